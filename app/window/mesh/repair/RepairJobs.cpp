// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/repair/RepairJobs.h"

#include "mesh/measure/MeshFidelity.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "proximity/SelfIntersection.h"
#include "text/ErrorText.h"
#include "text/RepairText.h"
#include "tools/mesh/BoundaryLoopText.h"
#include "tools/mesh/repair/DefectFixes.h"
#include "tools/mesh/repair/RemainingDefects.h"
#include "tools/mesh/repair/RepairChanges.h"
#include "window/CommandLines.h"
#include "window/documents/DiscardedResult.h"
#include "window/documents/DocumentTabs.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/mesh/EquivalentCommand.h"
#include "window/mesh/MeshMessages.h"
#include "window/mesh/MeshTab.h"
#include "window/mesh/repair/RepairLog.h"
#include "window/mesh/repair/RepairReasons.h"

#include <QCoreApplication>
#include <algorithm>

namespace handwheel {
namespace {

// Returns true if numbers of this type hold all digits of a mesh. O(n).
bool isExactIn(const HalfEdgeMesh& mesh, NumberType numbers) {
  if (numbers == NumberType::Float64) return true;
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v)
    if (rounded(mesh.position(v), numbers) != mesh.position(v)) return false;
  return true;
}

}  // namespace

RepairJobs::RepairJobs(DocumentTabs& tabs, JobRunner& jobs, LogModel& log, const FidelityChoice& fidelity,
                       QObject* parent)
    : QObject(parent), m_tabs(tabs), m_jobs(jobs), m_log(log), m_fidelity(fidelity) {
  connect(&tabs, &DocumentTabs::closing, this, [this](DocumentTab* document) {
    dropChanges(document);
    m_jobs.forget(&document->document);
  });
}

QString RepairJobs::obstacle(const MeshTab* document) const {
  if (!document) return tr("Open a mesh first.");
  return isWorkingOn(document) ? tr("The mesh is being changed.") : QString();
}

void RepairJobs::fill(MeshTab* document, int loop, PreparedFill prepared) {
  startFill(document, document->defectList.keyOf(loop), std::move(prepared), Round::First);
}

void RepairJobs::startFill(MeshTab* document, Vertex key, PreparedFill prepared, Round round) {
  const int loopId = document->defectList.loopWithKey(key);
  if (loopId < 0) return;  // an undo or another fill was faster
  const std::uint64_t revision = document->document.revision();
  FillOptions options = prepared.options.value_or(FillOptions());
  if (!prepared.options) apply(m_fidelity.values(), options);
  options.numbers = document->document.fileNumbers();
  if (!prepared.cache) prepared.cache = std::make_shared<HoleFillerCache>(document->document.mesh());
  Job job;
  job.name = tr("Filling hole %1").arg(document->defectList.loopNumber(loopId));
  job.work = [this, document, key, revision, round, options, name = job.name, nearWeld = nearWeld(),
              prepared = std::move(prepared),
              loop = document->defectList.loop(loopId)](Progress progress) -> Job::Finish {
    HoleFiller* filler = prepared.cache->filler(progress.part(0.0, 0.3));
    if (!filler) return {};
    const FillAttempt attempt = fillHole(*filler, loop, options, prepared.attempt, progress.part(0.3, 0.6));
    InspectedMesh after;
    if (attempt.failure == FillFailure::None) after = inspected(filler->mesh(), nearWeld, progress.part(0.6, 1.0));
    return [this, document, key, revision, round, options, name, cache = prepared.cache, attempt, after] {
      if (!m_tabs.contains(document)) return;
      if (!isStale(document, revision))
        return filledOne(document, key, cache, {attempt, options, fillStep(key, options)}, after);
      reportStale(*document, name, round);
      if (round == Round::First) startFill(document, key, {nullptr, std::nullopt, options}, Round::Second);
    };
  };
  start(document, std::move(job));
}

