#include <gtest/gtest.h>

#include <algorithm>

#include "common/files/files.h"
#include "learning/q_table_file.h"
#include "social_crowd/errors.h"
#include "social_crowd/q_table.h"
#include "social_crowd/scenario.h"
#include "support/temporary_folder.h"

namespace crowd::library::files_test {
namespace {

TEST(LibraryQTable, IsLoadedByNameAndSavedBitForBit) {
  const TemporaryFolder folder;
  const QTable table = QTable::load("anticipation");
  table.save(folder.file("copy.txt"));
  EXPECT_EQ(readFile(folder.file("copy.txt")), readFile(SOURCE_DIR "/config/q_tables/anticipation.txt"));
  EXPECT_EQ(QTable::load(folder.file("copy.txt")).decisions(), table.decisions());
}

TEST(LibraryQTable, TellsWhatIsInIt) {
  const TrainedTable expected = loadQTable(SOURCE_DIR "/config/q_tables/anticipation.txt");
  const QTable table = QTable::load("anticipation");
  EXPECT_EQ(table.rows(), expected.table.rows());
  EXPECT_EQ(table.actions(), expected.table.actions());
  EXPECT_EQ(table.value(17, 3), expected.table.value(17, 3));
  EXPECT_EQ(table.decisions(), expected.decisions);
  EXPECT_EQ(table.model(), expected.model.spec());
  EXPECT_EQ(table.vision().radius, expected.model.vision().radius);
  EXPECT_EQ(table.vision().max_neighbours, expected.model.vision().max_neighbours);
  EXPECT_THROW(table.value(table.rows(), 0), InputError);
  EXPECT_THROW(table.value(0, table.actions()), InputError);
}

TEST(LibraryQTable, ErrorsNameTheFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(QTable::load("anticipatoin"), InputError);
  EXPECT_THROW(QTable::load(folder.file("missing.txt")), FileError);
  EXPECT_THROW(QTable::load(folder.write("damaged.txt", "state_set: {}\n")), InputError);
  EXPECT_THROW(QTable::load("anticipation").save(folder.file("missing/table.txt")), FileError);
}

TEST(LibraryScenario, IsLoadedByNameOrFileOrParsed) {
  const std::vector<std::string> names = Scenario::names();
  EXPECT_NE(std::find(names.begin(), names.end(), "circle6"), names.end());
  EXPECT_EQ(Scenario::load("circle6").size(), 1U);
  const std::string one =
      "name: a\nduration: 1\ngoal_tolerance: 0.1\nagents: [{position: [0, 0], goal: [3, 0], speed: 1, radius: 0.2}]\n";
  EXPECT_EQ(Scenario::parse(one + "---\n" + one, "two.yaml").size(), 2U);
  const TemporaryFolder folder;
  EXPECT_EQ(Scenario::load(folder.write("one.yaml", one)).size(), 1U);
}

TEST(LibraryScenario, ErrorsNameFileAndLine) {
  EXPECT_THROW(Scenario::load("circel6"), InputError);
  try {
    Scenario::parse(
        "name: a\nduration: long\ngoal_tolerance: 0.1\nagents: [{position: [0, 0], goal: [3, 0], speed: 1, radius: "
        "0.2}]\n",
        "mine.yaml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("mine.yaml"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace crowd::library::files_test
