#include "scenario/scenario.h"

#include <gtest/gtest.h>

#include <array>

#include "scenario/reading/scenario_reader.h"
#include "social_crowd/errors.h"
#include "support/overlaps.h"

namespace crowd::scenario_test {
namespace {

const char* const HEAD = "name: n\nduration: 60\ngoal_tolerance: 0.3\n";

ScenarioList parse(const std::string& text) { return parseScenarios(text, "s.yaml"); }

/// The start positions of a scene, agents first.
std::vector<Vector2> places(const Scene& scene) {
  std::vector<Vector2> all;
  for (const AgentStart& agent : scene.agents) {
    all.push_back(agent.position);
    all.insert(all.end(), agent.goals.begin(), agent.goals.end());
    all.emplace_back(agent.max_speed, agent.radius);
    all.emplace_back(agent.heading, 0.0);
  }
  for (const Obstacle& obstacle : scene.obstacles) {
    all.insert(all.end(), obstacle.path.points().begin(), obstacle.path.points().end());
    all.emplace_back(obstacle.radius, 0.0);
  }
  return all;
}

struct Disc {
  Vector2 centre;
  double radius;
};

std::vector<Disc> discs(const Scene& scene) {
  std::vector<Disc> all;
  for (const AgentStart& agent : scene.agents) {
    all.push_back({agent.position, agent.radius});
  }
  for (const Obstacle& obstacle : scene.obstacles) {
    all.push_back({obstacle.path.position(0.0), obstacle.radius});
  }
  return all;
}

/// A hall with all kinds of random places, the drawn bodies before the fixed ones.
const char* const HALL =
    "agents:\n"
    "  - {count: 12, position: {box: [[-4, -4], [4, 4]]}, goal: {box: [[-4, -4], [4, 4]]}, speed: [0.8, "
    "1.6],\n"
    "     radius: [0.2, 0.3], heading: [-180, 180]}\n"
    "  - {count: 4, position: {ring: {centre: [0, 0], radius: [3, 4]}}, goal: {opposite: [0, 0]}, speed: 1,\n"
    "     radius: 0.25}\n"
    "  - {position: [0, 0], goals: [[3, 3], {ring: {centre: [0, 0], radius: 2}}], speed: 1, radius: 0.25}\n"
    "obstacles:\n"
    "  - {count: 5, position: {box: [[-4, -4], [4, 4]]}, radius: [0.2, 0.5]}\n"
    "  - {count: 2, position: {box: [[-4, -4], [4, 4]]}, radius: 0.3, to_and_fro: {box: [[-4, -4], [4, "
    "4]]},\n"
    "     speed: [0.1, 0.5]}\n"
    "  - {position: [1, 1], radius: 0.4}\n"
    "walls:\n"
    "  - [[-5, 0], [-1, 0]]\n";

/// Calls `check` with scenes of the hall; failures name the episode.
template <typename Check>
void forManyHalls(Check check) {
  const ScenarioList list = parse(std::string(HEAD) + HALL);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (std::uint64_t episode = 0; episode < 40; ++episode) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", episode " + std::to_string(episode));
      check(list.scene(seed, episode));
    }
  }
}

TEST(Region, DrawsUniformlyWithinABox) {
  Region box;
  box.kind = Region::Kind::BOX;
  box.first = {-1.0, 2.0};
  box.second = {3.0, 4.0};
  KeyedRandom random(7, KeyedRandom::PLACEMENT, {});
  Vector2 sum = Vector2::Zero();
  for (int i = 0; i < 10000; ++i) {
    const Vector2 point = box.draw(random);
    ASSERT_TRUE(point.x() >= -1.0 && point.x() <= 3.0 && point.y() >= 2.0 && point.y() <= 4.0);
    sum += point;
  }
  EXPECT_NEAR(sum.x() / 10000.0, 1.0, 0.05);
  EXPECT_NEAR(sum.y() / 10000.0, 3.0, 0.03);
}

