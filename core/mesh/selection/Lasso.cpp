// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/selection/Lasso.h"

#include "mesh/search/PointInPolygonTester.h"
#include "mesh/structure/FaceNormal.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace handwheel {
namespace {

// Vertices or faces examined between two polls of the cancel flag.
constexpr std::size_t kChunk = 4096;

// Calls visit(i) for all i < n, in parallel. Returns false if cancelled.
template <class Visit>
bool forEachIndex(std::size_t n, const Progress& progress, Visit visit) {
  std::atomic<std::size_t> done = 0;
  const tbb::blocked_range<std::size_t> all(0, n, kChunk);
  tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t first = range.begin(); first < range.end() && !progress.cancelled(); first += kChunk) {
      const std::size_t end = std::min(first + kChunk, range.end());
      for (std::size_t i = first; i < end; ++i) visit(i);
      progress.set(static_cast<double>(done += end - first) / static_cast<double>(n));
    }
  });
  return !progress.cancelled();
}

// Returns a direction in the middle of the lasso, so that every ray meets the plane perpendicular to it.
Vec3 forwardOf(const std::vector<Ray>& rays) {
  Vec3 sum = Vec3::Zero();
  for (const Ray& ray : rays) sum += ray.direction.stableNormalized();
  return sum;
}

// Tests if a face has its front and its centre visible to the viewer.
class Visibility {
 public:
  Visibility(const FaceHierarchy& faces, const std::optional<Vec3>& eye, const Vec3& forward)
      : m_faces(faces), m_eye(eye), m_forward(forward) {}

  bool operator()(Face f) const {
    const TrianglePoints t = m_faces.mesh().points(f);
    const Vec3 centre = t[0] + (t[1] - t[0]) / 3.0 + (t[2] - t[0]) / 3.0;
    const Vec3 pickRay = m_eye ? Vec3(centre - *m_eye) : m_forward;
    return unitNormal(t).dot(pickRay) <= 0.0 && !m_faces.isHidden(centre, m_eye, pickRay, 0.0, f);
  }

 private:
  const FaceHierarchy& m_faces;
  std::optional<Vec3> m_eye;
  Vec3 m_forward;
};

}  // namespace

std::optional<FaceSelection> facesInLasso(const FaceHierarchy& faces, const Lasso& lasso, Progress progress) {
  std::vector<Ray> rays = lasso.rays;
  std::erase_if(rays, [](const Ray& ray) { return !ray.isUsable(); });
  const Vec3 forward = forwardOf(rays);
  if (rays.size() < 3 || forward.isZero(0.0) || (lasso.eye && !lasso.eye->allFinite())) return FaceSelection();

  const PickRayPlane plane(lasso.eye, rays.front().origin, forward);
  std::vector<PickRayPlane::Vec2> corners;
  for (const Ray& ray : rays) {
    const auto projected = plane.projected(ray);
    if (!projected || !projected->allFinite()) return FaceSelection();
    corners.push_back(*projected);
  }
  const PointInPolygonTester polygon(corners);

  const HalfEdgeMesh& mesh = faces.mesh();
  std::vector<std::uint8_t> inside(mesh.vertexSlots());
  std::vector<std::uint8_t> selected(mesh.faceSlots());
  const Visibility isVisible(faces, lasso.eye, plane.forward());
  const bool done = forEachIndex(inside.size(), progress.part(0.0, 0.1),
                                 [&](std::size_t v) {
                                   const auto projected = plane.projected(mesh.position(static_cast<Vertex>(v)));
                                   inside[v] = projected && polygon.contains(*projected);
                                 }) &&
                    forEachIndex(selected.size(), progress.part(0.1, 1.0), [&](std::size_t i) {
                      const auto f = static_cast<Face>(i);
                      if (!mesh.isLive(f)) return;
                      const Triangle& t = mesh.triangle(f);
                      if (inside[t[0]] && inside[t[1]] && inside[t[2]]) selected[i] = lasso.through || isVisible(f);
                    });
  if (!done) return std::nullopt;
  return FaceSelection::where(selected.size(), [&](Face f) { return selected[f] != 0; });
}

}  // namespace handwheel
