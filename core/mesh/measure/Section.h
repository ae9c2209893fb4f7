// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// One curve of a section.
struct SectionCurve {
  std::vector<Vec3> points;  // mm; no two in a row are equal
  bool closed = true;        // the last point joins the first; an open curve ends at the border of the surface
};

// The intersection curves of a plane and a mesh. Seen from the side to which the plane's normal points, the curves have
// the material on their left: outlines run counter-clockwise, those of hollows clockwise.
struct Section {
  std::vector<SectionCurve> curves;
  double length = 0.0;  // mm, sum over all curves
  double area = 0.0;    // mm², enclosed by the closed curves: overlapping areas count once, hollows do not count
  bool isClosed = true;
  std::size_t facesInPlane = 0;
  bool isTouched = false;  // a vertex lies in the plane
};

// Orthonormal axes of a plane with a unit normal. u, v and the normal form a right-handed system. For the normal X, u
// and v are Y and Z; for Y, −X and Z; for Z, X and Y.
struct PlaneAxes {
  Vec3 u, v;
};
PlaneAxes axesOfPlane(const Vec3& normal);

// Computes the section of a mesh by a plane. The plane consists of the points p with normal · p = offset (mm); the
// normal has unit length. Vertices in the plane itself, up to rounding, count as below it, so the result is that of a
// plane just above: each face is cut in one segment or not at all, and the curves of a closed mesh are closed
// (Edelsbrunner, Mücke, "Simulation of simplicity", 1990). If faces lie in the plane, the result is that of a plane
// just below instead, so the wall on top of a body is its outline; shells that begin in the plane are cut just above
// it. The points of the curves lie on the edges of the mesh, up to the rounding error of one division. Faces with a
// corner that is not finite, or with a repeated corner, are left out. The result is invalid if cancelled. O(faces),
// plus the cost of coveredArea().
Section sectionOf(const HalfEdgeMesh& mesh, const Vec3& normal, double offset, Progress progress = {});

}  // namespace handwheel
