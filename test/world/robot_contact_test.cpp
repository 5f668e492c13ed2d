// Contacts of robots with agents, walls and obstacles, and their causes.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/robots.h"
#include "support/worlds.h"
#include "world/world_editor.h"

namespace crowd::robots::robot_contact_test {
namespace {

constexpr double NEAR = 1e-6;

/// The world after a tick in which the robot drives straight ahead, if it does, and the agents walk.
World afterTick(const Scene& scene, bool drives, const std::vector<AgentAction>& actions = {}) {
  World world(scene);
  if (drives) world.robots().command(0, {{1.0, 0.0}, 0.0});
  world.step(actions);
  return world;
}

/// An agent of 0.25 m and 1 m/s in front of a robot at the origin, with a gap in between [m]; it faces the robot.
Scene facing(double gap) {
  AgentStart agent = wanderer({0.55 + gap, 0.0}, 1.0);
  agent.heading = -PI;
  return with({robot({0.0, 0.0})}, scene({agent}));
}

/// A recorded person of 0.25 m who walks from one place at 0 s to another one at 2 s.
Obstacle recorded(const Vector2& from, const Vector2& to) {
  const auto track = std::make_shared<const Track>(std::vector<double>{0.0, 2.0}, std::vector<Vector2>{from, to});
  return {ObstaclePath::recorded(track), 0.25, 12};
}

/// The cause of the only contact of the first robot, which begins now and is with the obstacle of this number.
ContactCause causeWithRecorded(const World& world, std::size_t obstacle = 0) {
  const std::vector<RobotContact>& contacts = world.robots()[0].contacts;
  EXPECT_EQ(contacts.size(), 1U);
  if (contacts.empty()) return ContactCause::MUTUAL;
  EXPECT_EQ(contacts[0].agent, idOfRecorded(obstacle));
  EXPECT_TRUE(contacts[0].begins);
  return contacts[0].cause;
}

void expectContact(const World& world, ContactCause cause) {
  ASSERT_EQ(world.robots()[0].contacts.size(), 1U);
  EXPECT_EQ(world.robots()[0].contacts[0].agent, 0U);
  EXPECT_EQ(world.robots()[0].contacts[0].cause, cause);
  EXPECT_TRUE(world.robots()[0].contacts[0].begins);
}

TEST(RobotContact, WallsStopARobot) {
  World world = afterTick(solid(with({robot({0.0, 0.0})}, scene({}, {}, {{{0.35, -1.0}, {0.35, 1.0}}}))), true);
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 0.05, NEAR);
  EXPECT_TRUE(world.robots()[0].blocked);
  EXPECT_EQ(world.robots()[0].twist.linear, Vector2(0.0, 0.0));
  EXPECT_EQ(world.robots()[0].velocity, Vector2(0.0, 0.0));
  world.step({});  // it presses on, and is stopped at the start of the tick
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 0.05, NEAR);
  EXPECT_TRUE(world.robots()[0].blocked);
  world.robots().command(0, {});
  world.step({});
  EXPECT_FALSE(world.robots()[0].blocked);
}

TEST(RobotContact, ADiscGoesOnToTurnAtAWall) {
  // It stops after 0.05 s of the tick of 0.1 s, and turns by 0.5 rad/s for all of it.
  const Scene at_wall = solid(with({robot({0.0, 0.0})}, scene({}, {}, {{{0.35, -1.0}, {0.35, 1.0}}})));
  World world(at_wall);
  world.robots().command(0, {{1.0, 0.0}, 0.5});
  world.step({});
  EXPECT_TRUE(world.robots()[0].blocked);
  EXPECT_NEAR(world.robots()[0].pose.heading, 0.05, NEAR);
  EXPECT_EQ(world.robots()[0].twist.rotation, 0.5);
  EXPECT_NEAR(world.robots()[0].velocity.x(), 0.0, 1e-9);
  EXPECT_NEAR(world.robots()[0].velocity.y(), std::sin(0.025), 1e-4);  // it was turned by 0.025 at the impact

  RobotStart car = robot({0.0, 0.0});
  car.drive = Drive::ACKERMANN;  // it turns on curves only
  World other(solid(with({car}, scene({}, {}, {{{0.35, -1.0}, {0.35, 1.0}}}))));
  other.robots().command(0, {{1.0, 0.0}, 0.5});
  other.step({});
  EXPECT_TRUE(other.robots()[0].blocked);
  EXPECT_LT(other.robots()[0].pose.heading, 0.03);
  EXPECT_NEAR(other.robots()[0].twist.rotation, 0.5 * std::sin(0.025), 1e-4);  // in proportion to the speed
}

