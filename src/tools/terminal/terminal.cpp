#include "tools/terminal/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

namespace crowd {

bool isTerminal() { return ::isatty(STDERR_FILENO) == 1; }

TerminalSize terminalSize() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0;  // NOLINT(*-vararg)
  if (!known || size.ws_col == 0 || size.ws_row == 0) return {};
  return {size.ws_col, size.ws_row};
}

std::string LineBlock::toBegin() const {
  return (above_ > 0 ? "\x1b[" + std::to_string(above_) + "A" : std::string()) + "\r";
}

std::string LineBlock::draw(const std::vector<std::string>& lines, int columns) {
  const bool resized = columns_ != 0 && columns != columns_ && above_ > 0;
  std::string text = resized ? "\x1b[H\x1b[J" : toBegin();
  for (std::size_t i = 0; i < lines.size(); ++i) text += (i > 0 ? "\n" : "") + lines[i] + "\x1b[K";
  if (above_ + 1 > lines.size()) text += "\x1b[J";  // lines that are left from before
  above_ = lines.empty() ? 0 : lines.size() - 1;
  columns_ = columns;
  return text;
}

std::string LineBlock::clear() {
  std::string text = toBegin() + (above_ > 0 ? "\x1b[J" : "\x1b[K");
  above_ = 0;
  return text;
}

}  // namespace crowd
