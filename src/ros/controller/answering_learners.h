#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "simulation/lockstep.h"

namespace crowd {

/// @brief The controller whose perceptions a message answers.
enum class RunCheck {
  OWN,
  EARLIER,  ///< an earlier controller; latched message, the first one of the learner
  OTHER,    ///< another controller, or the message contains no run
};

/// @brief Learners that have answered the controller, with the causes for which answers were refused. Prints one
/// warning per learner and cause. All functions run in the main loop of the controller.
class AnsweringLearners {
 public:
  /// @param run of this controller
  explicit AnsweringLearners(std::uint64_t run) : run_(run) {}

  /// @brief Returns the number of a learner; a new one for a new name.
  /// @param node name of the ROS node that published the answer; with nodelets it may contain several learners
  LearnerId numberOf(const std::string& learner, const std::string& node);
  /// @brief Returns the controller that a message answers, by its run. Warns of OTHER.
  RunCheck checkRun(std::uint64_t run, LearnerId learner);
  void noteTaken(LearnerId learner);
  /// @brief Warns of new causes.
  void noteRefused(const std::vector<RefusedAnswer>& refused);

  /// @brief Nodes that have sent messages, each once.
  std::vector<std::string> nodes() const;
  /// @brief Returns as text why agents may have no answer.
  /// @param nodes that publish `topic`
  std::string reasonForSilence(const std::vector<std::string>& nodes, const std::string& topic) const;

 private:
  struct Learner {
    std::string name;
    std::string node;
    std::uint64_t messages = 0;
    bool taken = false;              // at least one answer was accepted
    std::set<std::string> warned;    // causes of refusals
    std::set<std::string> refusals;  // the same, since an answer was accepted
  };
  /// Prints a warning unless there was one for this learner and cause.
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
