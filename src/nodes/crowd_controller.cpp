#include "social_crowd/ros/crowd_controller.h"

#include "social_crowd/ros/node_main.h"

int main(int argc, char** argv) { return crowd::runNode<crowd::CrowdController>(argc, argv, "crowd_controller"); }
