// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/DefectActions.h"

#include "mesh/measure/MeshFidelity.h"
#include "tools/mesh/DefectFixes.h"
#include "tools/mesh/LoopText.h"
#include "window/ActionToolTip.h"
#include "window/fidelity/FidelityChoice.h"
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

}  // namespace

DefectActions::DefectActions(Selection& selection, RepairJobs& jobs, const HolePreview& preview,
                             const FidelityChoice& fidelity, QObject* parent)
    : QObject(parent),
      m_selection(selection),
      m_jobs(jobs),
      m_preview(preview),
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
      if (auto wanted = make()) m_jobs.change(m_document, std::move(*wanted));
    });
  };
  connectTo(m_fix, [this] { return change(); });
  connectTo(m_reverseBodies, [this] { return changeFor(DefectKind::InsideOut, -1); });
  connectTo(m_resolveIntersections, [this] { return changeFor(DefectKind::SelfIntersection, -1); });
  connect(&m_thickenSheet, &QAction::triggered, this, [this] {
    std::vector<Vertex> keys;
    for (const int id : sheets()) keys.push_back(m_document->inspection.keyOf(id));
    m_jobs.change(m_document, thickenFix(std::move(keys), options()));
  });
  connect(&m_cutAndClose, &QAction::triggered, this, [this] {
    m_jobs.change(m_document, cutAndCloseFix(m_document->inspection.keyOf(m_selection.loop()), options()));
  });
  connect(&m_selection, &Selection::changed, this, &DefectActions::follow);
  connect(&m_preview, &HolePreview::changed, this, &DefectActions::follow);
  connect(&m_jobs, &RepairJobs::workingChanged, this, &DefectActions::follow);
  follow();
}

void DefectActions::setDocument(MeshTab* document) {
  if (m_document) m_document->inspection.disconnect(this);
  m_document = document;
  if (document) connect(&document->inspection, &Inspection::changed, this, &DefectActions::follow);
  choose(std::nullopt, -1);
}

void DefectActions::choose(std::optional<DefectKind> kind, int row) {
  m_kind = kind;
  m_row = row;
  follow();
}

void DefectActions::follow() {
  const bool free = m_document && !m_jobs.isWorking();
  const auto wanted = change();
  m_fix.setVisible(wanted.has_value());
  m_fix.setEnabled(free && wanted);
  if (wanted) m_fix.setText(QCoreApplication::translate("Tool", wanted->text));
  m_thickenSheet.setEnabled(free && !sheets().empty());
  m_reverseBodies.setEnabled(free && m_document->inspection.count(DefectKind::InsideOut) > 0);
  m_resolveIntersections.setEnabled(free && m_document->inspection.count(DefectKind::SelfIntersection) > 0);
  const int loop = m_document ? m_selection.loop() : -1;
  const bool isBlocked = loop >= 0 && !m_document->inspection.loop(loop).rim &&
                         m_preview.state().kind == PreviewState::Kind::Failed &&
                         m_preview.state().failure == FillFailure::SelfIntersecting;
  m_cutAndClose.setVisible(isBlocked);
  m_cutAndClose.setEnabled(free && isBlocked);
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
    case DefectKind::NonManifoldVertex:
      return nonManifoldFix(numbers);
    case DefectKind::OneSided:
      return nonOrientableFix(options());
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
      return degenerateFix();
    case DefectKind::Duplicate:
      return duplicateFix();
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
