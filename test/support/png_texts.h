#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// PNG files for tests, written without a library and without compression.
namespace crowd::png {

enum ColourType : std::uint8_t { GRAY = 0, RGB = 2, PALETTE = 3, GRAY_ALPHA = 4, RGBA = 6 };

/// Whole numbers of four bytes, the high one first.
inline std::string bigEndian(std::uint32_t value) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> static_cast<unsigned>(shift));
  return text;
}

inline std::uint32_t crcOf(const std::string& text) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char c : text) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

inline std::string chunk(const std::string& type, const std::string& content) {
  return bigEndian(static_cast<std::uint32_t>(content.size())) + type + content + bigEndian(crcOf(type + content));
}

/// A zlib stream of one block that is not compressed (up to 65535 bytes).
inline std::string stored(const std::string& content) {
  const auto size = static_cast<std::uint32_t>(content.size());
  std::uint32_t low = 1;
  std::uint32_t high = 0;
  for (const char c : content) {
    low = (low + static_cast<unsigned char>(c)) % 65521U;
    high = (high + low) % 65521U;
  }
  std::string stream("\x78\x01\x01", 3);
  for (const std::uint32_t value : {size, ~size})
    stream.append({static_cast<char>(value & 0xFFU), static_cast<char>((value >> 8U) & 0xFFU)});
  return stream + content + bigEndian(high << 16U | low);
}

/// A PNG file. @param rows bytes of each row, the top one first @param extra chunks before the pixels
inline std::string file(std::uint32_t width, const std::vector<std::string>& rows, ColourType type, int bit_depth = 8,
                        const std::string& extra = "") {
  const std::string kind = {static_cast<char>(bit_depth), static_cast<char>(type), '\0', '\0', '\0'};
  std::string pixels;
  for (const std::string& row : rows) pixels += '\0' + row;
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", bigEndian(width) + bigEndian(static_cast<std::uint32_t>(rows.size())) + kind) + extra +
         chunk("IDAT", stored(pixels)) + chunk("IEND", "");
}

}  // namespace crowd::png
