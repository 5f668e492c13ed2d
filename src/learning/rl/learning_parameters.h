#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "common/portable_math.h"
#include "common/text/enum_names.h"
#include "common/text/number_range.h"

namespace crowd {

/// @brief How a greedy decision chooses among several actions of the highest value. first: the lowest number; random:
/// each with the same probability.
enum class Ties { FIRST, RANDOM };

inline constexpr EnumNames<Ties, 2> TIES{"ties", {"first", "random"}};

/// @brief Parameters of Q-learning (3.1). The defaults of alpha, gamma and lambda are the thesis's (3.2.1);
/// it prints no epsilon.
struct LearningParameters {
  static constexpr NumberRange ALPHA{0.0, 1.0, "", true, false};
  static constexpr NumberRange GAMMA{0.0, 1.0, "", false, true};
  static constexpr NumberRange FRACTION{0.0, 1.0};  ///< of the others

  double alpha = 0.1;    ///< learning rate, above 0, at most 1
  double gamma = 0.1;    ///< discount factor, from 0 to below 1
  double lambda = 0.0;   ///< decay of eligibility traces, 0 (no traces) to 1
  double epsilon = 0.1;  ///< probability of a random action while learning, 0 to 1
  /// The learning rate of the n-th visit of a row and action is max(alpha, n^-alpha_decay); 0 (always alpha) to 1.
  double alpha_decay = 0.0;
  bool mirrored = false;    ///< whether every experience is also learned with left and right exchanged
  Ties ties = Ties::FIRST;  ///< how greedy decisions choose among equal values

  /// @brief Returns the learning rate of visit number `visits` of a row and action, counted from 1.
  double learningRate(std::uint32_t visits) const {
    if (alpha_decay <= 0.0) return alpha;
    return std::max(alpha, portable::pow(static_cast<double>(visits), -alpha_decay));
  }
  /// @brief Returns a message that lists the values out of range; empty if there are none.
  std::string problems() const;
};

/// @brief Reads a learning parameter if the map has the key. @throws InputError with the place
void readParameter(const YamlMap& map, const std::string& key, double LearningParameters::*member,
                   LearningParameters& parameters);

/// @brief Epsilon by episode: from `first` to `last` within `episodes` episodes, then constant.
struct EpsilonSchedule {
  enum class Shape { LINEAR, EXPONENTIAL };
  static constexpr EnumNames<Shape, 2> SHAPES{"shape", {"linear", "exponential"}};
  double first = 0.1;
  double last = 0.1;
  std::uint64_t episodes = 0;
  Shape shape = Shape::LINEAR;

  static EpsilonSchedule constant(double epsilon) { return {epsilon, epsilon, 0, Shape::LINEAR}; }
  /// @brief Returns epsilon of an episode, counted from 0.
  double at(std::uint64_t episode) const;
};

/// @brief Reads a number, or {from, to, episodes, shape: linear|exponential}. @throws InputError
EpsilonSchedule readEpsilon(const YAML::Node& node, const YamlPlace& place);
/// @brief The same of a text. @param name name of the text in messages @throws InputError
EpsilonSchedule parseEpsilon(const std::string& text, const std::string& name);

/// @brief Returns the text that parseEpsilon() reads: a number if epsilon is constant, else {from: ..., to: ...,
/// ...}.
std::string toText(const EpsilonSchedule& schedule);

/// @brief Learning parameters with the schedule of epsilon, as in the section `learning` of a configuration.
struct LearningPlan {
  LearningParameters parameters;  ///< its epsilon is the first value of the schedule
  EpsilonSchedule epsilon;
};

/// @brief Reads a map {alpha, alpha_decay, gamma, lambda, mirrored, ties, epsilon}, all optional; epsilon is a number
/// or {from, to, episodes, shape: linear|exponential}. Missing keys are taken from `otherwise`. @throws InputError
LearningPlan readLearningPlan(const YAML::Node& node, const YamlPlace& place, const LearningPlan& otherwise = {});

/// @brief Returns a plan with the changes of a text such as "{alpha: 0.05, epsilon: 0}".
/// @param name name of the text in messages
/// @throws InputError as readLearningPlan() does, and if the text is not a map
LearningPlan changedPlan(const LearningPlan& plan, const std::string& text, const std::string& name);

/// @brief Returns the whole plan as changedPlan() reads it: {alpha: 0.1, ...}.
std::string toText(const LearningPlan& plan);

/// @brief Lists the differences: "alpha from 0.1 to 0.05, epsilon from 0.3 to 0"; empty if there are none.
std::string differences(const LearningPlan& before, const LearningPlan& after);

}  // namespace crowd
