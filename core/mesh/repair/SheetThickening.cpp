// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/SheetThickening.h"

#include "base/Tolerance.h"
#include "mesh/repair/SelfIntersectionRemoval.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/PositionKey.h"

#include <algorithm>
#include <limits>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace handwheel {
namespace {

// The offset is a 256th of the thickness at last: nearer than that, single precision shows hardly any.
constexpr int kMostHalvings = 8;
constexpr int kMostTurns = 100;  // of a direction towards a face that it lies behind

// The direction in which a vertex goes behind all its faces: against their mean normal, or, where one of them faces the
// other way in a sharp fold, against the middle of the smallest ball around the normals (Bădoiu and Clarkson, "Smaller
// core-sets for balls", 2003). Zero where there is none, so that the vertex has to stay.
Vec3 directionOf(const std::vector<Vec3>& normals) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& n : normals) middle += n / static_cast<double>(normals.size());
  for (int i = 1; i < kMostTurns; ++i) {
    const Vec3& worst = *std::min_element(normals.begin(), normals.end(),
                                          [&](const Vec3& a, const Vec3& b) { return a.dot(middle) < b.dot(middle); });
    if (worst.dot(middle) > 0.0) return middle.stableNormalized();
    middle += (worst - middle) / (i + 1.0);
  }
  return Vec3::Zero();
}

// The backs of sheets.
class Backs {
 public:
  Backs(HalfEdgeMesh& mesh, double thickness, NumberType numbers)
      : m_mesh(mesh), m_thickness(thickness), m_numbers(numbers) {}

  void add(const std::vector<Face>& sheet) {
    m_corners.clear();
    m_middles.clear();
    for (Face f : sheet) look(f);
    for (auto& [v, corner] : m_corners) corner.stays = corner.stays || directionOf(corner.normals).isZero();
    for (Face f : sheet) cover(f);
  }

  // Halves the offset wherever a back intersects anything, until none does. Where a face is so small that its back
  // lies on it all the same, neither is needed.
  void withdraw(Progress progress) {
    const std::unordered_set<Face> backs(m_faces.begin(), m_faces.end());
    for (int i = 0; i < kMostHalvings && !progress.cancelled(); ++i) {
      std::set<Vertex> nearer;
      for (const auto& [a, b] : selfIntersectingPairs(m_mesh, m_numbers, progress)) {
        if (!m_mesh.isLive(a) || !m_mesh.isLive(b)) continue;  // removed with the other side of an earlier pair
        if (backs.contains(a) != backs.contains(b) && haveSameCorners(a, b)) {
          m_mesh.removeFace(a);
          m_mesh.removeFace(b);
        }
        for (const Face f : {a, b}) {
          if (!backs.contains(f) || !m_mesh.isLive(f)) continue;
          for (const Vertex v : m_mesh.triangle(f))
            if (m_offsets.contains(v)) nearer.insert(v);
        }
      }
      if (nearer.empty()) break;
      for (const Vertex v : nearer) {
        Offset& offset = m_offsets.at(v);
        offset.depth *= 0.5;
        m_mesh.setPosition(v, place(offset));
      }
    }
    std::erase_if(m_faces, [&](Face f) { return !m_mesh.isLive(f); });
  }

  ThickenedSheets result() {
    SheetThickness reached;
    for (const Face f : m_faces) {
      for (const Vertex v : m_mesh.triangle(f)) {
        const auto offset = m_offsets.find(v);
        if (offset == m_offsets.end()) continue;
        const double depth = (m_mesh.position(v) - offset->second.from).norm();
        reached.extend({depth, depth});
      }
    }
    return {std::move(m_faces), reached};
  }

 private:
  bool haveSameCorners(Face a, Face b) const {
    const auto sorted = [&](Face f) {
      const TrianglePoints p = m_mesh.points(f);
      return std::set<PointKey>{positionKey(p[0]), positionKey(p[1]), positionKey(p[2])};
    };
    return sorted(a) == sorted(b);
  }

