// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/TripleBuffer.h"
#include "haptics/device/Device.h"

#include <atomic>

namespace handwheel {

// A device driven by the mouse instead of haptic hardware. The window sets the pointer's position in the scene, and
// reads the force that would be felt, to draw it. Its frame is that of the scene: its mapping is the identity. It has
// no motors, so no force can make it unstable, and none is limited for stability.
class MouseDevice : public Device {
 public:
  explicit MouseDevice(double maxForce = 10.0) : m_maxForce(maxForce) {}

  // Sets the pointer's position in the scene, mm, and the buttons that count as the device's. Window thread.
  void point(const Vec3& position, std::uint32_t buttons) noexcept;
  void leave() noexcept;  // sets that the pointer is outside the view: no device
  // Returns the force of the last tick, N.
  Vec3 force() noexcept { return m_force.read(); }

  DeviceCapabilities capabilities() const override;
  Status open(Progress progress) override;
  void close() noexcept override;
  DeviceState read() noexcept override;
  void write(const DeviceForce& force) noexcept override { m_force.write(force.force); }

 private:
  const double m_maxForce;
  TripleBuffer<DeviceState> m_state;
  TripleBuffer<Vec3> m_force{Vec3::Zero()};
  std::atomic<bool> m_isOpen{false};
};

// Depth of the mouse pointer along its pick ray. It is that of the surface under the pointer, or the last one; the
// wheel moves it along the ray.
class PointerDepth {
 public:
  // Sets the distance (mm) along the ray to the surface under the pointer. Without a surface the last one stays.
  void setSurface(double distance) { m_surface = distance; }
  // Adds wheel steps of `stepLength` mm each; positive: away from the eye.
  void turnWheel(double steps, double stepLength) { m_offset += steps * stepLength; }
  void resetWheel() { m_offset = 0.0; }

  // Returns the pointer's position on a ray with unit direction; never behind the eye.
  Vec3 positionOn(const Vec3& origin, const Vec3& direction) const;

 private:
  double m_surface = 0.0;
  double m_offset = 0.0;
};

}  // namespace handwheel
