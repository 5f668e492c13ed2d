#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief The positions of people in a file.
struct Recording {
  struct Sample {
    std::uint64_t frame = 0;
    Vector2 place = Vector2::Zero();  ///< [m]
  };
  std::map<std::uint64_t, std::vector<Sample>> walks;  ///< by the number of the person; frames ascend
  std::optional<double> frame_duration;                ///< [s]; absent if the file does not contain it
};

/// @brief Reads a recording: the CSV of `evaluate --trajectories`, JuPedSim's text format, or obsmat.txt of the ETH and
/// UCY data sets, whose annotated frames are counted from 0. The first line tells which. Rows may have any order.
/// @param instance which episode of a CSV file; absent: the first
/// @throws FileError; InputError "FILE:LINE: ..." if the file is no recording, a line is wrong, or a person is twice in
/// a frame
Recording readRecording(const std::string& file, std::optional<std::uint64_t> instance);

}  // namespace crowd
