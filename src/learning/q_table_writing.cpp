#include <cmath>
#include <string>
#include <vector>

#include "common/files/checksum.h"
#include "common/files/files.h"
#include "common/text/numbers.h"
#include "learning/q_table_file.h"
#include "learning/q_table_format.h"
#include "learning/q_table_text.h"

namespace crowd {
namespace {

using namespace q_table_format;  // NOLINT(google-build-using-namespace): the words of this file

constexpr std::size_t MAX_ROW_SIZE = 11;             // characters of the row number and the line end
constexpr std::size_t MAX_ENTRY_SIZE = 10 + 24 + 2;  // characters of visits, a value and two spaces
constexpr std::size_t MAX_GROWTH = 500;              // characters by which the header can grow, and of the checksum

/// Whether the row differs from a new one.
bool isStored(const QTable& table, Row row) {
  for (Action action = 0; action < table.actions(); ++action) {
    const double value = table.value(row, action);
    if (table.visits(row, action) > 0 || value != 0.0 || std::signbit(value)) return true;
  }
  return false;
}

/// The sources that a file must list so that its reader can restore all of them. A single source that equals
/// QTable::source() of a table without a named own source is not listed.
struct Sources {
  SourceId rest = NO_SOURCE;  // of all visits that are not listed
  Contributions listed;

  explicit Sources(const QTable& table) : listed(table.foreign()) {
    if (table.isNamed()) rest = table.source();
    if (listed.size() == 1 && !table.hasOwnVisits()) {
      rest = listed.front().source;
      listed.clear();
    }
    if (rest != NO_SOURCE && rest == table.contentId()) rest = NO_SOURCE;
  }
};

std::string headerOf(const TrainedTable& trained, const Sources& sources, std::size_t lines) {
  std::string text = std::string(Q_TABLE_MAGIC) + "\n" + trained.model.spec();
  const auto add = [&](const char* key, const std::string& value) { text += std::string(key) + ": " + value + "\n"; };
  add("rows", std::to_string(trained.table.rows()));
  add("actions", std::to_string(trained.table.actions()));
  add("alpha", toText(trained.parameters.alpha));
  add("gamma", toText(trained.parameters.gamma));
  add("lambda", toText(trained.parameters.lambda));
  if (trained.parameters.alpha_decay > 0.0) add("alpha_decay", toText(trained.parameters.alpha_decay));
  if (trained.parameters.mirrored) add("mirrored", "true");
  if (trained.parameters.ties != Ties::FIRST) add("ties", TIES.nameOf(trained.parameters.ties));
  add("epsilon", toText(trained.parameters.epsilon));
  add("decisions", std::to_string(trained.decisions));
  add("seed", std::to_string(trained.seed));
  if (sources.rest != NO_SOURCE) add("source", "'" + toHexText(sources.rest) + "'");
  if (!sources.listed.empty()) add("other_sources", std::to_string(sources.listed.size()));
  add("visited_rows", std::to_string(lines));
  return text + std::string(HEADER_END) + "\n";
}

void appendRow(const QTable& table, Row row, std::string& text) {
  appendText(row, text);
  for (Action action = 0; action < table.actions(); ++action) {
    const double value = table.value(row, action);
    if (!std::isfinite(value)) {
      throw InputError("row " + std::to_string(row) + ", action " + std::to_string(action) + " of the Q-table is " +
                       toText(value) + ": such a table is not written");
    }
    text += ' ';
    appendText(table.visits(row, action), text);
    text += ' ';
    appendText(value, text);
  }
  text += "\n";
}

void appendSource(const Contribution& contribution, std::string& text) {
  const VisitCounts& visits = *contribution.visits;
  text += std::string(SOURCE_KEY) + " " + toHexText(contribution.source) + " " + std::to_string(visits.rows().size()) +
          "\n";
  for (std::size_t i = 0; i < visits.rows().size(); ++i) {
    appendText(visits.rows()[i], text);
    for (Action action = 0; action < visits.actions(); ++action) {
      text += ' ';
      appendText(visits.at(i)[action], text);
    }
    text += "\n";
  }
}

}  // namespace

std::vector<Row> storedRows(const QTable& table) {
  std::vector<Row> rows;
  for (Row row = 0; row < table.rows(); ++row) {
    if (isStored(table, row)) rows.push_back(row);
  }
  return rows;
}

void appendRows(const QTable& table, const std::vector<Row>& rows, std::string& text) {
  // Avoids reallocations; reserved pages that are not written to need no memory.
  text.reserve(text.size() + rows.size() * (MAX_ROW_SIZE + table.actions() * MAX_ENTRY_SIZE));
  for (const Row row : rows) appendRow(table, row, text);
}

void appendSources(const Contributions& sources, std::string& text) {
  for (const Contribution& contribution : sources) appendSource(contribution, text);
}

std::string toText(const TrainedTable& trained) {
  const std::vector<Row> rows = storedRows(trained.table);
  const Sources sources(trained.table);
  std::string text = headerOf(trained, sources, rows.size());
  appendRows(trained.table, rows, text);
  appendSources(sources.listed, text);
  Checksum checksum;
  checksum.add(text);
  return text.append(Q_TABLE_CHECKSUM_KEY).append(checksum.text()).append("\n");
}

std::uint64_t maxTextSize(const TrainedTable& trained) {
  std::string others;
  appendSources(trained.table.foreign(), others);
  const std::uint64_t row = MAX_ROW_SIZE + trained.table.actions() * MAX_ENTRY_SIZE;
  return headerOf(trained, Sources(trained.table), 0).size() + MAX_GROWTH + others.size() + trained.table.rows() * row;
}

void saveQTable(const std::string& file, const TrainedTable& trained) { replaceFile(file, toText(trained)); }

}  // namespace crowd
