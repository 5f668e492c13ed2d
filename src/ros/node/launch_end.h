#pragma once

namespace crowd {

/// @brief Sends SIGINT to the roslaunch that started this process. It then stops all its nodes, including this one, and
/// exits with status 0. (A required node that exits also ends the launch, but roslaunch reports that as an error even
/// if the exit status is 0.)
/// @return false, and nothing is sent, if the parent process is not roslaunch: in rosrun, in rostest, on a remote
/// machine, or with a launch prefix whose process stays between the two
bool endLaunch();

}  // namespace crowd
