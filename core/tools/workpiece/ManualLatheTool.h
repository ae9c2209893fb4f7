// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/LatheDisplay.h"
#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "machining/TurningFidelity.h"
#include "machining/lathe/LatheMounting.h"
#include "simulation/SimulatedGesture.h"
#include "simulation/turning/LatheSimulation.h"
#include "tools/ToolKey.h"
#include "tools/UnfinishedGesture.h"
#include "tools/workpiece/LatheStates.h"

namespace handwheel {

// Tool that works a part on a manual lathe. Keys and commands turn the handwheels and work the levers; the mouse drags
// the tool in the plane through the axis, a haptic device holds it. What is cut until the tool has been clear for
// kIdle, or the tool ends, is one undo step; undo stops the slides, and
// takes a tool out of the material that comes back. A crash stops the
// lathe, is listed, and recorded in the document at once; no undo takes it back.
class ManualLatheTool : public Tool, public UnfinishedGesture {
 public:
  static constexpr double kIdle = 0.8;  // s

  // A lathe that was left, for when it is used again.
  struct Left {
    LatheSetup setup;
    LatheState state;         // with all levers off
    bool wasTurning = false;  // its spindle, until then
  };

  // What it begins with, by the settings turn.spacing, turn.force_model and turn.step.
  struct Start {
    double spacing = 0.0;  // mm between the samples of a part that was not cut yet
    ForceLaw law = ForceLaw::Kienzle;
    double step = turnStepSetting().standard;  // ms, of the simulation
    double forceLimit = 0.0;                   // N, that the work may take; 0: any
    // Where the slides of this document were left, and are left again at the end; null: at the beginning.
    std::shared_ptr<std::optional<Left>> left{};
  };

  ManualLatheTool(WorkpieceDocument& document, const SimulationServices& services, LatheTools tools,
                  const Start& start);
  ~ManualLatheTool() override;

  const std::shared_ptr<LatheChannel>& channel() const { return m_channel; }
  double base() const { return m_document.workpiece().stock.position; }  // mm, z of the part's lower end
  const LatheTools& tools() const { return m_tools; }
  double forceLimit() const { return m_forceLimit; }  // N, of the exercise that it is worked on for; 0: none
  // What the part is made of; never null, and another one when the document says another material.
  const std::shared_ptr<const LatheMaterial>& material() const { return m_material; }
  LatheSetup setup() const { return latheOf(m_document.workpiece()); }

  // Whether it began where the lathe was left: all slides and wheels are as they were.
  bool isWhereLeft() const { return m_isWhereLeft; }

  // The lathe now; never null.
  std::shared_ptr<const LatheMoment> moment() const;
  // All crashes since the tool began, in order.
  std::vector<LatheCollision> collisions() const;
  // All warnings, likewise.
  std::vector<LatheWarning> warnings() const;
  // From where crashes tell their Z, mm above the lower end of the bar: shownZero() of the document.
  double eventsZero() const;
  // What the read-out shows: X as diameter or radius, as the setup has it, and Z; mm.
  ProfilePoint readout() const;
  // Whether the tool in use was touched off, in X and in Z: before that the read-out means nothing.
  std::array<bool, 2> isTouchedOff() const;

  // How often the tool had to be taken out of material that undo or redo brought back.
  int returnCount() const { return m_returns; }

  // The roughness Ra of the part where the tip is, µm; none: it is not known, or there is no part. Of a file, paper or
  // disk: at the middle of its width.
  std::optional<double> roughnessHere() const;

  // Works a lever or a wheel.
  void command(const LatheCommand& command);
  // Ends the power traverse that an action began, as when its key is released.
  void stopRapids();
  // mm from the tip to what one touches off at: of X to the nearest radius of the work, of Z to the nearest face,
  // wherever along the work these are, since a turner draws the tool away along the other axis before measuring.
  double touchGap(bool isX) const;
  static constexpr double kTouching = 0.05;  // mm, of that: a sheet of paper is between them
  // Touches off: the read-out shows this value for the tool in use, X as diameter or radius; one undo step.
  void touchOff(bool isX, double value);
  // Mounts a tool on a side of the post, or a drill in the tailstock; an empty id takes the tool off. One undo step.
  // Returns why it was not done.
  std::optional<MountRefusal> mount(std::size_t station, const std::string& id);
  // Sets the lathe up anew; one undo step. False: such a setup is impossible, and nothing was changed.
  bool setUp(const LatheSetup& setup, const QString& text);
  // Records crashes, and ends the pass if the tool has been clear for kIdle, or at once. Returns whether there was one.
  // To be called as soon as hasToCommit() says so.
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
  std::optional<Vec3> placeOf(const PointerEvent& event) const;
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
  double m_forceLimit;
  std::shared_ptr<std::optional<Left>> m_left;  // null: nobody keeps it
  std::string m_materialName;                   // as the document says it, of m_material
  std::shared_ptr<const LatheMaterial> m_material;
  std::shared_ptr<LatheChannel> m_channel = std::make_shared<LatheChannel>();
  std::shared_ptr<const TurnedPart> m_part;  // of the document; null: nothing was cut yet
  LatheStates m_places;
  std::optional<LatheState> m_machine;  // with which the next simulation begins; none: at the beginning
  bool m_isWhereLeft;
  std::vector<LatheCollision> m_collisions;  // of simulations before
  std::vector<LatheWarning> m_warnings;      // likewise
  std::size_t m_recorded = 0;                // crashes of this simulation that the document has
  int m_returns = 0;
  bool m_isCommitting = false;
  bool m_isDragging = false;  // by the mouse
  bool m_isRapid = false;     // an action began a power traverse
  bool m_showsChips = true;
  Vec3 m_grab = Vec3::Zero();  // from the mouse to the tip, in its drag
  std::shared_ptr<const LatheDisplay> m_display;
  std::shared_ptr<const LatheSetup> m_displayed;  // the setup that m_display is of
  mutable PartedBlock m_parted;                   // in the part that the preview shows
  SimulatedGesture m_gesture;
};

}  // namespace handwheel
