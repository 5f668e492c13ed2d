#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ranks/border_exchange.h"
#include "ranks/floor_strips.h"
#include "ranks/ranks_report.h"
#include "scenario/scene.h"
#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "training/communicator.h"

namespace crowd {

/// @brief Whether a DistributedCrowd can walk a scene: without the order `sequential`, robots, routes, sources, sinks,
/// queues, gates, reaction times, and ways round walls or obstacles.
bool isDivisible(const Scene& scene);

/// @brief One crowd, in demo mode, on all ranks of a Communicator: the trajectories and results are those of one
/// Episode, bit for bit, however many ranks there are.
///
/// Each rank owns the agents of a strip of the floor and has copies of the agents around it, in an Episode of its own.
/// In a tick it decides for its own agents, receives the actions of the copies from their owners and moves all of them.
/// Every few ticks the strips are divided anew, each agent is handed over to the owner of the strip that it is in, and
/// copies are made of all agents that an own agent can perceive or touch before the next division. See docs/mpi.md.
///
/// Call contract: step() until it returns false, then result(). All public functions but tick() are collective.
class DistributedCrowd final : private Decider {
 public:
  struct Options {
    std::uint64_t regroup_ticks = 10;  ///< ticks between two divisions of the floor; results do not depend on it
  };

  /// @param scene the whole scene, the same on all ranks, for which isDivisible()
  /// @param learner in demo mode, serves all agents; it, thread_pool and communicator must outlive the crowd
  DistributedCrowd(const Scene& scene, std::uint64_t episode, Learner& learner, ThreadPool& thread_pool,
                   Communicator& communicator, const Options& options);
  DistributedCrowd(const Scene& scene, std::uint64_t episode, Learner& learner, ThreadPool& thread_pool,
                   Communicator& communicator)
      : DistributedCrowd(scene, episode, learner, thread_pool, communicator, Options()) {}

  /// @brief One tick. @param stop whether this rank wants the episode to end now
  /// @return false: the episode is over, or a rank wanted it to end, and nothing has changed
  bool step(bool stop = false);
  /// @brief Whether a rank wanted the episode to end.
  bool wasStopped() const { return was_stopped_; }
  std::uint64_t tick() const { return world().tick(); }
  std::uint64_t maxTicks() const { return max_ticks_; }
  /// @brief On rank 0, appends the rows of the present tick (trajectory.h).
  void appendTrajectoryRows(std::string& rows);
  /// @brief The result, on rank 0; empty on others.
  EpisodeResult result();
  RanksReport report();

 private:
  using Track = EpisodeMonitor::Track;
  /// An agent on its way from one rank to another.
  struct Traveller {
    Agent agent;
    Track track;
  };
  /// How far agents have an effect [m].
  struct Reach {
    explicit Reach(const Scene& scene, const Vision& vision, double ticks);
    double copies = 0.0;    // copies are of agents within this distance of the strip
    double touching = 0.0;  // copies that own agents may touch are within this distance
  };
  struct Finished {
    AgentId id = 0;
    AgentResult result;
  };

  /// The part of a scene that a rank begins with, and the ids of its agents in the whole scene.
  static Scene ownPart(const Scene& scene, const FloorStrips& strips, int rank, std::vector<AgentId>& ids);
  /// Decides for the own agents, and receives the actions of the copies.
  bool decide(Episode& episode, std::vector<AgentAction>& actions) override;
  /// Receives the motions of the copies.
  void agree(World& world) override;
  /// Divides the floor again, hands over agents and copies those near borders.
  void regroup();
  /// Lists the own agents on their way in `kept_`; the results of those that have arrived are stored.
  std::vector<Vector2> keepOwn();
  /// Sends away the kept agents in strips of others; returns those that arrive here.
  std::vector<Traveller> handOver();
  /// Returns the copies of others' agents, after newcomers() were handed over.
  std::vector<Traveller> exchangeCopies(const std::vector<Traveller>& newcomers);
  void writeCopies(const Agent& agent, std::vector<Communicator::Bytes>& messages);
  /// Makes the kept agents and these the agents of the world.
  void adopt(std::vector<Traveller> newcomers);
  void append(Agent&& agent, const Track& track);
  void noteShares(std::size_t own);
  /// Computes the motion of all agents of all ranks.
  void moveWholeCrowd(World& world);
  const World& world() const { return episode_.world(); }
  int rank() const { return communicator_.rank(); }
  std::size_t rankCount() const { return static_cast<std::size_t>(communicator_.size()); }

  std::string scenario_;
  std::uint64_t max_ticks_;
  std::size_t agent_count_;
  Options options_;
  Reach reach_;
  Communicator& communicator_;
  FloorStrips strips_;
  std::vector<AgentId> first_ids_;  // while constructing: ids in the scene of the agents of this rank
  Episode episode_;                 // of the agents of this rank, with their ids in the scene
  CrowdDecider own_;
  BorderExchange border_;
  std::vector<Finished> finished_;
  std::uint64_t next_regroup_ = 0;  // tick
  bool stops_ = false;              // this rank wants the episode to end
  bool was_stopped_ = false;
  // While regrouping; kept for their memory:
  std::vector<Agent> agents_;  // the former ones
  std::vector<Track> tracks_;  // of these
  std::vector<std::uint32_t> kept_;
  std::vector<Agent> next_agents_;
  std::vector<Track> next_tracks_;
  std::vector<BorderExchange::Shared> shared_;
  // For the report:
  double seconds_ = 0.0;
  double busy_seconds_ = 0.0;     // processor time, that of exchanges included
  double waiting_seconds_ = 0.0;  // processor time of exchanges
  std::uint64_t bytes_ = 0;
  std::uint64_t whole_motions_ = 0;
  double imbalance_sum_ = 0.0;
  std::uint64_t divisions_ = 0;
};

}  // namespace crowd
