#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "common/text/number_range.h"

namespace crowd {

/// @brief Value of a parameter that may change while its node runs. The types are those of dynamic_reconfigure.
using LiveValue = std::variant<bool, int, double, std::string>;
/// @brief Values of all such parameters of a node, in the order of their descriptions.
using LiveValues = std::vector<LiveValue>;
/// @brief New values of some of them, by name.
using LiveChanges = std::vector<std::pair<std::string, LiveValue>>;

/// @brief What users see of such a parameter.
struct LiveDescription {
  std::string name;
  std::string meaning;               ///< one line, with the unit
  NumberRange range;                 ///< of a number
  std::vector<std::string> choices;  ///< of a text; empty: any text
};

/// @brief Name of the type of a value in dynamic_reconfigure.
std::string typeOf(const LiveValue& value);

/// @brief Makes changes; a whole number stands for any number. @throws InputError that lists unknown parameters and
/// invalid values; `values` has not changed then
void applyChanges(const std::vector<LiveDescription>& parameters, const LiveChanges& changes, LiveValues& values);

/// @brief The parameters of a node that may change while it runs, as values of its settings. Services and
/// dynamic_reconfigure change them by changed().
template <typename Settings>
class LiveParameters {
 public:
  /// @brief Adds a parameter. @param place pointer to a member of the settings, or function that returns a reference
  /// into them
  template <typename Place>
  void add(LiveDescription about, Place place) {
    using Value = std::decay_t<std::invoke_result_t<Place, Settings&>>;
    add<Value>(
        std::move(about), [place](const Settings& settings) { return std::invoke(place, settings); },
        [place](Settings& settings, const Value& value) { std::invoke(place, settings) = value; });
  }
  /// @brief Adds a parameter that two functions read and write.
  template <typename Value>
  void add(LiveDescription about, std::function<Value(const Settings&)> get,
           std::function<void(Settings&, const Value&)> set) {
    descriptions_.push_back(std::move(about));
    accessors_.push_back({std::move(get), [set = std::move(set)](Settings& settings, const LiveValue& value) {
                            set(settings, std::get<Value>(value));
                          }});
  }

  const std::vector<LiveDescription>& descriptions() const { return descriptions_; }

  LiveValues valuesOf(const Settings& settings) const {
    LiveValues values;
    for (const Accessor& accessor : accessors_) values.push_back(accessor.get(settings));
    return values;
  }
  /// @brief Returns the settings with these changes. Parameters whose value stays the same are not written.
  /// @throws InputError as applyChanges() does
  Settings changed(Settings settings, const LiveChanges& changes) const {
    const LiveValues before = valuesOf(settings);
    LiveValues values = before;
    applyChanges(descriptions_, changes, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (before[i] != values[i]) accessors_[i].set(settings, values[i]);
    }
    return settings;
  }

 private:
  struct Accessor {
    std::function<LiveValue(const Settings&)> get;
    std::function<void(Settings&, const LiveValue&)> set;
  };

  std::vector<LiveDescription> descriptions_;
  std::vector<Accessor> accessors_;
};

}  // namespace crowd
