// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Units.h"
#include "mesh/sculpt/SculptBrush.h"
#include "mesh/selection/FaceSelection.h"

#include <optional>

namespace handwheel {

// Options of smoothNoise().
struct NoiseSmoothing {
  // The difference of normals that counts as noise of a smooth surface: the width of the filter over |n - n'|, which is
  // nearly the angle (radian). By default 20° are noise, and an edge of 60° is kept.
  double normalSpread = 20.0 * kRadiansPerDegree;
  static constexpr double kLeastSpread = 1.0 * kRadiansPerDegree, kLargestSpread = 90.0 * kRadiansPerDegree;
  int normalPasses = 12;
  int vertexPasses = 15;
  bool movesBorder = false;
  NumberType numbers = NumberType::Float64;
  Progress progress = {};
};

// Removes noise from a part of a surface and preserves its creases. The normals of the faces are filtered, each towards
// those of the faces around it that are near and alike, then the vertices follow them (Zheng, Fu, Au, Tai, "Bilateral
// normal filtering for mesh denoising", 2011, the local scheme; vertices by Sun, Rosin, Martin, Langbein, "Fast and
// effective feature-preserving mesh denoising", 2007). Only vertices whose faces are all in the part move. Returns the
// faces around these vertices; returns nothing, without moving a vertex, if cancelled. O(faces of the part).
std::optional<MovedVertices> smoothNoise(HalfEdgeMesh& mesh, const FaceSelection& part,
                                         const NoiseSmoothing& options = {});

// Selects the faces at the border and the given number of rings of faces around them. A face is at the border if one of
// its vertices is. O(n).
FaceSelection facesAtBorder(const HalfEdgeMesh& mesh, int rings);

}  // namespace handwheel
