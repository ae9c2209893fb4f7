// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/DefectActions.h"

#include "mesh/measure/MeshFidelity.h"
#include "mesh/repair/SheetThickening.h"
#include "text/RepairText.h"
#include "tools/mesh/BoundaryLoopText.h"
#include "tools/mesh/operations/MeshOperations.h"
#include "tools/mesh/repair/DefectFixes.h"
#include "tools/mesh/repair/HoleFixes.h"
#include "window/ActionToolTip.h"
#include "window/OfferedAction.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/mesh/HolePreview.h"
#include "window/mesh/LoopSelection.h"
#include "window/mesh/MeshTab.h"
#include "window/mesh/repair/FixPreview.h"
#include "window/mesh/repair/RepairJobs.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

// One of them, or all for -1. (lupdate would take the name in a template's head for the class of all tr() below.)
auto chosen(const auto& values, int row) {
  return row < 0 ? values : std::decay_t<decltype(values)>{values[static_cast<std::size_t>(row)]};
}

// Returns the faces that name the defect of a row; empty, which names all, for -1.
FaceSelection faceOf(const std::vector<Face>& faces, int row) {
  return row < 0 ? FaceSelection() : FaceSelection{faces[static_cast<std::size_t>(row)]};
}

std::vector<Vertex> endsOf(const std::vector<std::pair<Vertex, Vertex>>& edges, int row) {
  if (row < 0) return {};
  const auto& [a, b] = edges[static_cast<std::size_t>(row)];
  return {a, b};
}

// The operation that fixes defects of a kind; null for loops, which have actions of their own.
const Operation* fixFor(DefectKind kind) {
  switch (kind) {
    case DefectKind::NonManifoldEdge:
    case DefectKind::NonManifoldVertex:
      return &meshOperation("split-nonmanifold");
    case DefectKind::OneSided:
      return &meshOperation("two-sides");
    case DefectKind::InsideOut:
    case DefectKind::Flipped:
      return &meshOperation("reverse");
    case DefectKind::Inconsistent:
      return &meshOperation("orient");
    case DefectKind::NearVertex:
      return &meshOperation("near-vertices");
    case DefectKind::Degenerate:
      return &meshOperation("degenerates");
    case DefectKind::Duplicate:
      return &meshOperation("duplicates");
    case DefectKind::SelfIntersection:
      return &meshOperation("cut-crossings");
    case DefectKind::Debris:
      return &meshOperation("debris");
    case DefectKind::Hole:
    case DefectKind::KeptOpen:
      break;
  }
  return nullptr;
}

}  // namespace

