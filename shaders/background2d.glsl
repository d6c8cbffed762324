// A quiet vertical gradient, and the lattice of the background grid fading out where cells get small.
uniform vec3 u_top, u_bottom;
uniform vec4 u_lattice;       // colour; alpha 0: none
uniform vec2 u_size;          // viewport [px]
uniform vec2 u_phase;         // centre of the view in units of ten cells, fractional part
uniform float u_cell;         // dx [px]
uniform float u_line;         // line width [px]

#ifdef VERTEX
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 1.0, 1.0); }
#endif

#ifdef FRAGMENT
uniform vec2 u_origin;        // lower left corner of the viewport [px]
out vec4 out_color;

// Coverage of the lines of a lattice with `pitch` pixels, `p` from one of its lines.
float lines(vec2 p, float pitch) {
  vec2 d = abs(p - pitch * round(p / pitch));
  vec2 c = clamp(0.5 * u_line + 0.5 - d, 0.0, 1.0);
  return max(c.x, c.y);
}

void main() {
  vec2 pixel = gl_FragCoord.xy - u_origin;
  vec3 color = mix(u_bottom, u_top, smoothstep(0.0, 1.0, pixel.y / u_size.y));
  if (u_lattice.a > 0.0) {
    vec2 p = pixel - 0.5 * u_size + u_phase * 10.0 * u_cell;
    float fine = lines(p, u_cell) * smoothstep(4.0, 14.0, u_cell);
    float coarse = lines(p, 10.0 * u_cell) * smoothstep(4.0, 14.0, 10.0 * u_cell);
    color = mix(color, u_lattice.rgb, u_lattice.a * max(0.55 * fine, coarse));
  }
  out_color = vec4(color + dither(gl_FragCoord.xy) / 255.0, 1.0);
}
#endif
