#pragma once

#include <std_msgs/ColorRGBA.h>

#include <cstddef>
#include <cstdint>

#include "scenario/figure.h"

/// Colours and sizes of all markers.
namespace crowd::marker_style {

using Colour = std_msgs::ColorRGBA;

// One namespace for each kind of marker; RViz can switch each off.
constexpr const char* MAP = "map";
constexpr const char* BODIES = "bodies";
constexpr const char* HEADINGS = "headings";
constexpr const char* GOALS = "goals";
constexpr const char* PATHS = "paths";
constexpr const char* OBSTACLES = "obstacles";
constexpr const char* WALLS = "walls";
constexpr const char* RADII = "radii";
constexpr const char* SECTORS = "sectors";
constexpr const char* VALUES = "values";
constexpr const char* VISITS = "visits";
constexpr const char* ROBOTS = "robots";
constexpr const char* FIGURES = "figures";
constexpr const char* RECORDED = "recorded";
constexpr const char* RECORDED_FIGURES = "recorded_figures";
constexpr const char* BELONGINGS = "belongings";
constexpr const char* GROUPS = "groups";

/// @brief Drawing order, lowest first.
enum class Layer {
  MAP = 0,
  SECTORS,
  OBSTACLES,
  WALLS,
  PATHS,
  GOALS,
  GROUPS,
  RADII,
  VALUES,
  CHOSEN_MOVE,
  BODIES,
  HEADINGS,
  CONTACTS
};
constexpr double LAYER_HEIGHT = 0.02;  ///< distance between two layers [m]; RViz mixes layers that are nearer

// Sizes [m].
constexpr double PATH_WIDTH = 0.035;
constexpr double WALL_WIDTH = 0.06;
constexpr double GROUP_WIDTH = 0.05;
constexpr double RADIUS_WIDTH = 0.02;
constexpr double CONTACT_WIDTH = 0.06;
constexpr double CHOSEN_WIDTH = 0.025;
constexpr double GOAL_WIDTH = 0.045;
constexpr double GOAL_SIZE = 0.13;        ///< length of an arm of the cross
constexpr double ROBOT_GOAL_SIZE = 0.26;  ///< the same, of a robot

// Arrow of a heading, in radii of the body: positions ahead of the centre and to the side.
constexpr double ARROW_TIP = 0.78;
constexpr double ARROW_BACK = -0.5;
constexpr double ARROW_NOTCH = -0.2;
constexpr double ARROW_HALF_WIDTH = 0.5;

/// @brief Approximate number of corners of all bodies together.
constexpr std::size_t CORNER_BUDGET = 12'000;
constexpr std::size_t MIN_CORNERS = 10;
constexpr std::size_t MAX_CORNERS = 36;

/// @brief Returns the number of corners of a circle for a number of bodies.
std::size_t cornersFor(std::size_t bodies);

/// @brief Colour of an agent. Consecutive numbers have clearly different colours, and none is the red of contacts.
Colour ofAgent(std::uint32_t agent);
/// @brief Returns the colour mixed with white.
Colour paler(const Colour& colour);
/// @brief Returns the colour mixed with that of the floor in rviz/social_crowd.rviz: 1 the colour, 0 the floor. RViz
/// ignores the opacity of the points of lines.
Colour faded(const Colour& colour, double strength);
/// @brief Colour of the circle that limits a distance class. The last limit is the radius of vision (amber), the others
/// are collision radii (red).
/// @param classes number of classes
Colour ofRadius(std::size_t distance_class, std::size_t classes);
/// @brief Colour of an occupied sector (translucent) by its class.
Colour ofSector(std::size_t distance_class, std::size_t classes);
/// @brief Parts of a person's figure; the dark ones are hair, trousers or skirt, and shoes; belongings are a
/// wheelchair, a suitcase or a stick.
enum class FigurePart { HEAD, SHIRT, DARK, BELONGINGS };
constexpr std::size_t FIGURE_PARTS = 4;
/// @brief Colour of a part; the shirt has the colour of the agent, the hair of old people is grey.
Colour ofFigure(FigurePart part, Figure figure, std::uint32_t agent);
/// @brief Height of the figure of an agent, as a factor of that of the meshes (1.75 m).
double figureHeight(Figure figure, std::uint32_t agent);
/// @brief Colour of the floor that the body of an agent with a figure covers.
Colour underFigure(std::uint32_t agent);
/// @brief Colour of the value of a move, also for people who do not distinguish red and green: from dark violet (0, the
/// worst move of a decision) over green to yellow (1, the best).
Colour ofValue(double share);
/// @brief Outline of the chosen move. @param exploration whether another one has a higher value
Colour ofChosenMove(bool exploration);
Colour ofVisits();
Colour ofContact();
Colour ofRobot();
/// @brief Colour of the lines between people who walk together.
Colour ofGroup();
Colour ofHeading();
Colour ofObstacle();
/// @brief Colour of recorded people: nearly black.
Colour ofRecorded();
Colour ofWall();
/// @brief Colour of the cells of a map that are not free. @param occupied else unknown
Colour ofCell(bool occupied);

}  // namespace crowd::marker_style
