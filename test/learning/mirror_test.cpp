#include "social_crowd/learning/rl/mirror.h"

#include <gtest/gtest.h>

#include "social_crowd/learning/q_table_file.h"
#include "support/error_of.h"
#include "support/learners.h"
#include "support/moves.h"
#include "support/rows.h"

namespace crowd {
namespace {

using learners::decide;
using learners::randomTick;

Model modelOf(const std::string& state_set, const std::string& action_set, const std::string& reward) {
  return parseModel("{state_set: " + state_set + ", action_set: " + action_set + ", reward: " + reward + "}");
}

/// Even and odd numbers of sectors and actions, one row for all actions and one for each.
std::vector<Model> models() {
  const std::string thesis = "{goal: distance_gained, obstacle_cost: 10}";
  return {
      modelOf("{type: nearest_obstacle}", "{type: kings_moves}", thesis),
      modelOf("{type: nearest_obstacle, goal_sectors: 5, obstacle_sectors: [30, 180]}",
              "{type: kings_moves, rotations: 7}", thesis),
      modelOf("{type: occupancy}", "{type: kings_moves}", thesis),
      modelOf("{type: occupancy, sectors: 5}", "{type: kings_moves, rotations: 2}", thesis),
      modelOf("{type: occupancy}", "{type: goal_relative}", thesis),
      modelOf("{type: condensed_occupancy}", "{type: kings_moves, stay: true}", thesis),
      modelOf("{type: anticipation}", "{type: goal_relative}", "{type: progress}"),
      modelOf("{type: anticipation}", "{type: kings_moves}", "{type: progress}"),
  };
}

Mirror mirrorOf(const Model& model) { return {*model.state_set, *model.action_set}; }

Vector2 flipped(const Vector2& vector) { return {vector.x(), -vector.y()}; }

/// Returns the perception with left and right exchanged.
PerceptionsBuilder mirrorImage(const Perception& seen) {
  PerceptionsBuilder image;
  image.agent(seen.self.agent, flipped(seen.self.goal));
  for (const Neighbour& neighbour : seen.neighbours) {
    image.neighbour(flipped(neighbour.position), neighbour.radius).kind(neighbour.kind);
    image.velocity(flipped(seen.self.velocity), flipped(neighbour.velocity));
  }
  for (const Segment& wall : seen.walls) image.wall(flipped(wall.from), flipped(wall.to));
  return image;
}

Vector2 anyVector(KeyedRandom& random, double longest) {
  const double bearing = random.uniform(-180.0, 180.0);
  return polar(bearing, random.uniform(0.0, longest));
}

/// Agents, obstacles, some of them moving, and walls, near enough to affect the rows of all state sets.
PerceptionsBuilder anyPerception(std::uint64_t seed) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
  PerceptionsBuilder scene;
  scene.agent(0, anyVector(random, 3.0));
  const Vector2 own_velocity = anyVector(random, 0.3);
  for (std::uint32_t left = 1 + random.below(4); left > 0; --left) {
    const Vector2 position = anyVector(random, 1.0);
    const double radius = random.uniform(0.05, 0.3);
    scene.neighbour(position + 0.3 * position.normalized(), radius);
    scene.velocity(own_velocity, random.below(3) == 0 ? Vector2::Zero() : anyVector(random, 0.4));
    scene.kind(random.below(2) == 0 ? NeighbourKind::AGENT : NeighbourKind::OBSTACLE);
  }
  for (std::uint32_t left = random.below(3); left > 0; --left) {
    const Vector2 from = anyVector(random, 1.5);
    scene.wall(from, anyVector(random, 1.5));
  }
  return scene;
}

std::vector<Row> rowsOf(const Model& model, const Perception& perception) {
  return rowsOf(*model.state_set, perception, movesOf(*model.action_set, perception));
}

// --- mirror images of rows and actions ---

TEST(Mirror, OfTheMirrorImageIsTheThingItself) {
  for (const Model& model : models()) {
    SCOPED_TRACE(model.spec());
    const Mirror mirror = mirrorOf(model);
    for (Row row = 0; row < model.state_set->rowCount(); ++row) {
      ASSERT_LT(mirror.row(row), model.state_set->rowCount()) << row;
      ASSERT_EQ(mirror.row(mirror.row(row)), row);
    }
    for (Action action = 0; action < model.action_set->size(); ++action) {
      ASSERT_LT(mirror.action(action), model.action_set->size()) << action;
      ASSERT_EQ(mirror.action(mirror.action(action)), action);
    }
  }
}

TEST(Mirror, RowOfAMirroredPerceptionIsTheMirroredRow) {
  for (const Model& model : models()) {
    SCOPED_TRACE(model.spec());
    const Mirror mirror = mirrorOf(model);
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
      const PerceptionsBuilder scene = anyPerception(seed);
      const PerceptionsBuilder image = mirrorImage(scene.perception());
      const std::vector<Row> rows = rowsOf(model, scene.perception());
      const std::vector<Row> image_rows = rowsOf(model, image.perception());
      const std::size_t stride = rows.size() == 1 ? 0 : 1;
      for (Action action = 0; action < model.action_set->size(); ++action) {
        ASSERT_EQ(image_rows[mirror.action(action) * stride], mirror.row(rows[action * stride]))
            << "seed " << seed << ", action " << action;
      }
    }
  }
}

