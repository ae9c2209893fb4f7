// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"

#include <map>
#include <memory>

namespace handwheel {

// The surface of a volume for its display, in pieces of 64³ voxels. A value; copies share the pieces.
class VolumeSurface {
 public:
  using Piece = std::shared_ptr<const TriangleSoup>;  // mm; not empty
  using Key = std::array<int, 3>;                     // of a piece: its 64³ voxels along z, y, x

  VolumeSurface() = default;
  // On all threads of the arena. Without some pieces once cancelled.
  explicit VolumeSurface(const SparseVolume& volume, Progress progress = {});

  const std::map<Key, Piece>& pieces() const { return m_pieces; }
  std::size_t triangleCount() const;

 private:
  std::map<Key, Piece> m_pieces;
};

}  // namespace handwheel
