#include "ros/markers/crowd_markers.h"

#include "ros/node/node_main.h"

int main(int argc, char** argv) {
  return crowd::runNode<crowd::CrowdMarkers>(argc, argv, "crowd_markers",
                                             {"Publishes the crowd as markers for RViz.", "_figures:=discs _agent:=2"});
}
