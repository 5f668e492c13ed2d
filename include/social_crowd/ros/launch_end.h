#pragma once

namespace crowd {

/// @brief Asks the roslaunch that started this process to end, as Ctrl-C does. It then stops all its nodes, this one
/// too, and exits with status 0. A required node that exits by itself ends the launch as well, but roslaunch reports
/// that as an error even if its exit status is 0.
/// @return false, with nothing done, if the parent process is not the roslaunch of a user: in rosrun, in rostest, on
/// another machine than the launch, or behind a launch prefix that stays between the two.
bool endLaunch();

}  // namespace crowd
