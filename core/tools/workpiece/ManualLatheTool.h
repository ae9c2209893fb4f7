// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/LatheDisplay.h"
#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/exercise/AssignedTask.h"
#include "machining/TurningFidelity.h"
#include "machining/lathe/LatheMounting.h"
#include "simulation/SimulatedGesture.h"
#include "simulation/turning/LatheSimulation.h"
#include "tools/ToolKey.h"
#include "tools/UnfinishedGesture.h"
#include "tools/workpiece/LatheStates.h"

namespace handwheel {

// Tool that works a part on a manual lathe. Keys and commands turn the handwheels and work the levers; the mouse drags
// the cutting tool in the plane through the axis, or a haptic device holds it. All cuts until the cutting tool has been
// clear of the part for kIdle, or until this tool ends, are one undo step. Undo stops the slides, and takes a cutting
// tool out of material that comes back. A crash stops the lathe, is listed, and is recorded in the document at once;
// undo does not remove the crash.
class ManualLatheTool : public Tool, public UnfinishedGesture {
 public:
  static constexpr double kIdle = 0.8;  // s

  // The state of a lathe when its tool ended, for the next start.
  struct Left {
    LatheSetup setup;
    LatheState state;         // state with all levers off
    bool wasTurning = false;  // true: the spindle was turning until then
  };

  // Initial values, from the settings turn.spacing, turn.force_model and turn.step.
  struct Start {
    double spacing = 0.0;  // mm, distance between the samples of an uncut bar
    ForceLaw law = ForceLaw::Kienzle;
    double step = turnStepSetting().standard;  // ms, step of the simulation
    WorkLimits limits;                         // limits of the exercise
    // State of the lathe at the end of the previous tool for this document, updated at the end of this one; null: the
    // initial state.
    std::shared_ptr<std::optional<Left>> left{};
  };

  ManualLatheTool(WorkpieceDocument& document, const SimulationServices& services, LatheTools tools,
                  const Start& start);
  ~ManualLatheTool() override;

  const std::shared_ptr<LatheChannel>& channel() const { return m_channel; }
  double base() const { return m_document.workpiece().stock.position; }  // mm, z of the part's lower end
  const LatheTools& tools() const { return m_tools; }
  const WorkLimits& limits() const { return m_limits; }  // limits of the exercise
  // Returns the material of the part; never null. The material changes when the document names another material.
  const std::shared_ptr<const LatheMaterial>& material() const { return m_material; }
  LatheSetup setup() const { return latheOf(m_document.workpiece()); }

  // Returns true if the tool began with all slides and wheels as they were left.
  bool isWhereLeft() const { return m_isWhereLeft; }

  // Returns the present state; never null.
  std::shared_ptr<const LatheMoment> moment() const;
  // Returns all crashes since the tool began, in order.
  std::vector<LatheCollision> collisions() const;
  // Returns all warnings since the tool began, in order.
  std::vector<LatheWarning> warnings() const;
  // Returns the zero of the Z of crashes, mm above the lower end of the bar. It is shownZero() of the document.
  double eventsZero() const;
  // Returns the values of the read-out: X as diameter or radius, by the setup, and Z; mm.
  ProfilePoint readout() const;
  // Returns whether the tool in use was touched off, in X and in Z; the read-out is meaningless until then.
  std::array<bool, 2> isTouchedOff() const;

  // Returns the number of times that the tool was taken out of material that undo or redo brought back.
  int returnCount() const { return m_returns; }

  // Returns the roughness Ra of the part at the tip, µm. Returns nothing if it is not known or if there is no part. For
  // a file, abrasive paper or disk, it is the roughness at the middle of its width.
  std::optional<double> roughnessHere() const;

