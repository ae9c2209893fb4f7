// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/HoleBridgeSearch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace handwheel {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr std::size_t kPieceSamples = 256;  // number of sampled points of a piece, all pairs of which are tried
// A piece whose lid (HoleContext::outward) is at least this long is seen from above: there no bridge may leave it.
constexpr double kFlatLid = 0.7;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

}  // namespace

struct HoleBridgeSearch::Ranked {
  double ratio;
  HoleBridge bridge;
};

struct HoleBridgeSearch::Piece {
  std::vector<std::uint32_t> numbers;
  std::vector<Vec3> points;
  std::vector<double> along;  // distance along the border from the first point; one more entry for the total
  std::vector<Vec2> flat;     // projection seen from outside; empty if the piece has none

  Piece(const HoleContext& hole, const std::vector<std::uint32_t>& piece) : numbers(piece), along{0.0} {
    HoleContext own;
    own.loopSize = piece.size();
    for (std::uint32_t i : piece) own.points.push_back(hole.points[i]);
    points = own.points;
    for (std::size_t i = 0; i < size(); ++i) along.push_back(along[i] + (points[next(i)] - points[i]).norm());
    const Vec3 outward = own.outward();
    if (outward.norm() < kFlatLid) return;
    const Eigen::Quaterniond toSight = Eigen::Quaterniond::FromTwoVectors(outward, Vec3::UnitZ());
    for (const Vec3& p : points) flat.push_back((toSight * (p - points[0])).head<2>());
  }

  std::size_t size() const { return points.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  std::size_t previous(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }

  // Returns the length of a bridge relative to the border that it cuts off; infinite if too few edges are on one side.
  double ratio(std::size_t a, std::size_t b) const {
    const std::size_t inside = b - a, least = std::max<std::size_t>(2, size() / 4);
    if (inside < least || size() - inside < least) return std::numeric_limits<double>::infinity();
    const double border = along[b] - along[a];
    return (points[b] - points[a]).norm() / std::min(border, along.back() - border);
  }

  // Returns true if the line from point a to point b starts between the edges at a. Seen from outside a hole runs
  // clockwise, so its inside is on the right.
  bool startsInside(std::size_t a, std::size_t b) const {
    const Vec2 &p = flat[a], &before = flat[previous(a)], &after = flat[next(a)], &q = flat[b];
    if (turn(before, p, after) < 0.0) return turn(p, after, q) < 0.0 && turn(p, q, before) < 0.0;
    return !(turn(p, after, q) >= 0.0 && turn(p, q, before) >= 0.0);
  }

  bool crossesBorder(std::size_t a, std::size_t b) const {
    for (std::size_t i = 0; i < size(); ++i) {
      const std::size_t j = next(i);
      if (i == a || i == b || j == a || j == b) continue;
      const bool parted = (turn(flat[a], flat[b], flat[i]) > 0.0) != (turn(flat[a], flat[b], flat[j]) > 0.0);
      if (parted && (turn(flat[i], flat[j], flat[a]) > 0.0) != (turn(flat[i], flat[j], flat[b]) > 0.0)) return true;
    }
    return false;
  }
};

HoleBridgeSearch::HoleBridgeSearch(const HoleContext& hole, const Obstacles& obstacles)
    : m_hole(hole), m_obstacles(obstacles), m_edges(obstacles.edgesAmong(hole.loop())) {}

std::optional<HoleBridge> HoleBridgeSearch::best(const std::vector<std::uint32_t>& numbers, Progress progress) const {
  const Piece piece(m_hole, numbers);
  const std::size_t stride = (piece.size() + kPieceSamples - 1) / kPieceSamples;
  // Each sample is paired with its best partner, so that not all of them fail at the same obstacle.
  std::vector<Ranked> ranked;
  for (std::size_t a = 0; a < piece.size(); a += stride) {
    Ranked best{std::numeric_limits<double>::infinity(), {}};
    for (std::size_t b = a + stride; b < piece.size(); b += stride) {
      const double ratio = piece.ratio(a, b);
      if (ratio < best.ratio) best = {ratio, {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)}};
    }
    if (best.ratio < std::numeric_limits<double>::infinity()) ranked.push_back(best);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) { return a.ratio < b.ratio; });
  for (const Ranked& rough : ranked) {
    if (progress.cancelled()) break;
    const HoleBridge s = improved(piece, rough, stride);
    if (isFree(piece, s)) return s;
  }
  return std::nullopt;
}

// Returns the best bridge between points near the ends of a rough one.
HoleBridge HoleBridgeSearch::improved(const Piece& piece, const Ranked& rough, std::size_t stride) const {
  const auto [from, to] = rough.bridge;
  Ranked best = rough;
  const std::size_t reach = stride / 2;
  for (std::size_t a = from - std::min<std::size_t>(from, reach); a <= from + reach; ++a) {
    for (std::size_t b = std::max<std::size_t>(to - reach, a + 1); b <= std::min(to + reach, piece.size() - 1); ++b) {
      const double ratio = piece.ratio(a, b);
      if (ratio < best.ratio) best = {ratio, {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)}};
    }
  }
  return best.bridge;
}

bool HoleBridgeSearch::isFree(const Piece& piece, const HoleBridge& s) const {
  const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(piece.numbers[s.a], piece.numbers[s.b]);
  if (std::binary_search(m_edges.begin(), m_edges.end(), edge)) return false;
  if (!piece.flat.empty() &&
      (!piece.startsInside(s.a, s.b) || !piece.startsInside(s.b, s.a) || piece.crossesBorder(s.a, s.b))) {
    return false;
  }
  return hasFreeSide(piece, s.a, s.b) && hasFreeSide(piece, s.b, s.a);
}

// Returns true if a triangle over the bridge and one of the adjacent edges at a does not intersect the surface: one of
// them is probably in the patch.
bool HoleBridgeSearch::hasFreeSide(const Piece& piece, std::size_t a, std::size_t b) const {
  for (std::size_t c : {piece.next(a), piece.previous(b)}) {
    const TrianglePoints t{piece.points[b], piece.points[c], piece.points[a]};
    if (!isDegenerate(t) && !m_obstacles.hits(t)) return true;
  }
  return false;
}

}  // namespace handwheel
