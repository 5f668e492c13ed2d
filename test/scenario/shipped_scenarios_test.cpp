#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "scenario/reading/scenario_reader.h"
#include "support/overlaps.h"

#ifndef SOURCE_DIR
#error "SOURCE_DIR must be the package's root folder"
#endif

namespace crowd::shipped_scenarios_test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenarioFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The folder of the benchmark's scenes from the environment or the build; empty if there is none.
fs::path benchmarkFolder() {
  if (const char* const folder = std::getenv("BENCHMARK_SCENARIOS_DIR")) {
    return folder;
  }
#ifdef BENCHMARK_SCENARIOS_DIR
  return BENCHMARK_SCENARIOS_DIR;
#else
  return {};
#endif
}

std::vector<fs::path> shippedFiles() { return scenarioFiles(fs::path(SOURCE_DIR) / "config" / "scenarios"); }

bool isInThesisUnits(const fs::path& file) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line == "units: thesis") return true;
  }
  return false;
}

std::vector<fs::path> thesisFiles() {
  std::vector<fs::path> files;
  const std::vector<fs::path> shipped = shippedFiles();
  std::copy_if(shipped.begin(), shipped.end(), std::back_inserter(files), isInThesisUnits);
  return files;
}

TEST(ShippedScenarios, IncludeAllScenariosOfTheThesis) {
  std::vector<std::string> names;
  for (const fs::path& file : thesisFiles()) {
    names.push_back(file.stem().string());
  }
  for (const char* name : {"single_obstacle", "twins_a", "twins_b", "twins_c", "twins_d", "dummies", "circle6",
                           "circle6_obstacle", "line6", "line6_mover", "same_goal6", "same_goal6_mover", "circle12",
                           "circle12_varied", "training_single", "training_field"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

TEST(ShippedScenarios, HaveTheNamesOfTheirFiles) {
  for (const fs::path& file : shippedFiles()) {
    SCOPED_TRACE(file.string());
    const ScenarioList list = readScenarios(file.string());
    for (std::size_t i = 0; i < list.size(); ++i) {
      EXPECT_EQ(list[i].name, file.stem().string());
    }
  }
}

TEST(ShippedScenarios, BeginWithoutOverlapInEveryEpisode) {
  for (const fs::path& file : shippedFiles()) {
    const ScenarioList list = readScenarios(file.string());
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      for (std::uint64_t episode = 0; episode < 20; ++episode) {
        SCOPED_TRACE(file.string() + ", seed " + std::to_string(seed) + ", episode " + std::to_string(episode));
        const Scene scene = list.scene(seed, episode);
        EXPECT_FALSE(scenes::hasOverlap(scene));
        for (const AgentStart& agent : scene.agents) {
          if (agent.route || agent.leader) continue;  // its first goal is drawn when the episode begins
          EXPECT_GT((agent.goals.front() - agent.position).norm(), scene.goal_tolerance);
        }
      }
    }
  }
}

TEST(ShippedScenarios, InThesisUnitsHaveItsDurationAndSpeeds) {
  for (const fs::path& file : thesisFiles()) {
    SCOPED_TRACE(file.string());
    const Scene scene = readScenarios(file.string()).scene(1, 0);
    EXPECT_EQ(scene.max_ticks, 2000U);
    for (const AgentStart& agent : scene.agents) {
      const double step = agent.max_speed * scene.tick_duration;
      EXPECT_TRUE(step >= 0.02 - 1e-12 && step <= 0.04 + 1e-12) << step;
      EXPECT_EQ(agent.radius, 0.25);
    }
  }
}

TEST(BenchmarkScenarios, CanAllBeRead) {
  const fs::path folder = benchmarkFolder();
  if (folder.empty() || !fs::is_directory(folder)) {
    GTEST_SKIP() << "BENCHMARK_SCENARIOS_DIR names no folder";
  }
  const std::vector<fs::path> files = scenarioFiles(folder);
  EXPECT_EQ(files.size(), 18U);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    const ScenarioList list = readScenarios(file.string());
    EXPECT_EQ(list.size(), 50U);
    for (std::size_t i = 0; i < list.size(); ++i) {
      EXPECT_EQ(list[i].name, file.stem().string());
      EXPECT_FALSE(scenes::hasOverlap(list.scene(1, i)));
    }
  }
}

}  // namespace
}  // namespace crowd::shipped_scenarios_test
