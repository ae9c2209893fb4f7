// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/MouseDevice.h"

#include <algorithm>

namespace handwheel {

void MouseDevice::point(const Vec3& position, std::uint32_t buttons) noexcept {
  DeviceState state;
  state.position = position;
  state.buttons = buttons;
  state.status = DeviceStatus::Ready;
  m_state.write(state);
}

void MouseDevice::leave() noexcept {
  m_state.write({});
}

DeviceCapabilities MouseDevice::capabilities() const {
  DeviceCapabilities mouse;
  mouse.outputs = 0;
  mouse.buttons = 3;
  mouse.maxForce = m_maxForce;
  return mouse;
}

Status MouseDevice::open(Progress) {
  m_isOpen.store(true, std::memory_order_relaxed);
  return Done{};
}

void MouseDevice::close() noexcept {
  m_isOpen.store(false, std::memory_order_relaxed);
}

DeviceState MouseDevice::read() noexcept {
  return m_isOpen.load(std::memory_order_relaxed) ? m_state.read() : DeviceState{};
}

Vec3 PointerDepth::positionOn(const Vec3& origin, const Vec3& direction) const {
  return origin + std::max(0.0, m_surface + m_offset) * direction;
}

}  // namespace handwheel
