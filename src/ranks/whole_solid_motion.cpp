// What DistributedCrowd does when a chain of impacts is longer than its copies reach.

#include <algorithm>

#include "ranks/distributed_crowd.h"
#include "simulation/byte_archive.h"

namespace crowd {
namespace {

struct AgentDisc {
  AgentId id = 0;
  SolidMotion::Disc disc;
};

template <typename Archive, typename ADisc>
void transferDisc(Archive& archive, ADisc& moved) {
  archive(moved.id);
  archive(moved.disc.position);
  archive(moved.disc.way);
  archive(moved.disc.radius);
}

}  // namespace

void DistributedCrowd::moveWholeCrowd(World& world) {
  ++whole_motions_;
  Communicator::Bytes own;
  ByteWriter write(own);
  std::vector<AgentId> present;  // in the order of the discs
  for (const Agent& agent : world.agents()) {
    if (!agent.isPresent()) continue;
    const AgentDisc moved{agent.id, world.solidDiscs()[present.size()]};
    if (agent.perceives) transferDisc(write, moved);
    present.push_back(agent.id);
  }
  std::vector<Communicator::Bytes> in;
  communicator_.exchangeAnySize(std::vector<Communicator::Bytes>(rankCount(), own), in);
  in[static_cast<std::size_t>(rank())] = std::move(own);
  std::vector<AgentDisc> all;
  for (const Communicator::Bytes& message : in) {
    ByteReader read(message);
    while (!read.isAtEnd()) transferDisc(read, all.emplace_back());
  }
  std::sort(all.begin(), all.end(), [](const AgentDisc& a, const AgentDisc& b) { return a.id < b.id; });
  std::vector<SolidMotion::Disc> discs;
  discs.reserve(all.size());
  for (const AgentDisc& moved : all) discs.push_back(moved.disc);
  const auto obstacles = world.solidDiscs().begin() + static_cast<std::ptrdiff_t>(present.size());
  discs.insert(discs.end(), obstacles, world.solidDiscs().end());
  SolidMotion motion;
  const std::vector<SolidMotion::Outcome>& outcomes = motion.move(discs, world.walls().index());
  for (std::size_t i = 0; i < present.size(); ++i) {
    const auto found = std::lower_bound(all.begin(), all.end(), present[i],
                                        [](const AgentDisc& moved, AgentId id) { return moved.id < id; });
    world.solidOutcomes()[i] = outcomes[static_cast<std::size_t>(found - all.begin())];
  }
}

}  // namespace crowd