DefectActions::DefectActions(LoopSelection& selection, RepairJobs& jobs, const HolePreview& preview, FixPreview& shown,
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
      m_resolveIntersections(tr("Resolve &self-intersections"), this),
      m_uniteBodies(tr("&Unite bodies"), this) {
  prepare(m_fix, "fixDefect", "repair", tr("Fix the defects selected in the list"));
  prepare(m_thickenSheet, "thickenSheet", "sheet-back",
          tr("Turn open sheets into thin closed bodies: the selected one, or all. A body grows to the side opposite to "
             "the normals; the triangles of the sheet stay where they are"));
  prepare(m_cutAndClose, "cutAndClose", "fill-hole",
          tr("Close the hole across the part, and cut the part where the patch intersects it"));
  prepare(m_reverseBodies, "reverseBodies", "inside-out", tr("Reverse all bodies whose triangles face inwards"));
  prepare(m_resolveIntersections, "resolveIntersections", "self-intersection",
          tr("Cut all triangles that intersect apart, and join the rest"));
  prepare(m_uniteBodies, "uniteBodies", "unite-bodies",
          tr("Make one body of those that intersect or lie inside each other, and remove what lies inside of it"));
  connect(&m_fix, &QAction::triggered, this, [this] {
    if (m_kind) fixRow({*m_kind, m_row});
  });
  connect(&m_reverseBodies, &QAction::triggered, this, [this] { fixRow({DefectKind::InsideOut, -1}); });
  connect(&m_resolveIntersections, &QAction::triggered, this, [this] { fixRow({DefectKind::SelfIntersection, -1}); });
  // In vain it says so in a message: as the reason of the row it would stand for what else may resolve them.
  connect(&m_uniteBodies, &QAction::triggered, this, [this] { m_jobs.change(m_document, uniting()); });
  connect(&m_thickenSheet, &QAction::triggered, this, [this] { m_jobs.change(m_document, thickening()); });
  connect(&m_cutAndClose, &QAction::triggered, this, [this] { m_jobs.change(m_document, cutting()); });
  // After every change of the list of defects, too.
  connect(&m_selection, &LoopSelection::changed, this, [this] {
    m_pointed = nullptr;
    follow();
  });
  connect(&m_preview, &HolePreview::changed, this, &DefectActions::follow);
  connect(&m_jobs, &RepairJobs::workingChanged, this, &DefectActions::follow);
  connect(&m_fidelity, &FidelityChoice::changed, this, &DefectActions::renewPreview);
  connect(&m_shown, &FixPreview::changed, this, &DefectActions::followShown);
  follow();
}

void DefectActions::fixRow(const DefectRow& row) {
  if (auto wanted = changeFor(row.kind, row.row)) m_jobs.change(m_document, std::move(*wanted), row);
}

void DefectActions::setDocument(MeshTab* document) {
  m_document = document;
  m_thickness = 0.0;
  m_kind = std::nullopt;
  m_row = -1;
  m_pointed = nullptr;
  follow();
}

void DefectActions::choose(std::optional<DefectKind> kind, int row) {
  if (kind == m_kind && row == m_row) return;
  m_kind = kind;
  m_row = row;
  follow();
}

void DefectActions::pointAt(const QAction* action, bool isPointed) {
  if (!isPointed && m_pointed != action) return;
  m_pointed = isPointed && offeredBy(action) ? action : nullptr;
  m_shown.request(m_document, offered());
}

void DefectActions::setThickness(double thickness) {
  m_thickness = thickness;
  nameThickening();
  renewPreview();
}

// For values that the fix is made with.
void DefectActions::renewPreview() {
  m_shown.request(nullptr, std::nullopt);
  m_shown.request(m_document, offered());
}

void DefectActions::follow() {
  const QString obstacle = m_jobs.obstacle(m_document);
  const bool free = obstacle.isEmpty();
  const bool isWanted = m_kind && isFixable(*m_kind, m_row);
  m_fix.setVisible(isWanted);
  m_mayFix = free && isWanted;
  if (isWanted) m_fix.setText(QCoreApplication::translate("Tool", fixFor(*m_kind)->title));
  const auto offerFree = [&](QAction& action, bool isThere, const QString& reason) {
    offer(action, free && isThere, free ? reason : obstacle);
  };
  const bool isSearched = m_document && m_document->defectList.selfIntersections();
  const QString searching = tr("Self-intersections are still being searched for.");
  offerFree(m_thickenSheet, free && !sheets().empty(),
            selectedLoop() < 0 ? tr("There is no open sheet.")
                               : tr("The selected hole is not the outer boundary of a sheet."));
  nameThickening();
  if (m_thickenSheet.isEnabled()) emit thicknessChanged();
  offerFree(m_reverseBodies, free && m_document->defectList.count(DefectKind::InsideOut) > 0,
            tr("No body faces inwards."));
  offerFree(m_resolveIntersections, free && m_document->defectList.count(DefectKind::SelfIntersection) > 0,
            isSearched ? tr("There are no self-intersections.") : searching);
  offerFree(m_uniteBodies,
            free && (m_document->document.defects().nestedBodies > 0 ||
                     (m_resolveIntersections.isEnabled() && m_document->document.defects().components.size() > 1)),
            isSearched ? tr("No bodies intersect or lie inside each other.") : searching);
  const int loop = selectedLoop();
  const FillFailure failure = m_preview.state().failure;
  const bool isBlocked = loop >= 0 && !m_document->defectList.loop(loop).isSheetBoundary &&
                         m_preview.state().kind == PreviewState::Kind::Failed &&
                         (failure == FillFailure::SelfIntersecting || failure == FillFailure::NarrowTriangles);
  m_cutAndClose.setVisible(isBlocked);
  m_mayCut = free && isBlocked;
  m_shown.request(m_document, offered());
  followShown();
}

// A fix that would change nothing is not offered: the text of the preview gives the reason, and the row keeps it.
void DefectActions::followShown() {
  const bool isOfLoop = selectedLoop() >= 0;
  if (const char* why = m_shown.isPointless() ? m_shown.shown().reason : nullptr;
      why && m_kind && m_mayFix && !isOfLoop && !m_pointed) {
    const QString reason = QCoreApplication::translate("Tool", why);
    DefectList& defectList = m_document->defectList;
    if (defectList.reason(*m_kind, m_row) != reason) defectList.setReason(*m_kind, m_row, reason);
  }
  m_fix.setEnabled(m_mayFix && (isOfLoop || m_pointed || !m_shown.isPointless()));
  m_cutAndClose.setEnabled(m_mayCut && (m_pointed || !m_shown.isPointless()));
}

// The card has no field for the thickness, so the name says it before it is used.
void DefectActions::nameThickening() {
  m_thickenSheet.setText(
      m_thickenSheet.isEnabled()
          ? tr("&Thicken sheets by %1").arg(lengthText(thickness(), m_document->document.displayUnit()))
          : tr("&Thicken sheets"));
}

// None of an action that changes no mesh, or is disabled.
std::optional<OfferedFix> DefectActions::offeredBy(const QAction* action) const {
  if (!action || !action->isEnabled()) return std::nullopt;
  if (action == &m_thickenSheet)
    return OfferedFix{action, {}, selectedLoop(), [this] { return std::optional(thickening()); }};
  if (action == &m_uniteBodies) return OfferedFix{action, {}, -1, [this] { return std::optional(uniting()); }};
  if (action == &m_resolveIntersections)
    return OfferedFix{action, {}, -1, [this] { return changeFor(DefectKind::SelfIntersection, -1); }};
  if (action == &m_reverseBodies)
    return OfferedFix{action, {}, -1, [this] { return changeFor(DefectKind::InsideOut, -1); }};
  return std::nullopt;
}

// Returns the fix of the button under the pointer, or else that of the selection, if a hole has no patch to show.
std::optional<OfferedFix> DefectActions::offered() const {
  if (auto pointed = offeredBy(m_pointed)) return pointed;
  if (const int loop = selectedLoop(); loop >= 0) {
    if (m_mayCut) return OfferedFix{&m_cutAndClose, {}, loop, [this] { return std::optional(cutting()); }};
    return std::nullopt;
  }
  if (!m_mayFix) return std::nullopt;
  return OfferedFix{&m_fix, m_kind, m_row, [this] { return change(); }};
}

// The selection follows the list of defects, but not first.
int DefectActions::selectedLoop() const {
  const int loop = m_selection.loop();
  return m_document && loop < m_document->defectList.loopCount() ? loop : -1;
}

MeshChange DefectActions::thickening() const {
  std::vector<Vertex> keys;
  for (const int id : sheets()) keys.push_back(m_document->defectList.keyOf(id));
  return thickenFix(std::move(keys), options(), thickness());
}

MeshChange DefectActions::uniting() const {
  return unionFix(m_document->document.fileNumbers());
}

MeshChange DefectActions::cutting() const {
  return cutAndCloseFix(m_document->defectList.keyOf(selectedLoop()), options());
}

double DefectActions::thickness() const {
  if (m_thickness > 0.0) return m_thickness;
  std::vector<Box> outlines;
  for (const int id : sheets()) outlines.push_back(m_document->defectList.loop(id).box);
  const MeshDocument& document = m_document->document;
  return proposedSheetThickness(outlines, document.defects().box, millimetresPer(document.displayUnit()));
}

std::vector<int> DefectActions::sheets() const {
  if (!m_document) return {};
  const DefectList& defectList = m_document->defectList;
  std::vector<int> ids;
  if (const int selected = selectedLoop(); selected >= 0) {
    if (defectList.loop(selected).isSheetBoundary) ids.push_back(selected);
    return ids;
  }
  for (const int id : defectList.keptOpen()) {
    if (defectList.loop(id).isSheetBoundary) ids.push_back(id);
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

bool DefectActions::isFixable(DefectKind kind, int row) const {
  if (!m_document || !fixFor(kind)) return false;
  const auto count = static_cast<int>(m_document->defectList.count(kind));
  return count > 0 && row < count;
}

std::optional<MeshChange> DefectActions::changeFor(DefectKind kind, int row) const {
  if (!isFixable(kind, row)) return std::nullopt;
  const DefectList& defectList = m_document->defectList;
  const Defects& defects = m_document->document.defects();
  const NumberType numbers = m_document->document.fileNumbers();
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
    case DefectKind::Inconsistent:
      return orientFix(faceOf(defects.inconsistentFaces, row));
    case DefectKind::NearVertex:
      return nearVertexFix(m_fidelity.values().of(nearWeldSetting()), chosen(defects.nearVertices, row));
    case DefectKind::Degenerate:
      return degenerateFix(faceOf(defects.degenerateFaces, row));
    case DefectKind::Duplicate:
      return duplicateFix(faceOf(defects.duplicateFaces, row));
    case DefectKind::SelfIntersection:
      return intersectionFix(numbers, chosen(*defectList.selfIntersections(), row));
    case DefectKind::Debris: {
      std::vector<Face> faces;
      for (const std::size_t i : chosen(defectList.debris(), row)) faces.push_back(defects.components[i].faces.front());
      return debrisFix(std::move(faces));
    }
    case DefectKind::Hole:
    case DefectKind::KeptOpen:
      break;
  }
  return std::nullopt;
}

}  // namespace handwheel
