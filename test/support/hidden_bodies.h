#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/sceneries.h"

/// Sceneries with hidden bodies, and checks of what is visible.
namespace crowd::sceneries {

/// The direction of a line of sight, 36.9 degrees to the left of straight ahead, and the direction to its left.
inline const Vector2 SIGHT(0.8, 0.6);
inline const Vector2 LEFT(-0.6, 0.8);

/// A disc that touches this line of sight and its mirror image.
inline const Neighbour BIG = neighbour({2.0, 0.0}, 1.2);

/// A larger disc farther away that touches the same lines of sight. The chord between the points of contact is 3.2 m
/// ahead and reaches 2.4 m to either side.
inline const Neighbour LARGE = neighbour({5.0, 0.0}, 3.0);

/// A wall 1 m ahead that hides the chord of LARGE between two fractions of its length, measured from the right.
inline Segment hiding(double from, double to) {
  return {{1.0, 0.75 * (2.0 * from - 1.0)}, {1.0, 0.75 * (2.0 * to - 1.0)}};
}

inline Vector2 turned(const Vector2& v, double angle) { return Rotation(angle).outOfFrame(v); }

inline Scenery turned(Scenery scenery, double angle) {
  for (Neighbour& neighbour : scenery.neighbours) neighbour.position = turned(neighbour.position, angle);
  for (Segment& wall : scenery.walls) wall = {turned(wall.from, angle), turned(wall.to, angle)};
  return scenery;
}

/// Whether the last body of a scenery is visible. Requires the same answer for 24 headings of the agent.
inline bool sees(const Scenery& scenery) {
  const auto seen_at = [&](double angle) {
    const Scenery seen = look(turned(numbered(scenery), angle));
    return find(seen, scenery.neighbours.size() - 1) != nullptr;
  };
  const bool seen = seen_at(0.0);
  for (int i = 1; i < 24; ++i) EXPECT_EQ(seen_at(i * PI / 12.0), seen) << "turned by " << 15 * i << " degrees";
  return seen;
}

/// Requires that the agent perceives the last body of a scenery as a disc, for each of 24 headings.
inline void expectLast(const Scenery& scenery, const Vector2& position, double radius) {
  for (int i = 0; i < 24; ++i) {
    SCOPED_TRACE("turned by " + std::to_string(15 * i) + " degrees");
    const Scenery seen = look(turned(numbered(scenery), i * PI / 12.0));
    const Neighbour* const last = find(seen, scenery.neighbours.size() - 1);
    ASSERT_NE(last, nullptr);
    EXPECT_LT((last->position - turned(position, i * PI / 12.0)).norm(), 1e-12);
    EXPECT_NEAR(last->radius, radius, 1e-12);
  }
}

/// Requires that these parts of walls are visible, in this order.
inline void expectWalls(const Scenery& seen, const std::vector<Segment>& expected) {
  ASSERT_EQ(seen.walls.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((seen.walls[i].from - expected[i].from).norm(), 1e-9) << i;
    EXPECT_LT((seen.walls[i].to - expected[i].to).norm(), 1e-9) << i;
  }
}

}  // namespace crowd::sceneries
