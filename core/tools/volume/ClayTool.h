// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeDocument.h"
#include "simulation/SimulatedGesture.h"
#include "tools/ToolKey.h"
#include "tools/ToolProperty.h"
#include "tools/carving/VolumeTool.h"
#include "tools/volume/ClayStamps.h"

namespace handwheel {

// Tool that sculpts a volume like clay. While the button is held, it adds, carves, inflates, smooths, flattens, moves,
// attracts, pinches or masks the material along its path; this is one undo step. The mouse moves the tool over the
// surface as it was when the button was pressed; a haptic device feels the clay and sculpts at its tip.
class ClayTool : public VolumeTool {
 public:
  static constexpr double kRate = 60.0;  // steps of the simulation per second

  // The source of stamps. load: function that asks for a file and adds its stamp, which the setting "stamp" then
  // selects by its index; null: stamps cannot be loaded.
  struct StampServices {
    std::shared_ptr<ClayStamps> stamps = std::make_shared<ClayStamps>();
    std::function<void()> load = {};
  };

  ClayTool(VolumeDocument& document, const SimulationServices& services);
  ClayTool(VolumeDocument& document, const SimulationServices& services, StampServices stamps);

  ClayFeel feelAtDevice() const override;

  // Sets the function that is called when a stroke is refused: the topmost layer accepts no strokes, or the volume is
  // to be drilled.
  void whenRefused(std::function<void()> listener) { m_refused = std::move(listener); }

  static std::span<const ToolKey> keys();
  std::string id() const override { return "clay"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  bool isLive() const override { return m_gesture.isOn(); }
  bool isDue() const override;
  ToolReply resume() override;
  void settle() override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  bool isOfDocument(std::string_view setting) const override { return setting.starts_with("mirror_"); }
  void documentChanged() override { restart(); }
  std::vector<std::string> needs() const override { return {"simulation"}; }

 private:
  // The geometry of a gesture with the mouse.
  struct Grip {
    std::shared_ptr<const VolumeSnapshot> surface;  // surface that the gesture follows
    Vec3 point, across;                             // a point and the normal of the plane in which material is moved
  };

  ClayBrush brushFor(const Modifiers& modifiers) const;
  std::unique_ptr<Simulation> simulation() const;
  std::shared_ptr<const ClayState> state() const;
  double lift(double pressure) const;
  std::optional<Vec3> positionOf(const PointerEvent& event) const;
  // Returns the reason why strokes with a brush have no effect, or null if they have. It is English text, translated in
  // the context "Tool".
  const char* obstacle(const ClayBrush& brush) const;
  ToolReply press(const PointerEvent& event);
  ToolReply release();
  void complete();
  void restart();
  void feed(const Vec3& position, const PointerEvent& event);
  void hover(const PointerEvent& event);
  Limits radiusLimits() const;
  void invertMask();
  void setMask(const char* text, std::shared_ptr<const ClayMask> mask);

  VolumeDocument& m_document;
  ClayBrush m_brush;    // brush according to the settings
  ClayBrush m_present;  // brush of the gesture, with the modifier keys that are held
  double m_resistance = 0.05;
  StampServices m_stamps;
  std::size_t m_stamp = 0;  // index of the stamp
  SimulatedGesture m_gesture;
  // State of a gesture that ends. m_isEnding: the simulation is applying the rest of the stroke, and events of the hand
  // wait. m_isClosed: the simulation was told of the end.
  bool m_isEnding = false, m_isClosed = false;
  std::vector<PointerEvent> m_waiting;
  std::optional<Grip> m_grip;
  std::function<void()> m_refused;
  std::optional<Vec3> m_hovered;  // hovered point on the surface
};

}  // namespace handwheel
