// The cheap way to draw the balls of a 3D body: one GL point each, a lit disc at its centre's depth.
uniform mat4 u_view_projection;
uniform vec3 u_offset;
uniform float u_pixels;    // half the viewport's height times the projection's scale
uniform float u_smallest;  // [px]

#ifdef VERTEX
layout(location = 0) in vec3 a_x;
layout(location = 1) in float a_side;
layout(location = 2) in float a_value;
flat out float v_value;
void main() {
  gl_Position = u_view_projection * vec4(a_x + u_offset, 1.0);
  gl_PointSize = max(a_side * u_pixels / max(gl_Position.w, 1e-6), u_smallest);
  v_value = a_value;
}
#endif

#ifdef FRAGMENT
uniform sampler2D u_map;
uniform vec2 u_range;
uniform vec3 u_light, u_up;  // towards the light and upwards, in eye axes
flat in float v_value;
out vec4 out_color;
void main() {
  vec2 q = gl_PointCoord * 2.0 - 1.0;
  float r2 = dot(q, q);
  if (r2 > 1.0) discard;
  vec3 n = vec3(q.x, -q.y, sqrt(1.0 - r2));
  // About what shaded() gives, without its powers.
  float light = 0.60 + 0.10 * dot(n, u_up) + 0.36 * max(dot(n, u_light), 0.0);
  out_color = vec4(mapped(u_map, v_value, u_range) * light, 1.0);
}
#endif
