#pragma once

// CROWD_VECTORISED before a function: compiled for wider vector instructions (8 and 16 floats), too, of which those are
// run that the processor has. The loops in it give the same bits either way, as nothing is contracted or reordered
// (CMakeLists.txt).
// CROWD_AVX512 before a function: compiled for AVX-512 and may use its intrinsics; to be called only where hasAvx512().
// Where the compiler does not know them it is not defined.
// CROWD_FASTEST(wide, plain): of two functions of one type the first, which is CROWD_AVX512, where the processor runs
// it.
// ThreadSanitizer cannot start with functions that are chosen while the program is loaded.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define CROWD_VECTORISED __attribute__((target_clones("avx512f", "avx2", "default")))
#define CROWD_AVX512 __attribute__((target("avx512f,avx512vl,avx512dq,avx512cd,bmi2,popcnt")))

namespace crowd {

/// @brief Whether this processor runs functions that are CROWD_AVX512. There only where that is defined.
inline bool hasAvx512() {
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
         __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512cd") != 0 &&
         __builtin_cpu_supports("bmi2") != 0 && __builtin_cpu_supports("popcnt") != 0;
}

}  // namespace crowd
#define CROWD_FASTEST(wide, plain) (crowd::hasAvx512() ? (wide) : (plain))
#else
#define CROWD_VECTORISED
#define CROWD_FASTEST(wide, plain) (plain)
#endif
