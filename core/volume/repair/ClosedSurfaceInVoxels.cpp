// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/ClosedSurfaceInVoxels.h"

#include "base/NumberText.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/MeshErrors.h"
#include "mesh/structure/Weld.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeMemory.h"
#include "volume/VolumeSampler.h"
#include "volume/repair/WindingNumberFill.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {
namespace {

// Returns the origin of a grid for a surface whose box begins at this point, mm.
Vec3 originBefore(const Vec3& first, double voxel, const std::optional<Vec3>& alignedTo) {
  if (!alignedTo) return first;
  const double block = VolumeBlock::kSize * voxel;
  return *alignedTo + block * ((first - *alignedTo) / block).array().floor().matrix();
}

bool isNearSurface(const VolumeSampler& sampler, const Vec3& point) {
  const VoxelIndex first = point.array().floor().matrix().cast<int>() - VoxelIndex::Ones();
  bool isInside = false, isOutside = false;
  for (int i = 0; i < 64 && !(isInside && isOutside); ++i)
    (sampler.sample(first + VoxelIndex(i & 3, i >> 2 & 3, i >> 4)) > 0 ? isInside : isOutside) = true;
  return isInside && isOutside;
}

// Returns the volume of the material up to the surface, mm³. A sample inside stands for half a voxel towards a
// neighbour inside, and otherwise for the distance to the surface, the zero of the interpolated depth. So an
// axis-aligned box has its exact volume for any position of its faces; a count of samples would give 27 of 64 for a box
// of four voxels with faces on samples. A part without samples inside has no volume.
double materialToSurface(const SparseVolume& volume) {
  const VolumeSampler sampler(volume);
  double voxels = 0.0;
  volume.forEach([&](const VoxelIndex& block, const SparseVolume::Content& content) {
    if (!content.block) {
      voxels += static_cast<double>(VolumeBlock::kCount);
      return;
    }
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const double depth = content.block->depths[static_cast<std::size_t>(i)];
      if (!(depth > 0.0)) continue;
      const VoxelIndex at = VolumeBlock::kSize * block + VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
      double share = 1.0;
      for (int k = 0; k < 3; ++k) {
        double along = 0.0;
        for (const int side : {-1, 1}) {
          const double beside = sampler.sample(at + side * VoxelIndex::Unit(k));
          along += beside > 0.0 ? 0.5 : depth / (depth - beside);
        }
        share *= along;
      }
      voxels += share;
    }
  });
  return voxels * std::pow(volume.voxel(), 3.0);
}

}  // namespace

VoxelIndex ClosedSurfaceInVoxels::blocks() const {
  return ((bounds.max() - grid.origin()).array() / (VolumeBlock::kSize * grid.voxel()) + 2.0).ceil().cast<int>();
}

double ClosedSurfaceInVoxels::enclosed() const {
  double six = 0.0;
  for (const Triangle& t : closed.triangles)
    six += closed.points[t[0]].dot(closed.points[t[1]].cross(closed.points[t[2]]));
  return six / 6.0 * std::pow(grid.voxel(), 3.0);
}

double ClosedSurfaceInVoxels::nearShare(const SparseVolume& volume, const std::vector<bool>& isUsed,
                                        const Progress& progress) const {
  constexpr double kApart = 4.0;                 // voxels, approximate distance of samples
  constexpr int kMost = 64;                      // parts of an edge
  constexpr std::size_t kTrianglesPerPoll = 64;  // each with up to kMost² samples
  const VolumeSampler sampler(volume);
  double near = 0.0, all = 0.0;
  for (std::size_t i = 0; i < closed.triangles.size(); ++i) {
    if (!pollProgress(i, closed.triangles.size(), progress, kTrianglesPerPoll)) return 0.0;
    if (!isUsed[i]) continue;
    const Triangle& t = closed.triangles[i];
    const Vec3 &a = closed.points[t[0]], ab = closed.points[t[1]] - a, ac = closed.points[t[2]] - a;
    const double area = 0.5 * ab.cross(ac).norm();
    const int parts = static_cast<int>(std::clamp(std::sqrt(area) / kApart, 0.0, kMost - 1.0)) + 1;
    // The middles of parts², all of one size.
    for (int j = 0; j < parts; ++j)
      for (int k = 0; k < 2 * (parts - j) - 1; ++k) {
        const double third = k % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
        const Vec3 point = a + ((j + third) * ab + (k / 2 + third) * ac) / parts;
        const double share = area / (parts * parts);
        all += share;
        if (isNearSurface(sampler, point)) near += share;
      }
  }
  return all > 0.0 ? near / all : 0.0;
}

