#include "social_crowd/learner.h"

#include "learning/learner.h"
#include "learning/q_table_file.h"
#include "library/conversions.h"
#include "simulation/evaluation/evaluation.h"

namespace crowd::library {

struct Learner::State {
  crowd::Learner learner;
  crowd::Perceptions perceptions;
  RelativeActions actions;
};

Learner::Learner(const QTable& table, std::uint64_t seed)
    : state_(new State{makeDemoLearner(table.trained(), seed), {}, {}}) {
  state_->learner.setDecisions(table.decisions());
}

Learner::Learner(Learner&&) noexcept = default;
Learner& Learner::operator=(Learner&&) noexcept = default;
Learner::~Learner() = default;

std::vector<Action> Learner::decide(const Perceptions& perceptions) {
  fromPublic(perceptions, state_->perceptions);
  state_->learner.decide(state_->perceptions, state_->actions);
  return toPublic(state_->actions.agents);
}

void Learner::startLearning(double epsilon) {
  LearningParameters parameters = state_->learner.parameters();
  parameters.epsilon = epsilon;
  state_->learner.setPlan({parameters, EpsilonSchedule::constant(epsilon)});
  state_->learner.setMode(Mode::TRAINING);
}

void Learner::stopLearning() { state_->learner.setMode(Mode::DEMO); }

QTable Learner::table() {
  crowd::Learner& learner = state_->learner;
  return QTable(std::make_shared<TrainedTable>(TrainedTable{learner.model(), learner.parameters(), learner.decisions(),
                                                            learner.seed(), learner.tables().toSave(0)}));
}

crowd::Learner& Learner::learner() { return state_->learner; }

}  // namespace crowd::library
