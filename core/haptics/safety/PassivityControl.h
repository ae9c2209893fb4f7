// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetySettings.h"

#include <array>
#include <cstddef>

namespace handwheel {

// Time-domain passivity observer and controller for the force at the tip. Hannaford and Ryu, IEEE T-RA 18(1), 2002. The
// observer integrates the power of the force that was actually sent and held: between two readings the hand gave the
// scene exactly -F·dx, and the friction b of the device dissipated at least b·|dx|²/t on any path between the readings
// (Cauchy and Schwarz). So a spring K at period T never shows a deficit while K <= 2b/T, Colgate's bound. If the device
// responds with a delay, the force that acted on a displacement is the force sent earlier by that delay, regardless of
// the cause of the delay. Torque is not observed.
class PassivityControl {
 public:
  explicit PassivityControl(const SafetySettings& settings);

  // Discards the observed energy, and treats the next reading as the first.
  void reset() { *this = PassivityControl(m_settings); }
  // Adds a reading, mm, `period` seconds (> 0) after the previous one.
  void observe(const Vec3& position, double period);
  // Returns the damping force, N, that dissipates the energy deficit within the next period. The force is zero without
  // a deficit.
  Vec3 correction() const;
  // Records the force sent after the last reading.
  void sent(const Vec3& force);

  // Returns the observed energy, N·mm, that the hand has given to the scene and has not got back. A negative value
  // means that the scene has generated energy.
  double energy() const { return m_energy; }

 private:
  static constexpr std::size_t kLongest = 512;  // longest delay in ticks: 64 ms at 8 kHz, more than any device states
  // Returns the force sent this number of ticks ago.
  const Vec3& sentBefore(std::size_t ticks) const { return m_sent[(m_newest + kLongest - ticks) % kLongest]; }
  Vec3 acting() const;
  double recentFriction() const;

  SafetySettings m_settings;
  std::size_t m_latency = 0;    // number of whole ticks of the latency
  double m_latencyShare = 0.0;  // remaining fraction of a tick
  double m_energy = 0.0;
  std::array<Vec3, kLongest> m_sent;        // ring buffer; m_newest is the index of the newest force
  std::array<double, kLongest> m_friction;  // N·mm, energy dissipated by the device; with the indices of m_sent
  std::size_t m_newest = 0;
  Vec3 m_position = Vec3::Zero();
  Vec3 m_velocity = Vec3::Zero();  // mm/s, mean since the previous reading
  bool m_hasPosition = false;
};

}  // namespace handwheel
