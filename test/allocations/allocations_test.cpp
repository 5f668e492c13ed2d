#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include "robots/robot_senses.h"
#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "support/robots.h"
#include "support/straight_walk.h"

namespace {

std::atomic<std::uint64_t> allocations{0};
std::atomic<std::uint64_t> bytes_in_use{0};

void* allocate(std::size_t size) {
  ++allocations;
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  bytes_in_use += malloc_usable_size(memory);
  return memory;
}

void release(void* memory) {
  bytes_in_use -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

// All allocations of this executable are counted; new[] and the forms without exceptions call these operators.
void* operator new(std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { release(memory); }

namespace crowd::allocations_test {
namespace {

/// A lattice of agents that walk to and fro past each other, and a wall.
Scene lattice() {
  constexpr int COLUMNS = 20;
  Scene scene = scenes::scene({});
  scene.way_finding = false;  // ways are searched again from time to time, which allocates memory
  for (int i = 0; i < COLUMNS * COLUMNS; ++i) {
    const int row = i / COLUMNS;
    const Vector2 place(1.4 * (i % COLUMNS), 1.4 * row);
    const Vector2 goal = place + Vector2(i % 2 == 0 ? 100.0 : -100.0, 0.0);
    scene.agents.push_back(scenes::agent(place, goal));
  }
  scene.walls.push_back({{-50.0, -1.0}, {80.0, -1.0}});
  // Distant obstacles, so that the extent of the world does not grow.
  scene.obstacles = {scenes::pillar({-40.0, -40.0}, 0.5), scenes::pillar({70.0, 70.0}, 0.5)};
  return scene;
}

Learner makeLearner(Mode mode) {
  Learner::Options options;
  options.mode = mode;
  return {parseModel("{state_set: {type: anticipation}, action_set: {type: goal_relative}, reward: {type: progress}}"),
          options};
}

/// Whether a sequence of ticks allocates nothing. Its beginning depends on the scheduling of threads: a thread that had
/// no work before allocates its own workspace when it begins.
bool getsWarm(Mode mode, unsigned threads, const Scene& scene) {
  constexpr int ROW = 50;
  constexpr int MOST = 400;  // later the agents leave the lattice
  ThreadPool thread_pool(threads);
  Learner learner = makeLearner(mode);
  Episode episode(scene, 0, learner.model().vision(), thread_pool);
  CrowdDecider decider(learner, thread_pool);
  int quiet = 0;
  for (int tick = 0; tick < MOST && quiet < ROW; ++tick) {
    const std::uint64_t before = allocations;
    episode.walk(decider);
    quiet = allocations == before ? quiet + 1 : 0;
  }
  return quiet == ROW && !episode.isOver();
}

TEST(Allocations, CounterCountsAllocations) {
  const std::uint64_t before = allocations;
  const std::vector<int> something(100);
  EXPECT_EQ(allocations - before, 1U) << something.size();
}

TEST(Allocations, TicksEventuallyAllocateNothing) {
  for (const Mode mode : {Mode::DEMO, Mode::TRAINING}) {
    for (const unsigned threads : {1U, 2U}) {
      EXPECT_TRUE(getsWarm(mode, threads, lattice())) << MODES.nameOf(mode) << ", " << threads << " threads";
    }
  }
}

TEST(Allocations, NorDoTicksWithRobots) {
  RobotStart bar = robots::robot({10.0, -2.0});
  bar.footprint.corners = {{0.4, 0.2}, {-0.4, 0.2}, {-0.4, -0.2}, {0.4, -0.2}};
  for (const Contact contact : {Contact::GHOST, Contact::SOLID}) {
    Scene scene = robots::with({robots::robotTo({90.0, -1.5}, {0.0, -1.5}), bar}, lattice());
    scene.contact = contact;
    EXPECT_TRUE(getsWarm(Mode::DEMO, 1, scene)) << CONTACTS.nameOf(contact);
  }
}

/// 2 people enter per second, in ticks of 0.5 s, and are gone after some 6 s. There are walls on their way.
const char* const STREAM = R"(
sources: [{area: {box: [[0, -1], [0.5, 1]]}, rate: 2, interval: regular, route: through, speed: 1, radius: 0.1}]
routes: {through: {waypoints: [{sink: out}]}}
sinks: {out: {area: {box: [[5, -2], [6, 2]]}}}
)";

/// Most bytes in use in some ticks.
template <typename Walk>
std::uint64_t mostBytes(int ticks, const Walk& walk) {
  std::uint64_t most = 0;
  for (int tick = 0; tick < ticks; ++tick) {
    walk();
    most = std::max<std::uint64_t>(most, bytes_in_use);
  }
  return most;
}

/// A long time takes as much memory after 8,000 people have left as after 2,500, within 1 %. It is so long that what is
/// put aside for many people at a time is always among it. A learner serves them, but they walk straight.
void expectFlat(const Scene& scene, Mode mode) {
  const std::uint64_t before = bytes_in_use;
  Learner learner = makeLearner(mode);
  Episode episode(scene, 0, learner.model().vision());
  RobotSenses senses(scene);
  RelativeActions actions;
  const auto walk = [&] {
    learner.decide(episode.perceptions(), actions);
    straight_walk::step(episode);
    senses.observe(episode.world());
  };
  constexpr int LONG = 1500;  // [ticks]
  const auto walk_until = [&](std::size_t arrived) {
    while (episode.world().departed().arrived < arrived && !episode.isOver()) walk();
  };
  walk_until(2500);
  const std::uint64_t early = mostBytes(LONG, walk) - before;
  walk_until(8000);
  const std::uint64_t late = mostBytes(LONG, walk) - before;
  EXPECT_NEAR(static_cast<double>(late), static_cast<double>(early), 0.01 * static_cast<double>(early));
  EXPECT_GT(episode.result().arrivedCount(), 9000U);
}

TEST(Allocations, DoNotGrowWithPeopleWhoHaveLeft) {
  const Scene scene = straight_walk::sceneOf(STREAM, 10000.0);
  for (const Mode mode : {Mode::DEMO, Mode::TRAINING}) {
    SCOPED_TRACE(MODES.nameOf(mode));
    expectFlat(scene, mode);
  }
}

TEST(Allocations, NorBesideARobot) {
  RobotStart robot = robots::robot({9.0, 0.0});
  robot.scan.people = SeenPeople::LEGS;
  expectFlat(robots::with({robot}, straight_walk::sceneOf(STREAM, 10000.0)), Mode::DEMO);
}

}  // namespace
}  // namespace crowd::allocations_test
