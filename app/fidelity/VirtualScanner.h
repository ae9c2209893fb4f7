// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/ExactPart.h"
#include "mesh/structure/TriangleSoup.h"

#include <cstdint>

namespace handwheel {

// The parameters of a simulated scan.
struct ScanOptions {
  double pitch = 1.0;   // mm, between samples
  double noise = 0.02;  // mm, standard deviation along the normal
  std::uint64_t seed = 1;
};

// Simulates a scan of a part as a closed mesh. The mesh has about one sample per pitch in each direction; only the
// noise moves samples off the surface. Samples lie on sharp edges only by chance, so that triangles cut the edges off
// by a width of about the pitch (surface nets: Gibson, "Constrained elastic surface nets", 1998). O(box / pitch³).
TriangleSoup scanOf(const ExactPart& part, const ScanOptions& options);

}  // namespace handwheel