void RepairJobs::filledOne(MeshTab* document, Vertex key, const std::shared_ptr<HoleFillerCache>& cache,
                           const Filled& done, const InspectedMesh& after) {
  const int loop = document->defectList.loopWithKey(key);
  const QString name = document->defectList.loopName(loop);
  const int number = document->defectList.loopNumber(loop);
  const FillFailure failure = done.attempt.failure;
  document->defectList.setFailure(loop, failure);
  if (failure != FillFailure::None) {
    m_log.add(tr("%1 stays open: %2").arg(name, fillFailureReason(failure)), {}, LogEntry::Weight::Warning);
    return;
  }
  const QString command = stepCommand(*document, done.step);
  document->document.commit(tr("Fill hole %1").arg(number), after, done.step);
  m_log.add(tr("Filled %1 of %2").arg(name, document->document.name()), command);
  const Substitute substitute = substituteIn(done.attempt.patch, done.options);
  if (substitute != Substitute::None)
    m_log.add(tr("%1: %2").arg(name, substituteText(substitute, done.attempt.patch.method)));
  emit filled(document, key, cache);
}

void RepairJobs::removeDebris(MeshTab* document) {
  const std::vector<std::size_t>& debris = document->defectList.debris();
  const std::vector<Component>& components = document->document.defects().components;
  const auto all = std::count_if(components.begin(), components.end(), [](const Component& c) { return c.debris; });
  if (debris.size() == static_cast<std::size_t>(all)) return change(document, allDebrisFix());
  std::vector<Face> faces;  // without the pieces that a fix has cut off
  for (const std::size_t i : debris) faces.push_back(components[i].faces.front());
  change(document, debrisFix(std::move(faces)));
}

void RepairJobs::change(MeshTab* document, MeshChange wanted, std::optional<DefectRow> of) {
  std::deque<Request>& changes = m_changes[document];
  changes.push_back({document, std::move(wanted), of});
  if (changes.size() == 1) startChange(changes.front(), Round::First);
}

void RepairJobs::changeEnded(const DocumentTab* document) {
  const auto changes = m_changes.find(document);
  const MeshChange ended = std::move(changes->second.front().wanted);
  changes->second.pop_front();
  changes->second.empty() ? void(m_changes.erase(changes)) : startChange(changes->second.front(), Round::First);
  ended.ended();
}

// Removes the changes that are not running.
void RepairJobs::dropChanges(const DocumentTab* document) {
  const auto changes = m_changes.find(document);
  if (changes != m_changes.end()) changes->second.resize(1);
}

void RepairJobs::startChange(Request request, Round round) {
  MeshTab* const document = request.document;
  request.revision = document->document.revision();
  const QString text = QCoreApplication::translate("Tool", request.wanted.text);
  Job job;
  job.name = text;
  const bool isSearched = document->defectList.selfIntersections().has_value();
  FaceSelection oldDebris;
  for (const Component& piece : document->document.defects().components)
    for (const Face f : piece.faces) oldDebris.add(f);
  job.work = [this, request, round, text, isSearched, nearWeld = nearWeld(), oldDebris = std::move(oldDebris),
              mesh = document->document.mesh()](Progress progress) -> Job::Finish {
    HalfEdgeMesh result = mesh;
    request.wanted.apply(result, progress.part(0.0, 0.4));
    ChangeEffects effects = effectsOf(request.wanted, mesh, result, isSearched, progress.part(0.4, 0.5));
    if (progress.cancelled()) return {};
    const InspectedMesh after = inspected(std::move(result), nearWeld, progress.part(0.5, 1.0));
    if (progress.cancelled()) return {};
    if (request.wanted.isFix) effects.cutOff = cutOffCorners(mesh, oldDebris, after);
    return [this, request, round, text, effects, after] {
      if (!m_tabs.contains(request.document)) return changeEnded(request.document);
      if (!isStale(request.document, request.revision)) {
        changed(request, text, after, effects);
        return changeEnded(request.document);
      }
      reportStale(*request.document, text, round);
      if (round == Round::First) return startChange({request.document, request.wanted, {}}, Round::Second);
      changeEnded(request.document);
    };
  };
  job.failed = [this, document](const Error&) { changeEnded(document); };
  start(document, std::move(job));
}

