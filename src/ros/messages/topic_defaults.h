#pragma once

#include <ros/duration.h>

#include <cstdint>

namespace crowd {

constexpr std::uint32_t QUEUE = 100;        ///< length of the queues of topics [messages]
constexpr std::uint32_t SHORT_QUEUE = 10;   ///< where only the newest messages are of use [messages]
constexpr std::uint32_t LONG_QUEUE = 1000;  ///< where many learners may publish at the same time [messages]
constexpr bool LATCHED = true;              ///< the last message is also sent to subscribers that come later

const ros::WallDuration IDLE(0.1);  ///< between two checks for shutdown

}  // namespace crowd
