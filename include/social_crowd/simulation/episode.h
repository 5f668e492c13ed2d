#pragma once

#include <cstdint>
#include <memory>

#include "social_crowd/common/recycler.h"
#include "social_crowd/learning/learner.h"
#include "social_crowd/simulation/episode_result.h"
#include "social_crowd/simulation/greedy_crowd.h"
#include "social_crowd/world/scene.h"
#include "social_crowd/world/world.h"

namespace crowd {

/// @brief One episode: a world that is walked tick by tick until everybody has arrived or time is up. The same steps
/// serve the headless runs and the ROS node; whoever drives it brings the actions.
class Episode {
 public:
  /// @param number goes into the perceptions; learners draw their exploration from it.
  /// @param workers share out the agents as long as the episode lives; what comes of it does not depend on their number
  Episode(Scene scene, std::uint64_t number, const Vision& vision, Workers& workers = Workers::alone());

  /// @brief What everybody perceives now; `last` once the episode is over.
  const Perceptions& perceptions() { return *perceive(); }
  /// @brief The same to be kept: it stays as it is while somebody holds it.
  std::shared_ptr<const Perceptions> sharedPerceptions() { return perceive(); }
  /// @brief What the learner decides for everybody on perceptions(): the same as Learner::decide(), but in demo mode
  /// sooner (see GreedyCrowd), in another order of agents, and it does not come to know them.
  void decide(Learner& learner, RelativeActions& actions);
  /// @brief Moves everybody for one tick; who has no action stays. @throws InputError, nothing has moved then.
  void step(const std::vector<AgentAction>& actions);
  bool isOver() const;

  std::uint64_t number() const { return number_; }
  const Scene& scene() const { return scene_; }
  const World& world() const { return world_; }
  EpisodeResult result() const { return monitor_.result(); }

  /// @brief Changes the world between two ticks; perceptions() follow. @throws InputError, nothing has changed then.
  AgentId spawnAgent(const AgentStart& start);
  void removeAgent(AgentId id);
  void setGoal(AgentId id, const Vector2& goal);
  std::size_t spawnObstacle(const Vector2& position, const Vector2& velocity, double radius);
  void removeObstacle(std::size_t number);

 private:
  const std::shared_ptr<Perceptions>& perceive();

  Scene scene_;
  World world_;
  Vision vision_;
  Workers* workers_;
  EpisodeMonitor monitor_;
  std::uint64_t number_;
  Recycler<std::shared_ptr<Perceptions>> buffers_;
  std::shared_ptr<Perceptions> perceptions_;  // those of the last time that somebody asked
  bool are_current_ = false;
  GreedyCrowd crowd_;
};

}  // namespace crowd