  // Of a vertex behind a sheet.
  struct Offset {
    Vec3 from;
    Vec3 normal;
    double depth;
  };

  struct Corner {
    std::vector<Vec3> normals;  // of the faces
    double shortest = std::numeric_limits<double>::infinity();
    bool stays = false;  // it is open, or there is no way behind its faces
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
      from.normals.push_back(normal(f));
      from.shortest = std::min(from.shortest, length);
      to.shortest = std::min(to.shortest, length);
      if (!m_mesh.hasOpposite(h)) from.stays = to.stays = true;
    }
  }

  double depth(double shortestEdge) const { return std::min(m_thickness, tolerance::kSheetOffsetEdge * shortestEdge); }

  Vec3 place(const Offset& offset) const {
    return rounded(Vec3(offset.from - offset.depth * offset.normal), m_numbers);
  }

  Vertex behind(const Vec3& p, const std::vector<Vec3>& normals, double by) {
    const Offset offset{p, directionOf(normals), by};
    const Vertex v = m_mesh.addVertex(place(offset));
    m_offsets.emplace(v, offset);
    return v;
  }

  Vertex back(Vertex v) {
    Corner& c = m_corners.at(v);
    if (c.stays) return v;
    if (c.back == kNone) c.back = behind(m_mesh.position(v), c.normals, depth(c.shortest));
    return c.back;
  }

  // The vertex behind the middle of an edge whose ends both stay; kNone for other edges.
  Vertex middle(HalfEdge h) {
    if (!m_mesh.hasOpposite(h) || !m_corners.at(m_mesh.from(h)).stays || !m_corners.at(m_mesh.to(h)).stays)
      return kNone;
    const HalfEdge g = m_mesh.opposite(h);
    const auto [at, isNew] = m_middles.emplace(std::min(g, h), kNone);
    if (isNew) {
      const Vec3 a = m_mesh.position(m_mesh.from(h)), b = m_mesh.position(m_mesh.to(h));
      at->second =
          behind(0.5 * (a + b), {normal(HalfEdgeMesh::face(h)), normal(HalfEdgeMesh::face(g))}, depth((b - a).norm()));
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

  // A face none of whose edges is split: one whose corners all stay would lie on its back.
  void coverWhole(Face f, const std::array<Vertex, 3>& v) {
    if (v != m_mesh.triangle(f)) return add(v[0], v[1], v[2]);
    const TrianglePoints p = m_mesh.points(f);
    const double shortest = std::min({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
    const Vertex c = behind((p[0] + p[1] + p[2]) / 3.0, {normal(f)}, depth(shortest));
    for (int k = 0; k < 3; ++k) add(v[k], v[(k + 1) % 3], c);
  }

  HalfEdgeMesh& m_mesh;
  double m_thickness;
  NumberType m_numbers;
  std::unordered_map<Vertex, Corner> m_corners;
  std::unordered_map<HalfEdge, Vertex> m_middles;  // by the smaller half-edge
  std::unordered_map<Vertex, Offset> m_offsets;
  std::vector<Face> m_faces;
};

}  // namespace

void SheetThickness::extend(const SheetThickness& other) {
  if (other.largest <= 0.0) return;
  least = largest > 0.0 ? std::min(least, other.least) : other.least;
  largest = std::max(largest, other.largest);
}

ThickenedSheets thickenSheets(HalfEdgeMesh& mesh, const std::vector<std::vector<Face>>& sheets, double thickness,
                              NumberType numbers, Progress progress) {
  Backs backs(mesh, thickness, numbers);
  for (const std::vector<Face>& sheet : sheets) backs.add(sheet);
  backs.withdraw(progress);
  return backs.result();
}

double defaultSheetThickness(const Box& box) {
  return box.isEmpty() ? 0.0 : tolerance::kSheetThickness * box.diagonal().norm();
}

double defaultSheetThickness(const HalfEdgeMesh& mesh) {
  return defaultSheetThickness(boundsOf(mesh));
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
