#include "social_crowd/common/yaml_reader.h"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "social_crowd/common/files.h"
#include "social_crowd/common/numbers.h"
#include "social_crowd/common/suggestions.h"

namespace crowd {
namespace {

constexpr std::size_t MAX_QUOTE = 40;  // [characters]

std::string lineOf(const YAML::Mark& mark) {
  return mark.line < 0 ? std::string() : "line " + std::to_string(mark.line + 1);  // yaml-cpp counts from 0
}

/// "FILE: document D, line L: PATH: " without the parts that are unknown.
std::string prefixOf(const YamlPlace& place, const YAML::Mark& mark) {
  const std::string document = place.document > 0 ? "document " + std::to_string(place.document) : "";
  const std::string line = lineOf(mark);
  std::string prefix = place.file + ": " + document;
  if (!document.empty() && !line.empty()) {
    prefix += ", ";
  }
  prefix += line;
  if (!document.empty() || !line.empty()) {
    prefix += ": ";
  }
  return place.path.empty() ? prefix : prefix + place.path + ": ";
}

/// Whether the node is an unquoted scalar; a quoted one is always a text.
bool isPlain(const YAML::Node& node) { return node.IsDefined() && node.IsScalar() && node.Tag() != "!"; }

YAML::Mark markOf(const YAML::Node& node) { return node.IsDefined() ? node.Mark() : YAML::Mark::null_mark(); }

std::string describe(const YAML::Node& node) {
  if (!node.IsDefined() || node.IsNull()) {
    return "nothing";
  }
  if (node.IsMap()) {
    return "a map";
  }
  if (node.IsSequence()) {
    return "a list of " + std::to_string(node.size());
  }
  const std::string& text = node.Scalar();
  const std::string quote = text.size() > MAX_QUOTE ? text.substr(0, MAX_QUOTE) + "..." : text;
  return (isPlain(node) ? "'" : "the text '") + quote + "'";
}

const char* wordsFor(NumberRule rule) {
  switch (rule) {
    case NumberRule::NOT_NEGATIVE:
      return "a number of 0 or more";
    case NumberRule::POSITIVE:
      return "a number above 0";
    case NumberRule::FRACTION:
      return "a number from 0 to 1";
    case NumberRule::ANY:
      break;
  }
  return "a number";
}

bool satisfies(double value, NumberRule rule) {
  switch (rule) {
    case NumberRule::NOT_NEGATIVE:
      return value >= 0.0;
    case NumberRule::POSITIVE:
      return value > 0.0;
    case NumberRule::FRACTION:
      return value >= 0.0 && value <= 1.0;
    case NumberRule::ANY:
      break;
  }
  return true;
}

/// Detects a document that begins at the same position as the previous one.
class ProgressWatch : public YAML::EventHandler {
 public:
  bool isStuck() const { return is_stuck_; }
  const YAML::Mark& mark() const { return mark_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    is_stuck_ = mark.pos == mark_.pos;
    mark_ = mark;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnAlias(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnScalar(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                const std::string& /*value*/) override {}
  void OnSequenceStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                       YAML::EmitterStyle::value /*style*/) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {}
  void OnMapEnd() override {}

 private:
  bool is_stuck_ = false;
  YAML::Mark mark_ = YAML::Mark::null_mark();
};

/// Whether every line begins like a line of a block map or list: with a word, "- ", a comment or "---" alone.
bool beginsPlainly(const std::string& text) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::size_t first = std::min(text.find_first_not_of(" \r", begin), end);
    const char head = first < end ? text[first] : '#';
    const bool word = std::isalnum(static_cast<unsigned char>(head)) != 0 || head == '#';
    const bool entry = head == '-' && first + 1 < end && text[first + 1] == ' ';
    if (!word && !entry && text.compare(begin, end - begin, "---") != 0) {
      return false;
    }
    begin = end + 1;
  }
  return true;
}

/// Refuses documents that begin with a comma: yaml-cpp treats them as empty and never advances, so that LoadAll would
/// exhaust the memory. This check takes as long as reading, and is skipped if no document can begin with a comma.
void refuseEndlessText(const std::string& text, const std::string& name) {
  if (beginsPlainly(text)) {
    return;
  }
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  ProgressWatch watch;
  while (parser.HandleNextDocument(watch)) {
    if (watch.isStuck()) {
      throw InputError(prefixOf({name, 0, ""}, watch.mark()) + "this is not YAML: a comma out of place");
    }
  }
}

}  // namespace

