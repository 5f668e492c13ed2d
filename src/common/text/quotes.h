#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Texts of users and files in messages.
namespace crowd {

/// @brief Longest part of such a text that a message contains [bytes].
constexpr std::size_t MAX_QUOTE = 80;

/// @brief Returns the text, of a longer one the first bytes and "...". No character of UTF-8 is cut in two.
std::string shortened(std::string_view text, std::size_t most = MAX_QUOTE);

/// @brief Returns the text, shortened, in quotation marks; while HiddenQuotes lives, only the marks with dots.
std::string inQuotes(std::string_view text);

/// @brief While one lives, inQuotes() in this thread does not tell the text. So messages about a file name the place of
/// the error and what is expected there, but not what the file contains.
class HiddenQuotes {
 public:
  HiddenQuotes();
  ~HiddenQuotes();
  HiddenQuotes(const HiddenQuotes&) = delete;
  HiddenQuotes& operator=(const HiddenQuotes&) = delete;

  /// @brief Whether one lives in this thread.
  static bool areActive();

 private:
  bool were_active_;
};

/// @brief Throws InputError "WHAT: expected at most N characters, got M" if a text of a user is longer than that.
void requireShort(const std::string& what, std::string_view text, std::size_t most = MAX_QUOTE);

/// @brief Throws InputError "WHAT: expected at most N entries, got M" if a list of a user has more.
void requireFew(const std::string& what, std::size_t size, std::size_t most);

}  // namespace crowd
