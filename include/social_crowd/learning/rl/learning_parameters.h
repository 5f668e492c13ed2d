#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "social_crowd/common/yaml_reader.h"

namespace crowd {

/// @brief Which of several actions of the highest value a greedy decision takes. first: the one of the lowest number;
/// random: each of them with the same probability.
enum class Ties { FIRST, RANDOM };

/// @brief The names used in files. @throws InputError naming what was expected.
Ties parseTies(const std::string& text);
std::string toText(Ties ties);

/// @brief Parameters of Q-learning (3.1). The defaults are the thesis's.
struct LearningParameters {
  double alpha = 0.1;    ///< learning rate, above 0 to 1
  double gamma = 0.1;    ///< discount of what comes later, 0 to below 1
  double lambda = 0.0;   ///< how long traces last, 0 (none) to 1
  double epsilon = 0.1;  ///< share of decisions taken at random while learning, 0 to 1
  /// The n-th visit of a row and action steps by n^-alpha_decay as long as that is above alpha, 0 (always alpha) to 1.
  double alpha_decay = 0.0;
  bool mirrored = false;    ///< every experience is also learned with left and right exchanged
  Ties ties = Ties::FIRST;  ///< how greedy decisions choose between equal values

  /// @brief Share of the way to the target that a value goes when its row and action are visited for the n-th time.
  double learningRate(std::uint32_t visits) const {
    if (alpha_decay <= 0.0) return alpha;
    return std::max(alpha, std::pow(static_cast<double>(visits), -alpha_decay));
  }
  /// @brief What is wrong with the numbers, in words; empty if nothing is.
  std::string problems() const;
};

/// @brief Reads a learning parameter where the map has that key. @throws InputError that names the place
void readParameter(const YamlMap& map, const std::string& key, double LearningParameters::*member,
                   LearningParameters& parameters);

/// @brief Reads the key `ties`, where it is there. @throws InputError that names the place
Ties readTies(const YamlMap& map, Ties otherwise = Ties::FIRST);

/// @brief How epsilon changes over the episodes: from `first` to `last` within so many episodes, then `last`.
struct EpsilonSchedule {
  enum class Shape { LINEAR, EXPONENTIAL };
  double first = 0.1;
  double last = 0.1;
  std::uint64_t episodes = 0;
  Shape shape = Shape::LINEAR;

  static EpsilonSchedule constant(double epsilon) { return {epsilon, epsilon, 0, Shape::LINEAR}; }
  double at(std::uint64_t episode) const;
};

/// @brief As readLearningPlan() reads it: a number where it is constant, else {from: ..., to: ..., ...}.
std::string toText(const EpsilonSchedule& schedule);

/// @brief Learning parameters with the schedule of epsilon, as a configuration's section `learning` gives them.
struct LearningPlan {
  LearningParameters parameters;  ///< its epsilon is the schedule's first
  EpsilonSchedule epsilon;
};

/// @brief Reads a map {alpha, alpha_decay, gamma, lambda, mirrored, ties, epsilon}, all optional; epsilon is a number
/// or {from, to, episodes, shape: linear|exponential}. What is not named is taken from `otherwise`. @throws InputError
LearningPlan readLearningPlan(const YAML::Node& node, const YamlPlace& place, const LearningPlan& otherwise = {});

/// @brief The plan with what a text such as "{alpha: 0.05, epsilon: 0}" names changed, and the rest as it is; `name`
/// stands for the text in messages. @throws InputError as readLearningPlan() does, and if the text is no map
LearningPlan changedPlan(const LearningPlan& plan, const std::string& text, const std::string& name);

/// @brief All of the plan as changedPlan() reads it: {alpha: 0.1, ...}.
std::string toText(const LearningPlan& plan);

/// @brief What differs: "alpha from 0.1 to 0.05, epsilon from 0.3 to 0"; empty if nothing does.
std::string differences(const LearningPlan& before, const LearningPlan& after);

}  // namespace crowd
