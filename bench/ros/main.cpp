// Measurements of nodes, and the references they are compared with.

#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "commands.h"

namespace crowd::bench {
namespace {

int runMain(int argc, char** argv) {
  ros::init(argc, argv, "ros_bench", ros::init_options::AnonymousName);  // removes ROS arguments
  CLI::App app("Measures nodes, and what they are compared with.", "ros_bench");
  app.require_subcommand(1);
  std::string scenario;
  std::string q_table;
  std::vector<std::string> topics;
  unsigned max_neighbours = 0;
  unsigned warm_up = 0;
  unsigned count = 1;
  std::size_t bytes = 0;

  CLI::App* const headless = app.add_subcommand("headless", "walk without ROS; ticks/s");
  headless->add_option("scenario", scenario)->required();
  headless->add_option("q_table", q_table)->required();
  headless->add_option("max_neighbours", max_neighbours)->required();
  CLI::App* const lockstep = app.add_subcommand("lockstep", "let a paused crowd_controller walk; ticks/s and bytes");
  CLI::App* const trip = app.add_subcommand("round_trip", "send messages to echo; round trips/s");
  trip->add_option("bytes", bytes)->required();
  for (CLI::App* timed : {headless, lockstep, trip}) {
    timed->add_option("warm_up", warm_up)->required();
    timed->add_option("count", count)->required()->check(CLI::PositiveNumber);
  }
  CLI::App* const answering = app.add_subcommand("echo", "answer round_trip's messages");
  answering->add_option("bytes", bytes)->required();
  CLI::App* const sinking = app.add_subcommand("sink", "take in topics");
  sinking->add_option("topics", topics)->required();
  CLI11_PARSE(app, argc, argv);

  if (headless->parsed()) walkHeadless(scenario, q_table, max_neighbours, warm_up, count);
  if (lockstep->parsed()) timeLockstep(warm_up, count);
  if (trip->parsed()) roundTrip(bytes, warm_up, count);
  if (answering->parsed()) echo(bytes);
  if (sinking->parsed()) sink(topics);
  return 0;
}

}  // namespace
}  // namespace crowd::bench

int main(int argc, char** argv) {
  try {
    return crowd::bench::runMain(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "ros_bench: " << error.what() << std::endl;
    return 1;
  }
}
