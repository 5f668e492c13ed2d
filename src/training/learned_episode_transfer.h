#pragma once

#include "simulation/agent_transfer.h"
#include "social_crowd/simulation/byte_archive.h"
#include "social_crowd/training/training_state.h"

namespace crowd {

/// Calls archive(field) for each field of the result of a robot, to write or to read it (byte_archive.h).
template <typename Archive, typename AResult>
void transferRobot(Archive& archive, AResult& result) {
  archive(result.name);
  archive(result.success);
  archive(result.timeout);
  archive(result.stuck);
  archive(result.time_to_reach_goal);
  archive(result.path_length);
  archive(result.path_length_ratio);
  archive(result.final_distance);
  archive(result.minimum_distance_to_goal);
  archive(result.avg_robot_linear_speed);
  archive(result.max_speed);
  archive(result.avg_acceleration);
  archive(result.max_acceleration);
  archive(result.avg_jerk);
  archive(result.max_jerk);
  archive(result.cumulative_heading_changes);
  archive(result.time_not_moving);
  archive(result.robot_on_person_collisions);
  archive(result.person_on_robot_collisions);
  archive(result.mutual_collisions);
  archive(result.contact_time);
  archive(result.wall_contacts);
  archive(result.robot_contacts);
  archive(result.minimum_distance_to_people);
  archive(result.avg_closest_person);
  archive(result.minimum_clearance);
  archive(result.intimate_space_time);
  archive(result.personal_space_time);
  archive(result.intimate_space_intrusions);
  archive(result.personal_space_intrusions);
  archive(result.people_compared);
  archive(result.people_delay);
  archive(result.people_detour);
  archive(result.input.taken);
  archive(result.input.missed);
  archive(result.input.late);
  archive(result.input.timeouts);
  archive(result.input.refused);
  archive(result.input.poses_taken);
  archive(result.input.poses_refused);
  archive(result.input.jumps);
  archive(result.input.gaps);
  archive(result.input.stale);
}

inline void transferAgents(ByteWriter& write, const AgentResults& agents) {
  write(static_cast<std::uint64_t>(agents.size()));
  for (const AgentResult& agent : agents) transferResult(write, agent);
}

inline void transferAgents(ByteReader& read, AgentResults& agents) {
  std::vector<AgentResult> results;
  transferAll(read, results, [&](AgentResult& result) { transferResult(read, result); });
  agents = std::move(results);
}

/// The same for an episode of a training, with the results of its agents and robots.
template <typename Archive, typename AnEpisode>
void transferEpisode(Archive& archive, AnEpisode& episode) {
  archive(episode.scenario);
  archive(episode.ticks);
  archive(episode.way_finding_problem);
  archive(episode.decisions);
  archive(episode.reward);
  archive(episode.epsilon);
  archive(episode.visited_rows);
  transferAgents(archive, episode.agents);
  transferAll(archive, episode.robots, [&](auto& result) { transferRobot(archive, result); });
}

}  // namespace crowd
