// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/TripleBuffer.h"
#include "haptics/device/Device.h"

#include <atomic>

namespace handwheel {

// A device driven by the mouse instead of haptic hardware. The window sets the pointer's position in the scene, and
// reads the force that would be felt, to draw it. The frame of the device is that of the scene, so the mapping is the
// identity. The device has no motors, so no force can make it unstable, and forces are not limited for stability.
class MouseDevice : public Device {
 public:
  explicit MouseDevice(double maxForce = 10.0) : m_maxForce(maxForce) {}

  // Sets the pointer's position in the scene, mm, and the buttons that count as those of the device. Must be called on
  // the window thread.
  void point(const Vec3& position, std::uint32_t buttons) noexcept;
  void leave() noexcept;  // marks the device as absent, because the pointer is outside the view
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

// Depth of the mouse pointer along its pick ray. It is the depth of the last surface that was under the pointer, plus
// the displacement by the wheel.
class PointerDepth {
 public:
  // Sets the distance along the ray to the surface under the pointer, mm. If it is not called, the last distance stays.
  void setSurface(double distance) { m_surface = distance; }
  // Adds wheel steps of `stepLength` mm each. Positive steps are away from the eye.
  void turnWheel(double steps, double stepLength) { m_offset += steps * stepLength; }
  void resetWheel() { m_offset = 0.0; }

  // Returns the pointer's position on a ray with a unit direction. The position is never behind the eye.
  Vec3 positionOn(const Vec3& origin, const Vec3& direction) const;

 private:
  double m_surface = 0.0;
  double m_offset = 0.0;
};

}  // namespace handwheel
