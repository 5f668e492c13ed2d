#include "robot_means.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "common/text/numbers.h"

namespace crowd {
namespace {

constexpr std::size_t NAME_WIDTH = 33;  // of the longest name, and a space
constexpr int DECIMALS = 3;

std::string spreadText(const std::vector<double>& values) {
  const auto all = Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  const double squares = (all - all.mean()).square().sum();
  const double deviation = values.size() > 1 ? std::sqrt(squares / static_cast<double>(values.size() - 1)) : 0.0;
  return toFixedText(all.mean(), DECIMALS) + " ± " + toFixedText(deviation, DECIMALS) + " (" +
         toFixedText(all.minCoeff(), DECIMALS) + " to " + toFixedText(all.maxCoeff(), DECIMALS) + ")";
}

}  // namespace

std::string measureLine(const std::string& name, const std::string& value, const std::string& unit) {
  const std::size_t gap = NAME_WIDTH - std::min(NAME_WIDTH - 1, name.size());
  return "  " + name + std::string(gap, ' ') + value + (unit.empty() ? "" : " " + unit) + "\n";
}

void RobotMeans::add(const RobotResult& robot) {
  std::size_t place = 0;
  RobotResult::visitMeasures(
      [&](const MetricName& metric, const auto& value) {
        if (place == measures_.size()) measures_.push_back({metric.name, metric.unit, {}});
        const auto number = static_cast<double>(value);
        if (!std::isnan(number)) measures_[place].values.push_back(number);
        ++place;
      },
      robot);
  ++robots_;
}

std::string RobotMeans::text() const {
  if (robots_ < 2) return "";
  std::string text = "mean ± standard deviation (least to greatest) of " + std::to_string(robots_) + " results\n";
  for (const Measure& measure : measures_) {
    const std::size_t count = measure.values.size();
    if (count == 0) continue;
    const std::string missing = static_cast<int>(count) < robots_ ? " of " + std::to_string(count) : "";
    text += measureLine(measure.name, spreadText(measure.values) + missing, measure.unit);
  }
  return text;
}

}  // namespace crowd
