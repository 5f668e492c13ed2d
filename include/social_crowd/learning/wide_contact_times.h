#pragma once

#include "social_crowd/learning/contact_times.h"

namespace crowd {

/// @brief Whether the processor has the instructions that noteAgentsWidely() needs (AVX-512).
bool mayNoteWidely();

/// @brief noteAgentsPlainly() bit for bit, in half of its time where there are many discs: most pairs of a move and a
/// disc are left out, as they have no time of contact. Only if mayNoteWidely().
void noteAgentsWidely(const Discs& agents, const Vector2& velocity, const Vector2& wish, Courses& courses,
                      float& fastest);

}  // namespace crowd
