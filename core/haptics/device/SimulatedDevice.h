// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/TripleBuffer.h"
#include "haptics/device/Device.h"
#include "haptics/device/PoseTrajectory.h"
#include "haptics/device/ServoClock.h"

#include <array>
#include <cstddef>

namespace handwheel {

// PID parameters of the simulated hand that pulls the tip to its target.
struct HandGrip {
  double stiffness = 0.3;  // N/mm
  double damping = 0.003;  // N·s/mm, for the velocity relative to the target's
  double integral = 0.0;   // N/(mm·s)
  double maxForce = 20.0;  // N
};

// Parameters of a simulated device.
struct SimulatedDeviceSettings {
  DeviceCapabilities capabilities;  // capabilities of the simulated device; friction and latency are simulated
  double mass = 0.1;                // kg, of the tip and all that moves with it, the hand's share included
  HandGrip grip;
  bool isCommanded = false;  // the tip follows the path exactly; forces move nothing
};

// Returns the settings of a Novint Falcon, with a friction that allows 1 N/mm at 1 kHz.
SimulatedDeviceSettings simulatedDevice();
// Returns the same settings with motors for torque, about as strong as those of devices that have them.
SimulatedDeviceSettings simulatedTorqueDevice();

// Simulated haptic device: a mass with friction, moved by a simulated hand. The mass with friction b is between the
// hand and the force that was sent, and moves with the clock. A force is held from one write to the next, and acts
// `latency` seconds late. Between two readings the motion under constant force and damping is exact; the springs of the
// hand are evaluated at the middle of steps of 0.1 ms.
class SimulatedDevice : public Device {
 public:
  // The hand follows the path from the first reading on, or, with an empty path, the target. The clock outlives it.
  SimulatedDevice(const SimulatedDeviceSettings& settings, PoseTrajectory path, ServoClock& clock);

  DeviceCapabilities capabilities() const override { return m_settings.capabilities; }
  Status open(Progress progress) override;
  void close() noexcept override;
  DeviceState read() noexcept override;
  void write(const DeviceForce& force) noexcept override;

  // Sets the target of the hand for an empty path. To be called by one thread, the only one that may query it.
  void setTarget(const HandPose& target) noexcept {
    m_lastTarget = target;
    m_target.write(target);
  }
  const HandPose& target() const { return m_lastTarget; }
  // Returns the torque on the hand at the last reading, N·mm. It acts `latency` seconds after it was sent, and turns
  // nothing: the hand holds the orientation. For tests; on the thread that reads.
  const Vec3& torque() const { return m_acting.torque; }
  // Sets the tip's initial position (mm) and velocity (mm/s), instead of at rest at the hand. To be called before the
  // first reading.
  void setStart(const Vec3& position, const Vec3& velocity);

 private:
  struct SentForce {
    double time = 0.0;  // s: when it begins to act
    DeviceForce force;
  };
  HandPose wanted(double time) noexcept;
  void begin(double time) noexcept;
  void moveTo(double time) noexcept;
  void moveUnder(const Vec3& force, double until) noexcept;
  void step(const Vec3& force, double seconds) noexcept;
  Vec3 pull(double seconds) noexcept;

  SimulatedDeviceSettings m_settings;
  PoseTrajectory m_path;
  ServoClock& m_clock;
  TripleBuffer<HandPose> m_target;
  HandPose m_lastTarget;  // last target written to m_target; for the thread that writes
  bool m_isOpen = false;
  bool m_hasBegun = false;
  bool m_hasStart = false;
  std::int64_t m_origin = 0;  // ns: the first reading
  double m_time = 0.0;        // s since then
  Vec3 m_position = Vec3::Zero();
  Vec3 m_velocity = Vec3::Zero();
  Vec3 m_error = Vec3::Zero();  // mm·s, integral of the position error
  // Forces that do not act yet, oldest first. If there are more than fit, half a second at 8 kHz, the oldest are
  // dropped.
  std::array<SentForce, 4096> m_sent;
  std::size_t m_first = 0;
  std::size_t m_count = 0;
  DeviceForce m_acting;
};

}  // namespace handwheel
