// The colour maps of core/charts as a texture. Internal to render/.
#pragma once

#include <array>
#include <cstdint>

#include "core/diagnostics/fields.hpp"
#include "core/snapshot.hpp"
#include "render/gl_objects.hpp"

namespace pf {

struct Frame;

class ColorTexture {
 public:
  /// Binds the map of `scale` to texture unit 0.
  void bind(FieldScale scale);

 private:
  gl::Texture textures_[3];
  bool filled_[3] = {false, false, false};
};

/// The 256 RGBA8 texels of a map.
std::array<std::uint8_t, 1024> field_texels(FieldScale scale);
/// The value that particle p is coloured by; NaN when the snapshot does not hold the field.
float color_value(const Snapshot& snapshot, Field field, std::size_t p);
/// As the shaders map it: the value, or its logarithm. See Frame::shown_range().
float shown_value(const Frame& frame, std::size_t p);

}  // namespace pf
