#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "common/files/files.h"
#include "common/text/number_limit.h"
#include "social_crowd/errors.h"

namespace crowd {

/// @brief Location of a value, for error messages: file, number of the document in the stream, path of keys.
struct YamlPlace {
  std::string file;
  int document = 0;  ///< from 1; 0: the file is not a stream, and messages omit the document
  std::string path;  ///< for example agents[3].goal

  YamlPlace child(const std::string& key) const;
  YamlPlace element(std::size_t index) const;
};

/// @brief Throws the InputError "FILE: document D, line L: PATH: PROBLEM" with the line of the mark or node.
[[noreturn]] void throwProblem(const YamlPlace& place, const YAML::Mark& mark, const std::string& problem);
[[noreturn]] void throwProblem(const YamlPlace& place, const YAML::Node& node, const std::string& problem);
/// @brief Throws the InputError "FILE: document D, line L: PATH: expected ..., got ...".
[[noreturn]] void throwExpected(const YamlPlace& place, const YAML::Node& node, const std::string& expected);

/// @brief Reads a finite number that the limit permits, or throws InputError. A quoted scalar is not a number.
double readNumber(const YAML::Node& node, const YamlPlace& place, const NumberLimit& limit = NumberRule::ANY);
/// @brief Reads a whole number from `low` to `high`, or throws InputError.
std::int64_t readWhole(const YAML::Node& node, const YamlPlace& place, std::int64_t low, std::int64_t high);
/// @brief Reads a whole number from 0 to 2^64 - 1, or throws InputError.
std::uint64_t readCount(const YAML::Node& node, const YamlPlace& place);
/// @brief Reads a text (scalar), or throws InputError.
std::string readText(const YAML::Node& node, const YamlPlace& place);
/// @brief Reads [x, y], or throws InputError. @param limit of each of the two
Eigen::Vector2d readVector(const YAML::Node& node, const YamlPlace& place, const NumberLimit& limit = NumberRule::ANY);
/// @brief Reads true or false, or throws InputError.
bool readFlag(const YAML::Node& node, const YamlPlace& place);

/// @brief The keys that a map may have.
using YamlKeys = std::initializer_list<const char*>;

/// @brief Reader of a map of a YAML document.
///
/// The caller declares the permitted keys before it reads the first value, so that the message about an unknown key
/// lists them all, and a misspelt key is reported as misspelt and not as missing.
/// All readers throw InputError with file, document, line and the expected value. If the key is absent they return
/// `otherwise`; without it they require the key.
class YamlMap {
 public:
  /// @brief A map whose keys are declared later with allow(); until then any key may be read.
  /// @throws InputError unless `node` is a map without duplicate keys.
  YamlMap(const YAML::Node& node, YamlPlace place);
  /// @brief A map with these permitted keys. @throws InputError as above and as allow() does.
  YamlMap(const YAML::Node& node, YamlPlace place, YamlKeys keys);

  /// @brief Declares all permitted keys.
  /// @throws InputError if the map has another key; the message names it, the nearest permitted key and all of them.
  void allow(YamlKeys keys);

  bool has(const std::string& key) const;
  /// @brief The value of a required key.
  YAML::Node need(const std::string& key) const;
  /// @brief The value of a key, or an undefined node (false) if it is absent.
  YAML::Node find(const std::string& key) const;

  double number(const std::string& key, const NumberLimit& limit, std::optional<double> otherwise = std::nullopt) const;
  std::int64_t whole(const std::string& key, std::int64_t low, std::int64_t high,
                     std::optional<std::int64_t> otherwise = std::nullopt) const;
  std::uint64_t count(const std::string& key, std::optional<std::uint64_t> otherwise = std::nullopt) const;
  std::string text(const std::string& key, std::optional<std::string> otherwise = std::nullopt) const;
  bool flag(const std::string& key, bool otherwise) const;
  /// @brief A list, possibly empty, of strictly increasing numbers from `low` to `high`.
  std::vector<double> risingNumbers(const std::string& key, double low, double high,
                                    const std::vector<double>& otherwise) const;

  YamlPlace placeOf(const std::string& key) const { return place_.child(key); }
  const YamlPlace& place() const { return place_; }
  const YAML::Node& node() const { return node_; }

 private:
  struct Entry {
    YAML::Node key;
    YAML::Node value;
  };
  /// The entry of the key; nullptr if it is absent. @throws std::logic_error for a key that was not declared.
  const Entry* look(const std::string& key) const;

  YAML::Node node_;
  YamlPlace place_;
  std::vector<Entry> entries_;      // in the order of the file
  std::vector<const char*> known_;  // empty: not declared yet
};

/// @brief All documents of a YAML file.
/// @throws FileError as readFile(); InputError, with the line, if it is not valid YAML.
std::vector<YAML::Node> loadYamlStream(const std::string& file, FileKinds kinds = FileKinds::REGULAR);

/// @brief All documents of a text; `name` replaces the file name in messages.
/// @throws InputError, with the line, if it is not valid YAML.
std::vector<YAML::Node> parseYamlStream(const std::string& text, const std::string& name);

}  // namespace crowd
