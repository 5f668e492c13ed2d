#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace crowd {

/// @brief Size of a terminal in characters.
struct TerminalSize {
  int columns = 80;
  int rows = 24;
};

/// @brief Whether standard error is a terminal.
bool isTerminal();

/// @brief Size of the terminal on standard error; 80 x 24 if it is unknown.
TerminalSize terminalSize();

/// @brief Lines at the bottom of a terminal that are drawn again and again at the same place. Writes nothing itself:
/// its functions return what to write.
class LineBlock {
 public:
  /// @brief Returns the text that draws these lines in place of those before. The cursor stays at the end of the last
  /// line. @param columns width of the terminal; if it has changed, lines may have been broken: the screen is cleared
  std::string draw(const std::vector<std::string>& lines, int columns);
  /// @brief Returns the text that removes the lines.
  std::string clear();

 private:
  /// The text that moves the cursor to the beginning of the block.
  std::string toBegin() const;

  std::size_t above_ = 0;  // lines above that of the cursor
  int columns_ = 0;
};

}  // namespace crowd
