#include "simulation/evaluation/trajectory.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "common/files/files.h"
#include "common/text/numbers.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/scenes.h"
#include "support/temporary_folder.h"
#include "support/worlds.h"
#include "world/world_editor.h"

namespace crowd::trajectory_test {
namespace {

using scenes::agent;
using scenes::scene;
using scenes::wanderer;

TEST(Trajectory, WritesASmallRun) {
  // Agent 0 arrives in tick 2, agent 1 in tick 3; agent 2 is removed after tick 1.
  World world(scenes::halfSeconds(
      scene({agent({0.0, 0.0}, {1.0, 0.0}, 1.0), agent({-1.25, 3.0}, {1.75, 3.0}, 2.0), wanderer({0.0, -3.0})})));
  std::string rows;
  appendTrajectoryRows(7, world, rows);
  world.step({ahead(0), ahead(1)});
  appendTrajectoryRows(7, world, rows);
  WorldEditor(world).removeAgent(2);
  for (int i = 0; i < 3; ++i) {
    world.step({ahead(0), ahead(1)});
    appendTrajectoryRows(7, world, rows);
  }
  EXPECT_EQ(rows,
            "7,0,0,0,0\n"
            "7,0,1,-1.25,3\n"
            "7,0,2,0,-3\n"
            "7,1,0,0.5,0\n"
            "7,1,1,-0.25,3\n"
            "7,1,2,0,-3\n"
            "7,2,0,1,0\n"
            "7,2,1,0.75,3\n"
            "7,3,1,1.75,3\n");
}

TEST(Trajectory, NumbersReadBackBitForBit) {
  World world(scenes::randomScene(5));
  KeyedRandom random(5, KeyedRandom::EXPLORATION, {});
  world.step(scenes::randomActions(world, random));
  std::string rows;
  appendTrajectoryRows(0, world, rows);
  std::istringstream lines(rows);
  std::string line;
  for (const Agent& walker : world.agents()) {
    if (!walker.isWalking() && walker.arrival_tick != world.tick()) continue;
    ASSERT_TRUE(std::getline(lines, line));
    const std::size_t y = line.rfind(',') + 1;
    const std::size_t x = line.rfind(',', y - 2) + 1;
    EXPECT_EQ(toNumber(line.substr(x, y - 1 - x)), walker.pose.position.x()) << line;
    EXPECT_EQ(toNumber(line.substr(y)), walker.pose.position.y()) << line;
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(TrajectoryFile, ContainsHeaderAndAppendedRows) {
  const TemporaryFolder folder;
  TrajectoryFile file(folder.file("deep/down"), "circle6");  // creates the folders
  const std::string path = folder.file("deep/down/circle6.csv");
  EXPECT_EQ(readFile(path), "instance,tick,agent,x,y\n");
  file.append("0,0,0,1.5,2\n");
  EXPECT_EQ(readFile(path), "instance,tick,agent,x,y\n0,0,0,1.5,2\n");  // written at once, not when the file is closed
  file.append("1,0,0,3,4\n1,1,0,3,4\n");
  EXPECT_EQ(readFile(path), "instance,tick,agent,x,y\n0,0,0,1.5,2\n1,0,0,3,4\n1,1,0,3,4\n");
}

TEST(TrajectoryFile, ReplacesAnOlderFile) {
  const TemporaryFolder folder;
  folder.write("line6.csv", "left over from a longer run, much longer than the header\n");
  const TrajectoryFile file(folder.path(), "line6");
  EXPECT_EQ(readFile(folder.file("line6.csv")), TRAJECTORY_HEADER);
}

/// The message of the FileError of a trajectory file to which a row is appended.
std::string fileError(const std::string& folder, const std::string& name) {
  return errorOf<FileError>([&] { TrajectoryFile(folder, name).append("0,0,0,0,0\n"); });
}

void expectContains(const std::string& text, const std::string& part) {
  EXPECT_TRUE(contains(text, part)) << "'" << text << "' lacks '" << part << "'";
}

TEST(TrajectoryFile, ReportsAFolderThatCannotBeCreated) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a_file", "no folder");
  const std::string message = fileError(file + "/below", "line6");
  expectContains(message, file + "/below");
  expectContains(message, "Not a directory");
}

TEST(TrajectoryFile, ReportsAFileThatCannotBeOpened) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("line6.csv"));
  const std::string message = fileError(folder.path(), "line6");
  expectContains(message, "line6.csv");
  expectContains(message, "Is a directory");
}

TEST(TrajectoryFile, ReportsAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/full", folder.file("line6.csv"));
  const std::string message = fileError(folder.path(), "line6");
  expectContains(message, "line6.csv");
  expectContains(message, "No space left on device");
}

}  // namespace
}  // namespace crowd::trajectory_test
