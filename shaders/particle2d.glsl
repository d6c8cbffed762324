// A particle as what it is: its reference square of volume V_p^0 mapped by F_p; or a round point. Edges are
// antialiased half a pixel outside the true edge, so that neighbours overlap and a solid shows no hairline gaps.
uniform mat4 u_view_projection;
uniform vec3 u_offset;            // of the data's origin from the camera's [m]
uniform vec2 u_half_size;         // half of the viewport [px]
uniform float u_pixels_per_metre;
uniform bool u_round;
uniform float u_scale;            // layout pixel [px]
uniform vec4 u_silhouette;        // alpha > 0: only this colour, u_grow wider, to be drawn below
uniform float u_grow;             // [px]

#ifdef VERTEX
layout(location = 0) in vec2 a_x;
layout(location = 1) in vec4 a_F;      // columns
layout(location = 2) in float a_side;  // of the reference square [m]
layout(location = 3) in float a_value;
out vec2 v_s;                  // -1..1 over the square
flat out vec2 v_half;          // [px] from the centre to the edges s.x = 1, s.y = 1
flat out float v_value;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  float h = 0.5 * a_side;
  mat2 F = u_round ? mat2(1.0) : mat2(a_F.xy, a_F.zw);
  float px = u_pixels_per_metre;
  float area = abs(determinant(F)) * h * px;
  v_half = vec2(area / max(length(F[1]), 1e-20), area / max(length(F[0]), 1e-20));
  if (u_round) v_half = vec2(max(h * px, 1.3 * u_scale));
  v_half = max(v_half, vec2(0.02));
  vec2 reach = u_round ? vec2(max(h, 1.3 * u_scale / px)) : vec2(h);
  v_s = corner * (1.0 + (1.5 + u_grow) / v_half);
  gl_Position = u_view_projection * vec4(a_x + u_offset.xy + F * (v_s * reach), 0.0, 1.0);
  v_value = a_value;
}
#endif

#ifdef FRAGMENT
uniform sampler2D u_map;
uniform vec2 u_range;
uniform float u_rim;  // how much a rim is darkened
in vec2 v_s;
flat in vec2 v_half;
flat in float v_value;
out vec4 out_color;
void main() {
  vec2 inside = (1.0 - abs(v_s)) * v_half;
  float d = u_round ? v_half.x * (1.0 - length(v_s)) : min(inside.x, inside.y);
  float size = min(v_half.x, v_half.y) / u_scale;
  // The overlap is for solids seen from afar; from near, squares are shown exactly.
  float overlap = u_round ? 0.0 : mix(0.5, 0.1, smoothstep(16.0, 40.0, size));
  float alpha = clamp(d + 0.5 + overlap + u_grow, 0.0, 1.0);
  if (alpha <= 0.0) discard;
  if (u_silhouette.a > 0.0) {
    out_color = vec4(u_silhouette.rgb, alpha);
    return;
  }
  vec3 color = mapped(u_map, v_value, u_range);
  float rim = u_rim * smoothstep(4.0, 9.0, size) * (1.0 - smoothstep(0.2 * u_scale, 1.4 * u_scale, d));
  out_color = vec4(color * (1.0 - rim), alpha);
}
#endif
