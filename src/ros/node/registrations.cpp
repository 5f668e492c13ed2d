#include "ros/node/registrations.h"

#include <ros/connection_manager.h>
#include <ros/network.h>
#include <ros/service_manager.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>

#include <map>
#include <mutex>

namespace crowd {
namespace {

using XmlRpc::XmlRpcValue;

/// The services that may be there beside those of addService(): of roscpp and of the manager of nodelets; below the
/// node.
const std::vector<std::string> USUAL_SERVICES = {"get_loggers", "set_logger_level", "load_nodelet", "unload_nodelet",
                                                 "list"};

struct AddedServices {
  std::mutex mutex;
  std::set<std::string> names;
};

AddedServices& addedServices() {
  static AddedServices services;
  return services;
}

/// Returns the full names of the services that this process serves at present.
std::vector<std::string> presentServices() {
  std::set<std::string> names;
  {
    const std::lock_guard<std::mutex> lock(addedServices().mutex);
    names = addedServices().names;
  }
  for (const std::string& name : USUAL_SERVICES) names.insert(ros::this_node::getName() + "/" + name);
  std::vector<std::string> present;
  for (const std::string& name : names) {
    if (ros::ServiceManager::instance()->lookupServicePublication(name) != nullptr) present.push_back(name);
  }
  return present;
}

std::string ownUri() { return ros::XMLRPCManager::instance()->getServerURI(); }

std::string serviceUri() {
  return "rosrpc://" + ros::network::getHost() + ":" + std::to_string(ros::ConnectionManager::instance()->getTCPPort());
}

/// Returns the entries of an array.
std::vector<XmlRpcValue> toValues(XmlRpcValue array) {
  std::vector<XmlRpcValue> values(static_cast<std::size_t>(array.size()));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = array[static_cast<int>(i)];
  return values;
}

bool isDone(const std::optional<RosApi::Answer>& answer) { return answer && answer->success; }

}  // namespace

Registrations::Registrations(const std::function<bool()>& is_cancelled)
    : node_("localhost", static_cast<int>(ros::XMLRPCManager::instance()->getServerPort()), is_cancelled) {}

void Registrations::addService(const std::string& name) {
  const std::lock_guard<std::mutex> lock(addedServices().mutex);
  addedServices().names.insert(name);
}

bool Registrations::registerOffers(RosApi& master) {
  published_ = 0;
  std::optional<Values> topics = own("getPublications");
  if (!topics) return false;
  for (XmlRpcValue& topic : *topics) {  // name, type
    if (!isDone(master.call("registerPublisher", {topic[0], topic[1], ownUri()}))) return false;
    ++published_;
  }
  return registerServices(master);
}

bool Registrations::registerServices(RosApi& master) {
  served_ = 0;
  for (const std::string& name : presentServices()) {
    if (!isDone(master.call("registerService", {name, serviceUri(), ownUri()}))) return false;
    ++served_;
  }
  return true;
}

bool Registrations::registerSubscriptions(RosApi& master) {
  subscribed_ = 0;
  std::optional<Values> topics = own("getSubscriptions");
  std::optional<Values> links = own("getBusInfo");
  if (!topics || !links) return false;
  std::map<std::string, std::set<std::string>> publishers;  // URIs by topic
  for (XmlRpcValue& link : *links) {  // number, URI of the publisher, "i" or "o", transport, topic
    if (static_cast<std::string>(link[2]) == "i") publishers[link[4]].insert(link[1]);
  }
  for (XmlRpcValue& topic : *topics) {  // name, type
    const std::optional<RosApi::Answer> answer = master.call("registerSubscriber", {topic[0], topic[1], ownUri()});
    if (!isDone(answer) || !connect(topic[0], publishers[topic[0]], answer->value)) return false;
    ++subscribed_;
  }
  return true;
}

bool Registrations::connect(const std::string& topic, std::set<std::string> publishers, const XmlRpcValue& listed) {
  for (XmlRpcValue& uri : toValues(listed)) publishers.insert(uri);
  XmlRpcValue all;
  all.setSize(0);
  for (const std::string& uri : publishers) all[all.size()] = uri;
  // The answer is an error if one of them cannot be reached, which ends by itself.
  return node_.call("publisherUpdate", {topic, all}).has_value();
}

std::optional<Registrations::Values> Registrations::own(const std::string& function) {
  const std::optional<RosApi::Answer> answer = node_.call(function, {});
  if (!isDone(answer)) return std::nullopt;
  return toValues(answer->value);
}

}  // namespace crowd
