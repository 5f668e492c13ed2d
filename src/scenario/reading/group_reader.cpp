#include "scenario/reading/group_reader.h"

#include <algorithm>
#include <set>
#include <string>

#include "common/text/quotes.h"
#include "scenario/reading/list_reader.h"
#include "scenario/reading/region_reader.h"

namespace crowd {
namespace {

constexpr std::int64_t LAST_AGENT = 9'999'999;
constexpr std::size_t LARGEST_GROUP = 20;
constexpr NumberLimit WEIGHT{NumberRule::NOT_NEGATIVE, 1e9, ""};
const std::vector<GroupShare::Size> PAIRS_AND_MORE = {{2, 0.7}, {3, 0.2}, {4, 0.1}};

/// Reads {SIZE: WEIGHT, ...}. Returns the sizes with a weight, by ascending size, so that draws do not depend on the
/// order in the document.
std::vector<GroupShare::Size> readSizes(const YAML::Node& node, const YamlPlace& place) {
  const std::string expected = "a map of sizes from 2 to " + std::to_string(LARGEST_GROUP) + " to weights";
  if (!node.IsMap() || node.size() == 0) throwExpected(place, node, expected);
  const YamlMap checked(node, place);  // no duplicate keys
  std::vector<GroupShare::Size> sizes;
  sizes.reserve(node.size());
  for (const auto& entry : node) {
    std::size_t size = 0;
    const bool is_size = YAML::convert<std::size_t>::decode(entry.first, size) && size >= 2 && size <= LARGEST_GROUP;
    if (!is_size) throwExpected(place, entry.first, expected);
    const double weight = readNumber(entry.second, place.child(entry.first.Scalar()), WEIGHT);
    if (weight > 0.0) sizes.push_back({size, weight});
  }
  if (sizes.empty()) throwExpected(place, node, "a weight above 0");
  const auto is_smaller = [](const auto& one, const auto& other) { return one.members < other.members; };
  std::sort(sizes.begin(), sizes.end(), is_smaller);
  return sizes;
}

AgentId readAgentNumber(const YAML::Node& node, const YamlPlace& place) {
  return static_cast<AgentId>(readWhole(node, place, 0, LAST_AGENT));
}

/// Who is in a group already, and of which entry.
class Groups {
 public:
  explicit Groups(const Scenario& scenario) {
    for (const AgentGroup& entry : scenario.agents) {
      entries_.insert(entries_.end(), static_cast<std::size_t>(entry.count), &entry);
    }
  }

  void requireAgent(AgentId agent, const YamlPlace& place, const YAML::Mark& mark) const {
    if (agent < entries_.size()) return;
    throwProblem(place, mark,
                 entries_.empty() ? "there are no agents"
                                  : "expected the number of an agent, 0 to " + std::to_string(entries_.size() - 1) +
                                        ", got " + std::to_string(agent));
  }
  const AgentGroup& entryOf(AgentId agent) const { return *entries_[agent]; }
  /// Whether it was not a member of a group before.
  bool add(AgentId agent) { return members_.insert(agent).second; }

 private:
  std::vector<const AgentGroup*> entries_;  // of each agent
  std::set<AgentId> members_;
};

YAML::Mark markOf(int line) {
  YAML::Mark mark;
  mark.line = line - 1;
  return mark;
}

void resolveLeader(const Scenario& scenario, const Groups& groups, const YamlPlace& place, AgentGroup& entry) {
  const YAML::Mark mark = markOf(entry.line);
  LeaderDescription& leader = *entry.leader;
  if (leader.robot.empty()) {
    groups.requireAgent(leader.agent, place, mark);
    const AgentGroup& its = groups.entryOf(leader.agent);
    if (its.leader) throwProblem(place, mark, "expected an agent with a goal of its own, which follows nobody");
    if (its.groups.share > 0.0) throwProblem(place, mark, "expected an agent without `groups`");
    return;
  }
  const auto has_name = [&](const RobotGroup& robot) { return robot.start.name == leader.robot; };
  const auto found = std::find_if(scenario.robots.begin(), scenario.robots.end(), has_name);
  if (found == scenario.robots.end()) throwProblem(place, mark, "there is no robot " + inQuotes(leader.robot));
  leader.robot_number = static_cast<std::uint32_t>(found - scenario.robots.begin());
}

}  // namespace

GroupShare readGroupShare(const YamlMap& map) {
  const YAML::Node node = map.find("groups");
  if (!node) return {};
  const YamlMap entry(node, map.placeOf("groups"), {"share", "sizes"});
  GroupShare groups;
  groups.share = entry.number("share", NumberRule::FRACTION);
  const YAML::Node sizes = entry.find("sizes");
  groups.sizes = sizes ? readSizes(sizes, entry.placeOf("sizes")) : PAIRS_AND_MORE;
  return groups;
}

LeaderDescription readLeader(const YamlMap& map) {
  const YAML::Node node = map.need("leader");
  const YamlPlace place = map.placeOf("leader");
  LeaderDescription leader;
  if (const YAML::Node robot = findOnly("robot", node, place)) {
    leader.robot = readText(robot, place.child("robot"));
    return leader;
  }
  if (!node.IsScalar()) throwExpected(place, node, "the number of an agent, or {robot: NAME}");
  leader.agent = readAgentNumber(node, place);
  return leader;
}

std::vector<GroupDescription> readGroups(const YamlMap& map) {
  const auto read = [](const YAML::Node& node, const YamlPlace& place) {
    const YamlMap entry(node, place, {"members"});
    GroupDescription group;
    group.line = lineOf(node);
    group.members = readList<AgentId>(entry.need("members"), entry.placeOf("members"), readAgentNumber);
    if (group.members.size() < 2) {
      throwExpected(entry.placeOf("members"), entry.need("members"), "the numbers of at least two agents");
    }
    return group;
  };
  return readList<GroupDescription>(map.find("groups"), map.placeOf("groups"), read);
}

void resolveGroups(Scenario& scenario, const YamlPlace& place) {
  Groups groups(scenario);
  for (std::size_t i = 0; i < scenario.agents.size(); ++i) {
    const YamlPlace at = place.child("agents").element(i).child("leader");
    if (scenario.agents[i].leader) resolveLeader(scenario, groups, at, scenario.agents[i]);
    if (scenario.agents[i].leader && scenario.agents[i].leader->robot.empty())
      groups.add(scenario.agents[i].leader->agent);
  }
  for (std::size_t i = 0; i < scenario.groups.size(); ++i) {
    const YamlPlace at = place.child("groups").element(i).child("members");
    const YAML::Mark mark = markOf(scenario.groups[i].line);
    for (const AgentId member : scenario.groups[i].members) {
      groups.requireAgent(member, at, mark);
      const AgentGroup& entry = groups.entryOf(member);
      const bool is_free = groups.add(member) && !entry.leader && entry.groups.share <= 0.0;
      if (!is_free) throwProblem(at, mark, "agent " + std::to_string(member) + " is in another group already");
    }
  }
}

}  // namespace crowd
