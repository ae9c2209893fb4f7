// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/SimulationLoop.h"

#include <functional>
#include <optional>

namespace handwheel {

// What simulated gestures use of the program. Both outlive them.
struct SimulationServices {
  ServoClock& clock;
  Service& service;
};

// The gestures of a tool whose work a simulation does. There is one from press to release at a time, of the mouse or of
// a device. The simulation runs between them, too, as the hand feels through it. Window thread.
class SimulatedGesture {
 public:
  // Makes a simulation from the present state of the document on.
  using Make = std::function<std::unique_ptr<Simulation>()>;

  // rate: steps a second.
  SimulatedGesture(const SimulationServices& services, std::shared_ptr<SimulationInputs> inputs, double rate,
                   Make make);

  bool isOn() const { return m_isOn; }
  // Whether one is on that this source makes: a device, whose inputs come from the servo loop, or the mouse.
  bool isOnFrom(bool isDevice) const { return m_isOn && m_isOfDevice == isDevice; }

  // Throws what the simulation has thrown: to be called with each event, so that the tool ends.
  void rethrow() const { m_loop.rethrow(); }
  // None must be on.
  void begin(bool isOfDevice);
  // A place of the mouse in its gesture, mm. time: s, when it was there, by any clock; none: now. The window comes to
  // several places at once when it is busy. period: s, for simulations that depend on it. pressure: as that of
  // SimulationInput.
  void feed(const Vec3& place, std::optional<double> time = {}, double period = TipState().period,
            double pressure = 1.0);
  // Nothing more is fed, nor comes of the device. The simulation is informed after all that has arrived, and goes on
  // with what is left. False: there was no room, to be asked again. end() is to follow.
  bool close();
  // Ends it, and gives the simulation after all that has arrived. restart() is to follow. Throws what a step throws.
  std::unique_ptr<Simulation> end();
  // Looks at the simulation between two of its steps; the gesture goes on. Throws what a step throws.
  void look(const std::function<void(Simulation&)>& at) { m_loop.look(at); }
  // Drops what was begun, and simulates from the present state on.
  void restart();

  std::shared_ptr<const SimulationState> state() const { return m_loop.state(); }

 private:
  void disarm();

  ServoClock& m_clock;
  const std::shared_ptr<SimulationInputs> m_inputs;
  const Make m_make;
  mutable SimulationLoop m_loop;  // mutable: to read its state takes the newest one out of a buffer
  std::uint32_t m_number = 0;     // of the gesture that began last
  bool m_isOn = false;
  bool m_isOfDevice = false;
  bool m_isFirst = false;        // nothing was fed yet
  std::optional<double> m_time;  // s, of the place that was fed last; none: by the clock of the servo loop
};

}  // namespace handwheel
