#pragma once

#include <rviz/properties/float_property.h>
#include <rviz/properties/string_property.h>
#include <rviz/tool.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "ros/node/service_line.h"
#include "rviz/floor_outline.h"

namespace Ogre {
class Viewport;
}
namespace rviz {
class BillboardLine;
}

namespace crowd {

/// @brief Base of the tools with which a user draws on the floor: the left button goes down at one point and up at
/// another one, with an outline between; the right button abandons it. Then a service of the crowd controller is
/// called, in another thread, and RViz shows its answer in the status bar. The tool stays active.
///
/// RViz makes it and calls all functions, in its thread.
class FloorTool : public rviz::Tool {
 public:
  /// @param name in the tool bar @param help shown while the tool is active
  FloorTool(const QString& name, const QString& help);
  ~FloorTool() override;

  void onInitialize() override;
  void activate() override;
  void deactivate() override;
  void update(float wall_dt, float ros_dt) override;
  int processMouseEvent(rviz::ViewportMouseEvent& event) override;

 protected:
  /// What is drawn while the button is down [m], `map`.
  virtual FloorOutline outline(const Vector2& from, const Vector2& to) const = 0;
  /// The button is up [m], `map`.
  virtual void finish(const Vector2& from, const Vector2& to) = 0;

  /// Calls a service of the controller whose response has `success` and `message`.
  template <typename Service>
  void call(const char* service, const typename Service::Request& request) {
    const std::optional<std::string> controller = controllerName();
    if (!controller) return;
    line_->add<Service>(*controller + "/" + service, request, [this](const typename Service::Response& response) {
      tell(response.success != 0, response.message);
    });
  }
  /// Shows a text in the status bar.
  void say(const std::string& text);

 private:
  /// The full name of the controller; nothing if the property has no valid name, which is reported.
  std::optional<std::string> controllerName();
  /// Keeps an answer until update(). Thread-safe.
  void tell(bool success, const std::string& message);
  /// The point of the floor under the mouse [m], `map`.
  std::optional<Vector2> pointAt(Ogre::Viewport* viewport, int x, int y) const;
  void draw(const FloorOutline& outline);
  void abandon();

  QString name_;
  QString help_;
  rviz::StringProperty* controller_;
  std::unique_ptr<rviz::BillboardLine> lines_;
  std::optional<Vector2> from_;  // while the button is down
  std::mutex mutex_;
  std::optional<std::string> answer_;
  std::unique_ptr<ServiceLine> line_;  // last member: its thread uses the others
};

}  // namespace crowd
