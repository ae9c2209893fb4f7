// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/LatheStates.h"

#include <algorithm>

namespace handwheel {

void LatheStates::note(const Part& part, const LatheState& state) {
  if (!part) {
    m_ofBar = state;
    return;
  }
  std::erase_if(m_ofParts, [&](const auto& each) { return each.first.expired() || each.first.lock() == part; });
  m_ofParts.emplace_back(part, state);
}

std::optional<LatheState> LatheStates::of(const Part& part) const {
  if (!part) return m_ofBar;
  const auto found =
      std::find_if(m_ofParts.begin(), m_ofParts.end(), [&](const auto& each) { return each.first.lock() == part; });
  return found == m_ofParts.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace handwheel
