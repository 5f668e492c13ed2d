#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/scenes.h"
#include "support/worlds.h"
#include "world/world.h"
#include "world/world_editor.h"

namespace crowd::recorded_people_test {
namespace {

using scenes::halfSeconds;
using scenes::moving_obstacle;
using scenes::pillar;
using scenes::scene;
using scenes::solid;
using scenes::wanderer;

/// A person of radius 0.25 m.
Obstacle person(std::vector<double> times, std::vector<Vector2> places) {
  const auto track = std::make_shared<const Track>(std::move(times), std::move(places));
  return {ObstaclePath::recorded(track), 0.25, 12};
}

/// Comes at 1 s at (4, 1) and walks south at 1 m/s to (4, -1).
Obstacle walker() { return person({1.0, 3.0}, {{4.0, 1.0}, {4.0, -1.0}}); }

TEST(RecordedPeople, ArePerceivedWhileTheyAreThere) {
  // Obstacles before and after it, which must not be mistaken for it when it comes and goes.
  World world(halfSeconds(scene({wanderer({0.0, 0.0}, 0.0)}, {moving_obstacle({0.0, -8.0}, {1.0, 0.0}, 0.5), walker(),
                                                              moving_obstacle({0.0, 9.0}, {0.0, 1.0}, 0.5)})));
  for (int tick = 0; tick <= 8; ++tick) {
    SCOPED_TRACE("tick " + std::to_string(tick));
    const double time = 0.5 * tick;
    const Perceptions seen = lookAround(world);
    const bool is_there = tick >= 2 && tick <= 6;
    ASSERT_EQ(seen.agents[0].neighbour_count, is_there ? 3U : 2U);
    EXPECT_EQ(world.recordedPeople().size(), is_there ? 1U : 0U);
    std::size_t found = 0;
    for (std::uint32_t i = 0; i < seen.agents[0].neighbour_count; ++i) {
      const Neighbour neighbour = seen.neighbours[i];
      EXPECT_EQ(neighbour.kind, NeighbourKind::OBSTACLE);
      if (neighbour.velocity == Vector2(1.0, 0.0)) expectVector(neighbour.position, time, -8.0);
      if (neighbour.velocity == Vector2(0.0, 1.0)) expectVector(neighbour.position, 0.0, 9.0 + time);
      if (neighbour.velocity != Vector2(0.0, -1.0)) continue;
      ++found;
      expectVector(neighbour.position, 4.0, 2.0 - time);
      EXPECT_EQ(neighbour.radius, 0.25);
    }
    EXPECT_EQ(found, is_there ? 1U : 0U);
    world.step({});
  }
}

TEST(RecordedPeople, AreInContactWithAgentsWhileTheyAreThere) {
  World world(halfSeconds(scene({wanderer({4.0, 0.0}, 0.0)}, {walker()})));
  std::vector<bool> contacts;
  for (int tick = 1; tick <= 7; ++tick) {
    world.step({});
    contacts.push_back(world.agents()[0].in_contact);
  }
  // At (4, 1 - (t - 1)) from 1 s to 3 s: within 0.5 m of (4, 0) by more than 1 mm at 2 s only.
  EXPECT_EQ(contacts, (std::vector<bool>{false, false, false, true, false, false, false}));
}

TEST(RecordedPeople, PushAgentsOfASolidWorldAndPassOverWhomTheyAppearOn) {
  World world(halfSeconds(solid(scene({wanderer({4.0, 0.0}, 0.0), wanderer({0.1, 0.0}, 0.0)},
                                      {walker(), person({1.0, 5.0}, {{0.0, 0.0}, {0.0, 0.0}})}))));
  for (int tick = 1; tick <= 8; ++tick) world.step({});
  expectVector(world.agents()[0].pose.position, 4.0, -1.5);  // two radii before the end of the walk
  EXPECT_TRUE(world.agents()[0].touched);
  expectVector(world.agents()[1].pose.position, 0.1, 0.0);  // stays where somebody appeared on it
  EXPECT_TRUE(world.agents()[1].in_contact);
  for (int tick = 9; tick <= 11; ++tick) world.step({});
  EXPECT_FALSE(world.agents()[1].in_contact);  // the other one has left
}

TEST(RecordedPeople, AnAgentOnWhomOneAppearsCanWalkAway) {
  for (const bool is_solid : {false, true}) {
    Scene made = halfSeconds(scene({wanderer({0.1, 0.0}, 1.0)}, {person({0.5, 9.0}, {{0.0, 0.0}, {0.0, 0.0}})}));
    if (is_solid) made = solid(made);
    World world(made);
    world.step({});
    EXPECT_TRUE(world.agents()[0].in_contact);
    for (int tick = 0; tick < 3; ++tick) world.step({ahead(0)});
    expectVector(world.agents()[0].pose.position, 1.6, 0.0);
    EXPECT_FALSE(world.agents()[0].in_contact);
  }
}

TEST(RecordedPeople, CanNeitherBeMovedNorRemoved) {
  World world(scene({wanderer({0.0, 0.0})}, {pillar({2.0, 2.0}, 0.5), walker()}));
  WorldEditor editor(world);
  const std::string expected = "obstacle 1 is recorded person 12, who cannot be moved or removed";
  EXPECT_EQ(errorOf<InputError>([&] { editor.moveObstacle(1, {8.0, 8.0}); }), expected);
  EXPECT_EQ(errorOf<InputError>([&] { editor.removeObstacle(1); }), expected);
  // Others can, and the recorded person goes on.
  editor.removeObstacle(0);
  EXPECT_EQ(editor.spawnObstacle({8.0, 8.0}, {0.0, 0.0}, 0.5), 1U);
  for (int tick = 0; tick < 20; ++tick) world.step({});
  ASSERT_EQ(world.recordedPeople().size(), 1U);
  expectVector(world.recordedPeople()[0].position, 4.0, 0.0);
  EXPECT_EQ(errorOf<InputError>([&] {
              editor.spawnAgent(wanderer({4.1, 0.0}));
            }),
            "the place is taken by recorded person 12");
}

TEST(RecordedPeople, AreNotThereForPlacesBeforeTheyCome) {
  World world(scene({wanderer({0.0, 0.0})}, {walker()}));
  EXPECT_EQ(WorldEditor(world).spawnAgent(wanderer({4.0, 1.0})), 1U);
}

}  // namespace
}  // namespace crowd::recorded_people_test
