#include "ros/controller/crowd_controller.h"

#include "ros/node/node_main.h"

int main(int argc, char** argv) {
  return crowd::runNode<crowd::CrowdController>(argc, argv, "crowd_controller",
                                                {"Owns world, clock and episodes: tells learners what their agents "
                                                 "perceive, and moves the agents as they answer.",
                                                 "_scenario:=circle6 _real_time_factor:=4"});
}
