#pragma once

#include <string>

namespace crowd {

/// @brief Returns what `--version` of a tool prints: lines "WORD VALUE" of package, sources (digest) and compiler.
std::string versionText();

}  // namespace crowd
