#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace crowd {
class ScenarioList;
}

namespace crowd::library {

/// @brief The documents of a scenario file, one after the other: episode number k is drawn from document k modulo
/// size(). Immutable; copies share the documents, and any threads may use them at the same time.
class Scenario {
 public:
  /// @brief Reads a scenario file, or a scenario of the package by its name, such as "circle6".
  /// @throws FileError if it or its map cannot be read; InputError if there is no such name, or with file, line and
  /// what was expected
  static Scenario load(const std::string& name_or_file);
  /// @brief Reads the text of a scenario file. @param name in messages @throws InputError and FileError as load() does
  static Scenario parse(const std::string& text, const std::string& name);
  /// @brief Names of the scenarios of the package.
  static std::vector<std::string> names();

  /// @brief Number of documents, at least one.
  std::size_t size() const;

  /// @brief For this library only.
  explicit Scenario(std::shared_ptr<const ScenarioList> list) : list_(std::move(list)) {}
  const ScenarioList& list() const { return *list_; }

 private:
  std::shared_ptr<const ScenarioList> list_;
};

}  // namespace crowd::library
