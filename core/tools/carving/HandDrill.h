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
// upright on it), or along the view with Shift, from the press position until the button is released, in pecks if the
// settings say so; a key stops the feed. A device drills as the hand moves. Thrust, torque and work are shown during
// drilling. Derived classes define the material and what happens to the hole.
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

  // Returns the hole being drilled, or else the previous hole. Returns null if there is no hole.
  std::shared_ptr<const DrillState> hole() const { return m_gesture->isOn() ? state() : m_last; }
  virtual DrillSetup setup() const { return m_settings.setup(); }
  // Returns true if the part is work on an exercise, whose task chooses the drill.
  virtual bool isWorkOnExercise() const { return false; }

 protected:
  struct SurfaceHit {
    Vec3 point;   // mm
    Vec3 normal;  // outward unit normal
  };

  explicit HandDrill(const DrillSettings& settings) : m_settings(settings) {}
  // Starts the simulation. The constructor of a derived class must call it once, when the virtual functions of that
  // class can be called.
  void begin(const SimulationServices& services);

  // Returns the size of the voxels to be cut, mm; 0: the voxels are chosen for the head.
  virtual double voxelOfPart() const = 0;
  // Returns the first point of the surface on a ray. Returns nothing if the ray misses the part.
  virtual std::optional<SurfaceHit> hitAt(const Ray& ray) const = 0;
  // Returns true if there is material along a displacement from a point outside of the part.
  virtual bool isMaterialAlong(const Vec3& from, const Vec3& displacement) const = 0;
  // Returns the largest distance from the surface at which a point counts as on it, mm.
  virtual double slack() const = 0;
  // Returns the record of the last hole that the part still has. Returns null if there is no such hole.
  virtual const DrillRecord* holeBefore() const = 0;
  virtual std::unique_ptr<DrillSimulation> simulation(const std::optional<DrillFeed>& feed) const = 0;
  virtual std::shared_ptr<const KindPreview> previewOf(const std::shared_ptr<const DrillState>& state) const = 0;
  // Returns the reason why drilling is impossible at present, as an English text that is translated in the context
  // "Tool". Returns null if drilling is possible.
  virtual const char* obstacle() const { return nullptr; }
  virtual void refuse() {}  // is called when the user presses in spite of an obstacle
  // Takes a finished hole, which is hole(), with its record. The implementation must call restart(), at once or later.
  virtual void take(const DrillSimulation& drilled, std::shared_ptr<const DrillRecord> record) = 0;
  // Handles a hole that was dropped before its end.
  virtual void drop(const DrillState& hole) { (void)hole; }

  // Ends the hole being drilled, as if the button were released.
  ToolReply release();

  // Drops the hole being drilled, and simulates from the present state of the document.
  void restart();
  void forgetHole() { m_last.reset(); }
  // Returns true if the hole being drilled, or else the last one, was begun in holeBefore() and continues along it.
  bool isContinued() const { return m_isContinued; }
  // Returns the record of the hole being drilled.
  DrillRecord recordOf(const DrillState& hole) const { return {m_begun, hole.poses}; }
  const DrillSettings& drillSettings() const { return m_settings; }
  // Returns the present state of the simulation.
  std::shared_ptr<const DrillState> state() const;
  // Returns a hole as text: "Drill: −28.3 mm³, at most 6.2 N and 31 N·mm".
  static QString textOf(const DrillState& hole);

 private:
  struct Start {
    DrillFeed feed;
    Vec3 position;  // position of the head's centre
    bool isContinued = false;
  };

  const char* holdText() const;
  // Returns the start of a feed by the mouse. Returns nothing if the pointer is beside the part, or if material
  // obstructs the length of a twist drill, in which case m_isBlocked becomes true.
  std::optional<Start> startOfFeed(const PointerEvent& event);
  std::optional<Start> continued(const Vec3& position) const;
  ToolReply press(const PointerEvent& event);

  DrillSettings m_settings;
  bool m_isHeld = false;            // true: the feed is paused
  std::optional<DrillFeed> m_feed;  // feed of the present hole; none: a device feeds it
  DrillSetup m_begun;               // setup at the start of the present hole
  std::optional<SimulatedGesture> m_gesture;
  std::shared_ptr<const DrillState> m_last;  // the previous hole; null: none
  std::optional<Vec3> m_hovered;             // point of the surface under the mouse
  Vec3 m_normal = Vec3::UnitZ();             // direction away from the material at m_hovered
  bool m_isContinued = false;
  bool m_isBlocked = false;  // true: a drill cannot enter at the last press position
};

}  // namespace handwheel
