// Which program this is: written into every output, so that a number can be traced to the code that made it.
#pragma once

#include <string_view>

namespace pf {

struct BuildInfo {
  std::string_view version;   ///< of the project, "0.1.0"
  std::string_view commit;    ///< 12 hex digits, "unknown" outside of git
  std::string_view compiler;  ///< name and version
  std::string_view flags;     ///< that code generation depends on
};

BuildInfo build_info();

}  // namespace pf
