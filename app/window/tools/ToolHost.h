// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "panels/HintBar.h"
#include "tools/ToolRunner.h"

#include <QPointer>
#include <QTimer>
#include <map>

namespace handwheel {

class PartsLayer;
class ToolKeys;
class ToolPanel;
class ToolReadout;
class Viewport;
struct PointerInput;
struct ViewRay;

// Connects the active tool to the viewport, the keyboard and its settings panel. Mouse input becomes pointer events,
// the previews of the tool are drawn, and its declared actions become hints.
class ToolHost : public QObject {
  Q_OBJECT

 public:
  ToolHost(Viewport& viewport, ToolPanel& panel, ServiceRegistry& needs, QObject* parent = nullptr);
  ~ToolHost() override;

  void start(std::unique_ptr<Tool> tool, Document& document);
  void stop() { m_runner.stop(); }
  // Updates the display. To be called when the preview of the tool has changed without an input.
  void refresh() { showSoon(); }
  // Shows or hides the previews of tools, with the document.
  void setVisible(bool visible);
  // Changes a setting of a tool, for the running tool and for later starts.
  void choose(const std::string& tool, const std::string& setting, const PropertyValue& value);
  // Sets the effect of Esc in the view if the tool has nothing to revert, such as cancelling a job of the document. The
  // function returns true if it did anything; otherwise the key goes to the tool.
  void setEscape(std::function<bool()> escape) { m_escape = std::move(escape); }
  ToolRunner& runner() { return m_runner; }
  // Returns true if the tool has unfinished work that the value of the document does not contain yet.
  bool isUnderWay(const Document& document) const;
  // Returns the value of a document with the unfinished work; null: there is none. This call completes the present
  // strokes of the tool, so it must not be called from within the tool.
  SnapshotPointer valueWithGesture(const Document& document);
  ToolKeys& keys() { return m_keys; }
  // Passes a pointer event of a haptic device; events of the mouse are passed automatically.
  void point(const PointerEvent& event) { m_runner.pointer(event); }
  // The function that is called with each mouse input before the tool receives it, while the mouse is the haptic
  // device. It returns the pose of the tip, or nothing if the mouse does not move a tip. While the mouse is the device,
  // its wheel moves the tip, or the camera if Ctrl is held.
  using MouseDevicePose = std::function<std::optional<Pose>(const PointerInput&, const ViewRay&)>;
  // Sets the function for the mouse as haptic device. isOn: the function that returns true while the mouse is the
  // device.
  void setMouseDevice(MouseDevicePose pose, std::function<bool()> isOn) {
    m_mouseDevice = std::move(pose);
    m_isMouseDevice = std::move(isOn);
  }
  // Sets the function that is called with each right click before the tool receives it. It returns true if it has
  // opened a menu.
  void setContextMenu(std::function<bool(const QPointF& position)> menu) { m_menu = std::move(menu); }

  // The present bindings of pointer and keys, translated.
  std::vector<Hint> hints() const;

 signals:
  void updated();  // the hints or the display of the tool have changed
  // Emitted with the present preview of the tool, which is empty when the tool has ended. The user interface of the
  // document's kind shows its own part of the preview.
  void previewed(const handwheel::ToolPreview& preview);

 protected:
  // Handles the keys of the tool, wherever the focus is in the window, unless the widget with the focus needs them.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool take(const PointerInput& input);
  ToolReply perform(std::string_view action);
  bool claimKey(QKeyEvent& event);
  void unclaim();
  bool isWatched(const QWidget& widget) const;
  bool takeKey(QKeyEvent& event);
  void showActions();
  void showValues(const PointerInput& input, PointerEvent::Kind kind);
  void show();
  void showSoon();
  void showNothing();
  void showShapes(ToolPreview preview);
  void showLabel(const std::optional<ToolLabel>& label);

  Viewport& m_viewport;
  std::shared_ptr<PartsLayer> m_proposed;
  ToolPanel& m_panel;
  ToolReadout* m_readout;
  ToolReadout* m_label;
  ToolKeys& m_keys;
  ServiceRegistry& m_needs;
  ToolRunner m_runner;
  MouseDevicePose m_mouseDevice;
  std::function<bool()> m_isMouseDevice = [] { return false; };
  std::function<bool()> m_escape = [] { return false; };
  std::function<bool(const QPointF&)> m_menu;
  QPointer<QWidget> m_claimed;  // the widget whose next key press is that of the tool; null: none
  std::vector<ServiceHandle> m_needed;
  bool m_isMoving = false;   // the tool is handling a mouse move
  bool m_isShowDue = false;  // showSoon() was called
  bool m_isVisible = true;
  int m_frame = 0;  // frame shown while the preview is live
  QTimer m_frames;  // runs while the preview is live
  using Chosen = std::map<std::string, PropertyValue>;
  std::map<std::string, Chosen> m_chosen;  // chosen settings, by tool
  std::map<std::pair<std::string, std::string>, Chosen>
      m_chosenOfDocument;  // chosen settings, by the id of the document and the tool
};

}  // namespace handwheel
