#include "rviz/crowd_editor.h"

#include "ros/node/node_main.h"

int main(int argc, char** argv) {
  return crowd::runNode<crowd::CrowdEditor>(
      argc, argv, "crowd_editor",
      {"Publishes markers with which agents, goals and obstacles of a running crowd are moved in RViz.",
       "_controller:=/crowd_controller"});
}