TEST(RobotContact, ARobotSlidesAlongAWall) {
  // It drives at 60 degrees to the wall, whose line is 0.02 m in front of its rim, at 1 m/s: it meets it after
  // 0.02 / sin(60) m, and slides at cos(60) m/s from then on.
  const Vector2 ahead = unitVector(PI / 3.0);
  const Scene at_wall = solid(with({robot({0.0, 0.0}, PI / 3.0)}, scene({}, {}, {{{-5.0, 0.32}, {5.0, 0.32}}})));
  World world = afterTick(at_wall, true);
  const double met = 0.02 / ahead.y();
  EXPECT_NEAR(world.robots()[0].pose.position.y(), 0.02, NEAR);
  EXPECT_NEAR(world.robots()[0].pose.position.x(), met * 0.5 + (0.1 - met) * 0.5, NEAR);
  EXPECT_NEAR(world.robots()[0].velocity.x(), 0.5, NEAR);
  EXPECT_NEAR(world.robots()[0].velocity.y(), 0.0, NEAR);
  EXPECT_NEAR(world.robots()[0].twist.linear.x(), 0.25, NEAR);
  EXPECT_NEAR(world.robots()[0].twist.linear.y(), -0.5 * ahead.y(), NEAR);
  EXPECT_TRUE(world.robots()[0].blocked);

  // With the protective stop it stops.
  Scene stopping = at_wall;
  stopping.robots[0].yields = Yields::BOTH;
  EXPECT_NEAR(afterTick(stopping, true).robots()[0].pose.position.x(), met * 0.5, NEAR);
}

TEST(RobotContact, ARobotThatSlidesNeverEntersAWallAndGetsOutOfACorner) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    RobotStart start = robot({0.0, 0.0}, random.uniform(-PI, PI));
    start.drive = static_cast<Drive>(random.below(3));
    start.limits = {random.uniform(0.3, 2.0), random.uniform(0.3, 2.0), 1e3, 1e3, 0.5};
    if (seed % 2 == 0) start.footprint.corners = {{0.5, -0.3}, {0.5, 0.3}, {-0.2, 0.3}, {-0.2, -0.3}};
    std::vector<Segment> walls = {
        {{-1.0, -1.0}, {1.0, -1.0}}, {{1.0, -1.0}, {1.2, 1.0}}, {{1.2, 1.0}, {-1.0, 0.9}}, {{-1.0, 0.9}, {-1.0, -1.0}}};
    walls.push_back({{0.7, 0.1}, {1.1, 0.0}});  // with an end in the room
    World world(solid(with({start}, scene({}, {}, walls))));
    for (int tick = 0; tick < 200; ++tick) {
      if (tick % 20 == 0) {
        const double speed = random.uniform(-2.0, 2.0);
        world.robots().command(0, {{speed, random.uniform(-1.0, 1.0)}, random.uniform(-2.0, 2.0)});
      }
      world.step({});
      const Robot& moved = world.robots()[0];
      for (const Segment& wall : walls) {
        ASSERT_FALSE(isCutBy(moved.start.footprint, moved.pose, wall, 1e-9)) << "tick " << tick;
      }
    }
  }
}

TEST(RobotContact, WithAPersonWhoHasArrivedAndStays) {
  for (const Contact contact : {Contact::GHOST, Contact::SOLID}) {
    Scene scene = facing(0.05);
    scene.contact = contact;
    scene.agents[0].goals = {scene.agents[0].position};
    scene.agents[0].stays = true;
    World world(scene);
    world.step({});
    ASSERT_EQ(world.agents()[0].status, AgentStatus::STAYING);
    EXPECT_TRUE(world.robots()[0].contacts.empty());
    world.robots().command(0, {{1.0, 0.0}, 0.0});
    world.step({});
    expectContact(world, ContactCause::ROBOT);
    EXPECT_EQ(world.agents()[0].pose.position, scene.agents[0].position);
  }
}

