#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "learning/line_reader.h"
#include "learning/rl/q_table.h"

/// Rows and sources of a Q-table as lines of text, for Q-table files and checkpoints.
namespace crowd {

/// @brief The rows that differ from new ones, ascending.
std::vector<Row> storedRows(const QTable& table);

/// @brief Appends a line for each of these rows. @throws InputError if a value is not finite
void appendRows(const QTable& table, const std::vector<Row>& rows, std::string& text);

/// @brief Reads `count` lines of appendRows() into the table.
/// @throws InputError with the line if a row is invalid, out of range or not above the one before
void readRows(LineReader& lines, std::size_t count, QTable& table);

/// @brief Appends the visits of these sources.
void appendSources(const Contributions& sources, std::string& text);

/// @brief Reads `count` sources that appendSources() wrote.
/// @param table has all its rows already
/// @param own name of its own source, which must not be among them; NO_SOURCE: none
/// @throws InputError with the line if anything is invalid, or if the sources have more visits than the table
Contributions readSources(LineReader& lines, std::size_t count, SourceId own, const QTable& table);

}  // namespace crowd
