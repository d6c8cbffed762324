// Surface of a rigid solid. Faces that look away from the eye are left out (the near walls of a container);
// where it would hide the body it is a veil.
uniform mat4 u_view_projection;
uniform vec3 u_offset;
uniform vec3 u_eye;

#ifdef VERTEX
layout(location = 0) in vec3 a_x;
layout(location = 1) in vec3 a_normal;
out vec3 v_p;
out vec3 v_normal;
void main() {
  v_p = a_x + u_offset;
  v_normal = a_normal;
  gl_Position = u_view_projection * vec4(v_p, 1.0);
}
#endif

#ifdef FRAGMENT
uniform vec3 u_fill;
uniform sampler2D u_body_depth;
uniform float u_veil;  // opacity over the body
uniform bool u_casting;  // into the shadow map
in vec3 v_p;
in vec3 v_normal;
out vec4 out_color;
void main() {
  if (u_casting) { out_color = vec4(1.0); return; }
  vec3 n = normalize(v_normal), to_eye = normalize(u_eye - v_p);
  if (dot(n, to_eye) < 0.0) discard;
  float key = reached(v_p, gl_FragCoord.xy);
  bool over_body = texelFetch(u_body_depth, ivec2(gl_FragCoord.xy), 0).r < 1.0;
  vec3 color = shaded(u_fill, n, to_eye, key);
  float rim = pow(1.0 - dot(n, to_eye), 3.0);
  out_color = vec4(mix(color, vec3(1.0), 0.10 * rim), over_body ? u_veil : 1.0);
}
#endif
