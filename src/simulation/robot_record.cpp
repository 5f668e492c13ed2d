#include "social_crowd/simulation/robot_record.h"

#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

/// Calls number(name, value) or count(name, value) for each field of a result but the name of the robot.
template <typename Number, typename Count>
void forEachField(const RobotResult& result, const Number& number, const Count& count) {
  count("success", result.success ? 1 : 0);
  count("timeout", result.timeout ? 1 : 0);
  count("stuck", result.stuck ? 1 : 0);
  number("time_to_reach_goal", result.time_to_reach_goal);
  number("path_length", result.path_length);
  number("path_length_ratio", result.path_length_ratio);
  number("final_distance", result.final_distance);
  number("minimum_distance_to_goal", result.minimum_distance_to_goal);
  number("avg_robot_linear_speed", result.avg_robot_linear_speed);
  number("max_speed", result.max_speed);
  number("avg_acceleration", result.avg_acceleration);
  number("max_acceleration", result.max_acceleration);
  number("avg_jerk", result.avg_jerk);
  number("max_jerk", result.max_jerk);
  number("cumulative_heading_changes", result.cumulative_heading_changes);
  number("time_not_moving", result.time_not_moving);
  count("robot_on_person_collisions", result.robot_on_person_collisions);
  count("person_on_robot_collisions", result.person_on_robot_collisions);
  count("mutual_collisions", result.mutual_collisions);
  number("contact_time", result.contact_time);
  count("wall_contacts", result.wall_contacts);
  count("robot_contacts", result.robot_contacts);
  number("minimum_distance_to_people", result.minimum_distance_to_people);
  number("avg_closest_person", result.avg_closest_person);
  number("minimum_clearance", result.minimum_clearance);
  number("intimate_space_time", result.intimate_space_time);
  number("personal_space_time", result.personal_space_time);
  number("intimate_space_intrusions", result.intimate_space_intrusions);
  number("personal_space_intrusions", result.personal_space_intrusions);
  count("people_compared", result.people_compared);
  number("people_delay", result.people_delay);
  number("people_detour", result.people_detour);
  count("commands_taken", result.input.taken);
  count("commands_missed", result.input.missed);
  count("commands_late", result.input.late);
  count("command_timeouts", result.input.timeouts);
  count("commands_refused", result.input.refused);
  count("poses_taken", result.input.poses_taken);
  count("poses_refused", result.input.poses_refused);
  count("pose_jumps", result.input.jumps);
  count("pose_gaps", result.input.gaps);
  count("pose_stale", result.input.stale);
}

}  // namespace

std::string robotRecordHeader() {
  std::string header = "episode,scenario,robot";
  const auto append = [&](const char* name, auto /*value*/) { header += std::string(",") + name; };
  forEachField(RobotResult(), append, append);
  return header + "\n";
}

void appendRobotRows(std::uint64_t episode, const EpisodeResult& result, std::string& rows) {
  for (const RobotResult& robot : result.robots) {
    rows += std::to_string(episode) + "," + result.scenario + "," + robot.name;
    forEachField(
        robot, [&](const char* /*name*/, double value) { rows += "," + toText(value); },
        [&](const char* /*name*/, std::uint64_t value) { rows += "," + std::to_string(value); });
    rows += "\n";
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
