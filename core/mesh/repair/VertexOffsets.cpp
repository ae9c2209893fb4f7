// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/VertexOffsets.h"

#include <algorithm>

namespace handwheel {
namespace {

// Each of the n² divisions of such a fan needs two directions; with 24 faces that takes some milliseconds.
constexpr std::size_t kMostDividedFaces = 24;
constexpr double kLeastGap = 1e-3;  // least gap of the triangles between the parts, like the margin of widestBehind()

double volumeOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.dot(b.cross(c));
}

// Returns the direction behind a part of a fan, closed by the plane through its first edge and its end.
DirectionBehind behindPart(const std::vector<FanFace>& fan, std::size_t begin, std::size_t end) {
  std::vector<Vec3> normals;
  for (std::size_t i = begin; i != end; i = (i + 1) % fan.size()) normals.push_back(fan[i].face.normal);
  normals.push_back(fan[end].edge.cross(fan[begin].edge).stableNormalized());
  return widestBehind(std::move(normals));
}

}  // namespace

VertexOffsets vertexOffsets(const std::vector<FanFace>& fan, bool isClosed) {
  std::vector<FaceAtVertex> faces;
  faces.reserve(fan.size());
  for (const FanFace& f : fan) faces.push_back(f.face);
  if (const Vec3 offset = offsetBehind(faces); !offset.isZero()) return {{offset}};
  VertexOffsets best;
  if (!isClosed || fan.size() > kMostDividedFaces) return best;
  double most = 0.0;
  for (std::size_t begin = 0; begin < fan.size(); ++begin) {
    for (std::size_t end = begin + 2; end < fan.size() && end + 2 <= begin + fan.size(); ++end) {
      const DirectionBehind first = behindPart(fan, begin, end);
      if (first.margin <= most) continue;
      const DirectionBehind second = behindPart(fan, end, begin);
      // The triangles between both parts must not flip.
      const double gap = std::min(volumeOf(second.direction, first.direction, fan[begin].edge),
                                  volumeOf(first.direction, second.direction, fan[end].edge));
      if (gap < kLeastGap || std::min(second.margin, gap) <= most) continue;
      most = std::min({first.margin, second.margin, gap});
      best = {{first.direction, second.direction}, begin, end};
    }
  }
  return best;
}

}  // namespace handwheel
