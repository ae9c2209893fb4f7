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
  // Sample points on each surface, besides its vertices, equally many on equal areas; 0: vertices only.
  std::size_t samples = 200'000;
  std::size_t bins = 50;  // of the histogram, at least 1
};

// A point with its distance from the other surface.
struct DeviationPlace {
  double distance = 0.0;  // mm, with its sign
  Vec3 place = Vec3::Zero();
  Vec3 nearest = Vec3::Zero();  // on the other surface
};

inline constexpr std::array<double, 4> kDeviationPercentiles{50.0, 90.0, 95.0, 99.0};

// The deviation of one surface from another. Lengths in mm, the sign as in SurfaceDistance. Mean, RMS, percentiles and
// histogram count equal areas equally: they are taken over the samples, or, without any, over the vertices, each with a
// third of the area around it. The extremes are those of samples and vertices, so the true ones may lie beyond them by
// no more than the distance to the next sample.
struct SurfaceDeviation {
  std::vector<double> atVertex;  // per vertex slot; NaN where no face of the surface has the vertex
  std::size_t vertices = 0;      // measured
  std::size_t samples = 0;
  double area = 0.0;  // mm²
  double mean = 0.0;
  double meanAbsolute = 0.0;
  double rms = 0.0;
  DeviationPlace lowest, highest;
  std::array<double, kDeviationPercentiles.size()> percentiles{};  // of the absolute distance
  std::vector<double> histogram;  // shares of the area in equal bins from lowest to highest; their sum is 1

  const DeviationPlace& farthest() const { return -lowest.distance > highest.distance ? lowest : highest; }
};

// The deviation between a mesh and a scan, either way.
struct Deviation {
  SurfaceDeviation ofMesh;  // from the scan
  SurfaceDeviation ofScan;  // from the mesh
  // The largest distance found either way: a lower bound of the Hausdorff distance.
  double hausdorff() const;
};

// Compares a mesh with the scan that it came from, or any two meshes. The result is the same for any number of threads.
// O((v + s) log n) on ordinary surfaces. Errors: NoTriangles, ValueOutOfRange (a coordinate beyond 1e60), Cancelled.
Result<Deviation> deviation(const HalfEdgeMesh& mesh, const HalfEdgeMesh& scan, const DeviationOptions& options = {},
                            Progress progress = {});
// The largest distance found between two surfaces, either way, mm: at all vertices, and at about twice as many samples
// as the second has faces, up to a number at which more hardly change it. None where one has no triangles, or if
// cancelled.
std::optional<double> largestDistance(const HalfEdgeMesh& mesh, const HalfEdgeMesh& original, Progress progress = {});

// Compares two surfaces, for callers that measure more distances from them. Errors: as above, and Cancelled where the
// construction of a surface was.
Result<Deviation> deviation(const SurfaceDistance& mesh, const SurfaceDistance& scan,
                            const DeviationOptions& options = {}, Progress progress = {});

}  // namespace handwheel
