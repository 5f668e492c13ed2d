#pragma once

#include <string>

/// Names of topics, services and frames that several files use; another topic or service is named where it is
/// advertised.
namespace crowd::names {

// Topics; relative, so that namespaces and remapping work.
constexpr const char* PERCEPTIONS = "perceptions";  ///< Perceptions: crowd_controller -> learner
constexpr const char* ACTIONS = "actions";          ///< RelativeActions: learner -> crowd_controller
constexpr const char* AGENTS = "agents";            ///< AgentStates: crowd_controller -> visualisation
constexpr const char* SCENARIO = "scenario";        ///< Scenario, latched: crowd_controller -> visualisation
constexpr const char* WALLS = "walls";              ///< Walls, latched: crowd_controller -> visualisation
constexpr const char* MAP = "map";                  ///< nav_msgs/OccupancyGrid, latched: crowd_controller -> RViz
constexpr const char* CONTROLLER_STATUS =
    "controller_status";                                    ///< ControllerStatus: crowd_controller -> user interfaces
constexpr const char* LEARNER_STATUS = "learner_status";    ///< LearnerStatus, latched: learner -> all
constexpr const char* CHOSEN_AGENT = "chosen_agent";        ///< std_msgs/Int32, latched: crowd_markers -> any node
constexpr const char* DECISION_VALUES = "decision_values";  ///< DecisionValues: learner -> crowd_markers
constexpr const char* ROBOTS = "robots";                    ///< RobotStates: crowd_controller -> any node

// Topics of a robot, in its namespace.
constexpr const char* CMD_VEL = "cmd_vel";        ///< geometry_msgs/Twist: any node -> crowd_controller
constexpr const char* ODOMETRY = "odom";          ///< nav_msgs/Odometry
constexpr const char* SCAN = "scan";              ///< sensor_msgs/LaserScan
constexpr const char* GOAL = "goal";              ///< geometry_msgs/PoseStamped, latched: its present goal
constexpr const char* PEOPLE = "people";          ///< people_msgs/People, where people_msgs is installed
constexpr const char* NAVIGATION = "navigation";  ///< std_msgs/String, latched: robot_crew -> crowd_controller

/// @brief Returns the topic with the perceptions of one learner's agents: Perceptions, crowd_controller -> learner.
/// @param perceptions full name of PERCEPTIONS @param learner full name of the node
inline std::string perceptionsOf(const std::string& perceptions, const std::string& learner) {
  return perceptions + learner;  // the name of a node begins with a slash
}

// Services; private names below the node.
constexpr const char* PAUSE = "pause";
constexpr const char* STEP = "step";
constexpr const char* RESET = "reset";
constexpr const char* LOAD_SCENARIO = "load_scenario";
constexpr const char* LIST_SCENARIOS = "list_scenarios";
constexpr const char* SAVE_SCENARIO = "save_scenario";
constexpr const char* SET_REAL_TIME_FACTOR = "set_real_time_factor";
constexpr const char* SPAWN_AGENT = "spawn_agent";
constexpr const char* REMOVE_AGENT = "remove_agent";
constexpr const char* SET_GOAL = "set_goal";
constexpr const char* ADD_SOURCE = "add_source";
constexpr const char* ADD_GATE = "add_gate";
constexpr const char* TELEPORT = "teleport";
constexpr const char* SPAWN_ROBOT = "spawn_robot";
constexpr const char* REMOVE_ROBOT = "remove_robot";
constexpr const char* TELEPORT_ROBOT = "teleport_robot";
constexpr const char* ADD_WALL = "add_wall";
constexpr const char* SPAWN_OBSTACLE = "spawn_obstacle";
constexpr const char* REMOVE_OBSTACLE = "remove_obstacle";
constexpr const char* MOVE_OBSTACLE = "move_obstacle";
constexpr const char* CHOOSE_AGENT = "choose_agent";
constexpr const char* SAVE_Q_TABLE = "save_q_table";
constexpr const char* LOAD_Q_TABLE = "load_q_table";
constexpr const char* SHARE_Q_TABLE = "share_q_table";
constexpr const char* TAKE_Q_TABLE = "take_q_table";
constexpr const char* SET_MODE = "set_mode";
constexpr const char* SET_LEARNING_PARAMETERS = "set_learning_parameters";

// Frames.
constexpr const char* MAP_FRAME = "map";
constexpr const char* ODOM_FRAME = "odom";       ///< of a robot, after the prefix NAMESPACE/
constexpr const char* BASE_FRAME = "base_link";  ///< the same
constexpr const char* LASER_FRAME = "laser";     ///< the same
constexpr const char* AGENT_FRAME_PREFIX = "agent_";
constexpr const char* CROWD_FRAME = "crowd";  ///< at the centre of the scenario, rounded to metres; axes as in map

}  // namespace crowd::names
