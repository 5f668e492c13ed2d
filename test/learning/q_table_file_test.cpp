#include "learning/q_table_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "common/random.h"
#include "support/error_of.h"
#include "support/q_table_texts.h"
#include "support/temporary_folder.h"

namespace crowd::q_table_file_test {
namespace {

using Names = std::vector<std::string>;
using Limits = std::numeric_limits<double>;

/// A random finite double; every fourth is subnormal.
double anyDouble(KeyedRandom& random) {
  for (;;) {
    const std::uint64_t mask = random.below(4) == 0 ? 0x800FFFFFFFFFFFFFULL : UINT64_MAX;
    const std::uint64_t bits = random.next() & mask;
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) return value;
  }
}

void expectSame(const TrainedTable& read, const TrainedTable& written) {
  EXPECT_EQ(read.model.spec(), written.model.spec());
  EXPECT_EQ(read.parameters.alpha, written.parameters.alpha);
  EXPECT_EQ(read.parameters.gamma, written.parameters.gamma);
  EXPECT_EQ(read.parameters.lambda, written.parameters.lambda);
  EXPECT_EQ(read.parameters.epsilon, written.parameters.epsilon);
  EXPECT_EQ(read.decisions, written.decisions);
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_TRUE(read.table == written.table);
}

void expectRoundTrip(const TrainedTable& trained) {
  const std::string text = toText(trained);
  const TrainedTable read = parseQTable(text, "table.txt");
  expectSame(read, trained);
  EXPECT_EQ(toText(read), text);
}

TEST(QTableText, WritesTheExpectedText) { EXPECT_EQ(toText(q_table_texts::trained()), q_table_texts::text()); }

TEST(QTableText, ReadsTheExpectedText) {
  expectSame(parseQTable(q_table_texts::text(), "table.txt"), q_table_texts::trained());
}

/// Its rows would take memory, so they are not read.
TEST(QTableText, ThatDoesNotFitTheExpectedModelIsRefusedBeforeItsRows) {
  const Model expected = q_table_texts::trained().model;
  expectSame(parseQTable(q_table_texts::text(), "table.txt", &expected), q_table_texts::trained());
  std::string large = q_table_texts::text();
  large.replace(large.find("[180]"), 5, "[45, 180]");
  large.replace(large.find("rows: 11"), 8, "rows: 19");
  large.replace(large.find("---\n") + 4, std::string::npos, "no row\n");
  const std::string problem = errorOf<InputError>([&] { parseQTable(large, "table.txt"); });
  EXPECT_NE(problem.find("expected a row number"), std::string::npos) << problem;
  EXPECT_THROW(parseQTable(large, "table.txt", &expected), ShapeError);
}

TEST(QTableText, WritesTiesUnlessTheyAreBrokenByTheFirst) {
  EXPECT_EQ(parseQTable(q_table_texts::text(), "table.txt").parameters.ties, Ties::FIRST);
  TrainedTable trained = q_table_texts::trained();
  trained.parameters.ties = Ties::RANDOM;
  std::string expected = q_table_texts::body();
  expected.replace(expected.find("epsilon: 0\n"), 0, "ties: random\n");
  EXPECT_EQ(toText(trained), q_table_texts::withChecksum(expected));
  EXPECT_EQ(parseQTable(toText(trained), "table.txt").parameters.ties, Ties::RANDOM);
  expectRoundTrip(trained);
}

/// The sources of a table in a form that can be compared.
std::vector<std::pair<SourceId, std::vector<std::uint32_t>>> sourcesOf(const QTable& table) {
  std::vector<std::pair<SourceId, std::vector<std::uint32_t>>> sources;
  for (const Contribution& contribution : table.contributions()) {
    sources.push_back({contribution.source, {}});
    for (std::size_t i = 0; i < contribution.visits->rows().size(); ++i) {
      std::vector<std::uint32_t>& numbers = sources.back().second;
      numbers.push_back(contribution.visits->rows()[i]);
      numbers.insert(numbers.end(), contribution.visits->at(i), contribution.visits->at(i) + table.actions());
    }
  }
  return sources;
}

TEST(QTableSources, AreWrittenAsExpected) {
  EXPECT_EQ(toText(q_table_texts::trainedBySources()), q_table_texts::textWithSources());
}

TEST(QTableSources, AreReadBack) {
  const TrainedTable read = parseQTable(q_table_texts::textWithSources(), "table.txt");
  expectSame(read, q_table_texts::trainedBySources());
  EXPECT_EQ(sourcesOf(read.table), sourcesOf(q_table_texts::trainedBySources().table));
  EXPECT_EQ(read.table.source(), 0xFFU);
  expectRoundTrip(q_table_texts::trainedBySources());
}

TEST(QTableSources, AreOmittedIfTheReaderCanDeriveThem) {
  TrainedTable trained = q_table_texts::trained();
  trained.table.nameSource(trained.table.contentId());
  EXPECT_EQ(toText(trained), q_table_texts::text());
  trained.table.beginSource();  // all visits are now foreign, of a source that is identified by the content
  EXPECT_EQ(toText(trained), q_table_texts::text());
  EXPECT_EQ(sourcesOf(parseQTable(toText(trained), "table.txt").table), sourcesOf(trained.table));
}

TEST(QTableSources, SingleSourceIsWrittenAsAName) {
  TrainedTable trained = q_table_texts::trained();
  trained.table.nameSource(0x1234);
  const std::string text = toText(trained);
  EXPECT_TRUE(contains(text, "seed: 7\nsource: '0000000000001234'\nvisited_rows: 3\n")) << text;
  expectRoundTrip(trained);
  trained.table.beginSource();
  EXPECT_EQ(toText(trained), text);
}

TEST(QTableText, ReadsAnEmptyTable) {
  TrainedTable trained = q_table_texts::trained();
  trained.table = QTable(11, 2);
  EXPECT_TRUE(contains(toText(trained), "visited_rows: 0\n---\nchecksum: "));
  expectRoundTrip(trained);
}

TEST(QTableText, HasAGreatestSize) {
  for (TrainedTable trained : {q_table_texts::trained(), q_table_texts::trainedBySources()}) {
    const std::uint64_t most = maxTextSize(trained);
    for (Row row = 0; row < trained.table.rows(); ++row) {
      for (Action action = 0; action < trained.table.actions(); ++action) {
        trained.table.set(row, action, -Limits::max(), UINT32_MAX);
      }
    }
    trained.parameters = {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
    trained.decisions = UINT64_MAX;
    trained.seed = UINT64_MAX;
    const std::size_t size = toText(trained).size();
    EXPECT_LE(size, most);
    EXPECT_GT(size, most / 2);
  }
}

TEST(QTableText, ReadsBackBitForBit) {
  TrainedTable trained = q_table_texts::trained();
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    trained.table = QTable(11, 2);
    for (Row row = 0; row < 11; ++row) {
      if (random.below(3) == 0) continue;
      const double value = anyDouble(random);
      trained.table.set(row, 0, value, 1 + random.below(UINT32_MAX));
      trained.table.set(row, 1, anyDouble(random), random.below(5));
    }
    trained.parameters = {1.0 - random.uniform(), random.uniform(), random.uniform(), random.uniform()};
    trained.decisions = random.next() >> 1U;
    trained.seed = random.next() >> 1U;
    expectRoundTrip(trained);
  }
}

TEST(QTableText, ReadsBackExtremeValues) {
  TrainedTable trained = q_table_texts::trained();
  trained.table.set(0, 0, -0.0, 1);
  trained.table.set(1, 0, Limits::max(), UINT32_MAX);
  trained.table.set(1, 1, Limits::lowest(), 1);
  trained.table.set(2, 0, Limits::denorm_min(), 1);
  trained.table.set(2, 1, -Limits::denorm_min(), 1);
  trained.table.set(4, 0, Limits::min(), 1);
  trained.table.set(4, 1, std::nextafter(1.0, 2.0), 1);
  expectRoundTrip(trained);
}

TEST(QTableText, ReadsBackAnySeedAndNumberOfDecisions) {
  TrainedTable trained = q_table_texts::trained();
  trained.seed = UINT64_MAX;
  trained.decisions = UINT64_MAX;
  expectRoundTrip(trained);
}

TEST(QTableText, ReadsBackValuesWithoutVisits) {
  TrainedTable trained = q_table_texts::trained();
  trained.table.set(5, 1, 2.5, 0);
  expectRoundTrip(trained);
  trained.table.set(5, 1, -0.0, 0);
  expectRoundTrip(trained);
}

TEST(QTableText, ReadsBackTablesOfTheThesis) {
  for (const char* const state_set : {"{type: nearest_obstacle}", "{type: occupancy}"}) {
    const Model model = parseModel("{state_set: " + std::string(state_set) +
                                   ", action_set: {type: kings_moves}, "
                                   "reward: {goal: distance_gained, obstacle_cost: 10}}");
    QTable table(model.state_set->rowCount(), 8);
    KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
    for (Row row = 0; row < table.rows(); row += 1 + random.below(20)) {
      table.set(row, random.below(8), random.uniform(-100.0, 100.0), 1 + random.below(9));
    }
    expectRoundTrip({model, {}, 1, 2, table});
  }
}

TEST(QTableText, WritesOnlyVisitedRows) {
  TrainedTable trained = q_table_texts::trained();
  trained.table = QTable(11, 2);
  trained.table.set(4, 1, 0.0, 1);  // visited, and still zero
  trained.table.set(9, 0, 1.0, 1);
  EXPECT_TRUE(contains(toText(trained), "visited_rows: 2\n---\n4 0 0 1 0\n9 1 1 0 0\nchecksum: "));
}

TEST(QTableText, RefusesNonFiniteValues) {
  for (const double value : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    TrainedTable trained = q_table_texts::trained();
    trained.table.set(3, 1, value, 1);
    const std::string message = errorOf<InputError>([&] { toText(trained); });
    EXPECT_TRUE(contains(message, "row 3, action 1")) << message;
  }
}

TEST(QTableFile, ReadsBackWhatWasSaved) {
  const TemporaryFolder folder;
  saveQTable(folder.file("table.txt"), q_table_texts::trained());
  expectSame(loadQTable(folder.file("table.txt")), q_table_texts::trained());
  EXPECT_EQ(folder.names(), Names{"table.txt"});
}

TEST(QTableFile, ReplacesAnOlderFile) {
  const TemporaryFolder folder;
  const std::string file = folder.write("table.txt", "something much longer" + std::string(100000, '.'));
  saveQTable(file, q_table_texts::trained());
  expectSame(loadQTable(file), q_table_texts::trained());
  EXPECT_EQ(folder.names(), Names{"table.txt"});
}

TEST(QTableFile, KeepsTheOlderFileIfTheTableIsInvalid) {
  const TemporaryFolder folder;
  saveQTable(folder.file("table.txt"), q_table_texts::trained());
  TrainedTable broken = q_table_texts::trained();
  broken.table.set(0, 0, Limits::quiet_NaN(), 1);
  EXPECT_THROW(saveQTable(folder.file("table.txt"), broken), InputError);
  expectSame(loadQTable(folder.file("table.txt")), q_table_texts::trained());
  EXPECT_EQ(folder.names(), Names{"table.txt"});
}

TEST(QTableFile, ReportsPathsThatCannotBeWritten) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("taken"));
  for (const std::string& file : {folder.file("none/table.txt"), folder.file("taken")}) {
    const std::string message = errorOf<FileError>([&] { saveQTable(file, q_table_texts::trained()); });
    EXPECT_TRUE(contains(message, file)) << message;
  }
  EXPECT_EQ(folder.names(), Names{"taken"});
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("taken")));
}

TEST(QTableFile, ErrorsNameMissingAndDamagedFiles) {
  const TemporaryFolder folder;
  const std::string missing = folder.file("missing.txt");
  EXPECT_TRUE(contains(errorOf<FileError>([&] { loadQTable(missing); }), missing));
  const std::string damaged = folder.write("damaged.txt", q_table_texts::text() + "more\n");
  const std::string message = errorOf<InputError>([&] { loadQTable(damaged); });
  EXPECT_EQ(message.rfind(damaged + ": line ", 0), 0U) << message;
}

}  // namespace
}  // namespace crowd::q_table_file_test
