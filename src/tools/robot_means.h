#pragma once

#include <string>
#include <vector>

#include "social_crowd/robot_result.h"

namespace crowd {

/// @brief A line with a measure of robots: name, value and unit.
std::string measureLine(const std::string& name, const std::string& value, const std::string& unit);

/// @brief Means of the measures of robots over episodes.
class RobotMeans {
 public:
  /// @brief Adds the measures of a robot in an episode; those that are NaN count in no mean.
  void add(const RobotResult& robot);

  /// @brief A line for each measure: mean, standard deviation of the sample, least and greatest value, unit, and the
  /// number of values where some are missing. Empty for fewer than two robots.
  std::string text() const;

 private:
  struct Measure {
    std::string name;
    std::string unit;
    std::vector<double> values;
  };

  int robots_ = 0;
  std::vector<Measure> measures_;
};

}  // namespace crowd
