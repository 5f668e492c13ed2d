#pragma once

#include <array>
#include <cstdint>

#include "social_crowd/learning/sectors.h"

namespace crowd {

/// @brief A set of sectors: bit 0 is sector 0.
using SectorSet = std::uint32_t;

/// @brief Looks at eight limits, each a unit vector: which of them a disc touches (bits 0 to 7), which have its centre
/// on their left (from bit 16), and of which its rim ends nearer than `clear` [m] (from bit 32).
using CompareLimits = std::uint64_t (*)(const double* x, const double* y, const Vector2& centre, double radius,
                                        double clear);

/// @brief A CompareLimits for every machine.
std::uint64_t compareLimitsAnywhere(const double* x, const double* y, const Vector2& centre, double radius,
                                    double clear);

/// @brief The fastest CompareLimits that this processor can run; all tell the same.
CompareLimits fastestCompareLimits();

/// @brief The limits of even sectors as directions: tells which sectors a disc reaches into without any angle.
class SectorLimits {
 public:
  static constexpr int MOST = 16;  ///< sectors

  /// @param sectors 2 to MOST of them
  /// @param compare how limits are looked at; what is told is the same whichever way
  explicit SectorLimits(const EvenSectors& sectors, CompareLimits compare = fastestCompareLimits());

  /// @brief The sectors that a disc reaches into, or the one that a point lies in. None where it ends so near a limit
  /// that rounding decides: then angles are to tell.
  /// @param centre seen from where the sectors begin [m]
  /// @param radius less than the centre's distance; 0: a point [m]
  SectorSet reachedBy(const Vector2& centre, double radius) const;

 private:
  using Lanes = std::array<double, MOST>;

  CompareLimits compare_;
  SectorSet all_;
  unsigned count_;
  alignas(64) Lanes x_{};  // of the right limit of each sector
  alignas(64) Lanes y_{};
};

}  // namespace crowd
