// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What ManualLatheTool commits to its document, and how it follows that.
#include "tools/workpiece/ManualLatheTool.h"
#include "tools/workpiece/PassNames.h"

#include <QCoreApplication>
#include <QLocale>
#include <utility>

namespace handwheel {

// Ends the simulation, and keeps its last state of the lathe.
std::unique_ptr<LatheSimulation> ManualLatheTool::endSimulation() {
  std::unique_ptr<LatheSimulation> ended(static_cast<LatheSimulation*>(m_gesture.end().release()));
  ended->finish();
  const auto last = std::static_pointer_cast<const LatheMoment>(ended->state());
  m_machine = last->machine;
  recordCrashes(*last);
  m_recorded = 0;
  m_collisions.insert(m_collisions.end(), last->collisions->begin(), last->collisions->end());
  m_warnings.insert(m_warnings.end(), last->warnings->begin(), last->warnings->end());
  return ended;
}

bool ManualLatheTool::endPass(bool isAtOnce) {
  m_gesture.rethrow();
  const auto now = moment();
  recordCrashes(*now);
  if (!now->isCut || !(isAtOnce || isDue(*now))) return false;
  commitPasses(*endSimulation());
  m_gesture.restart();
  return true;
}

bool ManualLatheTool::isDue(const LatheMoment& now) const {
  return now.isCut && !m_isDragging && (now.isFull || now.sinceCut >= kIdle);
}

bool ManualLatheTool::hasToCommit() const {
  const auto now = moment();
  return isDue(*now) || now->collisions->size() > m_recorded;
}

// Commits the present state of the simulation: the state that the window has seen is some milliseconds old.
void ManualLatheTool::settle() {
  m_gesture.rethrow();
  if (!isLive()) return recordCrashes(*moment());
  commitPasses(*endSimulation());
  m_gesture.restart();
}

// All that the simulation did has to be in its state: LatheSimulation::finish().
std::shared_ptr<const TurnedPart> ManualLatheTool::partWith(const LatheSimulation& lathe) const {
  const auto last = std::static_pointer_cast<const LatheMoment>(lathe.state());
  TurnedPart part = m_present.of(m_document.workpiece());
  const TurnedProfile before = std::exchange(part.profile, last->profile);
  part.surface = last->surface;
  part.finish = last->finish;
  TurnedProfile settled = before;
  for (const TurningPass& each : lathe.passes()) {
    const auto pass = std::make_shared<const TurningPass>(each);
    TurnedProfile next = last->profile;
    settlePass(next, settled, pass, static_cast<std::uint32_t>(part.passes.size()));
    settled = std::move(next);
    part.passes.push_back(pass);
  }
  part.profile = std::move(settled);
  return std::make_shared<const TurnedPart>(std::move(part));
}

SnapshotPointer ManualLatheTool::withGesture() {
  recordCrashes(*moment());
  if (!moment()->isCut) return nullptr;
  auto workpiece = std::make_shared<WorkpieceSnapshot>(m_document.workpiece());
  m_gesture.look([&](Simulation& simulation) {
    auto& lathe = static_cast<LatheSimulation&>(simulation);
    lathe.finish();
    workpiece->part = partWith(lathe);
  });
  return workpiece;
}

QString ManualLatheTool::underWay() const {
  const auto now = moment();
  if (!now->isCut) return {};
  const QString number = QLocale().toString((m_part ? m_part->passes.size() : 0) + 1);
  // If a drill is fitted, only the end of the pass tells which tool cuts.
  if (setup().tailstock.fitting == LatheFitting::Drill)
    return QCoreApplication::translate("Tool", "Pass %1").arg(number);
  return passName(now->tool.get(), TurningSide::Outside, number);
}

void ManualLatheTool::commitPasses(const LatheSimulation& lathe) {
  const auto last = std::static_pointer_cast<const LatheMoment>(lathe.state());
  if (!last->isCut) return;
  auto part = partWith(lathe);
  const QString text = passesText(*part, part->passes.size() - lathe.passes().size(), last->removed);
  m_isCommitting = true;
  m_document.commit(text, std::make_unique<TurnedPartEdit>(std::move(part)));
  m_isCommitting = false;
  m_part = m_document.workpiece().part;
  m_states.note(m_part, *m_machine);
}

// Crashes are recorded at once, without waiting for a pass, and undo does not remove them.
void ManualLatheTool::recordCrashes(const LatheMoment& moment) {
  const std::vector<LatheCollision>& all = *moment.collisions;
  if (all.size() <= m_recorded) return;
  m_document.addCrashes(std::span(all).subspan(std::exchange(m_recorded, all.size())));
}

// Returns the state with the cross slide drawn back beside the work, a millimetre clear of its largest radius: at the
// same Z or, if the jaws are there, just as far along the bed as clears them. None: that is not clear either, for
// example for a boring bar.
std::optional<LatheState> ManualLatheTool::drawnBack(const LatheSetup& lathe, LatheState state) const {
  constexpr double kClear = 1.0;      // mm
  constexpr double kWideTool = 40.0;  // mm, of one that reaches so far towards the chuck
  constexpr auto kCross = static_cast<std::size_t>(LatheAxis::Cross);
  constexpr auto kCarriage = static_cast<std::size_t>(LatheAxis::Carriage);
  const TurnedProfile profile = m_present.of(m_document.workpiece()).profile;
  double thickest = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i) thickest = std::max(thickest, profile.radius(i));
  const LatheSlot& slot = lathe.stations[std::min<std::size_t>(state.tool, lathe.stations.size() - 1)];
  const ProfilePoint tip = tipAt(lathe, slot, state.slides);
  const double by = thickest + kClear - tip.x();
  if (!(by > 0.0)) return std::nullopt;
  const double beyondJaws = lathe.chuck.grip + kClear - tip.y();
  for (const double along : {0.0, beyondJaws, beyondJaws + kWideTool}) {
    if (along < 0.0) continue;
    LatheState back = state;
    for (auto* travel : {&back.wheels, &back.slides}) {
      (*travel)[kCross] += by;
      (*travel)[kCarriage] += along;
    }
    const bool isReached =
        back.slides[kCross] <= lathe.dials[kCross].largest && back.slides[kCarriage] <= lathe.dials[kCarriage].largest;
    if (isReached && LatheRun(lathe, m_tools, profile, back).isClear()) return back;
  }
  return std::nullopt;
}

