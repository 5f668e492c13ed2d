#include "world/neighbours.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <string>

#include "support/scenes.h"

namespace crowd::neighbours_test {
namespace {

constexpr NeighbourKind AGENT = NeighbourKind::AGENT;
constexpr NeighbourKind OBSTACLE = NeighbourKind::OBSTACLE;

Neighbour randomNeighbour(KeyedRandom& random) {
  Neighbour neighbour;
  neighbour.position = scenes::randomPoint(random, 9.0);
  neighbour.velocity = scenes::randomPoint(random, 2.0);
  neighbour.radius = random.uniform(0.1, 1.0);
  neighbour.kind = random.below(2) == 0 ? AGENT : OBSTACLE;
  return neighbour;
}

void expectSame(const Neighbour& got, const Neighbour& expected) {
  EXPECT_EQ(got.position, expected.position);
  EXPECT_EQ(got.velocity, expected.velocity);
  EXPECT_EQ(got.radius, expected.radius);
  EXPECT_EQ(got.kind, expected.kind);
}

/// Body by body and number by number, of a list or a view.
template <typename Bodies>
void expectAll(const Bodies& neighbours, const std::vector<Neighbour>& expected) {
  ASSERT_EQ(neighbours.size(), expected.size());
  EXPECT_EQ(neighbours.empty(), expected.empty());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    SCOPED_TRACE("body " + std::to_string(i));
    expectSame(neighbours[i], expected[i]);
    expectSame({{neighbours.xs()[i], neighbours.ys()[i]},
                {neighbours.vxs()[i], neighbours.vys()[i]},
                neighbours.radii()[i],
                neighbours.kinds()[i]},
               expected[i]);
  }
}

NeighbourList listOf(const std::vector<Neighbour>& neighbours) {
  NeighbourList list;
  for (const Neighbour& neighbour : neighbours) list.push_back(neighbour);
  return list;
}

/// Bodies at (0, 10), (1, 11), ... of these kinds.
std::vector<Neighbour> rowOf(const std::vector<NeighbourKind>& kinds) {
  std::vector<Neighbour> neighbours;
  for (const NeighbourKind kind : kinds) {
    const auto number = static_cast<double>(neighbours.size());
    neighbours.push_back({{number, 10.0 + number}, {20.0 + number, 30.0 + number}, 40.0 + number, kind});
  }
  return neighbours;
}

/// How many numbers there is memory for.
template <typename Number>
std::size_t roomAt(const Number* numbers) {
  return malloc_usable_size(const_cast<Number*>(numbers)) / sizeof(Number);
}

void expectMargin(const NeighbourList& neighbours) {
  const std::size_t needed = neighbours.size() + NeighbourList::PADDING;
  for (const double* numbers :
       {neighbours.xs(), neighbours.ys(), neighbours.vxs(), neighbours.vys(), neighbours.radii()}) {
    EXPECT_GE(roomAt(numbers), needed) << neighbours.size() << " bodies";
  }
  EXPECT_GE(roomAt(neighbours.kinds()), needed) << neighbours.size() << " bodies";
}

TEST(Neighbour, RimDistanceByHand) {
  EXPECT_EQ(rimDistance({{3.0, -4.0}, {}, 1.0, AGENT}), 4.0);
  EXPECT_EQ(rimDistance({{3.0, -4.0}, {}, 5.0, OBSTACLE}), 0.0);
  EXPECT_EQ(rimDistance({{3.0, 4.0}, {}, 7.5, AGENT}), -2.5);  // from within
}

TEST(NeighbourList, IsEmptyAtFirst) {
  const NeighbourList neighbours;
  EXPECT_TRUE(neighbours.empty());
  EXPECT_EQ(neighbours.size(), 0U);
}

TEST(NeighbourList, AgreesWithAStandardVector) {
  std::size_t longest = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    NeighbourList neighbours;
    std::vector<Neighbour> expected;
    for (int change = 0; change < 200; ++change) {
      const auto size = static_cast<std::uint32_t>(expected.size());
      const std::uint32_t kind = random.below(40);
      if (kind == 0) {
        neighbours.clear();
        expected.clear();
      } else if (kind == 1) {  // longer or shorter
        expected.resize(random.below(2 * size + 2));
        neighbours.resize(expected.size());
        for (std::size_t i = size; i < expected.size(); ++i) neighbours.set(i, expected[i] = randomNeighbour(random));
      } else if (kind < 10 && size > 0) {
        const std::uint32_t i = random.below(size);
        neighbours.set(i, expected[i] = randomNeighbour(random));
      } else {
        expected.push_back(randomNeighbour(random));
        neighbours.push_back(expected.back());
      }
      ASSERT_NO_FATAL_FAILURE(expectAll(neighbours, expected)) << "change " << change;
      longest = std::max(longest, expected.size());
    }
  }
  EXPECT_GT(longest, 100U);
}

