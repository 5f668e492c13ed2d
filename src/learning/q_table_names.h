#pragma once

#include <string>

namespace crowd {

/// @brief Resolves a Q-table file, or the name of a shipped Q-table, to a file.
///
/// An existing file takes precedence. Otherwise a bare name, with or without `.txt`, is looked up in config/q_tables of
/// this package, so that a name is valid on every host whatever its folders are. A path is returned as it is.
/// @param base folder of relative paths; empty: the working directory
/// @throws InputError for a bare name that is neither, with the available names
std::string findQTable(const std::string& name_or_file, const std::string& base = "");

}  // namespace crowd
