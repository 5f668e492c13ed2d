#include "navigation/group_walking.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"

namespace crowd {
namespace {

constexpr double BODY_GAP = 0.3;        // least gap between mates side by side [m]
constexpr double ROW_DISTANCE = 1.0;    // between rows [m]
constexpr double AREA_RADIUS = 3.0;     // of the disc ahead in which the density is measured [m]
constexpr double BENT_DENSITY = 0.25;   // at which a V is bent fully [1/m2]
constexpr double FULL_BEND = 0.6;       // its angle [rad]
constexpr double ALONE_DENSITY = 0.6;   // from which each walks its own way at its own speed [1/m2]
constexpr double ONCOMING_SPEED = 0.3;  // [m/s]
constexpr double CATCH_UP = 0.6;        // speed gained for each metre behind its place [1/s]
constexpr double LEAST_PACE = 0.2;      // of the speed of the group, of those who wait where others can pass
constexpr double MOST_PACE = 1.15;      // of the agent's own speed
constexpr double WIDE_CLEARANCE = 0.9;  // of places that are not narrow [m]
constexpr double FARTHEST_GOAL = 6.0;   // of a member from that of another one [m]
constexpr double LONGEST_SHIFT = 1.0;   // [m]

/// The speed that an agent would have without its mates [m/s].
double speedAlone(const Agent& agent) { return agent.wanted_speed / agent.paceOf(Pace::GROUP); }

Vector2 leftOf(const Vector2& forward) { return {-forward.y(), forward.x()}; }

}  // namespace

void GroupWalking::update(World& world, const Paths& paths, const FloorRuler* floor) {
  if (!world.hasGroups()) return;
  collect(world);
  const auto ticks = static_cast<std::uint64_t>(std::max(1.0, std::round(DECISION_TIME / world.tickDuration())));
  for (auto& [number, group] : groups_) {
    if (group.decision_tick && world.tick() < *group.decision_tick) continue;
    world.stopRequest().throwIfMade();
    // After the first decision groups decide at different ticks, so that all ticks cost about the same.
    const std::uint64_t pause = group.decision_tick ? ticks : 1 + number % ticks;
    group.decision_tick = world.tick() + pause;
    decide(group, world, paths, floor);
  }
}

/// Finds the members of all groups that are on their way.
void GroupWalking::collect(const World& world) {
  for (auto& [number, group] : groups_) group.members.clear();
  for (const Agent& agent : world.agents()) {
    const bool walks = agent.group != NO_GROUP && agent.isWalking() && !agent.at_goal;
    if (walks) groups_[agent.group].members.push_back(agent.id);
  }
  for (auto group = groups_.begin(); group != groups_.end();) {
    group = group->second.members.empty() ? groups_.erase(group) : std::next(group);
  }
  if (!groups_.empty() || !members_.empty()) members_.follow(world.agents());
}

void GroupWalking::decide(const Group& group, World& world, const Paths& paths, const FloorRuler* floor) {
  Vector2 forward = Vector2::Zero();
  std::vector<Walker> walkers = walkersOf(group, world, paths, forward);
  const Traffic traffic = trafficAhead(walkers, forward, world);
  if (walkers.size() < 2 || forward == Vector2::Zero() || traffic.density > ALONE_DENSITY || haveParted(walkers)) {
    for (const Walker& walker : walkers) {
      world.walkingAgent(walker.agent->id).setPace(Pace::GROUP, 1.0);
      members_[walker.agent->id] = Member();
    }
    return;
  }
  double radius = 0.0;
  for (const Walker& walker : walkers) radius = std::max(radius, walker.agent->radius);
  const double spacing = std::max(SPACING, 2.0 * radius + BODY_GAP);
  const std::size_t columns = columnsFor(walkers, spacing, forward, traffic, floor);
  arrange(walkers, columns, spacing, FULL_BEND * std::min(1.0, traffic.density / BENT_DENSITY));
  assign(walkers, world, floor);
}

/// The number of goals that an agent has not reached.
std::size_t goalsLeft(const Agent& agent) { return agent.goals.size() - agent.next_goal; }

/// The members, with their positions relative to the mean: along the way by the remaining length of their ways to the
/// next goal of the group, so that they are compared round corners, too.
/// @param forward is set to the direction of the group, zero if it has none
std::vector<GroupWalking::Walker> GroupWalking::walkersOf(const Group& group, const World& world, const Paths& paths,
                                                          Vector2& forward) {
  std::size_t goals_left = 0;
  for (const AgentId id : group.members) goals_left = std::max(goals_left, goalsLeft(world.agents()[id]));
  std::vector<Walker> walkers;
  Vector2 centre = Vector2::Zero();
  double remaining = 0.0;
  for (const AgentId id : group.members) {
    Walker& walker = walkers.emplace_back();
    walker.agent = &world.agents()[id];
    const Agent& agent = *walker.agent;
    const Vector2& place = agent.pose.position;
    const RemainingPath* const path = paths.find(id);
    const RemainingPath straight = {agent.goal()};
    const bool has_path = path != nullptr && !path->empty() && path->back() == agent.goal();
    const RemainingPath& way = has_path ? *path : straight;
    if (agent.goals.size() >= goals_left) walker.goal = agent.goals[agent.goals.size() - goals_left];
    const bool has_passed = walker.goal && goalsLeft(agent) < goals_left;
    const double length = has_passed ? -(*walker.goal - place).norm() : lengthOf({way.data(), way.size()}, place);
    walker.ahead = -length;
    const Vector2 offset = pointAlong({way.data(), way.size()}, place, LOOKAHEAD) - place;
    if (offset != Vector2::Zero()) forward += offset.normalized();
    centre += place;
    remaining += length;
  }
  const auto count = static_cast<double>(walkers.size());
  if (forward.norm() > 1e-9) forward.normalize();
  for (Walker& walker : walkers) {
    walker.ahead += remaining / count;
    walker.left = (walker.agent->pose.position - centre / count).dot(leftOf(forward));
  }
  return walkers;
}

/// Whether members walk to different places, so that their ways cannot be compared.
bool GroupWalking::haveParted(const std::vector<Walker>& walkers) {
  return std::any_of(walkers.begin(), walkers.end(), [&](const Walker& walker) {
    return !walker.goal || !walkers[0].goal || (*walker.goal - *walkers[0].goal).norm() > FARTHEST_GOAL;
  });
}

/// Agents in a disc ahead of the group.
GroupWalking::Traffic GroupWalking::trafficAhead(const std::vector<Walker>& walkers, const Vector2& forward,
                                                 const World& world) {
  Vector2 centre = AREA_RADIUS * forward;
  for (const Walker& walker : walkers) centre += walker.agent->pose.position / static_cast<double>(walkers.size());
  std::vector<std::uint32_t> bodies;
  world.grid().findNear(centre, AREA_RADIUS, bodies);
  Traffic traffic;
  std::size_t others = 0;
  for (const std::uint32_t body : bodies) {
    if (body >= world.agents().size()) continue;  // an obstacle
    const Agent& other = world.agents().nth(body);
    if (other.group == walkers[0].agent->group) continue;
    ++others;
    traffic.is_oncoming = traffic.is_oncoming || other.velocity.dot(forward) < -ONCOMING_SPEED;
  }
  traffic.density = static_cast<double>(others) / (PI * AREA_RADIUS * AREA_RADIUS);
  return traffic;
}

/// How many walk abreast. Those who come towards the group get one half of the floor.
std::size_t GroupWalking::columnsFor(const std::vector<Walker>& walkers, double spacing, const Vector2& forward,
                                     const Traffic& traffic, const FloorRuler* floor) {
  std::size_t columns = std::min(walkers.size(), MOST_ABREAST);
  if (walkers.size() > MOST_ABREAST) columns = MOST_ABREAST - 1;
  if (floor == nullptr) return columns;
  const double most = 2.0 * static_cast<double>(columns) * spacing;
  for (const Walker& walker : walkers) {
    const double radius = walker.agent->radius;
    const Vector2 place = walker.agent->pose.position + forward;
    double width = floor->widthAt(place, forward, radius, most).total();
    if (traffic.is_oncoming) width = std::max(0.0, 0.5 * width - radius);
    columns = std::min(columns, 1 + static_cast<std::size_t>(width / spacing));
  }
  return columns;
}

/// Gives each walker a place: rows from front to back in the order in which they are, and in each row from right to
/// left in the order in which they are, so that nobody crosses the way of a mate.
void GroupWalking::arrange(std::vector<Walker>& walkers, std::size_t columns, double spacing, double bend) {
  std::stable_sort(walkers.begin(), walkers.end(), [](const auto& a, const auto& b) { return a.ahead > b.ahead; });
  Vector2 mean = Vector2::Zero();
  for (std::size_t first = 0, row = 0; first < walkers.size(); first += columns, ++row) {
    const auto begin = walkers.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = walkers.begin() + static_cast<std::ptrdiff_t>(std::min(walkers.size(), first + columns));
    std::stable_sort(begin, end, [](const auto& a, const auto& b) { return a.left < b.left; });
    const double middle = 0.5 * static_cast<double>(end - begin - 1);
    for (auto walker = begin; walker != end; ++walker) {
      const double column = static_cast<double>(walker - begin) - middle;
      walker->place = {spacing * portable::sin(bend) * std::abs(column) - ROW_DISTANCE * static_cast<double>(row),
                       spacing * portable::cos(bend) * column};
      mean += walker->place / static_cast<double>(walkers.size());
    }
  }
  for (Walker& walker : walkers) walker.place -= mean;
}

/// Sets paces and shifts.
void GroupWalking::assign(const std::vector<Walker>& walkers, World& world, const FloorRuler* floor) {
  double speed = speedAlone(*walkers[0].agent);
  for (const Walker& walker : walkers) speed = std::min(speed, speedAlone(*walker.agent));
  speed = std::max(0.5 * speed, speed - SIZE_SLOWDOWN * static_cast<double>(walkers.size() - 1));
  for (const Walker& walker : walkers) {
    const bool is_wide = floor == nullptr || floor->hasClearance(walker.agent->pose.position, WIDE_CLEARANCE);
    const double least = (is_wide ? LEAST_PACE : 1.0) * speed;
    const double own_speed = speedAlone(*walker.agent);
    const double wanted = speed + CATCH_UP * (walker.place.x() - walker.ahead);
    world.walkingAgent(walker.agent->id).setPace(Pace::GROUP, std::min(MOST_PACE, std::max(least, wanted) / own_speed));
    Member& member = members_[walker.agent->id];
    member.shift = std::clamp(walker.place.y() - walker.left, -LONGEST_SHIFT, LONGEST_SHIFT);
    member.aim.reset();
  }
}

std::optional<Vector2> GroupWalking::aimOf(const Agent& agent, const Vector2& next) {
  if (agent.group == NO_GROUP) return std::nullopt;
  Member* const member = members_.find(agent.id);
  if (member == nullptr || member->shift == 0.0) return std::nullopt;
  if (member->aim && member->next == next) return member->aim;
  const Vector2 offset = next - agent.pose.position;
  const double distance = offset.norm();
  if (distance < 0.5 * LOOKAHEAD) return std::nullopt;
  const double reach = std::min(distance, LOOKAHEAD);
  const Vector2 forward = offset / distance;
  member->next = next;
  member->aim = agent.pose.position + reach * forward + reach / LOOKAHEAD * member->shift * leftOf(forward);
  return member->aim;
}

}  // namespace crowd
