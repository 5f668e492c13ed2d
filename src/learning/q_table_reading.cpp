#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/files/files.h"
#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "learning/line_reader.h"
#include "learning/q_table_file.h"
#include "learning/q_table_format.h"
#include "learning/q_table_text.h"

namespace crowd {
namespace {

using namespace q_table_format;  // NOLINT(google-build-using-namespace): the words of this file

constexpr std::int64_t MAX_SOURCES = 1'000'000;
constexpr const char* A_SOURCE = "16 hexadecimal digits, not all 0";

/// The message does not quote a file that is not a Q-table: the caller may not be allowed to read it.
void readMagic(LineReader& lines) {
  if (lines.nextIs(Q_TABLE_MAGIC)) return;
  throw InputError(lines.name() + ": line 1: expected '" + std::string(Q_TABLE_MAGIC) +
                   "': this is no Q-table of this package, or one of another version");
}

/// Contents of the header.
struct Header {
  Model model;
  LearningParameters parameters;
  Row rows = 0;
  Action actions = 0;
  std::uint64_t decisions = 0;
  std::uint64_t seed = 0;
  SourceId source = NO_SOURCE;
  std::size_t other_sources = 0;
  Row visited_rows = 0;
};

/// Inverse of toHexText(); a source is not 0.
std::optional<SourceId> toSource(std::string_view text) {
  if (text.size() != 16) return std::nullopt;
  constexpr std::string_view DIGITS = "0123456789abcdef";
  SourceId source = 0;
  for (const char digit : text) {
    const std::size_t value = DIGITS.find(digit);
    if (value == std::string_view::npos) return std::nullopt;
    source = source << 4U | value;
  }
  if (source == NO_SOURCE) return std::nullopt;
  return source;
}

SourceId readSource(const YamlMap& map) {
  const YAML::Node node = map.find("source");
  if (!node) return NO_SOURCE;
  const std::optional<SourceId> source = toSource(readText(node, map.placeOf("source")));
  if (!source) throwExpected(map.placeOf("source"), node, A_SOURCE);
  return *source;
}

std::string readHeaderText(LineReader& lines) {
  std::string text = "\n";  // in place of the magic line, so that YAML's line numbers are those of the file
  for (;;) {
    const std::string_view line = lines.next("the end of the header, '---'");
    if (line == HEADER_END) return text;
    text += std::string(line) + "\n";
  }
}

Header readHeader(LineReader& lines) {
  const std::vector<YAML::Node> documents = parseYamlStream(readHeaderText(lines), lines.name());
  if (documents.size() != 1) lines.fail("a header of YAML before '---'", "nothing");
  const YamlMap map(
      documents.front(), {lines.name(), 0, ""},
      {"state_set", "action_set", "reward", "vision", "rows", "actions", "alpha", "alpha_decay", "gamma", "lambda",
       "mirrored", "ties", "epsilon", "decisions", "seed", "source", "other_sources", "visited_rows"});
  Header header;
  header.model = readModel(map);
  const auto rows = static_cast<std::int64_t>(header.model.state_set->rowCount());
  const auto actions = static_cast<std::int64_t>(header.model.action_set->size());
  header.rows = static_cast<Row>(map.whole("rows", rows, rows));
  header.actions = static_cast<Action>(map.whole("actions", actions, actions));
  for (const char* key : {"alpha", "gamma", "lambda", "epsilon"}) map.need(key);
  readParameter(map, "alpha", &LearningParameters::alpha, header.parameters);
  readParameter(map, "gamma", &LearningParameters::gamma, header.parameters);
  readParameter(map, "lambda", &LearningParameters::lambda, header.parameters);
  readParameter(map, "alpha_decay", &LearningParameters::alpha_decay, header.parameters);
  header.parameters.mirrored = map.flag("mirrored", header.parameters.mirrored);
  header.parameters.ties = TIES.read(map, Ties::FIRST);
  readParameter(map, "epsilon", &LearningParameters::epsilon, header.parameters);
  header.decisions = map.count("decisions");
  header.seed = map.count("seed");
  header.source = readSource(map);
  header.other_sources = static_cast<std::size_t>(map.whole("other_sources", 1, MAX_SOURCES, 0));
  header.visited_rows = static_cast<Row>(map.whole("visited_rows", 0, rows));
  return header;
}

std::string_view nextWord(std::string_view& rest) {
  const std::size_t end = std::min(rest.find(' '), rest.size());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return word;
}

std::optional<std::uint32_t> toCount(std::string_view word) {
  if (word.empty() || word.size() > 10) return std::nullopt;
  std::uint64_t count = 0;
  for (const char digit : word) {
    if (digit < '0' || digit > '9') return std::nullopt;
    count = count * 10 + static_cast<std::uint64_t>(digit - '0');
  }
  if (count > UINT32_MAX) return std::nullopt;
  return static_cast<std::uint32_t>(count);
}

/// Reads the row number at the start of a line; it must be above that of the previous row.
Row readRowNumber(const LineReader& lines, std::string_view line, std::int64_t before, Row end,
                  std::string_view& rest) {
  rest = line;
  const std::optional<std::uint32_t> row = toCount(nextWord(rest));
  if (row && *row<end&& static_cast<std::int64_t>(*row)> before) return *row;
  lines.fail("a row number above " + std::to_string(before) + " and below " + std::to_string(end), inQuotes(line));
}

void requireEndOfRow(const LineReader& lines, std::string_view line, std::string_view rest, Action actions) {
  if (rest.empty() && line.back() != ' ') return;
  lines.fail("nothing after the last of " + std::to_string(actions) + " actions", inQuotes(rest));
}

/// Reads one row, whose number must be above that of the previous row. Returns its number.
Row readRow(LineReader& lines, std::int64_t before, QTable& table) {
  const std::string_view line = lines.next("a row of the Q-table");
  std::string_view rest;
  const Row row = readRowNumber(lines, line, before, table.rows(), rest);
  for (Action action = 0; action < table.actions(); ++action) {
    const std::optional<std::uint32_t> visits = toCount(nextWord(rest));
    const std::optional<double> value = toNumber(nextWord(rest));
    if (!visits || !value || !std::isfinite(*value)) {
      lines.fail("visits and a finite value for each of " + std::to_string(table.actions()) + " actions",
                 inQuotes(line));
    }
    table.set(row, action, *value, *visits);
    lines.sumUpTo(rest.data());
  }
  requireEndOfRow(lines, line, rest, table.actions());
  return row;
}

/// Reads the visits of foreign sources.
class SourcesReader {
 public:
  SourcesReader(LineReader& lines, const QTable& table)
      : lines_(lines), table_(table), visits_(table.actions()), sums_(table.rows() * std::size_t{table.actions()}) {}

