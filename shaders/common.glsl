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
