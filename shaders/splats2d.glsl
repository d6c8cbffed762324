// A picture of the particles made by the processor, pixel for pixel over the view.
uniform sampler2D u_color;
uniform vec2 u_origin;  // lower left corner of the viewport [px]

#ifdef VERTEX
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }
#endif

#ifdef FRAGMENT
out vec4 out_color;
void main() {
  vec4 color = texelFetch(u_color, ivec2(gl_FragCoord.xy - u_origin), 0);
  if (color.a <= 0.0) discard;
  out_color = color;
}
#endif
