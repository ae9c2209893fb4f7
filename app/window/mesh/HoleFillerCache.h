// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"

#include <optional>

namespace handwheel {

// A cache of the hole filler of a mesh. The filler's search structure is costly to build, so it is built by the first
// worker that needs it and kept for the next one. Must not be used by two threads at once.
class HoleFillerCache {
 public:
  explicit HoleFillerCache(HalfEdgeMesh mesh) : m_mesh(std::move(mesh)) {}

  // Returns the filler; builds it on the first call. Returns null if cancelled before the filler is ready; the next
  // call starts over.
  HoleFiller* filler(Progress progress) {
    if (!m_filler) {
      m_filler.emplace(m_mesh, progress);
      if (progress.cancelled()) m_filler.reset();
    }
    return m_filler ? &*m_filler : nullptr;
  }

 private:
  HalfEdgeMesh m_mesh;
  std::optional<HoleFiller> m_filler;
};

}  // namespace handwheel
