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

namespace handwheel {

namespace {

QStringList collisionsOf(const CellScene& scene, const CheckedPath& checked) {
  constexpr std::size_t kMostListed = 5;
  QStringList texts;
  const auto& all = checked.verification.collisions;
  for (std::size_t i = 0; i < std::min(all.size(), kMostListed); ++i) {
    const auto [link, other] = scene.namesOf(all[i].deepest);
    texts += PathChecks::tr("On the way to place %1: %2 with %3")
                 .arg(checked.placeOf(all[i].motion) + 1)
                 .arg(QString::fromStdString(link), QString::fromStdString(other));
  }
  return texts;
}

}  // namespace

PathChecks::PathChecks(const WindowContext& parts, CellCollisions& collisions, QObject* parent)
    : QObject(parent), m_parts(parts), m_collisions(collisions) {
  connect(&collisions, &CellCollisions::prepared, this, &PathChecks::goOn);
}

PathChecks::~PathChecks() {
  m_parts.jobs.cancelOf(this);
}

void PathChecks::setDocument(DocumentTab* document) {
  m_run.reset();
  m_waiting.clear();
  m_parts.jobs.cancelOf(this);
  m_document = document;
}

std::shared_ptr<const RobotCellSnapshot> PathChecks::content() const {
  return std::static_pointer_cast<const RobotCellSnapshot>(m_document->document.snapshot());
}

// One that was renamed is found by its places.
const PathResult* PathChecks::resultOf(const RobotPath& path, const RobotCellSnapshot& now) const {
  const auto known = m_results.find(m_document);
  if (known == m_results.end()) return nullptr;
  const auto& results = known->second;
  if (const auto found = results.find(path.name); found != results.end()) return &found->second;
  const auto renamed = std::find_if(results.begin(), results.end(), [&](const auto& each) {
    return !now.plans->path(each.first) && areSameWay(each.second.basis.path, path);
  });
  return renamed == results.end() ? nullptr : &renamed->second;
}

bool PathChecks::isRunning(const RobotPath& path, const RobotCellSnapshot& now) const {
  return m_run && m_run->basis.path.name == path.name && changeSince(m_run->basis, now, path) == BasisChange::Nothing;
}

PathChecks::State PathChecks::stateOf(const RobotPath& path) const {
  if (!m_document) return {};
  const auto now = content();
  State state{resultOf(path, *now), BasisChange::Nothing, isRunning(path, *now)};
  if (state.last) state.change = changeSince(state.last->basis, *now, path);
  return state;
}

std::shared_ptr<const CheckedPath> PathChecks::of(const RobotPath& path) const {
  const State state = stateOf(path);
  return state.last && state.change == BasisChange::Nothing ? state.last->checked : nullptr;
}

void PathChecks::verify(const RobotPath& path, Wish wish) {
  const auto scene = m_collisions.scene();
  const auto now = content();
  const State state = stateOf(path);
  if (state.isUnderWay) {
    m_run->isAsked |= wish == Wish::Again;
    return;
  }
  const bool isKnown = state.last && state.change == BasisChange::Nothing;
  if (wish == Wish::Known && isKnown) return;
  const FidelityValues& fidelity = m_parts.fidelity.values();
  const PathCheckSettings settings{
      .clearance = now->plans->clearance,
      .resolution = std::min(PathCheckSettings().resolution, fidelity.of(planResolutionSetting())),
      .step = fidelity.of(verifyStepSetting())};
  // One of those that wait gives way to the one that is asked for.
  if (m_run && !m_waiting.empty()) m_waiting.push_back(m_run->basis.path.name);
  m_parts.jobs.cancelOf(this);
  const std::uint64_t run = ++m_runs;
  m_run = Run{basisOf(*now, path, scene->dofs), wish == Wish::Again, run};
  Job job;
  job.name = tr("Verifying %1").arg(QString::fromStdString(path.name));
  job.owner = this;
  job.failed = [this, run](const Error&) {
    if (!m_run || m_run->number != run) return;
    m_run.reset();
    m_waiting.clear();
    if (m_document) emit changed();
  };
  job.work = [this, run, scene, path, settings, plans = now->plans](Progress progress) -> Job::Finish {
    auto found = checkPath(*scene, *plans, path, settings, progress);
    return [this, run, scene, found = std::move(found)] { take(run, *scene, found); };
  };
  m_parts.jobs.start(std::move(job));
  emit changed();
}

void PathChecks::take(std::uint64_t run, const CellScene& scene, const Result<CheckedPath>& found) {
  if (!m_document || !m_run || m_run->number != run) return;
  const Run done = std::move(*m_run);
  m_run.reset();
  PathResult result{.basis = done.basis, .checked = nullptr, .at = QDateTime::currentDateTime()};
  if (found) {
    result.checked = std::make_shared<const CheckedPath>(*found);
    result.collisions = collisionsOf(scene, *found);
    result.hasShapeless = !scene.shapeless.empty();
  } else {
    result.problem = errorSentence(found.error());
  }
  m_results[m_document][done.basis.path.name] = result;
  emit changed();
  if (done.isAsked) emit verified(result);
  goOn();
}

void PathChecks::verifyAll() {
  if (!m_document) return;
  m_waiting.clear();
  const auto now = content();
  for (const RobotPath& path : now->plans->paths) {
    if (isSameArm(*now->robot, path.arm, now->plans->arm) && path.places.size() >= 2) m_waiting.push_back(path.name);
  }
  goOn();
}

// With the next one that waits, once the cell is prepared and nothing else is under way.
void PathChecks::goOn() {
  if (!m_document || !m_collisions.scene()) return;
  const auto now = content();
  while (!m_run && !m_waiting.empty()) {
    const RobotPath* const path = now->plans->path(m_waiting.front());
    m_waiting.pop_front();
    if (path && path->places.size() >= 2 && isSameArm(*now->robot, path->arm, now->plans->arm)) verify(*path);
  }
}

}  // namespace handwheel
