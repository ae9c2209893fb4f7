// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/PickRay.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "proximity/TriangleHierarchy.h"

#include <functional>

namespace handwheel {

// A bounding volume hierarchy over the faces of a mesh version. It is built on a worker and is then immutable, so it
// may be read on any thread.
class FaceHierarchy {
 public:
  explicit FaceHierarchy(const HalfEdgeMesh& mesh);

  const HalfEdgeMesh& mesh() const { return m_mesh; }
  const Box& bounds() const { return m_hierarchy.bounds(); }  // box of all live faces with finite corners

  struct Hit {
    Face face;
    Vec3 point;
    double distance;  // distance from the origin of the ray, as a multiple of the direction's length
  };
  // Returns the first face that the ray meets, from either side. Returns nothing if there is none or the ray is not
  // usable.
  std::optional<Hit> firstHit(const Ray& ray) const;

  // Calls visit(face) for each face whose box meets the box (boundaries included), and perhaps for some just outside,
  // until it returns false. Returns false if a visit returned false.
  bool forEachInBox(const Box& box, const std::function<bool(Face)>& visit) const;

  // Returns the point of the surface nearest to p. Returns nothing if there are no faces.
  std::optional<Vec3> nearest(const Vec3& p) const;

  // Returns the unit normal of the face nearest to p; zero if there is no face or it has no area.
  Vec3 normalNear(const Vec3& p) const;

  // Returns true if the surface is more than "by" (mm) in front of p. The point is seen from the eye or, without an
  // eye, from outside the model along the direction. The face "own", on which p lies, is ignored.
  bool isHidden(const Vec3& p, const std::optional<Vec3>& eye, const Vec3& direction, double by = 0.0,
                Face own = kNone) const;

 private:
  HalfEdgeMesh m_mesh;
  std::vector<Face> m_faceOf;  // face of each triangle in the hierarchy
  TriangleHierarchy m_hierarchy;
};

}  // namespace handwheel
