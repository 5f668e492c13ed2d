#pragma once

#include <ros/node_handle.h>

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ros/messages/topic_defaults.h"

namespace crowd {

/// @brief Topics whose messages are made from the same data, each only while somebody subscribes to it.
template <typename... Data>
class TopicGroup {
 public:
  /// @param make returns the message for the data
  template <typename Make>
  void advertise(ros::NodeHandle& node, const std::string& topic, Make make) {
    using Message = std::invoke_result_t<Make, Data...>;
    const auto publish = [make = std::move(make)](const ros::Publisher& publisher, Data... data) {
      publisher.publish(make(data...));
    };
    topics_.push_back({node.advertise<Message>(topic, QUEUE), publish});
  }

  /// @brief Whether any of the topics has subscribers.
  bool haveSubscribers() const {
    return std::any_of(topics_.begin(), topics_.end(), [](const Topic& topic) { return topic.isHeard(); });
  }
  /// @brief Publishes a message from the data on each topic that has subscribers.
  void publish(Data... data) const {
    for (const Topic& topic : topics_) {
      if (topic.isHeard()) topic.publish(topic.publisher, data...);
    }
  }

 private:
  struct Topic {
    bool isHeard() const { return publisher.getNumSubscribers() > 0; }

    ros::Publisher publisher;
    std::function<void(const ros::Publisher& publisher, Data... data)> publish;
  };

  std::vector<Topic> topics_;
};

}  // namespace crowd
