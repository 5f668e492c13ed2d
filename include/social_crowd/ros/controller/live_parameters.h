#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "social_crowd/common/number_range.h"

namespace crowd {

/// @brief Value of a parameter that may change while its node runs. The types are those of dynamic_reconfigure.
using LiveValue = std::variant<bool, int, double, std::string>;
/// @brief Values of all such parameters of a node, in the order of their descriptions.
using LiveValues = std::vector<LiveValue>;

/// @brief What users see of such a parameter.
struct LiveDescription {
  std::string name;
  std::string meaning;               ///< one line, with the unit
  NumberRange range;                 ///< of a number
  std::vector<std::string> choices;  ///< of a text; empty: any text
};

/// @brief Returns a value as text for messages.
std::string toText(const LiveValue& value);

/// @brief Returns what is wrong with a value, such as "expected a number from 0 to 1, got 2"; empty: nothing.
std::string problemOf(const LiveDescription& about, const LiveValue& value);

/// @brief The parameters of a node that may change while it runs, as values of its settings.
template <typename Settings>
class LiveParameters {
 public:
  /// @brief Adds a parameter that is a member of the settings.
  template <typename Value>
  void add(LiveDescription about, Value Settings::*member) {
    add<Value>(
        std::move(about), [member](const Settings& settings) { return settings.*member; },
        [member](Settings& settings, const Value& value) { settings.*member = value; });
  }
  /// @brief Adds a parameter that two functions read and write.
  template <typename Value>
  void add(LiveDescription about, std::function<Value(const Settings&)> get,
           std::function<void(Settings&, const Value&)> set) {
    static_assert(std::is_constructible_v<LiveValue, Value>);
    descriptions_.push_back(std::move(about));
    accessors_.push_back({[get = std::move(get)](const Settings& settings) { return LiveValue(get(settings)); },
                          [set = std::move(set)](Settings& settings, const LiveValue& value) {
                            set(settings, std::get<Value>(value));
                          }});
  }

  const std::vector<LiveDescription>& descriptions() const { return descriptions_; }

  LiveValues valuesOf(const Settings& settings) const {
    LiveValues values;
    for (const Accessor& accessor : accessors_) values.push_back(accessor.get(settings));
    return values;
  }
  /// @brief Returns the settings with these values. Parameters whose value stays the same are not written.
  Settings changed(Settings settings, const LiveValues& values) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (accessors_[i].get(settings) != values[i]) accessors_[i].set(settings, values[i]);
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
