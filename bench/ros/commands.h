#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Commands of `ros_bench`. Each prints its results on one line, separated by blanks.
namespace crowd::bench {

/// @brief Runs a scenario without ROS in one thread and prints ticks per second.
/// @param warm_up number of unmeasured ticks before the measurement
void walkHeadless(const std::string& scenario, const std::string& q_table, unsigned max_neighbours, unsigned warm_up,
                  unsigned ticks);

/// @brief Resets a paused crowd_controller, steps it, and prints ticks per second, bytes of perceptions and bytes of
/// actions.
void timeLockstep(unsigned warm_up, unsigned ticks);

/// @brief The other end of roundTrip(): answers each message with one of `bytes_back` bytes, until shutdown.
void echo(std::size_t bytes_back);

/// @brief Sends messages of `bytes` bytes to echo(), each after the answer to the last; prints round trips per second.
void roundTrip(std::size_t bytes, unsigned warm_up, unsigned trips);

/// @brief Subscribes to topics of any type and discards the messages, until shutdown.
void sink(const std::vector<std::string>& topics);

}  // namespace crowd::bench
