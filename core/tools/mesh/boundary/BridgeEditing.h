// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/Patch.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace handwheel {

// User-edited bridges that divide a boundary loop into pieces. The user draws a line from one point of the loop to
// another. The line adds a bridge and removes the bridges that it would cross; if the bridge already exists, it is
// removed. Points are indices in the loop.
class BridgeEditing {
 public:
  // The bridges that the user has drawn. The list is empty while the program chooses the bridges.
  const std::vector<HoleBridge>& own() const { return m_own; }
  void reset();

  void press(std::uint32_t point) { m_from = point; }
  void drag(std::optional<std::uint32_t> point) { m_to = point; }
  bool isDrawing() const { return m_from.has_value(); }
  // Ends the drawing. shown: the present bridges. Returns true if the bridges have changed.
  bool release(std::size_t loopSize, const std::vector<HoleBridge>& shown);
  void cancel() { m_from = m_to = std::nullopt; }

  // Returns the bridge that is being drawn.
  std::optional<HoleBridge> drawn() const;

 private:
  std::vector<HoleBridge> m_own;
  std::optional<std::uint32_t> m_from, m_to;
};

}  // namespace handwheel
