#pragma once

#include <optional>
#include <vector>

#include "learning/states/sectors.h"

namespace crowd {

/// @brief Sectors that bodies occupy: EvenSectors, or MirroredSectors where limits are given, each with its numbers.
///
/// A position counts sectors counterclockwise; the sectors at positions p and p + 1, and at the last one and 0, are
/// adjacent. The left limit of a sector is the right limit of the one at the next position.
class ObstacleSectors {
 public:
  /// @param count number of equal sectors, if there are no limits
  /// @param limits outer limits of the sectors of one side [degrees], ascending, the last one 180; empty: equal sectors
  ObstacleSectors(int count, const std::vector<double>& limits);

  int count() const { return count_; }
  /// @brief Returns the sectors by limits; nullptr if they are equal.
  const MirroredSectors* byLimits() const { return limited_ ? &*limited_ : nullptr; }
  const EvenSectors& even() const { return even_; }

  /// @brief Returns the position of the sector that contains an angle in [-pi, pi] [rad].
  int positionOf(double angle) const { return limited_ ? limited_->positionOf(angle) : even_.indexOf(angle); }
  /// @brief Returns the number of the sector at a position.
  int sectorAt(int position) const { return limited_ ? limited_->sectorAt(position) : position; }
  /// @brief Returns the mirror image of a sector.
  int mirrored(int sector) const;
  /// @brief Return the right and the left limit of a sector [rad].
  double rightLimit(int sector) const;
  double leftLimit(int sector) const;

 private:
  EvenSectors even_;
  std::optional<MirroredSectors> limited_;
  int count_;
};

}  // namespace crowd
