#pragma once

namespace crowd {

/// @brief main() of a node, as runNode() describes it. These functions are compiled with the library: the headers of
/// ROS take longer to read than they do.
int runCrowdController(int argc, char** argv);
int runCrowdMarkers(int argc, char** argv);
int runLearner(int argc, char** argv);
int runRobotController(int argc, char** argv);

}  // namespace crowd
