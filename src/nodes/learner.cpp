#include "social_crowd/ros/learner_node.h"

#include "social_crowd/ros/node_main.h"

int main(int argc, char** argv) { return crowd::runNode<crowd::LearnerNode>(argc, argv, "learner"); }
