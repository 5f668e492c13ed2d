#include "social_crowd/ranks/shared_decisions.h"

#include "simulation/stopwatch.h"
#include "social_crowd/simulation/byte_archive.h"

namespace crowd {

void SharedDecisions::decide(Episode& episode, RelativeActions& actions) {
  const std::uint64_t sent = communicator_.sentBytes();
  const DecisionShare own{static_cast<std::size_t>(communicator_.rank()),
                          static_cast<std::size_t>(communicator_.size())};
  episode.decide(learner_, own, actions);
  Communicator::Bytes message;
  ByteWriter write(message);
  write(is_stopped_ && is_stopped_());
  for (const AgentAction& action : actions.agents) {
    write(action.agent);
    write(action.action.rotation);
    write(action.action.speed_fraction);
  }
  actions.agents.clear();
  for (const Communicator::Bytes& part : gather(message)) append(part, actions.agents);
  bytes_ += communicator_.sentBytes() - sent;
}

void SharedDecisions::stop() {
  Communicator::Bytes message;
  ByteWriter write(message);
  write(true);
  gather(message);
  was_stopped_ = true;
}

std::vector<Communicator::Bytes> SharedDecisions::gather(const Communicator::Bytes& message) {
  const Stopwatch waiting(CLOCK_THREAD_CPUTIME_ID, waiting_seconds_);
  return communicator_.gatherAll(message);
}

void SharedDecisions::append(const Communicator::Bytes& message, std::vector<AgentAction>& actions) {
  ByteReader read(message);
  bool stops = false;
  read(stops);
  was_stopped_ = was_stopped_ || stops;
  while (!read.isAtEnd()) {
    AgentAction& action = actions.emplace_back();
    read(action.agent);
    read(action.action.rotation);
    read(action.action.speed_fraction);
  }
}

}  // namespace crowd
