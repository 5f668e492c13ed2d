#include "training/checkpoint.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/files/checksum.h"
#include "common/files/files.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/temporary_folder.h"
#include "training/record.h"

namespace crowd::checkpoint_test {
namespace {

/// Two agents that cross a ring and keep their headings between episodes, 20 ticks at most.
const char* const PAIR =
    "name: pair\nduration: 2\ngoal_tolerance: 0.3\n"
    "agents: [{count: 2, position: {ring: {centre: [0, 0], radius: [1, 2]}}, goal: {opposite: [0, 0]}, speed: 1.2,\n"
    "          radius: 0.2, heading: kept}]\n";

class CheckpointTest : public testing::Test {
 protected:
  CheckpointTest() { folder_.write("s.yaml", PAIR); }

  TrainingConfig config(const std::string& training = "tables: shared", const std::string& learning = "lambda: 0",
                        std::uint64_t episodes = 12) const {
    return readTrainingConfig(folder_.write("config.yaml",
                                            "state_set: {type: nearest_obstacle}\n"
                                            "action_set: {type: kings_moves}\n"
                                            "reward: {goal: cosine_cubed, obstacle_cost: 80}\n"
                                            "learning: {gamma: 0.5, epsilon: {from: 0.5, to: 0.1, episodes: 20}, " +
                                                learning + "}\ntraining: {scenarios: [s.yaml], seed: 5, episodes: " +
                                                std::to_string(episodes) + ", " + training + "}\n"));
  }

  /// Runs turns until this number of episodes is done. Returns the rows of their log.
  static std::string run(Training& training, std::uint64_t episodes) {
    std::string rows;
    while (training.episode() < episodes) {
      std::uint64_t episode = training.episode();
      for (const LearnedEpisode& learned : training.runNextTurn()) appendLogRow(episode++, learned, rows);
    }
    return rows;
  }

  /// Everything that a training gives: its table, and with own tables also that of agent 1.
  static std::string resultOf(const Training& training) {
    TrainedTable second = training.trained();
    second.table = training.learner().tables().of(1);
    return toText(training.trained()) + toText(second);
  }

  /// The checkpoint after some episodes.
  static std::string checkpointOf(const Training& training) {
    return toText(Checkpoint{identityOf(training), {{"--log", 17}}, training.state()});
  }

  static Checkpoint parse(const std::string& text, const Training& training) {
    return parseCheckpoint(text, "c.txt", identityOf(training), training.config().model);
  }

  std::string errorFor(const std::string& text, const TrainingConfig& config) const {
    const Training training(config);
    return errorOf<InputError>([&] { parse(text, training); });
  }

