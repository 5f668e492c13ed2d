#include "training/record.h"

#include <limits>

#include "common/text/numbers.h"
#include "simulation/evaluation/metrics.h"

namespace crowd {
namespace {

/// A text as a CSV field: in double quotes if it contains a comma, quote or line break.
std::string fieldOf(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char letter : text) field += letter == '"' ? "\"\"" : std::string(1, letter);
  return field + "\"";
}

/// NaN of nothing.
double shareOf(std::size_t part, std::size_t whole) {
  if (whole == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

double successShare(const EpisodeResult& result) {
  const std::size_t expected = result.expectedCount();
  // Curves need a value: the success is 1 if no agent is expected to arrive.
  return expected == 0 && result.agentCount() > 0 ? 1.0 : shareOf(result.arrivedCount(), expected);
}

double contactShare(const EpisodeResult& result) { return shareOf(result.touchedCount(), result.agentCount()); }

std::string recordHeader() {
  std::string header = "episode,scenario,agent";
  const AgentResult result;
  AgentResult::visitMeasures([&](const std::string& name, const auto& /*value*/) { header += "," + name; }, result);
  return header + "\n";
}

void appendRecordRows(std::uint64_t episode, const EpisodeResult& result, std::string& rows) {
  const std::string begin = std::to_string(episode) + "," + fieldOf(result.scenario) + ",";
  for (std::size_t i = 0; i < result.agents.size(); ++i) {
    const AgentResult& agent = result.agents[i];
    if (agent.removed) continue;
    rows += begin + std::to_string(i);
    AgentResult::visitMeasures([&](const char* /*name*/, const auto& value) { rows += "," + toField(value); }, agent);
    rows += "\n";
  }
}

void appendLogRow(std::uint64_t episode, const LearnedEpisode& learned, std::string& rows) {
  const std::size_t agents = learned.agentCount();
  rows += std::to_string(episode) + "," + fieldOf(learned.scenario) + "," + std::to_string(agents);
  for (const double share : {successShare(learned), contactShare(learned), shareOf(learned.collidedCount(), agents)}) {
    rows += "," + toText(share);
  }
  rows += "," + toText(learned.reward) + "," + std::to_string(learned.visited_rows) + "," + toText(learned.epsilon);
  rows += "," + std::to_string(learned.decisions) + "\n";
}

}  // namespace crowd
