#include "social_crowd/ros/answering_learners.h"

#include <ros/console.h>

#include <algorithm>

#include "social_crowd/common/numbers.h"
#include "social_crowd/ros/agent_list.h"

namespace crowd {
namespace {

/// A few words for each cause; equal words are warned of once.
std::string briefly(Refusal cause) {
  switch (cause) {
    case Refusal::NOT_ASKED:
      return "for agents that were not asked";
    case Refusal::BAD_ROTATION:
      return "rotation is not a finite number";
    case Refusal::BAD_SPEED:
      return "speed_fraction is not within 0 to 1";
    case Refusal::TOO_LATE:
      return "for a tick that is over";
    case Refusal::TOO_EARLY:
      return "for a tick that has not begun";
    case Refusal::SECOND_ANSWER:
      return "a second answer to the same tick";
    case Refusal::OTHER_LEARNER:
      return "another learner answers for the same agents";
  }
  return "";
}

/// What was answered and what was expected.
std::string explained(const RefusedAnswer& refused, const std::vector<AgentId>& agents) {
  const std::string when = "tick " + std::to_string(refused.tick) + " of episode " + std::to_string(refused.episode);
  std::string whose = namedAgents(agents);
  switch (refused.cause) {
    case Refusal::NOT_ASKED:
      return whose + " in " + when + ", expected agents of the perceptions that have not arrived";
    case Refusal::BAD_ROTATION:
      return whose + " with rotation " + toText(refused.answer.action.rotation) + ", expected a finite number [rad]";
    case Refusal::BAD_SPEED:
      return whose + " with speed_fraction " + toText(refused.answer.action.speed_fraction) + ", expected 0 to 1";
    case Refusal::TOO_LATE:
      return whose + " in " + when + ", which is over: expected episode and tick of the perceptions, within " +
             "~answer_deadline";
    case Refusal::TOO_EARLY:
      return whose + " in " + when + ", which has not begun: expected episode and tick of the perceptions";
    case Refusal::SECOND_ANSWER:
      return whose + " in " + when + " twice: the first answer counts";
    case Refusal::OTHER_LEARNER:
      break;
  }
  return whose;
}

std::string describedAsSilent(const std::string& node, const std::string& topic) {
  return "'" + node + "' publishes on '" + topic + "', but has not answered yet";
}

/// Agents of refused answers of the same cause as the first one, which are taken out of the list.
std::vector<AgentId> takeAgentsOfFirstCause(std::vector<RefusedAnswer>& refused) {
  const RefusedAnswer first = refused.front();
  const auto others = std::stable_partition(refused.begin(), refused.end(), [&](const RefusedAnswer& one) {
    return one.cause == first.cause && one.other == first.other;
  });
  std::vector<AgentId> agents;
  for (auto one = refused.begin(); one != others; ++one) agents.push_back(one->answer.agent);
  refused.erase(refused.begin(), others);
  return agents;
}

}  // namespace

LearnerId AnsweringLearners::numberOf(const std::string& learner, const std::string& node) {
  const auto [found, is_new] = numbers_.try_emplace({learner, node}, static_cast<LearnerId>(learners_.size()));
  if (is_new) learners_.push_back({learner, node, 0, false, {}});
  return found->second;
}

RunCheck AnsweringLearners::checkRun(std::uint64_t run, LearnerId learner) {
  const bool is_first = learners_[learner].messages++ == 0;
  if (run == run_) return RunCheck::OWN;
  if (is_first && run != 0) return RunCheck::EARLIER;
  const std::string expected = ", expected run " + std::to_string(run_) + ", that of the perceptions";
  if (run == 0) {
    warnOnce(learner, "run is missing", "without run" + expected);
  } else {
    warnOnce(learner, "run is another controller's",
             "another controller's perceptions (run " + std::to_string(run) + ")" + expected);
  }
  return RunCheck::OTHER;
}

void AnsweringLearners::noteRefused(const std::vector<RefusedAnswer>& refused) {
  std::vector<RefusedAnswer> left = refused;
  while (!left.empty()) {
    const RefusedAnswer first = left.front();
    const std::vector<AgentId> agents = takeAgentsOfFirstCause(left);
    if (first.cause == Refusal::OTHER_LEARNER) {
      warnOfRivals(first, agents);
    } else {
      warnOnce(first.learner, briefly(first.cause), "for " + explained(first, agents));
    }
  }
}

void AnsweringLearners::warnOfRivals(const RefusedAnswer& refused, const std::vector<AgentId>& agents) {
  learners_[refused.learner].refusals.insert(briefly(Refusal::OTHER_LEARNER));
  if (!rivals_.insert(std::minmax(refused.learner, refused.other)).second) return;
  ROS_WARN(
      "two learners answer for %s: %s and %s; of their answers to a tick the first one counts, the other is dropped. "
      "Give each learner agents of its own (~agents)",
      namedAgents(agents).c_str(), quoted(refused.other).c_str(), quoted(refused.learner).c_str());
}

void AnsweringLearners::warnOnce(LearnerId learner, const std::string& cause, const std::string& text) {
  if (!learners_[learner].refusals.insert(cause).second) return;
  ROS_WARN("%s answers %s. The answer is dropped; this is said once for each cause", quoted(learner).c_str(),
           text.c_str());
}

std::string AnsweringLearners::reasonForSilence(const std::vector<std::string>& nodes, const std::string& topic) const {
  std::string reason;
  const auto add = [&](const std::string& text) { reason += (reason.empty() ? "" : "; ") + text; };
  for (const std::string& node : nodes) {
    bool has_answered = false;
    for (const Learner& learner : learners_) {
      if (learner.node != node) continue;
      has_answered = true;
      add(described(learner));
    }
    if (!has_answered) add(describedAsSilent(node, topic));
  }
  return reason.empty() ? "no learner is there (no node publishes on '" + topic + "')" : reason;
}

std::string AnsweringLearners::described(const Learner& learner) const {
  if (learner.refusals.empty()) {
    return "'" + learner.name +
           (learner.taken ? "' answers for other agents, or has stopped" : "' has not answered yet");
  }
  std::string causes;
  for (const std::string& cause : learner.refusals) causes += (causes.empty() ? "" : ", ") + cause;
  return "'" + learner.name + "' answers, but " + (learner.taken ? "some of its" : "its") +
         " answers are refused: " + causes;
}

}  // namespace crowd
