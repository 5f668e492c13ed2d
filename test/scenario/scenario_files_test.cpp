#include "scenario/reading/scenario_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/temporary_folder.h"

namespace crowd::scenario_files_test {
namespace {

const std::string SHIPPED = std::string(SOURCE_DIR) + "/config/scenarios";

TEST(ScenarioFiles, ShippedScenariosAreInTheSourceTreeBeforeInstallation) { EXPECT_EQ(shippedScenarios(), SHIPPED); }

TEST(ScenarioFiles, FindsShippedScenariosByName) {
  EXPECT_EQ(findScenario("circle6"), SHIPPED + "/circle6.yaml");
  EXPECT_EQ(findScenario("circle6.yaml"), SHIPPED + "/circle6.yaml");
}

TEST(ScenarioFiles, FindsNamesInFoldersOfTheFolder) {
  EXPECT_EQ(findScenario("robot_hall"), SHIPPED + "/robots/robot_hall.yaml");
  const std::vector<std::string> names = scenarioNames();
  for (const char* const name : {"circle6", "robot_hall"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.file("b/c"));
  std::filesystem::create_directory(folder.file("a"));
  folder.write("b/c/deep.yaml", "");
  const std::string second = folder.write("b/mine.yaml", "");
  EXPECT_EQ(findScenario("mine", "", folder.path()), second);
  const std::string first = folder.write("a/mine.yaml", "");
  EXPECT_EQ(findScenario("mine", "", folder.path()), first);
  const std::string own = folder.write("mine.yaml", "");
  EXPECT_EQ(findScenario("mine", "", folder.path()), own);
  EXPECT_EQ(scenarioNames(folder.path()), std::vector<std::string>{"mine"});
  EXPECT_THROW(findScenario("deep", "", folder.path()), InputError);
}

TEST(ScenarioFiles, PrefersAFileToAName) {
  const TemporaryFolder folder;
  const std::string file = folder.write("circle6", "");
  EXPECT_EQ(findScenario("circle6", folder.path()), file);
  EXPECT_EQ(findScenario(file), file);
  std::filesystem::create_directory(folder.file("line6"));  // a folder is no file
  EXPECT_EQ(findScenario("line6", folder.path()), SHIPPED + "/line6.yaml");
}

TEST(ScenarioFiles, RelativePathsStartAtTheBaseFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("sub"));
  const std::string file = folder.write("sub/mine.yaml", "");
  EXPECT_EQ(findScenario("sub/mine.yaml", folder.path()), file);
  EXPECT_EQ(findScenario("../sub/mine.yaml", folder.file("sub")), file);
}

TEST(ScenarioFiles, FindsNamesInAnotherFolder) {
  const TemporaryFolder folder;
  const std::string file = folder.write("mine.yaml", "");
  EXPECT_EQ(findScenario("mine", "", folder.path()), file);
  EXPECT_EQ(errorOf<InputError>([&] { findScenario("mien", "/nowhere", folder.path()); }),
            "no scenario 'mien', did you mean 'mine'? There is no file /nowhere/mien, and in " + folder.path() +
                " none of that name; there is mine");
}

TEST(ScenarioFiles, ErrorProposesAFileOfTheBaseFolder) {
  const TemporaryFolder named;
  named.write("mine.yaml", "");
  const TemporaryFolder base;
  base.write("my_hall.yaml", "");
  const auto proposal = [&](const std::string& name) {
    return errorOf<InputError>([&] { findScenario(name, base.path(), named.path()); });
  };
  EXPECT_NE(proposal("my_hal.yaml").find("did you mean 'my_hall.yaml'?"), std::string::npos);
  EXPECT_NE(proposal("my_hal").find("did you mean 'my_hall.yaml'?"), std::string::npos);
  EXPECT_NE(proposal("mien").find("did you mean 'mine'?"), std::string::npos);
}

TEST(ScenarioFiles, ErrorNamesSearchedPlacesAndAlternatives) {
  const TemporaryFolder folder;
  const std::string bare = errorOf<InputError>([&] { findScenario("circel12"); });
  const std::string here = std::filesystem::current_path().string();
  EXPECT_EQ(bare.find("no scenario 'circel12', did you mean 'circle12'? There is no file " + here +
                      "/circel12, and in " + SHIPPED + " none of that name; there are circle12, circle6, "),
            0U)
      << bare;
  folder.write("b.yaml", "");
  folder.write("corner.yaml", "");
  EXPECT_EQ(errorOf<InputError>([&] { findScenario(folder.file("corer.yaml")); }),
            "no scenario '" + folder.file("corer.yaml") + "', did you mean '" + folder.file("corner.yaml") +
                "'? There is no file " + folder.file("corer.yaml") + "; there are " + folder.file("corner.yaml") +
                ", " + folder.file("b.yaml"));
  const std::string base = std::filesystem::path(folder.path()).parent_path().string();
  const std::string below = std::filesystem::path(folder.path()).filename().string();
  const std::string relative = errorOf<InputError>([&] { findScenario(below + "/corner", base); });
  EXPECT_EQ(relative, "no scenario '" + below + "/corner', did you mean '" + below +
                          "/corner.yaml'? There is no file " + folder.file("corner") + "; there are " + below +
                          "/corner.yaml, " + below + "/b.yaml");
  const std::string elsewhere = errorOf<InputError>([&] { findScenario("no/such.yaml", "/base"); });
  EXPECT_EQ(elsewhere, "no scenario 'no/such.yaml': there is no file /base/no/such.yaml");
}

}  // namespace
}  // namespace crowd::scenario_files_test
