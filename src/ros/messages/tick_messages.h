#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <social_crowd/Perceptions.h>
#include <social_crowd/RelativeActions.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "ros/messages/perception_routes.h"
#include "world/perception.h"
#include "world/relative_action.h"

/// The two messages of each tick. They contain the types of the core, which are serialised directly. On the wire, and
/// for other nodes, they are social_crowd/Perceptions and social_crowd/RelativeActions. Within a process they are
/// passed by pointer and not serialised.
namespace crowd {

/// @brief Perceptions of the agents at the start of a tick; on the wire social_crowd/Perceptions.
struct PerceptionsMessage {
  using Wire = social_crowd::Perceptions;
  using Ptr = boost::shared_ptr<PerceptionsMessage>;
  using ConstPtr = boost::shared_ptr<const PerceptionsMessage>;

  std_msgs::Header header;
  std::uint64_t run = 0;                      ///< of the publishing controller
  Vision vision;                              ///< of the perceptions
  std::uint8_t motion_source = 0;             ///< of the motion limits: a constant of the wire type
  std::shared_ptr<const Perceptions> shared;  ///< sent message: the object of the episode
  std::optional<PerceptionRows> rows;         ///< sent message: only these of its agents are serialised; null: all
  Perceptions received;                       ///< deserialised message; used if `shared` is null

  /// @brief Within a process a message with `rows` contains the other agents as well, because nothing is copied.
  const Perceptions& content() const { return shared != nullptr ? *shared : received; }
};

/// @brief Answer of a learner; on the wire social_crowd/RelativeActions. The receiver checks whether the actions are
/// valid.
struct ActionsMessage {
  using Wire = social_crowd::RelativeActions;
  using Ptr = boost::shared_ptr<ActionsMessage>;
  using ConstPtr = boost::shared_ptr<const ActionsMessage>;

  std_msgs::Header header;
  std::uint64_t run = 0;  ///< of the perceptions answered
  std::string node;       ///< name of the learner; may be empty
  RelativeActions content;
};

/// @brief Messages with agent numbers from this one on are invalid.
constexpr AgentId AGENT_LIMIT = 10'000'000;

/// @brief Checks received perceptions.
/// @throws InputError if parts lie beyond the lists or numbers are not finite
void requireValid(const Perceptions& perceptions);

}  // namespace crowd

namespace ros {

namespace message_traits {

/// Trait with the value of the wire type.
template <template <typename> class Trait, typename Message>
struct TraitOf {
  static const char* value() { return Trait<typename Message::Wire>::value(); }
  static const char* value(const Message& /*message*/) { return value(); }
};

template <>
struct IsMessage<crowd::PerceptionsMessage> : TrueType {};
template <>
struct HasHeader<crowd::PerceptionsMessage> : TrueType {};
template <>
struct MD5Sum<crowd::PerceptionsMessage> : TraitOf<MD5Sum, crowd::PerceptionsMessage> {};
template <>
struct DataType<crowd::PerceptionsMessage> : TraitOf<DataType, crowd::PerceptionsMessage> {};
template <>
struct Definition<crowd::PerceptionsMessage> : TraitOf<Definition, crowd::PerceptionsMessage> {};

template <>
struct IsMessage<crowd::ActionsMessage> : TrueType {};
template <>
struct HasHeader<crowd::ActionsMessage> : TrueType {};
template <>
struct MD5Sum<crowd::ActionsMessage> : TraitOf<MD5Sum, crowd::ActionsMessage> {};
template <>
struct DataType<crowd::ActionsMessage> : TraitOf<DataType, crowd::ActionsMessage> {};
template <>
struct Definition<crowd::ActionsMessage> : TraitOf<Definition, crowd::ActionsMessage> {};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<crowd::PerceptionsMessage> {
  static void write(OStream& stream, const crowd::PerceptionsMessage& message);
  /// @throws StreamOverrunException if the message is too short
  static void read(IStream& stream, crowd::PerceptionsMessage& message);
  static std::uint32_t serializedLength(const crowd::PerceptionsMessage& message);
};

template <>
struct Serializer<crowd::ActionsMessage> {
  static void write(OStream& stream, const crowd::ActionsMessage& message);
  /// @throws StreamOverrunException if the message is too short
  static void read(IStream& stream, crowd::ActionsMessage& message);
  static std::uint32_t serializedLength(const crowd::ActionsMessage& message);
};

}  // namespace serialization

}  // namespace ros
