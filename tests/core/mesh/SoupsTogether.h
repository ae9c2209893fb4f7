// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshShapes.h"

#include <vector>

namespace handwheel::test {

// Returns the triangles of several soups as one soup.
inline TriangleSoup together(const std::vector<TriangleSoup>& parts) {
  TriangleSoup all;
  for (const TriangleSoup& part : parts) append(all, part);
  return all;
}

}  // namespace handwheel::test
