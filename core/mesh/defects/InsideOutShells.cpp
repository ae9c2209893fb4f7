// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/InsideOutShells.h"

#include "mesh/structure/Shells.h"
#include "mesh/structure/SolidAngle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace handwheel {
namespace {

constexpr double kVolumeRounding = 1e-14;  // a few rounding errors of area · diagonal

struct Shell {
  std::vector<Face> faces;
  Box box;
  double volume = 0.0;  // with a fan in each opening
  double area = 0.0;
  double doubt = 0.0;  // uncertainty of the volume: possible bulges over the openings, and rounding
  bool isOpen = false;
  // Returns true if the volume is negative by more than the rounding of a plate without thickness, which has no inside.
  bool isInsideOut() const { return volume < -doubt; }
};

// The chain of open half-edges from this one, each marked as seen.
std::vector<Vec3> openingAt(const HalfEdgeMesh& mesh, HalfEdge start, std::vector<bool>& seen) {
  std::vector<Vec3> points;
  for (HalfEdge h = start; !seen[h]; h = mesh.nextOpen(h)) {
    seen[h] = true;
    points.push_back(mesh.position(mesh.from(h)));
  }
  return points;
}

void addOpening(Shell& shell, const Vec3& origin, const std::vector<Vec3>& points) {
  Vec3 centre = Vec3::Zero();
  Box box;
  for (const Vec3& p : points) {
    centre += p / static_cast<double>(points.size());
    box.extend(p);
  }
  double area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 &a = points[i], &b = points[(i + 1) % points.size()];  // the fan runs against them
    shell.volume += (b - origin).dot((a - origin).cross(centre - origin)) / 6.0;
    area += 0.5 * (a - b).cross(centre - b).norm();
  }
  shell.doubt += area * box.diagonal().norm();
  shell.isOpen = true;
}

Shell shellOf(const HalfEdgeMesh& mesh, std::vector<Face> faces, std::vector<bool>& seen) {
  Shell shell;
  for (Face f : faces) {
    for (const Vec3& p : mesh.points(f)) shell.box.extend(p);
  }
  const Vec3 origin = shell.box.center();  // keeps the precision far from the world's origin
  for (Face f : faces) {
    if (!mesh.isProper(f)) continue;
    const TrianglePoints p = mesh.points(f);
    shell.volume += (p[0] - origin).dot((p[1] - origin).cross(p[2] - origin)) / 6.0;
    shell.area += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (!mesh.hasOpposite(h) && !seen[h]) addOpening(shell, origin, openingAt(mesh, h, seen));
    }
  }
  shell.doubt += kVolumeRounding * shell.area * shell.box.diagonal().norm();
  shell.faces = std::move(faces);
  return shell;
}

// Returns the shells that are closed, or so nearly closed that they have an inside.
std::vector<Shell> shellsWithInside(const HalfEdgeMesh& mesh, Progress progress) {
  std::vector<Shell> shells;
  std::vector<bool> seen(mesh.halfEdgeSlots(), false);
  for (std::vector<Face>& faces : findShells(mesh, progress)) {
    if (progress.cancelled()) return {};
    Shell shell = shellOf(mesh, std::move(faces), seen);
    if (!shell.isOpen || std::abs(shell.volume) > shell.doubt) shells.push_back(std::move(shell));
  }
  return shells;
}

class Nesting {
 public:
  Nesting(const HalfEdgeMesh& mesh, const Progress& progress, std::size_t mostVisits)
      : m_mesh(mesh), m_progress(progress), m_mostVisits(mostVisits) {}

  // Returns false once cancelled or over the limits: then no result is valid.
  bool isSure() const { return m_visits <= m_mostVisits && !m_progress.cancelled(); }

