#pragma once

#include <memory>

#include "training/communicator.h"

namespace crowd {

/// @brief Joins the other processes of an MPI program: those that mpirun, or another launcher of MPI, started together
/// with this one. A process that was started without such a launcher is alone. MPI ends with the returned object.
/// @throws InputError if the processes were started by such a launcher, but this program was built without MPI
std::unique_ptr<Communicator> joinRanks();

/// @brief Whether the program was built with MPI.
bool isBuiltWithMpi();

}  // namespace crowd
