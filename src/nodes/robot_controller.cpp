#include "social_crowd/ros/robot_controller_node.h"

#include "social_crowd/ros/node_main.h"

int main(int argc, char** argv) { return crowd::runNode<crowd::RobotControllerNode>(argc, argv, "robot_controller"); }
