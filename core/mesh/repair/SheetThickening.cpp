// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/SheetThickening.h"

#include "base/Tolerance.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <unordered_set>

namespace handwheel {
namespace {

class Back {
 public:
  Back(HalfEdgeMesh& mesh, const std::vector<Face>& sheet, double thickness, NumberType numbers)
      : m_mesh(mesh), m_sheet(sheet), m_thickness(thickness), m_numbers(numbers) {}

  std::vector<Face> make() {
    for (Face f : m_sheet) look(f);
    for (Face f : m_sheet) cover(f);
    return std::move(m_faces);
  }

 private:
  struct Corner {
    Vec3 normal = Vec3::Zero();  // sum of the faces' unit normals
    double shortest = std::numeric_limits<double>::infinity();
    bool open = false;
    Vertex back = kNone;
  };

  Vec3 normal(Face f) const {
    const TrianglePoints p = m_mesh.points(f);
    return (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
  }

  void look(Face f) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      Corner& from = m_corners[m_mesh.from(h)];
      Corner& to = m_corners[m_mesh.to(h)];
      const double length = (m_mesh.position(m_mesh.to(h)) - m_mesh.position(m_mesh.from(h))).norm();
      from.normal += normal(f);
      from.shortest = std::min(from.shortest, length);
      to.shortest = std::min(to.shortest, length);
      if (!m_mesh.hasOpposite(h)) from.open = to.open = true;
    }
  }

  double depth(double shortestEdge) const { return std::min(m_thickness, tolerance::kSheetOffsetEdge * shortestEdge); }

  Vertex behind(const Vec3& p, const Vec3& normalSum, double by) {
    return m_mesh.addVertex(rounded(Vec3(p - by * normalSum.stableNormalized()), m_numbers));
  }

  Vertex back(Vertex v) {
    Corner& c = m_corners.at(v);
    if (c.open) return v;
    if (c.back == kNone) c.back = behind(m_mesh.position(v), c.normal, depth(c.shortest));
    return c.back;
  }

  // The vertex behind the middle of an edge whose ends are both open; kNone for other edges.
  Vertex middle(HalfEdge h) {
    if (!m_mesh.hasOpposite(h) || !m_corners.at(m_mesh.from(h)).open || !m_corners.at(m_mesh.to(h)).open) return kNone;
    const HalfEdge g = m_mesh.opposite(h);
    const auto [at, isNew] = m_middles.emplace(std::min(g, h), kNone);
    if (isNew) {
      const Vec3 a = m_mesh.position(m_mesh.from(h)), b = m_mesh.position(m_mesh.to(h));
      at->second =
          behind(0.5 * (a + b), normal(HalfEdgeMesh::face(h)) + normal(HalfEdgeMesh::face(g)), depth((b - a).norm()));
    }
    return at->second;
  }

  void add(Vertex a, Vertex b, Vertex c) { m_faces.push_back(m_mesh.addFace({c, b, a})); }  // turned

  void cover(Face f) {
    std::array<Vertex, 3> v{}, m{};  // m[k] is on the edge from corner k
    for (HalfEdge k = 0; k < 3; ++k) {
      v[k] = back(m_mesh.triangle(f)[k]);
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
          split == 1
              ? static_cast<int>(std::find_if(m.begin(), m.end(), [](Vertex x) { return x != kNone; }) - m.begin())
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

  // A face none of whose edges is split: one with its three edges open would lie on its back.
  void coverWhole(Face f, const std::array<Vertex, 3>& v) {
    if (v != m_mesh.triangle(f)) return add(v[0], v[1], v[2]);
    const TrianglePoints p = m_mesh.points(f);
    const double shortest = std::min({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
    const Vertex c = behind((p[0] + p[1] + p[2]) / 3.0, normal(f), depth(shortest));
    for (int k = 0; k < 3; ++k) add(v[k], v[(k + 1) % 3], c);
  }

  HalfEdgeMesh& m_mesh;
  const std::vector<Face>& m_sheet;
  double m_thickness;
  NumberType m_numbers;
  std::unordered_map<Vertex, Corner> m_corners;
  std::unordered_map<HalfEdge, Vertex> m_middles;  // by the smaller half-edge
  std::vector<Face> m_faces;
};

}  // namespace

std::vector<Face> thickenSheet(HalfEdgeMesh& mesh, const std::vector<Face>& sheet, double thickness,
                               NumberType numbers) {
  return Back(mesh, sheet, thickness, numbers).make();
}

std::vector<Face> sheetOf(const HalfEdgeMesh& mesh, Face f) {
  std::vector<Face> sheet{f};
  std::unordered_set<Face> seen{f};
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    for (HalfEdge h = 3 * sheet[i]; h < 3 * sheet[i] + 3; ++h) {
      if (!mesh.hasOpposite(h)) continue;
      const Face g = HalfEdgeMesh::face(mesh.opposite(h));
      if (seen.insert(g).second) sheet.push_back(g);
    }
  }
  return sheet;
}

}  // namespace handwheel
