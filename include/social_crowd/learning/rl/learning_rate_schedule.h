#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/learning/rl/learning_parameters.h"

namespace crowd {

/// @brief LearningParameters::learningRate() by the number of visits, worked out in advance: a power for every decision
/// would take longer than to look it up.
class LearningRateSchedule {
 public:
  explicit LearningRateSchedule(const LearningParameters& parameters);

  /// @brief Share of the way to the target that a value goes when its row and action are visited for the n-th time.
  double at(std::uint32_t visits) const {
    if (visits < sizes_.size()) return sizes_[visits];
    return steady_ ? parameters_.alpha : parameters_.learningRate(visits);
  }
  /// @brief Share that what a value was after `first` visits has in what it is after `last`.
  double retainedWeight(std::uint32_t first, std::uint32_t last) const;

 private:
  LearningParameters parameters_;
  std::vector<double> sizes_;  // of the first visits, [0] unused; empty where all steps are equal
  bool steady_ = true;         // all steps behind those are alpha
};

}  // namespace crowd
