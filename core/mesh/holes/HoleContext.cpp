// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/HoleContext.h"

#include <numeric>
#include <unordered_map>
#include <unordered_set>

namespace handwheel {
namespace {

constexpr int kRings = 3;  // enough for a patch that continues the tangents

std::vector<Face> facesAround(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) {
  std::vector<Face> faces;
  std::unordered_set<Face> seen;
  std::unordered_set<Vertex> visited;  // each fan is walked once, however many faces it has
  const auto addFan = [&](HalfEdge h) {
    if (!visited.insert(mesh.from(h)).second) return;
    for (HalfEdge g : mesh.fan(h)) {
      if (seen.insert(HalfEdgeMesh::face(g)).second) faces.push_back(HalfEdgeMesh::face(g));
    }
  };
  for (HalfEdge h : loop.halfEdges) {
    addFan(h);
    addFan(HalfEdgeMesh::next(h));
  }
  std::size_t begin = 0;
  for (int ring = 1; ring < kRings; ++ring) {
    const std::size_t end = faces.size();
    for (; begin < end; ++begin) {
      const Face f = faces[begin];
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) addFan(h);
    }
  }
  return faces;
}

}  // namespace

double HoleContext::size() const {
  Box box;
  for (std::size_t i = 0; i < loopSize; ++i) box.extend(points[i]);
  return box.diagonal().norm();
}

Vec3 HoleContext::outward() const {
  const Vec3 middle =
      std::accumulate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(loopSize), Vec3(Vec3::Zero())) /
      static_cast<double>(loopSize);
  Vec3 sum = Vec3::Zero();
  double size = 0.0;
  for (std::size_t i = 0; i < loopSize; ++i) {
    const Vec3 area = (points[(i + 1) % loopSize] - middle).cross(points[i] - middle);
    sum += area;
    size += area.norm();
  }
  return size > 0.0 ? Vec3(sum / size) : Vec3(Vec3::Zero());
}

HoleContext holeContext(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) {
  HoleContext context;
  context.loopSize = loop.halfEdges.size();
  std::unordered_map<Vertex, std::uint32_t> number;
  for (std::uint32_t i = 0; i < loop.halfEdges.size(); ++i) {
    const HalfEdge h = loop.halfEdges[i];
    const HalfEdge before = loop.halfEdges[(i + loop.halfEdges.size() - 1) % loop.halfEdges.size()];
    number[mesh.from(h)] = i;
    number[mesh.to(before)] = i;  // another vertex at the same position if the loop is pinched
    context.points.push_back(mesh.position(mesh.from(h)));
    context.apexes.push_back(mesh.position(mesh.from(HalfEdgeMesh::previous(h))));

    double length = 0.0;
    const std::vector<HalfEdge> fan = mesh.fan(h);
    for (HalfEdge g : fan) length += (mesh.position(mesh.to(g)) - mesh.position(mesh.from(g))).norm();
    context.edgeLength.push_back(length / static_cast<double>(fan.size()));
  }
  for (Face f : facesAround(mesh, loop)) {
    Triangle t = mesh.triangle(f);
    for (std::uint32_t& v : t) {
      const auto [at, isNew] = number.try_emplace(v, static_cast<std::uint32_t>(context.points.size()));
      if (isNew) context.points.push_back(mesh.position(v));
      v = at->second;
    }
    context.ring.push_back(t);
  }
  for (const Vec3& p : context.points) context.ringBox.extend(p);
  return context;
}

}  // namespace handwheel
