#include "simd/kernels.h"

#include <cstdlib>
#include <string>

#include "social_crowd/errors.h"

namespace crowd::simd {

#ifdef CROWD_HIGHWAY
/// Kernels for the vector instruction sets of this processor, fastest first.
std::vector<Kernels> highwayKernels();
#else
static std::vector<Kernels> highwayKernels() { return {}; }
#endif

std::vector<Kernels> availableKernels() {
  std::vector<Kernels> available = highwayKernels();
  available.push_back(REFERENCE);
  return available;
}

Kernels chooseKernels() {
  const std::vector<Kernels> available = availableKernels();
  const char* const wanted = std::getenv("SOCIAL_CROWD_SIMD");
  if (wanted == nullptr) return available.front();
  std::string names;
  for (const Kernels& one : available) {
    if (std::string(one.target) == wanted) return one;
    names += (names.empty() ? "" : ", ") + std::string(one.target);
  }
  throw InputError("SOCIAL_CROWD_SIMD is '" + std::string(wanted) + "', expected one of " + names);
}

const Kernels& kernels() {
  static const Kernels CHOSEN = chooseKernels();
  return CHOSEN;
}

}  // namespace crowd::simd
