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
    Release,       // the hands let go of the wheels: the rest of their motion is dropped
    Rapid,         // power traverse of an axis: value is -1, 0 or 1
    Spindle,       // direction of the spindle: value is -1, 0 or 1
    Speed,         // spindle speed: value r/min
    SurfaceSpeed,  // value m/min at the tip, at most `other` r/min (0: limit of the spindle)
    Feed,          // feed of carriage or cross slide: value mm per turn, negative towards chuck or axis; 0: off
    HalfNut,       // closes the half-nut: lead of value mm per turn, negative towards the chuck; 0: open
    Tool           // selects slot `value` of the post
  };
  Kind kind = Kind::Release;
  LatheAxis axis = LatheAxis::Carriage;
  double value = 0.0;
  double other = 0.0;

  bool operator==(const LatheCommand&) const = default;
};

// The state of all moving parts and levers of a lathe. Arrays are indexed by LatheAxis and are in mm.
struct LatheState {
  std::array<double, kLatheAxes> wheels{};   // travel of the wheels
  std::array<double, kLatheAxes> slides{};   // travel of the slides, which lag by the backlash
  std::array<double, kLatheAxes> demands{};  // travel that the hands have asked for but not yet made
  std::array<int, kLatheAxes> rapids{};      // power traverse of each axis: -1, 0 or 1
  int direction = 0;                         // direction of the spindle lever
  double setSpeed = 600.0;                   // r/min
  double surfaceSpeed = 0.0;                 // m/min, constant surface speed; 0: setSpeed is used
  double speedClamp = 0.0;                   // r/min, largest speed at a constant surface speed; 0: no limit
  double speed = 0.0;                        // r/min, signed; actual speed
  double turns = 0.0;                        // spindle revolutions so far, signed
  LatheAxis feedAxis = LatheAxis::Carriage;
  double feed = 0.0;         // mm per turn; 0: off
  double lead = 0.0;         // mm per turn, lead of the half-nut; 0: open
  bool isNutClosed = false;  // the half-nut has engaged the screw
  double nutPosition = 0.0;  // mm, travel of the carriage at turn 0 that the closed nut implies
  std::uint32_t tool = 0;    // index of the slot in use
  double time = 0.0;         // s

  bool operator==(const LatheState&) const = default;
};

// The motion during a step, with its cause.
struct LatheMotion {
  double turns = 0.0;     // spindle revolutions, not signed
  bool isRapid = false;   // moved by the power traverse
  bool isByHand = false;  // moved by a wheel
};

// The slides, wheels, spindle and levers of a manual lathe, without material. The simulation is deterministic: the
// state is a function of the calls.
//
// The half-nut closes only where it fits the threads of the lead screw, once in each leadScrewPitch of travel.
// Therefore, when a thread is cut in several passes, the tool meets the same groove of the work after each closing of
// the half-nut if leadScrewPitch is a multiple of the lead. With any other lead it may miss the groove.
class LatheMachine {
 public:
  // Creates a machine. The setup must be sound, and the state must belong to this setup.
  LatheMachine(LatheSetup setup, const LatheState& state);
  // Returns a machine at rest, with the first tool beside and in front of the part.
  static LatheState initialState(const LatheSetup& setup, const StockCylinder& stock);

  const LatheSetup& setup() const { return m_setup; }
  const LatheState& state() const { return m_state; }
  void restore(const LatheState& state) { m_state = state; }

  void apply(const LatheCommand& command);
  // Advances the machine by dt (s, > 0). mostByHand: the largest travel of a slide or of the tool by hand in this step,
  // mm. torque: the torque of the cut at the spindle, N·m. If the drive has more torque than that, the spindle speeds
  // up to its target speed; if it has less, the spindle slows down.
  LatheMotion advance(double dt, double mostByHand, double torque = 0.0);
  // Returns the speed that the levers ask for, r/min, signed.
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
