#include "ranks/border_exchange.h"

#include <utility>

#include "simulation/byte_archive.h"

namespace crowd {
namespace {

constexpr RelativeAction NO_ACTION{0.0, -1.0};  // of an agent that has arrived

template <typename Archive, typename AnOutcome>
void transferOutcome(Archive& archive, AnOutcome& outcome) {
  archive(outcome.position);
  archive(outcome.touched);
  archive(outcome.diverted);
  archive(outcome.history);
}

}  // namespace

void BorderExchange::set(std::vector<Shared> shared, const World& world) {
  shared_ = std::move(shared);
  slots_.assign(world.agents().size(), NONE);
  std::uint32_t count = 0;
  for (Shared& with : shared_) {
    for (AgentId& id : with.received) id = static_cast<AgentId>(world.agents().positionOf(id));
    for (AgentId& id : with.sent) {
      id = static_cast<AgentId>(world.agents().positionOf(id));
      if (slots_[id] == NONE) slots_[id] = count++;
    }
  }
  border_actions_.resize(count);
  out_.resize(shared_.size());
  in_.resize(shared_.size());
}

void BorderExchange::exchangeActions(const World& world, std::vector<AgentAction>& actions) {
  border_actions_.assign(border_actions_.size(), NO_ACTION);
  for (const AgentAction& given : actions) {
    const std::uint32_t slot = slots_[world.agents().positionOf(given.agent)];
    if (slot != NONE) border_actions_[slot] = given.action;
  }
  constexpr std::size_t SIZE = 2 * sizeof(double);
  for (std::size_t rank = 0; rank < shared_.size(); ++rank) {
    out_[rank].clear();
    ByteWriter write(out_[rank]);
    for (const AgentId position : shared_[rank].sent) {
      write(border_actions_[slots_[position]].rotation);
      write(border_actions_[slots_[position]].speed_fraction);
    }
    in_[rank].resize(SIZE * shared_[rank].received.size());
  }
  communicator_.exchange(out_, in_);
  for (std::size_t rank = 0; rank < shared_.size(); ++rank) {
    ByteReader read(in_[rank]);
    for (const AgentId position : shared_[rank].received) {
      AgentAction given{world.agents().idAt(position), {}};
      read(given.action.rotation);
      read(given.action.speed_fraction);
      if (given.action.isValid()) actions.push_back(given);
    }
  }
}

void BorderExchange::findPlaces(const World& world) {
  places_.assign(world.agents().size(), NONE);
  std::uint32_t place = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (world.agents().nth(i).isPresent()) places_[i] = place++;
  }
}

std::uint64_t BorderExchange::exchangeOutcomes(World& world) {
  findPlaces(world);
  std::vector<SolidMotion::Outcome>& outcomes = world.solidOutcomes();
  constexpr std::size_t SIZE = 2 * sizeof(double) + 2 * sizeof(bool) + sizeof(std::uint64_t);
  for (std::size_t rank = 0; rank < shared_.size(); ++rank) {
    out_[rank].clear();
    ByteWriter write(out_[rank]);
    for (const AgentId position : shared_[rank].sent) {
      const bool is_present = places_[position] != NONE;
      transferOutcome(write, is_present ? std::as_const(outcomes[places_[position]]) : SolidMotion::Outcome());
    }
    in_[rank].resize(SIZE * shared_[rank].received.size());
  }
  communicator_.exchange(out_, in_);
  std::uint64_t different = 0;
  for (std::size_t rank = 0; rank < shared_.size(); ++rank) {
    ByteReader read(in_[rank]);
    for (std::size_t i = 0; i < shared_[rank].received.size(); ++i) {
      SolidMotion::Outcome theirs;
      transferOutcome(read, theirs);
      const std::uint32_t place = places_[shared_[rank].received[i]];
      if (place == NONE) continue;
      SolidMotion::Outcome& mine = outcomes[place];
      if (shared_[rank].is_near[i] != 0 && mine.history != theirs.history) ++different;
      mine = theirs;
    }
  }
  return different;
}

}  // namespace crowd
