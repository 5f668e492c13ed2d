#include "common/text/numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <locale>
#include <sstream>
#include <system_error>

namespace crowd {

namespace {

template <typename Number>
void appendChars(Number value, std::string& text) {
  std::array<char, 32> buffer;  // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
  const std::to_chars_result written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), written.ptr);
}

}  // namespace

std::uint64_t bitsOf(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

void appendText(std::uint32_t value, std::string& text) { appendChars(value, text); }

#if defined(__cpp_lib_to_chars)

void appendText(double value, std::string& text) { appendChars(value, text); }

std::string toText(double value) {
  std::string text;
  appendText(value, text);
  return text;
}

std::optional<double> toNumber(std::string_view text) {
  // from_chars does not accept a plus sign.
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

#else  // GCC before 11 (Noetic) has no floating-point <charconv>

std::optional<double> toNumber(std::string_view text) {
  if (text == "nan") return std::nan("");
  if (text == "inf") return HUGE_VAL;
  if (text == "-inf") return -HUGE_VAL;
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> std::noskipws >> value) || stream.peek() != std::istringstream::traits_type::eof())
    return std::nullopt;
  return value;
}

std::string toText(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  for (int digits = 1; digits <= 17; ++digits) {
    stream.str({});
    stream.precision(digits);
    stream << value;
    if (toNumber(stream.str()) == value) break;
  }
  return stream.str();
}

void appendText(double value, std::string& text) { text += toText(value); }

#endif

std::string toText(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + toText(value);
  return "[" + text + "]";
}

std::string toFixedText(double value, int decimals, int width) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::fixed << std::setprecision(decimals) << std::setw(width) << value;
  return stream.str();
}

std::string toPaddedText(std::uint64_t value, int width) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::setfill('0') << std::setw(width) << value;
  return stream.str();
}

std::string toHexText(std::uint64_t value) {
  std::string digits(16, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, value >>= 4U) {
    *digit = "0123456789abcdef"[value & 0xFU];
  }
  return digits;
}

}  // namespace crowd