TEST(Region, DrawsUniformlyOverTheAreaOfARing) {
  Region ring;
  ring.kind = Region::Kind::RING;
  ring.first = {1.0, 1.0};
  ring.radius = {0.0, 2.0};
  KeyedRandom random(7, KeyedRandom::PLACEMENT, {});
  int inner = 0;
  int left = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vector2 offset = ring.draw(random) - ring.first;
    ASSERT_LE(offset.norm(), 2.0 + 1e-12);
    inner += offset.norm() < 1.0 ? 1 : 0;
    left += offset.x() < 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(inner, 2500, 200);  // a quarter of the area
  EXPECT_NEAR(left, 5000, 200);
}

TEST(Region, DrawsOnTheCircleOfARingWithOneRadius) {
  Region ring;
  ring.kind = Region::Kind::RING;
  ring.radius = {3.0, 3.0};
  KeyedRandom random(7, KeyedRandom::PLACEMENT, {});
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(ring.draw(random).norm(), 3.0, 1e-12);
  }
}

TEST(Scenario, WithoutRandomPlacesAlwaysGivesTheSameScene) {
  const ScenarioList list = parse(std::string(HEAD) +
                                  "agents: [{position: [0, 0], goal: [4, 0], speed: 1, radius: 0.25}]\n"
                                  "obstacles: [{position: [2, 0], radius: 0.5}]\n");
  EXPECT_EQ(places(list.scene(1, 0)), places(list.scene(99, 12345)));
}

TEST(Scenario, DependsOnlyOnRunSeedScenarioSeedAndEpisode) {
  const ScenarioList list = parse(std::string(HEAD) + HALL);
  const ScenarioList again = parse(std::string(HEAD) + HALL);
  const ScenarioList other = parse(std::string(HEAD) + "seed: 5\n" + HALL);
  const auto scene = places(list.scene(1, 3));
  list.scene(1, 4);
  EXPECT_EQ(scene, places(list.scene(1, 3)));
  EXPECT_EQ(scene, places(again.scene(1, 3)));
  EXPECT_NE(scene, places(list.scene(1, 4)));
  EXPECT_NE(scene, places(list.scene(2, 3)));
  EXPECT_NE(scene, places(other.scene(1, 3)));
}

TEST(Scenario, DrawnBodiesKeepClearOfEachOtherAndOfWalls) {
  forManyHalls([](const Scene& scene) {
    EXPECT_FALSE(scenes::hasOverlap(scene));
    const std::vector<Disc> all = discs(scene);
    ASSERT_EQ(all.size(), 25U);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        const double gap = (all[i].centre - all[j].centre).norm() - all[i].radius - all[j].radius;
        EXPECT_GE(gap, DRAWN_GAP - 1e-12) << i << " and " << j;
      }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i != 16) {  // the fixed one, 0.75 m from the wall's end
        EXPECT_GE(distanceTo(scene.walls[0], all[i].centre) - all[i].radius, DRAWN_GAP - 1e-12) << i;
      }
    }
  });
}

TEST(Scenario, DrawnNumbersLieInTheirRanges) {
  forManyHalls([](const Scene& scene) {
    for (std::size_t i = 0; i < 12; ++i) {
      const AgentStart& agent = scene.agents[i];
      EXPECT_TRUE(agent.max_speed >= 0.8 && agent.max_speed <= 1.6);
      EXPECT_TRUE(agent.radius >= 0.2 && agent.radius <= 0.3);
      EXPECT_TRUE(agent.heading >= -PI && agent.heading <= PI);
      EXPECT_LE(agent.position.cwiseAbs().maxCoeff(), 4.0);
    }
    for (std::size_t i = 12; i < 16; ++i) {
      const AgentStart& agent = scene.agents[i];
      EXPECT_TRUE(agent.position.norm() >= 3.0 - 1e-12 && agent.position.norm() <= 4.0 + 1e-12);
      EXPECT_LT((agent.goals.at(0) + agent.position).norm(), 1e-12);
      EXPECT_NEAR(std::abs(wrapAngle(agent.heading - bearingOf(-agent.position))), 0.0, 1e-9);
    }
    EXPECT_EQ(scene.agents[16].goals.at(0), Vector2(3.0, 3.0));
    EXPECT_EQ(scene.obstacles[7].path.points()[0], Vector2(1.0, 1.0));
  });
}

