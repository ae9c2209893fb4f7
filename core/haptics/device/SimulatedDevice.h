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
  double damping = 0.003;  // N·s/mm, for the velocity relative to that of the target
  double integral = 0.0;   // N/(mm·s)
  double maxForce = 20.0;  // N
};

// Parameters of a simulated device.
struct SimulatedDeviceSettings {
  DeviceCapabilities capabilities;  // specifications of the simulated device; friction and latency are simulated
  double mass = 0.1;                // kg, mass of the tip and all that moves with it, including the mass of the hand
  HandGrip grip;
  bool isCommanded = false;  // true: the tip follows the path exactly, and forces do not move it
};

// Returns the settings of a Novint Falcon, with enough friction for a stable stiffness of 1 N/mm at 1 kHz.
SimulatedDeviceSettings simulatedDevice();
// Returns the settings of simulatedDevice() with motors for torque, about as strong as those of real devices.
SimulatedDeviceSettings simulatedTorqueDevice();

// Simulated haptic device: a mass with friction, moved by a simulated hand. The mass is moved by the hand and by the
// force that was sent. The motion advances with the clock. A force is held from one write to the next, and acts
// `latency` seconds late. Between two readings the motion under constant force and damping is exact; the springs of the
// hand are evaluated at the middle of steps of 0.1 ms.
class SimulatedDevice : public Device {
 public:
  // From the first reading on, the hand follows the path, or the target if the path is empty. The clock must outlive
  // the device.
  SimulatedDevice(const SimulatedDeviceSettings& settings, PoseTrajectory path, ServoClock& clock);

  DeviceCapabilities capabilities() const override { return m_settings.capabilities; }
  Status open(Progress progress) override;
  void close() noexcept override;
  DeviceState read() noexcept override;
  void write(const DeviceForce& force) noexcept override;

  // Sets the target of the hand for an empty path. The target must be set and queried by the same thread.
  void setTarget(const HandPose& target) noexcept {
    m_lastTarget = target;
    m_target.write(target);
  }
  const HandPose& target() const { return m_lastTarget; }
  // Returns the torque on the hand at the last reading, N·mm. The torque acts `latency` seconds after it was sent. It
  // does not turn the tip, because the hand holds the orientation. The function is for tests, and must be called on the
  // thread that reads the device.
  const Vec3& torque() const { return m_acting.torque; }
  // Sets the tip's initial position (mm) and velocity (mm/s). Otherwise the tip starts at rest at the hand. Must be
  // called before the first reading.
  void setStart(const Vec3& position, const Vec3& velocity);

 private:
  struct SentForce {
    double time = 0.0;  // s, time at which the force begins to act
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
  HandPose m_lastTarget;  // last target written to m_target; used by the thread that writes
  bool m_isOpen = false;
  bool m_hasBegun = false;
  bool m_hasStart = false;
  std::int64_t m_origin = 0;  // ns, time of the first reading
  double m_time = 0.0;        // s since the first reading
  Vec3 m_position = Vec3::Zero();
  Vec3 m_velocity = Vec3::Zero();
  Vec3 m_error = Vec3::Zero();  // mm·s, integral of the position error
  // Forces that do not act yet, oldest first. The array holds the forces of half a second at 8 kHz; if there are more,
  // the oldest are dropped.
  std::array<SentForce, 4096> m_sent;
  std::size_t m_first = 0;
  std::size_t m_count = 0;
  DeviceForce m_acting;
};

}  // namespace handwheel
