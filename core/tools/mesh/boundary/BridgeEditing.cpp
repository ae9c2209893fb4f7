// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/boundary/BridgeEditing.h"

#include "mesh/holes/HoleDecomposition.h"

#include <algorithm>

namespace handwheel {
namespace {

bool isSame(const HoleBridge& x, const HoleBridge& y) {
  return std::minmax({x.a, x.b}) == std::minmax({y.a, y.b});
}

}  // namespace

void BridgeEditing::reset() {
  m_own.clear();
  cancel();
}

std::optional<HoleBridge> BridgeEditing::drawn() const {
  if (!m_from || !m_to || *m_from == *m_to) return std::nullopt;
  return HoleBridge{*m_from, *m_to};
}

bool BridgeEditing::release(std::size_t loopSize, const std::vector<HoleBridge>& shown) {
  const std::optional<HoleBridge> bridge = drawn();
  cancel();
  if (!bridge || !splitHole(loopSize, {*bridge})) return false;
  std::vector<HoleBridge> next = shown;
  const auto gone = std::remove_if(next.begin(), next.end(), [&](const HoleBridge& s) { return isSame(s, *bridge); });
  if (gone != next.end()) {
    next.erase(gone, next.end());
  } else {
    std::erase_if(next, [&](const HoleBridge& s) { return !splitHole(loopSize, {s, *bridge}); });
    next.push_back(*bridge);
  }
  m_own = std::move(next);
  return true;
}

}  // namespace handwheel
