#pragma once

#include <cstdint>
#include <unordered_map>

#include "navigation/remaining_path.h"
#include "world/world.h"

namespace crowd {

/// @brief How much slower than at their maximum speed agents have got on, by place and direction: on squares of CELL,
/// in four directions, as a moving average. Ways through crowds take longer, and where agents do not get on, they give
/// way to those who walk back (docs/way_finding.md).
///
/// Call contract: update() once per tick. Deterministic; depends only on the world and the ways. Not thread-safe.
class CongestionMap {
 public:
  static constexpr double CELL = 1.5;        ///< side of the squares [m]
  static constexpr double RISE_TIME = 2.5;   ///< of the moving average where agents are [s]
  static constexpr double FALL_TIME = 10.0;  ///< of its return to free floor where none are [s]

  /// @brief What a way costs in addition to its length.
  struct Delay {
    double total = 0.0;               ///< [s]
    double worst = 0.0;               ///< the part of it on the worst piece of the way [s]
    Vector2 place = Vector2::Zero();  ///< of this piece; the last one of equal ones [m], `map`
  };

  /// @param paths of the agents of the world; empty for those that have none
  void update(const World& world, const AgentMap<RemainingPath>& paths);
  /// @brief The share of their maximum speed at which agents have got on there; below 0 if they have walked back, 1
  /// where none are. @param place [m] @param direction of their paths, of any length
  double shareAt(const Vector2& place, const Vector2& direction) const;
  /// @brief The delay of an agent on a way. @param corners of the way [m] @param speed its maximum speed [m/s]
  Delay delayOn(const Vector2& from, Span<Vector2> corners, double speed) const;

 private:
  using Key = std::uint64_t;
  struct Flow {
    double share = 1.0;  // see shareAt()
    double sum = 0.0;    // of the shares in this tick
    int agents = 0;      // in this tick
  };
  static Key keyOf(const Vector2& place, const Vector2& direction);

  std::unordered_map<Key, Flow> flows_;  // where agents are slowed down
};

}  // namespace crowd
