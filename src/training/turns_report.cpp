#include "training/turns_report.h"

#include <algorithm>
#include <vector>

#include "common/text/numbers.h"

namespace crowd {

TurnsReport reportOf(Communicator& communicator, const TurnTimes& times, std::uint64_t learners) {
  const RankSpread episodes = spreadOf(communicator, times.episode_seconds);
  std::vector<std::uint64_t> sent = {times.bytes};
  communicator.sum(sent);
  TurnsReport report;
  report.ranks = communicator.size();
  report.learners = learners;
  report.turns = times.turns;
  report.seconds = spreadOf(communicator, times.seconds).largest;
  report.episode_seconds = episodes.largest;
  report.exchange_seconds = spreadOf(communicator, times.exchange_seconds).largest;
  report.imbalance = episodes.imbalance();
  report.bytes = sent.front();
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
