// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/SliverPieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace handwheel {
namespace {

using Corners = std::array<Vec3, 3>;

constexpr double kOverlapping = 16.0;  // boxes over triangles, by area; ordinary surfaces have 3 or 4
constexpr double kRoom = 8.0;          // allowed for a piece's box, by the same measure
constexpr double kMostPieces = 32.0;   // per triangle
constexpr double kMostMore = 1e6;      // pieces altogether, or as many as there are triangles

double halfAreaOf(const FloatBox& box) {
  const Eigen::Array3d d = box.high.head<3>().cast<double>() - box.low.head<3>().cast<double>();
  return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
}

// A sliver, cut across its longest edge into slices of the same length.
class Sliver {
 public:
  Sliver(Corners t, const BoxFrame& frame) : m_frame(frame) {
    const auto edge = [&](std::size_t k) { return Vec3(frame.toFrame(t[(k + 1) % 3]) - frame.toFrame(t[k])); };
    const double longest = std::max({edge(0).norm(), edge(1).norm(), edge(2).norm()});
    while (edge(0).norm() < longest) std::rotate(t.begin(), t.begin() + 1, t.end());
    m_from = t[0], m_to = t[1], m_apex = t[2];
    const double at = -edge(2).dot(edge(0)) / (longest * longest);
    m_apexAt = at > 0.0 && at < 1.0 ? at : std::round(std::clamp(at, 0.0, 1.0));
  }

  // Returns the box of the part between two parameters along the edge, from 0 to 1.
  FloatBox boxOf(double begin, double end) const {
    FloatBox box = m_frame.around(onEdge(begin), onEdge(end), opposite(begin));
    const bool holdsApex = begin <= m_apexAt && m_apexAt <= end;
    const FloatBox rest = m_frame.around(onEdge(end), opposite(end), holdsApex ? m_apex : opposite(begin));
    box.low = box.low.min(rest.low);
    box.high = box.high.max(rest.high);
    return box;
  }

 private:
  static Vec3 between(const Vec3& a, const Vec3& b, double at) { return (1.0 - at) * a + at * b; }
  Vec3 onEdge(double at) const { return between(m_from, m_to, at); }
  Vec3 opposite(double at) const {
    if (at == m_apexAt) return m_apex;
    return at < m_apexAt ? between(m_from, m_apex, at / m_apexAt)
                         : between(m_to, m_apex, (1.0 - at) / (1.0 - m_apexAt));
  }

  const BoxFrame& m_frame;
  Vec3 m_from, m_to, m_apex;
  double m_apexAt = 0.0;  // along the edge
};

// Returns the wanted number of pieces of each triangle, regardless of their sum; empty if the surface is ordinary.
std::vector<double> piecesWanted(const std::vector<BoxedItem>& items, std::span<const Vec3> points,
                                 std::span<const Triangle> triangles, const BoxFrame& frame) {
  double boxes = 0.0, surface = 0.0;
  std::vector<double> wanted;
  wanted.reserve(items.size());
  for (const BoxedItem& item : items) {
    const Triangle& t = triangles[item.id()];
    const Vec3 a = frame.toFrame(points[t[0]]), ab = frame.toFrame(points[t[1]]) - a;
    const Vec3 ac = frame.toFrame(points[t[2]]) - a;
    const double box = halfAreaOf(item.box), area = 0.5 * ab.cross(ac).norm();
    boxes += box;
    surface += area;
    const bool isPoint = ab.isZero(0.0) && ac.isZero(0.0);
    wanted.push_back(isPoint ? 1.0 : std::clamp(std::floor(box / (kRoom * area)), 1.0, kMostPieces));
  }
  if (!(boxes > kOverlapping * surface)) wanted.clear();
  return wanted;
}

}  // namespace

void splitSliverBoxes(std::vector<BoxedItem>& items, std::span<const Vec3> points, std::span<const Triangle> triangles,
                      const BoxFrame& frame) {
  const std::vector<double> wanted = piecesWanted(items, points, triangles, frame);
  if (wanted.empty()) return;
  const double whole = static_cast<double>(items.size()), allowed = whole + std::max(kMostMore, whole);
  const auto total = [&](double most) {
    return std::accumulate(wanted.begin(), wanted.end(), 0.0,
                           [most](double sum, double pieces) { return sum + std::min(pieces, most); });
  };
  double most = kMostPieces;
  while (total(most) > allowed) most *= 0.5;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const int pieces = static_cast<int>(std::min(wanted[i], most));
    if (pieces < 2) continue;
    const std::uint32_t id = items[i].id();
    const Triangle& t = triangles[id];
    const Sliver sliver({points[t[0]], points[t[1]], points[t[2]]}, frame);
    for (int k = 0; k < pieces; ++k) {
      BoxedItem piece{sliver.boxOf(static_cast<double>(k) / pieces, (k + 1.0) / pieces)};
      piece.setId(id);
      if (k == 0) {
        items[i] = piece;
      } else {
        items.push_back(piece);
      }
    }
  }
}

}  // namespace handwheel