TEST(RobotContact, ARobotThatDrivesIntoAPersonStops) {
  World world = afterTick(solid(facing(0.05)), true);
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 0.05, NEAR);
  expectVector(world.agents()[0].pose.position, 0.6, 0.0);
  EXPECT_TRUE(world.agents()[0].in_contact);
  expectContact(world, ContactCause::ROBOT);
  world.step({});  // it presses on: the same contact
  ASSERT_EQ(world.robots()[0].contacts.size(), 1U);
  EXPECT_FALSE(world.robots()[0].contacts[0].begins);
  EXPECT_EQ(world.robots()[0].contacts[0].cause, ContactCause::ROBOT);
  world.robots().command(0, {{-1.0, 0.0}, 0.0});
  world.step({});
  EXPECT_TRUE(world.robots()[0].contacts.empty());
  EXPECT_NEAR(world.robots()[0].pose.position.x(), -0.05, NEAR);
}

TEST(RobotContact, APersonThatWalksIntoARobotStops) {
  const World world = afterTick(solid(facing(0.05)), false, {ahead(0)});
  EXPECT_NEAR(world.agents()[0].pose.position.x(), 0.55, NEAR);
  EXPECT_TRUE(world.agents()[0].blocked);
  expectContact(world, ContactCause::PERSON);
}

TEST(RobotContact, IsMutualIfBothMoveIn) {
  for (const Contact contact : {Contact::SOLID, Contact::GHOST}) {
    for (const double gap : {0.05, 0.15}) {  // each of them alone, or none of them alone, would reach the other
      Scene both = facing(gap);
      both.contact = contact;
      expectContact(afterTick(both, true, {ahead(0)}), ContactCause::MUTUAL);
    }
  }
}

TEST(RobotContact, HasACauseInAGhostWorld) {
  expectContact(afterTick(facing(0.05), true), ContactCause::ROBOT);
  expectContact(afterTick(facing(0.05), false, {ahead(0)}), ContactCause::PERSON);
  EXPECT_TRUE(afterTick(facing(0.0995), true).robots()[0].contacts.empty());  // an overlap of 0.5 mm only
}

TEST(RobotContact, PassingThroughIsOneContact) {
  // Contact below 0.549 m: from tick 5, which ends at -0.5 m, to tick 16, which begins at 0.5 m.
  World world(with({robot({-1.0, 0.0})}, scene({wanderer({0.0, 0.0})})));
  world.robots().command(0, {{1.0, 0.0}, 0.0});
  for (int tick = 1; tick <= 20; ++tick) {
    world.step({});
    const auto& contacts = world.robots()[0].contacts;
    ASSERT_EQ(contacts.size(), tick >= 5 && tick <= 16 ? 1U : 0U) << "tick " << tick;
    if (!contacts.empty()) {
      EXPECT_EQ(contacts[0].begins, tick == 5) << "tick " << tick;
    }
  }
}

TEST(RobotContact, InSequentialTicksToo) {
  for (const Contact contact : {Contact::SOLID, Contact::GHOST}) {
    Scene scene = facing(0.05);
    scene.contact = contact;
    World person(scene);
    person.moveAgent(0, {ahead(0)});
    person.endTick();
    expectContact(person, ContactCause::PERSON);
    World robot(scene);
    robot.robots().command(0, {{1.0, 0.0}, 0.0});
    robot.moveAgent(0, {});
    robot.endTick();
    expectContact(robot, ContactCause::ROBOT);
  }
}

TEST(RobotContact, ARobotElsewhereIsNotStopped) {
  Scene scene = solid(facing(0.05));
  scene.robots[0].drive = Drive::EXTERNAL;
  World world(scene);
  world.robots().place(0, {{0.1, 0.0}, 0.0}, {1.0, 0.0}, false);
  world.step({});
  EXPECT_EQ(world.robots()[0].pose.position, Vector2(0.1, 0.0));
  expectVector(world.agents()[0].pose.position, 0.6, 0.0);
  expectContact(world, ContactCause::ROBOT);
  World jumping(scene);
  jumping.robots().place(0, {{0.6, 0.1}, 0.0}, {0.0, 0.0}, true);
  jumping.step({});
  expectContact(jumping, ContactCause::ROBOT);
  // An agent does not walk into it.
  World walking(scene);
  walking.step({ahead(0)});
  EXPECT_NEAR(walking.agents()[0].pose.position.x(), 0.55, NEAR);
  expectContact(walking, ContactCause::PERSON);
}