TEST(Scenario, DrawnGoalsAreFreeAndAwayFromTheStart) {
  forManyHalls([](const Scene& scene) {
    for (const AgentStart& agent : scene.agents) {
      const Vector2& goal = agent.goals.back();
      EXPECT_GT((goal - agent.position).norm(), scene.goal_tolerance);
      EXPECT_GE(distanceTo(scene.walls[0], goal), agent.radius);
      for (const Obstacle& obstacle : scene.obstacles) {
        if (!obstacle.path.moves()) {
          EXPECT_GE((goal - obstacle.path.position(0.0)).norm(), agent.radius + obstacle.radius);
        }
      }
    }
  });
}

TEST(Scenario, DrawnGoalsKeepClearOfEachOther) {
  forManyHalls([](const Scene& scene) {
    for (std::size_t i = 0; i < scene.agents.size(); ++i) {
      for (std::size_t j = i + 1; j < scene.agents.size(); ++j) {
        const double apart = (scene.agents[i].goals.back() - scene.agents[j].goals.back()).norm();
        EXPECT_GE(apart, scene.agents[i].radius + scene.agents[j].radius) << i << " and " << j;
      }
    }
  });
}

/// A closed room covers half of the box.
const char* const CLOSED_ROOM =
    "agents: [{count: 20, position: {box: [[-5, -5], [3, 5]]}, goal: {box: [[-5, -5], [3, 5]]}, speed: 1, radius: "
    "0.2}]\n"
    "walls: [[[-1, -6], [3, -6]], [[3, -6], [3, 6]], [[3, 6], [-1, 6]], [[-1, 6], [-1, -6]]]\n";

TEST(Scenario, StartsAndGoalsAreDrawnWhereAWayConnectsThem) {
  const auto count_apart = [](const std::string& text) {
    std::size_t apart = 0;
    for (std::uint64_t episode = 0; episode < 10; ++episode) {
      for (const AgentStart& agent : parse(HEAD + text).scene(1, episode).agents) {
        apart += (agent.position.x() < -1.0) == (agent.goals.front().x() < -1.0) ? 0 : 1;
      }
    }
    return apart;
  };
  EXPECT_EQ(count_apart(CLOSED_ROOM), 0U);
  EXPECT_GT(count_apart(std::string(CLOSED_ROOM) + "way_finding: false\n"), 0U);
}

TEST(Scenario, GoalsThatNoWayLeadsToAreDrawnIfThereAreNoOthers) {
  const Scene scene = parse(std::string(HEAD) +
                            "agents: [{position: [-4, 0], goal: {box: [[0, -5], [2, 5]]}, speed: 1, radius: 0.2}]\n"
                            "walls: [[[-1, -6], [3, -6]], [[3, -6], [3, 6]], [[3, 6], [-1, 6]], [[-1, 6], [-1, -6]]]\n")
                          .scene(1, 0);
  EXPECT_GT(scene.agents.front().goals.front().x(), 0.0);
}

TEST(Scenario, DrawnGoalsMayOverlapIfThereIsNoRoom) {
  const ScenarioList list = parse(std::string(HEAD) +
                                  "agents: [{count: 20, position: {box: [[-5, -5], [0, 5]]},\n"
                                  "          goal: {box: [[4, 0], [4.5, 0.5]]}, speed: 1, radius: 0.25}]\n");
  EXPECT_EQ(list.scene(1, 0).agents.size(), 20U);
}

TEST(Scenario, DrawnObstaclesKeepClearOfFixedGoalsAndStarts) {
  const ScenarioList list = parse(std::string(HEAD) +
                                  "agents: [{position: [0, 0], goal: [2, 0], speed: 1, radius: 0.25}]\n"
                                  "obstacles: [{position: {box: [[-1, -1], [3, 1]]}, radius: 0.4}]\n");
  for (std::uint64_t episode = 0; episode < 200; ++episode) {
    SCOPED_TRACE("episode " + std::to_string(episode));
    const Vector2 centre = list.scene(1, episode).obstacles[0].path.position(0.0);
    EXPECT_GE(centre.norm(), 0.65 + DRAWN_GAP);
    EXPECT_GE((centre - Vector2(2.0, 0.0)).norm(), 0.65);
  }
}

