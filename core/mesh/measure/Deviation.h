// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "mesh/search/SurfaceDistance.h"

#include <array>
#include <optional>
#include <vector>

namespace handwheel {

inline constexpr std::size_t kMaxDeviationSamples = 4'000'000;
inline constexpr std::size_t kMaxDeviationBins = 10'000;

// Options of deviation().
struct DeviationOptions {
  // Number of uniformly distributed sample points on each surface besides its vertices; 0: vertices only.
  std::size_t samples = 200'000;
  std::size_t bins = 50;       // number of bins of the histogram, at least 1
  bool measuresBound = false;  // sets Deviation::atMost
};

// A point with an extreme distance from the other surface.
struct DeviationExtremum {
  double distance = 0.0;  // mm, signed
  Vec3 position = Vec3::Zero();
  Vec3 nearest = Vec3::Zero();  // nearest point of the other surface
};

inline constexpr std::array<double, 4> kDeviationPercentiles{50.0, 90.0, 95.0, 99.0};

// The deviation of one surface from another. Lengths are in mm, with the sign of SurfaceDistance. Mean, RMS,
// percentiles and histogram are weighted by area: they are computed from the samples or, if there are none, from the
// vertices, each with a third of the area around it. The extremes are found among samples and vertices, so the true
// extremes may exceed them by at most the distance to the next sample.
struct SurfaceDeviation {
  std::vector<double> atVertex;  // signed distance per vertex slot; NaN if no face of the surface has the vertex
  std::size_t vertices = 0;      // number of measured vertices
  std::size_t samples = 0;
  double area = 0.0;  // mm²
  double mean = 0.0;
  double meanAbsolute = 0.0;
  double rms = 0.0;
  DeviationExtremum lowest, highest;
  std::array<double, kDeviationPercentiles.size()> percentiles{};  // percentiles of the absolute distance
  std::vector<double> histogram;  // fractions of the area in equal bins from lowest to highest; their sum is 1

  const DeviationExtremum& farthest() const { return -lowest.distance > highest.distance ? lowest : highest; }
};

// The deviation between a mesh and a scan, in both directions.
struct Deviation {
  SurfaceDeviation ofMesh;  // deviation of the mesh from the scan
  SurfaceDeviation ofScan;  // deviation of the scan from the mesh
  // Upper bound of the distances in both directions (largestDistance()), mm; absent unless requested.
  std::optional<double> atMost;
  // Returns the largest distance found in both directions, a lower bound of the Hausdorff distance.
  double hausdorff() const;
};

// Compares a mesh with the scan it was made from, or any two meshes. The result is the same for any number of threads.
// O((v + s) log n) on ordinary surfaces with v vertices, s samples and n faces. Errors: NoTriangles, ValueOutOfRange (a
// coordinate beyond 1e60), Cancelled.
Result<Deviation> deviation(const HalfEdgeMesh& mesh, const HalfEdgeMesh& scan, const DeviationOptions& options = {},
                            Progress progress = {});

// Compares two surfaces. This overload is for callers that also measure other distances from the surfaces. The errors
// are those of the overload for meshes; Cancelled is also returned if the construction of a surface was cancelled.
Result<Deviation> deviation(const SurfaceDistance& mesh, const SurfaceDistance& scan,
                            const DeviationOptions& options = {}, Progress progress = {});

}  // namespace handwheel
