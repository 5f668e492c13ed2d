#pragma once

#include <cstddef>

#include "social_crowd/common/thread_pool.h"
#include "social_crowd/learning/learner.h"
#include "social_crowd/simulation/greedy_crowd.h"
#include "social_crowd/world/scene.h"
#include "social_crowd/world/world.h"

namespace crowd {

/// @brief A crowd to be walked: everybody on the way from anywhere to anywhere on a square floor without obstacles.
struct CrowdPlan {
  std::size_t agents = 10'000;
  double density = 0.5;        ///< [agents per m2]
  double vision_radius = 6.0;  ///< [m]; of what is perceived the 16 nearest neighbours
  unsigned threads = 1;
};

/// @brief The crowd's scene: mixed speeds and sizes, numbers in no order of places; the same every time.
Scene makeCrowd(const CrowdPlan& plan);

/// @brief A crowd that walks in demo mode with the shipped table `anticipation`.
class CrowdWalk {
 public:
  explicit CrowdWalk(const CrowdPlan& plan);

  /// @brief One crowd step: everybody perceives, decides and moves. @return how many did
  std::size_t step();
  const World& world() const { return world_; }
  const Vision& vision() const { return vision_; }

 private:
  World world_;
  Learner learner_;
  Vision vision_;
  ThreadPool thread_pool_;
  GreedyCrowd crowd_;
  std::vector<AgentAction> actions_;
};

}  // namespace crowd
