#include "learning/q_table_names.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "learning/q_table_file.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/temporary_folder.h"

namespace crowd::q_table_names_test {
namespace {

TEST(QTableNames, AreThoseOfShippedTables) {
  const std::string file = findQTable("anticipation");
  EXPECT_EQ(file, std::string(SOURCE_DIR) + "/config/q_tables/anticipation.txt");
  EXPECT_EQ(findQTable("anticipation.txt"), file);
  EXPECT_GT(loadQTable(file).table.visitedRows(), 0U);
}

TEST(QTableNames, PathsAreNotChanged) {
  EXPECT_EQ(findQTable("/none/anticipation.txt"), "/none/anticipation.txt");
  EXPECT_EQ(findQTable("./anticipation"), "./anticipation");
}

TEST(QTableNames, AFileTakesPrecedence) {
  const TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  std::ofstream("anticipation.txt") << "mine";
  EXPECT_EQ(findQTable("anticipation.txt"), "anticipation.txt");
  std::filesystem::current_path(before);
}

TEST(QTableNames, RelativePathsStartAtTheBaseFolder) {
  const TemporaryFolder folder;
  const std::string file = folder.write("anticipation.txt", "mine");
  EXPECT_EQ(findQTable("anticipation.txt", folder.path()), file);
  EXPECT_EQ(findQTable("./none.txt", folder.path()), folder.file("none.txt"));
  EXPECT_EQ(findQTable("human", folder.path()), std::string(SOURCE_DIR) + "/config/q_tables/human.txt");
}

TEST(QTableNames, AnUnknownNameIsRefusedWithTheNearest) {
  const std::string error = errorOf<InputError>([] { findQTable("anticipatoin"); });
  EXPECT_NE(error.find("no Q-table 'anticipatoin', did you mean 'anticipation'? There is no file /"), std::string::npos)
      << error;
  EXPECT_NE(error.find("human"), std::string::npos) << error;
}

}  // namespace
}  // namespace crowd::q_table_names_test
