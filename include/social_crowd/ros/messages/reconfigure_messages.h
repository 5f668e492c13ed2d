#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <string>
#include <vector>

#include "social_crowd/ros/controller/live_parameters.h"

// Messages of dynamic_reconfigure, in the form that its clients expect: one group with the number 0.
namespace crowd {

/// @brief Writes the values of all parameters.
dynamic_reconfigure::Config toMessage(const std::vector<LiveDescription>& parameters, const LiveValues& values);

/// @brief Describes all parameters. @param defaults their types are those of the parameters
dynamic_reconfigure::ConfigDescription toDescription(const std::vector<LiveDescription>& parameters,
                                                     const LiveValues& defaults);

/// @brief Replaces the values that a request contains; a whole number stands for any number.
/// @throws InputError that lists unknown parameters and invalid values; `values` has not changed then
void takeRequest(const dynamic_reconfigure::Config& request, const std::vector<LiveDescription>& parameters,
                 LiveValues& values);

}  // namespace crowd
