#include "metrics_table.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "common/text/numbers.h"
#include "simulation/evaluation/metrics.h"

namespace crowd {
namespace {

/// A number for the table; "-" if there is nothing to take the mean of, such as without any arrivals.
std::string cell(double value, int decimals) {
  if (std::isnan(value)) return "-";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

}  // namespace

std::string csvRow(const std::string& name, const Metrics& metrics) {
  std::string row = name + "," + std::to_string(metrics.episodes());
  for (const double value : {metrics.successPercent(), metrics.contactPercent(), metrics.collisionPercent(),
                             metrics.cleanPercent(), metrics.pathRatio(), metrics.timeRatio(), metrics.turnPerMetre(),
                             metrics.maxSpeedRatio(), metrics.blockedMovesPerAgent()}) {
    row += "," + toText(value);
  }
  return row + "\n";
}

void printHeader() {
  std::printf("%-18s %9s %8s %8s %10s %7s %6s %6s %6s %6s %7s\n", "scenario", "instances", "success%", "contact%",
              "collision%", "clean%", "path", "time", "rad/m", "speed", "blocked");
}

void printRow(const std::string& name, const Metrics& metrics) {
  std::printf("%-18s %9llu %8s %8.2f %10.2f %7.1f %6s %6s %6s %6.2f %7s\n", name.c_str(),
              static_cast<unsigned long long>(metrics.episodes()), cell(metrics.successPercent(), 2).c_str(),
              metrics.contactPercent(), metrics.collisionPercent(), metrics.cleanPercent(),
              cell(metrics.pathRatio(), 3).c_str(), cell(metrics.timeRatio(), 3).c_str(),
              cell(metrics.turnPerMetre(), 2).c_str(), metrics.maxSpeedRatio(),
              cell(metrics.blockedMovesPerAgent(), 2).c_str());
  std::fflush(stdout);
}

}  // namespace crowd
