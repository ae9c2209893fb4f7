// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/HalfEdgeMesh.h"

#include <functional>

#include <vector>

namespace handwheel {

// A file holds positions, not fans: where several vertices share a position, writing welds them, and edges that are
// manifold in the mesh may have four faces in the file. Moves such vertices apart by the smallest step that the number
// type can show and that makes no new self-intersection. Vertices whose welding harms no edge stay. An
// edge whose ends cannot come apart gets a vertex in its middle that can. Returns the vertices that were moved, then
// those that were added.
// spareCrossings: asked only when some cannot be parted so; then so many crossings are made where that parts them.
std::vector<Vertex> partDuplicates(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {},
                                   const std::function<std::size_t()>& spareCrossings = {});

}  // namespace handwheel
