// RViz as a test sees it: the program `rviz`, and answers about its widgets on the standard input and output, so that
// the test can click where a widget is. A request is a line "place NAME", "size NAME", "text NAME" or "enabled NAME",
// or "entries NAME" of a choice, whose answer is the list of them, with tabs between them,
// or "view PROPERTY" of the present view, whose answer is its value, or "frames", the number
// of frames drawn so far, or "pressed NAME", whether the mouse was pressed on the widget since its place was asked for;
// the answer is a line.

#include <rviz/properties/property.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>
#include <rviz/visualizer_app.h>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QSet>
#include <QSocketNotifier>
#include <QWidget>
#include <iostream>
#include <string>

namespace {

/// A widget is known by its object name, its class, or the text of a button.
bool isCalled(const QWidget* widget, const QString& name) {
  const auto* const button = qobject_cast<const QAbstractButton*>(widget);
  return widget->objectName() == name || widget->metaObject()->className() == name ||
         (button != nullptr && button->text() == name);
}

/// Notes the names of the enabled widgets on which the mouse is pressed, and of those around them.
class PressWatch : public QObject {
 public:
  bool eventFilter(QObject* object, QEvent* event) override {
    const auto* widget = event->type() == QEvent::MouseButtonPress ? qobject_cast<const QWidget*>(object) : nullptr;
    if (widget == nullptr || !widget->isEnabled()) return false;
    for (; widget != nullptr; widget = widget->parentWidget()) {
      names_ << widget->objectName() << widget->metaObject()->className();
      if (const auto* const button = qobject_cast<const QAbstractButton*>(widget)) names_ << button->text();
    }
    return false;
  }
  bool has(const QString& name) const { return names_.contains(name); }
  void clear() { names_.clear(); }

 private:
  QSet<QString> names_;
};

PressWatch& presses() {
  static PressWatch watch;
  return watch;
}

/// Whether the mouse was pressed on a widget of this name. Handles what the X server has sent so far.
bool wasPressed(const QString& name) {
  QGuiApplication::sync();
  QCoreApplication::processEvents(QEventLoop::ExcludeSocketNotifiers);
  return presses().has(name);
}

QWidget* findWidget(const QString& name, int index) {
  int found = 0;
  for (QWidget* const widget : QApplication::allWidgets()) {
    if (isCalled(widget, name) && widget->isVisible() && found++ == index) return widget;
  }
  return nullptr;
}

QString textOf(const QWidget* widget) {
  if (const auto* const label = qobject_cast<const QLabel*>(widget)) return label->text();
  if (const auto* const button = qobject_cast<const QAbstractButton*>(widget)) return button->text();
  if (const auto* const box = qobject_cast<const QAbstractSpinBox*>(widget)) return box->text();
  if (const auto* const choice = qobject_cast<const QComboBox*>(widget)) return choice->currentText();
  if (const auto* const line = qobject_cast<const QLineEdit*>(widget)) return line->text();
  return widget->windowTitle();
}

/// The entries of a choice, with tabs between them.
QString entriesOf(const QWidget* widget) {
  const auto* const choice = qobject_cast<const QComboBox*>(widget);
  QStringList entries;
  for (int i = 0; choice != nullptr && i < choice->count(); ++i) entries << choice->itemText(i);
  return entries.join('\t');
}

/// Scrolls so that a widget can be clicked on, as a user would do.
void scrollTo(QWidget* widget) {
  for (QWidget* outer = widget->parentWidget(); outer != nullptr; outer = outer->parentWidget()) {
    if (auto* const area = qobject_cast<QScrollArea*>(outer)) area->ensureWidgetVisible(widget);
  }
}

rviz::VisualizationManager* manager() {
  for (QWidget* const widget : QApplication::topLevelWidgets()) {
    auto* const frame = qobject_cast<rviz::VisualizationFrame*>(widget);
    if (frame != nullptr) return frame->getManager();
  }
  return nullptr;
}

/// The value of a property of the present view.
std::string ofView(const std::string& property) {
  rviz::ViewController* const view = manager()->getViewManager()->getCurrent();
  return view->subProp(QString::fromStdString(property))->getValue().toString().toStdString();
}

/// The answer to a request. @param name of the widget, see isCalled(); with "#N" behind it the N-th widget of that name
std::string answer(const std::string& verb, const std::string& name) {
  if (verb == "view") return ofView(name);
  if (verb == "frames") return std::to_string(manager()->getFrameCount());
  const QStringList parts = QString::fromStdString(name).split('#');
  if (verb == "pressed") return wasPressed(parts[0]) ? "yes" : "no";
  QWidget* const widget = findWidget(parts[0], parts.size() > 1 ? parts[1].toInt() : 0);
  if (widget == nullptr) return "no such widget";
  if (verb == "enabled") return widget->isEnabled() ? "yes" : "no";
  if (verb == "text") return textOf(widget).replace('\n', ' ').toStdString();
  if (verb == "entries") return entriesOf(widget).toStdString();
  if (verb == "size") return std::to_string(widget->width()) + " " + std::to_string(widget->height());
  scrollTo(widget);
  presses().clear();
  const QPoint middle = widget->mapToGlobal(widget->rect().center());
  return std::to_string(middle.x()) + " " + std::to_string(middle.y());
}

/// Closes RViz. It draws no more: Mesa's software renderer writes beyond its buffers if it draws a window that is
/// closed.
void close() {
  for (QWidget* const window : QApplication::topLevelWidgets()) {
    if (auto* const frame = qobject_cast<rviz::VisualizationFrame*>(window)) frame->getManager()->stopUpdate();
  }
  QApplication::closeAllWindows();
}

void serve() {
  std::string line;
  if (!std::getline(std::cin, line)) return close();
  const std::size_t gap = line.find(' ');
  std::cout << "answer: " << answer(line.substr(0, gap), gap == std::string::npos ? "" : line.substr(gap + 1))
            << std::endl;
}

}  // namespace

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  rviz::VisualizerApp visualizer;
  visualizer.setApp(&app);
  if (!visualizer.init(argc, argv)) return 1;
  QApplication::instance()->installEventFilter(&presses());
  QSocketNotifier requests(0, QSocketNotifier::Read);
  QObject::connect(&requests, &QSocketNotifier::activated, [] { serve(); });
  return QApplication::exec();
}
