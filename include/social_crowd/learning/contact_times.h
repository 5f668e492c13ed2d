#pragma once

#include <array>
#include <cstddef>

#include "social_crowd/learning/chooser.h"
#include "social_crowd/learning/move_outlooks.h"
#include "social_crowd/learning/time_to_contact.h"
#include "social_crowd/world/geometry.h"
#include "social_crowd/world/view.h"

namespace crowd {

/// @brief 1 / time to contact of what touches already.
constexpr float AT_ONCE = 1e30F;  // [1/s]

/// @brief Velocities of an agent's moves, and how soon each would touch something: 1 / time.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): whoever makes them writes them, and zeroing takes time
struct Courses {
  using Lanes = MoveOutlooks::Lanes;

  std::size_t count;   ///< moves; lanes behind them repeat one
  float speed;         ///< no move is faster [m/s]
  Vector2 velocity;    ///< of the agent in the last tick [m/s]
  Vector2 wish;        ///< another velocity [m/s]
  float time_to_goal;  ///< at full speed; what lies behind the goal does not count [s]
  float fastest;       ///< the square of the fastest approach of another agent if this one walked with that [m2/s2]
  bool any_fixed;      ///< whether anything but agents was noted

  alignas(64) Lanes ux;  ///< [m/s]
  alignas(64) Lanes uy;
  alignas(64) Lanes reciprocal;  ///< [1/s]
  alignas(64) Lanes selfish;
  alignas(64) Lanes fixed;

  /// @brief Nothing is touched, and nobody comes.
  void touchNothing() {
    fastest = 0.0F;
    any_fixed = false;
    for (Lanes* soonest : {&reciprocal, &selfish, &fixed}) soonest->fill(static_cast<float>(1.0 / NEVER));
  }
};

/// @brief Discs as the agent sees them, side by side, see put(). Places that are left are to hold discs that fly away,
/// see leaveOut().
struct Discs {
  static constexpr std::size_t SIZE = 16;
  static constexpr float FLYING = 1e6F;  ///< [m/s]
  using Floats = std::array<float, SIZE>;

  alignas(64) Floats px;  ///< [m]
  alignas(64) Floats py;
  alignas(64) Floats vx;  ///< [m/s]
  alignas(64) Floats vy;
  alignas(64) Floats apart;  ///< square of the distance less that of the reach, 0 if they overlap [m2]

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): whoever makes them writes them, and zeroing takes time
  Discs() = default;
  /// @brief Writes a disc.
  /// @param place of its centre, seen from the agent's [m]
  /// @param velocity over ground [m/s]
  /// @param reach sum of both radii [m]
  void put(std::size_t i, const Vector2& place, const Vector2& velocity, double reach) {
    px[i] = static_cast<float>(place.x());
    py[i] = static_cast<float>(place.y());
    vx[i] = static_cast<float>(velocity.x());
    vy[i] = static_cast<float>(velocity.y());
    const double gap = (place.x() * place.x() + place.y() * place.y()) - reach * reach;
    apart[i] = static_cast<float>(gap > 0.0 ? gap : 0.0);
  }
  /// @brief Makes those from a number on fly away.
  void leaveOut(std::size_t first) {
    // All places at once: written one by one they could not be read as a whole before they are in the cache.
    const auto flies = static_cast<std::int32_t>(first);
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(SIZE); ++i) {
      px[i] = i < flies ? px[i] : 1.0F;
      py[i] = i < flies ? py[i] : 1.0F;
      vx[i] = i < flies ? vx[i] : FLYING;
      vy[i] = i < flies ? vy[i] : FLYING;
      apart[i] = i < flies ? apart[i] : 1.0F;
    }
  }
};

/// @brief Agents that another one meets.
struct Encounter {
  Discs discs;
  std::size_t count;  ///< the first so many discs are agents, and those behind them fly away
  Courses* courses;   ///< of who meets them
};
using Encounters = View<Encounter>;
constexpr std::size_t MAX_ENCOUNTERS = MAX_CHOOSERS;

/// @brief Notes contacts with agents, and their fastest approach.
/// @param encounters MAX_ENCOUNTERS at most
void noteAgents(const Encounters& encounters);

/// @brief Notes contacts with what yields to nobody.
/// @param count as of an Encounter
void noteFixed(const Discs& discs, std::size_t count, Courses& courses);

/// @brief noteAgents() for any processor.
void noteAgentsPlainly(const Encounters& encounters);

}  // namespace crowd
