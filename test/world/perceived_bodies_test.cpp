#include "social_crowd/world/perceived_bodies.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <string>

#include "support/scenes.h"

namespace crowd {
namespace {

constexpr BodyKind AGENT = BodyKind::AGENT;
constexpr BodyKind OBSTACLE = BodyKind::OBSTACLE;

PerceivedBody randomBody(KeyedRandom& random) {
  PerceivedBody body;
  body.position = scenes::randomPoint(random, 9.0);
  body.velocity = scenes::randomPoint(random, 2.0);
  body.radius = random.uniform(0.1, 1.0);
  body.kind = random.below(2) == 0 ? AGENT : OBSTACLE;
  return body;
}

void expectSame(const PerceivedBody& got, const PerceivedBody& expected) {
  EXPECT_EQ(got.position, expected.position);
  EXPECT_EQ(got.velocity, expected.velocity);
  EXPECT_EQ(got.radius, expected.radius);
  EXPECT_EQ(got.kind, expected.kind);
}

/// Body by body and number by number, of a list or a view.
template <typename Bodies>
void expectAll(const Bodies& bodies, const std::vector<PerceivedBody>& expected) {
  ASSERT_EQ(bodies.size(), expected.size());
  EXPECT_EQ(bodies.empty(), expected.empty());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    SCOPED_TRACE("body " + std::to_string(i));
    expectSame(bodies[i], expected[i]);
    expectSame(
        {{bodies.xs()[i], bodies.ys()[i]}, {bodies.vxs()[i], bodies.vys()[i]}, bodies.radii()[i], bodies.kinds()[i]},
        expected[i]);
  }
}

PerceivedBodies listOf(const std::vector<PerceivedBody>& bodies) {
  PerceivedBodies list;
  for (const PerceivedBody& body : bodies) list.push_back(body);
  return list;
}

/// Bodies at (0, 10), (1, 11), ... of these kinds.
std::vector<PerceivedBody> rowOf(const std::vector<BodyKind>& kinds) {
  std::vector<PerceivedBody> bodies;
  for (const BodyKind kind : kinds) {
    const auto number = static_cast<double>(bodies.size());
    bodies.push_back({{number, 10.0 + number}, {20.0 + number, 30.0 + number}, 40.0 + number, kind});
  }
  return bodies;
}

/// How many numbers there is memory for.
template <typename Number>
std::size_t roomAt(const Number* numbers) {
  return malloc_usable_size(const_cast<Number*>(numbers)) / sizeof(Number);
}

void expectMargin(const PerceivedBodies& bodies) {
  const std::size_t needed = bodies.size() + PerceivedBodies::MARGIN;
  for (const double* numbers : {bodies.xs(), bodies.ys(), bodies.vxs(), bodies.vys(), bodies.radii()}) {
    EXPECT_GE(roomAt(numbers), needed) << bodies.size() << " bodies";
  }
  EXPECT_GE(roomAt(bodies.kinds()), needed) << bodies.size() << " bodies";
}

TEST(PerceivedBody, RimDistanceByHand) {
  EXPECT_EQ(rimDistance({{3.0, -4.0}, {}, 1.0, AGENT}), 4.0);
  EXPECT_EQ(rimDistance({{3.0, -4.0}, {}, 5.0, OBSTACLE}), 0.0);
  EXPECT_EQ(rimDistance({{3.0, 4.0}, {}, 7.5, AGENT}), -2.5);  // from within
}

TEST(PerceivedBodies, BeginEmpty) {
  const PerceivedBodies bodies;
  EXPECT_TRUE(bodies.empty());
  EXPECT_EQ(bodies.size(), 0U);
}

TEST(PerceivedBodies, HoldWhatAnOrdinaryListHolds) {
  std::size_t longest = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    PerceivedBodies bodies;
    std::vector<PerceivedBody> expected;
    for (int change = 0; change < 200; ++change) {
      const auto size = static_cast<std::uint32_t>(expected.size());
      const std::uint32_t kind = random.below(40);
      if (kind == 0) {
        bodies.clear();
        expected.clear();
      } else if (kind == 1) {  // longer or shorter
        expected.resize(random.below(2 * size + 2));
        bodies.resize(expected.size());
        for (std::size_t i = size; i < expected.size(); ++i) bodies.set(i, expected[i] = randomBody(random));
      } else if (kind < 10 && size > 0) {
        const std::uint32_t i = random.below(size);
        bodies.set(i, expected[i] = randomBody(random));
      } else {
        expected.push_back(randomBody(random));
        bodies.push_back(expected.back());
      }
      ASSERT_NO_FATAL_FAILURE(expectAll(bodies, expected)) << "change " << change;
      longest = std::max(longest, expected.size());
    }
  }
  EXPECT_GT(longest, 100U);
}

