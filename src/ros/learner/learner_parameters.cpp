#include "ros/learner/learner_parameters.h"

#include <filesystem>

#include "common/files/files.h"
#include "learning/q_table_names.h"
#include "training/training_config.h"

namespace crowd {
namespace {

/// Removes the name from a problem "NAME: expected ...", because parameters have other names.
std::string withoutName(const std::string& problem) { return problem.substr(problem.find(": ") + 2); }

/// Reads a parameter whose value is one of a few names.
template <typename Enum, std::size_t COUNT>
Enum readNamed(Parameters& parameters, const std::string& name, Enum otherwise, const EnumNames<Enum, COUNT>& names) {
  try {
    return names.parse(parameters.text(name, names.nameOf(otherwise), names.listed()));
  } catch (const InputError& error) {
    parameters.complain(name, withoutName(error.what()));
    return otherwise;
  }
}

/// Reads the file in a parameter; nullopt if the parameter is not set, or the file cannot be read (then noted).
template <typename Content>
std::optional<Content> readFileOf(Parameters& parameters, const std::string& name,
                                  Content (*read)(const std::string&)) {
  const std::string file = parameters.text(name, "");
  if (file.empty()) return std::nullopt;
  try {
    return read(file);
  } catch (const Error& error) {
    parameters.complain(name, error.what());
    return std::nullopt;
  }
}

/// Reads ~epsilon, a number or a schedule, if it is set.
void readEpsilon(Parameters& parameters, LearningPlan& plan) {
  const std::optional<std::string> schedule = parameters.map("epsilon");
  LearningParameters& changed = plan.parameters;
  if (!schedule) {
    changed.epsilon = parameters.number("epsilon", changed.epsilon, LearningParameters::FRACTION,
                                        " or a schedule {from, to, episodes, shape}");
    if (parameters.isSet("epsilon")) plan.epsilon = EpsilonSchedule::constant(changed.epsilon);
    return;
  }
  try {
    plan.epsilon = parseEpsilon(*schedule, "epsilon");
    changed.epsilon = plan.epsilon.at(0);
  } catch (const InputError& error) {
    parameters.complain("epsilon", withoutName(error.what()));
  }
}

void readLearningParameters(Parameters& parameters, LearningPlan& plan) {
  const auto override_with = [&](const char* name, double LearningParameters::*member, const NumberRange& range) {
    plan.parameters.*member = parameters.number(name, plan.parameters.*member, range);
  };
  override_with("alpha", &LearningParameters::alpha, LearningParameters::ALPHA);
  override_with("gamma", &LearningParameters::gamma, LearningParameters::GAMMA);
  override_with("lambda", &LearningParameters::lambda, LearningParameters::FRACTION);
  readEpsilon(parameters, plan);
}

/// Returns ~save_to as an absolute path. It is checked now, so that an error is reported before the training.
std::string readSaveTo(Parameters& parameters) {
  const std::string given = parameters.text("save_to", "");
  if (given.empty()) return {};
  std::string file = std::filesystem::absolute(given).lexically_normal().string();
  try {
    requireReplaceable(file);
  } catch (const FileError& error) {
    parameters.complain("save_to", error.what());
  }
  return file;
}

void readAgents(Parameters& parameters, std::set<AgentId>& agents) {
  for (const std::int64_t agent : parameters.wholes("agents")) {
    const bool added = agents.insert(static_cast<AgentId>(agent)).second;
    if (!added) parameters.complain("agents", "agent " + std::to_string(agent) + " is listed twice");
  }
}

/// Reads ~share and ~shares, which exclude ~agents.
void readShare(Parameters& parameters, Learner::Options& options) {
  const std::int64_t count = parameters.whole("shares", options.share.count, 1, MAX_WHOLE);
  const std::int64_t index = parameters.whole("share", options.share.index, 0, MAX_WHOLE);
  if (index >= count) {
    parameters.complain("share",
                        "expected a number below ~shares, " + std::to_string(count) + ", got " + std::to_string(index));
  }
  if (count > 1 && !options.agents.empty()) {
    parameters.complain("shares", "expected 1, because ~agents lists the agents, got " + std::to_string(count));
  }
  options.share = {static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(count)};
}

/// Loads a Q-table file, or a table of this package by its name.
TrainedTable loadFoundQTable(const std::string& name_or_file) { return loadQTable(findQTable(name_or_file)); }

TrainingConfig readConfig(const std::string& file) { return readTrainingConfig(file); }

/// Checks that the model is defined, by a table, a configuration or both.
void checkSources(Parameters& parameters, const std::optional<TrainingConfig>& config,
                  const std::optional<TrainedTable>& table, Mode mode) {
  const bool tried_table = !parameters.text("q_table", "").empty();
  const bool tried_config = !parameters.text("config", "").empty();
  if (mode == Mode::DEMO && !tried_table) {
    parameters.complainMissing("q_table", "expected a Q-table file or name in demo mode, got nothing");
  }
  if (mode == Mode::TRAINING && !tried_table && !tried_config) {
    parameters.complainMissing("config", "expected a training configuration or ~q_table in training mode, got neither");
  }
  if (!config || !table) return;
  try {
    requireFit(config->model, table->model, parameters.text("q_table", ""));
  } catch (const ShapeError& error) {
    parameters.complain("q_table", error.what());
  }
}

std::vector<std::string> findWarnings(Mode mode, const std::optional<TrainingConfig>& config,
                                      const std::string& save_to) {
  std::vector<std::string> warnings;
  if (mode == Mode::TRAINING && save_to.empty()) {
    warnings.emplace_back(
        "what is learned will not be saved: ~save_to is not set (argument save_to of demo.launch); the service "
        "~save_q_table saves it at any time");
  }
  if (mode == Mode::TRAINING && config && config->training.side_by_side > 1) {
    warnings.push_back(
        "the configuration requests " + std::to_string(config->training.side_by_side) +
        " learners side by side; through ROS a single one learns, so the table will differ from that of 'train'");
  }
  return warnings;
}

}  // namespace

LearnerParameters readLearnerParameters(const ros::NodeHandle& private_node) {
  Parameters parameters(private_node);
  Learner::Options options;
  options.mode = readNamed(parameters, "mode", options.mode, MODES);
  const TakeMethod on_share = readNamed(parameters, "on_share", TakeMethod::REPLACE, TAKE_METHODS);
  readAgents(parameters, options.agents);
  readShare(parameters, options);
  const auto config = readFileOf(parameters, "config", readConfig);
  const auto table = readFileOf(parameters, "q_table", loadFoundQTable);
  checkSources(parameters, config, table, options.mode);
  const TrainingPlan training = config ? config->training : TrainingPlan();
  options.tables = readNamed(parameters, "tables", training.tables, TABLE_USES);
  if (table) options.plan = {table->parameters, EpsilonSchedule::constant(table->parameters.epsilon)};
  if (config) options.plan = config->learning;
  readLearningParameters(parameters, options.plan);
  const auto seed = static_cast<std::int64_t>(training.seed);
  options.seed = static_cast<std::uint64_t>(parameters.whole("seed", seed, 0, MAX_WHOLE));
  const std::string save_to = readSaveTo(parameters);
  const auto planned = static_cast<std::int64_t>(training.save_every);
  const auto save_every = static_cast<std::uint64_t>(parameters.whole("save_every", planned, 0, MAX_WHOLE));
  if (save_every > 0 && save_to.empty() && parameters.isSet("save_every")) {
    parameters.complain("save_every", "needs ~save_to, the file to write");
  }
  const DataFolder data_folder = readDataFolder(parameters);
  const double diagnostic_period = readDiagnosticPeriod(parameters);
  const unsigned threads = readThreads(parameters);
  parameters.finish();

  const Model model = config ? config->model : table->model;
  const std::uint64_t decisions = table ? table->decisions : 0;
  QTable values = table ? table->table : QTable(model.state_set->rowCount(), model.action_set->size());
  return {options,
          {model, options.plan.parameters, decisions, options.seed, std::move(values)},
          on_share,
          save_to,
          data_folder,
          save_to.empty() ? 0 : save_every,
          diagnostic_period,
          threads,
          findWarnings(options.mode, config, save_to)};
}

}  // namespace crowd
