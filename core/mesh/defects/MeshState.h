// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

namespace handwheel {

// The state of a surface as the boundary of a solid. Window, command line, reports and exit codes all judge a part by
// it; stateText() has its words.
struct MeshState {
  bool closed = false;    // there are faces, and no open edges
  bool manifold = false;  // no edge has more than two faces, and nowhere do faces touch that share no edge
  bool oriented = false;  // the faces at each edge agree on which side is outside, and no body is inside out
  std::optional<std::size_t> selfIntersectingPairs = {};  // absent when not looked for
  std::size_t components = 0;

  // As far as it is known. Several components are no defect.
  bool isSound() const { return closed && manifold && oriented && selfIntersectingPairs.value_or(0) == 0; }
  // The same, with self-intersections looked for.
  bool isKnownSound() const { return isSound() && selfIntersectingPairs; }
};

}  // namespace handwheel
