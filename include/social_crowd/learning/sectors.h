#pragma once

#include <vector>

#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief Even sectors of the circle, number 0 centred straight ahead, counted counterclockwise. A sector holds its
/// right limit and not its left one.
class EvenSectors {
 public:
  explicit EvenSectors(int count)
      : count_(count), width_(2.0 * PI / count), per_radian_(count / (2.0 * PI)), place_of_ahead_(2.0 * count + 0.5) {}

  int count() const { return count_; }
  /// @brief Width of a sector [rad].
  double width() const { return width_; }
  /// @brief The sector of an angle [rad], whatever its multiple of the full circle.
  int indexOf(double angle) const { return wrap(unwrappedIndexOf(angle)); }
  /// @brief The sector of a direction: exactly that of its bearing, which is found out next to a limit only.
  int indexOf(const Vector2& direction) const {
    return wrap(unwrappedIndexOf(quickBearingOf(direction), QUICK_BEARING_ERROR, [&] { return bearingOf(direction); }));
  }
  /// @brief The same not yet taken modulo the number of sectors, for sweeping an interval of angles.
  long unwrappedIndexOf(double angle) const { return static_cast<long>(std::floor(angle / width_ + 0.5)); }
  /// @brief The same of an angle in (-2 pi, 2 pi) of which a guess that is at most `error` off [rad] nearly always says
  /// enough. @param angle tells the angle itself
  template <typename Angle>
  long unwrappedIndexOf(double guess, double error, const Angle& angle) const {
    const double place = guess * per_radian_ + place_of_ahead_;
    if (!(place > 0.0)) return unwrappedIndexOf(angle());  // there is none
    const auto whole = static_cast<long>(place);
    const double off_middle = std::abs(place - static_cast<double>(whole) - 0.5);
    return off_middle < 0.5 - ROUNDING - error * per_radian_ ? whole - 2L * count_ : unwrappedIndexOf(angle());
  }
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
  static constexpr double ROUNDING = 1e-9;  // far more than comes together, far less than a sector

  int count_;
  double width_;
  double per_radian_;
  double place_of_ahead_;  // so many sectors to the left of two circles to the right
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
