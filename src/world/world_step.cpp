// The step of a world.

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>

#include "common/text/numbers.h"
#include "geometry/impact.h"
#include "social_crowd/errors.h"
#include "world/world.h"

namespace crowd {
namespace {

[[noreturn]] void refuse(const AgentAction& given) {
  const RelativeAction& action = given.action;
  throw InputError("agent " + std::to_string(given.agent) +
                   ": expected a finite rotation and a fraction of the maximum speed from 0 to 1, got rotation " +
                   toText(action.rotation) + " and share " + toText(action.speed_fraction));
}

inline void requireValid(const AgentAction& given) {
  if (!given.action.isValid()) refuse(given);
}

}  // namespace

void World::step(const std::vector<AgentAction>& actions, ThreadPool& thread_pool) {
  beginStep(actions, thread_pool);
  stop_.throwIfMade();
  endStep(thread_pool);
}

void World::beginStep(const std::vector<AgentAction>& actions, ThreadPool& thread_pool) {
  for (const AgentAction& given : actions) requireValid(given);
  assigned_actions_.resize(agents_.size(), nullptr);
  for (const AgentAction& given : actions) {
    const std::size_t position = agents_.positionOf(given.agent);
    if (position < assigned_actions_.size() && assigned_actions_[position] == nullptr)
      assigned_actions_[position] = &given.action;
  }
  thread_pool.run(
      assigned_actions_.size(),
      [&](unsigned /*worker*/, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          beginMove(agents_.nth(i), std::exchange(assigned_actions_[i], nullptr));
        }
      },
      ThreadPool::FEW_SHORT_ITEMS);
  robots_.beginMoves(agents_.values(), robots_.empty() ? std::vector<Neighbour>() : recordedPeople());
  if (contact_ == Contact::SOLID) computeSolidMotions(BodyRange::all());
}

void World::endStep(ThreadPool& thread_pool) {
  if (contact_ == Contact::SOLID) {
    carryOutSolidMotions(BodyRange::all());
  } else {
    robots_.noteGhostContacts({agents_.values().data(), agents_.size()}, tick_duration_);
    robots_.noteGhostContacts(recordedMotions());
  }
  finishTick(thread_pool);
}

void World::moveAgent(AgentId id, const std::vector<AgentAction>& actions) {
  const RelativeAction* action = nullptr;
  for (const AgentAction& given : actions) {
    requireValid(given);
    if (given.agent == id && action == nullptr) action = &given.action;
  }
  if (!isActive(id)) return;
  const std::size_t position = agents_.positionOf(id);
  had_turn_.resize(agents_.size());
  had_turn_[position] = true;
  Agent& agent = agents_.nth(position);
  beginMove(agent, action);
  robots_.hold();
  if (contact_ == Contact::GHOST) robots_.noteGhostContacts({&agent, 1}, tick_duration_);
  if ((agent.acted || agent.velocity != Vector2::Zero()) && contact_ == Contact::SOLID) {
    const BodyRange it{position, position + 1};
    computeSolidMotions(it);
    carryOutSolidMotions(it);
  }
  std::size_t number = 0;
  for (std::size_t i = 0; i < position; ++i) number += agents_.nth(i).isPresent() ? 1 : 0;
  grid_.move(number, agent.pose.position, agent.velocity);  // also if it stays, because its velocity changes
  grid_.update();
}

void World::endTick(ThreadPool& thread_pool) {
  had_turn_.resize(agents_.size());
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if (!had_turn_[i]) beginMove(agents_.nth(i), nullptr);
  }
  had_turn_.assign(agents_.size(), false);
  robots_.beginMoves(agents_.values(), robots_.empty() ? std::vector<Neighbour>() : recordedPeople());
  if (contact_ == Contact::SOLID) {
    const BodyRange obstacles{agents_.size()};
    computeSolidMotions(obstacles);
    carryOutSolidMotions(obstacles);
  } else {
    robots_.noteGhostContacts({agents_.values().data(), agents_.size()}, 0.0);
    robots_.noteGhostContacts(recordedMotions());
  }
  finishTick(thread_pool);
}

