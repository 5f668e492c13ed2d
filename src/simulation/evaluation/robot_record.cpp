#include "simulation/evaluation/robot_record.h"

#include "common/text/numbers.h"

namespace crowd {

std::string robotRecordHeader() {
  std::string header = "episode,scenario,robot";
  const RobotResult result;
  RobotResult::visitFields([&](const std::string& name, const auto& /*value*/) { header += "," + name; }, result);
  return header + "\n";
}

void appendRobotRows(std::uint64_t episode, const EpisodeResult& result, std::string& rows) {
  for (const RobotResult& robot : result.robots) {
    rows += std::to_string(episode) + "," + result.scenario + "," + robot.name;
    RobotResult::visitFields([&](const char* /*name*/, const auto& value) { rows += "," + toField(value); }, robot);
    rows += "\n";
  }
}

std::string robotGoalHeader() {
  std::string header = "episode,scenario,robot,goal";
  const RobotGoalResult result;
  RobotGoalResult::visitFields([&](const std::string& name, const auto& /*value*/) { header += "," + name; }, result);
  return header + "\n";
}

void appendRobotGoalRows(std::uint64_t episode, const EpisodeResult& result, std::string& rows) {
  for (const RobotResult& robot : result.robots) {
    for (std::size_t goal = 0; goal < robot.goals.size(); ++goal) {
      rows += std::to_string(episode) + "," + result.scenario + "," + robot.name + "," + std::to_string(goal);
      RobotGoalResult::visitFields([&](const char* /*name*/, const auto& value) { rows += "," + toField(value); },
                                   robot.goals[goal]);
      rows += "\n";
    }
  }
}

void RobotSummary::add(const EpisodeResult& result) {
  for (const RobotResult& robot : result.robots) {
    ++robots_;
    arrived_ += robot.success ? 1 : 0;
    clean_ += robot.isClean() ? 1 : 0;
    on_person_ += robot.robot_on_person_collisions;
    on_robot_ += robot.person_on_robot_collisions;
    mutual_ += robot.mutual_collisions;
    if (robot.success) time_ += robot.time_to_reach_goal;
  }
  if (result.robots.empty() || result.robots.front().people_compared == 0) return;
  const RobotResult& first = result.robots.front();
  people_ += first.people_compared;
  people_delay_ += static_cast<double>(first.people_compared) * first.people_delay;
  people_detour_ += static_cast<double>(first.people_compared) * first.people_detour;
}

std::string RobotSummary::text() const {
  if (robots_ == 0) return "";
  std::string text = "robots: " + std::to_string(arrived_) + " of " + std::to_string(robots_) + " arrived";
  if (arrived_ > 0) text += " after " + toFixedText(time_ / static_cast<double>(arrived_), 1) + " s";
  text += ", " + std::to_string(clean_) + " of them without a contact; contacts: " + std::to_string(on_person_) +
          " robot on person, " + std::to_string(on_robot_) + " person on robot, " + std::to_string(mutual_) + " mutual";
  if (people_ == 0) return text;
  const auto mean = [&](double sum) { return toFixedText(sum / static_cast<double>(people_), 2); };
  return text + "; people are delayed by " + mean(people_delay_) + " s, with a detour of " + mean(people_detour_) +
         " m";
}

}  // namespace crowd
