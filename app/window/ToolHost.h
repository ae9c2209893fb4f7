// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "panels/HintBar.h"
#include "tools/ToolRunner.h"

#include <map>

namespace handwheel {

class ToolKeys;
class ToolPanel;
class ToolReadout;
class Viewport;
struct PointerInput;
struct ViewRay;

// Brings the tool in use together with viewport, keyboard and its settings: the mouse becomes pointer events, what the
// tool previews is drawn, what it declares becomes hints.
class ToolHost : public QObject {
  Q_OBJECT

 public:
  ToolHost(Viewport& viewport, ToolPanel& panel, NeedSet& needs, QObject* parent = nullptr);
  ~ToolHost() override;

  void start(std::unique_ptr<Tool> tool, Document& document);
  void stop() { m_runner.stop(); }
  // A setting of a tool: for the one that runs, and for the next time that such a one is started.
  void choose(const std::string& tool, const std::string& setting, const PropertyValue& value);
  ToolRunner& runner() { return m_runner; }
  ToolKeys& keys() { return m_keys; }
  // What a haptic device does; the mouse comes by itself.
  void point(const PointerEvent& event) { m_runner.pointer(event); }
  // Where the mouse is the device: hears of each input before the tool does, and says where the tip is; none where the
  // mouse is but a mouse. Then the wheel moves the tip, but for Ctrl, with which it is the camera's.
  using MouseDevicePlace = std::function<std::optional<Pose>(const PointerInput&, const ViewRay&)>;
  void setMouseDevice(MouseDevicePlace place) { m_mouseDevice = std::move(place); }

  // What the pointer and the keys do now, translated.
  std::vector<Hint> hints() const;
 signals:
  void updated();  // hints, or what the tool shows

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;  // keys that the tool declares, pressed in the view

 private:
  bool take(const PointerInput& input);
  bool takeKey(QKeyEvent& event);
  void showActions();
  void showValues(const PointerInput& input, PointerEvent::Kind kind);
  void show();
  void showSoon();
  void showNothing();

  Viewport& m_viewport;
  ToolPanel& m_panel;
  ToolReadout* m_readout;
  ToolKeys& m_keys;
  NeedSet& m_needs;
  ToolRunner m_runner;
  MouseDevicePlace m_mouseDevice;
  std::vector<Need> m_needed;
  bool m_isMoving = false;                                               // the tool is hearing of a move of the mouse
  bool m_isShowDue = false;                                              // showSoon() was called
  std::map<std::string, std::map<std::string, PropertyValue>> m_chosen;  // by tool
};

}  // namespace handwheel