TEST(Mirror, MoveOfTheMirroredActionIsTheMirroredMove) {
  for (const Model& model : models()) {
    SCOPED_TRACE(model.spec());
    const Mirror mirror = mirrorOf(model);
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const PerceptionsBuilder scene = anyPerception(seed);
      const PerceptionsBuilder image = mirrorImage(scene.perception());
      for (Action action = 0; action < model.action_set->size(); ++action) {
        const RelativeAction move = relativeAction(*model.action_set, scene.perception(), action);
        const RelativeAction mirrored = relativeAction(*model.action_set, image.perception(), mirror.action(action));
        ASSERT_NEAR((unitVector(mirrored.rotation) - flipped(unitVector(move.rotation))).norm(), 0.0, 1e-12)
            << "seed " << seed << ", action " << action;
        ASSERT_NEAR(mirrored.speed_fraction, move.speed_fraction, 1e-12) << "seed " << seed << ", action " << action;
      }
    }
  }
}

TEST(Mirror, ByHand) {
  const Mirror thesis = mirrorOf(models()[0]);
  EXPECT_EQ(thesis.action(0), 0U);
  EXPECT_EQ(thesis.action(1), 7U);  // 45 degrees to either side
  EXPECT_EQ(thesis.action(4), 4U);
  EXPECT_EQ(thesis.row(0), 0U);
  EXPECT_EQ(thesis.row(3), 5U);
  EXPECT_EQ(thesis.row(4), 4U);
  EXPECT_EQ(thesis.row(136), 136U);  // arrived
  // Goal sector 2, obstacle sector 1 on the left, class 2: 7 + 2 * 16 + 1 * 2 + 2; goal sector 6, sector 5 on the
  // right.
  EXPECT_EQ(thesis.row(43), 7U + 6U * 16U + 5U * 2U + 2U);
  const Mirror occupancy = mirrorOf(models()[2]);
  // Goal sector 1; class 1 in sector 1, class 2 in sector 4: these digits stand for 3^6 and 3^3, that of sector 7
  // for 1.
  EXPECT_EQ(occupancy.row(6561U + 729U + 2U * 27U), 7U * 6561U + 2U * 27U + 1U);
  const Mirror goal_relative = mirrorOf(models()[4]);
  EXPECT_EQ(goal_relative.action(0), 0U);
  EXPECT_EQ(goal_relative.action(1), 2U);    // 10 degrees to either side
  EXPECT_EQ(goal_relative.action(13), 13U);  // backwards
  EXPECT_EQ(goal_relative.action(16), 15U);  // 35 degrees, slow
  EXPECT_EQ(goal_relative.action(17), 17U);  // stay
}

/// Counts the pairs of row and action that are their own mirror image.
std::size_t countSelfImages(const Model& model) {
  const Mirror mirror = mirrorOf(model);
  std::size_t count = 0;
  for (Row row = 0; row < model.state_set->rowCount(); ++row) {
    for (Action action = 0; action < model.action_set->size(); ++action) {
      count += mirror.hasImage(row, action) ? 0 : 1;
      EXPECT_EQ(mirror.hasImage(row, action), mirror.hasImage(mirror.row(row), mirror.action(action)));
    }
  }
  return count;
}

TEST(Mirror, HasImageOfWhatIsNotSymmetric) {
  const Mirror thesis = mirrorOf(models()[0]);
  EXPECT_FALSE(thesis.hasImage(0, 0));  // goal ahead, straight on
  EXPECT_FALSE(thesis.hasImage(4, 0));  // goal behind
  EXPECT_FALSE(thesis.hasImage(0, 4));  // backwards
  EXPECT_TRUE(thesis.hasImage(0, 1));   // goal ahead, half left
  EXPECT_TRUE(thesis.hasImage(3, 0));   // goal on the left, straight on
  EXPECT_TRUE(thesis.hasImage(3, 1));
  EXPECT_TRUE(thesis.hasImage(43, 4));  // an obstacle on the left
  EXPECT_FALSE(thesis.hasImage(136, 4));
  // Two actions, straight on and back, in these rows: goal ahead or behind and no obstacle, and the terminal one.
  EXPECT_EQ(countSelfImages(models()[0]), 2U * 3U);
  // Goal ahead or behind, any of 3 classes ahead, behind and in three sectors whose image has the same; the terminal
  // one.
  EXPECT_EQ(countSelfImages(models()[2]), 2U * (2U * 243U + 1U));
}

