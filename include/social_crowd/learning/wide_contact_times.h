#pragma once

#include <cstddef>

#include "social_crowd/learning/contact_times.h"

namespace crowd {

/// @brief A form of noteAgents().
using NoteAgents = void (*)(const Discs& agents, std::size_t count, const Vector2& velocity, const Vector2& wish,
                            Courses& courses, float& fastest);

/// @brief The fastest noteAgents() for many discs that this processor can run; all give the same bits. With AVX-512
/// most pairs of a move and a disc are left out, as they have no time of contact.
NoteAgents fastestForMany();

}  // namespace crowd
