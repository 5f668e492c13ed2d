#pragma once

#include <map>
#include <set>
#include <string>

#include "world/perception.h"

namespace crowd {

/// @brief The vision that each learner has reported, and the widest of them. A new report of a learner replaces
/// its previous one. Reports of learners that have left are kept: wider perceptions do not change the decisions of the
/// others.
class LearnerVisions {
 public:
  /// @brief Records a report. An invalid radius is ignored with a warning.
  /// @param vision with radius 0: none is requested
  void report(const std::string& learner, const Vision& vision);
  /// @brief Forgets the motion limits of all learners but these, unless there are none; a forgotten one reports again
  /// if it needs other limits than are used.
  void keepMotionOf(const std::set<std::string>& learners);
  /// @brief Returns the widest vision of all learners; before the first report, the default vision.
  const Vision& widest() const { return widest_; }

 private:
  void findWidest();

  std::map<std::string, Vision> reported_;  // by learner
  Vision widest_;
};

}  // namespace crowd
