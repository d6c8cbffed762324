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

// In proportion to the inverse of the distance to the eye.
float nearness(float depth) { return u_near_far.y - depth * (u_near_far.y - u_near_far.x); }

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(u_depth, 0) - 1;
  float depth = texelFetch(u_depth, at, 0).r;
  if (depth >= 1.0) discard;
  gl_FragDepth = depth;
  vec3 color = texelFetch(u_color, at, 0).rgb;
  if (u_strength > 0.0) {
    float here = nearness(depth), product = 1.0;  // of how many times nearer to the eye the nearer ones are
    for (int k = 0; k < 8; ++k) {
      float a = 0.25 * PI * float(k);
      ivec2 q = clamp(at + ivec2(round(u_radius * vec2(cos(a), sin(a)))), ivec2(0), last);
      float other = texelFetch(u_depth, q, 0).r;
      if (other < 1.0) product *= max(1.0, nearness(other) / here);
    }
    color *= exp(-u_strength * log2(product));
  }
  out_color = vec4(color, 1.0);
}
#endif