void RepairJobs::changed(const Request& request, const QString& text, const InspectedMesh& after,
                         const ChangeEffects& effects) {
  MeshTab* const document = request.document;
  const MeshChange& wanted = request.wanted;
  const auto& crossings = effects.crossings;
  DefectList& defectList = document->defectList;
  // Those of a mesh that its file rounds are searched again as a whole.
  const auto known = isExactIn(document->document.mesh(), document->document.fileNumbers())
                         ? defectList.selfIntersections()
                         : std::nullopt;
  const auto before = defectList.counts();
  const QString command = stepCommand(*document, wanted.step);
  defectList.keepPieces(effects.cutOff);
  if (document->document.commit(text, after, wanted.step)) {
    if (crossings && known && known->size() < kMaxTrianglePairs)
      defectList.setSelfIntersections(document->document.revision(), intersectionsAfter(*crossings, *known));
    if (wanted.isFix) {
      document->fixedAt = presentPoint(document->document);
      defectList.setBefore(before, effects.loops);
    }
    noteReasons(defectList, wanted, request.of, document->document.revision() == request.revision);
    document->keepFindings();
    const auto undo = [this, document] {
      if (m_tabs.contains(document)) document->document.history()->undo();
    };
    logChange(*document, wanted, text, command);
    if (effects.removed) {
      const QString warning = removalWarning(*effects.removed, document->document.displayUnit());
      m_log.add(warning, {}, LogEntry::Weight::Warning);
      emit message(partRemovedMessage(document->document, text, warning, undo));
    }
    if (effects.piecesGone > 0)  // one triangle was meant, perhaps, and all that hangs together with it was selected
      emit message(piecesDeletedMessage(document->document, effects.piecesGone, effects.facesGone, undo));
    if (!crossings || !wanted.crossed) return;
    if (crossings->fresh > 0) reportCrossings(*document, *crossings);
    wanted.crossed(crossings->fresh);
  } else if (wanted.volume && wanted.volume->error) {
    const Error& error = *wanted.volume->error;
    emit changedNothing(document, text, errorSentence(error) + QLatin1Char(' ') + errorAdvice(error));
  } else if (const char* reason = reasonOf(wanted)) {
    noteReasons(defectList, wanted, request.of, document->document.revision() == request.revision);
    if (request.of && request.of->row < 0) defectList.setHopeless(request.of->kind);
    document->keepFindings();
    emit changedNothing(document, text, tr("Why: %1.").arg(QCoreApplication::translate("Tool", reason)));
  }
}

void RepairJobs::logChange(const MeshTab& document, const MeshChange& done, const QString& text,
                           const QString& command) {
  const ChangeSummary summary = changeSummaryOf(document, done, text);
  m_log.add(summary.line, command,
            summary.isPartly || summary.hasLostWalls ? LogEntry::Weight::Warning : LogEntry::Weight::Info);
  if (summary.isPartly) {
    emit changedPartly(&document, text, summary.how);
  } else if (summary.isWorthMessage) {
    Message change = changeMessage(document.document, text, summary.how);
    if (summary.hasLostWalls) change.weight = Message::Weight::Warning;
    change.comesFirst = summary.hasLostWalls;
    emit message(change);
  }
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
  options.sheets = SheetHandling::Keep;  // the list shows them as left open
  options.cutCrossings = true;           // adds nothing, and only where it leaves none of a cluster
  const FidelityValues settings = m_fidelity.values();
  apply(settings, options);
  options.fill.numbers = document->document.fileNumbers();
  options.keepOpen = keptLoops(document->document);
  Job job;
  job.name = tr("Repairing %1").arg(document->document.name());
  const bool isSearched = document->defectList.selfIntersections().has_value();
  job.work = [this, document, revision, round, options, settings, isSearched, name = job.name,
              mesh = document->document.mesh()](Progress progress) -> Job::Finish {
    HalfEdgeMesh result = mesh;
    const auto report = std::make_shared<RepairReport>();
    const MeshChange wanted = repairChange(options, report);
    wanted.apply(result, progress.part(0.0, 0.85));
    std::optional<FacePairs> pairs;
    if (isSearched && !report->cancelled)
      pairs = selfIntersectingPairs(result, options.fill.numbers, progress.part(0.85, 0.9));
    if (report->cancelled || progress.cancelled()) return {};
    const InspectedMesh after = inspected(std::move(result), options.nearWeld, progress.part(0.9, 0.98));
    const RemainingDefects left = remainingDefects(after, *report, progress.part(0.98, 1.0));
    return [this, document, revision, round, options, settings, name, step = wanted.step, report,
            pairs = std::move(pairs), after, left] {
      if (!m_tabs.contains(document)) return;
      if (!isStale(document, revision))
        return repairedAll(document, after, {*report, options, settings, step, pairs, left});
      reportStale(*document, name, round);
      if (round == Round::First) startRepair(document, Round::Second);
    };
  };
  start(document, std::move(job));
}

