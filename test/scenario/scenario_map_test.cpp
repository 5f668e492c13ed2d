#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "maps/map_walls.h"
#include "scenario/reading/scenario_map.h"
#include "scenario/reading/scenario_reader.h"
#include "support/error_of.h"
#include "support/temporary_folder.h"

namespace crowd::scenario_map_test {
namespace {

/// A scenario with a map of 10 x 1 cells of 1 m; the last four, from x = 6 to 10 m, are occupied. So there are walls
/// round the free cells, from (0, 0) to (6, 1).
class ScenarioMap : public testing::Test {
 protected:
  static constexpr const char* KEYS =
      "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

  ScenarioMap() {
    folder_.write("map.pgm", "P2 10 1 255 255 255 255 255 255 255 0 0 0 0\n");
    folder_.write("map.yaml", KEYS);
  }

  /// What is said of a scenario with the map on line 4 and an agent on line 5.
  std::string errorWith(const std::string& map, const std::string& agent) const {
    const std::string text =
        "name: n\nduration: 60\ngoal_tolerance: 0.3\nmap: " + map + "\nagents: [{" + agent + "}]\n";
    return errorOf<Error>([&] { parseScenarios(text, folder_.file("s.yaml")); });
  }
  /// The same with a goal of an agent that starts at (1, 0.5).
  std::string errorOfGoal(const std::string& goal, const std::string& radius = "0.2") const {
    return errorWith("map.yaml", "position: [1, 0.5], goal: " + goal + ", speed: 1, radius: " + radius);
  }
  std::string place() const { return folder_.file("s.yaml") + ": document 1, line 4: map: "; }