  /// Reads one source, whose id must be above that of the previous one.
  Contribution read(SourceId before, SourceId own) {
    const std::string expected = "'" + std::string(SOURCE_KEY) + " ' and a source of its own above " +
                                 toHexText(before) + ", then its number of rows";
    const std::string_view line = lines_.next(expected);
    std::string_view rest = line;
    const bool is_source = nextWord(rest) == SOURCE_KEY;
    const std::optional<SourceId> source = toSource(nextWord(rest));
    const std::optional<std::uint32_t> rows = toCount(rest);
    if (!is_source || !source || *source <= before || *source == own || !rows || *rows == 0) {
      lines_.fail(expected, inQuotes(line));
    }
    auto visits = std::make_shared<VisitCounts>(table_.actions());
    std::int64_t row = -1;
    for (std::uint32_t i = 0; i < *rows; ++i) row = readVisits(row, *visits);
    visits->finish();
    return {*source, std::move(visits)};
  }

 private:
  Row readVisits(std::int64_t before, VisitCounts& visits) {
    const std::string_view line = lines_.next("a row of visits");
    std::string_view rest;
    const Row row = readRowNumber(lines_, line, before, table_.rows(), rest);
    bool any = false;
    for (Action action = 0; action < table_.actions(); ++action) {
      const std::optional<std::uint32_t> count = toCount(nextWord(rest));
      if (!count || !isAvailable(row, action, *count)) {
        lines_.fail("visits of each of " + std::to_string(table_.actions()) +
                        " actions, of all sources together no more than the table has",
                    inQuotes(line));
      }
      visits_[action] = *count;
      any = any || *count > 0;
    }
    requireEndOfRow(lines_, line, rest, table_.actions());
    if (!any) lines_.fail("at least one visit", inQuotes(line));
    lines_.sumUpTo(line.data() + line.size());
    visits.add(row, visits_.data());
    return row;
  }

  /// Whether the table has this many visits beyond those of the sources read so far. Saturated visits allow any number.
  bool isAvailable(Row row, Action action, std::uint32_t count) {
    const std::uint32_t all = table_.visits(row, action);
    std::uint64_t& sum = sums_[static_cast<std::size_t>(row) * table_.actions() + action];
    sum += count;
    return sum <= all || all == UINT32_MAX;
  }

  LineReader& lines_;
  const QTable& table_;
  std::vector<std::uint32_t> visits_;  // of one row
  std::vector<std::uint64_t> sums_;    // of all sources so far
};

}  // namespace

void readRows(LineReader& lines, std::size_t count, QTable& table) {
  std::int64_t before = -1;
  for (std::size_t i = 0; i < count; ++i) before = readRow(lines, before, table);
}

Contributions readSources(LineReader& lines, std::size_t count, SourceId own, const QTable& table) {
  Contributions sources;
  if (count == 0) return sources;
  SourcesReader reader(lines, table);
  for (std::size_t i = 0; i < count; ++i) {
    sources.push_back(reader.read(sources.empty() ? NO_SOURCE : sources.back().source, own));
  }
  return sources;
}

TrainedTable parseQTable(const std::string& text, const std::string& name, const Model* expected_model) {
  LineReader lines(text, name);
  readMagic(lines);
  const Header header = readHeader(lines);
  if (expected_model != nullptr) requireFit(*expected_model, header.model, name);
  QTable table(header.rows, header.actions);
  readRows(lines, header.visited_rows, table);
  table.setSources(header.source, readSources(lines, header.other_sources, header.source, table));
  const std::string_view last = lines.next("the checksum after " + std::to_string(header.visited_rows) + " rows and " +
                                           std::to_string(header.other_sources) + " other sources");
  const std::string expected = std::string(Q_TABLE_CHECKSUM_KEY) + lines.sumUpTo(last.data()).text();
  if (last != expected) lines.fail("'" + expected + "': the file was changed or damaged", inQuotes(last));
  if (!lines.atEnd()) lines.fail("nothing after the checksum", "more text");
  return {header.model, header.parameters, header.decisions, header.seed, std::move(table)};
}

TrainedTable loadQTable(const std::string& file, FileKinds kinds, const Model* expected) {
  return parseQTable(readFile(file, FileLimits::Q_TABLE, kinds), file, expected);
}

}  // namespace crowd