void World::finishTick(ThreadPool& thread_pool) {
  robots_.endMoves();
  const bool are_fewer = dropDeparted();
  ++tick_;
  const bool are_others = obstacles_.moveTo(time());
  are_fewer || are_others ? rebuildGrid() : updateGrid();
  stop_.throwIfMade();
  // Agents that leave at the end of this tick are still present: the grid contains them during the measurements.
  std::atomic<std::size_t> arrived{0};
  thread_pool.run(
      agents_.size(),
      [&](unsigned /*worker*/, std::size_t begin, std::size_t end) {
        std::size_t arrivals = 0;
        for (std::size_t i = begin; i < end; ++i) endMove(i, arrivals);
        if (arrivals > 0) arrived += arrivals;
      },
      ThreadPool::FEW_SHORT_ITEMS);
  if (arrived == 0) return;
  active_count_ -= arrived;
  rebuildGrid();
}

bool World::dropDeparted() {
  const auto is_due = [this](const Agent& agent) { return !agent.isPresent() && agent.arrival_tick < tick_; };
  if (std::none_of(agents_.begin() + static_cast<std::ptrdiff_t>(lasting_count_), agents_.end(), is_due)) return false;
  agents_.eraseIf([&](AgentId id, const Agent& agent) {
    if (id < lasting_count_ || !is_due(agent)) return false;
    departed_.add(agent);
    return true;
  });
  return true;
}

inline void World::beginMove(Agent& agent, const RelativeAction* action) const {
  agent.acted = action != nullptr && agent.isWalking() && !agent.isHeld() && !agent.yielding;
  agent.blocked = false;
  if (!agent.acted) return hold(agent, action);
  if (action->rotation != 0.0) agent.setHeading(agent.pose.heading + action->rotation);
  agent.velocity = action->speed_fraction * agent.max_speed * agent.ahead;
  if (contact_ == Contact::GHOST) agent.pose.position += tick_duration_ * agent.velocity;
}

/// Brakes, straight on, by at least what the motion limits permit; its action may be to brake harder.
inline void World::hold(Agent& agent, const RelativeAction* action) const {
  if (action == nullptr || !agent.isWalking()) {
    agent.velocity = Vector2::Zero();
    return;
  }
  agent.velocity = motion_.braked(agent.velocity, tick_duration_);
  const double speed = agent.velocity.norm();
  const double chosen_speed = action->speed_fraction * agent.max_speed;
  if (chosen_speed < speed) agent.velocity *= chosen_speed / speed;
  if (contact_ == Contact::GHOST) agent.pose.position += tick_duration_ * agent.velocity;
}

/// The maximum speed follows the paces; an agent that is to walk slower brakes first.
inline void World::followPace(Agent& agent) const {
  if (agent.max_speed == agent.wanted_speed) return;
  agent.max_speed = std::max(agent.wanted_speed, motion_.braked(agent.velocity, tick_duration_).norm());
}

inline void World::endMove(std::size_t position, std::size_t& arrivals) {
  Agent& agent = agents_.nth(position);
  if (!agent.isWalking()) {
    agent.in_contact = false;
    agent.in_collision = false;
    return;
  }
  followPace(agent);
  agent.in_collision = isAnythingWithin(collision_radius_, position);
  const double contact_distance = agent.radius - CONTACT_OVERLAP;
  // Without anything within the collision radius, a search within a smaller distance is unnecessary.
  const bool may_touch = agent.in_collision || contact_distance > collision_radius_;
  agent.in_contact = agent.bumped || (may_touch && isAnythingWithin(contact_distance, position));
  agent.bumped = false;
  agent.collided = agent.collided || agent.in_collision;
  agent.touched = agent.touched || agent.in_contact;
  if ((agent.goal() - agent.pose.position).norm() > goal_tolerance_) return;
  if (agent.next_goal + 1 < agent.goals.size()) return agent.passGoal();
  if (!agent.leaves) {
    agent.at_goal = true;
    return;
  }
  ++agent.next_goal;
  agent.end(agent.statusAtEnd(), tick_);
  ++arrivals;
}

inline bool World::isAnythingWithin(double distance, std::size_t position) const {
  const Vector2& place = agents_.nth(position).pose.position;
  return grid_.isAnyNear(place, distance, static_cast<std::uint32_t>(position)) ||
         walls_.index().isAnyWithin(place, distance) || robots_.isAnyWithin(distance, place);
}

}  // namespace crowd
