// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "panels/HintBar.h"
#include "tools/ToolRunner.h"

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
  // Updates the display after the preview of the tool has changed without an input.
  void refresh() { showSoon(); }
  // Shows or hides the previews of tools, with the document.
  void setVisible(bool visible);
  // Changes a setting of a tool, for the running one and for later starts of it.
  void choose(const std::string& tool, const std::string& setting, const PropertyValue& value);
  // Sets the effect of Esc in the view if the tool has nothing to revert, such as cancelling a job. The function
  // returns true if it did anything; otherwise the key goes to the tool.
  void setEscape(std::function<bool()> escape) { m_escape = std::move(escape); }
  ToolRunner& runner() { return m_runner; }
  // Returns true if the tool has unfinished work in a document that is not in its value yet.
  bool isUnderWay(const Document& document) const;
  // Returns the value of a document with the unfinished work; null: there is none. Strokes already made are then
  // recorded in the document by the work, so it must not be called from within the tool.
  SnapshotPointer valueWithGesture(const Document& document);
  ToolKeys& keys() { return m_keys; }
  // Passes a pointer event of a haptic device; those of the mouse arrive by themselves.
  void point(const PointerEvent& event) { m_runner.pointer(event); }
  // Called while the mouse is the haptic device, with each input before the tool gets it. Returns the pose of the tip;
  // none while the mouse is only a mouse. The wheel then moves the tip; with Ctrl it moves the camera.
  using MouseDevicePose = std::function<std::optional<Pose>(const PointerInput&, const ViewRay&)>;
  // isOn: returns true while the mouse is the device.
  void setMouseDevice(MouseDevicePose pose, std::function<bool()> isOn) {
    m_mouseDevice = std::move(pose);
    m_isMouseDevice = std::move(isOn);
  }
  // Called with each right click before the tool gets it. Returns true if it has opened a menu.
  void setContextMenu(std::function<bool(const QPointF& position)> menu) { m_menu = std::move(menu); }

  // The present bindings of pointer and keys, translated.
  std::vector<Hint> hints() const;

 signals:
  void updated();  // the hints or the display of the tool have changed
  // The present preview of the tool; empty when it has ended. The kind of the document shows its part of it.
  void previewed(const handwheel::ToolPreview& preview);

 protected:
  bool eventFilter(QObject* watched,
                   QEvent* event) override;  // handles keys of the tool pressed in the view or the panel "Device"

 private:
  bool take(const PointerInput& input);
  ToolReply perform(std::string_view action);
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
  std::vector<ServiceHandle> m_needed;
  bool m_isMoving = false;   // the tool is handling a mouse move
  bool m_isShowDue = false;  // showSoon() was called
  bool m_isVisible = true;
  int m_frame = 0;  // frame shown while the preview is live
  QTimer m_frames;  // runs while the preview is live
  using Chosen = std::map<std::string, PropertyValue>;
  std::map<std::string, Chosen> m_chosen;  // chosen settings, by tool
  std::map<std::pair<std::string, std::string>, Chosen>
      m_chosenOfDocument;  // chosen settings, by the document's id and tool
};

}  // namespace handwheel
