// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/repair/RepairActions.h"

#include "window/ActionToolTip.h"
#include "window/OfferedAction.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/mesh/LoopSelection.h"
#include "window/mesh/MeshTab.h"

#include <QSettings>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

const auto kPreviewKey = QStringLiteral("showPreview");

void prepare(QAction& action, const char* name, const char* iconName, const QList<QKeySequence>& keys,
             const QString& tip) {
  action.setShortcuts(keys);
  handwheel::prepare(action, name, iconName, tip);
}

}  // namespace

RepairActions::RepairActions(LoopSelection& selection, RepairJobs& jobs, HolePreview& preview,
                             const FidelityChoice& fidelity, QObject* parent)
    : QObject(parent),
      m_selection(selection),
      m_jobs(jobs),
      m_preview(preview),
      m_fidelity(fidelity),
      m_repairAll(tr("&Repair all"), this),
      m_removeDebris(tr("Remove &debris"), this),
      m_undoRepair(tr("&Undo repair"), this),
      m_oneByOne(tr("&Go one by one"), this),
      m_byVolume(tr("Repair by &volume…"), this),
      m_fill(tr("&Fill"), this),
      m_keepOpen(tr("&Keep open"), this),
      m_showPreview(tr("&Preview"), this),
      m_next(tr("&Next hole"), this),
      m_previous(tr("Pre&vious hole"), this),
      m_deselect(tr("&Clear selection"), this) {
  prepare(m_repairAll, "repairAll", "repair", {QKeySequence(Qt::CTRL | Qt::Key_R)},
          tr("Fill all holes except those kept open, resolve self-intersections, and repair the other defects except "
             "debris, as one step"));
  prepare(m_removeDebris, "removeDebris", "debris", {},
          tr("Remove all pieces that are listed as debris; the list says which these are"));
  prepare(m_undoRepair, "undoRepair", "undo", {}, tr("Undo all that the last repair has changed"));
  prepare(m_oneByOne, "goOneByOne", "next", {}, tr("Look at one hole after the other"));
  prepare(m_byVolume, "repairByVolume", "kind-volume", {},
          tr("Choose the size of the voxels, and replace everything by the surface of the volume that is enclosed"));
  prepare(m_fill, "fillHole", "fill-hole", {QKeySequence(Qt::Key_Return), QKeySequence(Qt::Key_Enter)},
          tr("Fill the selected hole"));
  prepare(m_keepOpen, "keepOpen", "keep-open", {QKeySequence(Qt::Key_K)},
          tr("Mark this opening as intended: “Repair all” does not close it"));
  prepare(m_showPreview, "showPreview", "preview", {QKeySequence(Qt::Key_P)},
          tr("Show the patch of the selected hole before it is filled"));
  prepare(m_next, "nextHole", "next", {QKeySequence(Qt::Key_N)}, tr("Go to the next hole"));
  prepare(m_previous, "previousHole", "previous", {QKeySequence(Qt::SHIFT | Qt::Key_N)}, tr("Go to the previous hole"));
  prepare(m_deselect, "deselect", nullptr, {QKeySequence(Qt::Key_Escape)}, tr("Clear the selection and the preview"));
  m_repairAll.setPriority(QAction::HighPriority);
  m_fill.setPriority(QAction::HighPriority);
  m_keepOpen.setCheckable(true);
  m_showPreview.setCheckable(true);
  // In menus the check mark stands where the icon would.
  m_keepOpen.setIconVisibleInMenu(false);
  m_showPreview.setIconVisibleInMenu(false);
  m_showPreview.setChecked(QSettings().value(kPreviewKey, true).toBool());
  connectActions();
  connect(&fidelity, &FidelityChoice::changed, this, &RepairActions::follow);
  follow();
}

void RepairActions::connectActions() {
  connect(&m_repairAll, &QAction::triggered, this, [this] {
    m_selection.select(-1);
    m_jobs.repairAll(m_document);
  });
  connect(&m_removeDebris, &QAction::triggered, this, [this] { m_jobs.removeDebris(m_document); });
  connect(&m_undoRepair, &QAction::triggered, this, [this] { m_document->document.history()->undo(); });
  connect(&m_oneByOne, &QAction::triggered, this, [this] { step(+1); });
  connect(&m_byVolume, &QAction::triggered, this, &RepairActions::volumeRepairRequested);
  connect(&m_fill, &QAction::triggered, this, &RepairActions::fillSelected);
  connect(&m_keepOpen, &QAction::triggered, this, &RepairActions::toggleKeepOpen);
  connect(&m_next, &QAction::triggered, this, [this] { step(+1); });
  connect(&m_previous, &QAction::triggered, this, [this] { step(-1); });
  connect(&m_deselect, &QAction::triggered, this, [this] { m_selection.select(-1); });
  connect(&m_showPreview, &QAction::toggled, this, [this](bool on) {
    QSettings().setValue(kPreviewKey, on);
    follow();
  });
  connect(&m_preview, &HolePreview::changed, this, &RepairActions::followPreview);
  connect(&m_selection, &LoopSelection::changed, this, [this] {
    // Another hole that is chosen while this one is being filled stays chosen.
    const int filling = m_document ? m_document->defectList.loopWithKey(m_filling) : -1;
    if (filling >= 0 && m_selection.loop() != filling) m_filling = kNone;
    follow();
  });
  connect(&m_jobs, &RepairJobs::filled, this,
          [this](MeshTab* document, Vertex key, const std::shared_ptr<HoleFillerCache>& cache) {
            if (document != m_document) return;
            m_preview.returnCache(document, cache);
            if (std::exchange(m_filling, kNone) == key) m_selection.select(-1);
          });
  connect(&m_jobs, &RepairJobs::workingChanged, this, &RepairActions::follow);
}

