#pragma once

#include <cstddef>

#include "social_crowd/learning/contact_times.h"

namespace crowd {

/// @brief A form of noteAgents().
using NoteAgents = void (*)(const Encounters& encounters);

/// @brief The fastest noteAgents() that this processor can run; all give the same bits.
NoteAgents fastestNoteAgents();

}  // namespace crowd
