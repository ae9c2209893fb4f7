// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/SimulationLoop.h"

#include <functional>
#include <optional>

namespace handwheel {

// Services of the program that simulated gestures use. Both outlive the gestures.
struct SimulationServices {
  ServoClock& clock;
  Service& service;
};

// The gestures of a tool whose work is done by a simulation. There is one gesture from press to release at a time, of
// the mouse or of a device. The simulation also runs between them, since the hand feels it. Window thread.
class SimulatedGesture {
 public:
  // Makes a simulation that starts from the present state of the document.
  using Make = std::function<std::unique_ptr<Simulation>()>;

  // rate: steps a second.
  SimulatedGesture(const SimulationServices& services, std::shared_ptr<SimulationInputs> inputs, double rate,
                   Make make);

  bool isOn() const { return m_isOn; }
  // Returns true if a gesture of this source is active: of a device, whose inputs come from the servo loop, or of the
  // mouse.
  bool isOnFrom(bool isDevice) const { return m_isOn && m_isOfDevice == isDevice; }

  // Rethrows an exception of the simulation. To be called with each event, so that the tool ends.
  void rethrow() const { m_loop.rethrow(); }
  // No gesture must be active.
  void begin(bool isOfDevice);
  // Adds a mouse position to the gesture, mm. time: time of the position by any clock, s; none: now. A busy window
  // receives several positions at once. period: s, for simulations that depend on it. pressure: as in SimulationInput.
  void feed(const Vec3& position, std::optional<double> time = {}, double period = TipState().period,
            double pressure = 1.0);
  // Ends the input of the gesture. The simulation processes all inputs that have arrived, and continues with its
  // remaining work. False: the queue was full; call again. end() is to follow.
  bool close();
  // Ends the gesture, and returns the simulation after all inputs that have arrived. restart() is to follow. Throws the
  // exception of a step.
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
  bool m_isFirst = false;        // no input yet
  std::optional<double> m_time;  // s, time of the last mouse position; none: by the clock of the servo loop
};

}  // namespace handwheel
