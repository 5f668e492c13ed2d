#include "nodes/programs.h"

#include "ros/controller/crowd_controller.h"
#include "ros/learner/learner_node.h"
#include "ros/markers/crowd_markers.h"
#include "ros/node/node_main.h"
#include "ros/robots/robot_controller_node.h"

namespace crowd {

int runCrowdController(int argc, char** argv) {
  return runNode<CrowdController>(argc, argv, "crowd_controller",
                                  {"Owns world, clock and episodes: tells learners what their agents "
                                   "perceive, and moves the agents as they answer.",
                                   "_scenario:=circle6 _real_time_factor:=4"});
}

int runCrowdMarkers(int argc, char** argv) {
  return runNode<CrowdMarkers>(argc, argv, "crowd_markers",
                               {"Publishes the crowd as markers for RViz.", "_figures:=discs _agent:=2"});
}

int runLearner(int argc, char** argv) {
  return runNode<LearnerNode>(
      argc, argv, "learner",
      {"Decides for agents by a Q-table, and goes on learning in training mode.",
       "_q_table:=$(rospack find social_crowd)/config/q_tables/anticipation.txt _agents:=\"[0, 1]\""});
}

int runRobotController(int argc, char** argv) {
  return runNode<RobotControllerNode>(
      argc, argv, "robot_controller",
      {"Drives a robot to its goals by its laser scan; an example to be replaced by your own.",
       "__ns:=tug _radius:=0.25"});
}

}  // namespace crowd
