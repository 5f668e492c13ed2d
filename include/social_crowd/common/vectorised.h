#pragma once

/// @brief Before a function: compiled for wider vector instructions (8 and 16 floats), too, of which those are run that
/// the processor has. The loops in it give the same bits either way, as nothing is contracted or reordered
/// (CMakeLists.txt).
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__)
#define CROWD_VECTORISED __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define CROWD_VECTORISED
#endif
