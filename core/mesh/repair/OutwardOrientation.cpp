// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/OutwardOrientation.h"

#include "mesh/structure/Orientation.h"
#include "mesh/structure/Shells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {
namespace {

struct Shell {
  std::vector<Face> faces;
  Box box;
  double volume = 0.0;
  bool closed = true;
};

Shell shellOf(const HalfEdgeMesh& mesh, std::vector<Face> faces) {
  Shell shell;
  for (Face f : faces) {
    for (const Vec3& p : mesh.points(f)) shell.box.extend(p);
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) shell.closed = shell.closed && mesh.hasOpposite(h);
  }
  const Vec3 origin = shell.box.center();  // far from the world's origin the digits would go
  for (Face f : faces) {
    const TrianglePoints p = mesh.points(f);
    shell.volume += (p[0] - origin).dot((p[1] - origin).cross(p[2] - origin)) / 6.0;
  }
  shell.faces = std::move(faces);
  return shell;
}

std::vector<Shell> closedShells(const HalfEdgeMesh& mesh, Progress progress) {
  std::vector<Shell> shells;
  for (std::vector<Face>& faces : findShells(mesh, progress)) {
    if (progress.cancelled()) return {};
    Shell shell = shellOf(mesh, std::move(faces));
    if (shell.closed) shells.push_back(std::move(shell));
  }
  return shells;
}

class Nesting {
 public:
  Nesting(const HalfEdgeMesh& mesh, const Progress& progress) : m_mesh(mesh), m_progress(progress) {}

  // False as soon as it is cancelled, or has cost too much: then no answer counts.
  bool isSure() const { return m_visits <= kMostShellVisits && !m_progress.cancelled(); }

  // By the sum of the solid angles of the shell's faces at one point of the other, which is 4π inside and 0 outside
  // (van Oosterom and Strackee, "The Solid Angle of a Plane Triangle", 1983).
  bool liesIn(const Shell& inner, const Shell& outer) {
    if (!isSure() || &inner == &outer || !outer.box.contains(inner.box)) return false;
    m_visits += outer.faces.size();
    const TrianglePoints first = m_mesh.points(inner.faces.front());
    const Vec3 at = (first[0] + first[1] + first[2]) / 3.0;
    double angle = 0.0;
    for (Face f : outer.faces) {
      const TrianglePoints p = m_mesh.points(f);
      const Vec3 a = p[0] - at, b = p[1] - at, c = p[2] - at;
      const double u = a.norm(), v = b.norm(), w = c.norm();
      angle += 2.0 * std::atan2(a.dot(b.cross(c)), u * v * w + a.dot(b) * w + b.dot(c) * u + c.dot(a) * v);
    }
    return std::abs(angle) > 2.0 * std::numbers::pi;
  }

 private:
  const HalfEdgeMesh& m_mesh;
  const Progress& m_progress;
  std::size_t m_visits = 0;
};

// All half-edges of the shell run the other way; neighbours stay neighbours.
void turn(HalfEdgeMesh& mesh, const Shell& shell) {
  const auto reversedNumber = [](HalfEdge h) { return h - h % 3 + 2 - h % 3; };  // of the edge from corner k: 2 - k
  std::vector<std::pair<HalfEdge, HalfEdge>> pairs;
  for (Face f : shell.faces) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (h < mesh.opposite(h)) pairs.emplace_back(reversedNumber(h), reversedNumber(mesh.opposite(h)));
    }
  }
  for (Face f : shell.faces) mesh.setTriangle(f, reversed(mesh.triangle(f)));
  for (const auto& [g, h] : pairs) mesh.pair(g, h);
}

}  // namespace

std::size_t orientOutward(HalfEdgeMesh& mesh, Progress progress) {
  const std::vector<Shell> shells = closedShells(mesh, progress.part(0.0, 0.5));
  const auto isInsideOut = [](const Shell& s) { return s.volume < 0.0; };
  const auto suspects = static_cast<std::size_t>(std::count_if(shells.begin(), shells.end(), isInsideOut));
  if (suspects == 0 || suspects > kMostShellPairs / shells.size()) return 0;
  Nesting nesting(mesh, progress);
  std::vector<bool> mustTurn(shells.size(), false);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (!isInsideOut(shells[i])) continue;
    const auto holdsIt = [&](const Shell& s) { return nesting.liesIn(shells[i], s); };
    if (std::any_of(shells.begin(), shells.end(), holdsIt)) continue;
    for (std::size_t k = 0; k < shells.size(); ++k)
      mustTurn[k] = mustTurn[k] || k == i || nesting.liesIn(shells[k], shells[i]);
  }
  if (!nesting.isSure()) return 0;
  std::size_t faces = 0;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (!mustTurn[i]) continue;
    turn(mesh, shells[i]);
    faces += shells[i].faces.size();
  }
  return faces;
}

}  // namespace handwheel
