#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "social_crowd/simulation/lockstep.h"

namespace crowd {

/// @brief Which controller's perceptions a message answers.
enum class RunCheck {
  OWN,
  EARLIER,  ///< another controller's, in the learner's first message: a latched one from before
  OTHER,    ///< another controller's, or none is named
};

/// @brief The learners that have answered the controller: their names and what was refused of them. Warns once for
/// each learner and cause. Called in the controller's main loop.
class AnsweringLearners {
 public:
  /// @param run of this controller
  explicit AnsweringLearners(std::uint64_t run) : run_(run) {}

  /// @brief The number of a learner; a new one for a new name.
  /// @param node of the ROS node that published the answer, which with nodelets may hold several learners
  LearnerId numberOf(const std::string& learner, const std::string& node);
  /// @brief Whose answers a message holds, by the run that it names. Warns of OTHER.
  RunCheck checkRun(std::uint64_t run, LearnerId learner);
  void noteTaken(LearnerId learner) { learners_[learner].taken = true; }
  /// @brief Warns of causes that are new.
  void noteRefused(const std::vector<RefusedAnswer>& refused);

  /// @brief Returns why some agents have no answer, by what is known of the nodes that publish answers.
  /// @param nodes that publish on `topic`
  std::string reasonForSilence(const std::vector<std::string>& nodes, const std::string& topic) const;

 private:
  struct Learner {
    std::string name;
    std::string node;
    std::uint64_t messages = 0;
    bool taken = false;  // an answer
    std::set<std::string> refusals;
  };
  /// Warns unless the learner was warned of this cause before.
  void warnOnce(LearnerId learner, const std::string& cause, const std::string& text);
  std::string described(const Learner& learner) const;
  std::string quoted(LearnerId learner) const { return "'" + learners_[learner].name + "'"; }
  void warnOfRivals(const RefusedAnswer& refused, const std::vector<AgentId>& agents);

  std::uint64_t run_;
  std::vector<Learner> learners_;                                     // by number
  std::map<std::pair<std::string, std::string>, LearnerId> numbers_;  // by name and node
  std::set<std::pair<LearnerId, LearnerId>> rivals_;
};

}  // namespace crowd
