// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/MeshDocument.h"
#include "mesh/boundary/Islands.h"
#include "mesh/boundary/Peninsulas.h"
#include "tools/ToolProperty.h"
#include "tools/mesh/ManualMeshChanges.h"
#include "tools/mesh/boundary/BoundaryTool.h"

#include <QtGlobal>
#include <algorithm>
#include <utility>

// The actions of BoundaryTool, and its changes of a whole edge.
namespace handwheel {

namespace {
constexpr ToolKey kBoundaryKeys[] = {
    {"smooth", "Shift+S", QT_TRANSLATE_NOOP("Tool", "smooth the boundary")},
    {"islands", "I", QT_TRANSLATE_NOOP("Tool", "find islands")},
    {"peninsulas", "Shift+I", QT_TRANSLATE_NOOP("Tool", "find peninsulas")},
    {"next", "N", QT_TRANSLATE_NOOP("Tool", "next hole"), "nextHole"},
    {"previous", "Shift+N", QT_TRANSLATE_NOOP("Tool", "previous hole"), "previousHole"},
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "done")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "deselect the hole")},
};
}  // namespace

const char* BoundaryTool::dragEffect() const {
  switch (m_drag->effect) {
    case Effect::Pull:
      return m_drag->problem == JoinProblem::None ? QT_TRANSLATE_NOOP("Tool", "move the vertex")
                                                  : QT_TRANSLATE_NOOP("Tool", "move the vertex as far as possible");
    case Effect::Weld:
      return hintOf(m_drag->problem, QT_TRANSLATE_NOOP("Tool", "join the vertices"));
    case Effect::Bridge:
      break;
  }
  if (m_drag->target == kNone) return QT_TRANSLATE_NOOP("Tool", "not possible: no other vertex is near");
  return hintOf(m_drag->problem, QT_TRANSLATE_NOOP("Tool", "add the bridge"));
}

std::span<const ToolKey> BoundaryTool::keys() {
  return kBoundaryKeys;
}

std::vector<ToolAction> BoundaryTool::actions() const {
  const char* pull = QT_TRANSLATE_NOOP("Tool", "drag a vertex; onto another one: join them");
  const char* bridge = QT_TRANSLATE_NOOP("Tool", "add a bridge to another vertex");
  const char* turned = QT_TRANSLATE_NOOP("Tool", "bridge instead of joining");
  if (m_onto == Onto::Bridge) {
    std::swap(pull, bridge);
    turned = QT_TRANSLATE_NOOP("Tool", "join instead of bridging");
  }
  if (m_drag && m_drag->hasMoved)
    return {{"", QT_TRANSLATE_NOOP("ToolInput", "Release"), dragEffect()},
            {"", QT_TRANSLATE_NOOP("ToolInput", "Shift"), turned},
            {"", QT_TRANSLATE_NOOP("ToolInput", "Ctrl"), QT_TRANSLATE_NOOP("Tool", "do not snap")},
            actionOf(kBoundaryKeys, "revert", true, QT_TRANSLATE_NOOP("Tool", "cancel the move"))};
  const bool isChosen = loop() != nullptr, any = neighbour(true).has_value();
  const char* commit = QT_TRANSLATE_NOOP("Tool", "done");
  if (m_proposal) {
    commit = m_proposal->kind == Kind::Smooth ? QT_TRANSLATE_NOOP("Tool", "apply the smoothed boundary")
                                              : QT_TRANSLATE_NOOP("Tool", "remove the marked triangles");
  }
  const char* revert = QT_TRANSLATE_NOOP("Tool", "done");
  if (m_drag)
    revert = QT_TRANSLATE_NOOP("Tool", "cancel the move");
  else if (m_proposal || m_job)
    revert = QT_TRANSLATE_NOOP("Tool", "leave it unchanged");
  else if (isChosen)
    revert = QT_TRANSLATE_NOOP("Tool", "deselect the hole");
  return {
      {"", QT_TRANSLATE_NOOP("ToolInput", "Click"), QT_TRANSLATE_NOOP("Tool", "choose a boundary")},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), pull},
      {"", QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"), bridge},
      actionOf(kBoundaryKeys, "smooth", isChosen),
      actionOf(kBoundaryKeys, "islands", isChosen),
      actionOf(kBoundaryKeys, "peninsulas", isChosen),
      actionOf(kBoundaryKeys, "next", any),
      actionOf(kBoundaryKeys, "previous", any),
      actionOf(kBoundaryKeys, "commit", !m_job && (!m_proposal || isHeld(*m_proposal)), commit),
      actionOf(kBoundaryKeys, "revert", true, revert),
  };
}

ToolReply BoundaryTool::perform(std::string_view action) {
  if (action == "revert") return revert();
  if (m_drag) return ToolReply::Ignored;
  if (action == "commit") return m_job ? ToolReply::Ignored : m_proposal ? commitProposal() : ToolReply::Finished;
  if (action == "smooth") return propose(Kind::Smooth);
  if (action == "islands") return propose(Kind::Islands);
  if (action == "peninsulas") return propose(Kind::Peninsulas);
  if (action != "next" && action != "previous") return ToolReply::Ignored;
  choose(neighbour(action == "next"));
  return ToolReply::Used;
}

