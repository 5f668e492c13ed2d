#include "social_crowd/simulation/greedy_crowd.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr std::size_t BLOCK = 64;  // [bodies]; the perceptions of 64 agents take about 60 kB
constexpr std::size_t FEW_BLOCKS = ThreadPool::FEW_SHORT_ITEMS / BLOCK;

}  // namespace

void GreedyCrowd::decide(const World& world, std::uint64_t episode, const Vision& vision, const Learner& learner,
                         std::vector<AgentAction>& actions, ThreadPool& thread_pool,
                         const std::vector<AgentId>* names) {
  const std::size_t bodies = world.grid().size();
  const std::size_t blocks = (bodies + BLOCK - 1) / BLOCK;
  if (workspaces_.size() < thread_pool.count()) workspaces_.resize(thread_pool.count());
  // A single worker writes its decisions directly to `actions`.
  const std::size_t lists = thread_pool.runsInCaller(blocks, FEW_BLOCKS) ? 0 : blocks;
  if (decided_.size() < lists) decided_.resize(lists);
  for (std::size_t block = 0; block < lists; ++block) decided_[block].clear();
  actions.clear();
  thread_pool.run(
      blocks,
      [&](unsigned worker, std::size_t begin, std::size_t end) {
        ThreadWorkspace& workspace = workspaces_[worker];
        workspace.perceptions.episode = episode;
        for (std::size_t block = begin; block < end; ++block) {
          world.stopRequest().throwIfMade();
          const std::size_t first = block * BLOCK;
          const Viewers& viewers = workspace.viewers.among(world, first, std::min(first + BLOCK, bodies));
          workspace.perceiver.perceive(world, vision, viewers, workspace.perceptions);
          decideBlock(learner, names, workspace, lists == 0 ? actions : decided_[block]);
        }
      },
      FEW_BLOCKS);
  for (std::size_t block = 0; block < lists; ++block) {
    actions.insert(actions.end(), decided_[block].begin(), decided_[block].end());
  }
}

void GreedyCrowd::decideBlock(const Learner& learner, const std::vector<AgentId>* names, ThreadWorkspace& workspace,
                              std::vector<AgentAction>& actions) {
  const std::size_t before = actions.size();
  if (names != nullptr) {
    workspace.ids.clear();
    for (AgentPerception& self : workspace.perceptions.agents) {
      workspace.ids.push_back(self.agent);
      self.agent = (*names)[self.agent];
    }
  }
  learner.decideGreedily(workspace.perceptions, workspace.decision_workspace, actions);
  if (names == nullptr) return;
  for (std::size_t i = 0; i < workspace.ids.size(); ++i) actions[before + i].agent = workspace.ids[i];
}

}  // namespace crowd
