// Puts the body over the background and darkens pixels that lie behind their neighbours (eye-dome shading,
// Boucheny 2009): depth shows without any normal.
uniform sampler2D u_color, u_depth;
uniform vec2 u_near_far;
uniform float u_radius;    // [px]
uniform float u_strength;  // 0: off

#ifdef VERTEX
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }
#endif

#ifdef FRAGMENT
out vec4 out_color;

float log_depth(float depth) {
  float n = u_near_far.x, f = u_near_far.y;
  return log2(n * f / (f - depth * (f - n)));
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(u_depth, 0) - 1;
  float depth = texelFetch(u_depth, at, 0).r;
  if (depth >= 1.0) discard;
  gl_FragDepth = depth;
  vec3 color = texelFetch(u_color, at, 0).rgb;
  if (u_strength > 0.0) {
    float here = log_depth(depth), sum = 0.0;
    for (int k = 0; k < 8; ++k) {
      float a = 0.25 * PI * float(k);
      ivec2 q = clamp(at + ivec2(round(u_radius * vec2(cos(a), sin(a)))), ivec2(0), last);
      float other = texelFetch(u_depth, q, 0).r;
      if (other < 1.0) sum += max(0.0, here - log_depth(other));
    }
    color *= exp(-u_strength * sum);
  }
  out_color = vec4(color, 1.0);
}
#endif
