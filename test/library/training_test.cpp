#include "social_crowd/training.h"

#include <gtest/gtest.h>

#include "learning/q_table_file.h"
#include "social_crowd/errors.h"
#include "support/temporary_folder.h"
#include "training/training.h"

namespace crowd::library::training_test {
namespace {

/// A configuration with four learners side by side.
std::string writeConfig(const TemporaryFolder& folder, const std::string& state_set = "{type: nearest_obstacle}") {
  return folder.write("config.yaml", "state_set: " + state_set +
                                         "\n"
                                         "action_set: {type: kings_moves}\n"
                                         "reward: {goal: cosine_cubed, obstacle_cost: 80}\n"
                                         "learning: {alpha: 0.1, gamma: 0.1, epsilon: 0.25}\n"
                                         "training: {scenarios: [single_obstacle], episodes: 16, seed: 3,\n"
                                         "           side_by_side: 4, turn: 2}\n");
}

std::string textOf(const QTable& table) { return toText(table.trained()); }

TEST(LibraryTraining, LearnsAsTheClassBehindIt) {
  const TemporaryFolder folder;
  const std::string config = writeConfig(folder);
  crowd::Training expected(readTrainingConfig(config));
  Training training(config);
  EXPECT_EQ(training.episodes(), 16U);
  while (!expected.isDone()) {
    ASSERT_FALSE(training.isDone());
    const std::vector<crowd::LearnedEpisode> other = expected.runNextTurn();
    const std::vector<LearnedEpisode> episodes = training.runNextTurn();
    ASSERT_EQ(episodes.size(), other.size());
    EXPECT_EQ(episodes.size(), 8U);
    for (std::size_t i = 0; i < episodes.size(); ++i) {
      EXPECT_EQ(episodes[i].scenario, "single_obstacle");
      EXPECT_EQ(episodes[i].ticks, other[i].ticks);
      EXPECT_EQ(episodes[i].decisions, other[i].decisions);
      EXPECT_EQ(episodes[i].reward, other[i].reward);
      EXPECT_EQ(episodes[i].epsilon, 0.25);
      EXPECT_EQ(episodes[i].count.arrived, other[i].arrivedCount());
    }
    EXPECT_EQ(training.episode(), expected.episode());
    EXPECT_EQ(training.decisions(), expected.decisions());
    EXPECT_EQ(textOf(training.table()), toText(expected.trained()));
  }
  EXPECT_TRUE(training.isDone());
}

TEST(LibraryTraining, GoesOnFromACheckpoint) {
  const TemporaryFolder folder;
  const std::string config = writeConfig(folder);
  Training whole(config);
  whole.runNextTurn();
  whole.saveCheckpoint(folder.file("checkpoint"));
  const std::string half = textOf(whole.table());
  whole.runNextTurn();
  Training rest(config);
  rest.resume(folder.file("checkpoint"));
  EXPECT_EQ(rest.episode(), 8U);
  EXPECT_EQ(textOf(rest.table()), half);
  rest.runNextTurn();
  EXPECT_EQ(textOf(rest.table()), textOf(whole.table()));
}

TEST(LibraryTraining, OptionsOverrideTheConfiguration) {
  const TemporaryFolder folder;
  const std::string config = writeConfig(folder);
  TrainingOptions options;
  options.episodes = 8;
  options.seed = 4;
  options.threads = 2;
  Training other(config, options);
  other.runNextTurn();
  EXPECT_TRUE(other.isDone());
  Training training(config);
  training.runNextTurn();
  EXPECT_NE(textOf(other.table()), textOf(training.table()));
  options.begin = other.table();
  Training more(config, options);
  EXPECT_EQ(more.decisions(), 0U);
  EXPECT_EQ(more.table().decisions(), other.decisions());
  more.runNextTurn();
  EXPECT_EQ(more.table().decisions(), other.decisions() + more.decisions());
}

TEST(LibraryTraining, Errors) {
  const TemporaryFolder folder;
  EXPECT_THROW(Training(folder.file("missing.yaml")), FileError);
  EXPECT_THROW(Training(writeConfig(folder, "{type: nothing}")), InputError);
  const std::string config = writeConfig(folder);
  TrainingOptions options;
  options.begin = QTable::load("anticipation");
  EXPECT_THROW(Training(config, options), ShapeError);
  Training training(config);
  EXPECT_THROW(training.resume(folder.file("missing")), FileError);
  EXPECT_THROW(training.resume(folder.write("damaged", "nothing")), InputError);
  options = {};
  options.seed = 99;
  Training(config, options).saveCheckpoint(folder.file("other"));
  EXPECT_THROW(training.resume(folder.file("other")), InputError);
  EXPECT_EQ(training.episode(), 0U);
}

}  // namespace
}  // namespace crowd::library::training_test
