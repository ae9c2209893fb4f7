// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/DefectActions.h"

#include "mesh/measure/MeshFidelity.h"
#include "mesh/repair/SheetThickening.h"
#include "tools/mesh/DefectFixes.h"
#include "tools/mesh/LoopText.h"
#include "window/ActionToolTip.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/mesh/FixPreview.h"
#include "window/mesh/HolePreview.h"
#include "window/mesh/MeshTab.h"
#include "window/mesh/RepairJobs.h"
#include "window/mesh/Selection.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

// One of them, or all for -1. (lupdate would take the name in a template's head for the class of all tr() below.)
auto chosen(const auto& values, int row) {
  return row < 0 ? values : std::decay_t<decltype(values)>{values[static_cast<std::size_t>(row)]};
}

// What names the defect of a row; empty, which names all, for -1.
FaceSelection faceOf(const std::vector<Face>& faces, int row) {
  return row < 0 ? FaceSelection() : FaceSelection{faces[static_cast<std::size_t>(row)]};
}

std::vector<Vertex> endsOf(const std::vector<std::pair<Vertex, Vertex>>& edges, int row) {
  if (row < 0) return {};
  const auto& [a, b] = edges[static_cast<std::size_t>(row)];
  return {a, b};
}

}  // namespace

DefectActions::DefectActions(Selection& selection, RepairJobs& jobs, const HolePreview& preview, FixPreview& shown,
                             const FidelityChoice& fidelity, QObject* parent)
    : QObject(parent),
      m_selection(selection),
      m_jobs(jobs),
      m_preview(preview),
      m_shown(shown),
      m_fidelity(fidelity),
      m_fix(tr("Fix"), this),
      m_thickenSheet(tr("&Thicken sheets"), this),
      m_cutAndClose(tr("&Cut and close"), this),
      m_reverseBodies(tr("Reverse &inside-out bodies"), this),
      m_resolveIntersections(tr("Resolve &self-intersections"), this) {
  prepare(m_fix, "fixDefect", "repair", tr("Fix the defects selected in the list"));
  prepare(m_thickenSheet, "thickenSheet", "sheet-back",
          tr("Turn open sheets into thin closed bodies: the selected one, or all"));
  prepare(m_cutAndClose, "cutAndClose", "fill-hole",
          tr("Close the hole across the part, and cut the part where the patch intersects it"));
  prepare(m_reverseBodies, "reverseBodies", "inside-out", tr("Reverse all bodies whose triangles face inwards"));
  prepare(m_resolveIntersections, "resolveIntersections", "self-intersection",
          tr("Cut all triangles that intersect apart, and join the rest"));
  const auto connectTo = [this](QAction& action, auto make) {
    connect(&action, &QAction::triggered, this, [this, make] {
      if (std::optional<MeshChange> wanted = make()) m_jobs.change(m_document, std::move(*wanted));
    });
  };
  connectTo(m_fix, [this] { return change(); });
  connectTo(m_reverseBodies, [this] { return changeFor(DefectKind::InsideOut, -1); });
  connectTo(m_resolveIntersections, [this] { return changeFor(DefectKind::SelfIntersection, -1); });
  connectTo(m_thickenSheet, [this] { return std::optional(thickening()); });
  connectTo(m_cutAndClose, [this] { return std::optional(cutting()); });
  connect(&m_thickenSheet, &QAction::hovered, this, [this] { point(&m_thickenSheet); });
  connect(&m_selection, &Selection::changed, this, [this] { point(nullptr); });
  connect(&m_preview, &HolePreview::changed, this, &DefectActions::follow);
  connect(&m_jobs, &RepairJobs::workingChanged, this, &DefectActions::follow);
  follow();
}

void DefectActions::setDocument(MeshTab* document) {
  if (m_document) m_document->inspection.disconnect(this);
  m_document = document;
  m_thickness = 0.0;
  if (document) connect(&document->inspection, &Inspection::changed, this, &DefectActions::follow);
  choose(std::nullopt, -1);
}

void DefectActions::choose(std::optional<DefectKind> kind, int row) {
  m_kind = kind;
  m_row = row;
  point(nullptr);
}

void DefectActions::point(const QAction* action) {
  m_pointed = action;
  follow();
}

