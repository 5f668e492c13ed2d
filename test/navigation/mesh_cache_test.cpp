#include "navigation/mesh_cache.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

#include "social_crowd/errors.h"
#include "support/floors.h"

namespace crowd::mesh_cache_test {
namespace {

constexpr double RADIUS = 0.2;

/// A small room of this width, which no other test uses.
FloorPlan smallRoom(double width) { return floors::room({0.0, 0.0}, {width, 2.0}); }

TEST(MeshCache, TheSameFloorHasTheSameData) {
  const auto data = navigationData(smallRoom(3.0), RADIUS);
  EXPECT_EQ(navigationData(smallRoom(3.0), RADIUS), data);
  EXPECT_DOUBLE_EQ(data->comfortable.clearance(), RADIUS + COMFORTABLE_MARGIN);
  EXPECT_DOUBLE_EQ(data->tight.clearance(), RADIUS + TIGHT_MARGIN);
}

TEST(MeshCache, AnyDifferenceMakesAnotherFloor) {
  const auto data = navigationData(smallRoom(3.1), RADIUS);
  std::vector<FloorPlan> others(5, smallRoom(3.1));
  others[0].walls.pop_back();
  others[1].walls.front().to.x() += 1e-9;
  others[2].obstacles.push_back({{1.0, 1.0}, 0.1});
  others[3].bounds = FloorPlan::Bounds{{0.0, 0.0}, {3.0, 2.0}};
  others[4].bounds = FloorPlan::Bounds{{0.0, 0.0}, {3.0, 1.0}};
  for (const FloorPlan& other : others) EXPECT_NE(navigationData(other, RADIUS), data);
  EXPECT_NE(navigationData(smallRoom(3.1), RADIUS + 0.01), data);
}

TEST(MeshCache, TwoFloorsInTurnAreKept) {
  const auto open = navigationData(smallRoom(3.2), RADIUS);
  const auto closed = navigationData(smallRoom(3.3), RADIUS);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(navigationData(smallRoom(3.2), RADIUS), open);
    ASSERT_EQ(navigationData(smallRoom(3.3), RADIUS), closed);
  }
}

TEST(MeshCache, ManyFloorsAreNotAllKept) {
  const std::weak_ptr<const NavigationData> first = navigationData(smallRoom(4.0), RADIUS);
  const auto used = navigationData(smallRoom(4.1), RADIUS);
  EXPECT_FALSE(first.expired());
  for (int i = 1; i < 20; ++i) navigationData(smallRoom(5.0 + 0.1 * i), RADIUS);
  EXPECT_TRUE(first.expired());
  // Data in use stay valid.
  NavigationMesh::Query query(used->comfortable);
  EXPECT_TRUE(query.findPath({1.0, 1.0}, {3.0, 1.0}));
}

TEST(MeshCache, AnInvalidFloorChangesNothing) {
  const auto data = navigationData(smallRoom(3.4), RADIUS);
  FloorPlan invalid = smallRoom(3.4);
  invalid.obstacles.push_back({{1.0, 1.0}, -1.0});
  EXPECT_THROW(navigationData(invalid, RADIUS), InputError);
  EXPECT_EQ(navigationData(smallRoom(3.4), RADIUS), data);
}

TEST(MeshCache, ThreadsGetTheSameData) {
  std::vector<std::shared_ptr<const NavigationData>> found(4);
  std::vector<std::thread> threads;
  for (auto& data : found) {
    threads.emplace_back([&data] { data = navigationData(smallRoom(3.5), RADIUS); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& data : found) EXPECT_EQ(data, found.front());
}

}  // namespace
}  // namespace crowd::mesh_cache_test
