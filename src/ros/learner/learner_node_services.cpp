// The services of a learner but for those of sharing, and its table files.

#include <social_crowd/LoadQTable.h>
#include <social_crowd/SaveQTable.h>
#include <social_crowd/SetLearningParameters.h>
#include <social_crowd/SetMode.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <filesystem>

#include "common/text/quotes.h"
#include "learning/q_table_names.h"
#include "ros/learner/learner_node.h"
#include "ros/messages/agent_list.h"
#include "ros/messages/names.h"
#include "ros/node/console.h"

namespace crowd {
namespace {

std::string visitedRowsOf(const QTable& table) {
  return std::to_string(table.visitedRows()) + " visited rows of " + std::to_string(table.rows());
}

}  // namespace

void LearnerNode::saveAll(bool goes_on) {
  const auto save = [&](const std::string& file, AgentId agent) {
    const TrainedTable table = trained(goes_on ? learner_.tables().toSave(agent) : learner_.tables().of(agent));
    saveQTable(file, table);
    logInfo("saved " + visitedRowsOf(table.table) + " to " + file);
  };
  if (learner_.tables().use() == TableUse::SHARED) return save(save_to_, firstAgent());
  const std::filesystem::path path(save_to_);
  for (const AgentId agent : learner_.servedAgents()) {
    const std::string name = path.stem().string() + "_agent_" + std::to_string(agent) + path.extension().string();
    save((path.parent_path() / name).string(), agent);
  }
}

void LearnerNode::requireServed(AgentId agent) const {
  const std::vector<AgentId> served = learner_.servedAgents();
  if (std::binary_search(served.begin(), served.end(), agent)) return;
  throw InputError("agent " + std::to_string(agent) + " is not served by " + name_ + "; it serves " +
                   (served.empty() ? "no agent yet" : namedAgents(served)));
}

AgentId LearnerNode::meant(AgentId agent) const {
  const std::vector<AgentId> served = learner_.servedAgents();
  const bool one_table = learner_.tables().use() == TableUse::SHARED || served.size() == 1;
  if (agent == 0 && one_table) return firstAgent();
  requireServed(agent);
  return agent;
}

void LearnerNode::advertiseServices() {
  files_.serve<social_crowd::SaveQTable>(names::SAVE_Q_TABLE, [this](const auto& request, auto& response) {
    const std::string file = data_folder_.resolveToWrite(request.file, request.overwrite != 0);
    std::string whose = "the shared table";
    const auto table = loop_.ask<TrainedTable>([&] {
      const bool shared = learner_.tables().use() == TableUse::SHARED;
      const AgentId agent = shared ? firstAgent() : meant(request.agent);
      const bool for_one = !learner_.servesAll() && learner_.servedAgents().size() == 1;
      if (!shared || for_one) whose = "the table of agent " + std::to_string(agent);
      return trained(learner_.tables().toSave(agent));
    });
    saveQTable(file, table);  // in the service thread: the learner continues
    response.message = "saved " + visitedRowsOf(table.table) + " of " + whose + " to " + file;
  });
  files_.serve<social_crowd::LoadQTable>(names::LOAD_Q_TABLE, [this](const auto& request, auto& response) {
    const std::string file = data_folder_.resolveToRead(request.file, findQTable);
    const HiddenQuotes hidden;  // whoever calls may not be allowed to read the file
    // May throw; nothing has been replaced yet.
    const TrainedTable table = loadQTable(file, FileKinds::REGULAR, &learner_.model());
    loop_.ask<void>([&] {
      const TakeReport report = giveTo({}, table.table, TakeMethod::REPLACE);
      learner_.setDecisions(table.decisions);
      publishStatus();
      response.message = "loaded " + visitedRowsOf(table.table) + " from " + file + ": " + report.text();
    });
  });
  services_.serve<std_srvs::Trigger>("reset_traces", [this](const auto& /*request*/, auto& response) {
    loop_.ask<void>([&] { learner_.forgetDecisions(); });
    response.message = "reset the eligibility traces and the last decisions; the Q-table is unchanged";
  });
  services_.serve<social_crowd::SetMode>(names::SET_MODE, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] { use(live_.changed(settings(), {{"mode", request.mode}})); });
    response.message = "now in " + request.mode + " mode";
  });
  services_.serve<social_crowd::SetLearningParameters>(
      names::SET_LEARNING_PARAMETERS, [this](const auto& request, auto& response) {
        loop_.ask<void>([&] {
          const LearningPlan before = learner_.plan();
          use({learner_.mode(), changedPlan(before, request.parameters, "parameters")});
          const std::string changes = differences(before, learner_.plan());
          response.message = (changes.empty() ? "nothing changed" : "changed " + changes) +
                             "; present values: " + toText(learner_.plan());
        });
      });
  reconfigure_.serve(services_, loop_);
  sharing_.serve<social_crowd::ShareQTable>(names::SHARE_Q_TABLE,
                                            [this](const auto& request, auto& response) { share(request, response); });
  taking_.serve<social_crowd::TakeQTable>(names::TAKE_Q_TABLE,
                                          [this](const auto& request, auto& response) { take(request, response); });
}

}  // namespace crowd
