// The separation rule in random worlds: agents that follow it have none of the contacts that docs/separation_rule.md
// excludes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "avoidance/braking_rule.h"
#include "avoidance/separation_rule.h"
#include "geometry/closest_points.h"
#include "support/moves.h"
#include "support/robots.h"
#include "support/seeds.h"
#include "support/worlds.h"

namespace crowd::separation_property_test {
namespace {

constexpr double LOOKOUT = 1.5;  // [s]
constexpr int TICKS = 250;       // of each world
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t WORLDS = 200;  // sanitizers look for other faults, and are slow
#else
constexpr std::uint64_t WORLDS = 4000;
#endif

const std::vector<MotionLimits> LIMITS = {
    MotionLimits(), {2.0, 3.0, INFINITE}, MotionLimits(), {1.0, 6.0, INFINITE}, {2.0, 3.0, toRadians(90.0)}};

/// Two to six agents, sometimes forty, among walls, obstacles at rest and, in some worlds, a moving one and a robot.
Scene randomScene(std::uint64_t seed, KeyedRandom& random) {
  const std::uint32_t agents = seed % 100 == 0 ? 40 : 2 + random.below(5);
  Scene scene = scenes::solidCrowd(seed, agents, 2.5, seed % 3 == 0 ? 1 : 0);
  scene.contact = Contact::GHOST;  // nothing but the rule keeps bodies apart
  scene.tick_duration = random.uniform(0.05, 0.25);
  if (seed % 3 == 1) scene.obstacles.clear();  // agents among agents are decided in another way
  if (seed % 4 != 0) return scene;
  RobotStart robot = robots::robot(scenes::randomPoint(random, 2.5), random.uniform(-PI, PI));
  robot.limits = {random.uniform(0.2, 2.0), random.uniform(0.2, 2.0), random.uniform(0.2, 4.0), 3.0, 0.8};
  const bool is_free = std::all_of(scene.agents.begin(), scene.agents.end(), [&](const AgentStart& agent) {
    return (agent.position - robot.position).norm() > agent.radius + robot.footprint.radius + 0.1;
  });
  if (is_free) scene.robots.push_back(robot);
  return scene;
}

/// The least distance of two bodies during a tick, from rim to rim [m]. Both move straight.
double clearanceOf(const Segment& first, const Segment& second, double radii) {
  const ClosestPoints points = closestPoints(first, second);
  return (points.of_second - points.of_first).norm() - radii;
}

/// Positions of all agents, and all robots, at the start of a tick.
struct Start {
  explicit Start(const World& world) : robots(world.robots().list()) {
    for (const Agent& agent : world.agents()) places.push_back(agent.pose.position);
  }
  std::vector<Vector2> places;
  std::vector<Robot> robots;
};

/// The least distance of an agent from a robot after a tick [m]; infinite if the rule promises none, because the robot,
/// at its velocity, would have closed the whole gap.
double clearanceOfRobot(const Vector2& was, const Agent& agent, const Robot& before, const Robot& after, double tick) {
  const Vector2 between = before.pose.position - was;
  const double gap = between.norm() - agent.radius - before.perceived_radius;
  if (gap < 0.0 || gap + tick * between.normalized().dot(before.velocity) < 0.0) return INFINITE;
  return (after.pose.position - agent.pose.position).norm() - agent.radius - after.start.footprint.radius;
}

/// The least clearance during a tick of any agent from another, a wall, an obstacle at rest or a robot [m].
double clearanceIn(const World& world, const Start& start) {
  double least = INFINITE;
  for (const Agent& agent : world.agents()) {
    const Segment way{start.places[agent.id], agent.pose.position};
    const auto meet = [&](const Segment& own, const Segment& other, double radii) {
      least = std::min(least, clearanceOf(own, other, radii));
    };
    for (AgentId id = 0; id < agent.id; ++id) {
      const Agent& other = world.agents()[id];
      const Segment relative{start.places[id] - way.from, other.pose.position - way.to};
      meet({Vector2::Zero(), Vector2::Zero()}, relative, agent.radius + other.radius);
    }
    for (const Obstacle& obstacle : world.obstacles()) {
      if (obstacle.path.moves()) continue;
      const Vector2 centre = obstacle.path.position(0.0);
      meet(way, {centre, centre}, agent.radius + obstacle.radius);
    }
    for (const Segment& wall : world.walls().list()) meet(way, wall, agent.radius);
    for (RobotId id = 0; id < world.robots().size(); ++id) {
      least = std::min(least,
                       clearanceOfRobot(way.from, agent, start.robots[id], world.robots()[id], world.tickDuration()));
    }
  }
  return least;
}

/// Half of the wishes lead to a common place, where the crowd is dense; the others are random.
CandidateMove randomWish(KeyedRandom& random, const Agent& agent, const Vector2& meeting_place) {
  const double bearing = bearingOf(meeting_place - agent.pose.position) - agent.pose.heading;
  const double wanted = random.below(4) == 0 ? random.uniform() : 1.0;
  return {unitVector(random.below(2) == 0 ? bearing : random.uniform(-PI, PI)), wanted, wanted};
}

/// Now and then, changes what groups, queues and gates change of an agent: its pace and whether it is held.
void disturb(World& world, KeyedRandom& random) {
  if (random.below(10) > 0) return;
  Agent& agent = world.walkingAgent(random.below(static_cast<std::uint32_t>(world.agents().size())));
  agent.setPace(Pace::GROUP, random.uniform(0.3, 1.3));
  agent.setHeld(Hold::ROUTE, random.below(4) == 0);
}

/// One tick; a twentieth of the agents does not answer.
void step(World& world, const SeparationRule& rule, const Vector2& meeting_place, KeyedRandom& random,
          Perceptions& seen) {
  disturb(world, random);
  if (!world.robots().empty() && random.below(10) == 0) {
    const Vector2 velocity = scenes::randomPoint(random, 2.0);
    world.robots().command(0, {velocity, random.uniform(-2.0, 2.0)});
  }
  perceive(world, {6.0, 0}, seen);
  std::vector<AgentAction> actions;
  for (std::size_t i = 0; i < seen.agents.size(); ++i) {
    const Perception perception(seen, i);
    const AgentId id = seen.agents[i].agent;
    std::vector<MoveBlock> moves = toBlocks({randomWish(random, world.agents()[id], meeting_place)});
    BrakingLimits limits;
    rule.cut({&perception, 1}, moves.data(), 1, &limits);
    const CandidateMove move = moveAt(moves.data(), 0);
    const RelativeAction action =
        world.motion().areOn() ? BrakingRule(perception, limits).actionTowards(move) : toAction(move);
    if (random.below(20) > 0) actions.push_back({id, action});
  }
  world.step(actions);
}

/// Where the least clearance was seen.
struct Worst {
  double clearance = INFINITE;  // [m]
  std::uint64_t seed = 0;
  int tick = 0;
  std::uint64_t agent_ticks = 0;
};

void walk(GapSharing sharing, std::uint64_t seed, KeyedRandom& random, Worst& worst) {
  World world(randomScene(seed, random));
  world.setMotion(LIMITS[seed % LIMITS.size()]);
  const SeparationRule rule(sharing, LOOKOUT);
  Perceptions seen;
  Vector2 meeting_place = Vector2::Zero();
  for (int tick = 0; tick < TICKS; ++tick) {
    if (tick % 50 == 0) meeting_place = scenes::randomPoint(random, 2.0);
    const Start start(world);
    step(world, rule, meeting_place, random, seen);
    const double clearance = clearanceIn(world, start);
    if (clearance < worst.clearance) worst = {clearance, seed, tick, worst.agent_ticks};
    worst.agent_ticks += world.agents().size();
  }
}

TEST(SeparationProperty, NobodyTouchesAnythingInAMillionRandomTicks) {
  Worst worst;
  forSeeds(WORLDS, KeyedRandom::EXPLORATION, [&](std::uint64_t seed, KeyedRandom& random) {
    walk(seed % 2 == 0 ? GapSharing::HALF : GapSharing::MOVING, seed, random, worst);
    ASSERT_GE(worst.clearance, -TOUCH_TOLERANCE) << "tick " << worst.tick;
  });
  RecordProperty("worst_clearance_nm", std::to_string(1e9 * worst.clearance));
  RecordProperty("agent_ticks", std::to_string(worst.agent_ticks));
  std::printf("worst clearance %.3g m (seed %llu, tick %d) in %llu ticks, %llu agent ticks\n", worst.clearance,
              static_cast<unsigned long long>(worst.seed), worst.tick, static_cast<unsigned long long>(WORLDS * TICKS),
              static_cast<unsigned long long>(worst.agent_ticks));
  EXPECT_LT(worst.clearance, 1e-6);  // some did meet
}

TEST(SeparationProperty, TheSameWorldsHaveContactsWithoutTheRule) {
  Worst worst;
  forSeeds(5, KeyedRandom::EXPLORATION,
           [&](std::uint64_t seed, KeyedRandom& random) { walk(GapSharing::NONE, seed, random, worst); });
  EXPECT_LT(worst.clearance, -0.05);
}

}  // namespace
}  // namespace crowd::separation_property_test