void DefectActions::follow() {
  const bool free = m_document && !m_jobs.isWorking();
  const auto wanted = change();
  m_fix.setVisible(wanted.has_value());
  m_fix.setEnabled(free && wanted);
  if (wanted) m_fix.setText(QCoreApplication::translate("Tool", wanted->text));
  m_thickenSheet.setEnabled(free && !sheets().empty());
  if (m_thickenSheet.isEnabled()) emit thicknessChanged();
  m_reverseBodies.setEnabled(free && m_document->inspection.count(DefectKind::InsideOut) > 0);
  m_resolveIntersections.setEnabled(free && m_document->inspection.count(DefectKind::SelfIntersection) > 0);
  const int loop = m_document ? m_selection.loop() : -1;
  const bool isBlocked = loop >= 0 && !m_document->inspection.loop(loop).rim &&
                         m_preview.state().kind == PreviewState::Kind::Failed &&
                         m_preview.state().failure == FillFailure::SelfIntersecting;
  m_cutAndClose.setVisible(isBlocked);
  m_cutAndClose.setEnabled(free && isBlocked);
  m_shown.request(m_document, free ? offered(isBlocked) : std::nullopt);
}

// Where a hole has a patch, that is shown until the pointer is on the button of another way.
std::optional<MeshChange> DefectActions::offered(bool isBlocked) const {
  if (m_pointed == &m_thickenSheet && m_thickenSheet.isEnabled()) return thickening();
  if (isBlocked) return cutting();
  return m_selection.loop() < 0 ? change() : std::nullopt;
}

MeshChange DefectActions::thickening() const {
  std::vector<Vertex> keys;
  for (const int id : sheets()) keys.push_back(m_document->inspection.keyOf(id));
  return thickenFix(std::move(keys), options(), m_thickness);
}

MeshChange DefectActions::cutting() const {
  return cutAndCloseFix(m_document->inspection.keyOf(m_selection.loop()), options());
}

double DefectActions::thickness() const {
  return m_thickness > 0.0 ? m_thickness : defaultSheetThickness(m_document->document.mesh());
}

std::vector<int> DefectActions::sheets() const {
  if (!m_document) return {};
  const Inspection& inspection = m_document->inspection;
  std::vector<int> ids;
  if (const int selected = m_selection.loop(); selected >= 0) {
    if (inspection.loop(selected).rim) ids.push_back(selected);
    return ids;
  }
  for (const int id : inspection.keptOpen()) {
    if (inspection.loop(id).rim) ids.push_back(id);
  }
  return ids;
}

FillOptions DefectActions::options() const {
  FillOptions options;
  apply(m_fidelity.values(), options);
  options.numbers = m_document->document.fileNumbers();
  options.keptCorners = keptCorners(m_document->document);
  return options;
}

std::optional<MeshChange> DefectActions::changeFor(DefectKind kind, int row) const {
  if (!m_document) return std::nullopt;
  const Inspection& inspection = m_document->inspection;
  const Defects& defects = m_document->document.defects();
  const NumberType numbers = m_document->document.fileNumbers();
  if (const auto count = static_cast<int>(inspection.count(kind)); count == 0 || row >= count) return std::nullopt;
  switch (kind) {
    case DefectKind::NonManifoldEdge:
      return nonManifoldFix(numbers, endsOf(defects.nonManifoldEdges, row));
    case DefectKind::NonManifoldVertex:
      return nonManifoldFix(numbers, row < 0 ? std::vector<Vertex>() : chosen(defects.nonManifoldVertices, row));
    case DefectKind::OneSided:
      return nonOrientableFix(options(), endsOf(defects.nonOrientableEdges, row));
    case DefectKind::InsideOut: {
      FaceSelection faces;
      for (const std::vector<Face>& body : chosen(defects.insideOut, row))
        for (const Face f : body) faces.add(f);
      return row < 0 ? insideOutFix() : reverseChange(faces);
    }
    case DefectKind::Flipped: {
      FaceSelection faces;
      for (const Face f : chosen(m_document->document.reversedFaces(), row)) faces.add(f);
      return reverseChange(faces);
    }
    case DefectKind::NearVertex:
      return nearVertexFix(m_fidelity.values().of(nearWeldSetting()), chosen(defects.nearVertices, row));
    case DefectKind::Degenerate:
      return degenerateFix(faceOf(defects.degenerateFaces, row));
    case DefectKind::Duplicate:
      return duplicateFix(faceOf(defects.duplicateFaces, row));
    case DefectKind::SelfIntersection:
      return intersectionFix(numbers, chosen(*inspection.selfIntersections(), row));
    case DefectKind::Debris: {
      std::vector<Face> faces;
      for (const std::size_t i : chosen(inspection.debris(), row)) faces.push_back(defects.components[i].faces.front());
      return debrisFix(std::move(faces));
    }
    case DefectKind::Hole:
    case DefectKind::KeptOpen:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace handwheel
