// Messages of topics, one after the other, each behind a byte that tells which it is; a tick is one of them.

#include "fuzz/messages.h"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <social_crowd/LearnerStatus.h>
#include <tf2/utils.h>

#include "fuzz/small_world.h"
#include "maps/map_walls.h"
#include "robots/external_robot.h"
#include "ros/controller/learner_visions.h"
#include "ros/messages/conversions.h"
#include "ros/messages/motion_fields.h"
#include "ros/messages/perception_limiter.h"
#include "ros/messages/tick_messages.h"
#include "ros/messages/vision.h"
#include "ros/robots/robot_messages.h"
#include "simulation/lockstep.h"

namespace {

using namespace crowd;

constexpr double TICK = 0.1;  // [s]

/// What the messages change.
struct Nodes {
  Nodes() {
    lockstep.open(0, 0, {0, 1});
    commands.begin({1.0}, TICK);
  }

  Episode episode{fuzz::smallScene(), 0, {}, ThreadPool::callerOnly(), fuzz::stopAfter(fuzz::PATIENCE)};
  Learner learner = fuzz::makeLearner(Mode::TRAINING);
  PerceptionLimiter limiter{learner.model().vision()};
  Lockstep lockstep{3};
  LearnerVisions visions;
  RobotCommands commands{{}};
  ExternalRobot external{1.0, TICK};
};

using Handler = void (*)(Nodes& nodes, fuzz::MessageStream& stream);

void takeActions(Nodes& nodes, fuzz::MessageStream& stream) {
  nodes.lockstep.take(stream.takeTickMessage<ActionsMessage>().content, 0);
  nodes.episode.step(nodes.lockstep.answers());
  nodes.lockstep.open(0, nodes.episode.world().tick(), {0, 1});
}

void takePerceptions(Nodes& nodes, fuzz::MessageStream& stream) {
  const auto message = stream.takeTickMessage<PerceptionsMessage>();
  if (!covers(message.vision, nodes.limiter.vision())) return;
  requireValid(message.content());
  RelativeActions actions;
  nodes.learner.decide(nodes.limiter.limit(message.content(), message.vision), actions);
}

void takeStatus(Nodes& nodes, fuzz::MessageStream& stream) {
  const auto status = stream.take<social_crowd::LearnerStatus>();
  nodes.visions.report(status.node, {status.vision_radius, status.max_neighbours, status.occlusion != 0,
                                     wallDistanceOf(status.wall_distance),
                                     fromFields({status.acceleration, status.braking, status.turn_rate})});
  nodes.episode.setVision(nodes.visions.widest());
}

void takeMap(Nodes& nodes, fuzz::MessageStream& stream) {
  const auto map = std::make_shared<const OccupancyMap>(fromMessage(stream.take<nav_msgs::OccupancyGrid>()));
  nodes.episode.edit().replaceMap(map, traceWalls(*map));
}

void takeCommand(Nodes& nodes, fuzz::MessageStream& stream) {
  const std::uint64_t tick = nodes.episode.world().tick();
  nodes.commands.take(0, fromMessage(stream.take<geometry_msgs::Twist>()), 0, tick);
  nodes.episode.robots().command(0, nodes.commands.commandFor(0, tick));
}

void takeGoal(Nodes& nodes, fuzz::MessageStream& stream) {
  nodes.episode.edit().sendRobot(0, fromPoint(stream.take<geometry_msgs::PoseStamped>().pose.position));
}

Pose poseOf(const geometry_msgs::Pose& pose) { return {fromPoint(pose.position), tf2::getYaw(pose.orientation)}; }

void takePose(Nodes& nodes, fuzz::MessageStream& stream) {
  nodes.episode.edit().teleportRobot(0, poseOf(stream.take<geometry_msgs::PoseWithCovarianceStamped>().pose.pose));
}

void takeOdometry(Nodes& nodes, fuzz::MessageStream& stream) {
  const auto message = stream.take<nav_msgs::Odometry>();
  nodes.external.take(poseOf(message.pose.pose), message.header.stamp.toSec());
  const auto state = nodes.external.at(TICK * static_cast<double>(nodes.episode.world().tick() + 1));
  if (state) nodes.episode.robots().place(0, state->pose, state->velocity, state->jumped);
}

void walk(Nodes& nodes, fuzz::MessageStream& /*stream*/) { fuzz::walk(nodes.episode); }

constexpr Handler HANDLERS[] = {walk,        takeActions, takePerceptions, takeStatus,  takeMap,
                                takeCommand, takeGoal,    takePose,        takeOdometry};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed(
      size, 10'000,
      [&] {
        fuzz::MessageStream stream(data, size);
        Nodes nodes;
        fuzz::handleAll(HANDLERS, nodes, stream);
        fuzz::walk(nodes.episode);
      },
      fuzz::FLOOR_MEMORY);
}
