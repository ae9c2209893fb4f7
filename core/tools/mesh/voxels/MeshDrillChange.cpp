// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/MeshDrillChange.h"

#include "mesh/structure/MeshDelta.h"
#include "volume/drilling/DrilledTriangles.h"

#include <QtGlobal>
#include <utility>
#include <vector>

namespace handwheel {
namespace {

const char* reasonAgainstHole(const DrilledTriangles& drilled) {
  switch (drilled.problem) {
    case SubtractionProblem::None:
      break;
    case SubtractionProblem::NotClosed:
      return QT_TRANSLATE_NOOP("Tool", "the mesh is not closed, or not manifold");
    case SubtractionProblem::IntersectsItself:
      return QT_TRANSLATE_NOOP("Tool", "triangles of the mesh intersect one another");
    case SubtractionProblem::TooManyIntersections:
      return QT_TRANSLATE_NOOP("Tool", "the hole meets too many triangles");
    case SubtractionProblem::Unsound:
      return QT_TRANSLATE_NOOP("Tool", "the triangles cannot be joined soundly along the hole");
  }
  return drilled.mesh.liveFaceCount() == 0 ? QT_TRANSLATE_NOOP("Tool", "nothing would be left of the mesh") : nullptr;
}

// Puts the hole into the mesh that it was drilled in.
class HoleInMesh {
 public:
  HoleInMesh(HalfEdgeMesh& mesh, const DrilledTriangles& drilled, NumberType numbers)
      : m_mesh(mesh), m_drilled(drilled), m_numbers(numbers), m_vertexOf(drilled.mesh.vertexSlots(), kNone) {}

  // Finds the faces of the origin that stay, which are in the same order in all. False: they are not, and nothing is
  // changed.
  bool match() {
    Face next = 0;
    for (Face f = 0; f < m_mesh.faceSlots(); ++f) {
      if (!m_mesh.isLive(f)) continue;
      if (next < m_drilled.kept && isSame(f, next)) {
        for (std::size_t k = 0; k < 3; ++k) m_vertexOf[m_drilled.mesh.triangle(next)[k]] = m_mesh.triangle(f)[k];
        m_faceOf.push_back(f);
        ++next;
      } else {
        m_gone.push_back(f);
      }
    }
    return next == m_drilled.kept;
  }
  void put() {
    for (const Face f : m_gone) m_mesh.removeFace(f);
    const HalfEdgeMesh& drilled = m_drilled.mesh;
    for (auto f = static_cast<Face>(m_drilled.kept); f < drilled.faceSlots(); ++f) {
      Triangle corners = drilled.triangle(f);
      for (Vertex& v : corners) v = vertexFor(v);
      m_faceOf.push_back(m_mesh.addFace(corners));
    }
    for (auto h = static_cast<HalfEdge>(3 * m_drilled.kept); h < drilled.halfEdgeSlots(); ++h)
      m_mesh.pair(halfEdgeOf(h), halfEdgeOf(drilled.opposite(h)));
  }

 private:
  // Returns true if the faces are equal in the numbers of the file.
  bool isSame(Face own, Face kept) const {
    const TrianglePoints a = m_mesh.points(own), b = m_drilled.mesh.points(kept);
    for (std::size_t k = 0; k < 3; ++k)
      if (rounded(a[k], m_numbers) != b[k]) return false;
    return true;
  }
  Vertex vertexFor(Vertex v) {
    if (m_vertexOf[v] == kNone) m_vertexOf[v] = m_mesh.addVertex(m_drilled.mesh.position(v));
    return m_vertexOf[v];
  }
  HalfEdge halfEdgeOf(HalfEdge h) const { return 3 * m_faceOf[h / 3] + h % 3; }

  HalfEdgeMesh& m_mesh;
  const DrilledTriangles& m_drilled;
  NumberType m_numbers;
  std::vector<Vertex> m_vertexOf;  // by vertex of the drilled mesh; kNone: a new one
  std::vector<Face> m_faceOf;      // by its face
  std::vector<Face> m_gone;
};

bool isSameHead(const DrillBit& a, const DrillBit& b) {
  return a.shape == b.shape && a.diameter == b.diameter && a.pointAngle == b.pointAngle && a.length == b.length &&
         a.width == b.width;
}

// The part as the record cuts it.
std::shared_ptr<const HybridPart> cutPart(const DrilledMeshHole& hole, Progress progress) {
  if (hole.cut) return hole.cut;
  auto part = std::make_shared<HybridPart>(*hole.uncut);
  DrillRun run(*part, hole.record->setup);
  const PagedArray<DrillPose>& poses = hole.record->poses;
  for (std::size_t i = 0; i < poses.size() && !progress.cancelled(); ++i) {
    move(run, poses[i]);
    run.takeChangedBlocks();
    progress.set(static_cast<double>(i) / static_cast<double>(poses.size()));
  }
  return part;
}

}  // namespace

std::shared_ptr<const DrillRecord> joinedRecord(const DrillRecord& before, const DrillRecord& record) {
  constexpr double kBesideAxis = 1e-4;  // mm, of what is on it
  constexpr std::uint64_t kPauseMicros = 1000;
  if (before.poses.empty() || record.poses.empty() || !isSameHead(before.setup.tool, record.setup.tool) ||
      before.poses.size() + record.poses.size() > DrillRecord::kMostPoses)
    return nullptr;
  const DrillPose last = before.poses[before.poses.size() - 1], first = record.poses[0];
  const Vec3 offset = first.position() - last.position(), axis = first.direction();
  const bool isTurned = (last.direction() - axis).norm() > 1e-6;
  if (isTurned || (offset - offset.dot(axis) * axis).norm() > kBesideAxis) return nullptr;
  auto joined = std::make_shared<DrillRecord>(before);
  for (std::size_t i = 0; i < record.poses.size(); ++i) {
    DrillPose pose = record.poses[i];
    pose.micros += last.micros + kPauseMicros;
    joined->poses.push_back(pose);
  }
  return joined;
}

MeshChange drillChange(DrilledMeshHole hole, NumberType numbers, std::shared_ptr<DrilledMeshHoleOutcome> outcome) {
  return {QT_TRANSLATE_NOOP("Tool", "Drill a hole"),
          [hole = std::move(hole), numbers, outcome = std::move(outcome)](HalfEdgeMesh& mesh, Progress progress) {
            outcome->isMade = false;
            outcome->reason = nullptr;
            if (!MeshDelta::isEmptyBetween(hole.present, mesh)) {
              outcome->reason = QT_TRANSLATE_NOOP("Tool", "the mesh was changed meanwhile");
              return;
            }
            const auto part = cutPart(hole, progress.part(0.0, 0.2));
            DrilledTriangles drilled =
                drilledTriangles(hole.origin.compact().soup, *part, *hole.record, numbers, progress.part(0.2, 0.95));
            if (progress.cancelled()) return;
            outcome->reason = reasonAgainstHole(drilled);
            if (outcome->reason) return;
            HoleInMesh joined(mesh, drilled, numbers);
            if (joined.match())
              joined.put();
            else
              mesh = std::move(drilled.mesh);
            outcome->isMade = true;
          }};
}

}  // namespace handwheel
