#include "app/tools/grab.hpp"
#include "app/tools/tool.hpp"

namespace pf::app {

const std::vector<ToolInfo>& tools() {
  static const std::vector<ToolInfo> table{
      {"grab", "Grab",
       "Drag pulls the material, the wheel sets how much of it; a click selects a particle, with Ctrl a node.",
       make_grab_tool},
  };
  return table;
}

}  // namespace pf::app
