// The tables of a learner, and how they change when a table is given to it.

#include <gtest/gtest.h>

#include <cstdlib>

#include "learning/learner.h"
#include "support/error_of.h"
#include "support/learners.h"

namespace crowd::learner_tables_test {
namespace {

using learners::decide;
using learners::emptyTable;
using learners::goalIn;
using learners::model;
using learners::options;
using learners::randomTable;

/// Empty but for row 0, action 0.
QTable tableWith(double value, std::uint32_t visits) {
  QTable table = emptyTable();
  table.set(0, 0, value, visits);
  return table;
}

/// Lets each of the agents 0, 1, ... decide once in row 0 and gain the given distances [m].
void walk(Learner& learner, const std::vector<double>& gained, std::uint64_t episode = 0) {
  PerceptionsBuilder before(episode, 0);
  PerceptionsBuilder after(episode, 1);
  for (AgentId agent = 0; agent < gained.size(); ++agent) {
    before.agent(agent, goalIn(0, 32.0));
    after.agent(agent, goalIn(1, 32.0 - gained[agent]));
  }
  decide(learner, before);
  decide(learner, after.last());
}

double valueOf(const Learner& learner, AgentId agent) { return learner.tables().of(agent).value(0, 0); }
std::uint32_t visitsOf(const Learner& learner, AgentId agent) { return learner.tables().of(agent).visits(0, 0); }

TEST(SharedTable, LearnsFromAllAgents) {
  Learner learner(model(), options(Mode::TRAINING), tableWith(0.0, 0));
  EXPECT_EQ(learner.tables().use(), TableUse::SHARED);
  walk(learner, {8.0, 2.0});
  for (const AgentId agent : {0U, 1U, 99U}) {
    EXPECT_EQ(valueOf(learner, agent), 3.0);  // half of 8, then half of the way from 4 to 2
    EXPECT_EQ(visitsOf(learner, agent), 2U);
  }
}

TEST(OwnTables, LearnOnlyFromTheirAgent) {
  Learner learner(model(), options(Mode::TRAINING, TableUse::OWN), tableWith(2.0, 5));
  EXPECT_EQ(learner.tables().use(), TableUse::OWN);
  walk(learner, {8.0, 4.0});
  EXPECT_EQ(learner.tables().of(0), tableWith(5.0, 6));   // half of the way from 2 to 8
  EXPECT_EQ(learner.tables().of(1), tableWith(3.0, 6));   // to 4
  EXPECT_EQ(learner.tables().of(99), tableWith(2.0, 5));  // new agents begin with the given table
  walk(learner, {8.0, 4.0, 0.0}, 1);
  EXPECT_EQ(learner.tables().of(0), tableWith(6.5, 7));
  EXPECT_EQ(learner.tables().of(1), tableWith(3.5, 7));
  EXPECT_EQ(learner.tables().of(2), tableWith(1.0, 6));
}

TEST(OwnTables, AreTheGivenTableInDemoMode) {
  Learner learner(model(), options(Mode::DEMO, TableUse::OWN), tableWith(2.0, 5));
  walk(learner, {8.0, 4.0});
  EXPECT_EQ(&learner.tables().of(0), &learner.tables().of(1));  // no unnecessary copies
  EXPECT_EQ(learner.tables().of(0), tableWith(2.0, 5));
}

TEST(TakeTable, ReplacesTheSharedTable) {
  Learner learner(model(), options(Mode::TRAINING));
  walk(learner, {8.0, 8.0});
  const QTable given = randomTable(1);
  learner.tables().take(given, TakeMethod::REPLACE);
  for (const AgentId agent : {0U, 1U, 99U}) EXPECT_EQ(learner.tables().of(agent), given);
  walk(learner, {0.0}, 1);  // continues in the new table, which belongs to the learner
  EXPECT_NE(learner.tables().of(0), given);
  EXPECT_EQ(learner.tables().of(1), learner.tables().of(0));
  EXPECT_EQ(given, randomTable(1));
}

TEST(TakeTable, MergesIntoTheSharedTable) {
  Learner learner(model(), options(Mode::TRAINING), tableWith(2.0, 3));
  walk(learner, {});
  learner.tables().take(tableWith(6.0, 1), TakeMethod::MERGE);
  EXPECT_EQ(learner.tables().of(0), tableWith(3.0, 4));  // (3 * 2 + 1 * 6) / 4
}

TEST(TakeTable, ForOneAgentChangesASharedTableForAll) {
  Learner learner(model(), options(Mode::TRAINING), tableWith(2.0, 3));
  walk(learner, {2.0, 2.0});  // two visits more, at 2
  learner.tables().take(1, tableWith(6.0, 5), TakeMethod::MERGE);
  for (const AgentId agent : {0U, 1U, 99U}) EXPECT_EQ(learner.tables().of(agent), tableWith(4.0, 10));
  learner.tables().take(1, tableWith(7.0, 1), TakeMethod::REPLACE);
  for (const AgentId agent : {0U, 1U, 99U}) EXPECT_EQ(learner.tables().of(agent), tableWith(7.0, 1));
}

TEST(TakeTable, ReplacesAllOwnTablesAndTheInitialTable) {
  Learner learner(model(), options(Mode::TRAINING, TableUse::OWN));
  walk(learner, {8.0, 4.0});
  learner.tables().take(tableWith(2.0, 1), TakeMethod::REPLACE);
  for (const AgentId agent : {0U, 1U, 99U}) EXPECT_EQ(learner.tables().of(agent), tableWith(2.0, 1));
  walk(learner, {8.0, 4.0}, 1);  // and they diverge again
  EXPECT_EQ(learner.tables().of(0), tableWith(5.0, 2));
  EXPECT_EQ(learner.tables().of(1), tableWith(3.0, 2));
  EXPECT_EQ(learner.tables().of(99), tableWith(2.0, 1));
}

TEST(TakeTable, MergesIntoEachOwnTable) {
  Learner learner(model(), options(Mode::TRAINING, TableUse::OWN));
  walk(learner, {8.0, 4.0});  // values 4 and 2, one visit each
  learner.tables().take(tableWith(8.0, 3), TakeMethod::MERGE);
  EXPECT_EQ(learner.tables().of(0), tableWith(7.0, 4));   // (4 + 3 * 8) / 4
  EXPECT_EQ(learner.tables().of(1), tableWith(6.5, 4));   // (2 + 3 * 8) / 4
  EXPECT_EQ(learner.tables().of(99), tableWith(8.0, 3));  // new agents had no experience
}

TEST(TakeTable, ForOneAgentKeepsOtherOwnTables) {
  Learner learner(model(), options(Mode::TRAINING, TableUse::OWN), tableWith(2.0, 1));
  walk(learner, {2.0, 2.0});  // value 2 stays, two visits
  learner.tables().take(0, tableWith(5.0, 1), TakeMethod::REPLACE);
  learner.tables().take(7, tableWith(4.0, 3), TakeMethod::MERGE);  // unknown agent: merged with its initial table
  EXPECT_EQ(learner.tables().of(0), tableWith(5.0, 1));
  EXPECT_EQ(learner.tables().of(1), tableWith(2.0, 2));
  EXPECT_EQ(learner.tables().of(7), tableWith(3.5, 4));  // (2 + 3 * 4) / 4
  EXPECT_EQ(learner.tables().of(99), tableWith(2.0, 1));
  walk(learner, {5.0, 2.0}, 1);
  EXPECT_EQ(visitsOf(learner, 0), 2U);
  EXPECT_EQ(visitsOf(learner, 1), 3U);
}

TEST(TakeTable, SharesTheTableOfOneAgentWithAll) {
  Learner learner(model(), options(Mode::TRAINING, TableUse::OWN));
  walk(learner, {8.0, 4.0, 2.0});  // values 4, 2, 1
  learner.tables().take(learner.tables().toShare(0), TakeMethod::MERGE);
  EXPECT_EQ(learner.tables().of(0), tableWith(4.0, 1));  // which it knows already
  EXPECT_EQ(learner.tables().of(1), tableWith(3.0, 2));
  EXPECT_EQ(learner.tables().of(2), tableWith(2.5, 2));
  EXPECT_EQ(learner.tables().of(99), tableWith(4.0, 1));
  learner.tables().take(learner.tables().toShare(2), TakeMethod::REPLACE);
  for (const AgentId agent : {0U, 1U, 2U, 99U}) EXPECT_EQ(learner.tables().of(agent), tableWith(2.5, 2));
}

TEST(TakeTable, ReturnsTheNumberOfNewVisits) {
  Learner learner(model(), options(Mode::TRAINING, TableUse::OWN), tableWith(2.0, 5));
  walk(learner, {2.0, 2.0});
  walk(learner, {2.0}, 1);  // agent 0 has 7 visits, agent 1 has 6
  const AgentTables::TakenByAll all = learner.tables().take(learner.tables().toShare(0), TakeMethod::MERGE);
  EXPECT_EQ(all.newcomers.new_visits, 2U);
  EXPECT_EQ(all.newcomers.visits, 7U);
  EXPECT_EQ(all.by_agent.at(0).new_visits, 0U);
  EXPECT_EQ(all.by_agent.at(0).visits, 7U);
  EXPECT_EQ(all.by_agent.at(1).new_visits, 2U);
  EXPECT_EQ(all.by_agent.at(1).visits, 8U);
  const AgentTables::Taken one = learner.tables().take(0, learner.tables().toShare(1), TakeMethod::REPLACE);
  EXPECT_EQ(one.new_visits, 1U);
  EXPECT_EQ(one.visits, 8U);
}

TEST(TakeTable, RepeatedMergesOfAReplacedTableChangeNothing) {
  for (const TableUse tables : {TableUse::SHARED, TableUse::OWN}) {
    Learner giver(model(), options(Mode::TRAINING, tables), randomTable(1));
    Learner taker(model(), options(Mode::TRAINING, tables), tableWith(6.0, 4));
    walk(giver, {8.0});
    walk(taker, {4.0});
    taker.tables().take(0, giver.tables().toShare(0), TakeMethod::REPLACE);
    const QTable given = giver.tables().of(0);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(taker.tables().take(0, giver.tables().toShare(0), TakeMethod::MERGE).new_visits, 0U);
      EXPECT_EQ(giver.tables().take(0, taker.tables().toShare(0), TakeMethod::MERGE).new_visits, 0U);
    }
    EXPECT_EQ(taker.tables().of(0), given);
    EXPECT_EQ(giver.tables().of(0), given);
  }
}

TEST(TakeTable, MergesASavedStateOfTheSameTableOnce) {
  Learner learner(model(), options(Mode::TRAINING));
  walk(learner, {8.0});
  const QTable saved = learner.tables().toSave(0);
  walk(learner, {8.0}, 1);
  Learner other(model(), options(Mode::TRAINING), saved);
  other.tables().take(learner.tables().toShare(0), TakeMethod::MERGE);
  EXPECT_EQ(other.tables().of(0), learner.tables().of(0));
  EXPECT_EQ(learner.tables().take(saved, TakeMethod::MERGE).newcomers.new_visits, 0U);
}

TEST(Restart, GivesATableToOneAgent) {
  Learner learner(model(), options(Mode::TRAINING, TableUse::OWN), tableWith(2.0, 5));
  learner.tables().restart(7, tableWith(3.0, 6));
  EXPECT_EQ(learner.servedAgents(), std::vector<AgentId>{7});
  EXPECT_EQ(learner.tables().of(7), tableWith(3.0, 6));
  EXPECT_EQ(learner.tables().of(0), tableWith(2.0, 5));
  EXPECT_EQ(learner.tables().base(), tableWith(2.0, 5));
  EXPECT_FALSE(learner.tables().of(7).isNamed());
  Learner shared(model(), options(Mode::TRAINING), tableWith(2.0, 5));
  shared.tables().restart(7, tableWith(3.0, 6));
  EXPECT_EQ(shared.tables().base(), tableWith(3.0, 6));
  EXPECT_THROW(shared.tables().restart(7, QTable(1, 1)), ShapeError);
}

TEST(TakeTable, RefusesAnotherShapeAndKeepsAllTables) {
  for (const TableUse tables : {TableUse::SHARED, TableUse::OWN}) {
    Learner learner(model(), options(Mode::TRAINING, tables));
    walk(learner, {8.0, 8.0});
    const QTable before = learner.tables().of(0);
    const QTable newcomers = learner.tables().of(99);
    for (const TakeMethod method : {TakeMethod::REPLACE, TakeMethod::MERGE}) {
      for (const QTable& wrong : {QTable(69, 7), QTable(68, 8), QTable(8, 69)}) {
        const std::string message = errorOf<ShapeError>([&] { learner.tables().take(wrong, method); });
        EXPECT_TRUE(contains(message, "69 rows and 8 actions")) << message;
        EXPECT_THROW(learner.tables().take(1, wrong, method), ShapeError);
      }
    }
    EXPECT_EQ(learner.tables().of(0), before);
    EXPECT_EQ(learner.tables().of(1), before);
    EXPECT_EQ(learner.tables().of(99), newcomers);
  }
}

/// Ends the process, with status 0 if a table can be given to an agent of that id.
[[noreturn]] void giveTableTo(AgentId agent) {
  Learner learner(model(), options(Mode::TRAINING, TableUse::OWN));
  learner.tables().take(agent, tableWith(5.0, 1), TakeMethod::REPLACE);
  std::exit(learner.tables().of(agent) == tableWith(5.0, 1) && learner.tables().of(0) == emptyTable() ? 0 : 1);
}

TEST(TakeTableDeathTest, AcceptsAnyAgentId) {
  for (const AgentId agent : {UINT32_MAX, UINT32_MAX - 1}) {
    EXPECT_EXIT(giveTableTo(agent), testing::ExitedWithCode(0), "") << agent;
  }
}

}  // namespace
}  // namespace crowd::learner_tables_test
