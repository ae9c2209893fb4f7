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
  double chord = 0.0;  // largest distance from the surfaces, mm; at least the requested chord
  std::size_t faces = 0;
  std::size_t facesLost = 0;  // number of faces that cannot be triangulated
  std::string ply;            // PLY file, binary, in the byte order of this machine
};

// Tessellates all faces of a shape. chordShare: the chord as a fraction of the diagonal of the bounding box.
// Neighbouring faces of a shell have identical points along their edges. Errors: LibraryFailed with the reason.
Result<ShapeMesh> meshOf(const TopoDS_Shape& shape, double chordShare, Progress progress);

}  // namespace handwheel
