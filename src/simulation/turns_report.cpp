#include "social_crowd/simulation/turns_report.h"

#include <algorithm>

#include "social_crowd/common/numbers.h"
#include "social_crowd/simulation/byte_archive.h"

namespace crowd {

TurnsReport reportOf(Communicator& communicator, const TurnTimes& times, std::uint64_t learners) {
  Communicator::Bytes bytes;
  ByteWriter write(bytes);
  write(times.seconds);
  write(times.episode_seconds);
  write(times.exchange_seconds);
  write(times.bytes);
  TurnsReport report;
  report.ranks = communicator.size();
  report.learners = learners;
  report.turns = times.turns;
  double episode_sum = 0.0;
  for (const Communicator::Bytes& other : communicator.gatherAll(bytes)) {
    TurnTimes there;
    ByteReader read(other);
    read(there.seconds);
    read(there.episode_seconds);
    read(there.exchange_seconds);
    read(there.bytes);
    report.seconds = std::max(report.seconds, there.seconds);
    report.episode_seconds = std::max(report.episode_seconds, there.episode_seconds);
    report.exchange_seconds = std::max(report.exchange_seconds, there.exchange_seconds);
    report.bytes += there.bytes;
    episode_sum += there.episode_seconds;
  }
  if (episode_sum > 0.0) report.imbalance = report.episode_seconds * report.ranks / episode_sum;
  return report;
}

std::string TurnsReport::text() const {
  const double each = 1.0 / static_cast<double>(std::max<std::uint64_t>(1, turns));
  return std::to_string(ranks) + " ranks, " + std::to_string(learners) + " learners, " + std::to_string(turns) +
         " turns: " + toFixedText(1e3 * seconds * each, 2) + " ms per turn (" +
         toFixedText(1e3 * episode_seconds * each, 2) + " ms episodes on the slowest rank, " +
         toFixedText(1e3 * exchange_seconds * each, 2) + " ms merging and exchange), " +
         toFixedText(1e-6 * static_cast<double>(bytes) * each, 3) + " MB exchanged per turn, imbalance of episodes " +
         toFixedText(imbalance, 3);
}

}  // namespace crowd
