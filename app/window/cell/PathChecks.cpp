// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/PathChecks.h"

#include "document/cell/CellArms.h"
#include "document/cell/RobotCellDocument.h"
#include "planning/PlanningFidelity.h"
#include "text/ErrorText.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr std::size_t kMostResults = 8;  // Number of results per path

// Returns true if stored findings contradict each other, as those of a verification never do.
bool isContradictory(const PathFindings& found, BasisChange change, double clearance) {
  constexpr double kTolerance = 1e-6;  // mm
  if (found.isCertified && (found.collisions > 0 || !found.listed.empty())) return true;
  return change == BasisChange::Nothing && !(std::abs(found.clearance - clearance) <= kTolerance);
}

PathProof proofOf(const PathResult& result) {
  return {*result.found, result.at.toUTC().toString(Qt::ISODate).toStdString(), result.digests};
}

}  // namespace

PathChecks::PathChecks(const WindowContext& parts, CellCollisions& collisions, QObject* parent)
    : QObject(parent), m_parts(parts), m_collisions(collisions) {
  connect(&collisions, &CellCollisions::prepared, this, &PathChecks::goOn);
}

PathChecks::~PathChecks() {
  setDocument(nullptr);
  for (const auto& each : std::exchange(m_elsewhere, {})) m_parts.jobs.cancelOf(each.first);
}

// The jobs of a document have it as their owner. A verification that nobody asked for is of no use out of view.
void PathChecks::setDocument(DocumentTab* document) {
  const bool goesOn = m_run && (m_run->isAsked || m_run->isOfAll);
  if (goesOn || m_isAllAsked) m_elsewhere[m_document] = {goesOn ? m_run : std::nullopt, {}, m_waiting, m_isAllAsked};
  m_run.reset();
  m_waiting.clear();
  m_isAllAsked = false;
  if (m_document && !goesOn) m_parts.jobs.cancelOf(m_document);
  m_parts.jobs.cancelOf(&m_results);
  m_digests.reset();
  disconnect(m_changes);
  m_document = document;
  if (!document) return;
  m_changes = connect(&document->document, &Document::changed, this, &PathChecks::storeThoseThatHold);
  if (auto known = m_elsewhere.extract(document)) {
    m_run = std::move(known.mapped().run);
    m_waiting = std::move(known.mapped().waiting);  // goOn() as soon as the cell is prepared
    m_isAllAsked = known.mapped().isAll;
    if (const auto& ended = known.mapped().verified; ended && holds(*ended)) emit verified(*ended);
  }
  recall();
}

// Restores the stored results of the paths of a document that was opened.
void PathChecks::recall() {
  const auto now = content();
  if (now->proofs->empty()) m_recalled.insert(m_document);
  if (m_recalled.contains(m_document)) return;
  Job job;
  job.name = tr("Comparing the cell with what was verified");
  job.document = &m_document->document;
  job.owner = &m_results;
  job.lane = Job::Lane::Looking;
  job.isUnasked = true;
  job.work = [this, now](Progress) -> Job::Finish {
    const auto digests = std::make_shared<const PathDigests>(now);
    Results results;
    for (const RobotPath& path : now->plans->paths) {
      const auto proof = now->proofs->find(path.name);
      if (proof == now->proofs->end()) continue;
      const BasisChange change = changeBetween(proof->second.basis, digests->of(path));
      if (isContradictory(proof->second.found, change, now->plans->clearanceOf(path))) continue;
      const QDateTime at = QDateTime::fromString(QString::fromStdString(proof->second.at), Qt::ISODate).toLocalTime();
      results[path.name] = {{basisOf(*now, path), proof->second.found, {}, nullptr, at, change, proof->second.basis}};
    }
    return [this, digests, results = std::move(results)]() mutable {
      m_recalled.insert(m_document);
      m_results[m_document].merge(results);
      m_digests = digests;
      emit changed();
    };
  };
  m_parts.jobs.start(std::move(job));
}

std::shared_ptr<const RobotCellSnapshot> PathChecks::content() const {
  return std::static_pointer_cast<const RobotCellSnapshot>(m_document->document.snapshot());
}

