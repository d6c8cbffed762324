// An unbounded plane, cast ray by ray: fine lattice, soft shadow of the body, fading out with distance.
uniform mat4 u_inverse;      // clip -> world axes relative to the origin
uniform mat4 u_view_projection;
uniform vec3 u_eye;          // relative to the origin
uniform vec3 u_point, u_normal, u_tangent, u_bitangent;  // of the plane
uniform vec2 u_phase;        // of the lattice, in pitches
uniform float u_pitch;       // of the lattice [m]
uniform float u_reach;       // where it has faded out [m from u_point]
uniform vec3 u_fill, u_line;
uniform bool u_shadows;
uniform sampler2DShadow u_shadow_map;
uniform mat4 u_to_shadow;
uniform float u_softness;
uniform vec2 u_size;         // [px]

#ifdef VERTEX
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }
#endif

#ifdef FRAGMENT
out vec4 out_color;

float lines(vec2 q, vec2 width) {
  vec2 d = abs(q - round(q)) / width;
  vec2 c = clamp(1.0 - d, 0.0, 1.0) * clamp(0.35 / width, 0.0, 1.0);
  return max(c.x, c.y);
}

void main() {
  vec4 far = u_inverse * vec4(gl_FragCoord.xy / u_size * 2.0 - 1.0, 1.0, 1.0);
  vec3 ray = normalize(far.xyz / far.w - u_eye);
  float height = dot(u_eye - u_point, u_normal), fall = -dot(ray, u_normal);
  // Derivatives are taken before anything is discarded.
  float t = height / max(fall, 1e-4);
  vec3 p = u_eye + t * ray;
  vec2 q = vec2(dot(p - u_point, u_tangent), dot(p - u_point, u_bitangent)) / u_pitch + u_phase;
  vec2 width = max(fwidth(q), vec2(1e-5)) * 1.1;
  if (height <= 0.0 || fall <= 1e-4) discard;
  float fade = 1.0 - smoothstep(0.25, 1.0, length(p - u_point) / u_reach);
  if (fade <= 0.0) discard;
  float key = u_shadows ? reached(u_shadow_map, u_to_shadow, p, u_softness, gl_FragCoord.xy) : 1.0;
  float line = max(0.5 * lines(q, width), lines(q / 5.0, width / 5.0));
  vec3 color = mix(u_fill, u_line, line) * mix(0.52, 1.0, key);
  vec4 clip = u_view_projection * vec4(p, 1.0);
  gl_FragDepth = clamp(0.5 + 0.5 * clip.z / clip.w, 0.0, 0.9999999);
  out_color = vec4(color, fade);
}
#endif
