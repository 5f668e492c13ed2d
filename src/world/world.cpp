#include "world/world.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>

#include "common/text/numbers.h"
#include "geometry/impact.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

[[noreturn]] void refuse(const AgentAction& given) {
  const RelativeAction& action = given.action;
  throw InputError("agent " + std::to_string(given.agent) +
                   ": expected a finite rotation and a fraction of the maximum speed from 0 to 1, got rotation " +
                   toText(action.rotation) + " and share " + toText(action.speed_fraction));
}

/// All solid bodies move.
constexpr auto EVERY_BODY = [](std::size_t /*body*/) { return true; };

inline void requireValid(const AgentAction& given) {
  if (!given.action.isValid()) refuse(given);
}

}  // namespace

World::World(const Scene& scene, StopRequest stop)
    : stop_(std::move(stop)),
      tick_duration_(scene.tick_duration),
      goal_tolerance_(scene.goal_tolerance),
      collision_radius_(scene.collision_radius),
      contact_(scene.contact),
      obstacles_(scene.obstacles),
      robots_(scene) {
  walls_.replaceAll(scene.walls);
  std::vector<Agent> agents;
  agents.reserve(scene.agents.size());
  for (const AgentStart& start : scene.agents) {
    agents.emplace_back(static_cast<AgentId>(agents.size()), start);
    has_groups_ = has_groups_ || start.group != NO_GROUP;
  }
  lasting_count_ = entered_count_ = active_count_ = agents.size();
  agents_.replace(std::move(agents));
  refresh();
}

void World::refresh() {
  obstacle_motions_.clear();
  moving_obstacles_.clear();
  for (const Obstacle& obstacle : obstacles_) {
    if (obstacle.path.moves()) moving_obstacles_.push_back({obstacle_motions_.size(), ABSENT});
    obstacle_motions_.push_back(obstacle.path.at(time()));
  }
  rebuildGrid();
}

Agent& World::walkingAgent(AgentId id) {
  if (!isActive(id)) throw InputError("there is no agent " + std::to_string(id) + " on its way");
  return agents_[id];
}

bool World::isActive(AgentId id) const {
  const Agent* const agent = agents_.find(id);
  return agent != nullptr && agent->isWalking();
}

std::string World::blockerAt(const Vector2& centre, double radius, bool agents_only, std::optional<AgentId> except,
                             std::optional<RobotId> except_robot) const {
  const double overlap = contact_ == Contact::SOLID ? TOUCH_TOLERANCE : CONTACT_OVERLAP;
  std::vector<std::uint32_t> found;
  grid_.findNear(centre, radius - overlap, found);
  for (const std::uint32_t body : found) {
    if (body < agents_.size() && agents_.idAt(body) == except) continue;
    if (body < agents_.size()) return "agent " + std::to_string(agents_.idAt(body));
    if (!agents_only) return nameOf(obstacles_[body - agents_.size()], body - agents_.size());
  }
  std::string robot = robots_.blockerAt(centre, radius - overlap, except_robot);
  if (!robot.empty() || agents_only) return robot;
  return walls_.index().isAnyWithin(centre, radius - overlap) ? "a wall" : "";
}

void World::rebuildGrid() {
  grid_.clear();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Agent& agent = agents_.nth(i);
    if (agent.isPresent()) {
      grid_.add(agent.pose.position, agent.radius, static_cast<std::uint32_t>(i), agent.velocity);
    }
  }
  std::size_t rank = 0;
  auto mover = moving_obstacles_.begin();
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    const bool is_present = isPresent(obstacles_[i]);
    if (obstacles_[i].path.moves()) (mover++)->rank = is_present ? rank : ABSENT;
    if (!is_present) continue;
    ++rank;
    const auto body = static_cast<std::uint32_t>(agents_.size() + i);
    grid_.add(obstacle_motions_[i].position, obstacles_[i].radius, body, obstacle_motions_[i].velocity);
  }
  grid_.build(CELL_SIZE);
}

bool World::moveObstacles() {
  bool have_changed = false;
  for (const MovingObstacle& mover : moving_obstacles_) {
    const Obstacle& obstacle = obstacles_[mover.number];
    obstacle_motions_[mover.number] = obstacle.path.at(time());
    have_changed = have_changed || isPresent(obstacle) == (mover.rank == ABSENT);
  }
  return have_changed;
}

