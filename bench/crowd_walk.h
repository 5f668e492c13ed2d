#pragma once

#include <cstddef>
#include <optional>

#include "common/thread_pool.h"
#include "geometry/motion_limits.h"
#include "learning/learner.h"
#include "navigation/way_finder.h"
#include "scenario/scene.h"
#include "simulation/crowd_decider.h"

namespace crowd {

/// @brief Parameters of a crowd with random starts and goals on a square floor without obstacles.
struct CrowdPlan {
  std::size_t agents = 10'000;
  double density = 0.5;        ///< [agents per m2]
  double vision_radius = 6.0;  ///< [m]; at most the 16 nearest neighbours are perceived
  unsigned threads = 1;
  std::optional<MotionLimits> motion;  ///< see Scene
};

/// @brief Scene of the crowd: mixed speeds and sizes, ids independent of positions; deterministic.
Scene makeCrowd(const CrowdPlan& plan);

/// @brief A learner in demo mode with the shipped table `anticipation`.
Learner makeWalker();

/// @brief A crowd in demo mode with the shipped table `anticipation`.
class CrowdWalk {
 public:
  explicit CrowdWalk(const CrowdPlan& plan);
  /// @param vision_radius [m]
  explicit CrowdWalk(const Scene& scene, double vision_radius = 6.0, unsigned threads = 1);

  /// @brief One crowd step without measures: all agents perceive, decide and move, and find their ways.
  /// @return number of agents
  std::size_t step();
  const World& world() const { return world_; }
  const Vision& vision() const { return vision_; }

 private:
  World world_;
  WayFinder way_finder_;
  Learner learner_;
  Vision vision_;
  ThreadPool thread_pool_;
  CrowdDecider decider_;
  std::vector<AgentAction> actions_;
};

}  // namespace crowd
