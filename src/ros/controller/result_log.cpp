#include "ros/controller/result_log.h"

#include <ros/console.h>

#include <cmath>
#include <string>

#include "common/text/numbers.h"

namespace crowd {

void ResultLog::add(const EpisodeResult& result, std::uint64_t episode, std::uint64_t instance,
                    const AnswerCollector& answers) {
  metrics_.add(result);
  robots_.add(result);
  Metrics metrics;
  metrics.add(result);
  ROS_INFO(
      "episode %lu (%s, instance %lu): %lu ticks, %zu of %zu agents arrived, %zu in contact, %zu in collision, path "
      "ratio %.3f, "
      "time ratio %.3f, %lu answers missed, %lu dropped",
      static_cast<unsigned long>(episode), result.scenario.c_str(), static_cast<unsigned long>(instance),
      static_cast<unsigned long>(result.ticks), result.arrivedCount(), result.agentCount(), result.touchedCount(),
      result.collidedCount(), metrics.pathRatio(), metrics.timeRatio(),
      static_cast<unsigned long>(answers.missedCount()), static_cast<unsigned long>(answers.droppedCount()));
  RobotSummary robots;
  robots.add(result);
  if (!robots.text().empty()) ROS_INFO("episode %lu, %s", static_cast<unsigned long>(episode), robots.text().c_str());
  for (const RobotResult& robot : result.robots) {
    if (robot.input.navigation == RobotInput().navigation) continue;
    ROS_INFO("episode %lu, robot '%s': navigation: %s", static_cast<unsigned long>(episode), robot.name.c_str(),
             robot.input.navigation.c_str());
  }
  warnOfWays(result, episode, "at its end");
}

void ResultLog::logAll() const {
  if (metrics_.episodes() <= 1) return;
  const double percent = metrics_.successPercent();
  const std::string success = std::isnan(percent) ? "-" : toFixedText(percent, 2);
  ROS_INFO(
      "%lu episodes: success %s %%, contact %.2f %%, collision %.2f %%, clean %.1f %%, path ratio %.3f, time ratio "
      "%.3f",
      static_cast<unsigned long>(metrics_.episodes()), success.c_str(), metrics_.contactPercent(),
      metrics_.collisionPercent(), metrics_.cleanPercent(), metrics_.pathRatio(), metrics_.timeRatio());
  if (!robots_.text().empty()) ROS_INFO("all episodes, %s", robots_.text().c_str());
}

void warnOfWays(const EpisodeResult& result, std::uint64_t episode, const char* when) {
  const std::string warning = result.wayWarning();
  if (warning.empty()) return;
  ROS_WARN("episode %lu (%s), %s: %s", static_cast<unsigned long>(episode), result.scenario.c_str(), when,
           warning.c_str());
}

}  // namespace crowd