TEST(Mirror, WithoutModelMirrorsNothing) {
  EXPECT_EQ(Mirror().row(43), 43U);
  EXPECT_EQ(Mirror().action(1), 1U);
  EXPECT_FALSE(Mirror().hasImage(43, 1));
}

// --- learning; in learners::model() rows 1 and 3 are mirror images, actions a and 8 - a ---

constexpr LearningParameters HALVES = {0.5, 0.5, 0.0, 0.0};

TEST(MirroredLearning, TeachesTheMirrorImageTheSameTarget) {
  const Mirror mirror = mirrorOf(learners::model());
  QTable table = learners::emptyTable();
  table.set(2, 5, 8.0, 1);
  table.set(3, 6, 4.0, 1);  // the mirror image has another value already
  const Row here = 1;
  const Row there = 2;
  TdLearner learner;
  learner.recordDecision(table, {&here, 0}, 2, HALVES);
  learner.learn(table, 2.0, {&there, 0}, HALVES, LearningRateSchedule(HALVES), mirror);  // target 2 + 0.5 * 8 = 6
  QTable expected = table;
  expected.set(1, 2, 3.0, 1);  // half of the way from 0
  expected.set(3, 6, 5.0, 2);  // half of the way from 4
  EXPECT_EQ(table, expected);
  learner.recordDecision(table, {&here, 0}, 0, HALVES);
  learner.learnTerminal(table, 16.0, HALVES, LearningRateSchedule(HALVES), mirror);
  expected.set(1, 0, 8.0, 1);
  expected.set(3, 0, 8.0, 1);
  EXPECT_EQ(table, expected);
}

TEST(MirroredLearning, LearnsWhatIsItsOwnMirrorImageOnce) {
  QTable table = learners::emptyTable();
  const Row ahead = 0;
  TdLearner learner;
  learner.recordDecision(table, {&ahead, 0}, 4, HALVES);
  learner.learnTerminal(table, 8.0, HALVES, LearningRateSchedule(HALVES), mirrorOf(learners::model()));
  QTable expected = learners::emptyTable();
  expected.set(0, 4, 4.0, 1);
  EXPECT_EQ(table, expected);
}

TEST(MirroredLearning, StepsOfTheMirrorImageShrinkWithItsOwnVisits) {
  const LearningParameters means = {0.01, 0.5, 0.0, 0.0, 1.0};
  QTable table = learners::emptyTable();
  table.set(3, 7, 2.0, 3);
  const Row here = 1;
  TdLearner learner;
  learner.recordDecision(table, {&here, 0}, 1, means);
  learner.learnTerminal(table, 10.0, means, LearningRateSchedule(means), mirrorOf(learners::model()));
  EXPECT_EQ(table.value(1, 1), 10.0);  // the first visit
  EXPECT_EQ(table.value(3, 7), 4.0);   // the fourth: 2 + (10 - 2) / 4
  EXPECT_EQ(table.visits(3, 7), 4U);
}

TEST(MirroredLearning, CarriesStepsBackToMirrorImagesOfEarlierDecisions) {
  const LearningParameters traces = {0.5, 0.5, 0.5, 0.0};  // gamma * lambda = 0.25
  const Mirror mirror = mirrorOf(learners::model());
  QTable table = learners::emptyTable();
  table.set(2, 5, -8.0, 1);  // the mirror image of (2, 3)
  TdLearner learner;
  const auto decide_and_learn = [&](Row row, Action action, double reward, Row next) {
    learner.recordDecision(table, {&row, 0}, action, traces);
    learner.learn(table, reward, {&next, 0}, traces, LearningRateSchedule(traces), mirror);
  };
  decide_and_learn(1, 2, 8.0, 0);  // (1, 2) and (3, 6) become 4
  decide_and_learn(0, 0, 4.0, 2);  // its own image: step 2; a quarter of that goes back
  EXPECT_EQ(table.value(0, 0), 2.0);
  EXPECT_EQ(table.visits(0, 0), 1U);
  EXPECT_EQ(table.value(1, 2), 4.5);
  EXPECT_EQ(table.value(3, 6), 4.5);
  decide_and_learn(2, 3, 16.0, 5);  // steps 8, and 12 for the image, which was at -8; traces 0.25 and 0.0625
  EXPECT_EQ(table.value(2, 3), 8.0);
  EXPECT_EQ(table.value(2, 5), 4.0);
  EXPECT_EQ(table.value(0, 0), 4.0);  // once
  EXPECT_EQ(table.value(1, 2), 5.0);
  EXPECT_EQ(table.value(3, 6), 5.25);
}