inline void World::updateGrid() {
  std::size_t number = 0;
  for (const Agent& agent : agents_) {
    if (agent.isPresent()) grid_.move(number++, agent.pose.position, agent.velocity);
  }
  for (const MovingObstacle& mover : moving_obstacles_) {
    if (mover.rank == ABSENT) continue;
    const ObstaclePath::Motion& motion = obstacle_motions_[mover.number];
    grid_.move(number + mover.rank, motion.position, motion.velocity);
  }
  grid_.update();
}

std::vector<Neighbour> World::recordedPeople() const {
  std::vector<Neighbour> people;
  for (const MovingObstacle& mover : moving_obstacles_) {
    const Obstacle& obstacle = obstacles_[mover.number];
    const ObstaclePath::Motion& motion = obstacle_motions_[mover.number];
    if (!obstacle.person || mover.rank == ABSENT) continue;
    people.push_back({motion.position, motion.velocity, obstacle.radius, NeighbourKind::OBSTACLE});
  }
  return people;
}

std::vector<PersonMotion> World::recordedMotions() const {
  std::vector<PersonMotion> motions;
  if (robots_.empty()) return motions;
  const double end = static_cast<double>(tick_ + 1) * tick_duration_;
  for (const MovingObstacle& mover : moving_obstacles_) {
    const Obstacle& obstacle = obstacles_[mover.number];
    if (!obstacle.person || mover.rank == ABSENT) continue;
    PersonMotion& motion = motions.emplace_back();
    motion.id = idOfRecorded(mover.number);
    motion.radius = obstacle.radius;
    motion.start = obstacle_motions_[mover.number].position;
    motion.way = obstacle.path.position(end) - motion.start;
    motion.disc = static_cast<std::uint32_t>(mover.rank);
  }
  if (motions.empty()) return motions;
  const auto is_there = [](const Agent& agent) { return agent.isPresent(); };
  const auto agents = static_cast<std::uint32_t>(std::count_if(agents_.begin(), agents_.end(), is_there));
  for (PersonMotion& motion : motions) motion.disc += agents;
  return motions;
}

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
  if (contact_ == Contact::SOLID) computeSolidMotions(EVERY_BODY);
}

void World::endStep(ThreadPool& thread_pool) {
  if (contact_ == Contact::SOLID) {
    carryOutSolidMotions(EVERY_BODY);
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
    const auto is_it = [position](std::size_t body) { return body == position; };
    computeSolidMotions(is_it);
    carryOutSolidMotions(is_it);
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
    const auto is_obstacle = [this](std::size_t body) { return body >= agents_.size(); };
    computeSolidMotions(is_obstacle);
    carryOutSolidMotions(is_obstacle);
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
  const bool are_others = moveObstacles();
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

template <typename Moves>
void World::computeSolidMotions(const Moves& moves) {
  discs_.clear();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Agent& agent = agents_.nth(i);
    if (!agent.isPresent()) continue;
    const Vector2 way = moves(i) ? Vector2(tick_duration_ * agent.velocity) : Vector2::Zero();
    discs_.push_back({agent.pose.position, way, agent.radius, true});
  }
  const double end = static_cast<double>(tick_ + 1) * tick_duration_;
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    if (!isPresent(obstacles_[i])) continue;
    const Vector2 way = moves(agents_.size() + i)
                            ? Vector2(obstacles_[i].path.position(end) - obstacle_motions_[i].position)
                            : Vector2::Zero();
    discs_.push_back({obstacle_motions_[i].position, way, obstacles_[i].radius, false});
  }
  robots_.addDiscs(discs_);
  solid_motion_.move(discs_, walls_.index());
}

template <typename Moves>
void World::carryOutSolidMotions(const Moves& moves) {
  const std::vector<SolidMotion::Outcome>& outcomes = solid_motion_.outcomes();
  auto outcome = outcomes.begin();
  robots_.noteSolidContacts(agents_.values(), discs_, solid_motion_);
  const bool do_obstacles_move = moves(agents_.size());
  if (do_obstacles_move) robots_.noteRecordedContacts(recordedMotions(), solid_motion_);
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    Agent& agent = agents_.nth(i);
    if (!agent.isPresent()) continue;
    if (outcome->diverted) {
      const Vector2 velocity = (outcome->position - agent.pose.position) / tick_duration_;
      if (moves(i)) {
        agent.blocked = !agent.velocity.isZero(0.0);
        agent.blocked_moves += agent.blocked ? 1 : 0;
        agent.velocity = velocity;
      } else {
        agent.velocity += velocity;  // pushed after its own move
      }
    }
    agent.pose.position = outcome->position;
    agent.bumped = agent.bumped || outcome->touched;
    ++outcome;
  }
  robots_.replaceMotions(solid_motion_.sweeps());
}

}  // namespace crowd
