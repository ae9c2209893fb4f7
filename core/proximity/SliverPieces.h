// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "proximity/BoxTree.h"
#include "proximity/TriangleBoxes.h"

#include <span>
#include <vector>

namespace handwheel {

// Replaces the box of a long, slanted triangle by several boxes around its pieces. Around a vertex with thousands of
// faces the whole boxes all overlap, and a search would visit every face. The method is early split clipping (Ernst and
// Greiner, 2007). If the boxes are on average no larger than those of ordinary surfaces, nothing changes. A triangle
// gets at most 32 boxes; altogether, at most a million boxes or the number of items, whichever is larger, are added.
// O(n).
void splitSliverBoxes(std::vector<BoxedItem>& items, std::span<const Vec3> points, std::span<const Triangle> triangles,
                      const BoxFrame& frame);

}  // namespace handwheel
