#include "progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "social_crowd/common/numbers.h"

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

ProgressBar::ProgressBar(std::string label, std::uint64_t total)
    : label_(std::move(label)),
      total_(total),
      terminal_(::isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      next_(start_ + (terminal_ ? std::chrono::milliseconds(0) : PLAIN_PERIOD)) {}

double ProgressBar::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool ProgressBar::isDue(std::uint64_t done) const {
  return done == total_ || std::chrono::steady_clock::now() >= next_;
}

void ProgressBar::draw(std::uint64_t done, const std::string& note, bool always) {
  if (!always && !isDue(done)) return;
  next_ = std::chrono::steady_clock::now() + (terminal_ ? TERMINAL_PERIOD : PLAIN_PERIOD);
  const double share = total_ == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(total_);
  const double left = share > 0.0 ? seconds() * (1.0 - share) / share : 0.0;
  const std::string text = label_ + " " + barOf(std::min(1.0, share)) + " " + std::to_string(done) + "/" +
                           std::to_string(total_) + "  " + note + "  left " + formatDuration(left);
  // Carriage return, then clear to the end of the line.
  std::cerr << (terminal_ ? "\r" : "") << text << (terminal_ ? "\x1b[K" : "\n") << std::flush;
}

void ProgressBar::finish(std::uint64_t done, const std::string& note) {
  draw(done, note, true);
  if (terminal_) std::cerr << std::endl;
}

void ProgressBar::clear() {
  if (terminal_) std::cerr << "\r\x1b[K" << std::flush;
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
