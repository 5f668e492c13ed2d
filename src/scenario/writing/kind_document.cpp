#include "scenario/writing/kind_document.h"

#include <set>

#include "common/text/numbers.h"
#include "scenario/writing/population_document.h"

namespace crowd {
namespace {

std::string speedText(const Distribution& speed) {
  std::string range = rangeText(speed.range);
  if (!speed.normal) return range;
  return "{mean: " + toText(speed.normal->mean) + ", deviation: " + toText(speed.normal->deviation) +
         ", range: " + range + "}";
}

std::string entryOf(const PersonKind& kind) {
  std::string text = "  " + quotedYaml(kind.name) + ": {speed: " + speedText(kind.speed) +
                     ", radius: " + rangeText(kind.radius) + ", figure: " + FIGURES.nameOf(kind.figure);
  if (kind.pauses) {
    text += ", pauses: {every: " + toText(kind.pauses->every) + ", duration: " + rangeText(kind.pauses->duration) +
            ", speed: " + toText(kind.pauses->speed) + "}";
  }
  return text + "}\n";
}

template <typename Share, typename NameOf>
std::string mixText(const std::string& key, const std::vector<Share>& shares, const NameOf& name_of) {
  std::string text;
  for (const Share& each : shares) text += (text.empty() ? "" : ", ") + name_of(each) + ": " + toText(each.share);
  return text.empty() ? "" : ", " + key + ": {" + text + "}";
}

}  // namespace

std::string kindText(const AgentStart& agent, const Scene& scene) {
  if (agent.kind == NO_KIND) return "";
  return ", kind: " + quotedYaml(scene.population->kinds[static_cast<std::size_t>(agent.kind)].name);
}

std::string kindText(const AgentGroup& agents, const PopulationDescription& population) {
  return mixText("kind", agents.kinds,
                 [&](const KindShare& each) { return quotedYaml(population.kinds[each.kind].name); });
}

std::string reactionText(const AgentStart& agent) {
  return agent.reaction == Reaction::REGULAR ? "" : ", reaction: " + REACTIONS.nameOf(agent.reaction);
}

std::string reactionText(const AgentGroup& agents) {
  return mixText("reaction", agents.reactions,
                 [](const ReactionShare& each) { return REACTIONS.nameOf(each.reaction); });
}

std::string kindsText(const Scene& scene) {
  if (!scene.population) return "";
  std::set<std::size_t> used;
  for (const AgentStart& agent : scene.agents) {
    if (agent.kind != NO_KIND) used.insert(static_cast<std::size_t>(agent.kind));
  }
  for (const SourceDescription& source : scene.population->sources) {
    for (const KindShare& each : source.agents.kinds) used.insert(each.kind);
  }
  std::string text;
  for (const std::size_t kind : used) text += entryOf(scene.population->kinds[kind]);
  return text.empty() ? "" : "kinds:\n" + text;
}

}  // namespace crowd
