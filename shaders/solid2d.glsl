// Rigid solids and regions from a map of signed distances [px]: a fill with engineering hatching, deepest near
// the surface, and a crisp line at distance 0.
uniform vec2 u_size;     // viewport [px]
uniform vec2 u_origin;   // lower left corner of the viewport [px]
uniform vec2 u_phase;    // of the hatching [px]: it stays with the world, not with the screen
uniform float u_scale;   // layout pixel [px]
uniform sampler2D u_distance;  // r: solids; g: constraints; b: loads
uniform vec2 u_uv_scale, u_uv_shift;
uniform vec3 u_fill, u_hatch, u_edge, u_constraint, u_load;
uniform bool u_solids, u_regions;

#ifdef VERTEX
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }
#endif

#ifdef FRAGMENT
out vec4 out_color;

// `over` on top of `under`, both premultiplied.
vec4 over(vec4 under, vec4 top) { return top + under * (1.0 - top.a); }
vec4 ink(vec3 color, float alpha) { return vec4(color, 1.0) * alpha; }
float stripes(float across, float pitch, float width) {
  float d = abs(across - pitch * round(across / pitch));
  return clamp(0.5 * width + 0.5 - d, 0.0, 1.0);
}

void main() {
  vec2 pixel = gl_FragCoord.xy - u_origin;
  vec3 d = texture(u_distance, pixel / u_size * u_uv_scale + u_uv_shift).rgb;
  vec2 p = pixel + u_phase;
  float rising = (p.x + p.y) * 0.70710678, falling = (p.x - p.y) * 0.70710678;
  float s = u_scale;
  vec4 color = vec4(0.0);
  if (u_regions) {
    // A region may have zero thickness: its outline runs two pixels outside of it.
    float c = d.g - 2.0 * s;
    // Fading inwards: a region may be larger than the view.
    float inside = clamp(0.5 - c, 0.0, 1.0) * (0.1 + 0.9 * exp(min(c, 0.0) / (40.0 * s)));
    color = over(color, ink(u_constraint, inside * (0.10 + 0.22 * stripes(falling, 9.0 * s, s))));
    color = over(color, ink(u_constraint, 0.75 * clamp(0.5 * s + 0.5 - abs(c), 0.0, 1.0)));
    float l = d.b - 2.0 * s;
    inside = clamp(0.5 - l, 0.0, 1.0) * (0.1 + 0.9 * exp(min(l, 0.0) / (40.0 * s)));
    color = over(color, ink(u_load, inside * (0.12 + 0.25 * stripes(rising, 6.0 * s, s))));
    color = over(color, ink(u_load, 0.85 * clamp(0.5 * s + 0.5 - abs(l), 0.0, 1.0)));
  }
  if (u_solids) {
    float inside = clamp(0.5 - d.r, 0.0, 1.0);
    float depth = exp(-max(-d.r, 0.0) / (26.0 * s));
    color = over(color, ink(u_fill, inside));
    color = over(color, ink(u_hatch, inside * stripes(rising, 10.0 * s, 1.1 * s) * (0.18 + 0.82 * depth)));
    color = over(color, ink(u_edge, clamp(0.8 * s + 0.5 - abs(d.r + 0.5 * s), 0.0, 1.0)));
  }
  if (color.a <= 0.0) discard;
  out_color = vec4(color.rgb / color.a, color.a);
}
#endif