YamlPlace YamlPlace::child(const std::string& key) const {
  return {file, document, path.empty() ? key : path + "." + key};
}

YamlPlace YamlPlace::element(std::size_t index) const {
  return {file, document, path + "[" + std::to_string(index) + "]"};
}

void throwProblem(const YamlPlace& place, const YAML::Node& node, const std::string& problem) {
  throw InputError(prefixOf(place, markOf(node)) + problem);
}

void throwExpected(const YamlPlace& place, const YAML::Node& node, const std::string& expected) {
  throwProblem(place, node, "expected " + expected + ", got " + describe(node));
}

double readNumber(const YAML::Node& node, const YamlPlace& place, NumberRule rule) {
  if (isPlain(node)) {
    const std::optional<double> value = toNumber(node.Scalar());
    if (value && std::isfinite(*value) && satisfies(*value, rule)) {
      return *value;
    }
  }
  throwExpected(place, node, wordsFor(rule));
}

std::int64_t readWhole(const YAML::Node& node, const YamlPlace& place, std::int64_t low, std::int64_t high) {
  if (isPlain(node)) {
    const std::string& text = node.Scalar();
    const char* const end = text.data() + text.size();
    std::int64_t value = 0;
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec == std::errc() && read.ptr == end && value >= low && value <= high) {
      return value;
    }
  }
  throwExpected(place, node, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
}

std::uint64_t readCount(const YAML::Node& node, const YamlPlace& place) {
  if (isPlain(node)) {
    const std::string& text = node.Scalar();
    const char* const end = text.data() + text.size();
    std::uint64_t value = 0;
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec == std::errc() && read.ptr == end) return value;
  }
  throwExpected(place, node, "a whole number of at least 0");
}

std::string readText(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsDefined() || !node.IsScalar()) {
    throwExpected(place, node, "a text");
  }
  return node.Scalar();
}

Eigen::Vector2d readVector(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsDefined() || !node.IsSequence() || node.size() != 2) {
    throwExpected(place, node, "[x, y]");
  }
  // Places of elements are built only for messages, because most of a scenario file consists of vectors.
  const auto read = [&](std::size_t index) {
    const YAML::Node element = node[index];
    const std::optional<double> value = isPlain(element) ? toNumber(element.Scalar()) : std::nullopt;
    return value && std::isfinite(*value) ? *value : readNumber(element, place.element(index));
  };
  const double x = read(0);
  return {x, read(1)};
}

bool readFlag(const YAML::Node& node, const YamlPlace& place) {
  const bool yes = isPlain(node) && node.Scalar() == "true";
  if (!yes && !(isPlain(node) && node.Scalar() == "false")) {
    throwExpected(place, node, "true or false");
  }
  return yes;
}

YamlMap::YamlMap(const YAML::Node& node, YamlPlace place) : node_(node), place_(std::move(place)) {
  if (!node.IsDefined() || !node.IsMap()) {
    throwExpected(place_, node, "a map");
  }
  entries_.reserve(node.size());
  for (auto entry = node.begin(); entry != node.end(); ++entry) {
    if (!entry->first.IsScalar()) {
      throwExpected(place_, entry->first, "a word as key");
    }
    if (has(entry->first.Scalar())) {
      throwProblem(place_, entry->first, "the key '" + entry->first.Scalar() + "' stands twice");
    }
    entries_.push_back({entry->first, entry->second});
  }
}

YamlMap::YamlMap(const YAML::Node& node, YamlPlace place, YamlKeys keys) : YamlMap(node, std::move(place)) {
  allow(keys);
}

void YamlMap::allow(YamlKeys keys) {
  known_ = keys;
  for (const Entry& entry : entries_) {
    const std::string& key = entry.key.Scalar();
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::vector<std::string> known(known_.begin(), known_.end());
    const std::string hint = didYouMean(key, known);
    throwProblem(
        place_, entry.key,
        "unknown key '" + key + "'" + (hint.empty() ? "; known are " : hint + " Known are ") + joinNames(known));
  }
}

