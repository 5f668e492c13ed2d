#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// The commands of `ros_bench`. Each prints its figures on one line, separated by blanks.
namespace crowd::bench {

/// @brief Walks a scenario without ROS in one thread and prints ticks a second.
/// @param warm_up ticks before those that are timed
void walkHeadless(const std::string& scenario, const std::string& q_table, unsigned max_neighbours, unsigned warm_up,
                  unsigned ticks);

/// @brief Lets a paused crowd_controller walk from the scenario's beginning and prints ticks a second, bytes of
/// perceptions and bytes of actions.
void timeLockstep(unsigned warm_up, unsigned ticks);

/// @brief The other end of roundTrip(): answers every message with one of so many bytes, until it is stopped.
void echo(std::size_t bytes_back);

/// @brief Sends messages of so many bytes to echo(), each when the last was answered; prints round trips a second.
void roundTrip(std::size_t bytes, unsigned warm_up, unsigned trips);

/// @brief Takes in topics of any type and does nothing with them, until it is stopped.
void sink(const std::vector<std::string>& topics);

}  // namespace crowd::bench
