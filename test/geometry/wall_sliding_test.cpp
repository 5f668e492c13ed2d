#include "geometry/wall_sliding.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crowd::wall_sliding_test {
namespace {

const Footprint DISC{0.5, {}};
/// A rectangle of 1 m x 1 m whose origin is in the middle of its rear side.
const Footprint BOX{0.0, {{1.0, 0.5}, {0.0, 0.5}, {0.0, -0.5}, {1.0, -0.5}}};
const WallSliding SLIDING{1.0, true};

std::vector<WallContact> contactsOf(const Footprint& footprint, const Pose& pose, const std::vector<Segment>& walls) {
  std::vector<WallContact> contacts;
  for (const Segment& wall : walls) addContacts(footprint, pose, wall, 1e-7, contacts);
  return contacts;
}

BodyMotion slid(const Footprint& footprint, const Pose& pose, const std::vector<Segment>& walls,
                const BodyMotion& motion, const WallSliding& sliding = SLIDING) {
  return slideAlongWalls(footprint, contactsOf(footprint, pose, walls), motion, sliding, 0.1);
}

void expectMotion(const BodyMotion& motion, double x, double y, double rotation) {
  EXPECT_NEAR(motion.velocity.x(), x, 1e-5);
  EXPECT_NEAR(motion.velocity.y(), y, 1e-5);
  EXPECT_NEAR(motion.rotation, rotation, 1e-5);
}

TEST(WallSliding, ADiscKeepsItsMotionAlongTheWallAndItsRotation) {
  const Segment below{{-2.0, -0.5}, {2.0, -0.5}};
  expectMotion(slid(DISC, Pose(), {below}, {{0.6, -0.8}, 0.7}), 0.6, 0.0, 0.7);
  expectMotion(slid(DISC, Pose(), {below}, {{0.6, 0.8}, 0.7}), 0.6, 0.8, 0.7);  // away from it
  // At the end of a wall: its direction is that from the centre.
  const Vector2 end = 0.5 * unitVector(-PI / 4.0);
  const double half = std::sqrt(0.5);
  expectMotion(slid(DISC, Pose(), {{end, end + Vector2(2.0, 0.0)}}, {{1.0, 0.0}, 0.0}), half * half, half * half, 0.0);
}

TEST(WallSliding, ACarTurnsInProportionToItsSpeed) {
  const Segment below{{-2.0, -0.5}, {2.0, -0.5}};
  expectMotion(slid(DISC, Pose(), {below}, {{0.6, -0.8}, 0.5}, {1.0, false}), 0.6, 0.0, 0.3);
  expectMotion(slid(DISC, Pose(), {below}, {{0.0, -1.0}, 0.5}, {1.0, false}), 0.0, 0.0, 0.0);
}

TEST(WallSliding, InACornerItStands) {
  const std::vector<Segment> corner = {{{-2.0, -0.5}, {0.5, -0.5}}, {{0.5, -0.5}, {0.5, 2.0}}};
  expectMotion(slid(DISC, Pose(), corner, {{0.6, -0.8}, 0.2}), 0.0, 0.0, 0.2);
  expectMotion(slid(DISC, Pose(), corner, {{-0.6, -0.8}, 0.2}), -0.6, 0.0, 0.2);
}

TEST(WallSliding, AWallTurnsABox) {
  // Turned by -0.1, it drives down onto a wall with its front right corner, which is at (0.945087, -0.597335) from the
  // origin. Inertia per mass 0.4 * 1.25 m^2. The impulse is 1 / (1 + 0.945087^2 / 0.5) = 0.358889, which leaves
  // 0.641111 m/s and turns it at 0.358889 * 0.945087 / 0.5 = 0.678365 rad/s. The corner moves on an arc: up by another
  // 0.678365^2 * sqrt(1.25) * 0.1 / 2 = 0.025725 m/s.
  const Segment below{{-5.0, -0.597335}, {5.0, -0.597335}};
  std::vector<WallContact> contacts;
  addContacts(BOX, {{0.0, 0.0}, -0.1}, below, 1e-5, contacts);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].arm.x(), 0.945087, 1e-6);
  EXPECT_EQ(contacts[0].normal, Vector2(0.0, -1.0));
  expectMotion(slideAlongWalls(BOX, contacts, {{0.3, -1.0}, 0.0}, SLIDING, 0.1), 0.3, -0.641111 + 0.025725, 0.678365);
  // A wall turns it at most at its maximum rotation; then it is pushed off instead.
  const BodyMotion slow = slideAlongWalls(BOX, contacts, {{0.3, -1.0}, 0.0}, {0.1, true}, 0.1);
  EXPECT_EQ(slow.rotation, 0.1);
  EXPECT_NEAR(slow.velocity.y(), -0.1 * 0.945087 + 0.5 * 0.01 * std::sqrt(1.25) * 0.1, 1e-5);
}

TEST(WallSliding, ABoxThatStandsWithItsWholeSideDoesNotTurn) {
  // The front, against a wall across.
  const BodyMotion front = slid(BOX, Pose(), {{{1.0, -2.0}, {1.0, 2.0}}}, {{1.0, 0.0}, 0.0});
  expectMotion(front, 0.0, 0.0, 0.0);
  // The same with a wall that is shorter than the side: its ends touch it.
  expectMotion(slid(BOX, Pose(), {{{1.0, -0.2}, {1.0, 0.2}}}, {{1.0, 0.3}, 0.0}), 0.0, 0.3, 0.0);
}

}  // namespace
}  // namespace crowd::wall_sliding_test
