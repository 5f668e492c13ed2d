#pragma once

#include <vector>

#include "geometry/geometry.h"
#include "simulation/episode_result.h"
#include "social_crowd/episode.h"
#include "social_crowd/perception.h"
#include "social_crowd/results.h"
#include "world/perception.h"
#include "world/relative_action.h"
#include "world/world.h"

/// Conversions between the types of the public headers and those of the package.
namespace crowd::library {

inline Vector2 toPublic(const crowd::Vector2& v) { return {v.x(), v.y()}; }
inline crowd::Vector2 fromPublic(const Vector2& v) { return {v.x, v.y}; }
inline Pose toPublic(const crowd::Pose& pose) { return {toPublic(pose.position), pose.heading}; }
inline crowd::Pose fromPublic(const Pose& pose) { return {fromPublic(pose.position), pose.heading}; }
inline Wall toPublic(const Segment& wall) { return {toPublic(wall.from), toPublic(wall.to)}; }
inline Segment fromPublic(const Wall& wall) { return {fromPublic(wall.from), fromPublic(wall.to)}; }
inline MotionLimits toPublic(const crowd::MotionLimits& motion) {
  return {motion.acceleration, motion.braking, motion.turn_rate};
}
/// @throws InputError unless they are limits
crowd::MotionLimits fromPublic(const MotionLimits& motion);
inline crowd::Vision fromPublic(const Vision& vision) {
  return {vision.radius, vision.max_neighbours, vision.occlusion, vision.wall_distance, fromPublic(vision.motion)};
}

EpisodeResult toPublic(const crowd::EpisodeResult& result);
/// @param arrays are overwritten; their memory is reused
void toPublic(const World& world, AgentArrays& arrays);
/// @param to is overwritten; its memory is reused
void toPublic(const crowd::Perceptions& from, Perceptions& to);
/// @param to is overwritten; its memory is reused @throws InputError as Learner::decide() does
void fromPublic(const Perceptions& from, crowd::Perceptions& to);
std::vector<Action> toPublic(const std::vector<AgentAction>& actions);
/// @param to is overwritten
void fromPublic(const std::vector<Action>& from, std::vector<AgentAction>& to);

}  // namespace crowd::library
