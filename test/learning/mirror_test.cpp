#include "learning/rl/mirror.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/random.h"
#include "support/mirror_models.h"
#include "support/moves.h"
#include "support/perceptions.h"
#include "support/rows.h"

namespace crowd::mirror_test {
namespace {

using mirror_models::mirrorOf;
using mirror_models::models;

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

TEST(Mirror, IsItsOwnInverse) {
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
  const Mirror limited = mirrorOf(models()[8]);
  // Goal sector 1; class 1 in sector 1, 15-45 degrees on the left, class 2 in sector 7, behind on the right; then goal
  // sector 7, class 1 in sector 5 (3^2) and class 2 in sector 3 (3^4).
  EXPECT_EQ(limited.row(6561U + 729U + 2U), 7U * 6561U + 9U + 2U * 81U);
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

TEST(Mirror, HasImageIfRowAndActionAreNotSymmetric) {
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

TEST(Mirror, WithoutAModelHasNoImages) {
  EXPECT_EQ(Mirror().row(43), 43U);
  EXPECT_EQ(Mirror().action(1), 1U);
  EXPECT_FALSE(Mirror().hasImage(43, 1));
}

}  // namespace
}  // namespace crowd::mirror_test
