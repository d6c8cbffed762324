// A formula as an item of a panel.
#pragma once

#include <string_view>

namespace pf::app {

/// On a line of its own, as large as fits: at most `scale` em. A formula that cannot be read is shown as it was typed.
void formula_text(std::string_view tex, float scale = 1.25F);

}  // namespace pf::app
