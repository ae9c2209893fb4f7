// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleFilling.h"

#include <optional>

namespace handwheel {

// The search structure for filling the holes of a mesh. It is costly to build, so it is built by the first worker that
// needs it and kept for the next one. One thread at a time.
class FillBench {
 public:
  explicit FillBench(HalfEdgeMesh mesh) : m_mesh(std::move(mesh)) {}

  // Null when it is cancelled before it is ready; the next call begins anew.
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
