#include "social_crowd/simulation/lockstep.h"

#include <algorithm>
#include <cmath>

namespace crowd {

Lockstep::Partner& Lockstep::partner(AgentId agent) {
  if (agent >= partners_.size()) partners_.resize(agent + 1);
  return partners_[agent];
}

void Lockstep::open(std::uint64_t episode, std::uint64_t tick, const std::vector<AgentId>& agents) {
  for (const AgentId agent : asked_) partners_[agent].asked = false;
  episode_ = episode;
  tick_ = tick;
  open_ = true;
  asked_ = agents;
  answers_.clear();
  awaited_ = 0;
  for (const AgentId agent : agents) {
    Partner& asked = partner(agent);
    asked.known = true;
    asked.asked = true;
    asked.answered = false;
    awaited_ += asked.absent ? 0 : 1;
  }
  present_ = awaited_;
}

void Lockstep::take(const RelativeActions& answers) {
  const bool right_tick = open_ && answers.episode == episode_ && answers.tick == tick_;
  for (const AgentAction& answer : answers.agents) takeOne(answer, right_tick);
}

void Lockstep::takeOne(const AgentAction& answer, bool right_tick) {
  const bool known = answer.agent < partners_.size() && partners_[answer.agent].asked;
  const RelativeAction& action = answer.action;
  const bool sound = std::isfinite(action.rotation) && action.speed_share >= 0.0 && action.speed_share <= 1.0;
  if (!known && sound) noteOutOfTurn(answer.agent);
  if (!known || !sound) {
    ++dropped_;
    return;
  }
  Partner& partner = partners_[answer.agent];
  markPresent(partner);
  if (!right_tick || partner.answered) {
    ++dropped_;
    return;
  }
  partner.answered = true;
  --awaited_;
  answers_.push_back(answer);
}

void Lockstep::noteOutOfTurn(AgentId agent) {
  if (agent >= partners_.size() || !partners_[agent].known) return;
  partners_[agent].heard = true;
  partners_[agent].misses = 0;
  partners_[agent].absent = false;
}

void Lockstep::markPresent(Partner& partner) {
  partner.heard = true;
  partner.misses = 0;
  if (!partner.absent) return;
  partner.absent = false;
  ++present_;
  ++awaited_;
}

bool Lockstep::awaitsNewcomer() const {
  return std::any_of(asked_.begin(), asked_.end(), [&](AgentId agent) {
    const Partner& partner = partners_[agent];
    return !partner.answered && !partner.absent && !partner.heard;
  });
}

void Lockstep::close() {
  open_ = false;
  for (const AgentId agent : asked_) {
    Partner& partner = partners_[agent];
    if (partner.answered) continue;
    ++missed_;
    if (++partner.misses >= misses_until_absent_) partner.absent = true;
  }
}

void Lockstep::giveUpOnNewcomers(const std::vector<AgentId>& agents) {
  for (const AgentId agent : agents) {
    Partner& newcomer = partner(agent);
    if (newcomer.absent || newcomer.heard) continue;
    newcomer.absent = true;
    if (!newcomer.asked) continue;
    --awaited_;
    --present_;
  }
}

bool Lockstep::areAbsent(const std::vector<AgentId>& agents) const {
  return std::all_of(agents.begin(), agents.end(),
                     [&](AgentId agent) { return agent < partners_.size() && partners_[agent].absent; });
}

std::vector<AgentId> Lockstep::missing() const {
  std::vector<AgentId> missing;
  for (const AgentId agent : asked_) {
    if (!partners_[agent].answered) missing.push_back(agent);
  }
  return missing;
}

void Lockstep::resetCounts() {
  missed_ = 0;
  dropped_ = 0;
}

}  // namespace crowd
