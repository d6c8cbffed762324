// Straight lines of a fixed width in pixels, with an arrow head where u_head > 0. One quad each; the shape is cut
// out by its signed distance, so it is antialiased with or without multisampling.
uniform mat4 u_view_projection;
uniform vec3 u_offset;
uniform vec2 u_half_size;  // half of the viewport [px]
uniform float u_width;     // [px]
uniform float u_head;      // largest length of an arrow head [px]; 0: none
uniform vec4 u_rim;        // alpha > 0: a rim of this colour only, to be drawn below
uniform float u_grow;      // width of the rim [px]

#ifdef VERTEX
layout(location = 0) in vec3 a_from;
layout(location = 1) in vec3 a_to;
layout(location = 2) in vec4 a_color;
noperspective out vec2 v_p;   // [px] along and across
flat out float v_length;
flat out vec4 v_color;
void main() {
  vec4 a = u_view_projection * vec4(a_from + u_offset, 1.0);
  vec4 b = u_view_projection * vec4(a_to + u_offset, 1.0);
  // Cut at the near plane: w must stay positive.
  const float near = 1e-4;
  if (a.w < near && b.w < near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (a.w < near) a = mix(b, a, (b.w - near) / (b.w - a.w));
  if (b.w < near) b = mix(a, b, (a.w - near) / (a.w - b.w));
  vec2 pa = a.xy / a.w * u_half_size, pb = b.xy / b.w * u_half_size;
  v_length = length(pb - pa);
  vec2 along = v_length > 1e-6 ? (pb - pa) / v_length : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float reach = 0.5 * u_width + 0.5 * u_head + 1.5 + u_grow;
  bool end = (gl_VertexID & 1) == 1;
  float side = (gl_VertexID >> 1) == 1 ? reach : -reach;
  float beyond = 0.5 * u_width + 1.5 + 2.0 * u_grow;
  v_p = vec2(end ? v_length + beyond : -beyond, side);
  v_color = u_rim.a > 0.0 ? u_rim : a_color;
  vec4 at = end ? b : a;
  vec2 pixel = (end ? pb + along * beyond : pa - along * beyond) + across * side;
  gl_Position = vec4(pixel / u_half_size * at.w, at.z, at.w);
}
#endif

#ifdef FRAGMENT
noperspective in vec2 v_p;
flat in float v_length;
flat in vec4 v_color;
out vec4 out_color;
void main() {
  float head = min(u_head, 0.45 * v_length);
  // Shaft with round ends, up to the head.
  float shaft_end = max(v_length - 0.8 * head, 0.0);
  vec2 q = vec2(v_p.x - clamp(v_p.x, 0.0, shaft_end), v_p.y);
  float d = 0.5 * u_width - length(q);
  if (head > 0.0) {
    float from_tip = v_length + 0.5 * u_width - v_p.x;
    float half_width = 0.42 * from_tip;
    float triangle = min((half_width - abs(v_p.y)) * 0.92, head - from_tip);
    d = max(d, triangle);
  }
  float alpha = clamp(d + u_grow + 0.5, 0.0, 1.0);
  if (alpha <= 0.0) discard;
  out_color = vec4(v_color.rgb, v_color.a * alpha);
}
#endif
