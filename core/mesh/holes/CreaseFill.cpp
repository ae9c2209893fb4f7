// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/CreaseFill.h"

#include "base/Tolerance.h"
#include "mesh/holes/CgalHoleFilling.h"
#include "mesh/holes/CreaseMatching.h"
#include "mesh/holes/EarClipping.h"
#include "mesh/holes/HoleDecomposition.h"
#include "mesh/holes/MinimalTriangulation.h"
#include "mesh/holes/PatchRefinement.h"
#include "mesh/structure/EdgeTable.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace handwheel {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // smaller first

// A hole cut along creases. The patch's points are the loop's, then those of the curves, then each piece's own.
class CreaseFiller {
 public:
  CreaseFiller(const HoleContext& hole, const Obstacles& obstacles, const std::vector<CreaseEnd>& ends,
               const Creases& creases, double density, Continuity continuity, Progress progress)
      : m_hole(hole), m_obstacles(obstacles), m_density(density), m_continuity(continuity), m_progress(progress) {
    m_patch.loopSize = hole.loopSize;
    m_patch.points = hole.loop();
    m_patch.method = FillMethod::Crease;
    for (const Crease& crease : creases.pairs) {
      m_paths.push_back({crease.bridge(), added(crease.curve)});
      m_patch.bridges.push_back(crease.bridge());
    }
    for (const CreaseCorner& corner : creases.corners) addCorner(corner);
    for (const CreaseEnd& end : ends) addChain(end);
    findNeighbours();
  }

  std::optional<Patch> run() {
    const std::optional<std::vector<HolePiece>> pieces = splitHole(m_hole.loopSize, m_patch.bridges);
    if (!pieces) return std::nullopt;
    for (const HolePiece& piece : m_slivers) {
      if (m_progress.cancelled() || !fill(piece)) return std::nullopt;
    }
    for (const HolePiece& piece : *pieces) {
      if (m_corners.contains(piece)) continue;  // nothing: it is between three curves that meet
      if (m_progress.cancelled() || !fill(piece)) return std::nullopt;
    }
    return m_patch;
  }

 private:
  // A curve between two points of the loop, by the numbers of the points that it passes.
  struct Path {
    HoleBridge bridge;
    std::vector<std::uint32_t> points;
  };

  std::vector<std::uint32_t> added(const std::vector<Vec3>& curve) {
    std::vector<std::uint32_t> numbers;
    for (const Vec3& p : curve) {
      numbers.push_back(static_cast<std::uint32_t>(m_patch.points.size()));
      m_patch.points.push_back(p);
    }
    return numbers;
  }

