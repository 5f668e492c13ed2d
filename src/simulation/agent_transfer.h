#pragma once

#include "social_crowd/simulation/episode_result.h"
#include "social_crowd/world/agent.h"

namespace crowd {

/// Calls archive(field) for each field of an agent, to write or to read it (byte_archive.h).
template <typename Archive, typename AnAgent>
void transferAgent(Archive& archive, AnAgent& agent) {
  archive(agent.id);
  archive(agent.pose.position);
  archive(agent.pose.heading);
  archive(agent.ahead);
  archive(agent.velocity);
  archive(agent.max_speed);
  archive(agent.radius);
  archive(agent.goals);
  archive(agent.next_goal);
  archive(agent.present_goal);
  archive(agent.waypoint);
  archive(agent.goal_number);
  archive(agent.status);
  archive(agent.leaves);
  archive(agent.has_waypoint);
  archive(agent.at_goal);
  archive(agent.held);
  archive(agent.yielding);
  archive(agent.arrival_tick);
  archive(agent.acted);
  archive(agent.blocked);
  archive(agent.blocked_moves);
  archive(agent.in_contact);
  archive(agent.bumped);
  archive(agent.touched);
  archive(agent.in_collision);
  archive(agent.collided);
}

/// The same for the result of an agent.
template <typename Archive, typename AResult>
void transferResult(Archive& archive, AResult& result) {
  archive(result.arrived);
  archive(result.removed);
  archive(result.touched);
  archive(result.collided);
  archive(result.out_of_reach);
  archive(result.endless);
  archive(result.waypoints);
  archive(result.blocked_moves);
  archive(result.appeared);
  archive(result.start);
  archive(result.ticks);
  archive(result.heading);
  archive(result.path_length);
  archive(result.straight_length);
  archive(result.path_ratio);
  archive(result.time_ratio);
  archive(result.turn_per_metre);
  archive(result.max_speed_ratio);
  archive(result.distance_gained);
  archive(result.gain_per_tick);
  archive(result.path_per_gain);
}

/// The same for the track of an agent.
template <typename Archive, typename ATrack>
void transferTrack(Archive& archive, ATrack& track) {
  archive(track.begin);
  archive(track.start);
  archive(track.goal);
  archive(track.position);
  archive(track.course);
  archive(track.moves);
  archive(track.longest_step);
  archive(track.distance);
  archive(track.turn);
  archive(track.max_speed);
  transferResult(archive, track.result);
}

}  // namespace crowd
