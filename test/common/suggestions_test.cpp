#include "common/text/suggestions.h"

#include <gtest/gtest.h>

namespace crowd::suggestions_test {
namespace {

TEST(EditDistance, CountsInsertedOmittedReplacedAndExchangedLetters) {
  EXPECT_EQ(editDistance("", ""), 0U);
  EXPECT_EQ(editDistance("speed", "speed"), 0U);
  EXPECT_EQ(editDistance("", "abc"), 3U);
  EXPECT_EQ(editDistance("sped", "speed"), 1U);     // one omitted
  EXPECT_EQ(editDistance("speeed", "speed"), 1U);   // one inserted
  EXPECT_EQ(editDistance("raduis", "radius"), 1U);  // two exchanged
  EXPECT_EQ(editDistance("alfa", "alpha"), 2U);     // one replaced, one inserted
  EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
}

TEST(NearestName, IsAtMostTwoEditsAway) {
  EXPECT_EQ(nearestName("raduis", {"position", "speed", "radius"}), "radius");
  EXPECT_EQ(nearestName("alfa", {"gamma", "alpha"}), "alpha");
  EXPECT_EQ(nearestName("circel12", {"circle6", "circle12", "circle12_varied"}), "circle12");
  EXPECT_EQ(nearestName("colour", {"position", "speed", "radius"}), "");
  EXPECT_EQ(nearestName("raduis", {}), "");
}

TEST(NearestName, IsEmptyIfEveryLetterDiffers) {
  EXPECT_EQ(nearestName("a", {"b"}), "");    // one edit of one letter
  EXPECT_EQ(nearestName("ab", {"cd"}), "");  // two edits of two
  EXPECT_EQ(nearestName("goa", {"goal"}), "goal");
}

/// This would take minutes if distances were computed.
TEST(NearestName, IsNotSearchedForALongText) {
  EXPECT_EQ(nearestName(std::string(100'000'000, 'a'), std::vector<std::string>(100, std::string(1000, 'a'))), "");
}

TEST(NearestName, IsTheFirstOfEquallyNearOnes) {
  EXPECT_EQ(nearestName("gate_3", {"gate_10", "gate_1", "gate_2"}), "gate_1");
  EXPECT_EQ(nearestName("gate_2", {"gate_1", "gate_2", "gate_2"}), "gate_2");
}

TEST(DidYouMean, IsAQuestionOrEmpty) {
  EXPECT_EQ(didYouMean("pacee", {"pace", "seed"}, "~"), ", did you mean '~pace'?");
  EXPECT_EQ(didYouMean("colour", {"pace", "seed"}), "");
}

TEST(SortedByNearness, KeepsTheOrderOfEquallyNearNames) {
  EXPECT_EQ(sortedByNearness("circel6", {"dummies", "line6", "circle6", "circle12"}).front(), "circle6");
  EXPECT_EQ(sortedByNearness("aa", {"ac", "ab", "aa"}), (std::vector<std::string>{"aa", "ac", "ab"}));
}

TEST(JoinNames, CutsLongNamesAndManyNames) {
  EXPECT_EQ(joinNames({"a", "b"}, "~"), "~a, ~b");
  EXPECT_EQ(joinNames({std::string(1000, 'a'), "b"}), std::string(80, 'a') + "..., b");
  const std::string many = joinNames(std::vector<std::string>(1000, "a"));
  EXPECT_LT(many.size(), 1000U);
  EXPECT_EQ(many.substr(many.rfind(',')), ", a and 800 more");
}

}  // namespace
}  // namespace crowd::suggestions_test