TEST(RobotContact, AMovingObstacleStopsARobotAndPassesOverIt) {
  World world(solid(with({robot({0.0, 0.0})}, scene({}, {scenes::moving_obstacle({0.6, 0.0}, {-0.5, 0.0}, 0.25)}))));
  world.robots().command(0, {{1.0, 0.0}, 0.0});
  for (int tick = 0; tick < 5; ++tick) world.step({});
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 0.1 * 0.05 / 0.15, NEAR);  // they met 0.05 m closer, at 1.5 m/s
}

TEST(RobotContact, WithARecordedPersonWhoWalksThroughTheRobot) {
  // At 1 - t m from 0 to 2 s: the bodies overlap by more than 1 mm from 0.451 s, in tick 5, to 1.549 s, in tick 16.
  // Between an agent far away and a pillar, so that its number is not that of its disc.
  Scene made = with({robot({0.0, 0.0})}, scene({wanderer({0.0, 9.0})},
                                               {scenes::pillar({0.0, -9.0}, 0.5), recorded({1.0, 0.0}, {-1.0, 0.0})}));
  for (const Contact contact : {Contact::GHOST, Contact::SOLID}) {
    for (const Drive drive : {Drive::DIFFERENTIAL, Drive::EXTERNAL}) {
      made.contact = contact;
      made.robots[0].drive = drive;
      World world(made);
      World sequential(made);
      for (int tick = 1; tick <= 25; ++tick) {
        SCOPED_TRACE("tick " + std::to_string(tick));
        world.step({});
        sequential.moveAgent(0, {});
        sequential.endTick();
        for (const World* const one : {&world, &sequential}) {
          const auto& contacts = one->robots()[0].contacts;
          ASSERT_EQ(contacts.size(), tick >= 5 && tick <= 16 ? 1U : 0U);
          if (contacts.empty()) continue;
          EXPECT_EQ(contacts[0].agent, idOfRecorded(1));
          EXPECT_EQ(contacts[0].cause, ContactCause::PERSON);
          EXPECT_EQ(contacts[0].begins, tick == 5);
        }
      }
      EXPECT_EQ(world.robots()[0].pose.position, Vector2(0.0, 0.0));
    }
  }
}

TEST(RobotContact, WithRecordedPeopleHasACause) {
  for (const Contact contact : {Contact::GHOST, Contact::SOLID}) {
    // The robot drives 0.1 m; the person stands 0.05 m in front of it, or comes as fast.
    Scene made = with({robot({0.0, 0.0})}, scene({}, {recorded({0.6, 0.0}, {0.6, 0.0})}));
    made.contact = contact;
    const World drives = afterTick(made, true);
    EXPECT_EQ(causeWithRecorded(drives), ContactCause::ROBOT);
    EXPECT_NEAR(drives.robots()[0].pose.position.x(), contact == Contact::SOLID ? 0.05 : 0.1, NEAR);
    made.obstacles = {recorded({0.6, 0.0}, {-1.4, 0.0})};
    EXPECT_EQ(causeWithRecorded(afterTick(made, true)), ContactCause::MUTUAL);
    EXPECT_EQ(causeWithRecorded(afterTick(made, false)), ContactCause::PERSON);
    made.obstacles = {recorded({0.6, 0.0}, {2.6, 0.0})};
    EXPECT_TRUE(afterTick(made, true).robots()[0].contacts.empty());
    // It jumps onto the person.
    made.robots[0].drive = Drive::EXTERNAL;
    World jumping(made);
    jumping.robots().place(0, {{0.6, 0.1}, 0.0}, {0.0, 0.0}, true);
    jumping.step({});
    EXPECT_EQ(causeWithRecorded(jumping), ContactCause::ROBOT);
  }
}

TEST(RobotContact, WithARecordedPersonWhoPassesOverARobotAtAWall) {
  // The wall stops the robot at (0.05, 0) after half of the tick. Then the person, who comes at 2 m/s, is 0.6 m away;
  // at the end 0.5 m.
  World world(solid(
      with({robot({0.0, 0.0})}, scene({}, {recorded({0.05, 0.7}, {0.05, -3.3})}, {{{0.35, -1.0}, {0.35, 1.0}}}))));
  world.robots().command(0, {{1.0, 0.0}, 0.0});
  world.step({});
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 0.05, NEAR);
  EXPECT_EQ(causeWithRecorded(world), ContactCause::PERSON);
}

