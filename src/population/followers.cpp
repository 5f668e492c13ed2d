#include "population/followers.h"

#include <algorithm>
#include <array>
#include <utility>

namespace crowd {
namespace {

constexpr double GOAL_GAP = 0.25;  // between the bodies of a leader and of followers at their goals [m]
// Of followers around the goal of their leader, from the direction in which it comes: first beside it [pi].
constexpr std::array<double, 7> PLACES = {0.5, -0.5, 0.75, -0.75, 1.0, 0.25, -0.25};
constexpr int RINGS = 3;
constexpr double ROBOT_GAP = 0.8;       // between a robot and those who follow it [m]
constexpr double ROBOT_DISTANCE = 0.3;  // by which the place behind it has moved before they get a new goal [m]

}  // namespace

Vector2 Followers::goalBeside(const Vector2& goal, const Vector2& from, std::size_t number, double radius,
                              const World& world) const {
  const double bearing = goal == from ? 0.0 : bearingOf(goal - from);
  const double step = 2.0 * radius + GOAL_GAP;
  for (int ring = 1; ring <= RINGS; ++ring) {
    for (const double angle : PLACES) {
      Vector2 place = goal + ring * step * unitVector(bearing + angle * PI);
      const bool fits = places_.fits(place, radius, world) && world.walls().index().isClear(goal, place, 0.0);
      if (fits && number-- == 0) return place;
    }
  }
  return goal;
}

std::vector<Vector2> Followers::goalsBeside(const std::vector<Vector2>& goals, Vector2 from, std::size_t number,
                                            double radius, const World& world) const {
  std::vector<Vector2> places;
  places.reserve(goals.size());
  for (const Vector2& goal : goals) {
    places.push_back(goalBeside(goal, from, number, radius, world));
    from = goal;
  }
  return places;
}

Vector2 Followers::goalBehind(RobotId robot, std::size_t number, double radius, const World& world) const {
  const Robot& leader = world.robots().require(robot);
  const Vector2 ahead = unitVector(leader.pose.heading);
  const Vector2 place = leader.pose.position - (leader.start.footprint.reach() + radius + ROBOT_GAP) * ahead;
  return goalBeside(place, place - ahead, number, radius, world);
}

std::vector<Followers::Follower>::const_iterator Followers::lowerBound(AgentId id) const {
  const auto before = [](const Follower& follower, AgentId sought) { return follower.id < sought; };
  return std::lower_bound(followers_.begin(), followers_.end(), id, before);
}

void Followers::add(AgentId id, const Leader& leader, bool is_endless, const World& world, RouteObserver& observer) {
  Follower follower;
  follower.id = id;
  follower.leader = leader;
  follower.number = counts_[groupOf(leader)]++;
  if (leader.kind == Leader::Kind::AGENT) follower.leader_goals = world.agents()[leader.number].goals;
  followers_.insert(lowerBound(id), std::move(follower));
  observer.setEndless(id, is_endless);
}

void Followers::update(World& world, RouteObserver& observer) {
  const auto is_done = [&](Follower& follower) {
    if (!world.isActive(follower.id)) return true;
    if (hasLeft(follower.leader, world)) {
      release(follower, world, observer);
      return true;
    }
    const bool is_agent = follower.leader.kind == Leader::Kind::AGENT;
    is_agent ? followAgent(follower, world, observer) : followRobot(follower, world, observer);
    return false;
  };
  followers_.erase(std::remove_if(followers_.begin(), followers_.end(), is_done), followers_.end());
}

bool Followers::hasLeft(const Leader& leader, const World& world) {
  if (leader.kind == Leader::Kind::AGENT) return !world.isActive(leader.number);
  return world.robots().require(leader.number).hasArrived();
}

/// It leaves the world at its last goal.
void Followers::release(const Follower& follower, World& world, RouteObserver& observer) {
  world.walkingAgent(follower.id).leaves = true;
  observer.setEndless(follower.id, false);
}

/// A follower has all goals at once, so that it need not wait for its leader at each of them, until those of the leader
/// change, as on a route and at an attraction: from then on it gets one after the other.
void Followers::followAgent(Follower& follower, World& world, RouteObserver& observer) const {
  const Agent& leader = world.agents()[follower.leader.number];
  Agent& agent = world.walkingAgent(follower.id);
  const bool is_single = follower.single_goal || leader.goals != follower.leader_goals;
  const bool is_last = !is_single || leader.next_goal + 1 >= leader.goals.size();
  const bool visits = leader.isHeldBy(Hold::ATTRACTION);
  agent.leaves = leader.leaves && is_last && !visits;
  if (!is_single || visits || follower.single_goal == leader.goal()) return;
  follower.single_goal = leader.goal();
  agent.setGoals(goalsBeside({leader.goal()}, leader.pose.position, follower.number, agent.radius, world));
  observer.extendWay(agent);
}

void Followers::followRobot(Follower& follower, World& world, RouteObserver& observer) const {
  const Pose& pose = world.robots().require(follower.leader.number).pose;
  const std::optional<Pose>& last = follower.robot_pose;
  if (last && last->position == pose.position && last->heading == pose.heading) return;
  follower.robot_pose = pose;
  const Agent& agent = world.agents()[follower.id];
  const Vector2 goal = goalBehind(follower.leader.number, follower.number, agent.radius, world);
  if ((goal - agent.goal()).norm() < ROBOT_DISTANCE) return;
  world.walkingAgent(follower.id).setGoal(goal);
  observer.recordGoal(world.agents()[follower.id], goal);
}

std::optional<Leader> Followers::leaderOf(AgentId id) const {
  const auto found = lowerBound(id);
  return found == followers_.end() || found->id != id ? std::nullopt : std::optional<Leader>(found->leader);
}

bool Followers::leads(AgentId id, const World& world) const {
  return std::any_of(followers_.begin(), followers_.end(), [&](const Follower& follower) {
    return follower.leader.kind == Leader::Kind::AGENT && follower.leader.number == id && world.isActive(follower.id);
  });
}

void Followers::drop(AgentId id, World& world, RouteObserver& observer) {
  const auto found = lowerBound(id);
  if (found == followers_.end() || found->id != id) return;
  release(*found, world, observer);
  followers_.erase(found);
}

}  // namespace crowd
