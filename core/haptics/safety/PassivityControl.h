// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetySettings.h"

#include <array>
#include <cstddef>

namespace handwheel {

// Time-domain passivity observer and controller for the force at the tip. Hannaford and Ryu, IEEE T-RA 18(1), 2002. The
// observer integrates the power of the force that was actually sent and held: between two readings the hand gave the
// scene exactly -F·dx, and the friction b of the device dissipated at least b·|dx|²/t whatever the path between (Cauchy
// and Schwarz). So a spring K at period T never shows a deficit while K <= 2b/T, Colgate's bound. If the device
// responds with a delay, the force that acted on a displacement is the one sent that much earlier, wherever the time is
// lost. Torque is not observed.
class PassivityControl {
 public:
  explicit PassivityControl(const SafetySettings& settings);

  // Forgets all energy; the next reading is the first.
  void reset() { *this = PassivityControl(m_settings); }
  // Adds a reading, mm, `period` seconds (> 0) after the previous one.
  void observe(const Vec3& position, double period);
  // Returns the damping force, N, that dissipates the energy deficit within the next period; zero without a deficit.
  Vec3 correction() const;
  // Records the force sent after the last reading.
  void sent(const Vec3& force);

  // Returns the observed energy, N·mm, that the hand has given and not got back. Negative: the scene has generated
  // energy.
  double energy() const { return m_energy; }

 private:
  static constexpr std::size_t kLongest = 512;  // ticks of delay: 64 ms at 8 kHz, more than any device states
  // Returns the force sent that many ticks ago.
  const Vec3& sentBefore(std::size_t ticks) const { return m_sent[(m_newest + kLongest - ticks) % kLongest]; }
  Vec3 acting() const;
  double recentFriction() const;

  SafetySettings m_settings;
  std::size_t m_latency = 0;    // whole ticks of the latency,
  double m_latencyShare = 0.0;  // and the fraction of another
  double m_energy = 0.0;
  std::array<Vec3, kLongest> m_sent;        // ring buffer, up to m_newest
  std::array<double, kLongest> m_friction;  // N·mm, taken by the device; at the same indices
  std::size_t m_newest = 0;
  Vec3 m_position = Vec3::Zero();
  Vec3 m_velocity = Vec3::Zero();  // mm/s, mean since the previous reading
  bool m_hasPosition = false;
};

}  // namespace handwheel
