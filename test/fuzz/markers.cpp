// Messages that crowd_markers draws, one after the other, each behind a byte that tells which it is.

#include "ros/markers/marker_scene.h"

#include <boost/make_shared.hpp>

#include "fuzz/messages.h"

namespace {

using namespace crowd;

using Handler = void (*)(MarkerScene& scene, fuzz::MessageStream& stream);

template <typename Message>
void take(MarkerScene& scene, fuzz::MessageStream& stream) {
  scene.take(stream.take<Message>());
}

template <typename Message>
void takeShared(MarkerScene& scene, fuzz::MessageStream& stream) {
  const auto message = boost::make_shared<Message>();
  stream.next(*message);
  scene.take(typename Message::ConstPtr(message));
}

void takePerceptions(MarkerScene& scene, fuzz::MessageStream& stream) {
  scene.take(stream.takeTickMessage<PerceptionsMessage>());
}

void draw(MarkerScene& scene, fuzz::MessageStream& stream) {
  scene.choose(stream.nextByte());
  scene.draw(stream.nextByte() % 2 == 0);
}

constexpr Handler HANDLERS[] = {
    draw,
    takeShared<social_crowd::AgentStates>,
    takeShared<social_crowd::RobotStates>,
    take<social_crowd::Scenario>,
    take<social_crowd::Walls>,
    take<nav_msgs::OccupancyGrid>,
    takePerceptions,
    takeShared<social_crowd::DecisionValues>,
    take<social_crowd::LearnerStatus>,
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed(size, 10'000, [&] {
    fuzz::MessageStream stream(data, size);
    MarkerOptions options;
    options.radii = MarkerOptions::Radii::ALL;
    MarkerScene scene(options);
    fuzz::handleAll(HANDLERS, scene, stream);
    scene.draw(true);
  });
}
