// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/OffsetSheetBuilder.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

// The smallest offset is a 256th of the thickness: less is hardly visible in single precision.
constexpr int kMostOffsetHalvings = 8;
// Below this share of the requested thickness, a body counts as thinner. If more than three planes meet, no offset has
// all of them at the same distance; on a smooth sheet the difference is smaller.
constexpr double kThin = 0.9;

}  // namespace

Vec3 unitNormal(const HalfEdgeMesh& mesh, Face f) {
  const TrianglePoints p = mesh.points(f);
  return (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
}

bool OffsetSheetBuilder::add(const OpenSheet& sheet) {
  m_corners.clear();
  m_middles.clear();
  m_thickness = sheet.thickness;
  for (Face f : sheet.faces) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
      if (const Vertex v = m_mesh.from(h); !m_corners.contains(v)) m_corners.emplace(v, cornerOf(h));
  }
  if (!hasRoom()) return false;
  m_vertices += m_corners.size();
  for (const auto& [v, corner] : m_corners) m_sharpVertices += corner.stays();
  for (Face f : sheet.faces) cover(f);
  for (Face f : sheet.faces) addSides(f);
  for (Face f : sheet.faces) closeGaps(f);
  return true;
}

const SheetOffset* OffsetSheetBuilder::offsetOf(Vertex v) const {
  const auto found = m_offsets.find(v);
  return found == m_offsets.end() ? nullptr : &found->second;
}

bool OffsetSheetBuilder::halve(Vertex v) {
  SheetOffset& offset = m_offsets.at(v);
  if (offset.halvings == kMostOffsetHalvings) return false;
  ++offset.halvings;
  offset.depth *= 0.5;
  m_mesh.setPosition(v, positionOf(offset));
  return true;
}

SheetThickness OffsetSheetBuilder::reached() const {
  SheetThickness reached;
  for (const Face f : m_faces) {
    if (!m_mesh.isLive(f)) continue;
    for (const Vertex v : m_mesh.triangle(f)) {
      const SheetOffset* const offset = offsetOf(v);
      if (!offset || offset->direction.isZero()) continue;
      const double depth = (m_mesh.position(v) - offset->from).norm() / offset->direction.norm();
      reached.extend({depth * offset->reach, depth});
    }
  }
  if (m_sharpVertices > 0) reached.least = 0.0;
  std::unordered_set<Vertex> nearer;
  for (const auto& [v, offset] : m_offsets)
    if (offset.front != kNone && std::ldexp(offset.reach, -offset.halvings) < kThin) nearer.insert(offset.front);
  reached.vertices = m_vertices;
  reached.thinVertices = m_sharpVertices + nearer.size();
  return reached;
}

std::size_t OffsetSheetBuilder::Corner::offsetOf(Face f) const {
  if (behind.offsets.size() < 2) return 0;
  const auto at = std::find_if(fan.begin(), fan.end(), [f](HalfEdge h) { return HalfEdgeMesh::face(h) == f; });
  return behind.offsetOf(static_cast<std::size_t>(at - fan.begin()));
}

OffsetSheetBuilder::Corner OffsetSheetBuilder::cornerOf(HalfEdge h) const {
  const Vertex v = m_mesh.from(h);
  const Vec3 p = m_mesh.position(v);
  Corner corner;
  corner.fan = m_mesh.fan(h);
  corner.isOpen = !m_mesh.hasOpposite(corner.fan.front());
  if (m_kept.contains(v)) return corner;
  std::vector<FanFace> faces;
  for (const HalfEdge spoke : corner.fan) {
    const Vec3 on = m_mesh.position(m_mesh.to(spoke)) - p,
               back = m_mesh.position(m_mesh.from(HalfEdgeMesh::previous(spoke))) - p;
    faces.push_back({{unitNormal(m_mesh, HalfEdgeMesh::face(spoke)), std::atan2(on.cross(back).norm(), on.dot(back))},
                     on.stableNormalized()});
  }
  corner.behind = vertexOffsets(faces, !corner.isOpen);
  for (std::size_t i = 0; i < faces.size() && !corner.stays(); ++i) {
    const std::size_t k = corner.behind.offsetOf(i);
    if (const Vec3& normal = faces[i].face.normal; !normal.isZero())
      corner.reaches[k] = std::min(corner.reaches[k], -normal.dot(corner.behind.offsets[k]));
  }
  return corner;
}

// Returns false if rounding would make a back coincide with the sheet.
bool OffsetSheetBuilder::hasRoom() const {
  return std::all_of(m_corners.begin(), m_corners.end(), [&](const auto& entry) {
    const Vec3& p = m_mesh.position(entry.first);
    const std::vector<Vec3>& offsets = entry.second.behind.offsets;
    return std::all_of(offsets.begin(), offsets.end(), [&](const Vec3& direction) {
      const Vec3 offset = m_thickness * direction;
      return (rounded(Vec3(p + offset), m_numbers) - (p + offset)).norm() <= 0.5 * offset.norm();
    });
  });
}

