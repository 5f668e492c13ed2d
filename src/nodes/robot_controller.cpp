#include "ros/robots/robot_controller_node.h"

#include "ros/node/node_main.h"

int main(int argc, char** argv) {
  return crowd::runNode<crowd::RobotControllerNode>(
      argc, argv, "robot_controller",
      {"Drives a robot to its goals by its laser scan; an example to be replaced by your own.",
       "__ns:=tug _radius:=0.25"});
}
