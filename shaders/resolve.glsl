// The finished picture into the window's framebuffer, averaged where it was drawn larger.
uniform sampler2D u_color;
uniform vec2 u_origin, u_size;  // viewport [px]
uniform float u_opaque;         // 1: whatever is blended, the picture covers

#ifdef VERTEX
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }
#endif

#ifdef FRAGMENT
out vec4 out_color;
void main() {
  vec4 c = textureLod(u_color, (gl_FragCoord.xy - u_origin) / u_size, 0.0);
  out_color = vec4(c.rgb, max(c.a, u_opaque));
}
#endif