void RepairJobs::repairedAll(MeshTab* document, const InspectedMesh& after, const Repaired& done) {
  DefectList& defectList = document->defectList;
  const auto before = defectList.counts();
  const LengthUnit unit = document->document.displayUnit();
  const QString command = document->isAsInFile() ? repairCommand(document->document.path(), done.options)
                                                 : stepCommand(*document, done.step);
  std::map<int, QString> names;
  for (const LoopResult& loop : done.report.loops)
    if (loop.id >= 0) names[loop.id] = defectList.loopName(loop.id);
  const bool isChanged = document->document.commit(tr("Repair all"), after, done.step);
  if (isChanged && done.pairs) defectList.setSelfIntersections(document->document.revision(), *done.pairs);
  document->repairedAt = presentPoint(document->document);
  document->repairedWith = done.settings;
  if (isChanged) document->fixedAt = presentPoint(document->document);
  defectList.setFailures(failuresOf(done.report));
  // A repair that changes nothing has no summary: what is known from before is of another change, whose warnings stay.
  RepairFindings findings = defectList.findings();
  findings.before = isChanged ? before : decltype(before)();
  findings.loopOutcomes = isChanged ? countOutcomes(done.report) : LoopCounts();
  findings.doneBesides = isChanged ? doneBesides(done.report, before, defectList.counts(), unit) : QStringList();
  findings.reasons = reasonsOf(done.left, done.report, done.options);
  if (!done.report.isIntersectionRemovalIncomplete) findings.hopeless.insert(DefectKind::SelfIntersection);
  if (isChanged) findings.patchWarnings = patchWarningsOf(done.report, names);
  if (isChanged && done.report.removed) findings.removalWarning = removalWarning(*done.report.removed, unit);
  defectList.setFindings(std::move(findings));  // at once: each change of the list is shown
  document->keepFindings();
  logRepair(m_log, *document, done.report, names, command);
  if (!isChanged)
    emit changedNothing(document, tr("Repair all"),
                        tr("Nothing more could be repaired without damage. The list of defects gives the reasons that "
                           "are known."));
}

double RepairJobs::nearWeld() const {
  return m_fidelity.values().of(nearWeldSetting());
}

bool RepairJobs::isStale(MeshTab* document, std::uint64_t revision) const {
  return document->document.revision() != revision;
}

void RepairJobs::reportStale(const MeshTab& document, const QString& job, Round round) {
  const QString name = document.document.name();
  m_log.add(round == Round::First ? tr("%1 was changed meanwhile; the job runs again").arg(name)
                                  : tr("%1 was changed again; the result was discarded").arg(name),
            {}, LogEntry::Weight::Warning);
  if (round == Round::Second) emit message(discardedResultMessage(job, document.document));
}

void RepairJobs::start(const DocumentTab* document, Job job) {
  job.document = &document->document;
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
  if (error.code == ErrorCode::Cancelled) return;
  m_log.add(job + QStringLiteral(": ") + errorSentence(error), {}, LogEntry::Weight::Warning);
  if (!m_tabs.contains(document)) return;
  emit message(jobFailedMessage(document->document, job, error));
}

void RepairJobs::ended(const DocumentTab* document) {
  m_working.erase(m_working.find(document));
  emit workingChanged();
}

}  // namespace handwheel
