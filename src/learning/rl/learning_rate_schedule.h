#pragma once

#include <cstdint>
#include <vector>

#include "learning/rl/learning_parameters.h"

namespace crowd {

/// @brief Table of LearningParameters::learningRate() by the number of visits: a lookup is faster than a power per
/// decision. Immutable.
class LearningRateSchedule {
 public:
  explicit LearningRateSchedule(const LearningParameters& parameters);

  /// @brief Returns the learning rate of visit number `visits` of a row and action, counted from 1.
  double at(std::uint32_t visits) const {
    if (visits < sizes_.size()) return sizes_[visits];
    return steady_ ? parameters_.alpha : parameters_.learningRate(visits);
  }
  /// @brief Returns the weight, 0 to 1, that the value after `first` visits has in the value after `last` visits: the
  /// product of (1 - learning rate) of the visits in between.
  double retainedWeight(std::uint32_t first, std::uint32_t last) const;

 private:
  LearningParameters parameters_;
  std::vector<double> sizes_;  // learning rates of the first visits, [0] is unused; empty if constant
  bool steady_ = true;         // whether all later ones are alpha
};

}  // namespace crowd
