// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/CycleBudget.h"

namespace handwheel {

void CycleBudget::spend(std::uint64_t steps, const SourceLocation& location) {
  constexpr std::uint64_t kLook = 100'000;  // steps between two checks
  m_done += steps;
  if (m_done > kMost)
    refuse(location, "contour", "the cycles of the program take too much work",
           "Use a contour of fewer lines, or fewer passes.");
  if (m_done < m_look) return;
  m_look = m_done + kLook;
  if (m_progress.cancelled()) throw ProgramRefusal{{ErrorCode::Cancelled, {}, {}, {}}};
}

}  // namespace handwheel
