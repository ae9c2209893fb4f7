// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"

#include <span>
#include <vector>

namespace handwheel {

// The vertices whose triangles do not hang together through edges that touch them, ascending. Triangles with a repeated
// vertex have no part in it. O(n). Of no use once cancelled.
std::vector<std::uint32_t> findNonManifoldVertices(std::span<const Triangle> triangles, std::size_t vertexCount,
                                                   Progress progress = {});

}  // namespace handwheel
