#pragma once

#include "social_crowd/common/vectorised.h"

// The intrinsics for functions that are CROWD_AVX512; nothing where that is not defined.
#ifdef CROWD_AVX512
// The compiler's own header leaves undefined what is not used.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <immintrin.h>
#pragma GCC diagnostic pop
#endif
