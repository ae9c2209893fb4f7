// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/VertexGoals.h"

#include "base/Tolerance.h"
#include "mesh/selection/FaceSelection.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/FaceNormal.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace handwheel {
namespace {

// The cosine between a face before and after that still counts as the same side.
constexpr double kSameSide = 0.02;
constexpr int kMoveHalvings = 8;

struct FaceShape {
  Vec3 normal;
  double height;  // height over the longest side divided by its length
};

FaceShape faceShape(const TrianglePoints& t) {
  const Vec3 a = t[1] - t[0], b = t[2] - t[0];
  const double longest = std::max({a.stableNorm(), b.stableNorm(), (t[2] - t[1]).stableNorm()});
  // Dividing first avoids overflow and underflow of squares.
  return {unitNormal(t), longest > 0.0 ? Vec3(a / longest).cross(b / longest).norm() : 0.0};
}

class LimitedMove {
 public:
  LimitedMove(const HalfEdgeMesh& mesh, std::span<const VertexGoal> moves, NumberType numbers)
      : m_mesh(mesh), m_numbers(numbers), m_moving(moves.begin(), moves.end()), m_share(moves.size(), 1.0) {}

  // Returns false if cancelled.
  bool prepare(const Progress& progress) {
    FaceSelection around;
    std::unordered_map<Vertex, std::uint32_t> moveOf;
    moveOf.reserve(m_moving.size());
    for (std::uint32_t i = 0; i < m_moving.size(); ++i) {
      if (!pollProgress(i, m_moving.size(), progress.part(0.0, 0.5), kSearchesPerPoll)) return false;
      moveOf.emplace(m_mesh.from(m_moving[i].leaving), i);
      for (const HalfEdge h : m_mesh.fan(m_moving[i].leaving)) around.add(HalfEdgeMesh::face(h));
    }
    m_faces = around.faces();
    for (const Face f : m_faces) {
      if (!pollProgress(m_before.size(), m_faces.size(), progress.part(0.5, 1.0), kSearchesPerPoll)) return false;
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto it = moveOf.find(m_mesh.triangle(f)[k]);
        corners[k] = it == moveOf.end() ? kNone : it->second;
      }
      m_corners.push_back(corners);
      m_before.push_back(faceShape(m_mesh.points(f)));
    }
    return true;
  }

  // Returns false if cancelled.
  bool limit(const Progress& progress) {
    std::vector<std::uint32_t> suspects(m_faces.size());
    for (std::uint32_t f = 0; f < suspects.size(); ++f) suspects[f] = f;
    for (int round = 0; !suspects.empty(); ++round) {
      std::vector<std::uint32_t> slowed;
      for (std::size_t k = 0; k < suspects.size(); ++k) {
        if (k % kSearchesPerPoll == 0 && progress.cancelled()) return false;
        if (isGood(suspects[k])) continue;
        for (const std::uint32_t i : m_corners[suspects[k]])
          if (i != kNone && m_share[i] > 0.0) slowed.push_back(i);
      }
      unique(slowed);
      suspects.clear();
      for (const std::uint32_t i : slowed) {
        m_share[i] = round < kMoveHalvings ? 0.5 * m_share[i] : 0.0;
        for (const HalfEdge h : m_mesh.fan(m_moving[i].leaving)) suspects.push_back(indexOf(HalfEdgeMesh::face(h)));
      }
      unique(suspects);
    }
    return true;
  }

  MovedVertices write(HalfEdgeMesh& mesh) {
    MovedVertices result{std::move(m_faces), 0};
    std::vector<Vec3> positions;
    for (std::uint32_t i = 0; i < m_moving.size(); ++i) positions.push_back(position(i));
    for (std::uint32_t i = 0; i < m_moving.size(); ++i) {
      const Vertex v = mesh.from(m_moving[i].leaving);
      result.heldBack += m_share[i] < 1.0;
      if (positions[i] != mesh.position(v)) mesh.setPosition(v, positions[i]);
    }
    return result;
  }

 private:
  static void unique(std::vector<std::uint32_t>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  std::uint32_t indexOf(Face f) const {
    return static_cast<std::uint32_t>(std::lower_bound(m_faces.begin(), m_faces.end(), f) - m_faces.begin());
  }

  Vec3 position(std::uint32_t i) const {
    const Vec3 from = m_mesh.position(m_mesh.from(m_moving[i].leaving));
    const Vec3& to = m_moving[i].to;
    if (m_share[i] == 0.0 || !to.allFinite() || to == from) return from;
    const Vec3 position = rounded(m_share[i] == 1.0 ? to : Vec3(from + m_share[i] * (to - from)), m_numbers);
    return position.allFinite() ? position : from;
  }

  bool isGood(std::uint32_t f) const {
    TrianglePoints points = m_mesh.points(m_faces[f]);
    bool isMoved = false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (m_corners[f][k] == kNone) continue;
      const Vec3 to = position(m_corners[f][k]);
      isMoved = isMoved || to != points[k];
      points[k] = to;
    }
    if (!isMoved) return true;
    const FaceShape after = faceShape(points), &before = m_before[f];
    if (before.normal.isZero(0.0)) return true;  // it had no orientation before
    return after.normal.dot(before.normal) > kSameSide &&
           after.height >= std::min(tolerance::kNeedle, 0.5 * before.height);
  }

  const HalfEdgeMesh& m_mesh;
  const NumberType m_numbers;
  const std::vector<VertexGoal> m_moving;
  std::vector<double> m_share;  // share of the displacement, per move
  std::vector<Face> m_faces;
  std::vector<std::array<std::uint32_t, 3>> m_corners;  // per face: the moves of its corners; kNone: the corner stays
  std::vector<FaceShape> m_before;
};

}  // namespace

MovedVertices moveTowards(HalfEdgeMesh& mesh, std::span<const VertexGoal> moves, NumberType numbers,
                          Progress progress) {
  LimitedMove move(mesh, moves, numbers);
  if (!move.prepare(progress) || !move.limit(progress)) return {};
  return move.write(mesh);
}

}  // namespace handwheel
