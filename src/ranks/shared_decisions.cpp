#include "social_crowd/ranks/shared_decisions.h"

#include <utility>

#include "simulation/stopwatch.h"
#include "social_crowd/simulation/byte_archive.h"

namespace crowd {

SharedDecisions::SharedDecisions(Communicator& communicator, Learner& learner, ThreadPool& thread_pool,
                                 std::function<bool()> is_stopped)
    : communicator_(communicator),
      own_(learner, thread_pool,
           {static_cast<std::size_t>(communicator.rank()), static_cast<std::size_t>(communicator.size())}),
      is_stopped_(std::move(is_stopped)) {}

bool SharedDecisions::decide(Episode& episode, std::vector<AgentAction>& actions) {
  const std::uint64_t sent = communicator_.sentBytes();
  const bool goes_on = own_.decide(episode, actions);
  Communicator::Bytes message;
  ByteWriter write(message);
  write(is_stopped_ && is_stopped_());
  for (const AgentAction& action : actions) {
    write(action.agent);
    write(action.action.rotation);
    write(action.action.speed_fraction);
  }
  actions.clear();
  for (const Communicator::Bytes& part : gather(message)) append(part, actions);
  bytes_ += communicator_.sentBytes() - sent;
  return goes_on && !was_stopped_;
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
