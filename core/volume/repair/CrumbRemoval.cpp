// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/CrumbRemoval.h"

#include "mesh/structure/DisjointSets.h"
#include "volume/VolumeParts.h"
#include "volume/repair/ClosedSurfaceInVoxels.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

namespace handwheel {
namespace {

constexpr std::uint64_t kCrumbsPerPart = 100;  // a crumb has less than a hundredth of the voxels of the largest part
constexpr double kCrumbArea = 0.01;            // an open shell with a smaller share of the area is debris

// The shells of a surface, by a vertex of each.
struct OpenShells {
  DisjointSets joined;
  std::unordered_map<std::uint32_t, double> area;  // by the root
  std::vector<bool> isOpen;                        // by the root
  double whole = 0.0;

  OpenShells(const TriangleSoup& closed, std::size_t own) : joined(closed.points.size()), isOpen(closed.points.size()) {
    for (std::size_t i = 0; i < own; ++i) {
      const Triangle& t = closed.triangles[i];
      joined.join(t[0], t[1]);
      joined.join(t[1], t[2]);
    }
    for (std::size_t i = 0; i < own; ++i) {
      const Triangle& t = closed.triangles[i];
      const Vec3& a = closed.points[t[0]];
      const double each = 0.5 * (closed.points[t[1]] - a).cross(closed.points[t[2]] - a).norm();
      area[joined.root(t[0])] += each;
      whole += each;
    }
    for (std::size_t i = own; i < closed.triangles.size(); ++i) isOpen[joined.root(closed.triangles[i][0])] = true;
  }
};

// Returns the part that begins at a point of the surface: that of the voxel inside which is nearest along a row.
std::vector<std::optional<std::size_t>> partsAt(const VolumeParts& parts,
                                                const std::vector<std::pair<Vec3, std::uint32_t>>& points) {
  std::vector<VoxelIndex> voxels;
  voxels.reserve(6 * points.size());
  for (const auto& [p, triangle] : points) {
    const VoxelIndex near = p.array().round().cast<int>();
    for (int k = 0; k < 3; ++k)
      for (const double end : {std::floor(p[k]), std::ceil(p[k])}) {
        voxels.push_back(near);
        voxels.back()[k] = static_cast<int>(end);
      }
  }
  const std::vector<std::optional<std::size_t>> all = parts.partsOf(voxels);
  std::vector<std::optional<std::size_t>> found(points.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i] && !found[i / 6]) found[i / 6] = all[i];
  return found;
}

}  // namespace

std::size_t removeCrumbs(SparseVolume& volume, const ClosedSurfaceInVoxels& surface, std::size_t own,
                         std::vector<std::pair<Vec3, std::uint32_t>>& points, const Progress& progress) {
  if (surface.caps.boundaries == 0) return 0;
  const VolumeParts parts(volume, progress);
  if (progress.cancelled() || parts.voxels().size() < 2) return 0;
  std::vector<bool> kept(parts.voxels().size());
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = kCrumbsPerPart * parts.voxels()[i] >= parts.voxels().front();
  OpenShells shells(surface.closed, own);
  const std::vector<std::optional<std::size_t>> partOf = partsAt(parts, points);
  std::map<std::uint32_t, std::map<std::size_t, std::size_t>> votes;  // points of each shell in each part
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!partOf[i] || points[i].second >= own) continue;
    const std::uint32_t shell = shells.joined.root(surface.closed.triangles[points[i].second][0]);
    if (shells.isOpen[shell])
      ++votes[shell][*partOf[i]];
    else
      kept[*partOf[i]] = true;
  }
  for (const auto& [shell, ofParts] : votes) {
    if (shells.area[shell] < kCrumbArea * shells.whole) continue;
    const auto main = std::max_element(ofParts.begin(), ofParts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    kept[main->first] = true;
  }
  const auto removed = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
  if (removed == 0) return 0;
  volume = parts.without(kept);
  std::size_t left = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!partOf[i] || kept[*partOf[i]]) points[left++] = points[i];
  points.resize(left);
  return removed;
}

}  // namespace handwheel
