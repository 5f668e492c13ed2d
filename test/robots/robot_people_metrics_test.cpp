// Metrics of people near the robot, worked out by hand from the formulas of docs/metrics.md.

#include <gtest/gtest.h>

#include <cmath>

#include "robots/metrics/conflicts.h"
#include "robots/metrics/interaction_force.h"
#include "support/robot_logs.h"

namespace crowd::robots::robot_people_metrics_test {
namespace {

/// A robot that stands at the origin for a tick of 1 s, with people who stand.
RobotResult amongStanding(const std::vector<Vector2>& places) {
  std::vector<LoggedPerson> people;
  for (const Vector2& place : places) people.push_back(personAt(static_cast<AgentId>(people.size()), place));
  return scoreOf(headerTo({9.0, 0.0}), std::vector<RobotLogTick>{tickAt(0, Pose(), people), tickAt(1, Pose(), people)});
}

TEST(RobotPeopleMetrics, TimeToCollision) {
  // Head-on at 1 m/s each: after the tick 4.8 m apart, less 0.3 m and 0.25 m, at 2 m/s.
  const auto meet = [](double beside) {
    return scoreOf(headerTo({9.0, 0.0}, 0.1),
                   std::vector<RobotLogTick>{tickAt(0, {{0.0, 0.0}, 0.0}, {personAt(4, {5.0, beside})}),
                                             tickAt(1, {{0.1, 0.0}, 0.0}, {personAt(4, {4.9, beside})})});
  };
  EXPECT_NEAR(meet(0.0).minimum_time_to_collision, (4.8 - 0.55) / 2.0, 1e-9);
  // Beside each other by 0.44 m: they touch when they are sqrt(0.55^2 - 0.44^2) = 0.33 m apart along x.
  EXPECT_NEAR(meet(0.44).minimum_time_to_collision, (4.8 - 0.33) / 2.0, 1e-9);
  EXPECT_TRUE(std::isnan(meet(0.56).minimum_time_to_collision));
}

TEST(RobotPeopleMetrics, SpacesAndDistances) {
  // From the rim to the centre: 0.4 m, 1 m and 3 m.
  const RobotResult result = amongStanding({{0.7, 0.0}, {-1.3, 0.0}, {0.0, 3.3}});
  EXPECT_NEAR(result.minimum_distance_to_people, 0.4, 1e-12);
  EXPECT_NEAR(result.maximum_distance_to_people, 3.0, 1e-12);
  EXPECT_EQ(result.intimate_space_intrusions, 100.0);
  EXPECT_EQ(result.space_compliance, 0.0);
  EXPECT_EQ(amongStanding({{0.85, 0.0}}).space_compliance, 1.0);
  EXPECT_EQ(amongStanding({{0.85, 0.0}}).personal_space_intrusions, 100.0);
  EXPECT_EQ(amongStanding({{0.0, 3.3}}).social_space_intrusions, 100.0);
  EXPECT_EQ(amongStanding({{0.0, 3.91}}).social_space_intrusions, 0.0);
  EXPECT_EQ(amongStanding({}).space_compliance, 1.0);
  EXPECT_TRUE(std::isnan(amongStanding({}).maximum_distance_to_people));
}

TEST(RobotPeopleMetrics, SpeedsOfPeople) {
  const RobotResult result =
      scoreOf(headerTo({9.0, 0.0}),
              std::vector<RobotLogTick>{tickAt(0, Pose(), {personAt(0, {2.0, 0.0}), personAt(1, {0.0, 5.0})}),
                                        tickAt(1, Pose(), {personAt(0, {2.0, 1.0}), personAt(1, {0.0, 5.0})}),
                                        tickAt(2, Pose(), {personAt(0, {2.0, 1.0}), personAt(1, {0.0, 3.0})})});
  EXPECT_NEAR(result.avg_pedestrian_velocity, (1.0 + 0.0 + 0.0 + 2.0) / 4.0, 1e-12);
  EXPECT_NEAR(result.avg_closest_pedestrian_velocity, (1.0 + 0.0) / 2.0, 1e-12);
}

TEST(RobotPeopleMetrics, ResolvedConflicts) {
  // Head-on at 1 m/s each, 4 m apart, radii of 0.5 m together: they would overlap by 0.5 m.
  const Vector2 offset(4.0, 0.0);
  const auto resolved = [&](const Vector2& robot, const Vector2& person) {
    return resolvedConflict(offset, {{1.0, 0.0}, robot}, {{-1.0, 0.0}, person}, 0.5);
  };
  // One of them turns aside by 0.1 m/s: they pass at 4 * 0.1 / sqrt(4.01) = 0.199750 m.
  EXPECT_NEAR(resolved({1.0, 0.1}, {-1.0, 0.0}).by_robot, 0.199750, 1e-6);
  EXPECT_EQ(resolved({1.0, 0.1}, {-1.0, 0.0}).by_people, 0.0);
  EXPECT_NEAR(resolved({1.0, 0.0}, {-1.0, 0.1}).by_people, 0.199750, 1e-6);
  EXPECT_EQ(resolved({1.0, 0.0}, {-1.0, 0.1}).by_robot, 0.0);
  // Both to their right: 4 * 0.2 / sqrt(4.04) = 0.398015 m, half each.
  EXPECT_NEAR(resolved({1.0, -0.1}, {-1.0, 0.1}).by_robot, 0.199007, 1e-6);
  EXPECT_NEAR(resolved({1.0, -0.1}, {-1.0, 0.1}).by_people, 0.199007, 1e-6);
  // Both to the same side: nothing is resolved. A conflict that begins, or is later than 5 s, does not count.
  EXPECT_EQ(resolved({1.0, 0.1}, {-1.0, 0.1}).by_robot, 0.0);
  EXPECT_EQ(resolvedConflict(offset, {{0.0, 1.0}, {1.0, 0.0}}, {{-1.0, 0.0}, {-1.0, 0.0}}, 0.5).by_robot, 0.0);
  EXPECT_EQ(resolvedConflict({11.0, 0.0}, {{1.0, 0.0}, {1.0, 1.0}}, {{-1.0, 0.0}, {-1.0, 0.0}}, 0.5).by_robot, 0.0);
  const Vector2 unknown(NAN, NAN);
  EXPECT_EQ(resolvedConflict(offset, {unknown, {1.0, 1.0}}, {{-1.0, 0.0}, {-1.0, 0.0}}, 0.5).by_robot, 0.0);
}

TEST(RobotPeopleMetrics, Responsibility) {
  // They meet head-on at 1 m/s each; in the third tick of 0.1 s each steps aside as far as given [m].
  const auto meet = [](double robot, double person) {
    return scoreOf(headerTo({9.0, 0.0}, 0.1),
                   std::vector<RobotLogTick>{tickAt(0, {{0.0, 0.0}, 0.0}, {personAt(4, {5.0, 0.0})}),
                                             tickAt(1, {{0.1, 0.0}, 0.0}, {personAt(4, {4.9, 0.0})}),
                                             tickAt(2, {{0.2, 0.0}, 0.0}, {personAt(4, {4.8, 0.0})}),
                                             tickAt(3, {{0.3, robot}, 0.0}, {personAt(4, {4.7, person})})})
        .responsibility;
  };
  EXPECT_NEAR(meet(0.0, 0.02), 0.0, 1e-12);
  EXPECT_NEAR(meet(-0.02, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(meet(-0.02, 0.02), 0.5, 1e-12);
  EXPECT_TRUE(std::isnan(meet(0.0, 0.0)));
}

TEST(RobotPeopleMetrics, ResponsibilityLeavesOutWhoseVelocityIsNotKnown) {
  // The robot drives at 1 m/s; somebody appears 2 m ahead, and walks aside from the next tick on.
  const std::vector<RobotLogTick> ticks = {tickAt(0, {{0.0, 0.0}, 0.0}, {}), tickAt(1, {{0.1, 0.0}, 0.0}, {}),
                                           tickAt(2, {{0.2, 0.0}, 0.0}, {personAt(4, {2.0, 0.0})}),
                                           tickAt(3, {{0.3, 0.0}, 0.0}, {personAt(4, {2.0, 0.1})})};
  EXPECT_TRUE(std::isnan(scoreOf(headerTo({9.0, 0.0}, 0.1), ticks).responsibility));
}

TEST(RobotPeopleMetrics, ResponsibilityLeavesOutWhoIsInContact) {
  // Somebody walks into a robot that stands, which stops them.
  std::vector<RobotLogTick> ticks;
  for (std::uint32_t tick = 0; tick < 5; ++tick) {
    const double x = std::max(0.55, 0.8 - 0.1 * tick);
    ticks.push_back(tickAt(tick, {{0.0, 0.0}, 0.0}, {personAt(4, {x, 0.0})}));
    ticks.back().robots[0].contacts.emplace();
    if (tick >= 3) ticks.back().robots[0].contacts->push_back({4, ContactCause::PERSON, tick == 3});
  }
  EXPECT_TRUE(std::isnan(scoreOf(headerTo({9.0, 0.0}, 0.1), ticks).responsibility));
}

TEST(RobotPeopleMetrics, SocialForces) {
  // At rest 2 m apart: D = e, B = 0.35, theta = 0, so that f = 2.1 exp(-2 / 0.35) = 0.0069269 away from the other.
  const Vector2 force = interactionForce({{0.0, 0.0}, {0.0, 0.0}}, {{2.0, 0.0}, {0.0, 0.0}});
  EXPECT_NEAR(force.x(), -0.0069269, 1e-7);
  EXPECT_NEAR(force.y(), 0.0, 1e-12);
  // A body that walks at 1 m/s past another one, 2 m to its left: D = (2, 1), B = 0.35 sqrt(5) = 0.78262,
  // theta = pi / 2 - atan(1 / 2) = 1.10715, exp(-2 / B) = 0.077653; slowing: 0.077653 exp(-(3 B theta)^2) = 9.0279e-5,
  // turning: 0.077653 exp(-(2 B theta)^2) = 3.8539e-3, to the right of D.
  const Vector2 aside = interactionForce({{0.0, 0.0}, {1.0, 0.0}}, {{0.0, 2.0}, {0.0, 0.0}});
  EXPECT_NEAR(aside.x(), 2.1 * (3.8539e-3 - 2.0 * 9.0279e-5) / std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(aside.y(), -2.1 * (2.0 * 3.8539e-3 + 9.0279e-5) / std::sqrt(5.0), 1e-6);
  EXPECT_TRUE(interactionForce({{1.0, 1.0}, {1.0, 0.0}}, {{1.0, 1.0}, {0.0, 0.0}}).isZero(0.0));
}

TEST(RobotPeopleMetrics, SumsOfForces) {
  // Two people at rest, 2 m in front of the robot and behind it, push with 0.0069269 each; together they do not.
  const RobotResult result = amongStanding({{2.0, 0.0}, {-2.0, 0.0}});
  EXPECT_NEAR(result.social_force_on_robot, 2.0 * 0.0069269, 1e-6);
  EXPECT_NEAR(result.social_force_on_agents, 2.0 * 0.0069269, 1e-6);
  EXPECT_NEAR(result.social_work, 0.0 + 0.0 + 2.0 * 0.0069269, 1e-6);
  EXPECT_EQ(result.obstacle_force_on_robot, 0.0);
  // With one of them: on the robot and on the person.
  EXPECT_NEAR(amongStanding({{2.0, 0.0}}).social_work, 2.0 * 0.0069269, 1e-6);
}

TEST(RobotPeopleMetrics, ObstacleForces) {
  // The robot is 0.7 - 0.3 = 0.4 m from a wall: 10 exp(-0.4 / 0.2) = 1.35335. One person is 0.45 m from it: 10
  // exp(-2.25) = 1.05399; the other one 0.25 m from a pillar: 10 exp(-1.25) = 2.86505. Two ticks.
  RobotLogHeader header = headerTo({9.0, 0.0});
  header.walls = {{{-5.0, 0.7}, {5.0, 0.7}}};
  header.obstacles = {{{3.0, -1.0}, 0.5, false}};
  const std::vector<LoggedPerson> people = {personAt(0, {-3.0, 0.0}), personAt(1, {3.0, -2.0})};
  const RobotResult result = scoreOf(
      header,
      std::vector<RobotLogTick>{tickAt(0, Pose(), people), tickAt(1, Pose(), people), tickAt(2, Pose(), people)});
  EXPECT_NEAR(result.obstacle_force_on_robot, 2.0 * 1.35335, 1e-4);
  EXPECT_NEAR(result.obstacle_force_on_agents, 2.0 * (1.05399 + 2.86505) / 2.0, 1e-4);
  EXPECT_NEAR(result.minimum_obstacle_clearance, 0.4, 1e-12);
  EXPECT_EQ(result.wall_contacts, 0U);
}

TEST(RobotPeopleMetrics, ClearanceToObstaclesAndContacts) {
  // A wall ahead at 2 m and a pillar behind: nearest are 1.2 m (pillar), 0.7 m (wall), 0 m (wall), 0.7 m (wall).
  RobotLogHeader header = headerTo({9.0, 0.0});
  header.walls = {{{2.0, -5.0}, {2.0, 5.0}}};
  header.obstacles = {{{-2.0, 0.0}, 0.5, false}};
  const RobotResult result = scoreOf(
      header,
      std::vector<Pose>{{{0.0, 0.0}, 0.0}, {{0.0, 0.0}, 0.0}, {{1.0, 0.0}, 0.0}, {{1.7, 0.0}, 0.0}, {{1.0, 0.0}, 0.0}});
  EXPECT_NEAR(result.minimum_obstacle_clearance, 0.0, 1e-12);
  EXPECT_NEAR(result.avg_obstacle_clearance, (1.2 + 0.7 + 0.0 + 0.7) / 4.0, 1e-12);
  EXPECT_EQ(result.wall_contacts, 1U);
  EXPECT_EQ(result.obstacle_contacts, 0U);
  EXPECT_EQ(result.contacts, 1U);
  const RobotResult back = scoreOf(header, std::vector<Pose>{{{0.0, 0.0}, 0.0}, {{-1.2, 0.0}, PI}});
  EXPECT_EQ(back.obstacle_contacts, 1U);
  EXPECT_EQ(back.wall_contacts, 0U);
}

TEST(RobotPeopleMetrics, WhatIsThereAtTheStartIsNoContact) {
  // It stands at a wall and at a pillar, between the members of a group; it leaves them and comes back.
  RobotLogHeader header = headerTo({9.0, 0.0});
  header.walls = {{{-5.0, 0.3}, {5.0, 0.3}}};
  header.obstacles = {{{0.0, -0.8}, 0.5, false}};
  std::vector<LoggedPerson> people = {personAt(0, {-1.0, 0.0}), personAt(1, {1.0, 0.0})};
  for (LoggedPerson& person : people) person.group = 1;
  const auto after = [&](const std::vector<Vector2>& places) {
    std::vector<RobotLogTick> ticks;
    for (const Vector2& place : places) ticks.push_back(tickAt(ticks.size(), {place, 0.0}, people));
    return scoreOf(header, ticks);
  };
  const RobotResult stays = after({{0.0, 0.0}, {0.0, 0.0}});
  EXPECT_EQ(stays.contacts, 0U);
  EXPECT_EQ(stays.group_intrusions, 0U);
  const RobotResult returns = after({{0.0, 0.0}, {0.0, -4.0}, {0.0, 0.0}});
  EXPECT_EQ(returns.wall_contacts, 1U);
  EXPECT_EQ(returns.obstacle_contacts, 1U);
  EXPECT_EQ(returns.group_intrusions, 1U);
}

TEST(RobotPeopleMetrics, ClearanceOfAFootprintBesideItsOrigin) {
  // From 2 to 3 m ahead. The wall behind is 1 m from the origin and 3 m from the footprint, that ahead 4.2 m and 1.2 m.
  RobotLogHeader header = headerTo({9.0, 0.0});
  header.robots[0].footprint = {0.0, {{2.0, -0.1}, {3.0, -0.1}, {3.0, 0.1}, {2.0, 0.1}}};
  header.walls = {{{-1.0, -1.0}, {-1.0, 1.0}}, {{4.2, -1.0}, {4.2, 1.0}}};
  EXPECT_NEAR(scoreOf(header, std::vector<Pose>{Pose(), Pose()}).minimum_obstacle_clearance, 1.2, 1e-12);
}

TEST(RobotPeopleMetrics, ContactsAreThoseOfTheWaysBetweenTheLines) {
  // The robot stands at the origin. `velocity` is that at the end of the tick of 1 s.
  const auto contacts = [](const std::vector<LoggedPerson>& before, const Vector2& place, const Vector2& velocity) {
    LoggedPerson person = personAt(7, place);
    person.velocity = velocity;
    return scoreOf(headerTo({9.0, 0.0}),
                   std::vector<RobotLogTick>{tickAt(0, Pose(), before), tickAt(1, Pose(), {person})});
  };
  // It walks beside the robot, and then towards (2, 1) at 2.2 m/s.
  EXPECT_EQ(contacts({personAt(7, {2.0, 0.0})}, {2.0, 1.0}, {2.0, 1.0}).contacts, 0U);
  // It walks through the robot and stops.
  EXPECT_EQ(contacts({personAt(7, {-2.0, 0.0})}, {2.0, 0.0}, {0.0, 0.0}).person_on_robot_collisions, 1U);
  // It appears in front of the robot.
  EXPECT_EQ(contacts({}, {0.9, 0.0}, {1.0, 0.0}).contacts, 0U);
}

TEST(RobotPeopleMetrics, ContactsByCause) {
  // The robot drives through a person who stands; then a person walks through the robot, which stands.
  const RobotResult drives =
      scoreOf(headerTo({9.0, 0.0}), std::vector<RobotLogTick>{tickAt(0, {{0.0, 0.0}, 0.0}, {personAt(7, {1.0, 0.0})}),
                                                              tickAt(1, {{0.5, 0.0}, 0.0}, {personAt(7, {1.0, 0.0})}),
                                                              tickAt(2, {{0.6, 0.0}, 0.0}, {personAt(7, {1.0, 0.0})}),
                                                              tickAt(3, {{2.0, 0.0}, 0.0}, {personAt(7, {1.0, 0.0})})});
  EXPECT_EQ(drives.robot_on_person_collisions, 1U);
  EXPECT_EQ(drives.people_contacts, 1U);
  EXPECT_EQ(drives.contact_time, 3.0);  // it begins in the first tick, at 0.45 m, and ends in the third one
  const RobotResult stands =
      scoreOf(headerTo({9.0, 0.0}), std::vector<RobotLogTick>{tickAt(0, Pose(), {personAt(7, {1.0, 0.0})}),
                                                              tickAt(1, Pose(), {personAt(7, {0.4, 0.0})})});
  EXPECT_EQ(stands.person_on_robot_collisions, 1U);
  EXPECT_EQ(stands.contacts, 1U);
  const RobotResult apart =
      scoreOf(headerTo({9.0, 0.0}), std::vector<RobotLogTick>{tickAt(0, Pose(), {personAt(7, {1.0, 0.0})}),
                                                              tickAt(1, Pose(), {personAt(7, {0.56, 0.0})})});
  EXPECT_EQ(apart.contacts, 0U);
}

TEST(RobotPeopleMetrics, GroupSpaces) {
  LoggedPerson left = personAt(0, {2.0, 1.0});
  LoggedPerson right = personAt(1, {2.0, -1.0});
  for (LoggedPerson* person : {&left, &right}) {
    person->group = 5;
    person->heading = 0.0;
  }
  const auto score_at = [&](const std::vector<double>& xs) {
    std::vector<RobotLogTick> ticks;
    for (const double x : xs) ticks.push_back(tickAt(ticks.size(), {{x, 0.0}, 0.0}, {left, right}));
    return scoreOf(headerTo({9.0, 0.0}), ticks);
  };
  // The middle of the group is at (3.5, 0), 1.5 m in front of them: 3.2 m from the rim of the robot.
  EXPECT_EQ(score_at({0.0, 0.0}).group_social_space_intrusions, 100.0);
  EXPECT_EQ(score_at({0.0, 2.3}).group_personal_space_intrusions, 100.0);
  EXPECT_EQ(score_at({0.0, 3.5}).group_intimate_space_intrusions, 100.0);
  // Between them, its rim is on the line from one to the other from 1.7 to 2.3 m.
  EXPECT_EQ(score_at({0.0, 1.0, 1.8, 2.2, 3.0, 2.1}).group_intrusions, 2U);
  right.group = 6;
  EXPECT_EQ(score_at({0.0, 3.5}).group_intimate_space_intrusions, 0.0);
  EXPECT_EQ(score_at({0.0, 2.0}).group_intrusions, 0U);
}

TEST(RobotPeopleMetrics, TheHullOfAGroup) {
  std::vector<LoggedPerson> people;
  for (const Vector2& place :
       {Vector2(2.0, 2.0), Vector2(6.0, 2.0), Vector2(4.0, 0.5), Vector2(2.0, -2.0), Vector2(6.0, -2.0)}) {
    people.push_back(personAt(static_cast<AgentId>(people.size()), place));
    people.back().group = 1;
  }
  const auto enters = [&](const Vector2& place) {
    return scoreOf(headerTo({9.0, 0.0}),
                   std::vector<RobotLogTick>{tickAt(0, Pose(), people), tickAt(1, {place, 0.0}, people)})
               .group_intrusions == 1;
  };
  EXPECT_TRUE(enters({4.0, -1.0}));
  EXPECT_TRUE(enters({1.75, 0.0}));
  EXPECT_FALSE(enters({1.65, 0.0}));
  EXPECT_FALSE(enters({4.0, 2.35}));
}

TEST(RobotPeopleMetrics, AggregatedTime) {
  const auto score = [](std::vector<AgentId> arrived, bool endless) {
    LoggedPerson person = personAt(3, {0.0, 5.0});
    person.endless = endless;
    std::vector<RobotLogTick> ticks = {tickAt(0, Pose(), {person}), tickAt(1, {{1.0, 0.0}, 0.0}, {person}),
                                       tickAt(2, {{2.0, 0.0}, 0.0}), tickAt(3, {{2.0, 0.0}, 0.0})};
    ticks[3].arrived = std::move(arrived);
    return scoreOf(headerTo({2.0, 0.0}), ticks).aggregated_time;
  };
  EXPECT_EQ(score({3}, false), 3.0);  // the robot has arrived after 2 s, the person after 3 s
  EXPECT_TRUE(std::isnan(score({}, false)));
  EXPECT_EQ(score({}, true), 2.0);
}

}  // namespace
}  // namespace crowd::robots::robot_people_metrics_test
