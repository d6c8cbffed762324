// An unbounded plane as a large square around the body: fine lattice, soft shadow, fading out with distance.
uniform mat4 u_view_projection;
uniform vec3 u_point, u_tangent, u_bitangent;  // of the plane, relative to the origin
uniform vec2 u_phase;        // of the lattice, in pitches
uniform float u_pitch;       // of the lattice [m]
uniform float u_reach;       // where it has faded out [m from u_point]

#ifdef VERTEX
out vec2 v_q;  // from u_point, in units of u_reach
void main() {
  v_q = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec3 p = u_point + u_reach * (v_q.x * u_tangent + v_q.y * u_bitangent);
  gl_Position = u_view_projection * vec4(p, 1.0);
}
#endif

#ifdef FRAGMENT
uniform vec3 u_fill, u_line;
in vec2 v_q;
out vec4 out_color;

float lines(vec2 q, vec2 width) {
  vec2 d = abs(q - round(q)) / width;
  vec2 c = clamp(1.0 - d, 0.0, 1.0) * clamp(0.35 / width, 0.0, 1.0);
  return max(c.x, c.y);
}

void main() {
  vec2 q = v_q * (u_reach / u_pitch) + u_phase;
  vec2 width = max(fwidth(q), vec2(1e-5)) * 1.1;
  float fade = 1.0 - smoothstep(0.25, 1.0, length(v_q));
  float line = max(0.5 * lines(q, width), lines(q / 5.0, width / 5.0));
  vec3 color = mix(u_fill, u_line, line);
  vec3 p = u_point + u_reach * (v_q.x * u_tangent + v_q.y * u_bitangent);
  color *= mix(0.52, 1.0, reached(p, gl_FragCoord.xy));
  out_color = vec4(color, fade);
}
#endif