  // Executes a command of a lever or a wheel.
  void command(const LatheCommand& command);
  // Ends the power traverse that an action began, for example when its key is released.
  void stopRapids();
  // Returns the distance from the tip to the face to touch off at, mm: in X to the nearest radius of the work, in Z to
  // the nearest face, anywhere along the work, since a turner draws the tool away along the other axis before
  // measuring.
  double touchGap(bool isX) const;
  // Returns the value of X or Z of the surface that touchGap() measures to, as the read-out shows it, X as diameter or
  // radius, mm. Z counts from the zero that a tool of the lathe was touched off for, or else from that of the target.
  // Returns nothing if the part has no surface, or Z no zero.
  std::optional<double> touchedSize(bool isX) const;
  // Returns true if the tip is at the free end of the work, where a zero for the whole work may begin.
  bool touchesEnd() const;
  static constexpr double kTouching = 0.05;  // mm, touchGap() that counts as touching: about the thickness of paper
  // Touches off by setting the read-out of the tool in use to a value, X as diameter or radius. This is one undo step.
  void touchOff(bool isX, double value);
  // Mounts a tool on a side of the post, or a drill in the tailstock; an empty id takes the tool off. This is one undo
  // step. Returns the reason for a refusal, or nothing.
  std::optional<MountRefusal> mount(std::size_t station, const std::string& id);
  // Replaces the setup of the lathe as one undo step. Returns false, without a change, if the setup is impossible.
  bool setUp(const LatheSetup& setup, const QString& text);
  // Records crashes, and ends the pass if the tool has been clear for kIdle or if isAtOnce is true. Returns true if
  // there was a pass. It has to be called as soon as hasToCommit() is true.
  bool endPass(bool isAtOnce = false);
  bool hasToCommit() const;

  static std::span<const ToolKey> keys();
  std::string id() const override { return "lathe"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  ToolReply undo() override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  bool isLive() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  bool remembersSettings() const override { return false; }
  void settle() override;
  SnapshotPointer withGesture() override;
  QString underWay() const override;
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"simulation"}; }

 private:
  std::unique_ptr<Simulation> simulation() const;
  LatheSlot slotInUse() const;
  void renewMaterial();
  void turn(LatheAxis axis, double divisions);
  void stop();
  std::optional<double> touchedRadius(const LatheMoment& now) const;
  std::optional<double> zeroOfZ() const;
  std::optional<Vec3> positionOf(const PointerEvent& event) const;
  ToolReply press(const PointerEvent& event);
  ToolReply release(bool isDevice);
  std::unique_ptr<LatheSimulation> endSimulation();
  bool isDue(const LatheMoment& now) const;
  std::shared_ptr<const TurnedPart> partWith(const LatheSimulation& lathe) const;
  void commitPasses(const LatheSimulation& lathe);
  void recordCrashes(const LatheMoment& moment);
  void showLathe(const LatheSetup& setup);
  void follow(const LatheSetup& setup);
  std::optional<LatheState> whereLeft() const;
  std::optional<LatheState> drawnBack(const LatheSetup& setup, LatheState state) const;

  WorkpieceDocument& m_document;
  PresentPart m_present;
  LatheTools m_tools;
  ForceLaw m_law;
  WorkLimits m_limits;
  std::shared_ptr<std::optional<Left>> m_left;  // null: the state is not kept
  std::string m_materialName;                   // name of m_material in the document
  std::shared_ptr<const LatheMaterial> m_material;
  std::shared_ptr<LatheChannel> m_channel = std::make_shared<LatheChannel>();
  std::shared_ptr<const TurnedPart> m_part;  // part of the document; null: nothing was cut yet
  LatheStates m_states;
  std::optional<LatheState> m_machine;  // state for the next simulation; none: the initial one
  bool m_isWhereLeft;
  std::vector<LatheCollision> m_collisions;  // crashes of previous simulations
  std::vector<LatheWarning> m_warnings;      // warnings of previous simulations
  std::size_t m_recorded = 0;                // number of crashes of this simulation that the document has
  int m_returns = 0;
  bool m_isCommitting = false;
  bool m_isDragging = false;  // true: the mouse drags the tool
  bool m_isRapid = false;     // true: an action began a power traverse
  bool m_showsChips = true;
  Vec3 m_grab = Vec3::Zero();  // displacement from the mouse to the tip during a drag
  std::shared_ptr<const LatheDisplay> m_display;
  std::shared_ptr<const LatheSetup> m_displayed;  // the setup that m_display shows
  mutable PartedBlock m_parted;                   // result of showPartedOff() for the shown part
  SimulatedGesture m_gesture;
};

}  // namespace handwheel
