// Errors of Q-table files tell nothing of what the files contain while quotes are hidden.

#include <gtest/gtest.h>

#include <string>

#include "common/files/files.h"
#include "common/text/quotes.h"
#include "learning/q_table_file.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"

namespace crowd::hidden_q_tables_test {
namespace {

constexpr const char* SECRET = "sEcReT";

const std::string FOLDER = std::string(SOURCE_DIR) + "/config/q_tables/";

TEST(HiddenQTables, NoWordIsInAnError) {
  const std::string text = readFile(FOLDER + "thesis_nearest.txt");
  const std::string separators = " \n:,{}[]";
  int errors = 0;
  for (std::size_t begin = text.find_first_not_of(separators); begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    const std::string changed = text.substr(0, begin) + SECRET + text.substr(end);
    const HiddenQuotes hidden;
    const std::string problem = errorOf<Error>([&] { parseQTable(changed, "file.txt"); });
    EXPECT_FALSE(contains(problem, SECRET)) << problem;
    errors += problem == "no error" ? 0 : 1;
    begin = text.find_first_not_of(separators, end);
  }
  EXPECT_GT(errors, 500);
}

TEST(HiddenQTables, AnotherModelIsNotTold) {
  const TrainedTable expected = loadQTable(FOLDER + "thesis_nearest.txt");
  const TrainedTable got = loadQTable(FOLDER + "thesis_occupancy.txt");
  const auto problem = [&] { return errorOf<ShapeError>([&] { requireFit(expected.model, got.model, "file.txt"); }); };
  EXPECT_TRUE(contains(problem(), got.model.state_set->spec()));
  const HiddenQuotes hidden;
  EXPECT_EQ(problem(), "file.txt: was learned for another state set or action set than\n" + expected.model.spec());
}

}  // namespace
}  // namespace crowd::hidden_q_tables_test
