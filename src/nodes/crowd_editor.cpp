#include "rviz/crowd_editor.h"

#include "social_crowd/ros/node_main.h"

int main(int argc, char** argv) { return crowd::runNode<crowd::CrowdEditor>(argc, argv, "crowd_editor"); }
