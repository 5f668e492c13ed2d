#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace crowd {

/// @brief A call of a service that the panel is to make.
struct PanelRequest {
  enum class Kind {
    PAUSE,           ///< `flag`: pause, else walk
    STEP,            ///< `number`: ticks
    RESET,           ///< with the present seed
    SET_SPEED,       ///< `number`: factor of real time
    LIST_SCENARIOS,  ///<
    LOAD_SCENARIO,   ///< `text`: file or name
    SAVE_SCENARIO,   ///< `text`: file; `flag`: it may be replaced
    SET_MODE,        ///< `text`: mode
    SET_PARAMETER,   ///< `text`: name of a parameter of Q-learning; `number`: value
    SAVE_TABLE,      ///< `text`: file; `number`: agent; `flag`: the file may be replaced
    LOAD_TABLE,      ///< `text`: file
    SHARE_TABLE,     ///< `text`: method; `number`: agent
    CHOOSE_AGENT,    ///< `number`: agent
  };
  Kind kind = Kind::PAUSE;
  std::string node;  ///< full name of the node that serves it
  std::string text = {};
  double number = 0.0;
  bool flag = false;
};

/// @brief What the panel shows, and which of its controls are enabled.
struct PanelView {
  bool has_controller = false;  ///< reset, scenarios and speed
  bool can_play = false;
  bool can_pause = false;
  bool can_step = false;
  bool has_learner = false;  ///< mode, parameters and tables
  bool can_share = false;    ///< there are several tables
  bool has_markers = false;  ///< choice of the agent

  double speed = 1.0;  ///< factor of real time; 0: as fast as possible
  std::vector<std::string> scenarios;
  std::string scenario;
  std::vector<std::string> learners;  ///< entries of the choice
  std::string learner;                ///< the chosen entry
  std::string mode;
  double epsilon = 0.0;
  double alpha = 0.0;
  double gamma = 0.0;
  std::int64_t chosen_agent = -1;

  std::string state;      ///< "walking", "paused" or who is away
  std::string episode;    ///< number of the episode
  std::string tick;       ///< number of the tick, and time
  std::string success;    ///< share of the agents, and count
  std::string contact;    ///< the same
  std::string collision;  ///< the same
  std::string decisions;  ///< per second
  std::string missing;    ///< agents without answers
  std::string table;      ///< visited rows and decisions of the learner
  std::string message;    ///< result of the last request
  bool is_error = false;  ///< `message` is an error
};

}  // namespace crowd
