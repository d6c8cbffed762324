// The finished picture into the window's framebuffer, averaged where it was drawn larger.
uniform sampler2D u_color;
uniform vec2 u_origin, u_size;  // viewport [px]

#ifdef VERTEX
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }
#endif

#ifdef FRAGMENT
out vec4 out_color;
void main() { out_color = vec4(textureLod(u_color, (gl_FragCoord.xy - u_origin) / u_size, 0.0).rgb, 1.0); }
#endif
