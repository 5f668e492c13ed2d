// What DistributedCrowd does when a chain of impacts is longer than its copies reach.

#include <algorithm>

#include "social_crowd/ranks/distributed_crowd.h"
#include "social_crowd/simulation/byte_archive.h"

namespace crowd {
namespace {

struct NamedDisc {
  AgentId name = 0;
  SolidMotion::Disc disc;
};

template <typename Archive, typename ADisc>
void transferDisc(Archive& archive, ADisc& named) {
  archive(named.name);
  archive(named.disc.position);
  archive(named.disc.way);
  archive(named.disc.radius);
}

}  // namespace

void DistributedCrowd::moveWholeCrowd() {
  ++whole_motions_;
  Communicator::Bytes own;
  ByteWriter write(own);
  std::vector<AgentId> walking;  // names, in the order of the discs
  for (const Agent& agent : world_.agents()) {
    if (!agent.isWalking()) continue;
    const NamedDisc named{names_[agent.id], world_.solidDiscs()[walking.size()]};
    if (agent.perceives) transferDisc(write, named);
    walking.push_back(named.name);
  }
  std::vector<Communicator::Bytes> in;
  communicator_.exchangeAnySize(std::vector<Communicator::Bytes>(rankCount(), own), in);
  in[static_cast<std::size_t>(rank())] = std::move(own);
  std::vector<NamedDisc> all;
  for (const Communicator::Bytes& message : in) {
    ByteReader read(message);
    while (!read.isAtEnd()) transferDisc(read, all.emplace_back());
  }
  std::sort(all.begin(), all.end(), [](const NamedDisc& a, const NamedDisc& b) { return a.name < b.name; });
  std::vector<SolidMotion::Disc> discs;
  discs.reserve(all.size());
  for (const NamedDisc& named : all) discs.push_back(named.disc);
  const auto obstacles = world_.solidDiscs().begin() + static_cast<std::ptrdiff_t>(walking.size());
  discs.insert(discs.end(), obstacles, world_.solidDiscs().end());
  SolidMotion motion;
  const std::vector<SolidMotion::Outcome>& outcomes = motion.move(discs, world_.walls().index());
  for (std::size_t i = 0; i < walking.size(); ++i) {
    const auto found = std::lower_bound(all.begin(), all.end(), walking[i],
                                        [](const NamedDisc& named, AgentId name) { return named.name < name; });
    world_.solidOutcomes()[i] = outcomes[static_cast<std::size_t>(found - all.begin())];
  }
}

}  // namespace crowd
