#include "tools/terminal/progress_bar.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "common/text/numbers.h"

namespace crowd {
namespace {

constexpr std::chrono::milliseconds TERMINAL_PERIOD(100);
constexpr std::chrono::seconds PLAIN_PERIOD(10);
constexpr int WIDTH = 24;

std::string barOf(double share) {
  const auto full = static_cast<std::size_t>(std::lround(share * WIDTH));
  return "[" + std::string(full, '#') + std::string(WIDTH - full, '.') + "]";
}

}  // namespace

ProgressBar::ProgressBar(std::string label, std::uint64_t total, std::uint64_t done_before)
    : label_(std::move(label)),
      total_(total),
      done_before_(done_before),
      terminal_(isTerminal()),
      start_(std::chrono::steady_clock::now()),
      next_(start_ + (terminal_ ? std::chrono::milliseconds(0) : PLAIN_PERIOD)) {}

ProgressBar::~ProgressBar() { endLine(); }

double ProgressBar::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool ProgressBar::isDue(std::uint64_t done) const {
  return done == total_ || std::chrono::steady_clock::now() >= next_;
}

std::string ProgressBar::textOf(std::uint64_t done, const std::string& note) const {
  const double share = total_ == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(total_);
  const auto now = static_cast<double>(done - std::min(done, done_before_));  // done by this run
  const double left = now > 0.0 ? seconds() * static_cast<double>(total_ - std::min(done, total_)) / now : 0.0;
  return label_ + " " + barOf(std::min(1.0, share)) + " " + std::to_string(done) + "/" + std::to_string(total_) +
         "  left " + formatDuration(left) + (note.empty() ? "" : "  " + note);
}

void ProgressBar::draw(std::uint64_t done, const std::string& note, const std::vector<std::string>& above,
                       bool always) {
  if (!always && !isDue(done)) return;
  next_ = std::chrono::steady_clock::now() + (terminal_ ? TERMINAL_PERIOD : PLAIN_PERIOD);
  const std::string text = textOf(done, note);
  if (!terminal_) {
    std::cerr << text << std::endl;
    return;
  }
  const int columns = terminalSize().columns;
  std::vector<std::string> lines = above;
  // A line as long as the terminal is wide would be broken on some terminals.
  lines.push_back(text.substr(0, static_cast<std::size_t>(std::max(1, columns - 1))));
  std::cerr << block_.draw(lines, columns) << std::flush;
  has_line_ = true;
}

void ProgressBar::endLine() {
  if (has_line_) std::cerr << std::endl;
  has_line_ = false;
}

void ProgressBar::finish(std::uint64_t done, const std::string& note, const std::vector<std::string>& above) {
  draw(done, note, above, true);
  endLine();
}

void ProgressBar::clear() {
  if (terminal_) std::cerr << block_.clear() << std::flush;
  has_line_ = false;
}

std::string formatDuration(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::llround(std::max(0.0, seconds)));
  const std::string rest = toPaddedText(whole % 60, 2);
  if (whole < 3600) return std::to_string(whole / 60) + ":" + rest;
  return std::to_string(whole / 3600) + ":" + toPaddedText(whole / 60 % 60, 2) + ":" + rest;
}

std::string formatCount(double count) {
  if (count >= 1e6) return toFixedText(count / 1e6, 2) + " M";
  if (count >= 1e4) return toFixedText(count / 1e3, 1) + " k";
  return toFixedText(count, 0);
}

}  // namespace crowd
