// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/ClosedSurfaceInVoxels.h"

#include "base/NumberText.h"
#include "mesh/structure/MeshErrors.h"
#include "mesh/structure/Weld.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeMemory.h"
#include "volume/repair/WindingNumberFill.h"

#include <cmath>
#include <utility>

namespace handwheel {
namespace {

// The origin of a grid for what begins at this place, mm.
Vec3 originBefore(const Vec3& first, double voxel, const std::optional<Vec3>& alignedTo) {
  if (!alignedTo) return first;
  const double block = VolumeBlock::kSize * voxel;
  return *alignedTo + block * ((first - *alignedTo) / block).array().floor().matrix();
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

double ClosedSurfaceInVoxels::nearShare(const SparseVolume& volume, const std::vector<bool>& isUsed) const {
  double near = 0.0, all = 0.0;
  for (std::size_t i = 0; i < closed.triangles.size(); ++i) {
    if (!isUsed[i]) continue;
    const Triangle& t = closed.triangles[i];
    const Vec3 &a = closed.points[t[0]], &b = closed.points[t[1]], &c = closed.points[t[2]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    all += area;
    const VoxelIndex base = ((a + b + c) / 3.0).array().floor().cast<int>();
    bool isInside = false, isOutside = false;
    for (int k = 0; k < 8; ++k)
      (volume.sample(base + VoxelIndex(k & 1, k >> 1 & 1, k >> 2)) > 0 ? isInside : isOutside) = true;
    if (isInside && isOutside) near += area;
  }
  return all > 0.0 ? near / all : 0.0;
}

Error ClosedSurfaceInVoxels::nothingInside() const {
  // What rounding leaves of a flat sheet is no volume.
  const bool isThin = enclosed() > 1e-9 * std::pow(bounds.sizes().maxCoeff(), 3.0);
  return isThin ? Error{VolumeErrors::NoVoxelInside, {roundedText(grid.voxel())}, {}, {}}
                : Error{VolumeErrors::NothingInside, {}, {}, {}};
}

Result<ClosedSurfaceInVoxels> closedInVoxels(const TriangleSoup& soup, double voxel, double wideFrom,
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
  constexpr double kMost = SparseVolume::kMostVoxels - 64;  // a region less, for what is around the part
  if (!(extent / voxel < kMost))
    return Error{
        VolumeErrors::TooFine, {shortestText(voxel), shortestText(extent), shortestText(extent / kMost)}, {}, {}};

  // Space for the band around the part, whose sides lie between voxels.
  made.grid = SparseVolume(originBefore(made.bounds.min().array() - 3.5 * voxel, voxel, alignedTo), voxel);
  for (Vec3& p : made.closed.points) p = (p - made.grid.origin()) / voxel;
  made.caps = closeBoundaries(made.closed, wideFrom, progress);
  const Vec3 across = made.bounds.sizes() / voxel;
  const double bytes = predictedMakingBytes(surfaceArea(made.closed), across, 1.0) +
                       WindingNumberFill::predictedBlocks(made.closed, made.caps.wide) * WindingNumberFill::kBytes;
  if (const auto error = memoryRefusal(voxel, bytes)) return *error;
  return made;
}

}  // namespace handwheel
