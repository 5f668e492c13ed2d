#include "training/checkpoint.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "common/files/files.h"
#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "learning/line_reader.h"
#include "learning/q_table_text.h"

namespace crowd {
namespace {

constexpr std::string_view MAGIC = "social_crowd checkpoint 1";  // with the version
constexpr std::string_view IDENTITY_END = "---";
constexpr std::string_view CHECKSUM_KEY = "checksum: ";

void addLine(std::string& text, const std::string& words) { text += words + "\n"; }

void addLine(std::string& text, const char* key, std::uint64_t value) {
  addLine(text, key + (" " + std::to_string(value)));
}

/// The words of a line, separated by blanks.
class Words {
 public:
  /// @param expected what the line holds, for messages
  Words(LineReader& lines, const std::string& expected)
      : lines_(lines), expected_(expected), rest_(lines.next(expected)) {}

  bool atEnd() const { return rest_.empty(); }

  std::string_view next() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }

  std::uint64_t nextWhole() {
    const std::string_view word = next();
    std::uint64_t value = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size()) lines_.fail(expected_, inQuotes(word));
    return value;
  }

  double nextNumber() {
    const std::string_view word = next();
    const std::optional<double> value = toNumber(word);
    if (!value) lines_.fail(expected_, inQuotes(word));
    return *value;
  }

 private:
  LineReader& lines_;
  std::string expected_;
  std::string_view rest_;
};

/// Reads a line "KEY NUMBER".
std::uint64_t readWhole(LineReader& lines, const std::string& key) {
  const std::string expected = "'" + key + "' and a whole number";
  Words words(lines, expected);
  const std::string_view word = words.next();
  if (word != key) lines.fail(expected, inQuotes(word));
  return words.nextWhole();
}

/// Checks magic and checksum. Returns the text between them.
std::string_view undamaged(std::string_view text, const std::string& name) {
  if (text.substr(0, MAGIC.size() + 1) != std::string(MAGIC) + "\n") {
    throw InputError(name + ": line 1: expected '" + std::string(MAGIC) +
                     "': this is no checkpoint of this package, or one of another version");
  }
  const std::size_t end = text.size() - std::min(text.size(), CHECKSUM_KEY.size() + 16 + 1);
  Checksum checksum;
  checksum.add(text.substr(0, end));
  if (text.substr(end) != std::string(CHECKSUM_KEY) + checksum.text() + "\n") {
    throw InputError(name + ": the checkpoint was damaged or cut short, its checksum is wrong; nothing was changed. " +
                     "To begin the training again, remove it");
  }
  return text.substr(MAGIC.size() + 1, end - MAGIC.size() - 1);
}

std::string nextOf(std::string_view& lines) {
  const std::size_t end = std::min(lines.find('\n'), lines.size());
  std::string line(lines.substr(0, end));
  lines.remove_prefix(std::min(end + 1, lines.size()));
  return line;
}

/// Reads the lines of the identity and compares them.
void requireIdentity(LineReader& lines, const std::string& expected) {
  std::string_view rest = expected;
  for (;;) {
    const std::string got(lines.next("a line about the training"));
    const std::string line = nextOf(rest);
    if (got == IDENTITY_END && line.empty()) return;
    if (got == line) continue;
    throw InputError(lines.name() + ": is the checkpoint of another training: it has '" +
                     (got == IDENTITY_END ? "" : got) + "', the training has '" + line + "'");
  }
}

void appendTable(const QTable& table, const std::string& name, std::string& text) {
  const std::vector<Row> rows = storedRows(table);
  addLine(text, name + " " + std::to_string(rows.size()));
  appendRows(table, rows, text);
}

void appendLearners(const TrainingState& state, std::string& text) {
  addLine(text, "learners", state.decisions.size());
  for (std::size_t i = 0; i < state.decisions.size(); ++i) {
    std::string line = std::to_string(state.decisions[i]);
    for (const double heading : state.headings[i]) line += " " + toText(heading);
    addLine(text, line);
  }
}

void readLearners(LineReader& lines, TrainingState& state) {
  const std::uint64_t learners = readWhole(lines, "learners");
  for (std::uint64_t i = 0; i < learners; ++i) {
    Words words(lines, "decisions and headings of a learner");
    state.decisions.push_back(words.nextWhole());
    std::vector<double>& headings = state.headings.emplace_back();
    while (!words.atEnd()) headings.push_back(words.nextNumber());
  }
}

