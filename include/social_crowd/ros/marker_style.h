#pragma once

#include <std_msgs/ColorRGBA.h>

#include <cstddef>
#include <cstdint>

/// How the markers look: all colours and sizes, and only here.
namespace crowd::marker_style {

using Colour = std_msgs::ColorRGBA;

// One namespace for each kind of marker; RViz can switch each off.
constexpr const char* BODIES = "bodies";
constexpr const char* HEADINGS = "headings";
constexpr const char* GOALS = "goals";
constexpr const char* PATHS = "paths";
constexpr const char* OBSTACLES = "obstacles";
constexpr const char* WALLS = "walls";
constexpr const char* RADII = "radii";
constexpr const char* SECTORS = "sectors";

/// @brief What lies over what, seen from above.
enum class Layer { SECTORS = 1, OBSTACLES, WALLS, PATHS, GOALS, RADII, BODIES, HEADINGS, CONTACTS };
constexpr double LAYER_HEIGHT = 0.02;  ///< from one layer to the next [m]; less and RViz mixes them up

// Sizes [m].
constexpr double PATH_WIDTH = 0.035;
constexpr double WALL_WIDTH = 0.06;
constexpr double RADIUS_WIDTH = 0.02;
constexpr double CONTACT_WIDTH = 0.06;
constexpr double GOAL_WIDTH = 0.045;
constexpr double GOAL_SIZE = 0.13;  ///< from the centre of a goal's cross to the end of an arm

// The arrow that shows a heading, in radii of its body: ahead of the centre and to the side.
constexpr double ARROW_TIP = 0.78;
constexpr double ARROW_BACK = -0.5;
constexpr double ARROW_NOTCH = -0.2;
constexpr double ARROW_HALF_WIDTH = 0.5;

/// @brief Bodies of a crowd together have about so many corners: the more bodies, the fewer corners each.
constexpr std::size_t CORNER_BUDGET = 12'000;
constexpr std::size_t MIN_CORNERS = 10;
constexpr std::size_t MAX_CORNERS = 36;

/// @brief Corners of the circles of each of so many bodies.
std::size_t cornersFor(std::size_t bodies);

/// @brief Own colour of an agent; neighbouring numbers differ strongly, and none is the red of contacts.
Colour ofAgent(std::uint32_t agent);
/// @brief The same colour, nearer to the ground's.
Colour paler(const Colour& colour);
/// @brief Of the circle that limits a distance class, of so many classes: the last limit is the radius of vision,
/// amber; one before it is a collision radius, red. A state set with one class has a radius of vision only.
Colour ofRadius(std::size_t distance_class, std::size_t classes);
/// @brief Of an occupied sector (translucent), as its class.
Colour ofSector(std::size_t distance_class, std::size_t classes);
Colour ofContact();
Colour ofHeading();
Colour ofObstacle();
Colour ofWall();

}  // namespace crowd::marker_style
