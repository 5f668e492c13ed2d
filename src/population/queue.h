#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/random.h"
#include "scenario/population_spec.h"
#include "world/world.h"

namespace crowd {

/// @brief A line of agents that wait to be served, one at a time, at its head.
///
/// An agent that joins walks to the end of the line. It is in line when it is within the spacing of that place; the
/// nearest agent is first. The line moves up when the first agent has been served or an agent has left it. Places that
/// walls separate from the head are not used; agents for which there is no place wait near the last one.
class Queue {
 public:
  /// @param queue must outlive it @param random of this queue
  Queue(const QueueDescription& queue, const KeyedRandom& random) : queue_(&queue), random_(random) {}

  /// @brief An agent begins to walk to the line.
  void join(AgentId agent) { coming_.push_back(agent); }
  /// @brief Removes an agent that is in line or on the way to it; does nothing for other agents.
  void leave(AgentId agent);
  /// @brief Serves the first agent, adds agents that have come near to the line, and sets the goals of all. Call it
  /// after each tick. @return the agents whose service has ended, which have left the line
  std::vector<AgentId> update(World& world);

  /// @brief Whether an agent stands: it has reached its place in line, or the line has no place for it and it is near
  /// other agents that wait for one.
  bool stands(AgentId id, const World& world) const;
  /// @brief The place where an agent that joins now walks to [m].
  Vector2 end() const;
  /// @brief Where an agent looks; null if it is not at the head, or looks ahead.
  const FacingDescription* facingOf(AgentId id) const {
    return queue_->face && !line_.empty() && line_.front() == id ? &*queue_->face : nullptr;
  }
  /// @brief The agents in line, the first one is at the head.
  const std::vector<AgentId>& line() const { return line_; }

 private:
  static constexpr std::size_t MAX_PLACES = 10000;

  void measure(const World& world);
  void admit(const World& world);
  void serve(const World& world, std::vector<AgentId>& served);

  const QueueDescription* queue_;
  KeyedRandom random_;
  std::vector<AgentId> line_;
  std::vector<AgentId> coming_;        // in the order of joining
  std::optional<double> service_end_;  // of the first agent [s]
  std::uint64_t layout_ = 0;           // of the world that `places_` belongs to
  std::size_t places_ = MAX_PLACES;    // that walls do not separate from the head
};

}  // namespace crowd
