// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/Patch.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace handwheel {

// User-edited bridges that divide a boundary loop into pieces. The user draws from point to point of the loop. This
// adds a bridge and removes those that it would cross, or removes a bridge that exists already. Points are indices in
// the loop.
class BridgeEditing {
 public:
  // The bridges of the user; empty while the program chooses them.
  const std::vector<HoleBridge>& own() const { return m_own; }
  void reset();

  void press(std::uint32_t point) { m_from = point; }
  void drag(std::optional<std::uint32_t> point) { m_to = point; }
  bool isDrawing() const { return m_from.has_value(); }
  // Ends the drawing. shown: the present bridges. Returns true if the bridges have changed.
  bool release(std::size_t loopSize, const std::vector<HoleBridge>& shown);
  void cancel() { m_from = m_to = std::nullopt; }

  // The bridge that is being drawn.
  std::optional<HoleBridge> drawn() const;

 private:
  std::vector<HoleBridge> m_own;
  std::optional<std::uint32_t> m_from, m_to;
};

}  // namespace handwheel
