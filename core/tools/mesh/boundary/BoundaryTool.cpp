// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/boundary/BoundaryTool.h"

#include "document/mesh/MeshDocument.h"
#include "tools/AxisDrag.h"
#include "tools/mesh/ManualMeshChanges.h"

#include <QtGlobal>
#include <utility>

// Following the pointer by BoundaryTool; BoundaryToolActions.cpp has the rest.
namespace handwheel {
namespace {

constexpr double kStill = 3.0;       // pixels of a click's tremor
constexpr double kStillHand = 12.0;  // for a stylus in the air: a millimetre, by which pressing its button moves it
constexpr double kMark = 6.0;        // pixels, radius of the mark on a point

}  // namespace

BoundaryTool::BoundaryTool(MeshDocument& document, MeshServices services, std::optional<Vertex> first)
    : m_document(document), m_services(std::move(services)), m_picking(document, m_services) {
  choose(first);
}

BoundaryTool::~BoundaryTool() {
  if (m_job) m_services.cancel();
}

const HalfEdgeMesh& BoundaryTool::mesh() const {
  return m_document.mesh();
}

const BoundaryLoop* BoundaryTool::loop() const {
  return m_key ? loopWithKey(mesh(), m_document.defects().loops, *m_key) : nullptr;
}

void BoundaryTool::choose(std::optional<Vertex> key) {
  if (key != m_key) dropProposal();
  m_key = key;
  if (!loop()) m_key.reset();
}

ToolReply BoundaryTool::pointer(const PointerEvent& given) {
  PointerEvent event = given;
  event.ray.direction.stableNormalize();
  switch (event.kind) {
    case PointerEvent::Kind::Hover:
      return hover(event);
    case PointerEvent::Kind::Press:
    case PointerEvent::Kind::DoubleClick:
      return press(event);
    case PointerEvent::Kind::Drag:
      if (!m_drag) return ToolReply::Ignored;
      follow(event);
      return ToolReply::Used;
    case PointerEvent::Kind::Release:
      return release(event);
    case PointerEvent::Kind::Leave:
      break;
  }
  m_hovered.reset();
  m_hoveredLoop.reset();
  return ToolReply::Used;
}

ToolReply BoundaryTool::hover(const PointerEvent& event) {
  m_hovered.reset();
  m_hoveredLoop.reset();
  if (!event.ray.isUsable()) return ToolReply::Used;
  m_hovered = m_picking.pointAt(event.pickRay());
  if (m_hovered) {
    m_mark = kMark * event.pickRay().pixelAt(mesh().position(mesh().from(m_hovered->at)));
    m_hoveredLoop = keyOf(mesh(), m_document.defects().loops[m_hovered->loop]);
  } else {
    m_hoveredLoop = m_picking.loopAt(event.pickRay());
  }
  return ToolReply::Used;
}

ToolReply BoundaryTool::press(const PointerEvent& event) {
  if (m_drag) {
    if (event.button == PointerButton::Second) m_drag.reset();
    return ToolReply::Used;
  }
  if (event.device && event.button == PointerButton::Second) return perform("commit");
  if (event.button != PointerButton::First || !event.ray.isUsable()) return ToolReply::Ignored;
  hover(event);
  if (!m_hoveredLoop) return ToolReply::Ignored;  // the camera's
  choose(m_hoveredLoop);
  const auto near = m_hovered ? m_picking.near() : nullptr;
  if (!near) return ToolReply::Used;
  dropProposal();
  const Vertex v = mesh().from(m_hovered->at);
  const double still = (event.device ? kStillHand : kStill) * event.pickRay().pixelAt(mesh().position(v));
  Drag drag{near, *m_hovered, VertexDrag(near, v), event.ray, {}, still};
  if (event.device) drag.tip = event.device->translation();
  drag.position = drag.stop = drag.pull.start();
  m_drag = std::move(drag);
  return ToolReply::Used;
}

void BoundaryTool::follow(const PointerEvent& event) {
  if (!event.ray.isUsable()) return;
  const Vec3 start = m_drag->pull.start();
  const auto position = event.device && m_drag->tip
                            ? std::optional<Vec3>(start + event.device->translation() - *m_drag->tip)
                            : positionUnder(start, m_drag->grip.direction, event.ray);
  if (!position || !position->allFinite()) return;
  m_drag->hasMoved |= (*position - start).stableNorm() > m_drag->still;
  if (!m_drag->hasMoved) return;
  m_drag->position = *position;
  const bool isBridge = (m_onto == Onto::Bridge) != event.modifiers.shift;
  const auto snapped = event.modifiers.control ? std::nullopt : m_picking.pointAt(event.pickRay(), start);
  if (snapped) {
    m_drag->position = mesh().position(mesh().from(snapped->at));
    return aim(isBridge ? Effect::Bridge : Effect::Weld, snapped->at);
  }
  aim(isBridge ? Effect::Bridge : Effect::Pull, kNone);
  if (m_drag->effect == Effect::Bridge) return;
  const VertexDrag::ReachablePoint reached = m_drag->pull.towards(m_drag->position, m_document.fileNumbers());
  m_drag->stop = reached.point;
  m_drag->problem = reached.problem;
}

// Finds the result of joining the held point with another; none: of letting it go here.
void BoundaryTool::aim(Effect effect, HalfEdge target) {
  if (m_drag->effect == effect && m_drag->target == target && target != kNone) return;
  m_drag->effect = effect;
  m_drag->target = target;
  m_drag->stop = m_drag->pull.start();
  m_drag->problem = JoinProblem::None;
  m_drag->weld = {};
  m_drag->bridge = {};
  if (target == kNone) return;
  const BoundaryPair ends{m_drag->held.at, target};
  if (effect == Effect::Weld) {
    m_drag->weld = weldBoundary(*m_drag->near, ends);
    m_drag->problem = m_drag->weld.problem;
  } else {
    m_drag->bridge = findBridge(*m_drag->near, ends);
    m_drag->problem = m_drag->bridge.problem;
  }
}

ToolReply BoundaryTool::release(const PointerEvent& event) {
  if (event.button != PointerButton::First || !m_drag) return ToolReply::Ignored;
  follow(event);
  const Drag drag = *std::exchange(m_drag, std::nullopt);
  m_hovered.reset();
  if (drag.hasMoved) commitDrag(drag);
  return ToolReply::Used;
}

// The recipes look again: by the time they are carried out the mesh may be another.
void BoundaryTool::commitDrag(const Drag& drag) {
  const HalfEdgeMesh& known = drag.near->mesh();
  if (drag.effect == Effect::Pull) {
    const Vec3 start = drag.pull.start();
    if (drag.stop == start) return;
    const Vertex v = known.from(drag.held.at);
    const auto isThere = [v, start](const HalfEdgeMesh& mesh) {
      return v < mesh.vertexSlots() && mesh.position(v) == start;
    };
    return m_services.commit(onlyWhere(isThere, pullChange(v, drag.stop)));
  }
  if (drag.target == kNone || drag.problem != JoinProblem::None) return;
  const BoundaryPair ends{drag.held.at, drag.target};
  const auto isThere = [known, ends](const HalfEdgeMesh& mesh) {
    for (const HalfEdge h : {ends.a, ends.b}) {
      const Face f = HalfEdgeMesh::face(h);
      if (f >= mesh.faceSlots() || mesh.triangle(f) != known.triangle(f) || mesh.points(f) != known.points(f) ||
          mesh.hasOpposite(h))
        return false;
    }
    return true;
  };
  m_services.commit(onlyWhere(isThere, drag.effect == Effect::Weld ? joinChange(ends) : bridgeChange(ends)));
}

}  // namespace handwheel
