// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/EdgeCollapse.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace handwheel {
namespace {

// The vertices around one, sorted.
struct Ring {
  std::vector<Vertex> vertices;
  bool isOpen = false;
  bool isTooLarge = false;
};

Ring ringOf(const HalfEdgeMesh& mesh, HalfEdge h) {
  Ring ring;
  ring.isTooLarge = !forEachInFan(mesh, h, [&](HalfEdge g) {
    ring.vertices.push_back(mesh.to(g));
    const HalfEdge back = HalfEdgeMesh::previous(g);
    if (!mesh.hasOpposite(back)) {
      ring.isOpen = true;
      ring.vertices.push_back(mesh.from(back));
    }
    return ring.vertices.size() <= kLargestFan;
  });
  std::sort(ring.vertices.begin(), ring.vertices.end());
  return ring;
}

Vertex apex(const HalfEdgeMesh& mesh, HalfEdge h) {
  return mesh.from(HalfEdgeMesh::previous(h));
}

// Returns true if the two remaining edges of the face of h can become one: at least one has a neighbour, and their
// neighbours are not folded onto each other.
bool canClose(const HalfEdgeMesh& mesh, HalfEdge h) {
  const HalfEdge one = HalfEdgeMesh::next(h), two = HalfEdgeMesh::previous(h);
  if (!mesh.hasOpposite(one) || !mesh.hasOpposite(two)) return mesh.hasOpposite(one) || mesh.hasOpposite(two);
  return apex(mesh, mesh.opposite(one)) != apex(mesh, mesh.opposite(two));
}

// Makes the neighbours at the two edges opposite to each other; a seam stays a seam.
void close(HalfEdgeMesh& mesh, HalfEdge h) {
  const HalfEdge one = HalfEdgeMesh::next(h), two = HalfEdgeMesh::previous(h);
  const bool hasOne = mesh.hasOpposite(one), hasTwo = mesh.hasOpposite(two);
  const HalfEdge a = mesh.opposite(one), b = mesh.opposite(two);
  mesh.removeFace(HalfEdgeMesh::face(h));
  if (hasOne) mesh.setOpposite(a, b);
  if (hasTwo) mesh.setOpposite(b, a);
}

}  // namespace

bool canCollapse(const HalfEdgeMesh& mesh, HalfEdge h) {
  const bool isInner = mesh.hasOpposite(h);
  if (!canClose(mesh, h) || (isInner && !canClose(mesh, mesh.opposite(h)))) return false;
  const Ring a = ringOf(mesh, h), b = ringOf(mesh, HalfEdgeMesh::next(h));
  if (a.isTooLarge || b.isTooLarge || (isInner && a.isOpen && b.isOpen)) return false;
  if (std::count(a.vertices.begin(), a.vertices.end(), mesh.to(h)) != 1) return false;  // another edge joins them too
  std::vector<Vertex> common;
  std::set_intersection(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                        std::back_inserter(common));
  return common.size() == (isInner ? 2u : 1u);
}

HalfEdge collapseEdge(HalfEdgeMesh& mesh, HalfEdge h, const Vec3& p) {
  const Vertex a = mesh.from(h);
  const HalfEdge o = mesh.opposite(h);
  const bool isInner = mesh.hasOpposite(h);
  // A half-edge that starts at the vertex afterwards is opposite to one of the two edges of the first face.
  const HalfEdge one = HalfEdgeMesh::next(h), two = HalfEdgeMesh::previous(h);
  const HalfEdge leaving = mesh.hasOpposite(two) ? mesh.opposite(two) : HalfEdgeMesh::next(mesh.opposite(one));
  forEachInFan(mesh, one, [&](HalfEdge g) {
    mesh.setCorner(g, a);
    return true;
  });
  mesh.setOpen(h, Open::Border);
  if (isInner) {
    mesh.setOpen(o, Open::Border);
    close(mesh, o);
  }
  close(mesh, h);
  mesh.setPosition(a, p);
  return leaving;
}

}  // namespace handwheel
