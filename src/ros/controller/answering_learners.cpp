#include "ros/controller/answering_learners.h"

#include <ros/console.h>

#include <algorithm>
#include <array>

#include "common/text/numbers.h"
#include "ros/messages/agent_list.h"

namespace crowd {
namespace {

/// Texts about a cause of refusal.
struct RefusalTexts {
  const char* cause;    // short; identifies the cause
  const char* details;  // follows the names of the agents; {...} are placeholders
};

/// In the order of Refusal.
constexpr std::array<RefusalTexts, 7> REFUSALS = {{
    {"for agents that were not asked", " in {tick}, expected agents of the perceptions that have not arrived"},
    {"rotation is not a finite number", " with rotation {rotation}, expected a finite number [rad]"},
    {"speed_fraction is not within 0 to 1", " with speed_fraction {speed_fraction}, expected 0 to 1"},
    {"for a tick that is over",
     " in {tick}, which is over: expected episode and tick of the perceptions, within ~answer_deadline"},
    {"for a tick that has not begun", " in {tick}, which has not begun: expected episode and tick of the perceptions"},
    {"a second answer to the same tick", " in {tick} twice: the first answer counts"},
    {"another learner answers for the same agents", ""},
}};
static_assert(static_cast<std::size_t>(Refusal::OTHER_LEARNER) + 1 == REFUSALS.size(), "one entry for each cause");

const RefusalTexts& textsOf(Refusal cause) { return REFUSALS.at(static_cast<std::size_t>(cause)); }

std::string replaced(std::string text, const std::string& placeholder, const std::string& value) {
  const std::size_t place = text.find(placeholder);
  return place == std::string::npos ? text : text.replace(place, placeholder.size(), value);
}

/// Returns what was answered and what was expected.
std::string detailsOf(const RefusedAnswer& refused, const std::vector<AgentId>& agents) {
  const std::string tick = "tick " + std::to_string(refused.tick) + " of episode " + std::to_string(refused.episode);
  std::string text = textsOf(refused.cause).details;
  text = replaced(text, "{tick}", tick);
  text = replaced(text, "{rotation}", toText(refused.answer.action.rotation));
  text = replaced(text, "{speed_fraction}", toText(refused.answer.action.speed_fraction));
  return namedAgents(agents) + text;
}

std::string describedAsSilent(const std::string& node, const std::string& topic) {
  return "'" + node + "' publishes on '" + topic + "', but has not answered yet";
}

/// Removes the refused answers with the same cause as the first one, and returns their agents.
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
  if (is_new) learners_.push_back({learner, node, 0, false, {}, {}});
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
    warnOnce(learner, "run of another controller",
             "perceptions of another controller (run " + std::to_string(run) + ")" + expected);
  }
  return RunCheck::OTHER;
}

void AnsweringLearners::noteTaken(LearnerId learner) {
  learners_[learner].taken = true;
  learners_[learner].refusals.clear();
}

void AnsweringLearners::noteRefused(const std::vector<RefusedAnswer>& refused) {
  std::vector<RefusedAnswer> left = refused;
  while (!left.empty()) {
    const RefusedAnswer first = left.front();
    const std::vector<AgentId> agents = takeAgentsOfFirstCause(left);
    if (first.cause == Refusal::OTHER_LEARNER) {
      warnOfRivals(first, agents);
    } else {
      warnOnce(first.learner, textsOf(first.cause).cause, "for " + detailsOf(first, agents));
    }
  }
}

void AnsweringLearners::warnOfRivals(const RefusedAnswer& refused, const std::vector<AgentId>& agents) {
  learners_[refused.learner].refusals.insert(textsOf(Refusal::OTHER_LEARNER).cause);
  if (!rivals_.insert(std::minmax(refused.learner, refused.other)).second) return;
  ROS_WARN(
      "two learners answer for %s: %s and %s; the first answer to a tick counts, the other is dropped. Assign "
      "different "
      "agents to the learners (~agents)",
      namedAgents(agents).c_str(), quoted(refused.other).c_str(), quoted(refused.learner).c_str());
}

void AnsweringLearners::warnOnce(LearnerId learner, const std::string& cause, const std::string& text) {
  learners_[learner].refusals.insert(cause);
  if (!learners_[learner].warned.insert(cause).second) return;
  ROS_WARN("%s answers %s. The answer is dropped. This warning is printed once for each cause", quoted(learner).c_str(),
           text.c_str());
}

std::vector<std::string> AnsweringLearners::nodes() const {
  std::set<std::string> names;
  for (const Learner& learner : learners_) names.insert(learner.node);
  return {names.begin(), names.end()};
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
  return reason.empty() ? "there is no learner (no node publishes on '" + topic + "')" : reason;
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
