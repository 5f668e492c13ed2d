#include "learning/rl/learning_rate_schedule.h"

#include "common/portable_math.h"

namespace crowd {
namespace {

constexpr std::uint32_t MAX_SIZE = 1U << 14U;  // a table of this size stays in the cache

}  // namespace

LearningRateSchedule::LearningRateSchedule(const LearningParameters& parameters) : parameters_(parameters) {
  if (parameters.alpha_decay <= 0.0) return;
  sizes_.push_back(1.0);
  while (sizes_.size() < MAX_SIZE && sizes_.back() > parameters.alpha) {
    sizes_.push_back(parameters.learningRate(static_cast<std::uint32_t>(sizes_.size())));
  }
  steady_ = sizes_.back() <= parameters.alpha;
}

double LearningRateSchedule::retainedWeight(std::uint32_t first, std::uint32_t last) const {
  double kept = 1.0;
  for (std::uint32_t done = first; done < last; ++done) {
    const double step = at(done + 1);
    // All further learning rates are alpha.
    if (step <= parameters_.alpha) return kept * portable::pow(1.0 - parameters_.alpha, last - done);
    kept *= 1.0 - step;
  }
  return kept;
}

}  // namespace crowd
