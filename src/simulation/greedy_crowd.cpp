#include "social_crowd/simulation/greedy_crowd.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr std::size_t BLOCK = 64;  // bodies; what 64 agents perceive is some 60 kB

}  // namespace

void GreedyCrowd::decide(const World& world, const Vision& vision, const Learner& learner,
                         std::vector<AgentAction>& actions, Workers& workers) {
  desks_.resize(std::max<std::size_t>(desks_.size(), workers.count()));
  for (Desk& desk : desks_) desk.actions.clear();
  workers.run(
      world.bodyCount(),
      [&](unsigned worker, std::size_t begin, std::size_t end) {
        Desk& desk = desks_[worker];
        for (; begin < end; begin += BLOCK) {
          world.perceiveSome(vision, begin, std::min(begin + BLOCK, end), desk.looker, desk.perceptions);
          learner.decideGreedily(desk.perceptions, desk.space, desk.actions);
        }
      },
      FEW_AGENTS);
  actions.clear();
  for (const Desk& desk : desks_) actions.insert(actions.end(), desk.actions.begin(), desk.actions.end());
}

}  // namespace crowd
