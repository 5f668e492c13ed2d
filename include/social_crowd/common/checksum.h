#pragma once

#include <cstdint>
#include <string>
#include <string_view>

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
  std::string text() const {
    std::string digits(16, '0');
    std::uint64_t left = hash_;
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, left >>= 4U) {
      *digit = "0123456789abcdef"[left & 0xFU];
    }
    return digits;
  }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325ULL;
};

}  // namespace crowd
