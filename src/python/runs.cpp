// Evaluations and trainings.

#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "python/bindings.h"
#include "python/results.h"
#include "social_crowd/evaluation.h"
#include "social_crowd/training.h"

namespace crowd::python {
namespace {

using library::QTable;
using library::Training;

/// Runs long work in another thread, so that Ctrl-C ends it. @param stop set to end the work early
template <typename Work>
void runInterruptibly(std::atomic<bool>& stop, const Work& work) {
  constexpr std::chrono::milliseconds PATIENCE(50);
  bool interrupted = false;
  {
    const py::gil_scoped_release released;
    std::future<void> done = std::async(std::launch::async, work);
    while (!interrupted && done.wait_for(PATIENCE) == std::future_status::timeout) {
      const py::gil_scoped_acquire acquired;
      interrupted = PyErr_CheckSignals() != 0;
    }
    stop = interrupted;
    if (!interrupted) {
      done.get();
    } else {
      done.wait();
    }
  }
  if (interrupted) throw py::error_already_set();
}

py::tuple evaluate(const QTable& table, const library::Scenario& scenario, std::uint64_t episodes, std::uint64_t seed,
                   unsigned threads, const std::string& robot) {
  std::vector<library::EpisodeResult> results;
  library::Means means;
  std::atomic<bool> stop{false};
  library::EvaluationOptions options;
  options.episodes = episodes;
  options.seed = seed;
  options.threads = threads;
  options.robot_controller = robot;
  options.on_episode = [&](const library::EpisodeResult& result) {
    results.push_back(result);
    results.back().agents.clear();
    return !stop;
  };
  runInterruptibly(stop, [&] { means = library::evaluate(table, scenario, options); });
  py::list all;
  for (const library::EpisodeResult& result : results) all.append(toDict(result));
  return py::make_tuple(toDict(means), all);
}

py::list runNextTurn(Training& training) {
  std::vector<library::LearnedEpisode> episodes;
  {
    const py::gil_scoped_release released;
    episodes = training.runNextTurn();
  }
  py::list all;
  for (const library::LearnedEpisode& learned : episodes) {
    py::dict fields = toDict(static_cast<const library::EpisodeResult&>(learned));
    fields["decisions"] = learned.decisions;
    fields["reward"] = learned.reward;
    fields["epsilon"] = learned.epsilon;
    all.append(fields);
  }
  return all;
}

}  // namespace

void bindRuns(py::module_& module) {
  module.def("evaluate", &evaluate, py::arg("table"), py::arg("scenario"), py::arg("episodes"), py::arg("seed"),
             py::arg("threads"), py::arg("robot"), "Returns means, and results of all episodes.");
  py::class_<Training>(module, "Training", "A training, turn by turn.")
      .def(py::init([](const std::string& config, std::optional<std::uint64_t> episodes,
                       std::optional<std::uint64_t> seed, std::optional<QTable> begin, unsigned threads) {
             return Training(config, {episodes, seed, std::move(begin), threads});
           }),
           py::arg("config"), py::arg("episodes"), py::arg("seed"), py::arg("begin"), py::arg("threads"))
      .def("run_next_turn", &runNextTurn, "Runs the episodes of a turn, and learns from them. Returns them.")
      .def_property_readonly("is_done", &Training::isDone)
      .def_property_readonly("episode", &Training::episode, "Number of episodes so far.")
      .def_property_readonly("episodes", &Training::episodes, "Number of episodes of the whole training.")
      .def_property_readonly("decisions", &Training::decisions)
      .def("table", &Training::table, "A copy of what was learned so far.")
      .def("save_checkpoint", &Training::saveCheckpoint, py::arg("file"))
      .def("resume", &Training::resume, py::arg("file"));
}

}  // namespace crowd::python
