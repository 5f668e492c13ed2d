#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <functional>
#include <string>
#include <vector>

#include "common/text/quotes.h"
#include "ros/node/registrations.h"

namespace crowd {

/// @brief Services of a node. Handlers run in separate threads, so that a waiting handler does not block the node.
/// Handlers that may take long, because they read files or wait for other nodes, belong in an object of their own:
/// others would wait for a free thread. An exception in a handler gives a response with `success: false` and its text
/// as `message`.
class Services {
 public:
  Services(const ros::NodeHandle& private_node, unsigned threads) : node_(private_node), spinner_(threads, &queue_) {
    node_.setCallbackQueue(&queue_);
  }
  ~Services() { stop(); }
  Services(const Services&) = delete;
  Services& operator=(const Services&) = delete;

  /// @brief Advertises a service whose response has `success` and `message`.
  /// @param handler writes the response without `success`, or throws
  template <typename Service>
  void serve(const std::string& name,
             std::function<void(const typename Service::Request&, typename Service::Response&)> handler) {
    using Request = typename Service::Request;
    using Response = typename Service::Response;
    serveAs<Service>(name, [handler](const Request& request, Response& response) {
      try {
        response.success = true;
        handler(request, response);
      } catch (const std::exception& error) {
        response.success = false;
        response.message = shortened(error.what(), MAX_MESSAGE);
      }
    });
  }

  /// @brief Advertises a service of another form. An exception in its handler fails the call.
  template <typename Service>
  void serveAs(const std::string& name,
               std::function<void(const typename Service::Request&, typename Service::Response&)> handler) {
    using Request = typename Service::Request;
    using Response = typename Service::Response;
    const boost::function<bool(Request&, Response&)> answer = [handler](Request& request, Response& response) {
      handler(request, response);
      return true;
    };
    servers_.push_back(node_.advertiseService<Request, Response>(name, answer));
    Registrations::addService(servers_.back().getService());
  }

  /// @brief Starts to answer requests.
  void start() { spinner_.start(); }

  /// @brief Shuts the services down and waits for running handlers.
  void stop() {
    for (ros::ServiceServer& server : servers_) server.shutdown();
    queue_.disable();  // wakes the threads, which otherwise look every 0.1 s whether they are to stop
    spinner_.stop();
  }

 private:
  static constexpr std::size_t MAX_MESSAGE = 10'000;  // [bytes], of an error

  ros::NodeHandle node_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace crowd
