// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/PatchRemeshing.h"

#include "mesh/holes/EvenRemeshing.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/Weld.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace handwheel {
namespace {

constexpr double kLongEdge = 1.6;  // an even patch has no edges that are longer, in lengths of outline edges
constexpr double kLeastRoundness = 0.3;

using Numbers = std::unordered_map<Vertex, std::uint32_t>;

bool isOnOutline(const HalfEdgeMesh& mesh, const FaceSelection& patch, HalfEdge h) {
  return !mesh.hasOpposite(h) || !patch.contains(HalfEdgeMesh::face(mesh.opposite(h)));
}

// A patch as a surface of its own, whose first points are those on its outline.
struct Extract {
  TriangleSoup soup;
  std::vector<Vertex> vertexOf;                                         // the vertices of the points
  std::map<std::pair<std::uint32_t, std::uint32_t>, HalfEdge> outside;  // opposites of the outline's half-edges
  EvenRemeshing wanted;
  bool hasSeam = false;
};

double lengthOf(const HalfEdgeMesh& mesh, HalfEdge h) {
  return (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
}

// Sets the wanted length at each point of the outline to the mean of the outline's edges there.
void setLengths(const HalfEdgeMesh& mesh, const std::vector<HalfEdge>& outline, const Numbers& number, Extract& patch) {
  const std::size_t n = patch.vertexOf.size();
  std::vector<double> sum(n, 0.0);
  std::vector<int> count(n, 0);
  for (const HalfEdge h : outline) {
    for (const Vertex v : {mesh.from(h), mesh.to(h)}) {
      sum[number.at(v)] += lengthOf(mesh, h);
      ++count[number.at(v)];
    }
  }
  for (std::size_t i = 0; i < n; ++i) patch.wanted.lengths.push_back(sum[i] / count[i]);
}

// Lists the edges outside of the patch that join two points of its outline.
void setJoined(const HalfEdgeMesh& mesh, const FaceSelection& faces, const std::vector<HalfEdge>& outline,
               const Numbers& number, Extract& patch) {
  for (const HalfEdge h : outline) {
    for (const HalfEdge g : mesh.fan(h)) {
      const auto other = number.find(mesh.to(g));
      if (faces.contains(HalfEdgeMesh::face(g)) || other == number.end()) continue;
      patch.wanted.joined.emplace_back(std::minmax(number.at(mesh.from(g)), other->second));
    }
  }
  auto& joined = patch.wanted.joined;
  std::sort(joined.begin(), joined.end());
  joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
}

Extract extract(const HalfEdgeMesh& mesh, const FaceSelection& faces) {
  Extract patch;
  Numbers number;
  std::vector<HalfEdge> outline;
  const auto put = [&](Vertex v) {
    if (!number.try_emplace(v, static_cast<std::uint32_t>(patch.vertexOf.size())).second) return;
    patch.vertexOf.push_back(v);
    patch.soup.points.push_back(mesh.position(v));
  };
  faces.forEach([&](Face f) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (isOnOutline(mesh, faces, h)) outline.push_back(h);
    }
  });
  for (const HalfEdge h : outline) put(mesh.from(h));
  setLengths(mesh, outline, number, patch);
  setJoined(mesh, faces, outline, number, patch);
  for (const HalfEdge h : outline) {
    patch.hasSeam = patch.hasSeam || mesh.isSeam(h);
    patch.outside[{number.at(mesh.from(h)), number.at(mesh.to(h))}] = mesh.opposite(h);
  }
  faces.forEach([&](Face f) {
    Triangle t = mesh.triangle(f);
    for (std::uint32_t& v : t) {
      put(v);
      v = number.at(v);
    }
    patch.soup.triangles.push_back(t);
  });
  return patch;
}

// Returns false if two points fall together, or a triangle has no area, in this number type.
bool roundPoints(TriangleSoup& soup, std::size_t fixed, NumberType numbers) {
  for (std::size_t i = fixed; i < soup.points.size(); ++i) soup.points[i] = rounded(soup.points[i], numbers);
  if (classifyPoints(soup.points).representative.size() < soup.points.size()) return false;
  return std::none_of(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
    return isDegenerate({soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]});
  });
}

FaceSelection replaceFaces(HalfEdgeMesh& mesh, const FaceSelection& faces, const Extract& patch,
                           const TriangleSoup& even) {
  std::vector<Vertex> vertex(patch.vertexOf.begin(),
                             patch.vertexOf.begin() + static_cast<std::ptrdiff_t>(patch.wanted.lengths.size()));
  for (std::size_t i = vertex.size(); i < even.points.size(); ++i) vertex.push_back(mesh.addVertex(even.points[i]));
  faces.forEach([&](Face f) { mesh.removeFace(f); });
  const auto first = static_cast<Face>(mesh.faceSlots());
  FaceSelection added;
  for (const Triangle& t : even.triangles) added.add(mesh.addFace({vertex[t[0]], vertex[t[1]], vertex[t[2]]}));
  const EdgeTable edges(even.triangles, even.points.size());
  edges.forEachEdge([&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
    const HalfEdge h = 3 * first + run[0].halfEdge;
    if (run.size() == 2) return mesh.pair(h, 3 * first + run[1].halfEdge);
    const std::uint32_t from = even.triangles[run[0].halfEdge / 3][run[0].halfEdge % 3];
    const HalfEdge outside = patch.outside.at({from, from == low ? high : low});
    if (outside < static_cast<HalfEdge>(Open::Seam)) mesh.pair(h, outside);
  });
  return added;
}

}  // namespace

RemeshedPatch remeshToSurroundings(HalfEdgeMesh& mesh, const FaceSelection& patch, const SubdivisionLimits& limits) {
  Extract extracted = extract(mesh, patch);
  if (extracted.wanted.lengths.empty()) return {SubdivisionFailure::NoEdgeInside, {}};
  if (extracted.hasSeam) return {SubdivisionFailure::NotManifold, {}};
  if (expectedTriangles(extracted.soup, extracted.wanted.lengths) > static_cast<double>(limits.mostFaces))
    return {SubdivisionFailure::TooManyFaces, {}};
  extracted.wanted.mostPoints = limits.mostFaces / 2;
  std::optional<TriangleSoup> even = remeshEvenly(extracted.soup, extracted.wanted, limits.progress);
  if (limits.progress.cancelled()) return {SubdivisionFailure::Cancelled, {}};
  if (!even) return {SubdivisionFailure::NotManifold, {}};
  if (!roundPoints(*even, extracted.wanted.lengths.size(), limits.numbers)) return {SubdivisionFailure::TooFine, {}};
  return {SubdivisionFailure::None, replaceFaces(mesh, patch, extracted, *even)};
}

bool isEven(const HalfEdgeMesh& mesh, const FaceSelection& patch) {
  const Extract extracted = extract(mesh, patch);
  if (extracted.wanted.lengths.empty()) return true;
  const double longest =
      kLongEdge * *std::max_element(extracted.wanted.lengths.begin(), extracted.wanted.lengths.end());
  bool even = true;
  patch.forEach([&](Face f) {
    const double a = lengthOf(mesh, 3 * f), b = lengthOf(mesh, 3 * f + 1), c = lengthOf(mesh, 3 * f + 2);
    even =
        even && std::max({a, b, c}) <= longest && (b + c - a) * (c + a - b) * (a + b - c) > kLeastRoundness * a * b * c;
  });
  return even;
}

}  // namespace handwheel