// Step by step out of what is going on.
ToolReply BoundaryTool::revert() {
  if (m_drag) {
    m_drag.reset();
  } else if (m_proposal || m_job) {
    dropProposal();
  } else if (m_key) {
    choose(std::nullopt);
  } else {
    return ToolReply::Finished;
  }
  return ToolReply::Used;
}

std::optional<Vertex> BoundaryTool::neighbour(bool forward) const {
  const auto& loops = m_document.defects().loops;
  const std::size_t n = loops.size();
  if (n == 0) return std::nullopt;
  const BoundaryLoop* chosen = loop();
  if (!chosen) return keyOf(mesh(), forward ? loops.front() : loops.back());
  const auto at = static_cast<std::size_t>(chosen - loops.data());
  return keyOf(mesh(), loops[(at + (forward ? 1 : n - 1)) % n]);
}

void BoundaryTool::dropProposal() {
  m_proposal.reset();
  if (!m_job) return;
  m_job.reset();
  m_services.cancel();
}

// Returns true if there is something to be done.
bool BoundaryTool::isHeld(const Proposal& proposal) const {
  return proposal.kind == Kind::Smooth ? !proposal.smoothed.moves.empty() : !proposal.faces.empty();
}

ToolReply BoundaryTool::propose(Kind kind) {
  if (!loop()) return ToolReply::Ignored;
  dropProposal();
  const auto faces = m_services.faces();
  if (!faces) return ToolReply::Ignored;
  m_job = std::make_shared<const Kind>(kind);
  m_services.run({QT_TRANSLATE_NOOP("Tool", "Analysing the boundary"),
                  [this, work = workFor(kind), job = std::weak_ptr(m_job)](Progress progress) {
                    const Proposal found = work(progress);
                    return std::function<void()>([this, found, job] {
                      if (job.expired()) return;
                      m_job.reset();
                      m_proposal = found;
                      reportUpdated();
                    });
                  }});
  return ToolReply::Used;
}

// On another thread: all that it needs goes with it.
std::function<BoundaryTool::Proposal(Progress)> BoundaryTool::workFor(Kind kind) const {
  SmoothingOptions options = m_smoothing;
  options.numbers = m_document.fileNumbers();
  return [kind, mesh = mesh(), loop = *loop(), loops = m_document.defects().loops, options,
          faces = m_services.faces()](Progress progress) {
    Proposal proposal;
    proposal.kind = kind;
    if (kind == Kind::Islands) proposal.faces = findIslands(mesh, loop, loops, progress);
    if (kind == Kind::Peninsulas) proposal.faces = findPeninsulas(mesh, loop, progress);
    if (kind != Kind::Smooth) return proposal;
    const FaceLocator near(mesh, faces);
    proposal.options = options;
    proposal.smoothed = smoothBoundary(near, loop, options);
    HalfEdgeMesh moved = mesh;
    moveVertices(moved, proposal.smoothed.moves);
    std::vector<TrianglePoints> shapes;
    for (const VertexMove& m : proposal.smoothed.moves)
      for (const HalfEdge h : near.leaving(m.from))
        if (proposal.faces.add(HalfEdgeMesh::face(h))) shapes.push_back(moved.points(HalfEdgeMesh::face(h)));
    proposal.shapes = std::make_shared<const TriangleSoup>(soupOf(shapes));
    return proposal;
  };
}

ToolReply BoundaryTool::commitProposal() {
  if (!isHeld(*m_proposal)) return ToolReply::Ignored;
  const Proposal proposal = *std::exchange(m_proposal, std::nullopt);
  if (proposal.kind == Kind::Smooth) {
    // Applies the shown moves only: by now the edge may have changed.
    MeshChange change = smoothEdgeChange(*m_key, proposal.options);
    change.apply = [moves = proposal.smoothed.moves](HalfEdgeMesh& mesh, Progress) { moveVertices(mesh, moves); };
    m_services.commit(std::move(change));
    return ToolReply::Used;
  }
  const char* text = proposal.kind == Kind::Islands ? QT_TRANSLATE_NOOP("Tool", "Remove islands")
                                                    : QT_TRANSLATE_NOOP("Tool", "Remove peninsulas");
  m_services.commit(deleteChange(proposal.faces, text, kEdgeChanged));
  return ToolReply::Used;
}

void BoundaryTool::setSetting(std::string_view id, const PropertyValue& value) {
  if (id == "onto") assignChoice(m_onto, value, 2);
  const bool isTaken = (id == "wavelength" &&
                        assignNumber(m_smoothing.wavelength, value, {0.0, SmoothingOptions::kLongestWavelength})) ||
                       (id == "evenly" && assignSwitch(m_smoothing.evenly, value));
  if (!isTaken) return;
  if ((m_proposal && m_proposal->kind == Kind::Smooth) || (m_job && *m_job == Kind::Smooth)) propose(Kind::Smooth);
}

void BoundaryTool::documentChanged() {
  m_drag.reset();
  m_hovered.reset();
  m_hoveredLoop.reset();
  dropProposal();
  if (!loop()) m_key.reset();
}

}  // namespace handwheel