  TemporaryFolder folder_;
};

TEST_F(ScenarioMap, ErrorsOfItsFilesSayWhereItIsNamed) {
  const std::string agent = "position: [1, 0.5], goal: [3, 0.5], speed: 1, radius: 0.2";
  EXPECT_EQ(errorWith("map.yaml", agent), "no error");
  const std::string absent = errorWith("absent.yaml", agent);
  EXPECT_EQ(absent.find(place() + folder_.file("absent.yaml") + ": cannot be read"), 0U) << absent;
  folder_.write("broken.yaml", "image: map.pgm\nresolution: -1\n");
  const std::string broken = errorWith("broken.yaml", agent);
  EXPECT_EQ(broken.find(place() + folder_.file("broken.yaml") + ": line 2: resolution: "), 0U) << broken;
  folder_.write("imageless.yaml", std::string(KEYS).replace(7, 7, "not.pgm"));
  const std::string imageless = errorWith("imageless.yaml", agent);
  EXPECT_EQ(imageless.find(place() + folder_.file("imageless.yaml") + ": line 1: image: "), 0U) << imageless;
}

TEST_F(ScenarioMap, TheRadiusOfItsFreeSpaceIsAtLeastThatOfTheAgents) {
  const std::string agent = "position: {map: free}, goal: {map: free}, speed: 1, radius: [0.1, 0.2]";
  EXPECT_EQ(errorWith("map.yaml\nfree_radius: 0.2", agent), "no error");
  EXPECT_EQ(errorWith("map.yaml\nfree_radius: 0.19", agent),
            folder_.file("s.yaml") +
                ": document 1, line 5: free_radius: expected at least the radius of the largest "
                "agent, 0.2 m, got '0.19'");
  EXPECT_NE(errorWith("map.yaml\nfree_radius: 0.6", agent).find("no agent of the scenario fits"), std::string::npos);
}

/// Two rooms of 4 m, with a wall of 1 m between them. All twelve goals and the start are in one room in one of 4096
/// draws.
TEST_F(ScenarioMap, ARobotWithManyGoalsOnTheMapStaysInItsRoom) {
  folder_.write("map.pgm", "P2 9 1 255 255 255 255 255 0 255 255 255 255\n");
  std::string goals = "{map: free}";
  for (int i = 1; i < 12; ++i) goals += ", {map: free}";
  const std::string text =
      "name: n\nduration: 60\ngoal_tolerance: 0.01\nmap: map.yaml\nfree_radius: 0.2\nrobots: [{name: r, position: "
      "{map: "
      "free}, radius: 0.2, max_speed: 1, goals: [" +
      goals + "]}]\n";
  const ScenarioList scenarios = parseScenarios(text, folder_.file("s.yaml"));
  for (std::uint64_t instance = 0; instance < 20; ++instance) {
    const RobotStart robot = scenarios.scene(1, instance).robots.at(0);
    for (const Vector2& goal : robot.goals) EXPECT_EQ(goal.x() < 4.0, robot.position.x() < 4.0) << instance;
  }
}

/// There is no wall within 1 m of (8, 0.5), in the middle of the occupied cells.
TEST_F(ScenarioMap, GoalsInOccupiedCellsAreRefused) {
  const auto expected = [&](const std::string& goal) {
    return folder_.file("s.yaml") +
           ": document 1, line 5: agents[0].goal: expected a goal that an agent of radius 0.2 m can get to within "
           "goal_tolerance (0.3 m), got " +
           goal + ", which is in a wall or an obstacle";
  };
  EXPECT_EQ(errorOfGoal("[8, 0.5]"), expected("(8, 0.5)"));
  EXPECT_EQ(errorOfGoal("[6.11, 0.5]"), expected("(6.11, 0.5)"));
  EXPECT_EQ(errorOfGoal("[6.09, 0.5]"), "no error");  // the agent arrives at (5.8, 0.5)
  EXPECT_EQ(errorOfGoal("[1, 5]"), "no error");       // outside of the map
  EXPECT_EQ(errorOfGoal("[8, 0.5]", "0.31").find("no error"), std::string::npos);
}

/// Agents of some radii that are drawn beside a wall of 10 m.
Scenario drawnAgents(const std::vector<double>& radii) {
  Scenario scenario;
  scenario.walls = {{{0.0, 0.0}, {10.0, 0.0}}};
  for (const double radius : radii) {
    AgentGroup& group = scenario.agents.emplace_back();
    group.position.kind = Region::Kind::BOX;
    group.radius = {radius, radius};
  }
  return scenario;
}

/// A file could name any number of sizes, each of which would take the memory of a grid of the floor.
TEST(ScenarioReach, IsMadeForAsManySizesOfAgentsAsThereAreGridPoints) {
  Scenario scenario = drawnAgents({0.2, 0.3, 0.2});
  const YamlMap no_map(YAML::Load("{}"), {"s.yaml", 1, ""}, {"map", "free_radius"});
  double points = 0.0;
  readScenarioMap(no_map, scenario, points);
  EXPECT_EQ(scenario.agents[0].reach, nullptr);
  FloorPlan floor;
  floor.walls = scenario.walls;
  points = 1.5 * FloorReach::pointsOf(floor);
  readScenarioMap(no_map, scenario, points);
  ASSERT_NE(scenario.agents[0].reach, nullptr);
  EXPECT_EQ(scenario.agents[1].reach, nullptr);
  EXPECT_EQ(scenario.agents[2].reach, scenario.agents[0].reach);
  EXPECT_NEAR(points, 0.5 * FloorReach::pointsOf(floor), 1.0);
}

TEST(ScenarioReach, AndFreeSpaceStopOnRequest) {
  const YamlMap no_map(YAML::Load("{}"), {"s.yaml", 1, ""}, {"map", "free_radius"});
  Scenario scenario = drawnAgents({0.2});
  double points = 1e9;
  EXPECT_THROW(readScenarioMap(no_map, scenario, points, StopRequest([] { return true; })), Stopped);
  OccupancyMap map;
  map.resolution = 1.0;
  map.width = map.height = 3;
  map.cells.assign(9, CellState::FREE);
  FloorPlan floor;
  floor.walls = traceWalls(map);
  EXPECT_THROW(FreeSpace(map, floor, 0.2, StopRequest([] { return true; })), Stopped);
}

}  // namespace
}  // namespace crowd::scenario_map_test
