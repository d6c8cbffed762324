// A particle as the ball of its volume mapped by F: a quad that covers its outline, and a ray cast in the fragment
// shader, so that shape, depth and normals are exact. Also draws the shadow map.
uniform mat4 u_view;         // world axes relative to the origin -> eye
uniform mat4 u_projection;
uniform vec3 u_offset;
uniform bool u_round;        // F = 1
uniform bool u_orthographic; // the shadow map's view

#ifdef VERTEX
layout(location = 0) in vec3 a_x;
layout(location = 1) in vec3 a_F0;  // columns
layout(location = 2) in vec3 a_F1;
layout(location = 3) in vec3 a_F2;
layout(location = 4) in vec2 a_radius_value;
out vec3 v_eye;                 // on the ray through the pixel, eye coordinates
flat out mat3 v_inverse;        // eye -> unit ball
flat out vec3 v_centre;         // eye coordinates
flat out float v_value;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  float r = a_radius_value.x;
  mat3 F = u_round ? mat3(1.0) : mat3(a_F0, a_F1, a_F2);
  // A collapsed particle stays visible as a small ball; the layer marks it.
  if (!(abs(determinant(F)) > 1e-6)) F = mat3(0.4);
  mat3 A = mat3(u_view) * F * r;
  vec3 c = (u_view * vec4(a_x + u_offset, 1.0)).xyz;
  vec3 e = sqrt(A[0] * A[0] + A[1] * A[1] + A[2] * A[2]);  // half sizes of its box in eye axes
  // The box's outline on the plane of its face nearest to the eye; the far face shrinks towards the axis.
  float near = c.z + e.z;
  vec2 low = c.xy - e.xy, high = c.xy + e.xy;
  if (!u_orthographic) {
    near = min(near, -1e-4 * abs(c.z));
    float shrink = clamp(near / (c.z - e.z), 0.0, 1.0);
    low = min(low, low * shrink);
    high = max(high, high * shrink);
  }
  v_eye = vec3(mix(low, high, 0.5 + 0.5 * corner), near);
  v_inverse = inverse(A);
  v_centre = c;
  v_value = a_radius_value.y;
  gl_Position = u_projection * vec4(v_eye, 1.0);
}
#endif

#ifdef FRAGMENT
uniform sampler2D u_map;
uniform vec2 u_range;
in vec3 v_eye;
flat in mat3 v_inverse;
flat in vec3 v_centre;
flat in float v_value;
out vec4 out_color;
void main() {
  vec3 start = u_orthographic ? v_eye : vec3(0.0);
  vec3 ray = u_orthographic ? vec3(0.0, 0.0, -1.0) : v_eye;
  vec3 o = v_inverse * (start - v_centre), d = v_inverse * ray;
  float a = dot(d, d), b = dot(o, d), c = dot(o, o) - 1.0;
  float discriminant = b * b - a * c;
  if (discriminant < 0.0) discard;
  float t = (-b - sqrt(discriminant)) / a;
  vec3 hit = start + t * ray;
  vec4 clip = u_projection * vec4(hit, 1.0);
  gl_FragDepth = clamp(0.5 + 0.5 * clip.z / clip.w, 0.0, 1.0);
  if (u_orthographic) { out_color = vec4(1.0); return; }
  mat3 to_world = transpose(mat3(u_view));
  vec3 n = to_world * normalize(transpose(v_inverse) * (o + t * d));
  vec3 to_eye = to_world * normalize(-hit);
  vec3 p = to_world * (hit - vec3(u_view[3]));
  float key = reached(p, gl_FragCoord.xy);
  out_color = vec4(shaded(mapped(u_map, v_value, u_range), n, to_eye, key), 1.0);
}
#endif
