// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/RepairJobs.h"

#include "mesh/measure/MeshFidelity.h"
#include "mesh/structure/FaceComponents.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "panels/defects/RepairAccount.h"
#include "proximity/SelfIntersection.h"
#include "text/ErrorText.h"
#include "text/RepairText.h"
#include "tools/mesh/DefectFixes.h"
#include "tools/mesh/LoopText.h"
#include "tools/mesh/RepairChanges.h"
#include "window/CommandLines.h"
#include "window/documents/DocumentTabs.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/mesh/EquivalentCommand.h"
#include "window/mesh/MeshTab.h"

#include <QCoreApplication>
#include <algorithm>

namespace handwheel {

namespace {

// Why loops stayed open, by their key, because the repair renumbers them.
std::vector<std::pair<Vertex, FillFailure>> failuresOf(const Inspection& inspection, const RepairReport& report) {
  std::vector<std::pair<Vertex, FillFailure>> failures;
  for (const LoopResult& loop : report.loops) {
    if (loop.outcome == LoopOutcome::Failed && loop.id >= 0)
      failures.emplace_back(inspection.keyOf(loop.id), loop.reason);
  }
  return failures;
}

// Why the holes stayed open that the repair opened itself, or whose key it changed: the one reason it gives for such.
std::vector<std::pair<Vertex, FillFailure>> failuresOfOthers(const Inspection& inspection, const RepairReport& report) {
  FillFailure reason = FillFailure::SelfIntersecting;
  for (const LoopResult& loop : report.loops)
    if (loop.outcome == LoopOutcome::Failed && loop.id < 0) reason = loop.reason;
  std::vector<std::pair<Vertex, FillFailure>> failures;
  for (const int id : inspection.holes())
    if (inspection.failure(id) == FillFailure::None) failures.emplace_back(inspection.keyOf(id), reason);
  return failures;
}

constexpr const char* kPartingCutShort =
    QT_TRANSLATE_NOOP("Tool", "separating all of them would take too long for a mesh of this size");
constexpr const char* kNotTried =
    QT_TRANSLATE_NOOP("Tool", "“Repair all” leaves them as they are; they can be fixed here");

// Why a repair leaves defects of these kinds: what was cut short, what was refused, and what it does not try. Not all
// kinds have a reason.
std::map<DefectKind, QString> reasonsOf(const Inspection& inspection, const RepairReport& report,
                                        const RepairOptions& options) {
  const auto text = [](const char* reason) { return QCoreApplication::translate("Tool", reason); };
  const QString notSeparated = text(report.isSeparationIncomplete ? kPartingCutShort : kNotSeparable);
  std::map<DefectKind, QString> reasons{
      {DefectKind::NonManifoldEdge, notSeparated},    {DefectKind::NonManifoldVertex, notSeparated},
      {DefectKind::NearVertex, text(kClosesNothing)}, {DefectKind::Duplicate, text(kPlateSides)},
      {DefectKind::OneSided, text(kNoCleanCut)},
  };
  if (!options.cutCrossings) reasons[DefectKind::SelfIntersection] = text(kNotTried);
  if (!options.removeDebris) reasons[DefectKind::Debris] = text(kNotTried);
  std::erase_if(reasons, [&](const auto& entry) { return inspection.count(entry.first) == 0; });
  return reasons;
}

// The connected parts of a mesh of which another version has no face any more. 0 if cancelled.
std::size_t countGone(const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress) {
  const PositionTriangles byPosition(before, progress.part(0.0, 0.5));
  if (progress.cancelled()) return 0;
  const FaceComponents components(before, byPosition, progress.part(0.5, 1.0));
  if (progress.cancelled()) return 0;
  std::vector<bool> isLeft(components.count(), false);
  for (Face f = 0; f < before.faceSlots(); ++f)
    if (before.isLive(f) && after.isLive(f)) isLeft[components.of(f)] = true;
  return static_cast<std::size_t>(std::count(isLeft.begin(), isLeft.end(), false));
}

}  // namespace

RepairJobs::RepairJobs(DocumentTabs& tabs, JobRunner& jobs, LogModel& log, const FidelityChoice& fidelity,
                       QObject* parent)
    : QObject(parent), m_tabs(tabs), m_jobs(jobs), m_log(log), m_fidelity(fidelity) {
  connect(&tabs, &DocumentTabs::closing, this, [this](DocumentTab* document) {
    dropChanges(document);
    m_jobs.cancelOf(document);
  });
}

void RepairJobs::fill(MeshTab* document, int loop, PreparedFill prepared) {
  startFill(document, document->inspection.keyOf(loop), std::move(prepared), Round::First);
}

void RepairJobs::startFill(MeshTab* document, Vertex key, PreparedFill prepared, Round round) {
  const int loopId = document->inspection.loopWithKey(key);
  if (loopId < 0) return;  // an undo or another fill was faster
  const std::uint64_t revision = document->document.revision();
  FillOptions options = prepared.options.value_or(FillOptions());
  if (!prepared.options) apply(m_fidelity.values(), options);
  options.numbers = document->document.fileNumbers();
  if (!prepared.bench) prepared = {std::make_shared<HoleFillerCache>(document->document.mesh()), std::nullopt, options};
  Job job;
  job.name = tr("Filling hole %1").arg(document->inspection.loopNumber(loopId));
  job.work = [this, document, key, revision, round, options, nearWeld = nearWeld(), prepared = std::move(prepared),
              loop = document->inspection.loop(loopId)](Progress progress) -> Job::Finish {
    HoleFiller* filler = prepared.bench->filler(progress.part(0.0, 0.3));
    if (!filler) return {};
    const FillFailure failure = fillHole(*filler, loop, options, prepared.attempt, progress.part(0.3, 0.6));
    InspectedMesh after;
    if (failure == FillFailure::None) after = inspected(filler->mesh(), nearWeld, progress.part(0.6, 1.0));
    return [this, document, key, revision, round, options, bench = prepared.bench, failure, after] {
      if (!m_tabs.contains(document)) return;
      if (!isStale(document, revision))
        return filledOne(document, key, bench, {failure, fillStep(key, options)}, after);
      reportStale(*document, round);
      if (round == Round::First) startFill(document, key, {nullptr, std::nullopt, options}, Round::Second);
    };
  };
  start(document, std::move(job));
}

void RepairJobs::filledOne(MeshTab* document, Vertex key, const std::shared_ptr<HoleFillerCache>& bench,
                           const Filled& done, const InspectedMesh& after) {
  const int loop = document->inspection.loopWithKey(key);
  const QString name = document->inspection.loopName(loop);
  const int number = document->inspection.loopNumber(loop);
  document->inspection.setFailure(loop, done.failure);
  if (done.failure != FillFailure::None) {
    m_log.add(tr("%1 stays open: %2").arg(name, fillFailureReason(done.failure)), {}, LogEntry::Weight::Warning);
    return;
  }
  const QString command = stepCommand(*document, done.step);
  document->document.commit(tr("Fill hole %1").arg(number), after, done.step);
  m_log.add(tr("Filled %1 of %2").arg(name, document->document.name()), command);
  emit filled(document, key, bench);
}

void RepairJobs::removeDebris(MeshTab* document) {
  change(document, allDebrisFix());
}

void RepairJobs::change(MeshTab* document, MeshChange wanted) {
  m_changes.emplace_back(document, std::move(wanted));
  if (m_changes.size() == 1) startChange(document, m_changes.front().second, Round::First);
}

void RepairJobs::changeEnded() {
  const MeshChange ended = std::move(m_changes.front().second);
  m_changes.pop_front();
  if (!m_changes.empty()) startChange(m_changes.front().first, m_changes.front().second, Round::First);
  ended.ended();
}

// Those that are not under way.
void RepairJobs::dropChanges(const DocumentTab* document) {
  if (m_changes.empty()) return;
  m_changes.erase(std::remove_if(m_changes.begin() + 1, m_changes.end(),
                                 [document](const auto& change) { return change.first == document; }),
                  m_changes.end());
}

void RepairJobs::startChange(MeshTab* document, MeshChange wanted, Round round) {
  const std::uint64_t revision = document->document.revision();
  const QString text = QCoreApplication::translate("Tool", wanted.text);
  Job job;
  job.name = text;
  const bool isSearched = document->inspection.selfIntersections().has_value();
  job.work = [this, document, revision, round, wanted, text, isSearched, nearWeld = nearWeld(),
              mesh = document->document.mesh()](Progress progress) -> Job::Finish {
    HalfEdgeMesh result = mesh;
    wanted.apply(result, progress.part(0.0, 0.4));
    Changed change;
    // The list of defects need not wait until the whole surface has been searched again.
    if (wanted.crossed || (wanted.isFix && isSearched))
      change.crossings = intersectionsChange(mesh, result, progress.part(0.4, 0.45));
    if (wanted.isDeletion) change.bodiesGone = countGone(mesh, result, progress.part(0.45, 0.5));
    change.facesGone = mesh.liveFaceCount() - std::min(mesh.liveFaceCount(), result.liveFaceCount());
    if (progress.cancelled()) return {};
    return [this, document, revision, round, wanted, text, change,
            after = inspected(std::move(result), nearWeld, progress.part(0.5, 1.0))] {
      if (!m_tabs.contains(document)) return changeEnded();
      if (!isStale(document, revision)) {
        changed(document, wanted, text, after, change);
        return changeEnded();
      }
      reportStale(*document, round);
      if (round == Round::First) return startChange(document, wanted, Round::Second);
      changeEnded();
    };
  };
  job.failed = [this](const Error&) { changeEnded(); };
  start(document, std::move(job));
}

void RepairJobs::changed(MeshTab* document, const MeshChange& wanted, const QString& text, const InspectedMesh& after,
                         const Changed& change) {
  const auto& crossings = change.crossings;
  Inspection& inspection = document->inspection;
  const auto known = inspection.selfIntersections();
  const auto before = inspection.counts();
  const QString command = stepCommand(*document, wanted.step);
  if (document->document.commit(text, after, wanted.step)) {
    if (crossings && known && known->size() < kMaxTrianglePairs)
      inspection.setSelfIntersections(document->document.revision(), intersectionsAfter(*crossings, *known));
    if (wanted.isFix) inspection.setBefore(before);
    logChange(*document, wanted, text, command);
    if (change.bodiesGone > 0) reportBodiesGone(document, change);
    if (!crossings || !wanted.crossed) return;
    if (crossings->fresh > 0) reportCrossings(*document, *crossings);
    wanted.crossed(crossings->fresh);
  } else if (const char* reason = reasonOf(wanted)) {
    emit changedNothing(document, text, tr("Why: %1.").arg(QCoreApplication::translate("Tool", reason)));
  }
}

// One triangle was meant, perhaps, and all that hangs together with it was selected.
void RepairJobs::reportBodiesGone(MeshTab* document, const Changed& change) {
  const MeshDocument& mesh = document->document;
  emit message(
      {.weight = Message::Weight::Info,
       .title = tr("%Ln whole piece(s) deleted", nullptr, static_cast<int>(change.bodiesGone)),
       .detail = tr("%Ln triangle(s) are gone from %1.", nullptr, static_cast<int>(change.facesGone)).arg(mesh.name()),
       .actionText = tr("Undo"),
       .action =
           [this, document] {
             if (m_tabs.contains(document)) document->document.history()->undo();
           },
       .about = &mesh,
       .isOver = [&mesh, then = mesh.revision()] { return mesh.revision() != then; }});
}

void RepairJobs::logChange(const MeshTab& document, const MeshChange& done, const QString& text,
                           const QString& command) {
  const QString name = document.document.name();
  const LengthUnit unit = document.document.displayUnit();
  const bool isPartly = done.sheets && done.sheets->leftCount() > 0;
  const bool isThickened = !isPartly && done.sheets && done.sheets->thickened > 0;
  const bool isMeasured = done.distance && *done.distance;
  const QStringList account = done.isFix ? repairAccount(document.inspection) : QStringList();
  QStringList how;
  if (isPartly) how << sheetsText(*done.sheets, unit);
  if (isMeasured)
    how << tr("largest distance found between the surface before and after %1").arg(lengthText(**done.distance, unit));
  how << account;
  const QString separator = QStringLiteral(", ");
  QString line = tr("%1: %2").arg(name, text);
  if (isThickened) {
    const QString thickness = thicknessText(done.sheets->thickness, unit);
    line = (QStringList(tr("%1: %2 by %3").arg(name, text, thickness)) + how).join(separator);
    how.prepend(thickness);
  } else if (!how.isEmpty()) {
    line = tr("%1: %2: %3").arg(name, text, how.join(separator));
  }
  const QString all = how.join(separator);
  m_log.add(line, command, isPartly ? LogEntry::Weight::Warning : LogEntry::Weight::Info);
  if (isPartly) {
    emit changedPartly(&document, text, all);
  } else if (isMeasured || !account.isEmpty() || (isThickened && done.sheets->thickness.thinVertices > 0)) {
    emit message(changeMessage(document, text, all));
  }
}

// What a change did, until the next one.
Message RepairJobs::changeMessage(const MeshTab& document, const QString& text, const QString& how) {
  const MeshDocument& mesh = document.document;
  return {.weight = Message::Weight::Info,
          .title = text,
          .detail = how.left(1).toUpper() + how.mid(1) + QLatin1Char('.'),
          .about = &mesh,
          .isOver = [&mesh, then = mesh.revision()] { return mesh.revision() != then; }};
}

void RepairJobs::reportCrossings(const MeshTab& document, const IntersectionsChange& crossings) {
  const int pairs = static_cast<int>(std::min(crossings.fresh, kMaxTrianglePairs));
  m_log.add(
      tr("%1: %n more pair(s) of triangles intersect; undo reverts this", nullptr, pairs).arg(document.document.name()),
      {}, LogEntry::Weight::Warning);
}

void RepairJobs::repairAll(MeshTab* document) {
  startRepair(document, Round::First);
}

void RepairJobs::startRepair(MeshTab* document, Round round) {
  const std::uint64_t revision = document->document.revision();
  RepairOptions options;
  options.rims = RimHandling::Keep;  // the list shows them as left open
  apply(m_fidelity.values(), options);
  options.fill.numbers = document->document.fileNumbers();
  options.keepOpen = keptLoops(document->document);
  Job job;
  job.name = tr("Repairing %1").arg(document->document.name());
  const bool isSearched = document->inspection.selfIntersections().has_value();
  job.work = [this, document, revision, round, options, isSearched,
              mesh = document->document.mesh()](Progress progress) -> Job::Finish {
    HalfEdgeMesh result = mesh;
    const auto report = std::make_shared<RepairReport>();
    const MeshChange wanted = repairChange(options, report);
    wanted.apply(result, progress.part(0.0, 0.85));
    std::optional<FacePairs> pairs;
    if (isSearched && !report->cancelled) pairs = findSelfIntersections(result, progress.part(0.85, 0.9));
    if (report->cancelled || progress.cancelled()) return {};
    return [this, document, revision, round, options, step = wanted.step, report, pairs = std::move(pairs),
            after = inspected(std::move(result), options.nearWeld, progress.part(0.9, 1.0))] {
      if (!m_tabs.contains(document)) return;
      if (!isStale(document, revision)) return repairedAll(document, after, {*report, options, step, pairs});
      reportStale(*document, round);
      if (round == Round::First) startRepair(document, Round::Second);
    };
  };
  start(document, std::move(job));
}

void RepairJobs::repairedAll(MeshTab* document, const InspectedMesh& after, const Repaired& done) {
  Inspection& inspection = document->inspection;
  const auto failures = failuresOf(inspection, done.report);
  const auto before = inspection.counts();
  const QString command = document->isAsInFile() ? repairCommand(document->document.path(), done.options)
                                                 : stepCommand(*document, done.step);
  std::map<int, QString> names;
  for (const LoopResult& loop : done.report.loops)
    if (loop.id >= 0) names[loop.id] = inspection.loopName(loop.id);
  const bool isChanged = document->document.commit(tr("Repair all"), after, done.step);
  if (isChanged && done.pairs) inspection.setSelfIntersections(document->document.revision(), *done.pairs);
  document->repairedRevision = document->document.revision();
  document->hasRepairChanged = isChanged;
  inspection.setFailures(failures);
  inspection.setFailures(failuresOfOthers(inspection, done.report));
  // A repair that changes nothing has no account: what is known from before is of another change.
  if (isChanged)
    inspection.setBefore(before, repairSummary(done.report, document->document.displayUnit()));
  else
    inspection.setBefore({});
  inspection.setReasons(reasonsOf(inspection, done.report, done.options));
  logRepair(*document, done, names, command);
  if (!isChanged)
    emit changedNothing(document, tr("Repair all"),
                        tr("Nothing more could be repaired without damage. The list of defects gives the reasons that "
                           "are known."));
}

// names: of the loops that there were.
void RepairJobs::logRepair(const MeshTab& document, const Repaired& done, const std::map<int, QString>& names,
                           const QString& command) {
  const QStringList account = repairAccount(document.inspection);
  m_log.add(account.isEmpty() ? tr("Repaired %1: nothing was changed").arg(document.document.name())
                              : tr("Repaired %1: %2").arg(document.document.name(), account.join(QStringLiteral(", "))),
            command);
  for (const LoopResult& loop : done.report.loops) {
    const QString name = loop.id >= 0 ? names.at(loop.id) : tr("A hole opened by the repair");
    const QString warning = loop.outcome == LoopOutcome::Filled ? patchWarning(loop.shape) : QString();
    if (loop.id >= 0 && !warning.isEmpty())
      m_log.add(tr("Look at the patch of %1: %2").arg(name, warning), {}, LogEntry::Weight::Warning);
    if (loop.outcome == LoopOutcome::Failed)
      m_log.add(tr("%1 stays open: %2").arg(name, fillFailureReason(loop.reason)), {}, LogEntry::Weight::Warning);
  }
}

double RepairJobs::nearWeld() const {
  return m_fidelity.values().of(nearWeldSetting());
}

bool RepairJobs::isStale(MeshTab* document, std::uint64_t revision) const {
  return document->document.revision() != revision;
}

void RepairJobs::reportStale(const MeshTab& document, Round round) {
  const QString name = document.document.name();
  m_log.add(round == Round::First ? tr("%1 was changed meanwhile; the job runs again").arg(name)
                                  : tr("%1 was changed again; the result was discarded").arg(name),
            {}, LogEntry::Weight::Warning);
}

void RepairJobs::start(const DocumentTab* document, Job job) {
  job.owner = document;
  m_working.insert(document);
  emit workingChanged();
  job.work = [this, document, work = std::move(job.work)](Progress progress) -> Job::Finish {
    return [this, document, finish = work(progress)] {
      finish();
      ended(document);
    };
  };
  job.failed = [this, document, name = job.name, failed = std::move(job.failed)](const Error& error) {
    reportFailure(document, name, error);
    failed(error);
    ended(document);
  };
  m_jobs.start(std::move(job));
}

void RepairJobs::reportFailure(const DocumentTab* document, const QString& job, const Error& error) {
  m_log.add(job + QStringLiteral(": ") + errorSentence(error), {}, LogEntry::Weight::Warning);
  if (error.code == ErrorCode::Cancelled || !m_tabs.contains(document)) return;
  const QString advice = error.code == ErrorCode::OutOfMemory
                             ? errorAdvice(error)
                             : tr("Save your work, and try it on a smaller part or in another way.");
  emit message({Message::Weight::Error,
                tr("%1 failed").arg(job),
                errorSentence(error),
                tr("The document is as it was before. %1").arg(advice),
                {},
                {},
                {},
                {},
                &document->document});
}

void RepairJobs::ended(const DocumentTab* document) {
  m_working.erase(m_working.find(document));
  emit workingChanged();
}

}  // namespace handwheel
