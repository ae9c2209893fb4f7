// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheSetup.h"

#include <cstdint>

namespace handwheel {

// A command of the operator of a manual lathe. Values that are not finite do nothing.
struct LatheCommand {
  enum class Kind : std::uint8_t {
    Turn,          // turns the wheel of an axis by `value` mm of its slide
    MoveTip,       // moves the tip to r = value, z = other, mm, by the cross slide and the carriage
    Release,       // the hands let go: the rest of their motion is dropped
    Rapid,         // power traverse of an axis: value is -1, 0 or 1
    Spindle,       // direction: value is -1, 0 or 1
    Speed,         // value r/min
    SurfaceSpeed,  // value m/min at the tip, at most `other` r/min (0: only the limit of the spindle)
    Feed,     // feed of the carriage or the cross slide: value mm in a turn, negative towards chuck or axis; 0: off
    HalfNut,  // closes the half-nut for a lead of value mm in a turn, negative towards the chuck; 0: open
    Tool      // selects slot `value` of the post
  };
  Kind kind = Kind::Release;
  LatheAxis axis = LatheAxis::Carriage;
  double value = 0.0;
  double other = 0.0;

  bool operator==(const LatheCommand&) const = default;
};

// The state of all moving parts and levers of a lathe. Arrays are by LatheAxis; mm.
struct LatheState {
  std::array<double, kLatheAxes> wheels{};   // travel of the wheels
  std::array<double, kLatheAxes> slides{};   // travel of the slides, which lag by the backlash
  std::array<double, kLatheAxes> demands{};  // travel that the hands have yet to make
  std::array<int, kLatheAxes> rapids{};      // -1, 0, 1
  int direction = 0;                         // direction of the spindle lever
  double setSpeed = 600.0;                   // r/min
  double surfaceSpeed = 0.0;                 // m/min; 0: setSpeed is used
  double speedClamp = 0.0;                   // r/min; 0: none
  double speed = 0.0;                        // r/min, signed; actual speed
  double turns = 0.0;                        // spindle revolutions so far, signed
  LatheAxis feedAxis = LatheAxis::Carriage;
  double feed = 0.0;         // mm in a turn; 0: off
  double lead = 0.0;         // mm in a turn; lead of the half-nut; 0: open
  bool isNutClosed = false;  // the half-nut has engaged the screw
  double nutPosition = 0.0;  // mm: travel of the carriage at turn 0, where it is closed
  std::uint32_t tool = 0;    // slot
  double time = 0.0;         // s

  bool operator==(const LatheState&) const = default;
};

// The motion of a step and its cause.
struct LatheMotion {
  double turns = 0.0;     // spindle revolutions, not signed
  bool isRapid = false;   // moved by the power traverse
  bool isByHand = false;  // moved by a wheel
};

// The slides, wheels, spindle and levers of a manual lathe, without material. Deterministic: the state is a function of
// the calls.
//
// The half-nut closes only where it meets the lead screw: the screw turns with the lead, and its threads pass every
// leadScrewPitch. So a lead that divides that pitch always finds the same thread, another lead does not.
class LatheMachine {
 public:
  // The setup must be sound, and the state must belong to this setup.
  LatheMachine(LatheSetup setup, const LatheState& state);
  // Returns a machine at rest, with the first tool beside and in front of the part.
  static LatheState initialState(const LatheSetup& setup, const StockCylinder& stock);

  const LatheSetup& setup() const { return m_setup; }
  const LatheState& state() const { return m_state; }
  void restore(const LatheState& state) { m_state = state; }

  void apply(const LatheCommand& command);
  // Moves everything by dt (s, > 0). mostByHand: mm, largest travel of a slide, and of the tool, that hands can make in
  // this step. torque: N·m of the cut at the spindle: the excess of the drive accelerates the spindle, a deficit slows
  // it down.
  LatheMotion advance(double dt, double mostByHand, double torque = 0.0);
  // r/min, signed; speed that the levers ask for
  double targetSpeed() const;
  // Stops the spindle, disengages feed and half-nut, and drops the pending travel.
  void stop();

  const LatheSlot& slot() const { return m_setup.stations[m_state.tool]; }
  ProfilePoint tip() const { return tipAt(m_setup, slot(), m_state.slides); }
  double quillTip() const;  // mm; z of the tip of the fitting in the quill

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
