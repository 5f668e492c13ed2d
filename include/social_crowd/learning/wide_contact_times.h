#pragma once

#include <cstddef>

#include "social_crowd/learning/contact_times.h"

namespace crowd {

/// @brief With no more discs than these it is best to look at moves side by side.
constexpr std::size_t FEW_DISCS = 5;

/// @brief A form of noteAgents().
using NoteAgents = void (*)(const Encounters& encounters);

/// @brief The fastest noteAgents() that this processor can run; all give the same bits. With AVX-512 most pairs of a
/// move and a disc are left out, as they have no time of contact.
NoteAgents fastestNoteAgents();

}  // namespace crowd
