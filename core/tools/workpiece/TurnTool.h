// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "simulation/SimulatedGesture.h"
#include "simulation/turning/RecordedPasses.h"
#include "simulation/turning/TurningSimulation.h"
#include "tools/ToolKey.h"

namespace handwheel {

// Tool that cuts a turning workpiece by hand. While the button is held the round nose of a lathe tool removes what it
// passes: one pass, which is one undo step. The mouse moves it in the plane through the axis that faces the viewer, and
// begins at the surface where it is pressed inside of the part, so that a click alone cuts nothing; a haptic device
// feels the part and moves it anywhere, since the part turns (turning(), source()).
class TurnTool : public Tool {
 public:
  static constexpr double kRate = 250.0;  // steps of the simulation a second

  // What a tool starts with, from the fidelity settings.
  struct Start {
    double spacing = 0.013;  // mm, between the samples of a part that was not cut yet (turn.spacing)
    TurningMethod method = TurningMethod::Trim;    // turn.method
    double resolution = 0.5;                       // mm (turn.resolution)
    double noseRadius = TurningTool().noseRadius;  // mm, that of an exercise
    double largestFeed = 0.0;                      // mm per revolution, that an exercise allows; 0: any
  };
  TurnTool(WorkpieceDocument& document, const SimulationServices& services, const Start& start);

  // What the force source of the tool exchanges with its simulation, for the haptic scene.
  const std::shared_ptr<TurningChannel>& channel() const { return m_channel; }
  TurningTool settingsAtDevice() const { return m_tool; }
  double base() const { return m_document.workpiece().stock.position; }  // mm, z of the lower end

  // The largest feed of the pass that was cut last, where it was above what an exercise allows, mm per revolution.
  std::optional<double> tooFast() const { return m_tooFast; }
  double largestFeed() const { return m_start.largestFeed; }

  // The part as the simulation has it now; never null.
  std::shared_ptr<const TurningState> state() const;

  static std::span<const ToolKey> keys();
  std::string id() const override { return "turn"; }
  std::string recordedName() const override { return recordedTurning(blankPass()); }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  bool isLive() const override { return m_gesture.isOn(); }
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  void documentChanged() override { m_gesture.restart(); }
  std::vector<std::string> needs() const override { return {"simulation"}; }

 private:
  TurningPass blankPass() const;
  std::unique_ptr<Simulation> simulation() const;
  ToolReply press(const PointerEvent& event);
  ToolReply release();
  std::optional<Vec3> placeOf(const PointerEvent& event) const;
  Vec3 wayOut(const Vec3& place) const;
  std::optional<ToolLabel> label() const;
  bool isTooFast(double feed) const { return m_start.largestFeed > 0.0 && feed > 1.01 * m_start.largestFeed; }

  WorkpieceDocument& m_document;
  Start m_start;
  PresentPart m_present;
  TurningTool m_tool;  // stiffness and resistance at the device
  std::shared_ptr<TurningChannel> m_channel = std::make_shared<TurningChannel>();
  SimulatedGesture m_gesture;
  Vec3 m_lift = Vec3::Zero();  // from the mouse to the tool, in its pass
  std::optional<double> m_tooFast;
  std::optional<Vec3> m_place;                               // of the tool's centre, where it is shown
  mutable std::shared_ptr<const TurningState> m_shownState;  // of which the preview shows the part
  mutable std::shared_ptr<const DisplayModel> m_shown;
  mutable PartedBlock m_parted;  // in it
};

}  // namespace handwheel
