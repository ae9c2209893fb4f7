// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/DeviceMotionEstimator.h"
#include "haptics/device/ServoClock.h"
#include "haptics/mapping/WorkspaceMapper.h"
#include "haptics/safety/SafetyChain.h"
#include "haptics/servo/ServoChannel.h"
#include "haptics/servo/ServoStatistics.h"

namespace handwheel {

// Settings of the servo loop. The rate and the velocity window are fidelity settings: servoSettings() in
// TouchFidelity.h sets them.
struct ServoSettings {
  double rate = 0.0;  // ticks a second, kept within kLeastServoRate and kLargestServoRate; 0: the device's nominal rate
  double velocityWindow = VelocityEstimator::kStandardWindow;  // s; used if the device gives no velocity
  int priority = 80;                                           // SCHED_FIFO priority
  std::size_t samples = 16384;                                 // samples that may wait to be fetched: 16 s at 1 kHz

  bool operator==(const ServoSettings&) const = default;
};

inline constexpr double kLeastServoRate = 500.0;
inline constexpr double kLargestServoRate = 8000.0;

// Executes one tick of the servo loop. It reads the device, maps the reading to the scene, computes the scene's force,
// applies the safety chain, writes to the device and publishes a sample. It takes no lock, allocates no memory and
// makes no system calls but those of the device. An object is used by one thread at a time.
class ServoTick {
 public:
  // Device, clock and channel must outlive the object. The device must be open.
  ServoTick(Device& device, const ServoSettings& settings, ServoClock& clock, ServoChannel& channel);

  // Executes a tick. now: the time when the thread was woken for it, ns.
  void run(std::int64_t now) noexcept;
  // Must be called for a pause. The period, the velocity and the energy are then measured anew, and the ramp of the
  // safety chain brings the force back.
  void pause() noexcept;

  // Continues the work of another object on the same device and channel, with its scene, mapping, tick count and time.
  // The ramp of the safety chain brings the force back. Must be called before the first tick, on the thread that owns
  // both objects.
  void resumeFrom(const ServoTick& before);

  ServoStatistics& measure() { return m_measure; }
  const ServoStatistics& measure() const { return m_measure; }
  double nominalPeriod() const { return m_chain.settings().nominalPeriod; }

 private:
  double advance(std::int64_t now);
  bool takeNews();
  void takeMapping(const NumberedMapping& newest);
  void feel(ServoSample& sample, SafetyInput& input, double period);
  bool isMoveFelt(const DeviceForce& asked);
  void ask(ServoSample& sample, SafetyInput& input);
  TipState tipFor(const DeviceState& device, const WorkspaceMapper::Tip& placed, double period) const;

  Device& m_device;
  ServoClock& m_clock;
  ServoChannel& m_channel;
  const DeviceCapabilities m_capabilities;
  SafetyChain m_chain;
  ServoStatistics m_measure;
  DeviceMotionEstimator m_motion;
  WorkspaceMapper m_mapper;
  ForceRenderer* m_renderer = nullptr;  // renderer of the scene that the channel has handed over
  std::uint64_t m_sceneNumber = 0;      // number of that scene
  std::uint64_t m_mappingNumber = 0;
  std::uint64_t m_tick = 0;
  std::int64_t m_last = 0;  // ns: time when the thread was woken for the previous tick
  double m_time = 0.0;      // s
  bool m_hasLast = false;
  bool m_wasReady = false;
  bool m_wasHeld = false;
  bool m_wasForceOn = true;
  bool m_isRestart = true;      // the tip does not continue from its last position
  bool m_isMoved = false;       // the mapping differs from that of the previous tick
  Vec3 m_proxy = Vec3::Zero();  // proxy of the previous tick, mm, in the scene
  DeviceForce m_asked;
};

}  // namespace handwheel