  void addCorner(const CreaseCorner& corner) {
    const std::uint32_t point = added({corner.point}).front();
    m_meetings.insert(point);
    std::array<std::vector<std::uint32_t>, 3> spokes;
    HolePiece ends;
    for (std::size_t k = 0; k < 3; ++k) {
      spokes[k] = added(corner.curves[k]);
      ends.push_back(corner.ends[k].chain[0]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      Path path{{ends[k], ends[l]}, spokes[k]};
      path.points.push_back(point);
      path.points.insert(path.points.end(), spokes[l].rbegin(), spokes[l].rend());
      const std::uint32_t n = static_cast<std::uint32_t>(m_hole.loopSize);
      if ((ends[k] + 1) % n == ends[l]) {
        m_slivers.push_back({ends[k], ends[l]});
      } else {
        m_patch.bridges.push_back(path.bridge);
      }
      m_paths.push_back(std::move(path));
    }
    m_corners.insert(ends);
  }

  void addChain(const CreaseEnd& end) {
    for (std::size_t i = 0; i + 1 < end.chain.size(); ++i) {
      m_creases.insert(std::minmax(end.chain[i], end.chain[i + 1]));
    }
  }

  // Finds the adjacent faces of the ring, and those behind the loop's edges; not across a crease.
  void findNeighbours() {
    const auto n = static_cast<std::uint32_t>(m_hole.loopSize);
    m_neighbours.resize(m_hole.ring.size());
    m_behind.assign(n, kNone);
    EdgeTable(m_hole.ring, m_hole.points.size()).forEachEdge([&](std::uint32_t a, std::uint32_t b, auto run) {
      if (m_creases.contains({a, b})) return;
      const std::uint32_t face = run[0].halfEdge / 3;
      if (run.size() == 2) {
        const std::uint32_t other = run[1].halfEdge / 3;
        m_neighbours[face].push_back(other);
        m_neighbours[other].push_back(face);
      } else if (run.size() == 1 && b < n) {
        const std::uint32_t from = m_hole.ring[face][run[0].halfEdge % 3], to = from == a ? b : a;
        if (to == (from + 1) % n) m_behind[from] = face;
      }
    });
  }

  // A piece as a separate hole, with the curves in its loop. number maps its points to those of the patch.
  struct Piece {
    HoleContext hole;
    std::vector<std::uint32_t> number;
  };

  void addCurve(Piece& piece, std::uint32_t from, std::uint32_t to) const {
    for (const Path& path : m_paths) {
      const HoleBridge& s = path.bridge;
      const bool isAlong = s.a == from && s.b == to;
      if (!isAlong && !(s.a == to && s.b == from)) continue;
      const std::size_t count = path.points.size();
      for (std::size_t i = 0; i < count; ++i) {
        piece.number.push_back(path.points[isAlong ? i : count - 1 - i]);
        const double t = (static_cast<double>(i) + 1.0) / (static_cast<double>(count) + 1.0);
        piece.hole.edgeLength.push_back((1.0 - t) * m_hole.edgeLength[from] + t * m_hole.edgeLength[to]);
      }
    }
  }

  Piece pieceOf(const HolePiece& loop) const {
    Piece piece;
    std::vector<std::uint32_t> behind;  // faces
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t from = loop[i], to = loop[(i + 1) % n];
      piece.number.push_back(from);
      piece.hole.edgeLength.push_back(m_hole.edgeLength[from]);
      if (to != (from + 1) % m_hole.loopSize) {
        addCurve(piece, from, to);
      } else if (m_behind[from] != kNone) {
        behind.push_back(m_behind[from]);
      }
    }
    // A face may be behind two edges.
    std::sort(behind.begin(), behind.end());
    behind.erase(std::unique(behind.begin(), behind.end()), behind.end());
    for (std::uint32_t v : piece.number) piece.hole.points.push_back(m_patch.points[v]);
    piece.hole.loopSize = piece.hole.points.size();
    addApexes(piece);
    addRing(piece, std::move(behind));
    return piece;
  }