// A renamed path is found by its waypoints.
const PathResult* PathChecks::resultOf(const RobotPath& path, const RobotCellSnapshot& now) const {
  const auto known = m_results.find(m_document);
  if (known == m_results.end()) return nullptr;
  const Results& results = known->second;
  auto of = results.find(path.name);
  if (of == results.end()) {
    const auto isSame = [&](const PathResult& result) { return haveSameWaypoints(result.basis.path, path); };
    of = std::find_if(results.begin(), results.end(), [&](const auto& each) {
      return !now.plans->path(each.first) && std::any_of(each.second.begin(), each.second.end(), isSame);
    });
  }
  if (of == results.end()) return nullptr;
  const auto holding = std::find_if(of->second.rbegin(), of->second.rend(), [&](const PathResult& result) {
    return changeOf(result, now, path) == BasisChange::Nothing;
  });
  return holding == of->second.rend() ? &of->second.back() : &*holding;
}

BasisChange PathChecks::changeOf(const PathResult& result, const RobotCellSnapshot& now, const RobotPath& path) {
  return result.changedBefore != BasisChange::Nothing ? result.changedBefore : changeSince(result.basis, now, path);
}

bool PathChecks::holds(const PathResult& result) const {
  const auto now = content();
  const RobotPath* const path = now->plans->path(result.basis.path.name);
  return path && changeOf(result, *now, *path) == BasisChange::Nothing;
}

bool PathChecks::isRunning(const RobotPath& path, const RobotCellSnapshot& now) const {
  return m_run && m_run->basis.path.name == path.name && changeSince(m_run->basis, now, path) == BasisChange::Nothing;
}

PathChecks::State PathChecks::stateOf(const RobotPath& path) const {
  if (!m_document) return {};
  const auto now = content();
  State state{resultOf(path, *now), BasisChange::Nothing, isRunning(path, *now)};
  if (state.last) state.change = changeOf(*state.last, *now, path);
  return state;
}

std::shared_ptr<const CheckedPath> PathChecks::of(const RobotPath& path) const {
  const State state = stateOf(path);
  return state.last && state.change == BasisChange::Nothing ? state.last->checked : nullptr;
}

void PathChecks::verify(const RobotPath& path, Request request) {
  const auto now = content();
  const auto scene = sceneFor(path, *now);
  if (!scene) return;
  const State state = stateOf(path);
  if (state.isUnderWay) {
    m_run->isAsked |= request == Request::Again;
    return;
  }
  // A result that was only stored is verified again.
  const bool isKnown =
      state.last && state.change == BasisChange::Nothing && (state.last->checked || !state.last->found);
  if (request != Request::Again && isKnown) return;
  const FidelityValues& fidelity = m_parts.fidelity.values();
  const PathCheckSettings settings{
      .clearance = now->plans->clearanceOf(path),
      .resolution = std::min(PathCheckSettings().resolution, fidelity.of(planResolutionSetting())),
      .step = fidelity.of(verifyStepSetting())};
  // A running verification of a waiting path gives precedence to the requested one; so does the last of all, which is
  // not finished.
  if (m_run && (m_isAllAsked || !m_waiting.empty())) m_waiting.push_back(m_run->basis.path.name);
  m_parts.jobs.cancelOf(m_document);
  const std::uint64_t run = ++m_runs;
  m_run = Run{basisOf(*now, path), request == Request::Again, request == Request::OfAll, run};
  Job job;
  job.name = tr("Verifying %1").arg(QString::fromStdString(path.name));
  job.document = &m_document->document;
  job.owner = m_document;
  job.lane = Job::Lane::Looking;
  job.isUnasked = request == Request::Known;
  job.failed = [this, document = m_document, run](const Error&) { fail(document, run); };
  job.work = [this, document = m_document, run, scene, path, settings, now,
              former = m_digests](Progress progress) -> Job::Finish {
    // With its tool.
    const Result<CellPlans> plans = withArmChosen(*now->robot, *now->plans, scene->plannedArm().name);
    Outcome outcome{plans ? checkPath(*scene, *plans, path, settings, progress) : Result<CheckedPath>(plans.error()),
                    scene, nullptr};
    outcome.digests = std::make_shared<const PathDigests>(now, former.get());
    return [this, document, run, outcome = std::move(outcome)] { take(document, run, outcome); };
  };
  m_parts.jobs.start(std::move(job));
  emit changed();
}

std::optional<PathChecks::Run>* PathChecks::runOf(const DocumentTab* document, std::uint64_t number) {
  const auto elsewhere = m_elsewhere.find(document);
  auto* const found = document == m_document           ? &m_run
                      : elsewhere != m_elsewhere.end() ? &elsewhere->second.run
                                                       : nullptr;
  return found && *found && (*found)->number == number ? found : nullptr;
}

// The others that are waiting are not begun either.
void PathChecks::fail(DocumentTab* document, std::uint64_t run) {
  if (!runOf(document, run)) return;
  m_elsewhere.erase(document);
  if (document != m_document) return;
  m_run.reset();
  m_waiting.clear();
  m_isAllAsked = false;
  if (m_document) emit changed();
}

