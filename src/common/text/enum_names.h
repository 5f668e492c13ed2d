#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "common/text/quotes.h"
#include "common/text/suggestions.h"
#include "common/text/yaml_reader.h"

namespace crowd {

/// @brief Names of the values 0, 1, 2 ... of an enumeration, as used in files, parameters and messages.
template <typename Enum, std::size_t COUNT>
class EnumNames {
 public:
  /// @param key key of YAML maps that hold a value; also its name in error messages
  constexpr EnumNames(const char* key, const std::array<const char*, COUNT>& names) : key_(key), names_(names) {}

  std::string nameOf(Enum value) const { return names_[static_cast<std::size_t>(value)]; }
  /// @brief Returns the value of a name. @throws InputError that lists the valid names
  Enum parse(const std::string& name) const {
    const std::size_t index = find(name);
    if (index < COUNT) return static_cast<Enum>(index);
    throw InputError(std::string(key_) + ": expected " + listed() + ", got " + inQuotes(name));
  }
  /// @brief Reads the key of a map; returns `otherwise` if it is absent. @throws InputError
  Enum read(const YamlMap& map, Enum otherwise) const {
    const std::size_t index = find(map.text(key_, nameOf(otherwise)));
    if (index < COUNT) return static_cast<Enum>(index);
    throwExpected(map.placeOf(key_), map.need(key_), listed());
  }
  /// @brief Reads the required key of a map. @throws InputError
  Enum need(const YamlMap& map) const {
    map.need(key_);
    return read(map, static_cast<Enum>(0));
  }
  /// @brief Returns the names as "first, second or third".
  std::string listed() const { return joinAlternatives({names_.begin(), names_.end()}); }
  const std::array<const char*, COUNT>& names() const { return names_; }

 private:
  /// Returns the index of a name; COUNT if there is none.
  std::size_t find(const std::string& name) const {
    std::size_t index = 0;
    while (index < COUNT && names_[index] != name) ++index;
    return index;
  }

  const char* key_;
  std::array<const char*, COUNT> names_;
};

}  // namespace crowd
