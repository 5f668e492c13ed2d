#include "simulation/crowd_decider.h"

#include <algorithm>

#include "simulation/episode.h"

namespace crowd {
namespace {

constexpr std::size_t BLOCK = 64;  // [bodies]; the perceptions of 64 agents take about 60 kB
constexpr std::size_t FEW_BLOCKS = ThreadPool::FEW_SHORT_ITEMS / BLOCK;

}  // namespace

bool CrowdDecider::decide(Episode& episode, std::vector<AgentAction>& actions) {
  actions.clear();
  const bool in_blocks = learner_.mode() == Mode::DEMO && episode.scene().order != Order::SEQUENTIAL;
  if (!in_blocks) {
    learner_.decide(episode.perceptions(), answers_);
    actions.swap(answers_.agents);
  }
  if (episode.isOver()) return false;
  if (in_blocks) decideInBlocks(episode.world(), episode.number(), episode.vision(), actions);
  return true;
}

void CrowdDecider::decideInBlocks(const World& world, std::uint64_t episode, const Vision& vision,
                                  std::vector<AgentAction>& actions) {
  actions.clear();
  const std::size_t bodies = world.grid().size();
  const std::size_t blocks = (bodies + BLOCK - 1) / BLOCK;
  if (workspaces_.size() < thread_pool_.count()) workspaces_.resize(thread_pool_.count());
  // A single worker writes its decisions directly to `actions`.
  const std::size_t lists = thread_pool_.runsInCaller(blocks, FEW_BLOCKS) ? 0 : blocks;
  if (decided_.size() < lists) decided_.resize(lists);
  for (std::size_t block = 0; block < lists; ++block) decided_[block].clear();
  thread_pool_.run(
      blocks,
      [&](unsigned worker, std::size_t begin, std::size_t end) {
        ThreadWorkspace& workspace = workspaces_[worker];
        workspace.perceptions.episode = episode;
        for (std::size_t block = begin; block < end; ++block) {
          world.stopRequest().throwIfMade();
          const std::size_t first = block * BLOCK;
          const Viewers& viewers = workspace.viewers.among(world, first, std::min(first + BLOCK, bodies));
          workspace.perceiver.perceive(world, vision, viewers, workspace.perceptions);
          learner_.decideGreedily(workspace.perceptions, workspace.decision_workspace,
                                  lists == 0 ? actions : decided_[block]);
        }
      },
      FEW_BLOCKS);
  for (std::size_t block = 0; block < lists; ++block) {
    actions.insert(actions.end(), decided_[block].begin(), decided_[block].end());
  }
}

}  // namespace crowd
