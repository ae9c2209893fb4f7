// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BoundaryLoops.h"
#include "mesh/Patch.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace handwheel {

// The bridges that cut one loop into pieces, as the user changes them by drawing from point to point of the loop:
// where there was none there is one now, and those that it would cross give way; where there was one there is none.
// Points are numbers in the loop.
class BridgeEditing {
 public:
  // Those of the user; empty as long as they are left to the program.
  const std::vector<Stitch>& own() const { return m_own; }
  void reset();

  void press(std::uint32_t point) { m_from = point; }
  void drag(std::optional<std::uint32_t> point) { m_to = point; }
  bool isDrawing() const { return m_from.has_value(); }
  // Ends the drawing. shown: the bridges as they are. True when they are now others.
  bool release(std::size_t loopSize, const std::vector<Stitch>& shown);
  void cancel() { m_from = m_to = std::nullopt; }

  // The bridge that is being drawn.
  std::optional<Stitch> drawn() const;

 private:
  std::vector<Stitch> m_own;
  std::optional<std::uint32_t> m_from, m_to;
};

}  // namespace handwheel
