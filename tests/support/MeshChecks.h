// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"
#include "mesh/structure/TriangleSoup.h"

#include <cstring>
#include <map>
#include <set>

// Brute-force measurements of triangle lists, for testing the mesh module.
namespace handwheel::test {

using Coordinates = std::array<double, 3>;
inline Coordinates coordinates(const Vec3& p) {
  return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
}  // adding 0.0 turns -0.0 into 0.0

struct Edges {
  std::size_t all = 0, border = 0, nonManifold = 0, inconsistent = 0;
  bool closed() const { return border == 0; }
  bool sound() const { return border == 0 && nonManifold == 0 && inconsistent == 0; }
};

// Counts edges by the positions of their ends. Triangles with two equal corners are not counted.
inline Edges countEdges(const TriangleSoup& s) {
  std::map<std::pair<Coordinates, Coordinates>, std::array<int, 2>> uses;
  for (const Triangle& t : s.triangles) {
    const std::array<Coordinates, 3> p = {coordinates(s.points[t[0]]), coordinates(s.points[t[1]]),
                                          coordinates(s.points[t[2]])};
    if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Coordinates &a = p[k], &b = p[(k + 1) % 3];
      ++uses[std::minmax(a, b)][a < b];
    }
  }
  Edges e;
  for (const auto& [edge, n] : uses) {
    ++e.all;
    e.border += n[0] + n[1] == 1;
    e.nonManifold += n[0] + n[1] > 2;
    e.inconsistent += (n[0] > 1) + (n[1] > 1);
  }
  return e;
}

inline Edges countEdges(const HalfEdgeMesh& mesh) {
  return countEdges(mesh.compact().soup);
}

// Returns the positions that triangles use.
inline std::set<Coordinates> allCoordinates(const TriangleSoup& s) {
  std::set<Coordinates> result;
  for (const Triangle& t : s.triangles)
    for (std::uint32_t v : t) result.insert(coordinates(s.points[v]));
  return result;
}

// Returns the Euler characteristic V - E + F, with vertices identified by their positions.
inline long eulerCharacteristic(const TriangleSoup& s) {
  return static_cast<long>(allCoordinates(s).size()) - static_cast<long>(countEdges(s).all) +
         static_cast<long>(s.triangles.size());
}

// Returns V - E + F, with the vertices of the mesh. An edge with two faces counts once, and so does an open half-edge.
inline long eulerCharacteristic(const HalfEdgeMesh& mesh) {
  std::set<Vertex> vertices;
  long halves = 0, faces = 0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isProper(f)) continue;
    ++faces;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      vertices.insert(mesh.from(h));
      halves += mesh.hasOpposite(h) ? 1 : 2;
    }
  }
  return static_cast<long>(vertices.size()) - halves / 2 + faces;
}

inline double area(const TriangleSoup& s) {
  double sum = 0.0;
  for (const Triangle& t : s.triangles)
    sum += 0.5 * (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]).norm();
  return sum;
}

// Returns the signed volume of the cone from the origin to the triangles.
inline double volume(const TriangleSoup& s) {
  double sum = 0.0;
  for (const Triangle& t : s.triangles) sum += s.points[t[0]].dot(s.points[t[1]].cross(s.points[t[2]])) / 6.0;
  return sum;
}

inline std::size_t countBorder(const HalfEdgeMesh& mesh) {
  std::size_t n = 0;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) n += mesh.isBorder(h);
  return n;
}

inline std::size_t countSeams(const HalfEdgeMesh& mesh) {
  std::size_t n = 0;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) n += mesh.isSeam(h);
  return n;
}

// Returns the number of pairs of triangles with area that intersect, by testing all pairs.
inline std::size_t meetingPairs(const TriangleSoup& s) {
  std::vector<std::pair<TrianglePoints, Box>> proper;
  for (const Triangle& t : s.triangles) {
    const TrianglePoints p = {s.points[t[0]], s.points[t[1]], s.points[t[2]]};
    if (!isDegenerate(p)) proper.emplace_back(p, Box(p[0]).extend(p[1]).extend(p[2]));
  }
  std::size_t n = 0;
  for (std::size_t i = 0; i < proper.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      n += proper[i].second.intersects(proper[j].second) && trianglesMeet(proper[i].first, proper[j].first);
  return n;
}

inline std::size_t meetingPairs(const HalfEdgeMesh& mesh) {
  return meetingPairs(mesh.compact().soup);
}

// Returns the components of a mesh that are connected across paired edges.
inline std::vector<TriangleSoup> pieces(const HalfEdgeMesh& mesh) {
  std::vector<bool> seen(mesh.faceSlots(), false);
  std::vector<TriangleSoup> result;
  for (Face seed = 0; seed < mesh.faceSlots(); ++seed) {
    if (seen[seed]) continue;
    std::vector<Face> faces{seed};
    seen[seed] = true;
    TriangleSoup piece;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto n = static_cast<std::uint32_t>(piece.points.size());
      for (const Vec3& p : mesh.points(faces[i])) piece.points.push_back(p);
      piece.triangles.push_back({n, n + 1, n + 2});
      for (HalfEdge h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h) {
        if (!mesh.hasOpposite(h) || seen[HalfEdgeMesh::face(mesh.opposite(h))]) continue;
        seen[HalfEdgeMesh::face(mesh.opposite(h))] = true;
        faces.push_back(HalfEdgeMesh::face(mesh.opposite(h)));
      }
    }
    result.push_back(piece);
  }
  return result;
}

inline bool sameBits(const Vec3& a, const Vec3& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double[3])) == 0;
}

// Returns the vertex at exactly this position, or kNone if there is none.
inline Vertex vertexAt(const HalfEdgeMesh& mesh, const Vec3& p) {
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.position(v) == p) return v;
  return kNone;
}

// Returns true if all slots of two meshes are equal, bit for bit.
inline bool sameMesh(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  if (a.vertexSlots() != b.vertexSlots() || a.faceSlots() != b.faceSlots()) return false;
  for (Vertex v = 0; v < a.vertexSlots(); ++v)
    if (!sameBits(a.position(v), b.position(v))) return false;
  for (Face f = 0; f < a.faceSlots(); ++f) {
    if (a.triangle(f) != b.triangle(f)) return false;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
      if (a.opposite(h) != b.opposite(h)) return false;
  }
  return true;
}

}  // namespace handwheel::test
