// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/SchemeSubdivision.h"

#include "mesh/openmesh/OpenMeshCopy.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/MeshBuilder.h"

#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>
#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

namespace Uniform = OpenMesh::Subdivider::Uniform;

// Attaches a scheme to a surface during its lifetime. A scheme still attached at its destruction, as after a cancel,
// would call cleanup() from the destructor of its base, where it is pure virtual.
template <class Scheme>
class Attached {
 public:
  Attached(Scheme& scheme, OpenMeshSurface& surface) : m_scheme(scheme) { m_scheme.attach(surface); }
  ~Attached() { m_scheme.detach(); }
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;

 private:
  Scheme& m_scheme;
};

// Attached for all levels: √3 treats open edges at every other one.
template <class Scheme>
void subdivideBy(Scheme& scheme, OpenMeshSurface& surface, int times, const Progress& progress) {
  const Attached<Scheme> attached(scheme, surface);
  double before = 0.0;
  for (int i = 0; i < times; ++i) {
    // Reserves the final size, for √3 more: growing would copy all elements without a poll.
    const std::size_t edges = surface.n_edges(), faces = surface.n_faces();
    surface.reserve(surface.n_vertices() + edges, 2 * edges + 3 * faces, 4 * faces);
    scheme(std::size_t{1});
    before = 0.25 + 0.75 * before;  // the last level takes most of the time
    progress.set(i + 1 == times ? 1.0 : before / double(times));
  }
}

// The tables of weights of OpenMesh end at 50, without a check.
template <class Scheme>
void subdivideTabled(OpenMeshSurface& surface, std::size_t mostNeighbours, int times, const Progress& progress) {
  Scheme scheme;
  scheme.init_weights(mostNeighbours + 1);
  subdivideBy(scheme, surface, times, progress);
}

std::size_t mostNeighbours(const OpenMeshSurface& surface) {
  std::size_t most = 6;
  for (const auto v : surface.vertices()) most = std::max(most, std::size_t(surface.valence(v)));
  return most;
}

void subdivideSurface(OpenMeshSurface& surface, const SchemeSubdivision& subdivision, std::size_t most,
                      const Progress& progress) {
  switch (subdivision.scheme) {
    case SubdivisionScheme::Loop:
      return subdivideTabled<Uniform::LoopT<OpenMeshSurface>>(surface, most, subdivision.times, progress);
    case SubdivisionScheme::Sqrt3:
      return subdivideTabled<Uniform::Sqrt3T<OpenMeshSurface>>(surface, most, subdivision.times, progress);
    case SubdivisionScheme::Butterfly: {
      Uniform::ModifiedButterflyT<OpenMeshSurface> scheme;
      return subdivideBy(scheme, surface, subdivision.times, progress);
    }
    case SubdivisionScheme::Midpoint:
      return;  // see splitAtMiddles()
  }
}

// Rounds to the number type of the file. Returns false if the ends of an edge become equal, or a point is out of range.
bool roundPoints(OpenMeshSurface& surface, NumberType numbers) {
  std::vector<Vec3> positions(surface.n_vertices());
  for (const auto v : surface.vertices()) {
    const Vec3 exact = pointOf(surface.point(v));
    const Vec3 position = rounded(exact, numbers);
    if (!position.allFinite()) return false;
    positions[std::size_t(v.idx())] = position;
    surface.set_point(v, openMeshPoint(position));
  }
  for (const auto e : surface.edges()) {
    const auto h = surface.halfedge_handle(e, 0);
    const auto from = surface.from_vertex_handle(h), to = surface.to_vertex_handle(h);
    if (positions[std::size_t(from.idx())] == positions[std::size_t(to.idx())]) return false;
  }
  return true;
}

bool isTooMany(std::size_t faces, const SchemeSubdivision& subdivision, std::size_t most) {
  for (int i = 0; i < subdivision.times; ++i) {
    if (faces > most / facesOfOne(subdivision.scheme)) return true;
    faces *= facesOfOne(subdivision.scheme);
  }
  return false;
}

using Parts = std::vector<Triangle>;

// A face with the vertices in the middles of its edges; kNone for an edge that stays whole.
Parts partsOf(const Triangle& v, const Triangle& m) {
  const auto isSplit = [&](std::size_t k) { return m[k % 3] != kNone; };
  const auto split = std::count_if(m.begin(), m.end(), [](Vertex x) { return x != kNone; });
  if (split == 0) return {v};
  if (split == 3) return {m, {v[0], m[0], m[2]}, {v[1], m[1], m[0]}, {v[2], m[2], m[1]}};
  std::size_t k = 0;  // the edge that is split, or the first of two
  while (!isSplit(k) || (split == 2 && !isSplit(k + 1))) ++k;
  const std::size_t l = (k + 1) % 3, o = (k + 2) % 3;
  if (split == 1) return {{v[k], m[k], v[o]}, {m[k], v[l], v[o]}};
  return {{m[k], v[l], m[l]}, {v[k], m[k], m[l]}, {v[k], m[l], v[o]}};
}

