#pragma once

#include <vector>

#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief Even sectors of the circle, number 0 centred straight ahead, counted counterclockwise. A sector holds its
/// right limit and not its left one.
class EvenSectors {
 public:
  explicit EvenSectors(int count) : count_(count), width_(2.0 * PI / count) {}

  int count() const { return count_; }
  /// @brief Width of a sector [rad].
  double width() const { return width_; }
  /// @brief The sector of an angle [rad], whatever its multiple of the full circle.
  int indexOf(double angle) const { return wrap(unwrappedIndexOf(angle)); }
  /// @brief The same not yet taken modulo the number of sectors, for sweeping an interval of angles.
  long unwrappedIndexOf(double angle) const { return static_cast<long>(std::floor(angle / width_ + 0.5)); }
  int wrap(long index) const {
    if (index >= -count_ && index < count_) return static_cast<int>(index) + (index < 0 ? count_ : 0);
    const long rest = index % count_;
    return static_cast<int>(rest < 0 ? rest + count_ : rest);
  }
  /// @brief The sector on the other side. What lies exactly on a limit has its mirror image in the next sector, as the
  /// limit is the right one of both.
  int mirrored(int index) const { return wrap(-static_cast<long>(index)); }
  /// @brief The right limit of a sector [rad].
  double rightLimit(long index) const { return (static_cast<double>(index) - 0.5) * width_; }

 private:
  int count_;
  double width_;
};

/// @brief Sectors that mirror left and right and may be of uneven width: finer in front (thesis fig. 3.6).
///
/// Sectors 0 .. n-1 lie on the left from front to back, n .. 2n-1 on the right. An angle exactly on a limit belongs to
/// the sector behind it, straight ahead to the left.
class MirroredSectors {
 public:
  /// @param limits outer limits of the sectors of one side [rad], rising, the last one pi.
  explicit MirroredSectors(std::vector<double> limits) : limits_(std::move(limits)) {}

  int count() const { return 2 * static_cast<int>(limits_.size()); }
  /// @brief The sector of an angle in [-pi, pi].
  int indexOf(double angle) const;
  /// @brief The sector on the other side.
  int mirrored(int index) const { return (index + count() / 2) % count(); }
  /// @brief Right and left limit of a sector [rad].
  double rightLimit(int index) const;
  double leftLimit(int index) const;

 private:
  double inner(int side_index) const {
    return side_index == 0 ? 0.0 : limits_[static_cast<std::size_t>(side_index) - 1];
  }
  double outer(int side_index) const { return limits_[static_cast<std::size_t>(side_index)]; }

  std::vector<double> limits_;
};

}  // namespace crowd
