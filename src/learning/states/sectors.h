#pragma once

#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Sectors of equal width around an agent. Sector 0 is centred straight ahead; numbers ascend counterclockwise.
/// A sector includes its right limit and excludes its left limit.
class EvenSectors {
 public:
  explicit EvenSectors(int count) : count_(count), width_(2.0 * PI / count) {}

  int count() const { return count_; }
  /// @brief Width of a sector [rad].
  double width() const { return width_; }
  /// @brief Returns the sector of an angle [rad], of any range.
  int indexOf(double angle) const { return wrap(unwrappedIndexOf(angle)); }
  /// @brief The same without the modulo operation, for sweeps over an interval of angles.
  long unwrappedIndexOf(double angle) const { return static_cast<long>(std::floor(angle / width_ + 0.5)); }
  /// @brief Reduces an unwrapped index to 0 .. count() - 1.
  int wrap(long index) const {
    if (index >= -count_ && index < count_) return static_cast<int>(index) + (index < 0 ? count_ : 0);
    const long rest = index % count_;
    return static_cast<int>(rest < 0 ? rest + count_ : rest);
  }
  /// @brief Returns the mirror image of a sector. The mirror image of a point exactly on a limit lies in the adjacent
  /// sector, because each sector includes its right limit.
  int mirrored(int index) const { return wrap(-static_cast<long>(index)); }
  /// @brief Returns the right limit of a sector [rad].
  double rightLimit(long index) const { return (static_cast<double>(index) - 0.5) * width_; }

 private:
  int count_;
  double width_;
};

/// @brief Sectors that are symmetric about the heading and may differ in width, such as narrower in front (thesis,
/// fig. 3.6).
///
/// Sectors 0 .. n-1 lie on the left from front to back, n .. 2n-1 on the right. An angle exactly on a limit belongs to
/// the rear one of both sectors; straight ahead belongs to the left.
class MirroredSectors {
 public:
  /// @param limits outer limits of the sectors of one side [degrees], ascending, the last one 180
  explicit MirroredSectors(std::vector<double> limits);

  int count() const { return 2 * static_cast<int>(limits_.size()); }
  /// @brief Returns the sector of an angle in [-pi, pi] [rad].
  int indexOf(double angle) const { return sectorAt(positionOf(angle)); }
  /// @brief Returns the position of that sector if sectors are counted counterclockwise, from the first one on the
  /// left.
  int positionOf(double angle) const;
  /// @brief Returns the sector at a position. The sector at position 0 is 0, that at the last position is n.
  int sectorAt(int position) const { return position < count() / 2 ? position : 3 * count() / 2 - 1 - position; }
  /// @brief Returns the mirror image of a sector.
  int mirrored(int index) const { return (index + count() / 2) % count(); }
  /// @brief Return the right and the left limit of a sector [rad].
  double rightLimit(int index) const;
  double leftLimit(int index) const;
  /// @brief Outer limits of the sectors of one side [degrees].
  const std::vector<double>& degrees() const { return degrees_; }

 private:
  double inner(int side_index) const {
    return side_index == 0 ? 0.0 : limits_[static_cast<std::size_t>(side_index) - 1];
  }
  double outer(int side_index) const { return limits_[static_cast<std::size_t>(side_index)]; }

  std::vector<double> degrees_;
  std::vector<double> limits_;  // [rad]
};

}  // namespace crowd
