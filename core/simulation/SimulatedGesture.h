// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/SimulationLoop.h"

#include <functional>
#include <optional>

namespace handwheel {

// Services of the program that simulated gestures use. The clock and the service must outlive the gestures.
struct SimulationServices {
  ServoClock& clock;
  Service& service;
};

// The gestures of a tool whose work is done by a simulation. Only one gesture is active at a time, from press to
// release of the mouse or of a device. The simulation also runs between gestures, since the hand feels it. It must be
// used on the window thread.
class SimulatedGesture {
 public:
  // A function that makes a simulation that starts from the present state of the document.
  using Make = std::function<std::unique_ptr<Simulation>()>;

  // rate: the number of steps a second.
  SimulatedGesture(const SimulationServices& services, std::shared_ptr<SimulationInputs> inputs, double rate,
                   Make make);

  bool isOn() const { return m_isOn; }
  // Returns true if a gesture of a device (isDevice) or of the mouse is active. The inputs of a device come from the
  // servo loop.
  bool isOnFrom(bool isDevice) const { return m_isOn && m_isOfDevice == isDevice; }

  // Rethrows an exception of the simulation. The tool must call it with each event, so that an exception ends the tool.
  void rethrow() const { m_loop.rethrow(); }
  // Begins a gesture. No gesture may be active.
  void begin(bool isOfDevice);
  // Adds a mouse position (mm) to the gesture. time: the time of the position on any clock, s, since a busy window
  // receives several positions at once; none: now. period: the period of the inputs, s, for simulations that depend on
  // it. pressure: the pressure as in SimulationInput.
  void feed(const Vec3& position, std::optional<double> time = {}, double period = TipState().period,
            double pressure = 1.0);
  // Ends the input of the gesture. The simulation processes all inputs that have arrived, and continues with its
  // remaining work. Returns false if the queue was full; the caller must then call it again. The caller must call end()
  // afterwards.
  bool close();
  // Ends the gesture, and returns the simulation after all inputs that have arrived. The caller must call restart()
  // afterwards. Throws the exception of a step.
  std::unique_ptr<Simulation> end();
  // Calls a function on the simulation between two steps; the gesture continues. Throws the exception of a step.
  void look(const std::function<void(Simulation&)>& at) { m_loop.look(at); }
  // Drops the gesture, and simulates from the present state of the document.
  void restart();

  std::shared_ptr<const SimulationState> state() const { return m_loop.state(); }

 private:
  void disarm();

  ServoClock& m_clock;
  const std::shared_ptr<SimulationInputs> m_inputs;
  const Make m_make;
  mutable SimulationLoop m_loop;  // mutable: reading the state takes the newest one out of a buffer
  std::uint32_t m_number = 0;     // number of the last gesture
  bool m_isOn = false;
  bool m_isOfDevice = false;
  bool m_isFirst = false;        // true: the gesture has no input yet
  std::optional<double> m_time;  // s, time of the last mouse position; none: the clock of the servo loop counts
};

}  // namespace handwheel