TEST(NeighbourList, HasPaddingBehindTheLastNeighbour) {
  NeighbourList growing;
  for (std::size_t size = 0; size <= 200; ++size) {
    NeighbourList neighbours;
    neighbours.resize(size);
    expectMargin(neighbours);
    if (size > 0) growing.push_back({});
    if (size > 0) expectMargin(growing);
  }
}

TEST(NeighbourList, KeepsItsMemoryWhenCleared) {
  NeighbourList neighbours = listOf(rowOf(std::vector<NeighbourKind>(100, OBSTACLE)));
  const double* const xs = neighbours.xs();
  const NeighbourKind* const kinds = neighbours.kinds();
  neighbours.clear();
  EXPECT_TRUE(neighbours.empty());
  const std::vector<Neighbour> again = rowOf(std::vector<NeighbourKind>(100, AGENT));
  for (const Neighbour& neighbour : again) neighbours.push_back(neighbour);
  expectAll(neighbours, again);
  EXPECT_EQ(neighbours.xs(), xs);
  EXPECT_EQ(neighbours.kinds(), kinds);
}

TEST(NeighbourList, CopiesAreIndependent) {
  const std::vector<Neighbour> row = rowOf({AGENT, OBSTACLE});
  NeighbourList neighbours = listOf(row);
  const NeighbourList copy = neighbours;
  neighbours.set(0, row[1]);
  expectAll(copy, row);
}

TEST(NeighbourSpan, ShowsAPartOfTheList) {
  const std::vector<Neighbour> row = rowOf({AGENT, OBSTACLE, AGENT, AGENT, OBSTACLE});
  const NeighbourList neighbours = listOf(row);
  for (std::size_t first = 0; first <= row.size(); ++first) {
    for (std::size_t count = 0; first + count <= row.size(); ++count) {
      SCOPED_TRACE(testing::Message() << count << " from " << first);
      const auto begin = row.begin() + static_cast<std::ptrdiff_t>(first);
      const std::vector<Neighbour> part(begin, begin + static_cast<std::ptrdiff_t>(count));
      const NeighbourSpan view(neighbours, first, count);
      expectAll(view, part);
      std::size_t met = 0;
      for (const Neighbour& neighbour : view) expectSame(neighbour, part.at(met++));
      EXPECT_EQ(met, count);
    }
  }
}

TEST(NeighbourSpan, FrontReturnsTheFirstNeighbours) {
  const std::vector<Neighbour> row = rowOf({AGENT, OBSTACLE, AGENT, AGENT, OBSTACLE});
  const NeighbourList neighbours = listOf(row);
  const NeighbourSpan view(neighbours, 1, 3);
  expectAll(view.front(2), {row[1], row[2]});
  expectAll(view.front(3), {row[1], row[2], row[3]});
  expectAll(view.front(2).front(1), {row[1]});
  EXPECT_TRUE(view.front(0).empty());
}

TEST(NeighbourSpan, HasObstaclesChecksItsOwnPartOnly) {
  const NeighbourList neighbours = listOf(rowOf({AGENT, AGENT, OBSTACLE, AGENT, AGENT, OBSTACLE}));
  const auto has = [&](std::size_t first, std::size_t count) {
    return NeighbourSpan(neighbours, first, count).hasObstacles();
  };
  EXPECT_TRUE(has(0, 6));
  EXPECT_FALSE(has(0, 2));  // the next one is an obstacle
  EXPECT_TRUE(has(0, 3));
  EXPECT_TRUE(has(2, 1));
  EXPECT_TRUE(has(2, 3));
  EXPECT_FALSE(has(3, 2));  // between two obstacles
  EXPECT_TRUE(has(3, 3));
  EXPECT_FALSE(has(2, 0));
  EXPECT_FALSE(NeighbourSpan(neighbours, 1, 3).front(1).hasObstacles());
}

TEST(NeighbourSpan, FindsAnObstacleAtAnyPosition) {
  for (std::size_t count = 0; count <= 20; ++count) {
    for (std::size_t place = 0; place < 24; ++place) {
      std::vector<NeighbourKind> kinds(24, AGENT);
      kinds[place] = OBSTACLE;
      const NeighbourList neighbours = listOf(rowOf(kinds));
      for (std::size_t first = 0; first < 4; ++first) {
        EXPECT_EQ(NeighbourSpan(neighbours, first, count).hasObstacles(), place >= first && place < first + count)
            << count << " bodies from " << first << ", an obstacle at " << place;
      }
    }
  }
}

TEST(NeighbourSpan, ForgetsClearedObstacles) {
  NeighbourList neighbours = listOf(rowOf(std::vector<NeighbourKind>(20, OBSTACLE)));
  neighbours.clear();
  EXPECT_FALSE(NeighbourSpan(neighbours, 0, 0).hasObstacles());
  neighbours.push_back({});
  neighbours.push_back({});
  EXPECT_FALSE(NeighbourSpan(neighbours, 0, neighbours.size()).hasObstacles());
}

}  // namespace
}  // namespace crowd::neighbours_test
