// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedSurface.h"
#include "machining/TurningPass.h"
#include "machining/finish/FinishMeter.h"
#include "machining/lathe/LatheRun.h"
#include "simulation/Simulation.h"
#include "simulation/turning/TurningContact.h"

namespace handwheel {

// The tool position and the cut of a lathe for the servo loop.
struct LathePatch {
  ProfilePoint tip{0.0, 0.0};       // (r, z)
  ProfilePoint velocity{0.0, 0.0};  // mm/s
  double time = 0.0;                // s, time of the input from which the patch results
  CutConditions cut;                // depth 0: nothing is cut
  ProfilePoint passive{1.0, 0.0};   // direction of the radial force on the tool, as in LatheLoad
  ProfilePoint press{0.0, 0.0};     // N, force on an abrasive, in (r, z)
  double rub = 0.0;                 // N, friction on an abrasive along the motion of the surface
  double wear = 0.0;                // mm, flank wear
  std::uint32_t tool = 0;           // index of the cutting tool in the list of tools
  double spindleSpeed = 0.0;        // r/min, signed
  double angle = 0.0;               // revolutions of the spindle
  std::uint32_t gesture = 0;        // number of the gesture in which the hand holds the tool; 0: it does not
  Vec3 grip = Vec3::Zero();         // mm, displacement from the hand to the tip while it holds the tool
  ProfilePatch part;                // the part near the hand, with threads if it does not turn
};

// The data that a lathe exchanges with the servo loop and the window. None of the three threads waits for another.
struct LatheChannel : SimulationChannel<LathePatch> {
  static constexpr std::size_t kWaiting = 4096;
  SpscRing<LatheCommand> commands{kWaiting};  // commands from the window
};

// A lathe with its part at one moment of the simulation.
struct LatheMoment : SimulationState {
  LatheMoment(TurnedProfile p, TurnedSurface s) : profile(std::move(p)), surface(std::move(s)) {}
  TurnedProfile profile;
  TurnedSurface surface;
  SurfaceFinish finish;  // finish of the profile
  LatheState machine;
  std::shared_ptr<const LatheTool> tool;  // tool in use; null: none
  ProfilePoint tip{0.0, 0.0};             // mm, true position of the tip
  double quillTip = 0.0;                  // mm, z of the tip of the fitting in the tailstock's quill
  LatheLoad load;                         // load of the cut
  bool isCut = false;                     // true: material was removed since the simulation began
  double sinceCut = 0.0;                  // s, time since material was last removed
  bool isFull = false;                    // true: the recording is full, and the pass has to end
  bool isHeld = false;                    // true: a crash, a limit or the part stopped the last motion
  double removed = 0.0;                   // mm³, material removed since the simulation began
  std::shared_ptr<const std::vector<LatheCollision>> collisions;  // never null
  std::shared_ptr<const std::vector<LatheWarning>> warnings;      // never null
};

// The simulation of a manual lathe. Commands of the window and the hand at a device move the lathe, and the tool
// removes material. All cuts since the simulation began form one pass for each tool.
class LatheSimulation : public Simulation {
 public:
  static constexpr double kShownRate = 125.0;  // Hz, largest rate at which the shown part changes
  static constexpr double kThreadRate = 25.0;  // Hz, largest rate for threads, whose triangles take some milliseconds
  static constexpr double kFinger = 0.5;       // mm, radius of the probe that feels the part while no tool is held

  // base: z of the part's lower end in the scene, mm. The channel may have only one simulation at a time. finish: the
  // finish of the part; passesBefore: the number of earlier passes of the part.
  LatheSimulation(LatheRun run, TurnedSurface surface, double base, std::shared_ptr<LatheChannel> channel,
                  SurfaceFinish finish = SurfaceFinish(), std::size_t passesBefore = 0);

  // Advances the lathe by a step. A device takes the tool where it is, and moves it during its gesture by as much as
  // the hand moves along the plane through the axis; it lets go of the tool when the gesture ends.
  void step(double dt, std::span<const SimulationInput> inputs) override;
  std::shared_ptr<const SimulationState> state() const override { return m_state; }

  // Updates the state with all that was cut. It has to be called after the last step.
  void finish();
  const std::vector<TurningPass>& passes() const { return m_passes; }
  const LatheRun& run() const { return m_run; }

 private:
  void takeCommands(std::span<const SimulationInput> inputs);
  ProfilePoint handAt(const SimulationInput& input) const;
  void record(const LatheStep& step, double dt);
  ProfilePatch patchAt(const SimulationInput& input) const;
  TurnedProfile::Range samplesBeside(const LatheStep& step) const;
  void publish();

  LatheRun m_run;
  TurnedSurface m_surface;
  double m_base;
  std::shared_ptr<LatheChannel> m_channel;
  std::vector<LatheCommand> m_commands;
  std::vector<TurningPass> m_passes;
  FinishMeter m_finish;
  std::size_t m_passesBefore;
  double m_begin = 0.0;  // s, time of the first point of the last pass
  TurnedProfile::Range m_changed;
  TurnedProfile::Range m_threaded;  // range whose triangles lack the last part of a thread
  std::size_t m_shownPasses = 0;    // number of passes whose threads are fully shown
  double m_sincePublished = 0.0;    // s
  double m_sinceThreaded = 0.0;     // s, time since the threads were shown
  std::uint32_t m_gesture = 0;      // gesture in which a device holds the tool; 0: none
  ProfilePoint m_grip{0.0, 0.0};    // mm, displacement from the hand to the tip in this gesture
  ProfilePatch m_part;              // patch of the last input
  std::uint32_t m_number;           // number of this simulation in the channel
  std::uint64_t m_warned = 0;       // number of changes of the warnings in m_now
  LatheMoment m_now;
  std::shared_ptr<const LatheMoment> m_state;
};

}  // namespace handwheel
