// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

namespace handwheel {

// The state of a surface as the boundary of a solid. The window, the command line, reports and exit codes all use it to
// judge a part; stateText() describes it in words.
struct MeshState {
  bool closed = false;    // there are faces, and no open edges
  bool manifold = false;  // no edge has more than two faces, and faces that share no edge do not touch at a vertex
  bool oriented = false;  // the faces at each edge agree on which side is outside, and no body is inside out
  std::optional<std::size_t> selfIntersectingPairs = {};  // absent if not searched
  std::size_t components = 0;

  // Returns true if no known property is a defect. Several components are no defect.
  bool isSound() const { return closed && manifold && oriented && selfIntersectingPairs.value_or(0) == 0; }
  // Returns true if the surface is sound and self-intersections were searched.
  bool isKnownSound() const { return isSound() && selfIntersectingPairs; }
};

}  // namespace handwheel
