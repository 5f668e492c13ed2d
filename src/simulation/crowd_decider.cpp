#include "social_crowd/simulation/crowd_decider.h"

#include <algorithm>

#include "social_crowd/simulation/episode.h"

namespace crowd {
namespace {

constexpr std::size_t BLOCK = 64;  // [bodies]; the perceptions of 64 agents take about 60 kB
constexpr std::size_t FEW_BLOCKS = ThreadPool::FEW_SHORT_ITEMS / BLOCK;

}  // namespace

bool CrowdDecider::decide(Episode& episode, std::vector<AgentAction>& actions) {
  actions.clear();
  const bool is_sequential = episode.scene().order == Order::SEQUENTIAL;
  const bool are_divisible = learner_.mode() == Mode::DEMO && !is_sequential;
  if (!are_divisible && share_.number == 0) {
    learner_.decide(episode.perceptions(), answers_);
    actions.swap(answers_.agents);
  } else if (is_sequential) {
    episode.perceptions();  // finds whose turn it is
  }
  if (episode.isOver()) return false;
  if (are_divisible) decideInBlocks(episode, actions);
  return true;
}

void CrowdDecider::decideInBlocks(const Episode& episode, std::vector<AgentAction>& actions) {
  const World& world = episode.world();
  const std::size_t bodies = world.grid().size();
  const std::size_t all_blocks = (bodies + BLOCK - 1) / BLOCK;
  const std::size_t first_block = all_blocks * share_.number / share_.count;
  const std::size_t blocks = all_blocks * (share_.number + 1) / share_.count - first_block;
  if (workspaces_.size() < thread_pool_.count()) workspaces_.resize(thread_pool_.count());
  // A single worker writes its decisions directly to `actions`.
  const std::size_t lists = thread_pool_.runsInCaller(blocks, FEW_BLOCKS) ? 0 : blocks;
  if (decided_.size() < lists) decided_.resize(lists);
  for (std::size_t block = 0; block < lists; ++block) decided_[block].clear();
  thread_pool_.run(
      blocks,
      [&](unsigned worker, std::size_t begin, std::size_t end) {
        ThreadWorkspace& workspace = workspaces_[worker];
        workspace.perceptions.episode = episode.number();
        for (std::size_t block = begin; block < end; ++block) {
          world.stopRequest().throwIfMade();
          const std::size_t first = (first_block + block) * BLOCK;
          const Viewers& viewers = workspace.viewers.among(world, first, std::min(first + BLOCK, bodies));
          workspace.perceiver.perceive(world, episode.vision(), viewers, workspace.perceptions);
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
