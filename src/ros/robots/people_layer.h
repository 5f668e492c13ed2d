#pragma once

#include <costmap_2d/layer.h>
#include <ros/ros.h>
#include <social_crowd/AgentStates.h>

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "robots/personal_space.h"
#ifdef SOCIAL_CROWD_PEOPLE_MSGS
#include <people_msgs/People.h>
#endif

namespace crowd {

/// @brief Layer of costmap_2d with the costs of the space around people; docs/move_base.md has its parameters.
///
/// The update thread of the costmap calls it. Messages arrive in threads that serve the global callback queue.
class PeopleLayer : public costmap_2d::Layer {
 public:
  /// @brief Enlarges the bounds by those of the people, and by those of the last call, whose costs must go.
  void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x, double* min_y, double* max_x,
                    double* max_y) override;
  /// @brief Raises the costs around people. Cells of unknown state stay unknown.
  void updateCosts(costmap_2d::Costmap2D& costmap, int min_i, int min_j, int max_i, int max_j) override;
  /// @brief Forgets the people until the next message.
  void reset() override;

 protected:
  void onInitialize() override;

 private:
  struct Person {
    Vector2 place;
    Vector2 velocity;
  };
  struct People {
    std_msgs::Header header;
    std::vector<Person> people;
  };

  void subscribe(const std::string& source, const std::string& topic);
  void take(const social_crowd::AgentStates& message);
#ifdef SOCIAL_CROWD_PEOPLE_MSGS
  void take(const people_msgs::People& message);
#endif
  void keep(People people);
  void readParameters();
  /// The parameter; the present value if it is not set or wrong, which is reported.
  double number(const std::string& name, double present, double low, double high);
  /// Personal spaces in the frame of the costmap of the people who are near it; none if the data are too old.
  std::vector<PersonalSpace> spacesOf(const People& people) const;
  bool isNear(const Bounds& bounds) const;

  ros::NodeHandle parameters_;
  std::string topic_;
  PersonalSpaceSpec spec_;
  bool draws_ = true;     // ~enabled; the member of the base class would keep old costs from being cleared
  double timeout_ = 1.0;  // [s]
  std::map<std::string, std::string> reported_;  // wrong values, by parameter
  std::mutex mutex_;
  People people_;                      // of the last message; guarded by mutex_
  std::vector<PersonalSpace> spaces_;  // of this update
  std::vector<Bounds> drawn_;          // of the last update, joined: one or none
  ros::Subscriber subscriber_;         // last member: its callback uses all others
};

}  // namespace crowd
