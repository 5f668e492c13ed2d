#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "scenario/reading/scenario_reader.h"
#include "support/straight_walk.h"
#include "support/temporary_folder.h"

namespace crowd::population_map_test {
namespace {

/// Two rooms, each 4 m x 4 m, left (x from 0.5 to 4.5 m) and right (x from 5 to 9 m), without a door between them.
class TwoRooms : public testing::Test {
 protected:
  TwoRooms() {
    std::ofstream image(folder_.file("rooms.pgm"));
    image << "P2\n19 10\n255\n";
    for (int row = 0; row < 10; ++row) {
      for (int column = 0; column < 19; ++column) {
        const bool wall = row == 0 || row == 9 || column == 0 || column == 9 || column == 18;
        image << (wall ? "0 " : "255 ");
      }
      image << "\n";
    }
    std::ofstream(folder_.file("rooms.yaml")) << "image: rooms.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
                                                 "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
  }

  Scene sceneOf(const std::string& keys, std::uint64_t seed) const {
    const std::string head = "name: n\nduration: 60\ngoal_tolerance: 0.2\nmap: rooms.yaml\n";
    return parseScenarios(head + keys, folder_.file("s.yaml")).scene(seed, 0);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(TwoRooms, AgentsStartWhereTheyCanReachTheirRoute) {
  const std::string keys =
      "agents: [{count: 4, position: {map: free}, route: out, speed: 1, radius: 0.2}]\n"
      "sources: [{area: {map: free}, rate: 1, route: out, speed: 1, radius: 0.2}, {area: {map: free}, rate: 1, goal: "
      "[2, 2], speed: 1, radius: 0.2}]\n"
      "routes: {out: {waypoints: [{place: {map: free}}, {sink: right}]}}\n"
      "sinks: {right: {area: {box: [[8, 1], [9, 4]]}}}\n";
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Episode episode(sceneOf(keys, seed), 0, Vision());
    while (episode.world().time() < 15.0) {
      for (const Agent& agent : episode.world().agents()) {
        if (!agent.isWalking()) continue;
        EXPECT_EQ(agent.pose.position.x() > 4.75, agent.goal().x() > 4.75) << "seed " << seed << ", agent " << agent.id;
      }
      straight_walk::step(episode);
    }
    EXPECT_GT(episode.world().enteredCount(), 15U) << "seed " << seed;
  }
}

TEST_F(TwoRooms, GoalsAnywhereAreInTheSameRoom) {
  const std::string keys =
      "agents: [{position: [2, 2], route: rounds, speed: 2, radius: 0.2}, {position: [7, 2], route: rounds, speed: 2, "
      "radius: 0.2}]\n"
      "routes: {rounds: {repeat: true, waypoints: [{place: {map: free}}]}}\n";
  Episode episode(sceneOf(keys, 3), 0, Vision());
  while (!episode.isOver()) {
    EXPECT_LT(episode.world().agents()[0].goal().x(), 4.3);
    EXPECT_GT(episode.world().agents()[1].goal().x(), 5.2);
    straight_walk::step(episode);
  }
  for (const AgentResult& agent : episode.result().agents) EXPECT_GT(agent.waypoints, 10U);
}

}  // namespace
}  // namespace crowd::population_map_test
