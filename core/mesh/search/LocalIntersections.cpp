// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/LocalIntersections.h"

#include "mesh/search/IncrementalHierarchy.h"
#include "mesh/structure/MeshDelta.h"
#include "proximity/SelfIntersection.h"

#include <algorithm>

namespace handwheel {
namespace {

using FacePair = std::pair<Face, Face>;

bool isAmong(const std::vector<Face>& sorted, Face f) {
  return std::binary_search(sorted.begin(), sorted.end(), f);
}

// Returns the pairs of a mesh with at least one of these faces, sorted.
std::optional<std::vector<FacePair>> crossingsOf(const HalfEdgeMesh& mesh, const std::vector<Face>& faces,
                                                 Progress progress) {
  Box around;
  for (const Face f : faces)
    if (f < mesh.faceSlots() && mesh.isLive(f)) around.extend(boxOf(mesh.points(f)));
  TriangleSoup soup;
  std::vector<Face> faceOf;
  for (Face f = 0; f < mesh.faceSlots() && !around.isEmpty(); ++f) {
    if (!mesh.isLive(f) || !boxOf(mesh.points(f)).intersects(around)) continue;
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    for (const Vec3& p : mesh.points(f)) soup.points.push_back(p);
    soup.triangles.push_back({n, n + 1, n + 2});
    faceOf.push_back(f);
  }
  const auto found = selfIntersections(soup.points, soup.triangles, progress);
  if (!found) return std::nullopt;
  std::vector<FacePair> pairs;
  for (const auto& [i, k] : *found)
    if (isAmong(faces, faceOf[i]) || isAmong(faces, faceOf[k])) pairs.emplace_back(faceOf[i], faceOf[k]);
  return pairs;
}

std::size_t freshOf(const std::vector<FacePair>& before, const std::vector<FacePair>& after, std::size_t oldSlots) {
  std::vector<Face> crossed;
  for (const auto& [f, g] : before) crossed.insert(crossed.end(), {f, g});
  std::sort(crossed.begin(), crossed.end());
  const auto isFresh = [&](const FacePair& pair) {
    const auto& [f, g] = pair;  // f < g
    if (g < oldSlots) return !std::binary_search(before.begin(), before.end(), pair);
    return f < oldSlots ? !isAmong(crossed, f) : before.empty();
  };
  return static_cast<std::size_t>(std::count_if(after.begin(), after.end(), isFresh));
}

}  // namespace

std::optional<IntersectionsChange> intersectionsChange(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                                       Progress progress) {
  IntersectionsChange change;
  change.touched = MeshDelta::between(before, after).touchedFaces(before);
  std::sort(change.touched.begin(), change.touched.end());
  change.touched.erase(std::unique(change.touched.begin(), change.touched.end()), change.touched.end());
  auto present = crossingsOf(after, change.touched, progress.part(0.0, 0.5));
  if (!present) return std::nullopt;
  change.present = std::move(*present);
  if (change.present.empty()) return change;
  const auto old = crossingsOf(before, change.touched, progress.part(0.5, 1.0));
  if (!old) return std::nullopt;
  change.fresh = freshOf(*old, change.present, before.faceSlots());
  return change;
}

std::vector<FacePair> intersectionsAfter(const IntersectionsChange& change, const std::vector<FacePair>& pairs) {
  std::vector<FacePair> result = change.present;
  for (const FacePair& pair : pairs)
    if (!isAmong(change.touched, pair.first) && !isAmong(change.touched, pair.second)) result.push_back(pair);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace handwheel
