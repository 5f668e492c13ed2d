#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/random.h"
#include "common/text/yaml_reader.h"

namespace crowd {

/// @brief What a person deviates from the way and the speed that it has chosen, at a moment.
struct GaitDeviation {
  double turn = 0.0;  ///< of the heading [rad]
  double pace = 1.0;  ///< factor of the speed, above 0 and at most 1
};

/// @brief How people deviate from straight lines and constant speeds: smooth random functions of time, of a different
/// extent for each agent, up to 1.7 times these maxima. Off by default. The definition is ours (docs/human.md).
struct Gait {
  double sway = 0.0;    ///< maximum deviation of the heading that changes within a second [degrees]
  double wander = 0.0;  ///< the same, within some seconds [degrees]
  double pace = 0.0;    ///< maximum decrease of the speed, as a fraction
  double shift = 0.0;   ///< mean number of random moves, each for a tick, of an agent that does not walk [1/s]

  bool isOn() const { return sway > 0.0 || wander > 0.0 || pace > 0.0 || shift > 0.0; }
  /// @param agent random numbers of this agent in this episode @param time of the episode [s]
  GaitDeviation at(const KeyedRandom& agent, double time) const;
  /// @brief The random move that an agent makes in a tick in which it would not walk; nothing in most ticks. It ends
  /// the standstill of crowds in which everybody chooses to stay.
  /// @param agent as in at() @param moves number of moves to draw from @param tick its number @param duration of it [s]
  std::optional<std::uint32_t> shiftAt(const KeyedRandom& agent, std::uint32_t moves, std::uint64_t tick,
                                       double duration) const;
};

/// @brief Reads the value of the key `gait`. @throws InputError
Gait readGait(const YAML::Node& node, const YamlPlace& place);
/// @brief Inverse of readGait().
std::string toText(const Gait& gait);

}  // namespace crowd
