#include "population/gate.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "support/scenes.h"
#include "world/world_editor.h"

namespace crowd::gate_test {
namespace {

GateDescription gateAt(double x) {
  GateDescription gate;
  gate.wall = {{x, -1.0}, {x, 1.0}};
  return gate;
}

/// A wall of the scene, number 0, and an agent of radius 0.25 m that walks along x at 1 m/s, 0.5 m a tick.
World walker() {
  return World(
      scenes::halfSeconds(scenes::scene({scenes::wanderer({0.0, 0.0}, 1.0)}, {}, {{{-9.0, -9.0}, {-9.0, 9.0}}})));
}

void step(World& world) { world.step({{0, {0.0, 1.0}}}); }

TEST(Gate, ItsWallIsThereWhileItIsClosed) {
  World world = walker();
  const GateDescription description = gateAt(5.0);
  Gate gate(description);
  gate.update(world);
  EXPECT_FALSE(gate.isOpen());
  ASSERT_EQ(world.walls().list().size(), 2U);
  EXPECT_EQ(world.walls().list()[1].from, Vector2(5.0, -1.0));
  gate.setOpen(true, world.time());
  gate.update(world);
  EXPECT_TRUE(gate.isOpen());
  EXPECT_EQ(world.walls().list().size(), 1U);
  gate.setOpen(false, world.time());
  gate.update(world);
  EXPECT_EQ(world.walls().list().size(), 2U);
}

TEST(Gate, DoesNothingWithoutAChange) {
  World world = walker();
  const GateDescription description = gateAt(5.0);
  Gate gate(description);
  gate.update(world);
  const std::uint64_t changes = world.layoutChanges();
  for (int i = 0; i < 10; ++i) gate.update(world);
  EXPECT_EQ(world.layoutChanges(), changes);
}

/// The states of a gate with the periods [1, 2) and [3, 4) in ten ticks of 0.5 s, as letters (open or closed).
/// @param services what setOpen() gets, by tick
std::string statesOf(const std::map<int, bool>& services) {
  World world = walker();
  GateDescription description = gateAt(50.0);
  description.open_in = {{1.0, 2.0}, {3.0, 4.0}};
  Gate gate(description);
  std::string states;
  for (int tick = 0; tick < 10; ++tick) {
    const auto service = services.find(tick);
    if (service != services.end()) gate.setOpen(service->second, world.time());
    gate.update(world);
    states += gate.isOpen() ? 'o' : 'c';
    step(world);
  }
  return states;
}

TEST(Gate, FollowsItsPeriods) { EXPECT_EQ(statesOf({}), "ccooccoocc"); }

TEST(Gate, AServiceHoldsUntilThePeriodChanges) { EXPECT_EQ(statesOf({{1, true}, {3, false}}), "coocccoocc"); }

/// The agent's centre is at 0.5, 1.0, 1.5 ... m; its disc reaches 0.25 m to both sides, the gate is at 1.1 m.
TEST(Gate, ClosesWhenNoAgentStandsInIt) {
  World world = walker();
  const GateDescription description = gateAt(1.1);
  Gate gate(description);
  step(world);
  step(world);
  gate.update(world);
  EXPECT_TRUE(gate.isOpen());
  step(world);
  gate.update(world);
  EXPECT_FALSE(gate.isOpen());
}

TEST(Gate, AClosedOneReturnsWhenOthersRemoveItsWall) {
  World world = walker();
  const GateDescription description = gateAt(5.0);
  Gate gate(description);
  gate.update(world);
  WorldEditor(world).replaceWalls({});
  gate.update(world);
  EXPECT_EQ(world.walls().list().size(), 1U);
  WorldEditor(world).removeWall(world.walls().ids().back());
  gate.update(world);
  EXPECT_EQ(world.walls().list().size(), 1U);
  EXPECT_FALSE(gate.isOpen());
}

}  // namespace
}  // namespace crowd::gate_test
