// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/lathe/CutMeter.h"
#include "machining/lathe/LatheCollisions.h"
#include "machining/lathe/LatheMaterial.h"
#include "machining/lathe/LatheWarnings.h"
#include "machining/lathe/ThreadsBeingCut.h"
#include "machining/lathe/WorkBeam.h"

#include <span>

namespace handwheel {

// The result of one step of a lathe.
struct LatheStep {
  RemovedMaterial cut;                        // the removed material; for a thread, the growth of the groove
  double edge = 0.0;                          // mm, length of the edge that cut a thread
  std::shared_ptr<const LatheTool> tool;      // the tool that moved; null: no tool was in use
  ProfilePoint from{0.0, 0.0}, to{0.0, 0.0};  // mm, (r, z); start and end of the tip's cutting travel
  double turns = 0.0;                         // spindle revolutions, not signed
  std::optional<ThreadCut> thread;  // the thread, if the half-nut leads a threading tool; the profile does not change
  double time = 0.0;                // s, clock of the machine after the step
  bool isCrash = false;             // the last entry of LatheRun::collisions() is from this step
  bool isRing = false;  // the nut was opened and the tool stayed in: the end of the groove is now a full circle
  bool isHeld = false;  // the slide was held back by the depth limit, the work, or the force of a hand

  bool hasMoved() const { return from != to; }
  bool cutsThread() const { return thread && cut.depth > 0.0; }
  // Return the depth across the path of the tool (mm) and the feed (mm per turn); both are 0 if nothing was cut.
  double depthOfCut() const;
  double feed() const;
};

// A simulated manual lathe with a part, moved step by step by commands. Tools remove material, and crashes stop the
// lathe. A step that would be a crash is not made: the slides stay where they were, the spindle stops, and the crash is
// recorded. Drawing the tool back after a crash is not another crash. File, paper and disk are pressed on the work no
// harder than a hand or their slide can press. A cut loads the spindle. If the torque of the drive is too small, the
// spindle slows down; if it stalls, that is a crash. A cut also bends the work, which yields and is left thicker.
// Workshop rules that a cut breaks are recorded as warnings. The simulation is deterministic: the state is a function
// of the calls.
class LatheRun {
 public:
  static constexpr double kTouch = TurningPass::kTouch;
  static constexpr double kAtRest = 1.0;                // r/min; a slower spindle cuts nothing
  static constexpr std::size_t kMostCollisions = 1000;  // largest number of recorded crashes
  static constexpr double kJudged = 0.1;                // s between two evaluations of the workshop rules

  // The setup must be sound. tools: the tools that the setup names; a slot whose tool is missing is empty. material:
  // the material of the part, with the laws of these tools in the same order; null: there are no forces. threads: the
  // threads of the part; null: none.
  LatheRun(LatheSetup setup, LatheTools tools, TurnedProfile profile, const LatheState& state,
           std::shared_ptr<const LatheMaterial> material = nullptr,
           std::shared_ptr<const PartThreads> threads = nullptr);

  LatheStep step(double dt, std::span<const LatheCommand> commands);

  const TurnedProfile& profile() const { return m_profile; }
  const LatheMachine& machine() const { return m_machine; }
  const std::vector<LatheCollision>& collisions() const { return m_collisions; }
  const std::shared_ptr<const LatheMaterial>& material() const { return m_material; }  // may be null
  const LatheLoad& load() const { return m_load; }                                     // load of the last step
  double sinceCut() const { return m_meter.sinceCut(); }  // s, time since material was last removed
  const LatheWarnings& warnings() const { return m_warnings; }
  std::shared_ptr<const LatheTool> tool() const;  // tool of the slot in use; null: none
  // Returns the index of the tool that cut last; the number of tools if none has cut.
  std::size_t cuttingTool() const { return indexOf(m_lastTool.get()); }
  // Returns true if no tool is in the work, the chuck or the tailstock at the present slide positions. Only then can
  // the slides move.
  bool isClear() const;
  double gripped() const { return m_gripped; }  // mm, radius that the jaws are closed on

 private:
  struct Try;
  Try attempt(const LatheState& before, double dt, double mostByHand);
  std::optional<LatheCollision> crashOf(const Try& tried) const;
  std::optional<LatheCollision> cutCrash(const Try& tried) const;
  double depthAt(const LatheTool& tool, const ProfilePoint& at) const;
  bool isDrawnStraight(const Try& tried) const;
  bool isDrawnOut(const Try& tried) const;
  bool isAwayFromChuck(const Try& tried, const std::vector<LatheSolid>& solids) const;
  bool holdPressed(Try& tried, const LatheState& before);
  std::size_t indexOf(const LatheTool* tool) const;
  std::shared_ptr<const LatheTool> drill() const;
  void crash(LatheStep& step, LatheCollision collision, const LatheState& before);
  bool leavesThread(const Try& tried) const;
  void meetThreads(Try& tried) const;
  void cut(LatheStep& step, const Try& tried);
  LatheStep move(double dt, std::span<const LatheCommand> commands);
  void measure(const LatheStep& step, double dt);
  void press(LatheLoad& load, const ProfilePoint& velocity);
  void judge();
  double heightPressed(const Try& tried) const;
  SlenderWork beamAtCut();
  std::optional<CutConditions> cutAhead(const Try& tried) const;
  double yielding(const Try& tried);
  bool isStalled(double speedBefore) const;
  std::optional<ThreadCut> threadOf(const Try& tried) const;

  LatheMachine m_machine;
  LatheTools m_tools;
  std::vector<std::vector<LatheSolid>> m_solids;  // sections of each of m_tools
  TurnedProfile m_profile;
  ThreadsBeingCut m_threads;
  bool m_isInThread = false;  // the tool is in the groove that it has cut last
  double m_gripped = 0.0;
  double m_within = 0.0;  // mm; largest distance of material from the axis
  std::vector<LatheSolid> m_chuck;
  std::vector<LatheCollision> m_collisions;
  bool m_isBlocked = false;  // the last move was a crash, which is recorded once
  // The tool that cut last, and its position (mm). An abrasive tool yields, so it is not at the position of its slide.
  std::shared_ptr<const LatheTool> m_lastTool;
  ProfilePoint m_lastPosition{0.0, 0.0};
  double m_pressed = 0.0;  // mm; z at which the last cut presses on the work
  std::shared_ptr<const LatheMaterial> m_material;
  CutMeter m_meter;
  LatheLoad m_load;
  LatheWarnings m_warnings;
  ProfilePoint m_tip{0.0, 0.0};    // mm, position of the tip after the last step
  double m_sinceJudged = kJudged;  // s, time since the workshop rules were last evaluated
  WorkBeam m_beam;
  double m_thrust = 0.0;             // N, force of the tool on the work, towards the axis
  std::optional<double> m_balanced;  // N, thrust to which the work yielded in the last step; none: not found
  double m_chatter = 0.0;            // strength of chatter, 0 to 1 as in LatheLoad
};

}  // namespace handwheel
