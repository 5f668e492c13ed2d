#include "learning/model.h"

#include <gtest/gtest.h>

#include "common/text/numbers.h"
#include "support/error_of.h"

namespace crowd::model_test {
namespace {

const char* const NEAREST =
    "state_set: {type: nearest_obstacle, goal_sectors: 8, obstacle_sectors: [15, 45, 90, 180], collision_radius: 0.5, "
    "vision_radius: 1}\n"
    "action_set: {type: kings_moves, rotations: 8}\n"
    "reward: {goal: cosine_cubed, arrival: 100, obstacle_cost: 80}\n";
const char* const OCCUPANCY =
    "state_set: {type: occupancy, sectors: 4, collision_radius: 0.1, vision_radius: 2.5}\n"
    "action_set: {type: kings_moves, rotations: 5}\n"
    "reward: {goal: distance_gained, arrival: -1, obstacle_cost: 0.001}\n";

/// A model with one part replaced.
Model modelWith(const std::string& part, const std::string& instead) {
  std::string spec = NEAREST;
  spec.replace(spec.find(part), part.size(), instead);
  return parseModel(spec);
}

std::string errorIn(const std::string& spec) {
  return errorOf<InputError>([&] { parseModel(spec); });
}

std::string errorInStateSet(const std::string& state_set) {
  return errorIn("{state_set: " + state_set +
                 ", action_set: {type: kings_moves}, reward: {goal: cosine_cubed, obstacle_cost: 80}}");
}

TEST(Model, AgreesWithItsSpec) {
  const Model nearest = parseModel(NEAREST);
  EXPECT_EQ(nearest.spec(), NEAREST);
  EXPECT_EQ(nearest.state_set->rowCount(), 137U);
  EXPECT_EQ(nearest.action_set->size(), 8U);
  const Model occupancy = parseModel(OCCUPANCY);
  EXPECT_EQ(occupancy.spec(), OCCUPANCY);
  EXPECT_EQ(occupancy.state_set->rowCount(), 325U);  // 3^4 * 4 + 1
  EXPECT_EQ(occupancy.action_set->size(), 5U);
}

TEST(Model, UsesTheDefaultsOfTheThesis) {
  EXPECT_EQ(parseModel("{state_set: {type: nearest_obstacle}, action_set: {type: kings_moves}, "
                       "reward: {goal: cosine_cubed, obstacle_cost: 80}}")
                .spec(),
            NEAREST);
  EXPECT_EQ(parseModel("{state_set: {type: occupancy}, action_set: {type: kings_moves}, "
                       "reward: {goal: cosine_cubed, obstacle_cost: 10}}")
                .state_set->spec(),
            "{type: occupancy, sectors: 8, collision_radius: 0.5, vision_radius: 1}");
}

TEST(Model, HasTheVisionOfItsStateSet) {
  // Slightly larger, so that the state set itself decides about bodies exactly at its limit.
  EXPECT_GT(parseModel(NEAREST).vision().radius, 1.0);
  EXPECT_LT(parseModel(NEAREST).vision().radius, 1.001);
  EXPECT_GT(parseModel(OCCUPANCY).vision().radius, 2.5);
  EXPECT_LT(parseModel(OCCUPANCY).vision().radius, 2.501);
  EXPECT_EQ(parseModel(OCCUPANCY).vision().max_neighbours, 0U);
}

TEST(Model, OcclusionIsOffByDefault) {
  EXPECT_FALSE(parseModel(NEAREST).vision().occlusion);
  const std::string spec = std::string(NEAREST) + "vision: {occlusion: true}\n";
  const Model model = parseModel(spec);
  EXPECT_TRUE(model.vision().occlusion);
  EXPECT_EQ(model.spec(), spec);
  EXPECT_EQ(parseModel(std::string(NEAREST) + "vision: {occlusion: false}\n").spec(), NEAREST);
  EXPECT_TRUE(model.fits(parseModel(NEAREST)));
  EXPECT_TRUE(contains(errorIn(std::string(NEAREST) + "vision: {occlusion: maybe}\n"), "vision.occlusion: expected"));
  EXPECT_TRUE(contains(errorIn(std::string(NEAREST) + "vision: {radius: 2}\n"), "unknown key 'radius'"));
}

TEST(Model, FitsModelsWithEqualStatesAndActions) {
  const Model model = parseModel(NEAREST);
  EXPECT_TRUE(model.fits(model));
  EXPECT_TRUE(model.fits(modelWith("obstacle_cost: 80", "obstacle_cost: 10")));
  EXPECT_TRUE(model.fits(modelWith("vision_radius: 1", "vision_radius: 1.0")));  // the same number
  EXPECT_FALSE(model.fits(modelWith("vision_radius: 1", "vision_radius: 2")));
  EXPECT_FALSE(model.fits(modelWith("collision_radius: 0.5", "collision_radius: 0.25")));
  EXPECT_FALSE(model.fits(modelWith("[15, 45, 90, 180]", "[30, 45, 90, 180]")));
  EXPECT_FALSE(model.fits(modelWith("rotations: 8", "rotations: 16")));
  EXPECT_FALSE(model.fits(parseModel(OCCUPANCY)));
}

TEST(Model, RefusesTheTableOfAnotherModel) {
  const Model model = parseModel(NEAREST);
  EXPECT_NO_THROW(requireFit(model, modelWith("obstacle_cost: 80", "obstacle_cost: 10"), "file.txt"));
  const Model other = parseModel(OCCUPANCY);
  const std::string message = errorOf<ShapeError>([&] { requireFit(model, other, "file.txt"); });
  EXPECT_EQ(message.rfind("file.txt: ", 0), 0U) << message;
  EXPECT_TRUE(contains(message, model.state_set->spec())) << message;
  EXPECT_TRUE(contains(message, other.state_set->spec())) << message;
}

TEST(ParseModel, ErrorsNameMissingAndUnknownKeys) {
  const std::string states = "state_set: {type: occupancy}";
  const std::string actions = "action_set: {type: kings_moves}";
  const std::string reward = "reward: {goal: cosine_cubed, obstacle_cost: 80}";
  EXPECT_TRUE(contains(errorIn("{" + actions + ", " + reward + "}"), "'state_set' is missing"));
  EXPECT_TRUE(contains(errorIn("{" + states + ", " + reward + "}"), "'action_set' is missing"));
  EXPECT_TRUE(contains(errorIn("{" + states + ", " + actions + "}"), "'reward' is missing"));
  EXPECT_TRUE(contains(errorIn("{" + states + ", " + actions + ", " + reward + ", a: 1}"), "unknown key 'a'"));
}

TEST(ParseModel, RefusesInvalidYamlAndAnythingButMaps) {
  EXPECT_NE(errorIn("state_set: {type: occupancy"), "no error");
  EXPECT_NE(errorIn("a: b: c"), "no error");
  EXPECT_NE(errorIn(""), "no error");
  EXPECT_NE(errorIn("just words"), "no error");
  EXPECT_NE(errorIn("[1, 2]"), "no error");
}

TEST(ParseModel, RefusesInvalidStateSets) {
  EXPECT_TRUE(contains(errorInStateSet("{type: nearest}"),
                       "state_set.type: expected " + namesOf(stateSetTypes()) + ", got 'nearest'"));
  EXPECT_TRUE(contains(errorInStateSet("{sectors: 8}"), "'type' is missing"));
  EXPECT_TRUE(contains(errorInStateSet("{type: occupancy, goal_sectors: 8}"), "unknown key 'goal_sectors'"));
  for (const char* const wrong : {"sectors: 1", "sectors: 13", "sectors: 8.5", "sectors: -8"}) {
    const std::string message = errorInStateSet("{type: occupancy, " + std::string(wrong) + "}");
    EXPECT_TRUE(contains(message, "state_set.sectors: expected")) << message;
  }
  for (const char* const wrong : {"goal_sectors: 0", "goal_sectors: 65"}) {
    const std::string message = errorInStateSet("{type: nearest_obstacle, " + std::string(wrong) + "}");
    EXPECT_TRUE(contains(message, "state_set.goal_sectors: expected")) << message;
  }
  for (const char* const wrong : {"[]", "180", "[15, 45]", "[45, 15, 180]", "[45, 45, 180]", "[0, 180]", "[-15, 180]",
                                  "[15, 180, 360]", "[15, wide, 180]"}) {
    const std::string message =
        errorInStateSet("{type: nearest_obstacle, obstacle_sectors: " + std::string(wrong) + "}");
    EXPECT_TRUE(contains(message, "state_set.obstacle_sectors")) << message;
  }
}

TEST(ParseModel, RefusesInvalidRadii) {
  for (const char* const type : {"nearest_obstacle", "occupancy", "condensed_occupancy"}) {
    for (const char* const wrong : {"collision_radius: 0", "collision_radius: -1", "vision_radius: nan",
                                    "vision_radius: 0.5", "vision_radius: 0.25", "collision_radius: 1"}) {
      const std::string message = errorInStateSet("{type: " + std::string(type) + ", " + wrong + "}");
      EXPECT_TRUE(contains(message, "_radius: expected")) << wrong << ": " << message;
    }
  }
}

TEST(ParseModel, RefusesNumbersBeyondTheLimits) {
  const auto expect = [](const std::string& state_set, const std::string& expected) {
    const std::string message = errorInStateSet(state_set);
    EXPECT_TRUE(contains(message, expected)) << message;
  };
  expect("{type: occupancy, vision_radius: 1e17}", "vision_radius: expected at most 1e+06 m, got '1e17'");
  expect("{type: occupancy, collision_radius: 1e17}", "collision_radius: expected at most 1e+06 m, got '1e17'");
  expect("{type: anticipation, vision_radius: 1e17}", "vision_radius: expected at most 1e+06 m, got '1e17'");
  expect("{type: anticipation, max_neighbours: 2000000000}",
         "max_neighbours: expected a whole number from 0 to 1000, got '2000000000'");
}

/// A list of this many rising numbers up to 1.
std::string risingList(int count) {
  std::string list;
  for (int i = 1; i <= count; ++i) list += (i > 1 ? ", " : "[") + toText(static_cast<double>(i) / count);
  return list + "]";
}

TEST(ParseModel, RefusesTablesThatAreTooLarge) {
  // 1000 * 1000 * 5000 rows do not even have numbers of 32 bits.
  const std::string message = errorInStateSet("{type: anticipation, reciprocal_times: " + risingList(999) +
                                              ", static_times: " + risingList(999) + ", turns: " + risingList(4999) +
                                              ", constant_velocity_times: [], admissible_fractions: [], oncoming: []}");
  EXPECT_TRUE(contains(message, "state_set: expected limits for at most 100000000 rows, got 5e+09")) << message;
  const std::string table = errorIn(
      "{state_set: {type: occupancy, sectors: 12}, action_set: {type: kings_moves, rotations: 16}, "
      "reward: {goal: cosine_cubed, obstacle_cost: 80}}");
  EXPECT_TRUE(contains(table, "state_set: expected a Q-table of at most 100000000 values, got 6377293 rows of 16"))
      << table;
}

}  // namespace
}  // namespace crowd::model_test
