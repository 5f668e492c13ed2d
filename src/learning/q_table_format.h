#pragma once

#include <string_view>

/// Words of a Q-table file.
namespace crowd::q_table_format {

constexpr std::string_view Q_TABLE_MAGIC = "social_crowd Q-table 1";  // with the version
constexpr std::string_view HEADER_END = "---";
constexpr std::string_view SOURCE_KEY = "source";
constexpr std::string_view Q_TABLE_CHECKSUM_KEY = "checksum: ";

}  // namespace crowd::q_table_format
