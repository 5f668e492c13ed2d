#pragma once

#include <algorithm>

#include "learning/rl/q_table.h"

namespace crowd {

/// @brief Value of PolicyDraws::tie that selects the first of equal values.
constexpr double FIRST_OF_TIES = 0.0;

/// @brief Returns the greedy action.
/// @param tie uniform in [0, 1), decides among equal values; FIRST_OF_TIES: the first
inline Action chooseGreedy(const QTable& table, const Rows& rows, double tie = FIRST_OF_TIES) {
  return tie > FIRST_OF_TIES ? table.greedyAction(rows, tie) : table.greedyAction(rows);
}

/// @brief Random numbers of one epsilon-greedy decision, each uniform in [0, 1).
struct PolicyDraws {
  double explore = 0.0;        ///< decides whether to explore
  double any = 0.0;            ///< decides which action is explored
  double tie = FIRST_OF_TIES;  ///< as in chooseGreedy()
};

/// @brief Returns the epsilon-greedy action: with probability epsilon any action, else the greedy one.
inline Action chooseEpsilonGreedy(const QTable& table, const Rows& rows, double epsilon, const PolicyDraws& draws) {
  if (draws.explore >= epsilon) return chooseGreedy(table, rows, draws.tie);
  return std::min(static_cast<Action>(draws.any * table.actions()), table.actions() - 1);
}

}  // namespace crowd
