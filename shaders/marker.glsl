// Marks of a fixed size in pixels: 0 dot, 1 ring, 2 cross, 3 square.
uniform mat4 u_view_projection;
uniform vec3 u_offset;
uniform vec2 u_half_size;  // half of the viewport [px]
uniform float u_scale;     // layout pixel [px]

#ifdef VERTEX
layout(location = 0) in vec3 a_x;
layout(location = 1) in vec4 a_color;
layout(location = 2) in vec2 a_radius_style;  // radius in layout pixels; style
out vec2 v_p;                                 // [px] from the centre
flat out vec4 v_color;
flat out float v_radius;
flat out int v_style;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  v_radius = a_radius_style.x * u_scale;
  v_style = int(a_radius_style.y + 0.5);
  v_color = a_color;
  v_p = corner * (v_radius + 2.0 * u_scale);
  gl_Position = u_view_projection * vec4(a_x + u_offset, 1.0);
  gl_Position.xy += v_p / u_half_size * gl_Position.w;
}
#endif

#ifdef FRAGMENT
in vec2 v_p;
flat in vec4 v_color;
flat in float v_radius;
flat in int v_style;
out vec4 out_color;
void main() {
  float d;
  if (v_style == 1) {
    d = 0.9 * u_scale - abs(length(v_p) - v_radius);
  } else if (v_style == 2) {
    vec2 q = vec2(v_p.x + v_p.y, v_p.x - v_p.y) * 0.70710678;
    q = abs(q);
    float long_side = max(q.x, q.y), short_side = min(q.x, q.y);
    d = min(v_radius - long_side, 0.9 * u_scale - short_side);
  } else if (v_style == 3) {
    d = v_radius - max(abs(v_p.x), abs(v_p.y));
  } else {
    d = v_radius - length(v_p);
  }
  float alpha = clamp(d + 0.5, 0.0, 1.0);
  // Rings and crosses mean something on any colour: a rim of the opposite lightness.
  float rim = v_style == 1 || v_style == 2 ? 0.65 * clamp(d + u_scale + 0.5, 0.0, 1.0) : 0.0;
  float both = alpha + rim * (1.0 - alpha);
  if (both <= 0.0) discard;
  vec3 edge = vec3(dot(v_color.rgb, vec3(0.3, 0.59, 0.11)) > 0.5 ? 0.05 : 0.95);
  out_color = vec4(mix(edge, v_color.rgb, alpha / both), v_color.a * both);
}
#endif
