#include "common/text/yaml_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "common/text/suggestions.h"

namespace crowd {
namespace {

std::string lineOfMark(const YAML::Mark& mark) {
  return mark.line < 0 ? std::string() : "line " + std::to_string(mark.line + 1);  // yaml-cpp counts from 0
}

/// "FILE: document D, line L: PATH: " without the parts that are unknown.
std::string prefixOf(const YamlPlace& place, const YAML::Mark& mark) {
  const std::string document = place.document > 0 ? "document " + std::to_string(place.document) : "";
  const std::string line = lineOfMark(mark);
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
  return (isPlain(node) ? "" : "the text ") + inQuotes(node.Scalar());
}

std::optional<double> finiteNumberOf(const YAML::Node& node) {
  const std::optional<double> value = isPlain(node) ? toNumber(node.Scalar()) : std::nullopt;
  return value && std::isfinite(*value) ? value : std::nullopt;
}

template <typename Whole>
std::optional<Whole> wholeNumberOf(const YAML::Node& node) {
  if (!isPlain(node)) return std::nullopt;
  const std::string& text = node.Scalar();
  const char* const end = text.data() + text.size();
  Whole value = 0;
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return value;
}

}  // namespace

YamlPlace YamlPlace::child(const std::string& key) const {
  return {file, document, path.empty() ? key : path + "." + key};
}

YamlPlace YamlPlace::element(std::size_t index) const {
  return {file, document, path + "[" + std::to_string(index) + "]"};
}

void throwProblem(const YamlPlace& place, const YAML::Mark& mark, const std::string& problem) {
  throw InputError(prefixOf(place, mark) + problem);
}

void throwProblem(const YamlPlace& place, const YAML::Node& node, const std::string& problem) {
  throwProblem(place, node.IsDefined() ? node.Mark() : YAML::Mark::null_mark(), problem);
}

void throwExpected(const YamlPlace& place, const YAML::Node& node, const std::string& expected) {
  throwProblem(place, node, "expected " + expected + ", got " + describe(node));
}

double readNumber(const YAML::Node& node, const YamlPlace& place, const NumberLimit& limit) {
  const double value = finiteNumberOf(node).value_or(std::nan(""));
  const std::string refusal = refusalOf(value, limit);
  if (!refusal.empty()) throwExpected(place, node, refusal);
  return value;
}

std::int64_t readWhole(const YAML::Node& node, const YamlPlace& place, std::int64_t low, std::int64_t high) {
  const auto value = wholeNumberOf<std::int64_t>(node);
  if (value && *value >= low && *value <= high) return *value;
  throwExpected(place, node, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
}

std::uint64_t readCount(const YAML::Node& node, const YamlPlace& place) {
  const auto value = wholeNumberOf<std::uint64_t>(node);
  if (value) return *value;
  throwExpected(place, node, "a whole number of at least 0");
}

std::string readText(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsDefined() || !node.IsScalar()) {
    throwExpected(place, node, "a text");
  }
  return node.Scalar();
}

Eigen::Vector2d readVector(const YAML::Node& node, const YamlPlace& place, const NumberLimit& limit) {
  if (!node.IsDefined() || !node.IsSequence() || node.size() != 2) {
    throwExpected(place, node, "[x, y]");
  }
  // Places of elements are built only for messages, because most of a scenario file consists of vectors.
  const auto read = [&](std::size_t index) {
    const std::optional<double> value = finiteNumberOf(node[index]);
    const bool is_fine = value && refusalOf(*value, limit).empty();
    return is_fine ? *value : readNumber(node[index], place.element(index), limit);
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
      throwProblem(place_, entry->first, "the key " + inQuotes(entry->first.Scalar()) + " stands twice");
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
        "unknown key " + inQuotes(key) + (hint.empty() ? "; known are " : hint + " Known are ") + joinNames(known));
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
      throwProblem(place_, other.key, "unknown key " + inQuotes(other.key.Scalar()) + hint);
  }
  throwProblem(place_, node_, "the key '" + key + "' is missing");
}

YAML::Node YamlMap::find(const std::string& key) const {
  const Entry* const entry = look(key);
  return entry != nullptr ? entry->value : YAML::Node(YAML::NodeType::Undefined);
}

double YamlMap::number(const std::string& key, const NumberLimit& limit, std::optional<double> otherwise) const {
  return otherwise && !has(key) ? *otherwise : readNumber(need(key), placeOf(key), limit);
}

std::int64_t YamlMap::whole(const std::string& key, std::int64_t low, std::int64_t high,
                            std::optional<std::int64_t> otherwise) const {
  return otherwise && !has(key) ? *otherwise : readWhole(need(key), placeOf(key), low, high);
}

std::uint64_t YamlMap::count(const std::string& key, std::optional<std::uint64_t> otherwise) const {
  return otherwise && !has(key) ? *otherwise : readCount(need(key), placeOf(key));
}

std::string YamlMap::text(const std::string& key, std::optional<std::string> otherwise) const {
  return otherwise && !has(key) ? *std::move(otherwise) : readText(need(key), placeOf(key));
}

bool YamlMap::flag(const std::string& key, bool otherwise) const {
  return has(key) ? readFlag(need(key), placeOf(key)) : otherwise;
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

}  // namespace crowd
