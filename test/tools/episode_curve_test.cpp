#include "tools/terminal/episode_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace crowd::episode_curve_test {
namespace {

using Values = std::vector<double>;

EpisodeCurve curveOf(const Values& values, std::size_t bins) {
  EpisodeCurve curve(bins);
  for (const double value : values) curve.add(value);
  return curve;
}

TEST(EpisodeCurve, HasTheValuesAsLongAsTheyFit) {
  const EpisodeCurve curve = curveOf({1, 5, 2, 8}, 4);
  EXPECT_EQ(curve.episodes(), 4U);
  EXPECT_EQ(curve.binSize(), 1U);
  EXPECT_EQ(curve.means(4), (Values{1, 5, 2, 8}));
}

TEST(EpisodeCurve, JoinsNeighboursWhenItIsFull) {
  EpisodeCurve curve = curveOf({1, 5, 2, 8, 7}, 4);
  EXPECT_EQ(curve.binSize(), 2U);
  EXPECT_EQ(curve.means(3), (Values{3, 5, 7}));
  curve.add(9);
  EXPECT_EQ(curve.means(3), (Values{3, 5, 8}));
  for (const double value : {0, 2, 100}) curve.add(value);
  EXPECT_EQ(curve.episodes(), 9U);
  EXPECT_EQ(curve.binSize(), 4U);
  EXPECT_EQ(curve.means(3), (Values{4, 4.5, 100}));  // 1, 5, 2, 8; 7, 9, 0, 2; 100
}

TEST(EpisodeCurve, FewerPointsAreMeansOfBins) {
  EXPECT_EQ(curveOf({1, 5, 2, 8}, 4).means(2), (Values{3, 5}));
  EXPECT_EQ(curveOf({1, 5, 2, 8, 4}, 8).means(2), (Values{3, 14.0 / 3}));
}

TEST(EpisodeCurve, MorePointsRepeatBins) { EXPECT_EQ(curveOf({1, 5}, 4).means(5), (Values{1, 1, 1, 5, 5})); }

TEST(EpisodeCurve, LeavesOutWhatIsUnknown) {
  const EpisodeCurve curve = curveOf({NAN, 4, NAN, NAN}, 4);
  EXPECT_EQ(curve.means(1), Values{4});
  EXPECT_EQ(curve.means(2)[0], 4);
  EXPECT_TRUE(std::isnan(curve.means(2)[1]));
}

TEST(EpisodeCurve, EmptyAtFirst) {
  const EpisodeCurve curve(4);
  EXPECT_EQ(curve.episodes(), 0U);
  EXPECT_TRUE(std::isnan(curve.means(1)[0]));
}

TEST(EpisodeCurve, KeepsTheMeanOfALongRun) {
  EpisodeCurve curve(8);
  for (int i = 0; i < 8 * 1024; ++i) curve.add(i % 2);
  EXPECT_EQ(curve.binSize(), 1024U);
  EXPECT_EQ(curve.means(8), Values(8, 0.5));
}

}  // namespace
}  // namespace crowd::episode_curve_test
