// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/TripleBuffer.h"
#include "haptics/Device.h"

#include <atomic>

namespace handwheel {

// The mouse in the place of a device: the window says where in the scene the pointer is, and reads the force that would
// be felt, to draw it. Its frame is the scene's: its mapping is the identity. It has no motors, so no force can make it
// unstable and none is limited for that.
class MouseDevice : public Device {
 public:
  explicit MouseDevice(double maxForce = 10.0) : m_maxForce(maxForce) {}

  // The window thread. The pointer at a place in the scene, mm, with the buttons that count as the device's.
  void point(const Vec3& position, std::uint32_t buttons) noexcept;
  void leave() noexcept;  // the pointer is outside the view: no device
  // N, as it was at the last tick.
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

// How deep in the view the pointer is: on the surface under it, or where it was last, and the wheel moves it on along
// the ray.
class PointerDepth {
 public:
  // mm along the ray to the surface under the pointer. Without one the last stays.
  void setSurface(double distance) { m_surface = distance; }
  // Steps of the wheel of so many mm each; positive: away from the eye.
  void turnWheel(double steps, double stepLength) { m_offset += steps * stepLength; }
  void resetWheel() { m_offset = 0.0; }

  // The place on a ray whose direction has length 1; never behind the eye.
  Vec3 place(const Vec3& origin, const Vec3& direction) const;

 private:
  double m_surface = 0.0;
  double m_offset = 0.0;
};

}  // namespace handwheel
