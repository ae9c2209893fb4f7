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

// Tool that cuts a turning workpiece by hand. While the button is held, the round nose of a lathe tool removes the
// material that it passes. This is one pass and one undo step. The mouse moves the nose in the plane through the axis
// that faces the viewer. A pass that begins with a press inside of the part begins at the surface, so a click alone
// cuts nothing. With a haptic device the user feels the part (TurningForce) and can approach it from any side: the part
// turns, so the cut depends only on the distance from the axis and on z.
class TurnTool : public Tool {
 public:
  static constexpr double kRate = 250.0;  // steps of the simulation a second

  // Initial values of a tool, from the fidelity settings.
  struct Start {
    double spacing = 0.013;                        // mm, distance between the samples of an uncut bar (turn.spacing)
    TurningMethod method = TurningMethod::Trim;    // turn.method
    double resolution = 0.5;                       // mm (turn.resolution)
    double noseRadius = TurningTool().noseRadius;  // mm, may be that of an exercise
    double largestFeed = 0.0;                      // mm per revolution, limit of an exercise; 0: no limit
  };
  TurnTool(WorkpieceDocument& document, const SimulationServices& services, const Start& start);

  // The channel between the force source of the tool and its simulation, for the haptic scene.
  const std::shared_ptr<TurningChannel>& channel() const { return m_channel; }
  TurningTool settingsAtDevice() const { return m_tool; }
  double base() const { return m_document.workpiece().stock.position; }  // mm, z of the lower end

  // Returns the largest feed of the last pass if it exceeded the limit of an exercise, mm per revolution.
  std::optional<double> tooFast() const { return m_tooFast; }
  double largestFeed() const { return m_start.largestFeed; }

  // Returns the part in the simulation; never null.
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
  std::optional<Vec3> positionOf(const PointerEvent& event) const;
  Vec3 liftAt(const Vec3& position) const;
  std::optional<ToolLabel> label() const;
  bool isTooFast(double feed) const { return m_start.largestFeed > 0.0 && feed > 1.01 * m_start.largestFeed; }

  WorkpieceDocument& m_document;
  Start m_start;
  PresentPart m_present;
  TurningTool m_tool;  // stiffness and resistance at the device
  std::shared_ptr<TurningChannel> m_channel = std::make_shared<TurningChannel>();
  SimulatedGesture m_gesture;
  Vec3 m_lift = Vec3::Zero();  // displacement from the mouse to the tool during a pass
  std::optional<double> m_tooFast;
  std::optional<Vec3> m_position;                            // displayed position of the tool's centre
  mutable std::shared_ptr<const TurningState> m_shownState;  // the state whose part the preview shows
  mutable std::shared_ptr<const DisplayModel> m_shown;
  mutable PartedBlock m_parted;  // result of showPartedOff() for m_shown
};

}  // namespace handwheel
