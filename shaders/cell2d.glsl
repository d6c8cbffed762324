// Tint of the active cells.
uniform mat4 u_view_projection;
uniform vec3 u_offset;
uniform float u_dx;  // [m]
uniform vec4 u_color;

#ifdef VERTEX
layout(location = 0) in vec2 a_min;  // lower left corner [m]
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = u_view_projection * vec4(a_min + u_offset.xy + corner * u_dx, 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
out vec4 out_color;
void main() { out_color = u_color; }
#endif