void PathChecks::take(DocumentTab* document, std::uint64_t run, const Outcome& outcome) {
  std::optional<Run>* const present = runOf(document, run);
  if (!present) return;
  const Run done = std::move(**present);
  present->reset();
  const PathResult result = added(document, done, outcome);
  if (document != m_document) {
    if (done.isAsked) m_elsewhere[document].verified = result;
    return;
  }
  m_digests = outcome.digests;
  emit changed();
  if (done.isAsked) emit verified(result);
  goOn();
}

PathResult PathChecks::added(DocumentTab* document, const Run& done, const Outcome& outcome) {
  PathResult result{.basis = done.basis,
                    .found = {},
                    .checked = nullptr,
                    .at = QDateTime::currentDateTime(),
                    .digests = outcome.digests->of(done.basis.path)};
  if (outcome.checked) {
    result.checked = std::make_shared<const CheckedPath>(*outcome.checked);
    result.found = findingsOf(*outcome.checked, *outcome.scene, done.basis.clearance);
  } else {
    result.problem = errorSentence(outcome.checked.error());
  }
  std::vector<PathResult>& known = m_results[document][done.basis.path.name];
  std::erase_if(known, [&](const PathResult& each) { return each.digests == result.digests; });
  if (known.size() == kMostResults) known.erase(known.begin());
  known.push_back(result);
  store(document->document, result, done.isAsked || done.isOfAll);
  return result;
}

// With the document. Only one that a person asked for, and that says something new, is a change that is to be saved.
void PathChecks::store(Document& document, const PathResult& result, bool isAsked) {
  auto& cell = static_cast<RobotCellDocument&>(document);
  const std::string& name = result.basis.path.name;
  PathProofs proofs = cell.proofs();
  const auto known = proofs.find(name);
  if (!result.found) {
    if (proofs.erase(name) > 0) cell.setProofs(std::move(proofs), false);
    return;
  }
  const PathProof proof = proofOf(result);
  const bool isNew = known == proofs.end() || known->second.found != proof.found || known->second.basis != proof.basis;
  proofs[name] = proof;
  cell.setProofs(std::move(proofs), isAsked && isNew);
}

// A result that undo or redo makes valid again is stored, but is no change that has to be saved.
void PathChecks::storeThoseThatHold() {
  auto& cell = static_cast<RobotCellDocument&>(m_document->document);
  const auto now = content();
  PathProofs proofs = cell.proofs();
  bool isOther = false;
  for (const RobotPath& path : now->plans->paths) {
    const PathResult* const result = resultOf(path, *now);
    if (!result || !result->found || changeOf(*result, *now, path) != BasisChange::Nothing) continue;
    const PathProof proof = proofOf(*result);
    const auto known = proofs.find(path.name);
    if (known != proofs.end() && known->second == proof) continue;
    proofs[path.name] = proof;
    isOther = true;
  }
  if (isOther) cell.setProofs(std::move(proofs), false);
}

void PathChecks::renamed(const std::string& from, const std::string& to) {
  auto& cell = static_cast<RobotCellDocument&>(m_document->document);
  PathProofs proofs = cell.proofs();
  const auto proof = proofs.find(from);
  if (proof == proofs.end()) return;
  proofs.insert_or_assign(to, PathProof(proof->second));  // the other one stays for when the new name is undone
  cell.setProofs(std::move(proofs), false);
}

// Those of all robots, each with the others where they stand.
void PathChecks::verifyAll() {
  if (!m_document) return;
  m_waiting.clear();
  for (const RobotPath& path : content()->plans->paths) {
    if (path.waypoints.size() >= 2) m_waiting.push_back(path.name);
  }
  m_isAllAsked = true;
  goOn();
}

std::shared_ptr<const CellScene> PathChecks::sceneFor(const RobotPath& path, const RobotCellSnapshot& now) const {
  const auto number = armNumber(*now.robot, path.arm);
  return number ? m_collisions.sceneFor(*number) : nullptr;
}

// Continues with the next waiting path, once the cell is prepared and nothing else is running.
void PathChecks::goOn() {
  if (!m_document || !m_collisions.isReady()) return;
  const auto now = content();
  while (!m_run && !m_waiting.empty()) {
    const RobotPath* const path = now->plans->path(m_waiting.front());
    m_waiting.pop_front();
    if (path && path->waypoints.size() >= 2) verify(*path, Request::OfAll);
  }
  if (!m_run && std::exchange(m_isAllAsked, false)) emit allVerified();
}

}  // namespace handwheel
