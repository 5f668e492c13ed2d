#include "common/text/quotes.h"

#include "social_crowd/errors.h"

namespace crowd {
namespace {

constexpr const char* DOTS = "...";

thread_local bool are_quotes_hidden = false;

/// Whether a byte continues a character of UTF-8.
bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  constexpr std::size_t LONGEST_CHARACTER = 4;  // [bytes]
  std::size_t end = most;
  while (end > 0 && end + LONGEST_CHARACTER > most + 1 && continues(text[end])) --end;
  return std::string(text.substr(0, end)) + DOTS;
}

std::string inQuotes(std::string_view text) {
  return "'" + (are_quotes_hidden ? std::string(DOTS) : shortened(text)) + "'";
}

HiddenQuotes::HiddenQuotes() : were_active_(are_quotes_hidden) { are_quotes_hidden = true; }

HiddenQuotes::~HiddenQuotes() { are_quotes_hidden = were_active_; }

bool HiddenQuotes::areActive() { return are_quotes_hidden; }

void requireShort(const std::string& what, std::string_view text, std::size_t most) {
  if (text.size() <= most) return;
  throw InputError(what + ": expected at most " + std::to_string(most) + " characters, got " +
                   std::to_string(text.size()));
}

void requireFew(const std::string& what, std::size_t size, std::size_t most) {
  if (size <= most) return;
  throw InputError(what + ": expected at most " + std::to_string(most) + " entries, got " + std::to_string(size));
}

}  // namespace crowd