TEST(PerceivedBodies, HaveAMarginBehindTheLast) {
  PerceivedBodies growing;
  for (std::size_t size = 0; size <= 200; ++size) {
    PerceivedBodies bodies;
    bodies.resize(size);
    expectMargin(bodies);
    if (size > 0) growing.push_back({});
    if (size > 0) expectMargin(growing);
  }
}

TEST(PerceivedBodies, KeepTheirMemoryWhenCleared) {
  PerceivedBodies bodies = listOf(rowOf(std::vector<BodyKind>(100, OBSTACLE)));
  const double* const xs = bodies.xs();
  const BodyKind* const kinds = bodies.kinds();
  bodies.clear();
  EXPECT_TRUE(bodies.empty());
  const std::vector<PerceivedBody> again = rowOf(std::vector<BodyKind>(100, AGENT));
  for (const PerceivedBody& body : again) bodies.push_back(body);
  expectAll(bodies, again);
  EXPECT_EQ(bodies.xs(), xs);
  EXPECT_EQ(bodies.kinds(), kinds);
}

TEST(PerceivedBodies, OfACopyAreItsOwn) {
  const std::vector<PerceivedBody> row = rowOf({AGENT, OBSTACLE});
  PerceivedBodies bodies = listOf(row);
  const PerceivedBodies copy = bodies;
  bodies.set(0, row[1]);
  expectAll(copy, row);
}

TEST(PerceivedBodiesView, IsAPartOfTheList) {
  const std::vector<PerceivedBody> row = rowOf({AGENT, OBSTACLE, AGENT, AGENT, OBSTACLE});
  const PerceivedBodies bodies = listOf(row);
  for (std::size_t first = 0; first <= row.size(); ++first) {
    for (std::size_t count = 0; first + count <= row.size(); ++count) {
      SCOPED_TRACE(testing::Message() << count << " from " << first);
      const auto begin = row.begin() + static_cast<std::ptrdiff_t>(first);
      const std::vector<PerceivedBody> part(begin, begin + static_cast<std::ptrdiff_t>(count));
      const PerceivedBodiesView view(bodies, first, count);
      expectAll(view, part);
      std::size_t met = 0;
      for (const PerceivedBody& body : view) expectSame(body, part.at(met++));
      EXPECT_EQ(met, count);
    }
  }
}

TEST(PerceivedBodiesView, FrontIsTheFirstOfIt) {
  const std::vector<PerceivedBody> row = rowOf({AGENT, OBSTACLE, AGENT, AGENT, OBSTACLE});
  const PerceivedBodies bodies = listOf(row);
  const PerceivedBodiesView view(bodies, 1, 3);
  expectAll(view.front(2), {row[1], row[2]});
  expectAll(view.front(3), {row[1], row[2], row[3]});
  expectAll(view.front(2).front(1), {row[1]});
  EXPECT_TRUE(view.front(0).empty());
}

TEST(PerceivedBodiesView, HasObstaclesOfItsOwnAlone) {
  const PerceivedBodies bodies = listOf(rowOf({AGENT, AGENT, OBSTACLE, AGENT, AGENT, OBSTACLE}));
  const auto has = [&](std::size_t first, std::size_t count) {
    return PerceivedBodiesView(bodies, first, count).hasObstacles();
  };
  EXPECT_TRUE(has(0, 6));
  EXPECT_FALSE(has(0, 2));  // the next one is an obstacle
  EXPECT_TRUE(has(0, 3));
  EXPECT_TRUE(has(2, 1));
  EXPECT_TRUE(has(2, 3));
  EXPECT_FALSE(has(3, 2));  // between two obstacles
  EXPECT_TRUE(has(3, 3));
  EXPECT_FALSE(has(2, 0));
  EXPECT_FALSE(PerceivedBodiesView(bodies, 1, 3).front(1).hasObstacles());
}

TEST(PerceivedBodiesView, HasAnObstacleWhereverItStands) {
  for (std::size_t count = 0; count <= 20; ++count) {
    for (std::size_t place = 0; place < 24; ++place) {
      std::vector<BodyKind> kinds(24, AGENT);
      kinds[place] = OBSTACLE;
      const PerceivedBodies bodies = listOf(rowOf(kinds));
      for (std::size_t first = 0; first < 4; ++first) {
        EXPECT_EQ(PerceivedBodiesView(bodies, first, count).hasObstacles(), place >= first && place < first + count)
            << count << " bodies from " << first << ", an obstacle at " << place;
      }
    }
  }
}

TEST(PerceivedBodiesView, ObstaclesThatWereClearedAreForgotten) {
  PerceivedBodies bodies = listOf(rowOf(std::vector<BodyKind>(20, OBSTACLE)));
  bodies.clear();
  EXPECT_FALSE(PerceivedBodiesView(bodies, 0, 0).hasObstacles());
  bodies.push_back({});
  bodies.push_back({});
  EXPECT_FALSE(PerceivedBodiesView(bodies, 0, bodies.size()).hasObstacles());
}

}  // namespace
}  // namespace crowd
