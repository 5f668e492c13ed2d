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
  if (desks_.size() < workers.count()) desks_.resize(workers.count());
  const auto decide_block = [&](Desk& desk, std::size_t block, std::vector<AgentAction>& decided) {
    const std::size_t first = block * BLOCK;
    world.perceiveSome(vision, first, std::min(first + BLOCK, bodies), desk.looker, desk.perceptions);
    learner.decideGreedily(desk.perceptions, desk.space, decided);
  };
  actions.clear();
  if (workers.count() == 1 || bodies <= FEW_AGENTS) {
    for (std::size_t block = 0; block < blocks; ++block) decide_block(desks_.front(), block, actions);
    return;
  }
  if (decided_.size() < blocks) decided_.resize(blocks);
  workers.run(blocks, [&](unsigned worker, std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      decided_[block].clear();
      decide_block(desks_[worker], block, decided_[block]);
    }
  });
  for (std::size_t block = 0; block < blocks; ++block) {
    actions.insert(actions.end(), decided_[block].begin(), decided_[block].end());
  }
}

}  // namespace crowd
