#include "social_crowd/simulation/greedy_crowd.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr std::size_t BLOCK = 64;  // bodies; what 64 agents perceive is some 60 kB

}  // namespace

void GreedyCrowd::decide(const World& world, const Vision& vision, const Learner& learner,
                         std::vector<AgentAction>& actions, Workers& workers) {
  const std::size_t bodies = world.bodyCount();
  const std::size_t blocks = (bodies + BLOCK - 1) / BLOCK;
  desks_.resize(std::max<std::size_t>(desks_.size(), workers.count()));
  decided_.resize(std::max(decided_.size(), blocks));
  workers.run(
      blocks,
      [&](unsigned worker, std::size_t begin, std::size_t end) {
        Desk& desk = desks_[worker];
        for (std::size_t block = begin; block < end; ++block) {
          const std::size_t first = block * BLOCK;
          world.perceiveSome(vision, first, std::min(first + BLOCK, bodies), desk.looker, desk.perceptions);
          decided_[block].clear();
          learner.decideGreedily(desk.perceptions, desk.space, decided_[block]);
        }
      },
      FEW_AGENTS / BLOCK);
  actions.clear();
  for (std::size_t block = 0; block < blocks; ++block) {
    actions.insert(actions.end(), decided_[block].begin(), decided_[block].end());
  }
}

}  // namespace crowd
