#include "social_crowd/simulation/record.h"

#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

/// A text as a CSV field: in double quotes if it contains a comma, quote or line break.
std::string fieldOf(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char letter : text) field += letter == '"' ? "\"\"" : std::string(1, letter);
  return field + "\"";
}

}  // namespace

void appendRecordRows(std::uint64_t episode, const EpisodeResult& result, std::string& rows) {
  const std::string begin = std::to_string(episode) + "," + fieldOf(result.scenario) + ",";
  for (std::size_t i = 0; i < result.agents.size(); ++i) {
    const AgentResult& agent = result.agents[i];
    if (agent.removed) continue;
    rows += begin + std::to_string(i) + (agent.arrived ? ",1" : ",0") + (agent.touched ? ",1" : ",0") +
            (agent.collided ? ",1," : ",0,") + std::to_string(agent.blocked_moves) + "," + std::to_string(agent.ticks);
    for (const double value : {agent.path_length, agent.path_ratio, agent.time_ratio, agent.turn_per_metre,
                               agent.distance_gained, agent.gain_per_tick, agent.path_per_gain}) {
      rows += "," + toText(value);
    }
    rows += "\n";
  }
}

}  // namespace crowd