  TemporaryFolder folder_;
};

TEST_F(CheckpointTest, TheTrainingGoesOnAsWithoutAnInterruption) {
  for (const TrainingConfig& config :
       {config(), config("tables: shared", "lambda: 0.8"), config("tables: own", "lambda: 0.8, mirrored: true"),
        config("side_by_side: 2, turn: 3", "alpha: 0.01, alpha_decay: 0.6")}) {
    Training whole(config, 2);
    whole.countVisitedRows();
    run(whole, 6);
    const std::string rest = run(whole, 12);
    Training first(config);
    run(first, 6);
    const std::string text = checkpointOf(first);
    Training second(config, 2);
    second.countVisitedRows();
    const Checkpoint checkpoint = parse(text, second);
    EXPECT_EQ(checkpoint.sizes.at("--log"), 17U);
    EXPECT_EQ(toText(checkpoint), text);
    second.restore(checkpoint.state);
    EXPECT_EQ(second.episode(), 6U);
    EXPECT_EQ(second.decisions(), first.decisions());
    EXPECT_EQ(resultOf(second), resultOf(first));
    EXPECT_EQ(run(second, 12), rest);
    EXPECT_EQ(resultOf(second), resultOf(whole));
  }
}

TEST_F(CheckpointTest, KeepsTheSourcesOfATableThatTheTrainingBeganWith) {
  for (const char* const tables : {"tables: shared", "tables: own"}) {
    Training before(config());
    run(before, 12);
    TrainedTable begin = before.trained();
    Training other(config("tables: shared", "lambda: 0", 5));
    run(other, 5);
    begin.table.merge(other.trained().table);
    Training whole(config(tables), begin);
    run(whole, 12);
    Training first(config(tables), begin);
    run(first, 4);
    Training second(config(tables));
    second.restore(parse(checkpointOf(first), second).state);
    EXPECT_EQ(second.decisions(), first.decisions());
    EXPECT_EQ(second.learner().tables().of(0).foreign().size(), 2U);
    run(second, 12);
    EXPECT_EQ(resultOf(second), resultOf(whole));
  }
}

TEST_F(CheckpointTest, RefusesDamagedTexts) {
  Training training(config("tables: own"));
  run(training, 2);
  const std::string text = checkpointOf(training);
  ASSERT_EQ(errorOf<InputError>([&] { parse(text, training); }), "no error");
  for (std::size_t size = 0; size < text.size(); ++size) {
    ASSERT_THROW(parse(text.substr(0, size), training), InputError) << size;
  }
  for (std::size_t place = 0; place < text.size(); ++place) {
    std::string damaged = text;
    damaged[place] = static_cast<char>(damaged[place] ^ 1);
    ASSERT_THROW(parse(damaged, training), InputError) << place;
  }
  EXPECT_TRUE(contains(errorOf<InputError>([&] { parse(text + "\n", training); }),
                       "c.txt: the checkpoint was damaged or cut short"));
  EXPECT_TRUE(contains(errorOf<InputError>([&] { parse("social_crowd Q-table 1\n", training); }),
                       "c.txt: line 1: expected 'social_crowd checkpoint 1'"));
}

/// Each of them takes the memory of a table, however short its text is.
TEST_F(CheckpointTest, RefusesTwoTablesOfAnAgent) {
  const Training training(config("tables: own"));
  std::string text = checkpointOf(training);
  text.replace(text.find("own_tables 0\n"), std::string::npos, "own_tables 2\n1 0\n1 0\n");
  Checksum checksum;
  checksum.add(text);
  text += "checksum: " + checksum.text() + "\n";
  EXPECT_TRUE(contains(errorOf<InputError>([&] { parse(text, training); }),
                       "expected an agent above the one before and its number of rows, got 1"));
}

TEST_F(CheckpointTest, NamesTheFirstDifferenceToAnotherTraining) {
  Training training(config());
  run(training, 2);
  const std::string text = checkpointOf(training);
  TrainingConfig other = config();
  other.training.seed = 6;
  EXPECT_EQ(errorFor(text, other),
            "c.txt: is the checkpoint of another training: it has 'seed: 5', the training has 'seed: 6'");
  EXPECT_TRUE(contains(errorFor(text, config("tables: own")), "'tables: shared', the training has 'tables: own'"));
  EXPECT_TRUE(contains(errorFor(text, config("side_by_side: 2")), "'side_by_side: 1', the training has "));
  EXPECT_TRUE(contains(errorFor(text, config("tables: shared", "alpha: 0.2")), "alpha: 0.2"));
  EXPECT_EQ(errorFor(text, config("tables: shared, save_every: 2", "lambda: 0", 99)), "no error");
  folder_.write("s.yaml", std::string(PAIR) + "# changed\n");
  EXPECT_TRUE(contains(errorFor(text, config()), "the training has 'scenario: s, checksum "));
}

TEST_F(CheckpointTest, NamesAChangedMap) {
  const auto map = [&](const char* cells) { return folder_.write("map.pgm", std::string("P2 3 1 255 ") + cells); };
  folder_.write("map.yaml",
                "{image: map.pgm, resolution: 9, origin: [-13.5, -4.5, 0], negate: 0, occupied_thresh: 0.65,\n"
                " free_thresh: 0.196}\n");
  folder_.write("s.yaml", std::string(PAIR) + "map: map.yaml\n");
  map("255 255 255");
  Training training(config());
  const std::string text = checkpointOf(training);
  EXPECT_EQ(errorFor(text, config()), "no error");
  map("0 255 255");
  EXPECT_TRUE(contains(errorFor(text, config()), "the training has 'map: map, checksum "));
}

TEST_F(CheckpointTest, RefusesAStateThatTheTrainingCannotReach) {
  const auto error = [&](const std::string& plan, std::uint64_t done, std::uint64_t episodes) {
    Training training(config(plan, "lambda: 0", done));
    run(training, done);
    Training other(config(plan, "lambda: 0", episodes));
    return errorOf<InputError>([&] { other.restore(training.state()); });
  };
  EXPECT_EQ(error("tables: shared", 5, 5), "no error");
  EXPECT_EQ(error("tables: shared", 5, 7), "no error");
  EXPECT_EQ(error("tables: shared", 5, 4), "training.episodes: expected 5 episodes or more, got 4");
  // A turn has 2 x 3 episodes.
  EXPECT_EQ(error("side_by_side: 2, turn: 3", 6, 8), "no error");
  EXPECT_EQ(error("side_by_side: 2, turn: 3", 8, 8), "no error");
  EXPECT_EQ(error("side_by_side: 2, turn: 3", 8, 12),
            "training.episodes: expected 8 episodes, because the last turn of learners side by side was cut, got 12");
}

}  // namespace
}  // namespace crowd::checkpoint_test
