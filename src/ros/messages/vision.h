#pragma once

#include <string>

#include "world/perception.h"

namespace crowd {

/// @brief Returns the smallest vision whose perceptions contain those of both, so that PerceptionLimiter can derive
/// either of them.
///
/// Occlusion with another radius gives other results, because a body beyond the smaller radius can hide part of a body
/// within it. So the result has occlusion only if both have it with the same radius. A learner that needs occlusion
/// otherwise applies it itself, for which it needs all bodies: the number of neighbours is then not limited.
Vision widest(const Vision& a, const Vision& b);

/// @brief Whether perceptions made with `vision` contain those made with `needed`: widest() of both is `vision`.
bool covers(const Vision& vision, const Vision& needed);

bool areEqual(const Vision& a, const Vision& b);
/// @brief Returns the vision as text for log messages.
std::string toText(const Vision& vision);

/// @brief The distance to walls as in messages, in which 0 stands for all walls within the radius of vision [m].
double wallDistanceField(const Vision& vision);
/// @brief Inverse of wallDistanceField().
double wallDistanceOf(double field);

}  // namespace crowd
