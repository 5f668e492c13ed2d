#pragma once

#include "simulation/episode_result.h"
#include "world/agent.h"

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
  archive(agent.own_speed);
  archive(agent.wanted_speed);
  for (auto& pace : agent.paces) archive(pace);
  archive(agent.radius);
  archive(agent.kind);
  archive(agent.figure);
  archive(agent.goals);
  archive(agent.next_goal);
  archive(agent.present_goal);
  archive(agent.waypoint);
  archive(agent.goal_number);
  archive(agent.status);
  archive(agent.group);
  archive(agent.leaves);
  archive(agent.stays);
  archive(agent.has_waypoint);
  archive(agent.at_goal);
  archive(agent.holds);
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
  AgentResult::visitFields([&](const char* /*name*/, auto& field) { archive(field); }, result);
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