  // Returns the winding number of the outer shell around the inner one: 1 inside a body, -1 inside a cavity, 0 outside.
  // Computed as the sum of the solid angles of its faces at one point of the inner shell.
  int turnsAround(const Shell& inner, const Shell& outer) {
    if (!isSure() || &inner == &outer || !outer.box.contains(inner.box)) return 0;
    m_visits += outer.faces.size();
    const TrianglePoints first = m_mesh.points(inner.faces.front());
    const Vec3 at = (first[0] + first[1] + first[2]) / 3.0;
    double angle = 0.0;
    for (Face f : outer.faces) angle += solidAngle(m_mesh.points(f), at);
    return static_cast<int>(std::lround(angle / (4.0 * std::numbers::pi)));
  }

 private:
  const HalfEdgeMesh& m_mesh;
  const Progress& m_progress;
  std::size_t m_visits = 0;
  std::size_t m_mostVisits;
};

std::vector<std::vector<Face>> insideOutAmong(const std::vector<Shell>& shells, Nesting& nesting) {
  const auto suspects =
      static_cast<std::size_t>(std::count_if(shells.begin(), shells.end(), std::mem_fn(&Shell::isInsideOut)));
  if (suspects == 0 || suspects > kMostShellPairs / shells.size()) return {};
  std::vector<std::vector<Face>> found;
  std::vector<bool> isFound(shells.size(), false);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (!shells[i].isInsideOut()) continue;
    const auto holdsIt = [&](const Shell& s) { return nesting.turnsAround(shells[i], s) != 0; };
    if (std::any_of(shells.begin(), shells.end(), holdsIt)) continue;
    std::vector<Face>& body = found.emplace_back();
    for (std::size_t k = 0; k < shells.size(); ++k) {
      if (isFound[k] || (k != i && nesting.turnsAround(shells[k], shells[i]) == 0)) continue;
      isFound[k] = true;
      body.insert(body.end(), shells[k].faces.begin(), shells[k].faces.end());
    }
  }
  return nesting.isSure() ? found : std::vector<std::vector<Face>>();
}

std::vector<std::vector<Face>> nestedAmong(const std::vector<Shell>& shells, Nesting& nesting) {
  if (shells.size() < 2 || shells.size() > kMostShellPairs / shells.size()) return {};
  const auto isSolid = [](const Shell& shell) { return !shell.isOpen && std::abs(shell.volume) > shell.doubt; };
  std::vector<std::vector<Face>> found;
  for (const Shell& shell : shells) {
    if (!isSolid(shell)) continue;
    int outside = 0;
    for (const Shell& other : shells)
      if (isSolid(other)) outside += nesting.turnsAround(shell, other);
    const int inside = outside + (shell.volume > 0.0 ? 1 : -1);
    if ((outside > 0) == (inside > 0)) found.push_back(shell.faces);
  }
  return nesting.isSure() ? found : std::vector<std::vector<Face>>();
}

}  // namespace

std::vector<std::vector<Face>> findInsideOutShells(const HalfEdgeMesh& mesh, Progress progress) {
  const std::vector<Shell> shells = shellsWithInside(mesh, progress.part(0.0, 0.5));
  Nesting nesting(mesh, progress, kMostShellVisits);
  return insideOutAmong(shells, nesting);
}

std::vector<std::vector<Face>> findNestedBodies(const HalfEdgeMesh& mesh, Progress progress) {
  const std::vector<Shell> shells = shellsWithInside(mesh, progress.part(0.0, 0.5));
  Nesting nesting(mesh, progress, kMostShellVisits);
  return nestedAmong(shells, nesting);
}

ShellFaults findShellFaults(const HalfEdgeMesh& mesh, Progress progress) {
  constexpr std::size_t kFewVisits = 2'000'000;  // a tenth of a second
  const std::vector<Shell> shells = shellsWithInside(mesh, progress.part(0.0, 0.5));
  Nesting turned(mesh, progress, kMostShellVisits), nested(mesh, progress, kFewVisits);
  return {insideOutAmong(shells, turned), nestedAmong(shells, nested).size()};
}

std::size_t orientOutward(HalfEdgeMesh& mesh, Progress progress) {
  std::size_t faces = 0;
  for (const std::vector<Face>& body : findInsideOutShells(mesh, progress)) {
    reverseShells(mesh, body);
    faces += body.size();
  }
  return faces;
}

}  // namespace handwheel
