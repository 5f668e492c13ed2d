#include "ros/learner/learner_node.h"

#include "ros/node/node_main.h"

int main(int argc, char** argv) {
  return crowd::runNode<crowd::LearnerNode>(
      argc, argv, "learner",
      {"Decides for agents by a Q-table, and goes on learning in training mode.",
       "_q_table:=$(rospack find social_crowd)/config/q_tables/anticipation.txt _agents:=\"[0, 1]\""});
}
