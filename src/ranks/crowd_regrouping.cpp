// How DistributedCrowd divides its agents among the ranks.

#include <algorithm>
#include <utility>

#include "ranks/distributed_crowd.h"
#include "simulation/agent_transfer.h"
#include "simulation/byte_archive.h"

namespace crowd {

void DistributedCrowd::regroup() {
  next_regroup_ = tick() + options_.regroup_ticks;
  agents_.clear();
  tracks_.clear();
  episode_.edit().replaceCrowd(agents_, tracks_);
  strips_.balance(keepOwn(), communicator_);
  shared_.assign(rankCount(), {});
  std::vector<Traveller> newcomers = handOver();
  noteShares(kept_.size() + newcomers.size());
  std::vector<Traveller> copies = exchangeCopies(newcomers);
  newcomers.insert(newcomers.end(), std::make_move_iterator(copies.begin()), std::make_move_iterator(copies.end()));
  adopt(std::move(newcomers));
}

std::vector<Vector2> DistributedCrowd::keepOwn() {
  kept_.clear();
  std::vector<Vector2> places;
  places.reserve(agents_.size());
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if (!agents_[i].perceives) continue;
    if (agents_[i].isPresent()) {
      kept_.push_back(static_cast<std::uint32_t>(i));
      places.push_back(agents_[i].pose.position);
    } else {
      finished_.push_back({agents_[i].id, episode_.monitor().resultOf(tracks_[i])});
    }
  }
  return places;
}

std::vector<DistributedCrowd::Traveller> DistributedCrowd::handOver() {
  std::vector<Communicator::Bytes> out(rankCount());
  std::vector<Communicator::Bytes> in;
  const auto leaves = [&](std::uint32_t i) {
    const int owner = strips_.stripOf(agents_[i].pose.position);
    if (owner == rank()) return false;
    ByteWriter write(out[static_cast<std::size_t>(owner)]);
    transferAgent(write, std::as_const(agents_[i]));
    transferTrack(write, std::as_const(tracks_[i]));
    return true;
  };
  kept_.erase(std::remove_if(kept_.begin(), kept_.end(), leaves), kept_.end());
  communicator_.exchangeAnySize(out, in);
  std::vector<Traveller> newcomers;
  for (const Communicator::Bytes& message : in) {
    ByteReader read(message);
    while (!read.isAtEnd()) {
      Traveller& newcomer = newcomers.emplace_back();
      transferAgent(read, newcomer.agent);
      transferTrack(read, newcomer.track);
    }
  }
  return newcomers;
}

void DistributedCrowd::writeCopies(const Agent& agent, std::vector<Communicator::Bytes>& messages) {
  const auto [first, last] = strips_.stripsWithin(reach_.copies, agent.pose.position);
  for (int other = first; other <= last; ++other) {
    if (other == rank()) continue;
    const auto to = static_cast<std::size_t>(other);
    ByteWriter write(messages[to]);
    transferAgent(write, agent);
    shared_[to].sent.push_back(agent.id);
  }
}

std::vector<DistributedCrowd::Traveller> DistributedCrowd::exchangeCopies(const std::vector<Traveller>& newcomers) {
  std::vector<Communicator::Bytes> out(rankCount());
  std::vector<Communicator::Bytes> in;
  for (const std::uint32_t i : kept_) writeCopies(agents_[i], out);
  for (const Traveller& newcomer : newcomers) writeCopies(newcomer.agent, out);
  communicator_.exchangeAnySize(out, in);
  std::vector<Traveller> copies;
  for (std::size_t from = 0; from < in.size(); ++from) {
    ByteReader read(in[from]);
    while (!read.isAtEnd()) {
      Traveller& copy = copies.emplace_back();
      transferAgent(read, copy.agent);
      copy.agent.perceives = false;
      shared_[from].received.push_back(copy.agent.id);
      const bool is_near = strips_.distanceTo(rank(), copy.agent.pose.position) <= reach_.touching;
      shared_[from].is_near.push_back(is_near ? 1 : 0);
    }
  }
  return copies;
}

void DistributedCrowd::append(Agent&& agent, const Track& track) {
  next_agents_.push_back(std::move(agent));
  next_tracks_.push_back(track);
}

void DistributedCrowd::adopt(std::vector<Traveller> newcomers) {
  std::sort(newcomers.begin(), newcomers.end(),
            [](const Traveller& a, const Traveller& b) { return a.agent.id < b.agent.id; });
  next_agents_.clear();
  next_tracks_.clear();
  auto newcomer = newcomers.begin();
  for (const std::uint32_t i : kept_) {
    for (; newcomer != newcomers.end() && newcomer->agent.id < agents_[i].id; ++newcomer) {
      append(std::move(newcomer->agent), newcomer->track);
    }
    append(std::move(agents_[i]), tracks_[i]);
  }
  for (; newcomer != newcomers.end(); ++newcomer) append(std::move(newcomer->agent), newcomer->track);
  episode_.edit().replaceCrowd(next_agents_, next_tracks_);
  next_agents_.swap(agents_);
  next_tracks_.swap(tracks_);
  border_.set(std::move(shared_), world());
}

void DistributedCrowd::noteShares(std::size_t own) {
  const RankSpread shares = spreadOf(communicator_, static_cast<double>(own));
  if (shares.mean == 0.0) return;
  imbalance_sum_ += shares.imbalance();
  ++divisions_;
}

}  // namespace crowd