bool YamlMap::has(const std::string& key) const { return look(key) != nullptr; }

const YamlMap::Entry* YamlMap::look(const std::string& key) const {
  if (!known_.empty() && std::find(known_.begin(), known_.end(), key) == known_.end()) {
    throw std::logic_error("the key '" + key + "' is read and not declared");
  }
  const auto entry =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& each) { return each.key.Scalar() == key; });
  return entry == entries_.end() ? nullptr : &*entry;
}

YAML::Node YamlMap::need(const std::string& key) const {
  const Entry* const entry = look(key);
  if (entry != nullptr) return entry->value;
  for (const Entry& other : entries_) {  // for declared keys, allow() has reported misspellings
    const std::string hint = didYouMean(other.key.Scalar(), {key});
    if (known_.empty() && !hint.empty())
      throwProblem(place_, other.key, "unknown key '" + other.key.Scalar() + "'" + hint);
  }
  throwProblem(place_, node_, "the key '" + key + "' is missing");
}

YAML::Node YamlMap::find(const std::string& key) const {
  const Entry* const entry = look(key);
  return entry != nullptr ? entry->value : YAML::Node(YAML::NodeType::Undefined);
}

double YamlMap::number(const std::string& key, NumberRule rule) const {
  return readNumber(need(key), placeOf(key), rule);
}

double YamlMap::number(const std::string& key, NumberRule rule, double otherwise) const {
  const Entry* const entry = look(key);
  return entry != nullptr ? readNumber(entry->value, placeOf(key), rule) : otherwise;
}

std::int64_t YamlMap::whole(const std::string& key, std::int64_t low, std::int64_t high) const {
  return readWhole(need(key), placeOf(key), low, high);
}

std::int64_t YamlMap::whole(const std::string& key, std::int64_t low, std::int64_t high, std::int64_t otherwise) const {
  const Entry* const entry = look(key);
  return entry != nullptr ? readWhole(entry->value, placeOf(key), low, high) : otherwise;
}

std::uint64_t YamlMap::count(const std::string& key) const { return readCount(need(key), placeOf(key)); }

std::uint64_t YamlMap::count(const std::string& key, std::uint64_t otherwise) const {
  const Entry* const entry = look(key);
  return entry != nullptr ? readCount(entry->value, placeOf(key)) : otherwise;
}

std::string YamlMap::text(const std::string& key) const { return readText(need(key), placeOf(key)); }

std::string YamlMap::text(const std::string& key, const std::string& otherwise) const {
  const Entry* const entry = look(key);
  return entry != nullptr ? readText(entry->value, placeOf(key)) : otherwise;
}

bool YamlMap::flag(const std::string& key, bool otherwise) const {
  const Entry* const entry = look(key);
  return entry != nullptr ? readFlag(entry->value, placeOf(key)) : otherwise;
}

std::vector<double> YamlMap::risingNumbers(const std::string& key, double low, double high,
                                           const std::vector<double>& otherwise) const {
  const YAML::Node node = find(key);
  if (!node) return otherwise;
  const std::string expected = "a list of rising numbers from " + toText(low) + " to " + toText(high);
  if (!node.IsSequence()) throwExpected(placeOf(key), node, expected);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < node.size(); ++i) {
    numbers.push_back(readNumber(node[i], placeOf(key).element(i)));
    const bool rises = i == 0 || numbers[i] > numbers[i - 1];
    if (!rises || numbers[i] < low || numbers[i] > high) throwExpected(placeOf(key).element(i), node[i], expected);
  }
  return numbers;
}

std::vector<YAML::Node> loadYamlStream(const std::string& file) { return parseYamlStream(readFile(file), file); }

std::vector<YAML::Node> parseYamlStream(const std::string& text, const std::string& name) {
  try {
    refuseEndlessText(text, name);
    return YAML::LoadAll(text);
  } catch (const YAML::Exception& error) {
    throw InputError(prefixOf({name, 0, ""}, error.mark) + "this is not YAML: " + error.msg);
  }
}

}  // namespace crowd