double nearShare(const SparseVolume& volume, const std::vector<Vec3>& points, const Progress& progress) {
  const VolumeSampler sampler(volume);
  std::size_t near = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!pollProgress(i, points.size(), progress, kSearchesPerPoll)) return 0.0;
    near += isNearSurface(sampler, points[i]);
  }
  return points.empty() ? 1.0 : static_cast<double>(near) / static_cast<double>(points.size());
}

std::optional<Error> lossRefusal(const SparseVolume& volume, double nearShare, double expected) {
  if (nearShare < kLeastKept)
    return Error{VolumeErrors::SurfaceIsLost,
                 {roundedText(volume.voxel()), roundedText(100.0 * nearShare, 2), roundedText(100.0 * kLeastKept, 2)},
                 {},
                 {}};
  double material = volume.material();
  if (material < kLeastKept * expected) material = std::max(material, materialToSurface(volume));
  if (material < kLeastKept * expected)
    return Error{VolumeErrors::MaterialIsLost,
                 {roundedText(volume.voxel()), roundedText(material, 3), roundedText(kLeastKept * expected, 3)},
                 {},
                 {}};
  return std::nullopt;
}

Error ClosedSurfaceInVoxels::nothingInside() const {
  // The rounding errors of a flat sheet are not a volume.
  const bool isThin = enclosed() > 1e-9 * std::pow(bounds.sizes().maxCoeff(), 3.0);
  return isThin ? Error{VolumeErrors::NoVoxelInside, {roundedText(grid.voxel())}, {}, {}}
                : Error{VolumeErrors::NothingInside, {}, {}, {}};
}

Result<ClosedSurfaceInVoxels> closedInGrid(const TriangleSoup& soup, double voxel, double wideFrom,
                                           const std::optional<Vec3>& alignedTo, Progress progress) {
  if (soup.triangles.empty()) return Error{MeshError::NoTriangles, {}, {}, {}};
  if (!(voxel > 0.0) || !std::isfinite(voxel))
    return Error{ErrorCode::ValueOutOfRange, {"voxel", shortestText(voxel), "0", "1e300"}, {}, {}};
  ClosedSurfaceInVoxels made;
  made.closed = weld(soup, progress);
  for (const Vec3& p : made.closed.points) {
    if (!p.allFinite()) return Error{ErrorCode::NumberNotFinite, {shortestText(p.x() + p.y() + p.z())}, {}, {}};
    made.bounds.extend(p);
  }
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  const double extent = made.bounds.sizes().maxCoeff();
  constexpr double kMost = SparseVolume::kMostVoxels - 64;  // minus a region, for the surroundings of the part
  if (!(extent / voxel < kMost))
    return Error{
        VolumeErrors::TooFine, {shortestText(voxel), shortestText(extent), shortestText(extent / kMost)}, {}, {}};

  // Space for the band around the part, whose sides lie between voxels.
  made.grid = SparseVolume(originBefore(made.bounds.min().array() - 3.5 * voxel, voxel, alignedTo), voxel);
  for (Vec3& p : made.closed.points) p = (p - made.grid.origin()) / voxel;
  made.caps = closeBoundaries(made.closed, wideFrom, progress);
  return made;
}

Result<ClosedSurfaceInVoxels> closedInVoxels(const TriangleSoup& soup, double voxel, double wideFrom,
                                             const std::optional<Vec3>& alignedTo, Progress progress) {
  Result<ClosedSurfaceInVoxels> made = closedInGrid(soup, voxel, wideFrom, alignedTo, progress);
  if (!made) return made;
  const Vec3 across = made->bounds.sizes() / voxel;
  const double bytes = predictedMakingBytes(surfaceArea(made->closed), across, 1.0) +
                       WindingNumberFill::predictedBlocks(made->closed, made->caps.wide) * WindingNumberFill::kBytes;
  if (const auto error = memoryRefusal(voxel, bytes)) return *error;
  return made;
}

}  // namespace handwheel