Vec3 OffsetSheetBuilder::positionOf(const SheetOffset& offset) const {
  return rounded(Vec3(offset.from + offset.depth * offset.direction), m_numbers);
}

Vertex OffsetSheetBuilder::behind(const SheetOffset& offset) {
  const Vertex v = m_mesh.addVertex(positionOf(offset));
  m_offsets.emplace(v, offset);
  return v;
}

// Returns the vertex behind a vertex of a face.
Vertex OffsetSheetBuilder::back(Vertex v, Face f) {
  Corner& c = m_corners.at(v);
  if (c.stays()) return v;
  const std::size_t k = c.offsetOf(f);
  if (c.backs[k] == kNone)
    c.backs[k] = behind({m_mesh.position(v), c.behind.offsets[k], m_thickness, c.reaches[k], v, c.isOpen});
  return c.backs[k];
}

// Returns the vertex behind the middle of an edge whose ends both stay; kNone for other edges.
Vertex OffsetSheetBuilder::middle(HalfEdge h) {
  if (!m_mesh.hasOpposite(h) || !m_corners.at(m_mesh.from(h)).stays() || !m_corners.at(m_mesh.to(h)).stays())
    return kNone;
  const HalfEdge g = m_mesh.opposite(h);
  const auto [at, isNew] = m_middles.emplace(std::min(g, h), kNone);
  if (isNew) {
    const Vec3 a = m_mesh.position(m_mesh.from(h)), b = m_mesh.position(m_mesh.to(h));
    const Vec3 offset = offsetBehind(
        {{unitNormal(m_mesh, HalfEdgeMesh::face(h)), 1.0}, {unitNormal(m_mesh, HalfEdgeMesh::face(g)), 1.0}});
    at->second = behind({0.5 * (a + b), offset, m_thickness, 1.0, kNone, false});
  }
  return at->second;
}

Face OffsetSheetBuilder::add(Vertex a, Vertex b, Vertex c) {  // turned
  m_faces.push_back(m_mesh.addFace({c, b, a}));
  return m_faces.back();
}

void OffsetSheetBuilder::cover(Face f) {
  std::array<Vertex, 3> v{}, m{};  // m[k] is on the edge from corner k
  for (HalfEdge k = 0; k < 3; ++k) {
    v[k] = back(m_mesh.triangle(f)[k], f);
    m[k] = middle(3 * f + k);
  }
  const auto split = std::count_if(m.begin(), m.end(), [](Vertex x) { return x != kNone; });
  if (split == 3) {
    for (int k = 0; k < 3; ++k) add(v[k], m[k], m[(k + 2) % 3]);
    add(m[0], m[1], m[2]);
  } else if (split == 0) {
    coverWhole(f, v);
  } else {  // from the middle of one split edge to the corner opposite; the other split edge lies on one side of it
    const int k =
        split == 1 ? static_cast<int>(std::find_if(m.begin(), m.end(), [](Vertex x) { return x != kNone; }) - m.begin())
                   : (static_cast<int>(std::find(m.begin(), m.end(), kNone) - m.begin()) + 1) % 3;
    const int l = (k + 1) % 3, o = (k + 2) % 3;
    add(v[k], m[k], v[o]);
    if (split == 1) {
      add(m[k], v[l], v[o]);
    } else {  // edge l is split, too
      add(m[k], v[l], m[l]);
      add(m[k], m[l], v[o]);
    }
  }
}

// Covers a face without split edges: one whose corners all stay would coincide with its back.
void OffsetSheetBuilder::coverWhole(Face f, const std::array<Vertex, 3>& v) {
  if (v != m_mesh.triangle(f)) {
    m_facePairs.emplace_back(add(v[0], v[1], v[2]), f);
    return;
  }
  const TrianglePoints p = m_mesh.points(f);
  const Vertex c = behind({(p[0] + p[1] + p[2]) / 3.0, -unitNormal(m_mesh, f), m_thickness, 1.0, kNone, false});
  for (int k = 0; k < 3; ++k) add(v[k], v[(k + 1) % 3], c);
}

// Adds the side faces behind the open edges of a face.
void OffsetSheetBuilder::addSides(Face f) {
  for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
    if (m_mesh.hasOpposite(h)) continue;
    const Vertex a = m_mesh.from(h), b = m_mesh.to(h), behindA = back(a, f), behindB = back(b, f);
    if (behindA != a) add(behindA, a, b);
    if (behindB != b) add(behindB, behindA, b);
  }
}

// Adds the faces between the parts of a divided back, behind the edges that divide it.
void OffsetSheetBuilder::closeGaps(Face f) {
  for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
    if (!m_mesh.hasOpposite(h) || m_mesh.opposite(h) < h) continue;
    const Face g = HalfEdgeMesh::face(m_mesh.opposite(h));
    const Vertex a = m_mesh.from(h), b = m_mesh.to(h);
    const Vertex behindA = back(a, f), behindB = back(b, f), otherA = back(a, g), otherB = back(b, g);
    if (otherB != behindB) add(otherB, behindB, behindA);
    if (otherA != behindA) add(otherA, otherB, behindA);
  }
}

}  // namespace handwheel
