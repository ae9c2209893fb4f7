// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeDocument.h"
#include "document/volume/exercise/DrillingTask.h"
#include "simulation/SimulatedGesture.h"
#include "simulation/drilling/DrillSimulation.h"
#include "tools/ToolKey.h"
#include "tools/volume/VolumeTool.h"
#include "volume/drilling/DrillTools.h"

namespace handwheel {

// Tool that drills a volume. With the mouse the drill is fed along the surface's normal (a saw stands upright on it),
// or straight down the view with Shift, from where it is pressed until the button is released, in pecks if that is set;
// a key holds it. A device drills as the hand goes. A hole is one undo step, and how it was drilled is kept with it.
// Thrust, torque and work are shown while it goes on. In work on an exercise the drill is that of its task, and is
// judged by the planned path.
class DrillingTool : public VolumeTool {
 public:
  static constexpr double kRate = 60.0;  // steps of the simulation a second

  DrillingTool(VolumeDocument& document, const SimulationServices& services);

  ClayFeel feelAtDevice() const override;

  static std::span<const ToolKey> keys();
  std::string id() const override { return "drill"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  bool isLive() const override { return m_gesture.isOn(); }
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"simulation"}; }

  // The hole that is drilled, or else the one before; null: there was none.
  std::shared_ptr<const DrillState> hole() const { return m_gesture.isOn() ? state() : m_last; }
  DrillSetup setup() const;
  // What is prepared for the exercise; null: it is work on none.
  const std::shared_ptr<const DrillingTask>& task() const { return m_task; }

 private:
  std::unique_ptr<Simulation> simulation() const;
  std::shared_ptr<const DrillState> state() const;
  const char* holdText() const;
  void setHead(std::size_t type);
  // Where a feed by the mouse begins, its head's centre; sets m_feed. None: the pointer is beside the volume, or
  // (m_isBlocked) a twist drill would stand in the material with its whole length.
  std::optional<Vec3> startOfFeed(const PointerEvent& event);
  ToolReply press(const PointerEvent& event);
  ToolReply release();

  VolumeDocument& m_document;
  std::shared_ptr<const DrillingTask> m_task;
  DrillTool m_head = drillTools().front().tool;
  std::size_t m_material = 0;       // of drillMaterials()
  double m_rpm = 1000.0;            // r/min
  double m_speed = 1.0;             // mm/s, of the feed
  double m_peck = 0.0;              // mm, as that of DrillFeed
  bool m_isHeld = false;            // the feed, for now
  std::optional<DrillFeed> m_feed;  // of the present hole; none: by a device
  DrillSetup m_begun;               // that the present hole was begun with
  SimulatedGesture m_gesture;
  std::shared_ptr<const DrillState> m_last;  // of the hole before; null: none
  std::size_t m_lastCount = 0;               // of the document's holes, with that one
  std::optional<Vec3> m_hovered, m_normal;   // on the surface
  bool m_isBlocked = false;                  // where it was pressed last, a drill has no way in
};

}  // namespace handwheel