// With another part, for example after undo, the slides come to rest where they are; the spindle continues. A tool that
// is in material that came back is drawn back or, if that does not help, moved to its position when that part was made.
void ManualLatheTool::follow(const LatheSetup& lathe) {
  LatheState now = *m_machine;
  now.demands = {};
  now.rapids = {};
  now.feed = now.lead = 0.0;
  now.isNutClosed = false;
  if (!LatheRun(lathe, m_tools, m_present.of(m_document.workpiece()).profile, now).isClear()) {
    const LatheState restored =
        drawnBack(lathe, now)
            .value_or(m_states.of(m_part).value_or(LatheMachine::initialState(lathe, m_document.workpiece().stock)));
    now.wheels = restored.wheels;
    now.slides = restored.slides;
    now.tool = restored.tool;
    ++m_returns;
  }
  m_machine = now;
}

// Cuts that are not in the document yet are dropped.
void ManualLatheTool::documentChanged() {
  if (m_isCommitting) return;
  m_isDragging = false;
  renewMaterial();
  const LatheSetup lathe = setup();
  showLathe(lathe);
  const bool isDropped = moment()->isCut;
  endSimulation();
  const auto before = std::exchange(m_part, m_document.workpiece().part);
  const bool isSame = before == m_part || (before && m_part && before->profile == m_part->profile);
  if (!isSame || isDropped) follow(lathe);
  m_gesture.restart();
}

}  // namespace handwheel