TEST(RobotContact, RobotsStopEachOther) {
  World world(solid(with({robot({0.0, 0.0}), robot({0.7, 0.0})}, scene({}))));
  world.robots().command(0, {{1.0, 0.0}, 0.0});
  world.step({});
  world.step({});
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 0.1, NEAR);
  EXPECT_EQ(world.robots()[1].pose.position, Vector2(0.7, 0.0));
  world.robots().command(1, {{1.0, 0.0}, 0.0});  // one drives ahead of the other
  world.step({});
  world.step({});
  EXPECT_NEAR(world.robots()[1].pose.position.x(), 0.9, NEAR);
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 0.3, NEAR);
}

TEST(RobotContact, RobotsOccupyPlaces) {
  World world(with({robot({0.0, 0.0})}, scene({wanderer({5.0, 0.0})})));
  EXPECT_FALSE(world.blockerAt({0.5, 0.0}, 0.25).empty());
  EXPECT_TRUE(world.blockerAt({0.56, 0.0}, 0.25).empty());
  const auto spawned = [&] { WorldEditor(world).spawnAgent(wanderer({0.4, 0.0})); };
  EXPECT_EQ(errorOf<InputError>(spawned), "the place is taken by robot 'robot'");
  EXPECT_EQ(errorOf<InputError>([&] {
              WorldEditor(world).addWall({{0.2, -1.0}, {0.2, 1.0}});
            }),
            "the place is taken by robot 'robot'");
  EXPECT_EQ(errorOf<InputError>([&] {
              WorldEditor(world).spawnObstacle({0.4, 0.0}, {0.0, 0.0}, 0.2);
            }),
            "the place is taken by robot 'robot'");
}

TEST(RobotContact, CollisionRadiusIncludesRobots) {
  const World far = afterTick(facing(0.26), false);  // the rim is 0.51 m from the agent's centre
  EXPECT_FALSE(far.agents()[0].in_collision);
  const World near = afterTick(facing(0.24), false);
  EXPECT_TRUE(near.agents()[0].in_collision);
  EXPECT_FALSE(near.agents()[0].in_contact);
}

TEST(RobotPerception, ShowsTheDiscThatTheRobotMayReach) {
  RobotStart start = robot({0.0, 0.0}, PI / 2.0);
  start.limits = {1.0, 1.0, 1.0, 2.0, 0.0};
  World world(with({start}, scene({wanderer({-2.0, 0.0}), wanderer({-3.0, 0.0})})));
  world.robots().command(0, {{1.0, 0.0}, 0.0});
  world.step({});
  const Perceptions seen = lookAround(world);
  ASSERT_EQ(seen.agents[0].neighbour_count, 2U);
  const Perception first(seen, 0);
  EXPECT_EQ(first.neighbours[0].kind, NeighbourKind::AGENT);  // its rim is 0.75 m away, that of the robot 1.7 m
  EXPECT_EQ(first.neighbours[1].kind, NeighbourKind::ROBOT);
  EXPECT_NEAR(first.neighbours[1].radius, 0.315, 1e-12);  // 0.015 m for acceleration and rotation
  expectVector(first.neighbours[1].position, 2.0, 0.01);
  expectVector(first.neighbours[1].velocity, 0.0, 0.1);
  const Perceptions nearest = perceive(world, {6.0, 1});
  EXPECT_EQ(nearest.agents[0].neighbour_count, 1U);
  EXPECT_EQ(Perception(nearest, 0).neighbours[0].kind, NeighbourKind::AGENT);
  const Perceptions short_sighted = perceive(world, {1.6, 0});
  EXPECT_EQ(short_sighted.agents[0].neighbour_count, 1U);
}

TEST(RobotPerception, DependsOnWhoYields) {
  RobotStart start = robot({0.0, 0.0});
  start.yields = Yields::ROBOT;
  EXPECT_EQ(perceive(with({start}, scene({wanderer({2.0, 0.0})}))).neighbours[0].kind, NeighbourKind::UNYIELDED_ROBOT);
  start.yields = Yields::BOTH;
  EXPECT_EQ(perceive(with({start}, scene({wanderer({2.0, 0.0})}))).neighbours[0].kind, NeighbourKind::ROBOT);
  start.perceived = false;
  EXPECT_EQ(perceive(with({start}, scene({wanderer({2.0, 0.0})}))).agents[0].neighbour_count, 0U);
}

}  // namespace
}  // namespace crowd::robots::robot_contact_test