/// Requires equal values of mirror images, bit for bit; counts the visited entries that are not their own image.
bool isSymmetric(const QTable& table, const Mirror& mirror, std::size_t& visited) {
  for (Row row = 0; row < table.rows(); ++row) {
    for (Action action = 0; action < table.actions(); ++action) {
      const Row image_row = mirror.row(row);
      const Action image_action = mirror.action(action);
      if (table.value(row, action) != table.value(image_row, image_action)) return false;
      if (table.visits(row, action) != table.visits(image_row, image_action)) return false;
      visited += table.visits(row, action) > 0 && (row != image_row || action != image_action) ? 1 : 0;
    }
  }
  return true;
}

QTable trainedTable(const Model& model, bool mirrored, double lambda) {
  Learner::Options options;
  options.mode = Mode::TRAINING;
  options.plan.parameters = {0.07, 0.9, lambda, 0.2, 0.6, mirrored};
  options.plan.epsilon = EpsilonSchedule::constant(0.2);
  Learner learner(model, options);
  for (std::uint64_t tick = 0; tick < 200; ++tick) decide(learner, randomTick(11, 0, tick, 6));
  return learner.tableOf(0);
}

TEST(MirroredLearning, LeavesASymmetricTableSymmetricBitForBit) {
  for (const Model& model : models()) {
    SCOPED_TRACE(model.spec());
    const Mirror mirror = mirrorOf(model);
    for (const double lambda : {0.0, 0.7}) {
      std::size_t visited = 0;
      EXPECT_TRUE(isSymmetric(trainedTable(model, true, lambda), mirror, visited)) << "lambda " << lambda;
      EXPECT_GT(visited, 10U);
      EXPECT_FALSE(isSymmetric(trainedTable(model, false, lambda), mirror, visited)) << "lambda " << lambda;
    }
  }
}

TEST(MirroredLearning, BeginsAndEndsWithTheParameters) {
  Learner::Options options = learners::options(Mode::TRAINING);
  Learner learner(learners::model(), options);
  const auto gain_in_row_one = [&](std::uint64_t tick) {
    decide(learner, learners::tick(tick, 1, 4.0));
    decide(learner, learners::tick(tick + 1, 0, 3.0));
    learner.forgetDecisions();
  };
  LearningParameters parameters = options.plan.parameters;
  gain_in_row_one(0);
  EXPECT_FALSE(learner.tableOf(0).isVisited(3));
  parameters.mirrored = true;
  learner.setPlan({parameters, options.plan.epsilon});
  gain_in_row_one(10);
  EXPECT_EQ(learner.tableOf(0).visits(3, 0), 1U);
  EXPECT_EQ(learner.decisions(), 2U);  // mirrored updates are not counted as decisions
  parameters.mirrored = false;
  learner.setPlan({parameters, options.plan.epsilon});
  gain_in_row_one(20);
  EXPECT_EQ(learner.tableOf(0).visits(3, 0), 1U);
  EXPECT_EQ(learner.tableOf(0).visits(1, 0), 3U);
}

// --- files ---

TEST(MirroredLearning, IsAskedForInTheConfiguration) {
  const auto read = [](const std::string& yaml) { return readLearningPlan(YAML::Load(yaml), {"f", 0, "learning"}); };
  EXPECT_FALSE(read("{}").parameters.mirrored);
  EXPECT_FALSE(read("{mirrored: false}").parameters.mirrored);
  EXPECT_TRUE(read("{mirrored: true}").parameters.mirrored);
  EXPECT_TRUE(contains(errorOf<InputError>([&] { read("{mirrored: left}"); }), "learning.mirrored: expected"));
}

TEST(MirroredLearning, StandsInTheTablesHeaderWhereItIsTrue) {
  TrainedTable trained = {learners::model(), HALVES, 1, 1, learners::randomTable(1)};
  EXPECT_FALSE(contains(toText(trained), "mirrored"));
  EXPECT_FALSE(parseQTable(toText(trained), "f").parameters.mirrored);
  trained.parameters.mirrored = true;
  EXPECT_TRUE(contains(toText(trained), "\nmirrored: true\n"));
  EXPECT_TRUE(parseQTable(toText(trained), "f").parameters.mirrored);
  EXPECT_EQ(toText(parseQTable(toText(trained), "f")), toText(trained));
}

}  // namespace
}  // namespace crowd
