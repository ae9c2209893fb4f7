// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <string>

namespace handwheel {

// The triangles of a shape.
struct ShapeMesh {
  double chord = 0.0;  // mm: how far they may be from its surfaces; the chord asked for, or more
  std::size_t faces = 0;
  std::size_t facesLost = 0;  // that cannot be cut into triangles
  std::string ply;            // binary, in the byte order of this machine
};

// Tessellates all faces of a shape. chordShare: of the diagonal of its box. Neighbouring faces of a shell have the very
// same points along their edges. Errors: LibraryFailed with the reason.
Result<ShapeMesh> meshOf(const TopoDS_Shape& shape, double chordShare, Progress progress);

}  // namespace handwheel
