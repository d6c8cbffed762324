// Put before every shader.
const float PI = 3.14159265358979;

// The colour map: value -> colour through a 256-entry table. NaN is grey: it must not pass for a value.
vec3 mapped(sampler2D map, float value, vec2 range) {
  if (isnan(value)) return vec3(0.5);
  float t = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
  return textureLod(map, vec2((t * 255.0 + 0.5) / 256.0, 0.5), 0.0).rgb;
}

vec3 to_linear(vec3 c) { return pow(c, vec3(2.2)); }
vec3 to_srgb(vec3 c) { return pow(max(c, vec3(0.0)), vec3(1.0 / 2.2)); }

// Breaks up the bands of a slow gradient.
float dither(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5; }

// Towards the light, in world axes: from the upper left of the usual view.
const vec3 LIGHT = vec3(-0.362, 0.805, 0.470);

// Share of the light that reaches p: soft, from a disc of samples turned anew in every pixel.
#ifdef SHADOWS
uniform sampler2DShadow u_shadow_map;
uniform mat4 u_to_shadow;
uniform float u_softness;
float reached(vec3 p, vec2 pixel) {
  vec4 q = u_to_shadow * vec4(p, 1.0);
  if (any(lessThan(q.xyz, vec3(0.0))) || any(greaterThan(q.xyz, vec3(1.0)))) return 1.0;
  const int taps = 16;
  float turn = (dither(pixel) + 0.5) * 2.0 * PI, sum = 0.0;
  for (int k = 0; k < taps; ++k) {
    float r = u_softness * sqrt((float(k) + 0.5) / float(taps)), a = turn + 2.39996323 * float(k);
    sum += texture(u_shadow_map, vec3(q.xy + r * vec2(cos(a), sin(a)), q.z));
  }
  return sum / float(taps);
}
#else
float reached(vec3 p, vec2 pixel) { return 1.0; }
#endif

// sRGB colour of a matt surface: sky light from above, a key light, a faint gloss. `n` and `to_eye` in world axes.
vec3 shaded(vec3 base, vec3 n, vec3 to_eye, float key) {
  float sky = 0.5 + 0.5 * n.y;
  float diffuse = max(dot(n, LIGHT), 0.0) * key;
  float gloss = pow(max(dot(n, normalize(LIGHT + to_eye)), 0.0), 40.0) * key;
  vec3 light = mix(vec3(0.24, 0.23, 0.24), vec3(0.46, 0.48, 0.52), sky) + vec3(0.74, 0.72, 0.68) * diffuse;
  return to_srgb(to_linear(base) * light + vec3(0.045) * gloss);
}
