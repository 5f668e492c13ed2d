#include "social_crowd/common/static_vector.h"

#include <gtest/gtest.h>

#include <vector>

namespace crowd {
namespace {

/// Neither to be made from nothing nor to be assigned to.
struct Note {
  const int& number;
  double weight;
};

TEST(StaticVector, KeepsWhatIsAddedUntilItIsFull) {
  const int one = 1;
  const int two = 2;
  StaticVector<Note, 2> notes;
  EXPECT_EQ(notes.size(), 0U);
  EXPECT_FALSE(notes.isFull());
  notes.add(one, 0.5);
  EXPECT_FALSE(notes.isFull());
  notes.add(Note{two, 1.5});
  EXPECT_TRUE(notes.isFull());
  EXPECT_EQ(&notes[0].number, &one);
  EXPECT_EQ(notes[0].weight, 0.5);
  EXPECT_EQ(&notes[1].number, &two);
  EXPECT_EQ(notes[1].weight, 1.5);
  notes.clear();
  EXPECT_EQ(notes.size(), 0U);
  EXPECT_EQ(notes.begin(), notes.end());
}

TEST(StaticVector, TakesTheLastOneAwayUnlessItIsToStay) {
  StaticVector<int, 4> numbers;
  for (const int number : {1, 2, 3, 4, 5, 6, 8}) {
    numbers.add(number);
    numbers.keepLastIf(number % 2 == 0);
  }
  EXPECT_EQ(std::vector<int>(numbers.begin(), numbers.end()), (std::vector<int>{2, 4, 6, 8}));
}

}  // namespace
}  // namespace crowd
