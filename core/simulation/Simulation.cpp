// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/Simulation.h"

namespace handwheel {

std::uint32_t SimulationInputs::gestureAt(const TipState& tip) noexcept {
  const std::uint32_t announced = m_announced.load(std::memory_order_acquire);
  if (announced != m_gesture) m_phase = Phase::Waiting;
  m_gesture = announced;
  const bool isHeld = (tip.buttons & 1u) != 0;
  if (m_phase == Phase::Waiting && isHeld)
    m_phase = Phase::Acting;
  else if (m_phase == Phase::Acting && (!isHeld || tip.isRestart))
    m_phase = Phase::Over;
  return m_phase == Phase::Acting ? m_gesture : 0;
}

}  // namespace handwheel
