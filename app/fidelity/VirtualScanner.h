// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/ExactPart.h"
#include "mesh/TriangleSoup.h"

#include <cstdint>

namespace handwheel {

struct ScanOptions {
  double pitch = 1.0;   // mm: between samples
  double noise = 0.02;  // mm: standard deviation along the normal
  std::uint64_t seed = 1;
};

// What a scanner makes of a part, closed: one sample about every pitch, on the surface but for the noise, none of them
// on a sharp edge but by chance, so that triangles cut the edges off, as wide as the pitch (surface nets: Gibson,
// "Constrained elastic surface nets", 1998). O(box / pitch³).
TriangleSoup scanOf(const ExactPart& part, const ScanOptions& options);

}  // namespace handwheel
