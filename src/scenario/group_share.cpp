#include "scenario/group_share.h"

#include "scenario/shares.h"

namespace crowd {

std::size_t GroupShare::drawSize(KeyedRandom random) const {
  if (share <= 0.0) return 1;
  double sum = 0.0;
  double members = 0.0;
  for (const Size& size : sizes) {
    sum += size.share;
    members += size.share * static_cast<double>(size.members);
  }
  // Of p groups and 1 - p people alone, the share p m / (p m + 1 - p) of the people is in groups of the mean size m.
  const double mean = members / sum;
  const double groups = share / (mean - share * (mean - 1.0));
  return random.uniform() < groups ? drawShare(sizes, random).members : 1;
}

}  // namespace crowd
