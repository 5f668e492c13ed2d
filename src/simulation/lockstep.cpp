#include "simulation/lockstep.h"

#include <algorithm>

namespace crowd {
namespace {

bool areEqual(const RelativeAction& one, const RelativeAction& other) {
  return one.rotation == other.rotation && one.speed_fraction == other.speed_fraction;
}

}  // namespace

void Lockstep::open(std::uint64_t episode, std::uint64_t tick, const std::vector<AgentId>& agents) {
  if (open_) abandoned_ = now_;
  for (const AgentId agent : asked_) records_[agent].asked = false;
  now_ = {episode, tick};
  open_ = true;
  asked_ = agents;
  answers_.clear();
  awaited_ = 0;
  for (const AgentId agent : agents) {
    AgentRecord& asked = records_.add(agent);
    asked.asked_at = now_;
    asked.asked = true;
    asked.answered = false;
    awaited_ += asked.absent ? 0 : 1;
  }
  present_ = awaited_;
  forgetDeparted();
}

void Lockstep::forgetDeparted() {
  if (records_.size() <= most_records_) return;
  records_.eraseIf([this](AgentId, const AgentRecord& record) {
    // In a sequential scenario agents are asked one after the other.
    return record.asked_at && (record.asked_at->first != now_.first || record.asked_at->second + 1 < now_.second);
  });
  most_records_ = 2 * records_.size() + FEW_AGENTS;
}

const std::vector<RefusedAnswer>& Lockstep::take(const RelativeActions& answers, LearnerId learner) {
  refused_.clear();
  const Moment moment(answers.episode, answers.tick);
  for (const AgentAction& answer : answers.agents) takeOne(answer, moment, learner);
  return refused_;
}

void Lockstep::takeOne(const AgentAction& answer, const Moment& moment, LearnerId learner) {
  if (!wasAsked(answer.agent)) return refuse(Refusal::NOT_ASKED, answer, moment, learner);
  if (!answer.action.hasValidRotation()) return refuse(Refusal::BAD_ROTATION, answer, moment, learner);
  if (!answer.action.hasValidSpeed()) return refuse(Refusal::BAD_SPEED, answer, moment, learner);
  AgentRecord& record = records_[answer.agent];
  markPresent(record);
  if (open_ && moment == now_ && record.asked && !record.answered) {
    record.answered = true;
    record.last = {learner, moment, answer.action};
    --awaited_;
    answers_.push_back(answer);
    return;
  }
  const bool is_repeated = record.last && record.last->learner == learner && record.last->moment == moment &&
                           areEqual(record.last->action, answer.action);
  if (!is_repeated && moment != abandoned_) refuse(causeOf(record, moment, learner), answer, moment, learner);
}

void Lockstep::markPresent(AgentRecord& record) {
  record.heard = true;
  record.misses = 0;
  if (!record.absent) return;
  record.absent = false;
  if (!record.asked) return;
  ++present_;
  if (!record.answered) ++awaited_;
}

Refusal Lockstep::causeOf(const AgentRecord& record, const Moment& moment, LearnerId learner) const {
  const bool has_newer = record.last && record.last->moment >= moment;
  if (has_newer && record.last->learner != learner) return Refusal::OTHER_LEARNER;
  if (has_newer && record.last->moment == moment) return Refusal::SECOND_ANSWER;
  if (moment > now_) return Refusal::TOO_EARLY;
  return moment < now_ || moment == record.asked_at ? Refusal::TOO_LATE : Refusal::NOT_ASKED;
}

void Lockstep::refuse(Refusal cause, const AgentAction& answer, const Moment& moment, LearnerId learner) {
  ++dropped_;
  const LearnerId other = cause == Refusal::OTHER_LEARNER ? records_[answer.agent].last->learner : learner;
  refused_.push_back({cause, answer, moment.first, moment.second, learner, other});
}

bool Lockstep::awaitsNewcomer() const {
  return std::any_of(asked_.begin(), asked_.end(), [&](AgentId agent) {
    const AgentRecord& record = records_[agent];
    return !record.answered && !record.absent && !record.heard;
  });
}

std::vector<AgentId> Lockstep::close() {
  open_ = false;
  std::vector<AgentId> absent;
  for (const AgentId agent : asked_) {
    AgentRecord& record = records_[agent];
    if (record.answered) continue;
    ++missed_;
    if (++record.misses < misses_until_absent_ || record.absent) continue;
    record.absent = true;
    absent.push_back(agent);
  }
  return absent;
}

std::vector<AgentId> Lockstep::giveUpOnNewcomers(const std::vector<AgentId>& agents) {
  std::vector<AgentId> given_up;
  for (const AgentId agent : agents) {
    AgentRecord& newcomer = records_.add(agent);
    if (newcomer.absent || newcomer.heard) continue;
    newcomer.absent = true;
    given_up.push_back(agent);
    if (!newcomer.asked) continue;
    --awaited_;
    --present_;
  }
  return given_up;
}

bool Lockstep::areAbsent(const std::vector<AgentId>& agents) const {
  return std::all_of(agents.begin(), agents.end(), [&](AgentId agent) {
    const AgentRecord* const record = records_.find(agent);
    return record != nullptr && record->absent;
  });
}

std::vector<AgentId> Lockstep::missing() const {
  std::vector<AgentId> missing;
  for (const AgentId agent : asked_) {
    if (!records_[agent].answered) missing.push_back(agent);
  }
  return missing;
}

void Lockstep::resetCounts() {
  missed_ = 0;
  dropped_ = 0;
}

}  // namespace crowd
