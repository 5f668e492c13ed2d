#include "ranks/ranks_report.h"

#include <algorithm>
#include <vector>

#include "common/text/numbers.h"

namespace crowd {

void RanksReport::collect(Communicator& communicator, double own_busy_seconds, std::uint64_t own_bytes) {
  ranks = communicator.size();
  std::vector<std::uint64_t> sent = {own_bytes};
  communicator.sum(sent);
  bytes = sent.front();
  const RankSpread busy = spreadOf(communicator, own_busy_seconds);
  busy_seconds = busy.largest;
  time_imbalance = busy.imbalance();
}

std::string RanksReport::text() const {
  const double each = 1.0 / static_cast<double>(std::max<std::uint64_t>(1, ticks));
  std::string text = std::to_string(ranks) + " ranks, " + std::to_string(agents) + " agents, " + std::to_string(ticks) +
                     " ticks: " + toFixedText(1e3 * seconds * each, 2) + " ms per tick";
  if (!is_divided) return text + ", by rank 0 alone";
  text += " (" + toFixedText(1e3 * busy_seconds * each, 2) + " ms computing on the slowest rank), " +
          toFixedText(1e-6 * static_cast<double>(bytes) * each, 3) + " MB exchanged per tick, imbalance of agents " +
          toFixedText(agent_imbalance, 3) + ", of computing " + toFixedText(time_imbalance, 3);
  if (whole_motions > 0) text += ", " + std::to_string(whole_motions) + " ticks with the motion of the whole crowd";
  return text;
}

}  // namespace crowd