QList<QAction*> RepairActions::all() {
  return {&m_repairAll, &m_removeDebris, &m_fill, &m_keepOpen, &m_showPreview, &m_next, &m_previous, &m_deselect};
}

void RepairActions::setDocument(MeshTab* document) {
  if (m_document) disconnect(&m_document->document, &Document::changed, this, &RepairActions::followUndo);
  if (document != m_document) m_filling = m_filled = kNone;
  m_document = document;
  if (document) connect(&document->document, &Document::changed, this, &RepairActions::followUndo);
  follow();
}

// Updates the possible actions and the preview after document and selection.
void RepairActions::follow() {
  MeshTab* document = m_document;
  const int loop = document ? m_selection.loop() : -1;
  const bool kept = loop >= 0 && document->document.isKeptOpen(document->defectList.loop(loop));
  const bool holes = document && !document->defectList.holes().empty();
  const bool isTriedInVain = document && isTried(*document);
  offerJob(m_repairAll, document && !document->defectList.isClean() && !isTriedInVain,
           isTriedInVain ? tr("The last repair has tried it; the list says why defects remain.")
           : document && !document->defectList.selfIntersections()
               ? tr("Self-intersections are still being searched for.")
               : tr("There is nothing that it would repair."));
  offerJob(m_removeDebris, document && !document->defectList.debris().empty(), tr("There is no debris."));
  for (QAction* action : {&m_oneByOne, &m_next, &m_previous}) offer(*action, holes, tr("There are no holes."));
  offer(m_keepOpen, loop >= 0, tr("Select a hole first."));
  m_keepOpen.setChecked(kept);
  offer(m_deselect, loop >= 0, tr("Nothing is selected."));
  m_preview.request(document, !m_jobs.isWorkingOn(document) && m_showPreview.isChecked() && !kept ? loop : -1);
  followPreview();
  followUndo();
}

void RepairActions::offerJob(QAction& action, bool isThere, const QString& reason) const {
  const QString obstacle = m_jobs.obstacle(m_document);
  offer(action, obstacle.isEmpty() && isThere, obstacle.isEmpty() ? reason : obstacle);
}

// Returns true if another repair would find the same defects as the last one left: the list has the reasons.
bool RepairActions::isTried(const MeshTab& document) const {
  if (!document.isRepaired() || document.repairedWith != m_fidelity.values()) return false;
  const auto& holes = document.defectList.holes();
  return std::none_of(holes.begin(), holes.end(), [&](int id) {
    const FillFailure failure = document.defectList.failure(id);
    return failure == FillFailure::WasSheetBoundary || failure == FillFailure::TooMuchEffort;
  });
}

void RepairActions::followUndo() {
  offerJob(m_undoRepair, m_document && m_document->isJustRepaired(), tr("The last change was not a repair."));
}

// There is no point in filling what the preview could not.
void RepairActions::followPreview() {
  const int loop = m_selection.loop();
  const MeshTab* document = m_document;
  const bool kept = loop >= 0 && document && document->document.isKeptOpen(document->defectList.loop(loop));
  const bool hopeless = m_preview.state().kind == PreviewState::Kind::Failed;
  offerJob(m_fill, loop >= 0 && !kept && !hopeless,
           loop < 0 ? tr("Select a hole first.")
           : kept   ? tr("This opening is marked as intended.")
                    : tr("No patch fits; the list says why."));
}

void RepairActions::fillSelected() {
  MeshTab* document = m_document;
  const int loop = m_selection.loop();
  m_filling = m_filled = document->defectList.keyOf(loop);
  m_jobs.fill(document, loop, m_preview.take(m_filling));
}

void RepairActions::toggleKeepOpen() {
  MeshTab* document = m_document;
  const BoundaryLoop loop = document->defectList.loop(m_selection.loop());
  document->document.setKeptOpen(loop, !document->document.isKeptOpen(loop));
  follow();
}

// Goes round among the holes, in the order of the list: from the selected one, or else from the one filled last. Loops
// are numbered in the order of their keys.
void RepairActions::step(int direction) {
  const DefectList& defectList = m_document->defectList;
  const std::vector<int>& holes = defectList.holes();
  if (holes.empty()) return;
  const int count = static_cast<int>(holes.size()), selected = m_selection.loop();
  const bool isFromFilled = selected < 0 && m_filled != kNone;
  const auto at =
      isFromFilled ? std::find_if(holes.begin(), holes.end(), [&](int id) { return defectList.keyOf(id) > m_filled; })
                   : std::lower_bound(holes.begin(), holes.end(), selected);
  int index = static_cast<int>(at - holes.begin());
  const bool onHole = at != holes.end() && *at == selected;
  if (direction > 0 && onHole) ++index;
  if (direction < 0) --index;
  const int loop = holes[static_cast<std::size_t>((index + count) % count)];
  m_selection.select(loop);
  emit showLoopRequested(loop);
}

}  // namespace handwheel
