// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/TripleBuffer.h"
#include "haptics/Device.h"
#include "haptics/HandPath.h"
#include "haptics/ServoClock.h"

#include <array>
#include <cstddef>

namespace handwheel {

// How a simulated hand holds the tip: it pulls it towards where it wants to be (PID).
struct HandGrip {
  double stiffness = 0.3;  // N/mm
  double damping = 0.003;  // N·s/mm, of the velocity relative to where it wants to be
  double integral = 0.0;   // N/(mm·s)
  double maxForce = 20.0;  // N
};

struct SimulatedDeviceSettings {
  DeviceCapabilities capabilities;  // of the device that it stands for; friction and latency are simulated
  double mass = 0.1;                // kg, of the tip and all that moves with it, the hand's share included
  HandGrip grip;
  bool isCommanded = false;  // the tip is exactly where the path says; forces move nothing
};

// With the data of a Novint Falcon, and a friction that carries 1 N/mm at 1 kHz.
SimulatedDeviceSettings simulatedDevice();

// A device without hardware: a mass with friction b between the hand and the force that was sent, moved by the clock.
// A force is held from one write to the next, and acts `latency` seconds late. Between two readings the motion under
// constant force and damping is exact; the springs of the hand are taken at the middle of steps of 0.1 ms.
class SimulatedDevice : public Device {
 public:
  // The hand follows the path from the first reading on, or, with an empty path, the target. The clock outlives it.
  SimulatedDevice(const SimulatedDeviceSettings& settings, HandPath path, ServoClock& clock);

  DeviceCapabilities capabilities() const override { return m_settings.capabilities; }
  Status open(Progress progress) override;
  void close() noexcept override;
  DeviceState read() noexcept override;
  void write(const DeviceForce& force) noexcept override;

  // Where the hand is to go without a path; any one thread.
  void setTarget(const HandPose& target) noexcept { m_target.write(target); }
  // Where and how fast (mm/s) the tip begins, instead of at rest where the hand is. Before the first reading.
  void setStart(const Vec3& position, const Vec3& velocity);

 private:
  struct SentForce {
    double time = 0.0;  // s: when it begins to act
    Vec3 force = Vec3::Zero();
  };
  HandPose wanted(double time) noexcept;
  void begin(double time) noexcept;
  void moveTo(double time) noexcept;
  void moveUnder(const Vec3& force, double until) noexcept;
  void step(const Vec3& force, double seconds) noexcept;
  Vec3 pull(double seconds) noexcept;

  SimulatedDeviceSettings m_settings;
  HandPath m_path;
  ServoClock& m_clock;
  TripleBuffer<HandPose> m_target;
  bool m_isOpen = false;
  bool m_hasBegun = false;
  bool m_hasStart = false;
  std::int64_t m_origin = 0;  // ns: the first reading
  double m_time = 0.0;        // s since then
  Vec3 m_position = Vec3::Zero();
  Vec3 m_velocity = Vec3::Zero();
  Vec3 m_error = Vec3::Zero();  // mm·s, integral of what the hand is off
  // Forces on their way, oldest first. More than fit, half a second at 8 kHz, push the oldest out.
  std::array<SentForce, 4096> m_sent;
  std::size_t m_first = 0;
  std::size_t m_count = 0;
  Vec3 m_acting = Vec3::Zero();
};

}  // namespace handwheel
