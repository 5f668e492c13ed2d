#include "navigation/congestion_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/two_ways.h"

namespace crowd::congestion_map_test {
namespace {

using two_ways::walker;

/// The ways of agents lead along the x axis.
class Street {
 public:
  explicit Street(std::vector<AgentStart> agents) : world(two_ways::worldOf(std::move(agents))) {}

  void walk(double time) {
    for (const double end = world.time() + time; world.time() < end;) step(straight_walk::actions(world));
  }
  void stand(double time) {
    for (const double end = world.time() + time; world.time() < end;) step({});
  }
  double delay(const Vector2& from, const Vector2& to, double speed = 1.0) const {
    return map.delayOn(from, {&to, 1}, speed).total;
  }

  World world;
  CongestionMap map;

 private:
  void step(const std::vector<AgentAction>& actions) {
    world.step(actions);
    std::vector<RemainingPath> paths(world.agents().size());
    for (const Agent& agent : world.agents()) paths[agent.id] = {agent.goal()};
    map.update(world, paths);
  }
};

TEST(CongestionMap, FreeFloorCostsNothing) {
  Street street({walker({0.5, 0.5}, {40.0, 0.5})});
  street.walk(10.0);
  EXPECT_EQ(street.delay({0.0, 0.5}, {20.0, 0.5}), 0.0);
}

/// An agent that stands for a long time: its square of 1.5 m is passed at 0.05 times the speed, 19 times longer than
/// its 1.5 s. The way has pieces of 0.5 m, three of which are in it.
TEST(CongestionMap, ACrowdThatStandsCostsTime) {
  Street street({walker({0.5, 0.5}, {40.0, 0.5})});
  street.stand(100.0);
  EXPECT_NEAR(street.delay({-3.0, 0.5}, {6.0, 0.5}), 19.0 * 1.5, 1e-6);
  EXPECT_NEAR(street.delay({-3.0, 0.5}, {6.0, 0.5}, 2.0), 0.5 * 19.0 * 1.5, 1e-6);  // at twice the speed
  EXPECT_EQ(street.delay({6.0, 0.5}, {-3.0, 0.5}), 0.0);                            // in the opposite direction
  EXPECT_EQ(street.delay({-3.0, 2.0}, {6.0, 2.0}), 0.0);                            // beside it
  const Vector2 goal(6.0, 0.5);
  const CongestionMap::Delay delay = street.map.delayOn({-3.0, 0.5}, {&goal, 1}, 1.0);
  EXPECT_NEAR(delay.worst, 19.0 * 0.5, 1e-6);
  EXPECT_LT((delay.place - Vector2(0.75, 0.5)).norm(), 0.75);
}

/// After 5 s, ten ticks of 0.5 s that each take a fifth of the difference, the share of the speed is 0.8^10.
TEST(CongestionMap, IsAMovingAverage) {
  Street street({walker({0.5, 0.5}, {40.0, 0.5})});
  street.stand(5.0);
  EXPECT_NEAR(street.delay({-3.0, 0.5}, {6.0, 0.5}), 1.5 * (std::pow(0.8, -10.0) - 1.0), 1e-6);
}

/// Two ticks of 0.5 s at the maximum speed against the way, in one square: 1 - 0.2 * 2 = 0.6, then 0.6 - 0.2 * 1.6.
TEST(CongestionMap, WhoWalksBackCounts) {
  Street street({walker({2.9, 0.5}, {40.0, 0.5})});
  street.world.walkingAgent(0).setWaypoint({-40.0, 0.5});
  street.walk(1.0);
  EXPECT_NEAR(street.map.shareAt({2.0, 0.5}, Vector2::UnitX()), 0.28, 1e-9);
  EXPECT_EQ(street.map.shareAt({2.0, 0.5}, -Vector2::UnitX()), 1.0);
  EXPECT_EQ(street.map.shareAt({4.0, 0.5}, Vector2::UnitX()), 1.0);
}

TEST(CongestionMap, ForgetsACrowdThatHasLeft) {
  Street street({walker({0.5, 0.5}, {40.0, 0.5})});
  street.stand(5.0);
  const double before = street.delay({-3.0, 0.5}, {1.5, 0.5});
  street.walk(10.0);
  EXPECT_LT(street.delay({-3.0, 0.5}, {1.5, 0.5}), 0.5 * before);
  street.walk(25.0);
  EXPECT_EQ(street.delay({-3.0, 0.5}, {1.5, 0.5}), 0.0);
}

}  // namespace
}  // namespace crowd::congestion_map_test
