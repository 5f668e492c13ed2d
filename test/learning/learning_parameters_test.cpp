#include "learning/rl/learning_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/error_of.h"

namespace crowd::learning_parameters_test {
namespace {

using Shape = EpsilonSchedule::Shape;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

LearningPlan read(const std::string& yaml) { return readLearningPlan(YAML::Load(yaml), {"file.yaml", 0, "learning"}); }

std::string errorIn(const std::string& yaml) {
  return errorOf<InputError>([&] { read(yaml); });
}

std::string problemsOf(double alpha, double gamma, double lambda, double epsilon) {
  return LearningParameters{alpha, gamma, lambda, epsilon}.problems();
}

TEST(LearningParameters, HaveTheDefaultsOfTheThesis) {
  const LearningParameters parameters;
  EXPECT_EQ(parameters.alpha, 0.1);
  EXPECT_EQ(parameters.gamma, 0.1);
  EXPECT_EQ(parameters.lambda, 0.0);
  EXPECT_EQ(parameters.problems(), "");
}

TEST(LearningParameters, AcceptValuesAtTheLimits) {
  EXPECT_EQ(problemsOf(1.0, 0.0, 0.0, 0.0), "");
  EXPECT_EQ(problemsOf(1e-9, std::nextafter(1.0, 0.0), 1.0, 1.0), "");
}

TEST(LearningParameters, ErrorsNameTheInvalidParameter) {
  for (const double wrong : {0.0, -0.1, 1.1, NOT_A_NUMBER, INFINITE}) {
    EXPECT_EQ(problemsOf(wrong, 0.1, 0.1, 0.1).rfind("alpha: expected", 0), 0U) << wrong;
  }
  for (const double wrong : {1.0, -0.1, NOT_A_NUMBER, INFINITE}) {
    EXPECT_EQ(problemsOf(0.1, wrong, 0.1, 0.1).rfind("gamma: expected", 0), 0U) << wrong;
  }
  for (const double wrong : {1.1, -0.1, NOT_A_NUMBER, -INFINITE}) {
    EXPECT_EQ(problemsOf(0.1, 0.1, wrong, 0.1).rfind("lambda: expected", 0), 0U) << wrong;
    EXPECT_EQ(problemsOf(0.1, 0.1, 0.1, wrong).rfind("epsilon: expected", 0), 0U) << wrong;
  }
}

TEST(LearningParameters, ErrorsNameAllInvalidParameters) {
  const std::string problems = problemsOf(2.0, 1.0, -1.0, 1.5);
  for (const char* const part : {"alpha", "gamma", "lambda", "epsilon", "got 2", "got 1;", "got -1", "got 1.5"}) {
    EXPECT_TRUE(contains(problems, part)) << problems;
  }
}

TEST(EpsilonSchedule, CanBeConstant) {
  const EpsilonSchedule schedule = EpsilonSchedule::constant(0.25);
  EXPECT_EQ(schedule.at(0), 0.25);
  EXPECT_EQ(schedule.at(1000000), 0.25);
}

TEST(EpsilonSchedule, FallsLinearlyThenStays) {
  const EpsilonSchedule schedule = {0.5, 0.1, 8, Shape::LINEAR};
  EXPECT_DOUBLE_EQ(schedule.at(0), 0.5);
  EXPECT_DOUBLE_EQ(schedule.at(2), 0.4);  // 0.5 - 2/8 * 0.4
  EXPECT_DOUBLE_EQ(schedule.at(6), 0.2);
  EXPECT_DOUBLE_EQ(schedule.at(8), 0.1);
  EXPECT_DOUBLE_EQ(schedule.at(UINT64_MAX), 0.1);
}

TEST(EpsilonSchedule, FallsExponentiallyThenStays) {
  // From 0.8 to 0.1 is three halvings: one every two episodes.
  const EpsilonSchedule schedule = {0.8, 0.1, 6, Shape::EXPONENTIAL};
  EXPECT_DOUBLE_EQ(schedule.at(0), 0.8);
  EXPECT_DOUBLE_EQ(schedule.at(2), 0.4);
  EXPECT_DOUBLE_EQ(schedule.at(4), 0.2);
  EXPECT_DOUBLE_EQ(schedule.at(6), 0.1);
  EXPECT_DOUBLE_EQ(schedule.at(7), 0.1);
  EXPECT_NEAR(schedule.at(1), 0.8 / std::sqrt(2.0), 1e-12);
}

TEST(EpsilonSchedule, CanRise) {
  const EpsilonSchedule schedule = {0.0, 1.0, 4, Shape::LINEAR};
  EXPECT_EQ(schedule.at(0), 0.0);
  EXPECT_DOUBLE_EQ(schedule.at(1), 0.25);
  EXPECT_EQ(schedule.at(4), 1.0);
}

TEST(ReadLearningPlan, ReadsParametersAndUsesDefaults) {
  EXPECT_EQ(read("{alpha_decay: 0.6}").parameters.alpha_decay, 0.6);
  EXPECT_EQ(read("{}").parameters.alpha_decay, 0.0);
  EXPECT_TRUE(contains(errorIn("{alpha_decay: 2}"), "alpha_decay: expected a number from 0 to 1, got 2"));
  const LearningPlan plan = read("{alpha: 0.25, gamma: 0.95, lambda: 0.5, epsilon: 0.3}");
  EXPECT_EQ(plan.parameters.alpha, 0.25);
  EXPECT_EQ(plan.parameters.gamma, 0.95);
  EXPECT_EQ(plan.parameters.lambda, 0.5);
  EXPECT_EQ(plan.parameters.epsilon, 0.3);
  EXPECT_EQ(plan.epsilon.at(0), 0.3);
  EXPECT_EQ(plan.epsilon.at(99), 0.3);
  const LearningPlan defaults = read("{}");
  EXPECT_EQ(defaults.parameters.alpha, 0.1);
  EXPECT_EQ(defaults.parameters.gamma, 0.1);
  EXPECT_EQ(defaults.parameters.lambda, 0.0);
  EXPECT_EQ(defaults.epsilon.at(0), LearningParameters().epsilon);
}

TEST(ReadLearningPlan, ReadsTies) {
  EXPECT_EQ(read("{}").parameters.ties, Ties::FIRST);
  EXPECT_EQ(read("{ties: first}").parameters.ties, Ties::FIRST);
  EXPECT_EQ(read("{ties: random}").parameters.ties, Ties::RANDOM);
  EXPECT_TRUE(contains(errorIn("{ties: last}"), "learning.ties: expected first or random, got 'last'"));
  EXPECT_TRUE(contains(errorIn("{ties: [random]}"), "learning.ties: expected"));
}

TEST(ReadLearningPlan, ReadsSchedules) {
  const LearningPlan linear = read("{epsilon: {from: 0.5, to: 0.1, episodes: 8}}");
  EXPECT_DOUBLE_EQ(linear.epsilon.at(2), 0.4);
  EXPECT_EQ(linear.parameters.epsilon, 0.5);
  const LearningPlan exponential = read("{epsilon: {from: 0.8, to: 0.1, episodes: 6, shape: exponential}}");
  EXPECT_DOUBLE_EQ(exponential.epsilon.at(2), 0.4);
  EXPECT_EQ(read("{epsilon: {from: 1, to: 0, episodes: 2, shape: linear}}").epsilon.at(2), 0.0);
}

TEST(ReadLearningPlan, ErrorsNameWrongKeysAndValues) {
  EXPECT_TRUE(contains(errorIn("{alpha: 2}"), "alpha: expected a number above 0, at most 1, got 2"));
  EXPECT_TRUE(contains(errorIn("{gamma: 1}"), "gamma: expected"));
  EXPECT_TRUE(contains(errorIn("{lambda: -1}"), "lambda: expected"));
  EXPECT_TRUE(contains(errorIn("{alpha: fast}"), "learning.alpha: expected a number, got 'fast'"));
  EXPECT_TRUE(contains(errorIn("{epsilon: 1.5}"), "learning.epsilon: expected a number from 0 to 1"));
  EXPECT_TRUE(contains(errorIn("{epsilon: [0.1]}"), "learning.epsilon: expected"));
  EXPECT_TRUE(contains(errorIn("{beta: 1}"), "unknown key 'beta'"));
  EXPECT_TRUE(contains(errorIn("[0.1]"), "learning: expected a map"));
}

TEST(ReadLearningPlan, ErrorsNameWrongKeysAndValuesOfASchedule) {
  EXPECT_TRUE(contains(errorIn("{epsilon: {to: 0.1, episodes: 8}}"), "'from' is missing"));
  EXPECT_TRUE(contains(errorIn("{epsilon: {from: 0.5, episodes: 8}}"), "'to' is missing"));
  EXPECT_TRUE(contains(errorIn("{epsilon: {from: 0.5, to: 0.1}}"), "'episodes' is missing"));
  EXPECT_TRUE(contains(errorIn("{epsilon: {from: 0.5, to: 0.1, episodes: 0}}"), "learning.epsilon.episodes: expected"));
  EXPECT_TRUE(contains(errorIn("{epsilon: {from: 2, to: 0.1, episodes: 8}}"), "learning.epsilon.from: expected"));
  EXPECT_TRUE(contains(errorIn("{epsilon: {from: 1, to: -1, episodes: 8}}"), "learning.epsilon.to: expected"));
  EXPECT_TRUE(contains(errorIn("{epsilon: {from: 1, to: 0, episodes: 8, shape: round}}"),
                       "learning.epsilon.shape: expected linear or exponential, got 'round'"));
  EXPECT_TRUE(contains(errorIn("{epsilon: {from: 1, to: 0, episodes: 8, shape: exponential}}"), "above 0"));
  EXPECT_TRUE(contains(errorIn("{epsilon: {from: 0, to: 1, episodes: 8, shape: exponential}}"), "above 0"));
  EXPECT_TRUE(contains(errorIn("{epsilon: {from: 1, to: 0, episodes: 8, form: linear}}"), "unknown key 'form'"));
}

TEST(ParseEpsilon, ReadsANumberOrASchedule) {
  EXPECT_EQ(toText(parseEpsilon("0.25", "epsilon")), "0.25");
  const std::string text = "{from: 0.8, to: 0.1, episodes: 6, shape: exponential}";
  const EpsilonSchedule schedule = parseEpsilon(text, "epsilon");
  EXPECT_DOUBLE_EQ(schedule.at(0), 0.8);
  EXPECT_DOUBLE_EQ(schedule.at(2), 0.4);  // 0.8 (1 / 8)^(1 / 3)
  EXPECT_EQ(schedule.at(6), 0.1);
  EXPECT_EQ(toText(schedule), text);
  EXPECT_DOUBLE_EQ(parseEpsilon("from: 0.5\nto: 0.1\nepisodes: 8", "epsilon").at(2), 0.4);
}

TEST(ParseEpsilon, NamesWhatIsWrong) {
  const auto error = [](const std::string& text) {
    return errorOf<InputError>([&] { parseEpsilon(text, "epsilon"); });
  };
  EXPECT_EQ(error("1.5"), "epsilon: line 1: expected a number from 0 to 1, got '1.5'");
  EXPECT_EQ(error("{from: 2, to: 0, episodes: 8}"), "epsilon: line 1: from: expected a number from 0 to 1, got '2'");
  EXPECT_EQ(error("{from: 1, to: 0}"), "epsilon: line 1: the key 'episodes' is missing");
  EXPECT_TRUE(contains(error("{from: 1, to: 0, episodes: 8, shape: exponential}"), "above 0"));
  EXPECT_TRUE(contains(error("{from: 1, to: 0, episodes: 8, shape: round}"), "expected linear or exponential"));
  EXPECT_TRUE(contains(error("{from: 1, "), "not YAML"));
  for (const char* const text : {"", "lots", "[0.1]", "0.1\n---\n0.2"}) {
    EXPECT_TRUE(contains(error(text), "expected a number from 0 to 1")) << text;
  }
}

LearningPlan somePlan() {
  return read(
      "{alpha: 0.25, alpha_decay: 0.5, gamma: 0.95, lambda: 0.5, mirrored: true, ties: random, "
      "epsilon: {from: 0.5, to: 0.25, episodes: 8}}");
}

std::string errorInChange(const std::string& text) {
  return errorOf<InputError>([&] { changedPlan(somePlan(), text, "parameters"); });
}

TEST(ChangedPlan, KeepsParametersThatAreNotNamed) {
  const LearningPlan plan = somePlan();
  EXPECT_EQ(toText(changedPlan(plan, "{}", "parameters")), toText(plan));
  LearningPlan expected = plan;
  expected.parameters.alpha = 0.05;
  EXPECT_EQ(toText(changedPlan(plan, "{alpha: 0.05}", "parameters")), toText(expected));
  EXPECT_EQ(toText(changedPlan(plan, "alpha: 0.05", "parameters")), toText(expected));
  expected.parameters = {0.05, 0.0, 0.0, 0.0, 0.0, false, Ties::FIRST};
  expected.epsilon = EpsilonSchedule::constant(0.0);
  const std::string all =
      "{alpha: 0.05, alpha_decay: 0, gamma: 0, lambda: 0, mirrored: false, ties: first, epsilon: 0}";
  EXPECT_EQ(toText(changedPlan(plan, all, "parameters")), toText(expected));
  EXPECT_EQ(toText(expected), all);
}

TEST(ChangedPlan, ReadsBackItsText) {
  const std::string text =
      "{alpha: 0.25, alpha_decay: 0.5, gamma: 0.95, lambda: 0.5, mirrored: true, ties: random, "
      "epsilon: {from: 0.5, to: 0.25, episodes: 8, shape: linear}}";
  EXPECT_EQ(toText(somePlan()), text);
  EXPECT_EQ(toText(changedPlan({}, text, "parameters")), text);
}

TEST(ChangedPlan, ErrorsNameWrongKeysAndValues) {
  const std::string known = "Known are alpha, alpha_decay, gamma, lambda, mirrored, ties, epsilon";
  EXPECT_EQ(errorInChange("{alfa: 0.1}"), "parameters: line 1: unknown key 'alfa', did you mean 'alpha'? " + known);
  EXPECT_EQ(errorInChange("{alpha: 1, gama: 0.1}"),
            "parameters: line 1: unknown key 'gama', did you mean 'gamma'? " + known);
  EXPECT_EQ(errorInChange("{alpha: 0}"), "parameters: line 1: alpha: expected a number above 0, at most 1, got 0");
  EXPECT_EQ(errorInChange("{gamma: 1}"), "parameters: line 1: gamma: expected a number from 0 to below 1, got 1");
  EXPECT_EQ(errorInChange("{epsilon: 1.5}"), "parameters: line 1: epsilon: expected a number from 0 to 1, got '1.5'");
  EXPECT_EQ(errorInChange("{lambda: .nan}"), "parameters: line 1: lambda: expected a number, got '.nan'");
  for (const char* const text : {"", "0.05", "[alpha, 0.05]", "{alpha: 0.1}\n---\n{gamma: 0.1}"}) {
    EXPECT_TRUE(contains(errorInChange(text), "expected a map such as {alpha: 0.05, epsilon: 0}")) << text;
  }
  EXPECT_TRUE(contains(errorInChange("{alpha: 0.1, alpha: 0.2}"), "stands twice"));
  EXPECT_TRUE(contains(errorInChange("{alpha: "), "not YAML"));
}

TEST(Differences, NameTheChangedParameters) {
  const LearningPlan plan = somePlan();
  EXPECT_EQ(differences(plan, plan), "");
  EXPECT_EQ(differences(plan, changedPlan(plan, "{alpha: 0.05, mirrored: false, ties: random}", "f")),
            "alpha from 0.25 to 0.05, mirrored from true to false");
  EXPECT_EQ(differences(plan, changedPlan(plan, "{epsilon: 0}", "f")),
            "epsilon from {from: 0.5, to: 0.25, episodes: 8, shape: linear} to 0");
}

}  // namespace
}  // namespace crowd::learning_parameters_test
