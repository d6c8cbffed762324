// The cheap way to draw very many particles: one GL point each, no blending.
uniform mat4 u_view_projection;
uniform vec3 u_offset;
uniform float u_pixels;      // 2D: pixels a metre; 3D: half the viewport's height times the projection's scale
uniform bool u_perspective;
uniform float u_smallest;    // [px]

#ifdef VERTEX
layout(location = 0) in vec3 a_x;
layout(location = 1) in float a_side;
layout(location = 2) in float a_value;
flat out float v_value;
void main() {
  gl_Position = u_view_projection * vec4(a_x + u_offset, 1.0);
  gl_PointSize = max(a_side * u_pixels / (u_perspective ? max(gl_Position.w, 1e-6) : 1.0), u_smallest);
  v_value = a_value;
}
#endif

#ifdef FRAGMENT
uniform sampler2D u_map;
uniform vec2 u_range;
flat in float v_value;
out vec4 out_color;
void main() {
  vec3 color = mapped(u_map, v_value, u_range);
  if (u_perspective) {  // shaded as a disc that faces the light
    vec2 q = gl_PointCoord * 2.0 - 1.0;
    float r2 = dot(q, q);
    if (r2 > 1.0) discard;
    color *= 0.55 + 0.45 * clamp(dot(vec3(q.x, -q.y, sqrt(1.0 - r2)), normalize(vec3(0.35, 0.7, 0.6))), 0.0, 1.0);
  }
  out_color = vec4(color, 1.0);
}
#endif
