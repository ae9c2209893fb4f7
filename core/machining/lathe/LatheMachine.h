// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheSetup.h"

#include <cstdint>

namespace handwheel {

// A command of the operator of a manual lathe. Values that are not finite do nothing.
struct LatheCommand {
  enum class Kind : std::uint8_t {
    Turn,          // the wheel of an axis on by `value` mm of its slide
    Place,         // the tip to r = value, z = other, mm, by the cross slide and the carriage
    Release,       // the hands let go: what was not turned yet is dropped
    Rapid,         // power traverse of an axis: value is -1, 0 or 1
    Spindle,       // its direction: value is -1, 0 or 1
    Speed,         // value r/min
    SurfaceSpeed,  // value m/min at the tip, at most `other` r/min (0: only the largest of the spindle)
    Feed,          // of the carriage or the cross slide: value mm in a turn, negative towards chuck or axis; 0: off
    HalfNut,       // closed for a lead of value mm in a turn, negative towards the chuck; 0: open
    Tool           // slot `value` of the post
  };
  Kind kind = Kind::Release;
  LatheAxis axis = LatheAxis::Carriage;
  double value = 0.0;
  double other = 0.0;

  bool operator==(const LatheCommand&) const = default;
};

// All that moves in a lathe and how its levers stand. Arrays are by LatheAxis; mm.
struct LatheState {
  std::array<double, kLatheAxes> wheels{};   // travel that the wheels were turned for
  std::array<double, kLatheAxes> slides{};   // travel of the slides, which lag by the backlash
  std::array<double, kLatheAxes> demands{};  // what the hands have yet to turn
  std::array<int, kLatheAxes> rapids{};      // -1, 0, 1
  int direction = 0;                         // of the spindle, as its lever stands
  double setSpeed = 600.0;                   // r/min
  double surfaceSpeed = 0.0;                 // m/min; 0: setSpeed holds
  double speedClamp = 0.0;                   // r/min; 0: none
  double speed = 0.0;                        // r/min, signed, as it turns now
  double turns = 0.0;                        // of the spindle so far, signed
  LatheAxis feedAxis = LatheAxis::Carriage;
  double feed = 0.0;         // mm in a turn; 0: off
  double lead = 0.0;         // mm in a turn: of the half-nut; 0: open
  bool isNutClosed = false;  // it has found the screw
  double nutPlace = 0.0;     // mm: travel of the carriage at turn 0, where it is closed
  std::uint32_t tool = 0;    // slot
  double time = 0.0;         // s

  bool operator==(const LatheState&) const = default;
};

// What moved in a step, and why.
struct LatheMotion {
  double turns = 0.0;     // of the spindle, not signed
  bool isRapid = false;   // by the power traverse
  bool isByHand = false;  // by a wheel
};

// The slides, wheels, spindle and levers of a manual lathe, without material. Deterministic: the state is a function of
// the calls.
//
// The half-nut closes where the lead screw lets it: the screw turns with the lead, and its threads pass every
// leadScrewPitch. So a lead that is a part of that pitch always finds the same thread, another one not.
class LatheMachine {
 public:
  // The setup must be sound, and a given state one of this setup.
  LatheMachine(LatheSetup setup, const LatheState& state);
  // At rest, with the first tool beside and before the part.
  static LatheState initialState(const LatheSetup& setup, const StockCylinder& stock);

  const LatheSetup& setup() const { return m_setup; }
  const LatheState& state() const { return m_state; }
  void restore(const LatheState& state) { m_state = state; }

  void apply(const LatheCommand& command);
  // Moves everything by dt (s, > 0). mostByHand: mm that hands can move a slide, and the tool, by in this step. torque:
  // N·m, of the cut at the spindle: what is left of the drive's accelerates it, and what it lacks slows it down.
  LatheMotion advance(double dt, double mostByHand, double torque = 0.0);
  // r/min, signed: what the levers ask for.
  double targetSpeed() const;
  // Spindle at rest, feed and half-nut out, nothing more to turn.
  void stop();

  const LatheSlot& slot() const { return m_setup.stations[m_state.tool]; }
  ProfilePoint tip() const { return tipAt(m_setup, slot(), m_state.slides); }
  double quillTip() const;  // mm: z of the tip of what is in the quill

 private:
  double nextSpeed(double dt, double torque) const;
  double shareOfHands(double most) const;
  void turnWheel(LatheAxis axis, double by);
  void moveSlide(LatheAxis axis, double by);
  void followNut(double before);

  LatheSetup m_setup;
  LatheState m_state;
};

}  // namespace handwheel
