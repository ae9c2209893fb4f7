// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/SimulatedGesture.h"
#include "tools/ToolKey.h"
#include "tools/carving/DrillSettings.h"
#include "tools/carving/VolumeTool.h"

#include <QString>
#include <optional>

namespace handwheel {

// Base class of tools that drill by hand. With the mouse the drill is fed along the surface's normal (a saw stands
// upright on it), or straight down the view with Shift, from where it is pressed until the button is released, in pecks
// if that is set; a key holds it. A device drills as the hand goes. Thrust, torque and work are shown while it goes on.
// What is drilled, and what becomes of the hole, is that of the classes derived.
class HandDrill : public VolumeTool {
 public:
  static constexpr double kRate = 60.0;  // steps of the simulation a second

  ClayFeel feelAtDevice() const override;

  static std::span<const ToolKey> keys();
  std::string id() const override { return "drill"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  bool isLive() const override { return m_gesture->isOn(); }
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  std::vector<std::string> needs() const override { return {"simulation"}; }

  // The hole that is drilled, or else the one before; null: there was none.
  std::shared_ptr<const DrillState> hole() const { return m_gesture->isOn() ? state() : m_last; }
  virtual DrillSetup setup() const { return m_settings.setup(); }
  // Whether it is work on an exercise, whose task chooses the drill.
  virtual bool isWorkOnExercise() const { return false; }

 protected:
  struct SurfacePlace {
    Vec3 point;   // mm
    Vec3 normal;  // outwards, of length 1
  };

  explicit HandDrill(const DrillSettings& settings) : m_settings(settings) {}
  // To be called once by the constructor of a derived class, when its functions below can be called.
  void begin(const SimulationServices& services);

  // mm, of the voxels that are cut; 0: they are made after the head.
  virtual double voxelOfPart() const = 0;
  virtual std::optional<SurfacePlace> placeAt(const Ray& ray) const = 0;
  // Whether there is material on the way from a place outside.
  virtual bool isMaterialAlong(const Vec3& from, const Vec3& way) const = 0;
  // How far from the surface a place may be that is on it, mm.
  virtual double slack() const = 0;
  // The hole that was drilled last and is still there; null: none.
  virtual const DrillRecord* holeBefore() const = 0;
  virtual std::unique_ptr<DrillSimulation> simulation(const std::optional<DrillFeed>& feed) const = 0;
  virtual std::shared_ptr<const KindPreview> previewOf(const std::shared_ptr<const DrillState>& state) const = 0;
  // Why nothing can be drilled now; English, context "Tool". Null: it can.
  virtual const char* obstacle() const { return nullptr; }
  virtual void refuse() {}  // it was tried all the same
  // A hole was drilled to its end; it is hole() and has this record. restart() is to follow, now or later.
  virtual void take(const DrillSimulation& drilled, std::shared_ptr<const DrillRecord> record) = 0;
  // A hole was begun, and is dropped before its end.
  virtual void drop(const DrillState& hole) { (void)hole; }

  // Ends the hole that is drilled, as if the button was let go.
  ToolReply release();

  // Drops what was begun, and simulates from the present state on.
  void restart();
  void forgetHole() { m_last.reset(); }
  // Whether the hole that is drilled, or else the last one, was begun in holeBefore() and goes on along it.
  bool isContinued() const { return m_isContinued; }
  // What is kept of the hole that is drilled.
  DrillRecord recordOf(const DrillState& hole) const { return {m_begun, hole.poses}; }
  const DrillSettings& drillSettings() const { return m_settings; }
  // What the drill feels and cuts now.
  std::shared_ptr<const DrillState> state() const;
  // "Drill: −28.3 mm³, at most 6.2 N and 31 N·mm"
  static QString textOf(const DrillState& hole);

 private:
  struct Start {
    DrillFeed feed;
    Vec3 place;  // of the head's centre
    bool isContinued = false;
  };

  const char* holdText() const;
  // Where a feed by the mouse begins. None: the pointer is beside the part, or (m_isBlocked) a twist drill would stand
  // in the material with its whole length.
  std::optional<Start> startOfFeed(const PointerEvent& event);
  std::optional<Start> continued(const Vec3& place) const;
  ToolReply press(const PointerEvent& event);

  DrillSettings m_settings;
  bool m_isHeld = false;            // the feed, for now
  std::optional<DrillFeed> m_feed;  // of the present hole; none: by a device
  DrillSetup m_begun;               // that the present hole was begun with
  std::optional<SimulatedGesture> m_gesture;
  std::shared_ptr<const DrillState> m_last;  // of the hole before; null: none
  std::optional<Vec3> m_hovered;             // on the surface,
  Vec3 m_normal = Vec3::UnitZ();             // which is turned so there
  bool m_isContinued = false;
  bool m_isBlocked = false;  // where it was pressed last, a drill has no way in
};

}  // namespace handwheel