TEST(Scenario, ErrorNamesTheBodyWithoutAPlace) {
  const std::string text = std::string(HEAD) +
                           "agents:\n"
                           "  - {position: [5, 5], goal: [6, 6], speed: 1, radius: 0.25}\n"
                           "  - {count: 9, position: {box: [[0, 0], [1, 1]]}, goal: [6, 6], speed: 1, radius: 0.25}\n";
  try {
    parse(text);
    ADD_FAILURE() << "nine agents found room on a square metre";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("s.yaml: document 1, line 6: agents[1] ("), 0U) << message;
    EXPECT_NE(message.find(" of 9): no free place for it and its goal found in 1000 tries"), std::string::npos);
  }
}

TEST(ScenarioList, RepeatsItsScenariosInOrder) {
  const auto document = [](const std::string& name) {
    return "---\nname: " + name +
           "\nduration: 60\ngoal_tolerance: 0.3\n"
           "agents: [{position: {box: [[0, 0], [9, 9]]}, goal: [4, 0], speed: 1, radius: 0.25}]\n";
  };
  const ScenarioList list = parse(document("a") + document("b") + document("c"));
  EXPECT_EQ(list.scene(1, 0).name, "a");
  EXPECT_EQ(list.scene(1, 2).name, "c");
  EXPECT_EQ(list.scene(1, 4).name, "b");
  EXPECT_NE(places(list.scene(1, 1)), places(list.scene(1, 4)));
  EXPECT_THROW(ScenarioList().scene(1, 0), InputError);
}

TEST(Scenario, RandomHeadingsDifferAndCoverTheCircle) {
  const ScenarioList list =
      parse(std::string(HEAD) + "agents: [{position: [0, 0], goal: [0, 3], speed: 1, radius: 0.2, heading: random}]\n");
  std::array<int, 4> quarters{};
  for (std::uint64_t episode = 0; episode < 400; ++episode) {
    const double heading = list.scene(1, episode).agents[0].heading;
    ++quarters.at(static_cast<std::size_t>((heading + PI) / (PI / 2.0)) % 4);
  }
  for (const int count : quarters) EXPECT_NEAR(count, 100, 40);
}

TEST(Scenario, ObstaclesBetweenLieBetweenStartAndGoal) {
  const ScenarioList list = parse(
      std::string(HEAD) +
      "agents: [{position: {ring: {centre: [0, 0], radius: [0, 0.2]}}, goal: {ring: {centre: [0, 0], radius: 3}},\n"
      "  speed: 1, radius: 0.2}]\n"
      "obstacles: [{position: {between: {agent: 0, share: [0.4, 0.6], aside: [-0.1, 0.1]}}, radius: 0.4}]\n");
  for (std::uint64_t episode = 0; episode < 200; ++episode) {
    const Scene scene = list.scene(1, episode);
    const Vector2 way = scene.agents[0].goals[0] - scene.agents[0].position;
    const Vector2 place = scene.obstacles[0].path.position(0.0) - scene.agents[0].position;
    const double share = place.dot(way) / way.squaredNorm();
    EXPECT_TRUE(share >= 0.4 - 1e-12 && share <= 0.6 + 1e-12) << share;
    EXPECT_LE(std::abs(cross(way, place)) / way.norm(), 0.1 + 1e-12);
  }
}

TEST(Scenario, KeptHeadingsComeFromThePreviousEpisode) {
  Scene scene = parse(std::string(HEAD) +
                      "agents:\n"
                      "  - {position: [0, 0], goal: [0, 3], speed: 1, radius: 0.2, heading: kept}\n"
                      "  - {position: [2, 0], goal: [2, 3], speed: 1, radius: 0.2}\n"
                      "  - {position: [4, 0], goal: [4, 3], speed: 1, radius: 0.2, heading: kept}\n")
                    .scene(1, 0);
  keepHeadings({1.0, 2.0}, scene);
  EXPECT_EQ(scene.agents[0].heading, 1.0);
  EXPECT_NEAR(scene.agents[1].heading, PI / 2.0, 1e-12);
  EXPECT_NEAR(scene.agents[2].heading, PI / 2.0, 1e-12);  // not in the previous episode
}

}  // namespace
}  // namespace crowd::scenario_test
