#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace crowd {

/// @brief part / whole; NaN unless the whole is above 0.
inline double ratioOf(double part, double whole) {
  return whole > 0.0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}

/// @brief Least value, mean and greatest value of some numbers; NaN without any.
class Statistic {
 public:
  void add(double value) {
    least_ = count_ == 0 ? value : std::min(least_, value);
    greatest_ = count_ == 0 ? value : std::max(greatest_, value);
    sum_ += value;
    ++count_;
  }
  /// @brief Adds a value unless it is NaN.
  void addNumber(double value) {
    if (!std::isnan(value)) add(value);
  }
  std::uint64_t count() const { return count_; }
  double least() const { return least_; }
  double greatest() const { return greatest_; }
  double mean() const { return ratioOf(sum_, static_cast<double>(count_)); }

 private:
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

  std::uint64_t count_ = 0;
  double sum_ = 0.0;
  double least_ = NONE;
  double greatest_ = NONE;
};

}  // namespace crowd
