// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/MeshDocument.h"
#include "tools/ToolProperty.h"
#include "tools/mesh/MeshPreview.h"
#include "tools/mesh/boundary/BoundaryTool.h"

#include <QtGlobal>
#include <utility>

// The preview and the forces of BoundaryTool.
namespace handwheel {
namespace {

// The thread between a held point and where it comes from: pulls in proportion to its length (He 2008, section 4.1.4).
constexpr double kThread = 0.1;           // N/mm
constexpr double kThreadDamping = 0.001;  // N·s/mm
constexpr double kSnap = 0.5;             // N/mm, of a point that attracts

DisplayPart proposed(std::shared_ptr<const TriangleSoup> soup) {
  DisplayPart part;
  part.name = "edge";
  part.soup = std::move(soup);
  return part;
}

}  // namespace

void BoundaryTool::addDragPreview(ToolPreview& preview, MeshPreview& onMesh) const {
  const Vec3& start = m_drag->pull.start();
  preview.circle = {m_drag->position, m_mark};
  if (!m_drag->hasMoved) return;
  preview.lines.push_back({start, m_drag->position});  // the thread
  TriangleSoup soup;
  if (m_drag->effect == Effect::Pull) {
    soup = soupOf(m_drag->pull.shapes(m_drag->stop));
  } else if (m_drag->effect == Effect::Weld) {
    soup = m_drag->weld.shapes;
    if (m_drag->problem == JoinProblem::None) onMesh.highlighted = FaceSelection(m_drag->weld.changed);
  } else {
    std::vector<TrianglePoints> laid;
    for (const Triangle& t : m_drag->bridge.triangles)
      laid.push_back({mesh().position(t[0]), mesh().position(t[1]), mesh().position(t[2])});
    soup = soupOf(laid);
  }
  if (soup.triangles.empty()) return;
  preview.parts.push_back(proposed(std::make_shared<const TriangleSoup>(std::move(soup))));
}

ToolPreview BoundaryTool::preview() const {
  ToolPreview preview;
  const auto onMesh = std::make_shared<MeshPreview>();
  preview.ofKind = onMesh;
  const auto& loops = m_document.defects().loops;
  for (const auto& key : {m_key, m_hoveredLoop != m_key ? m_hoveredLoop : std::nullopt}) {
    const BoundaryLoop* line = key ? loopWithKey(mesh(), loops, *key) : nullptr;
    if (line) preview.lines.push_back(outlineOf(mesh(), *line));
  }
  if (m_drag) {
    addDragPreview(preview, *onMesh);
  } else if (m_hovered) {
    preview.circle = {mesh().position(mesh().from(m_hovered->at)), m_mark};
  }
  if (!m_proposal) return preview;
  if (m_proposal->kind != Kind::Smooth) {
    onMesh->selected = m_proposal->faces;
  } else if (!m_proposal->shapes->triangles.empty()) {
    preview.parts.push_back(proposed(m_proposal->shapes));
  }
  return preview;
}

// A held point pulls like a thread, the more the further it is from where it was; a point near by draws the tip. Before
// anything is held, the snapTargets do.
std::vector<DeviceSpring> BoundaryTool::forces() const {
  if (!m_drag) return {};
  const Vec3& start = m_drag->pull.start();
  const Vec3 grip = m_drag->tip.value_or(start);  // the tip may have taken hold beside the point
  std::vector<DeviceSpring> terms = {{grip, kThread, kThreadDamping}};
  if (m_drag->target != kNone) terms.push_back({grip + (m_drag->position - start), kSnap});
  return terms;
}

std::vector<Property> BoundaryTool::settings() const {
  Property wave;
  wave.id = "wavelength";
  wave.group = QT_TRANSLATE_NOOP("Property", "Smoothing");
  wave.label = QT_TRANSLATE_NOOP("Property", "Wavelength (edges)");
  wave.value = m_smoothing.wavelength;
  wave.least = 0.0;
  wave.largest = SmoothingOptions::kLongestWavelength;
  Property evenly;
  evenly.id = "evenly";
  evenly.group = wave.group;
  evenly.label = QT_TRANSLATE_NOOP("Property", "Even spacing");
  evenly.value = m_smoothing.evenly;
  std::vector<Property> all = {
      choiceSetting("onto", QT_TRANSLATE_NOOP("Property", "Dropped onto a vertex"), static_cast<int>(m_onto),
                    {QT_TRANSLATE_NOOP("Property", "Join"), QT_TRANSLATE_NOOP("Property", "Add a bridge")}),
      wave, evenly};
  Property shown;
  shown.editable = false;
  if (m_drag) {
    shown.id = "way";
    shown.label = QT_TRANSLATE_NOOP("Property", "Displacement");
    shown.quantity = Quantity::Length;
    shown.value = (m_drag->position - m_drag->pull.start()).stableNorm();
    shown.problem = textOf(m_drag->problem);
    all.push_back(shown);
  } else if (m_proposal && m_proposal->kind == Kind::Smooth) {
    shown.id = "held";
    shown.label = QT_TRANSLATE_NOOP("Property", "Constrained vertices");
    shown.value = static_cast<double>(m_proposal->smoothed.held);
    if (m_proposal->smoothed.held > 0)
      shown.problem = QT_TRANSLATE_NOOP("Property", "Moving further would flip a triangle or tear the surface.");
    all.push_back(shown);
  } else if (m_proposal) {
    shown.id = "faces";
    shown.label = QT_TRANSLATE_NOOP("Property", "Marked triangles");
    shown.value = static_cast<double>(m_proposal->faces.count());
    if (m_proposal->faces.empty())
      shown.problem = m_proposal->kind == Kind::Islands
                          ? QT_TRANSLATE_NOOP("Property", "There is no island in this hole.")
                          : QT_TRANSLATE_NOOP("Property", "There is no peninsula in this hole.");
    all.push_back(shown);
  }
  return all;
}

}  // namespace handwheel
