// ROS's program `nodelet` for builds with a sanitizer, as that is built without one: with the argument `manager` it
// runs a manager, with `standalone TYPE` a nodelet alone.

#include <nodelet/loader.h>
#include <ros/ros.h>

#include <cstdlib>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  std::vector<std::string> arguments;
  ros::removeROSArgs(argc, argv, arguments);
  const std::string command = arguments.size() > 1 ? arguments[1] : "";
  if (command != "manager" && (command != "standalone" || arguments.size() < 3)) return EXIT_FAILURE;
  ros::init(argc, argv, command == "manager" ? "manager" : "nodelet");
  nodelet::Loader loader(command == "manager");  // only a manager has services
  if (command == "standalone") {
    const nodelet::V_string rest(arguments.begin() + 3, arguments.end());
    if (!loader.load(ros::this_node::getName(), arguments[2], ros::names::getRemappings(), rest)) return EXIT_FAILURE;
  }
  ros::spin();
  return EXIT_SUCCESS;
}
