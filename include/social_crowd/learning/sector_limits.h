#pragma once

#include <array>
#include <cstdint>

#include "social_crowd/learning/sectors.h"

namespace crowd {

/// @brief A set of sectors: bit 0 is sector 0.
using SectorSet = std::uint32_t;

/// @brief The limits of even sectors as directions: tells which sectors a disc reaches into without any angle.
class SectorLimits {
 public:
  static constexpr int MOST = 16;  ///< sectors

  /// @param sectors 2 to MOST of them
  explicit SectorLimits(const EvenSectors& sectors);

  /// @brief The sectors that a disc reaches into, or the one that a point lies in. None where it ends so near a limit
  /// that rounding decides: then angles are to tell.
  /// @param centre seen from where the sectors begin [m]
  /// @param radius less than the distance; 0: a point [m]
  SectorSet reachedBy(const Vector2& centre, double radius) const;

 private:
  using Lanes = std::array<double, MOST>;

  SectorSet all_;
  unsigned count_;
  alignas(64) Lanes x_{};  // of the right limit of each sector
  alignas(64) Lanes y_{};
};

}  // namespace crowd