// Replaces a face by its parts, without those that rounding collapsed to an edge.
void replace(HalfEdgeMesh& mesh, Face f, Parts parts) {
  std::erase_if(parts, [&](const Triangle& t) {
    const Vec3 &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
    return a == b || b == c || c == a;
  });
  if (parts.empty()) return mesh.removeFace(f);
  mesh.setTriangle(f, parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) mesh.addFace(parts[i]);
}

// Inserts a vertex in the middle of every edge and splits every face accordingly. An edge between neighbouring numbers
// has no middle and stays unsplit; its faces are split to match. Too fine if all edges are so short.
SubdivisionFailure splitAtMiddles(HalfEdgeMesh& mesh, NumberType numbers, const Progress& progress) {
  const auto faces = static_cast<Face>(mesh.faceSlots());
  const std::size_t vertices = mesh.vertexSlots();
  std::vector<Vertex> middles(mesh.halfEdgeSlots(), kNone);
  for (Face f = 0; f < faces; ++f) {
    if (!pollProgress(f, faces, progress.part(0.0, 0.5))) return SubdivisionFailure::Cancelled;
    if (!mesh.isLive(f) || !mesh.isProper(f)) continue;
    const Triangle v = mesh.triangle(f);
    Triangle m{};
    for (HalfEdge k = 0; k < 3; ++k) {
      const HalfEdge h = 3 * f + k;
      if (middles[h] == kNone) {
        const Vec3 &a = mesh.position(v[k]), &b = mesh.position(v[(k + 1) % 3]);
        const Vec3 middle = rounded(Vec3(0.5 * a + 0.5 * b), numbers);
        if (middle == a || middle == b) {
          m[k] = kNone;
          continue;
        }
        middles[h] = mesh.addVertex(middle);
        if (mesh.hasOpposite(h)) middles[mesh.opposite(h)] = middles[h];
      }
      m[k] = middles[h];
    }
    replace(mesh, f, partsOf(v, m));
  }
  if (mesh.vertexSlots() == vertices && faces > 0) return SubdivisionFailure::TooFine;
  relink(mesh, progress.part(0.5, 1.0));
  return progress.cancelled() ? SubdivisionFailure::Cancelled : SubdivisionFailure::None;
}

SubdivisionFailure splitAllAtMiddles(HalfEdgeMesh& mesh, int times, NumberType numbers, const Progress& progress) {
  HalfEdgeMesh result = mesh;
  double from = 0.0;
  for (int i = 0; i < times; ++i) {
    const double to = i + 1 == times ? 1.0 : 0.25 + 0.75 * from;
    if (const auto failure = splitAtMiddles(result, numbers, progress.part(from, to));
        failure != SubdivisionFailure::None)
      return failure;
    from = to;
  }
  mesh = std::move(result);
  return SubdivisionFailure::None;
}

}  // namespace

std::size_t facesOfOne(SubdivisionScheme scheme) {
  return scheme == SubdivisionScheme::Sqrt3 ? 3 : 4;
}

SchemeOutcome subdivideAll(HalfEdgeMesh& mesh, const SchemeSubdivision& subdivision, const SubdivisionLimits& limits) {
  if (isTooMany(mesh.liveFaceCount(), subdivision, limits.mostFaces)) return {SubdivisionFailure::TooManyFaces, {}};
  const Progress& progress = limits.progress;
  if (subdivision.scheme == SubdivisionScheme::Midpoint)
    return {splitAllAtMiddles(mesh, subdivision.times, limits.numbers, progress), {}};
  OpenMeshCopy copy;
  if (const auto refusal = copy.take(mesh, progress.part(0.0, 0.1)); refusal != OpenMeshRefusal::None)
    return {SubdivisionFailure::None, refusal};
  if (progress.cancelled()) return {SubdivisionFailure::Cancelled, {}};  // the copy may be half linked
  if (copy.hasSeams()) return {SubdivisionFailure::None, OpenMeshRefusal::Seam};
  const std::size_t most = mostNeighbours(copy.surface());
  if (subdivision.scheme == SubdivisionScheme::Butterfly && most > kMostButterflyNeighbours)
    return {SubdivisionFailure::None, OpenMeshRefusal::Hub};
  try {
    copy.surface().poll(progress);
    subdivideSurface(copy.surface(), subdivision, most, progress.part(0.1, 0.8));
    if (!roundPoints(copy.surface(), limits.numbers)) return {SubdivisionFailure::TooFine, {}};
    if (copy.bringBack(mesh, progress.part(0.8, 1.0))) return {};
  } catch (const OpenMeshSurface::Cancelled&) {
  }
  return {SubdivisionFailure::Cancelled, {}};
}

}  // namespace handwheel
