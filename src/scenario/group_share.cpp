#include "scenario/group_share.h"

namespace crowd {

std::size_t GroupShare::drawSize(KeyedRandom random) const {
  if (share <= 0.0) return 1;
  double sum = 0.0;
  double members = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i];
    members += weights[i] * static_cast<double>(i + 2);
  }
  // Of p groups and 1 - p people alone, the share p m / (p m + 1 - p) of the people is in groups of the mean size m.
  const double mean = members / sum;
  const double groups = share / (mean - share * (mean - 1.0));
  if (random.uniform() >= groups) return 1;
  double rest = random.uniform() * sum;
  std::size_t size = 2;
  while (size < weights.size() + 1 && rest >= weights[size - 2]) {
    rest -= weights[size - 2];
    ++size;
  }
  return size;
}

}  // namespace crowd