  // Behind a crease the piece is mirrored, as if it continued.
  void addApexes(Piece& piece) const {
    HoleContext& hole = piece.hole;
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : hole.points) middle += p / static_cast<double>(hole.loopSize);
    for (std::size_t i = 0; i < hole.loopSize; ++i) {
      const std::uint32_t from = piece.number[i], to = piece.number[(i + 1) % hole.loopSize];
      const bool isLoop = from < m_hole.loopSize && to == (from + 1) % m_hole.loopSize && m_behind[from] != kNone;
      const Vec3 mirrored = hole.points[i] + hole.points[(i + 1) % hole.loopSize] - middle;
      hole.apexes.push_back(isLoop ? m_hole.apexes[from] : mirrored);
    }
  }

  // The faces of the ring on this side of the creases.
  void addRing(Piece& piece, std::vector<std::uint32_t> open) const {
    std::map<std::uint32_t, std::uint32_t> local;
    for (std::uint32_t i = 0; i < piece.number.size(); ++i) {
      if (piece.number[i] < m_hole.loopSize) local[piece.number[i]] = i;
    }
    std::vector<bool> isSeen(m_hole.ring.size(), false);
    for (std::uint32_t f : open) isSeen[f] = true;
    while (!open.empty()) {
      const std::uint32_t face = open.back();
      open.pop_back();
      Triangle t = m_hole.ring[face];
      for (std::uint32_t& v : t) {
        const auto [at, isNew] = local.try_emplace(v, static_cast<std::uint32_t>(piece.hole.points.size()));
        if (isNew) piece.hole.points.push_back(m_hole.points[v]);
        v = at->second;
      }
      piece.hole.ring.push_back(t);
      for (std::uint32_t other : m_neighbours[face]) {
        if (!isSeen[other]) open.push_back(other);
        isSeen[other] = true;
      }
    }
    for (const Vec3& p : piece.hole.points) piece.hole.ringBox.extend(p);
  }

  // Returns the edges between points of one curve that are not adjacent: on a straight crease only slivers have such
  // edges.
  std::vector<Edge> chordsOfCurves(const Piece& piece) const {
    std::vector<Edge> chords;
    const auto n = static_cast<std::uint32_t>(piece.number.size());
    const auto isOnCurve = [&](std::uint32_t i) {
      const std::uint32_t v = piece.number[i % n];
      return v >= m_hole.loopSize && !m_meetings.contains(v);
    };
    for (std::uint32_t i = 0; i < n; ++i) {
      if (!isOnCurve(i + 1)) continue;
      for (std::uint32_t j = i + 2; j < i + n && isOnCurve(j - 1); ++j) chords.push_back(std::minmax(i, j % n));
    }
    return chords;
  }

  // Returns the pairs of points of a piece that the surface joins already, or a curve does.
  JoinedPoints joinedIn(const Piece& piece) const {
    JoinedPoints joined = m_obstacles.edgesAmong(piece.hole.loop());
    const std::vector<Edge> chords = chordsOfCurves(piece);
    joined.insert(joined.end(), chords.begin(), chords.end());
    std::sort(joined.begin(), joined.end());
    return joined;
  }

  bool fill(const HolePiece& loop) {
    Piece piece = pieceOf(loop);
    std::optional<Patch> made;
    if (piece.hole.loopSize <= tolerance::kOptimalFillEdges) {
      made = triangulateOptimal(piece.hole, Criterion::Dihedral, chordsOfCurves(piece), m_progress);
    }
    if (!made) made = clipEars(piece.hole, m_obstacles, {}, m_progress);
    if (made) made = refinePatch(piece.hole, *made, m_density, joinedIn(piece), m_progress);
    if (made) made = fairPatch(piece.hole, std::move(*made), m_continuity, {}, m_progress);
    if (!made) return false;
    for (std::size_t i = made->loopSize; i < made->points.size(); ++i) {
      piece.number.push_back(static_cast<std::uint32_t>(m_patch.points.size()));
      m_patch.points.push_back(made->points[i]);
    }
    for (const Triangle& t : made->triangles) {
      m_patch.triangles.push_back({piece.number[t[0]], piece.number[t[1]], piece.number[t[2]]});
    }
    return true;
  }

  const HoleContext& m_hole;
  const Obstacles& m_obstacles;
  double m_density;
  Continuity m_continuity;
  Progress m_progress;
  Patch m_patch;
  std::vector<Path> m_paths;
  std::vector<HolePiece> m_slivers;    // between an edge of the loop and two curves that meet
  std::set<std::uint32_t> m_meetings;  // points where three curves meet,
  std::set<HolePiece> m_corners;       // and the ends of those
  std::set<Edge> m_creases;            // edges of the creases in the surface and along the loop
  std::vector<std::vector<std::uint32_t>> m_neighbours;
  std::vector<std::uint32_t> m_behind;  // the face of each loop edge, none at a crease
};

}  // namespace

std::optional<Patch> fillAlongCreases(const HoleContext& hole, const Obstacles& obstacles, double density,
                                      Continuity continuity, Progress progress) {
  const std::vector<CreaseEnd> ends = findCreaseEnds(hole, tolerance::kCreaseAngle);
  const Creases creases = matchCreases(hole, ends, density);
  if (creases.pairs.empty() && creases.corners.empty()) return std::nullopt;
  return CreaseFiller(hole, obstacles, ends, creases, density, continuity, progress).run();
}

}  // namespace handwheel