void readOwnTables(LineReader& lines, TrainingState& state) {
  const std::uint64_t tables = readWhole(lines, "own_tables");
  for (std::uint64_t i = 0; i < tables; ++i) {
    const std::string expected = "an agent above the one before and its number of rows";
    Words words(lines, expected);
    const auto agent = static_cast<AgentId>(words.nextWhole());
    if (!state.own.empty() && agent <= state.own.rbegin()->first) lines.fail(expected, std::to_string(agent));
    QTable table(state.table.rows(), state.table.actions());
    readRows(lines, words.nextWhole(), table);
    // Foreign sources do not change in a training.
    table.setSources(NO_SOURCE, state.table.foreign());
    state.own.emplace(agent, std::move(table));
  }
}

/// Adds what determines the map of a scenario to a checksum.
void addMap(const OccupancyMap& map, Checksum& checksum) {
  checksum.add(std::to_string(map.width) + " " + std::to_string(map.height));
  for (const double value : {map.resolution, map.origin.position.x(), map.origin.position.y(), map.origin.heading}) {
    checksum.add(" " + toText(value));
  }
  for (const CellState cell : map.cells) checksum.add(std::string(1, static_cast<char>(cell)));
}

}  // namespace

std::string identityOf(const Training& training) {
  const TrainingConfig& config = training.config();
  const TrainingPlan& plan = config.training;
  std::string text = config.model.spec();
  addLine(text, "learning: " + toText(config.learning));
  addLine(text, "seed: " + std::to_string(plan.seed));
  addLine(text, "tables: " + std::string(TABLE_USES.nameOf(plan.tables)));
  addLine(text, "side_by_side: " + std::to_string(plan.side_by_side));
  if (plan.side_by_side > 1) addLine(text, "turn: " + std::to_string(plan.turn));
  for (const std::string& file : plan.scenarios) {
    Checksum checksum;
    checksum.add(readFile(file));
    addLine(text, "scenario: " + stemOf(file) + ", checksum " + checksum.text());
  }
  for (std::size_t i = 0; i < training.scenarios().size(); ++i) {
    const Scenario& scenario = training.scenarios()[i];
    if (!scenario.map) continue;
    Checksum checksum;
    addMap(*scenario.map, checksum);
    addLine(text, "map: " + stemOf(scenario.map_file) + ", checksum " + checksum.text());
  }
  return text;
}

std::string toText(const Checkpoint& checkpoint) {
  const TrainingState& state = checkpoint.state;
  std::string text = std::string(MAGIC) + "\n" + checkpoint.identity + std::string(IDENTITY_END) + "\n";
  addLine(text, "episode", state.episode);
  addLine(text, "decisions_before", state.decisions_before);
  addLine(text, "files", checkpoint.sizes.size());
  for (const auto& [option, size] : checkpoint.sizes) addLine(text, option.c_str(), size);
  appendLearners(state, text);
  appendTable(state.table, "table", text);
  addLine(text, "sources", state.table.foreign().size());
  appendSources(state.table.foreign(), text);
  addLine(text, "own_tables", state.own.size());
  for (const auto& [agent, table] : state.own) appendTable(table, std::to_string(agent), text);
  Checksum checksum;
  checksum.add(text);
  return text.append(CHECKSUM_KEY).append(checksum.text()).append("\n");
}

Checkpoint parseCheckpoint(const std::string& text, const std::string& name, const std::string& identity,
                           const Model& model) {
  LineReader lines(undamaged(text, name), name, 1);
  requireIdentity(lines, identity);
  Checkpoint checkpoint{
      identity, {}, {0, 0, {}, {}, QTable(model.state_set->rowCount(), model.action_set->size()), {}}};
  TrainingState& state = checkpoint.state;
  state.episode = readWhole(lines, "episode");
  state.decisions_before = readWhole(lines, "decisions_before");
  const std::uint64_t files = readWhole(lines, "files");
  for (std::uint64_t i = 0; i < files; ++i) {
    Words words(lines, "an option and a size");
    const std::string option(words.next());
    checkpoint.sizes[option] = words.nextWhole();
  }
  readLearners(lines, state);
  readRows(lines, readWhole(lines, "table"), state.table);
  const std::uint64_t sources = readWhole(lines, "sources");
  state.table.setSources(NO_SOURCE, readSources(lines, sources, NO_SOURCE, state.table));
  readOwnTables(lines, state);
  if (!lines.atEnd()) lines.fail("nothing after the tables", "more text");
  return checkpoint;
}

}  // namespace crowd
