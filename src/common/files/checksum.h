#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "common/text/numbers.h"

namespace crowd {

/// @brief Incremental 64-bit FNV-1a checksum of a text (Fowler, Noll and Vo).
///
/// The bytes form one dependency chain. Interleaved with other work, add() costs almost no additional time, because the
/// processor executes both in parallel.
class Checksum {
 public:
  void add(std::string_view text) {
    std::uint64_t hash = hash_;
    for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3ULL;
    hash_ = hash;
  }

  /// @brief The checksum as 16 hexadecimal digits.
  std::string text() const { return toHexText(hash_); }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325ULL;
};

}  // namespace crowd
