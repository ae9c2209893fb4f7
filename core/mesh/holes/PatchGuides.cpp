// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/PatchGuides.h"

#include "mesh/structure/FaceNormal.h"
#include "proximity/TriangleHierarchy.h"

#include <algorithm>
#include <map>

namespace handwheel {
namespace {

constexpr double kReach = 0.2;          // largest distance of a guide, relative to the hole's size
constexpr double kSameDirection = 0.6;  // least cosine between the normals of a guide and of the patch
constexpr std::size_t kAround = 6;      // nearest other guides that must agree
constexpr double kDisagreement = 0.03;  // largest difference from their median, of the hole's size

// A guide as seen from the patch.
struct Pull {
  std::uint32_t triangle;
  Vec3 foot;          // nearest point of the patch
  Vec3 displacement;  // from the patch to the guide
  double height;      // signed length of the displacement, positive outwards
};

std::vector<Pull> pullsOf(const HoleContext& hole, const Patch& patch, const std::vector<PatchGuide>& guides) {
  std::vector<Pull> pulls;
  const double reach = kReach * hole.size();
  Box near;
  for (const Vec3& p : patch.points) near.extend(p);
  near = Box((near.min().array() - reach).matrix(), (near.max().array() + reach).matrix());
  const TriangleHierarchy surface(patch.points, patch.triangles);
  for (const PatchGuide& guide : guides) {
    if (!near.contains(guide.point)) continue;
    const auto nearest = surface.nearest(guide.point, reach);
    if (!nearest) continue;
    const Vec3 normal = unitNormal(surface.corners(nearest->triangle)), displacement = guide.point - nearest->point;
    if (normal.dot(guide.normal) < kSameDirection) continue;
    pulls.push_back({nearest->triangle, nearest->point, displacement,
                     displacement.norm() * (displacement.dot(normal) < 0.0 ? -1.0 : 1.0)});
  }
  return pulls;
}

// Returns true if the heights of the pulls around this one are about the same.
bool agrees(const std::vector<Pull>& pulls, std::size_t i, double tolerance) {
  std::vector<std::pair<double, double>> around;  // distance and height
  for (std::size_t k = 0; k < pulls.size(); ++k)
    if (k != i) around.emplace_back((pulls[k].foot - pulls[i].foot).squaredNorm(), pulls[k].height);
  if (around.size() < kAround / 2) return false;
  const std::size_t n = std::min(kAround, around.size());
  std::partial_sort(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(n), around.end());
  std::vector<double> heights;
  for (std::size_t k = 0; k < n; ++k) heights.push_back(around[k].second);
  std::nth_element(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(n / 2), heights.end());
  return std::abs(pulls[i].height - heights[n / 2]) <= tolerance;
}

}  // namespace

std::vector<std::pair<std::uint32_t, Vec3>> guidedPoints(const HoleContext& hole, const Patch& patch,
                                                         const std::vector<PatchGuide>& guides) {
  constexpr std::size_t kMostPulls = 2000;  // each is compared with each
  std::vector<Pull> pulls = pullsOf(hole, patch, guides);
  if (pulls.size() > kMostPulls) pulls.resize(kMostPulls);
  std::map<std::uint32_t, std::pair<Vec3, int>> displacements;  // sum and number of the displacements of each point
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    if (!agrees(pulls, i, kDisagreement * hole.size())) continue;
    const Triangle& t = patch.triangles[pulls[i].triangle];
    const std::uint32_t nearest = *std::min_element(t.begin(), t.end(), [&](std::uint32_t a, std::uint32_t b) {
      return (patch.points[a] - pulls[i].foot).squaredNorm() < (patch.points[b] - pulls[i].foot).squaredNorm();
    });
    if (nearest < patch.loopSize) continue;
    auto& [sum, count] = displacements.try_emplace(nearest, Vec3::Zero(), 0).first->second;
    sum += pulls[i].displacement;
    ++count;
  }
  std::vector<std::pair<std::uint32_t, Vec3>> points;
  for (const auto& [i, displacement] : displacements)
    points.emplace_back(i, patch.points[i] + displacement.first / displacement.second);
  return points;
}

}  // namespace handwheel
