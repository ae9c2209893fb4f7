// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/dialects/LinuxCncRun.h"

#include "base/NumberText.h"
#include "machining/program/ProgramArc.h"
#include "machining/program/cycles/DrillCycle.h"
#include "machining/program/cycles/ThreadCycle.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kMostContourLines = 100'000;

constexpr const char* kCompensatedFinish =
    "Finish without G70: call a subprogram that goes in with G42 (G41 in a bore), along the contour, and out with G40.";

// Makes moves. If nose compensation refuses them, the advice is the one for finishing with compensation.
template <class Moves>
void adviseOn(bool isCompensated, const Moves& moves) {
  try {
    moves();
  } catch (ProgramRefusal& refusal) {
    if (isCompensated && refusal.error.code == ProgramError::Refused)
      refusal.error.arguments.back() = kCompensatedFinish;
    throw;
  }
}

// Returns true for codes that a contour may contain; other codes in it have no effect on a machine, so they are
// refused.
bool isContourCode(int tenths) {
  return tenths == 0 || tenths == 10 || tenths == 20 || tenths == 30;
}

}  // namespace

// G70, G71 and G72 with the contour in the subprogram Q.
void LinuxCncRun::contourCycle(int tenths, const ProgramWord& g) {
  const ProgramMachine::Modal& modal = m_machine.modal;
  const double unit = m_machine.unit();
  const bool isFinish = tenths / 10 == 70;
  if (m_contour) refuse(g.location, g.text(), "a contour cannot contain a cycle", "Put the cycle outside of it.");
  if (m_machine.isCompensated() && !isFinish)
    refuse(g.location, g.text(), "it is not possible with nose compensation", "Write G40 before it.");
  if (modal.isDrillPlane) refuse(g.location, g.text(), "it works in the plane of X and Z", "Write G18 before it.");
  const double q = needed('Q', g, "the number of the subprogram with the contour");
  const std::uint32_t sub = m_outline.subprogram(roundedText(q, 12));
  if (sub == kNone)
    refuse(g.location, g.text(), "there is no subprogram " + roundedText(q, 12),
           "Write it as O" + roundedText(q, 12) + " sub ... endsub.");
  ContourCycle::Roughing rough;
  ContourCycle::Finishing finish;
  const ProfilePoint start = target();
  finish.first = number('D', 0.0);
  rough.allowance = finish.first;
  rough.start = finish.start = planePoint(start) / unit;
  if (isFinish) {
    finish.last = number('E', 0.0);
    finish.passes = has('P') ? whole(*word('P'), 1, 10'000) : 1;
  } else {
    rough.pockets = static_cast<ContourCycle::Pockets>(tenths % 10);
    rough.isFacing = tenths / 10 == 72;
    rough.depth = number('I', 1.0);
    rough.retract = number('R', 0.5);
    if (!(rough.depth > 0.0)) refuse(g.location, g.text(), "the depth of cut I is not above 0", "Correct I.");
    if (!(rough.retract >= 0.0)) refuse(g.location, g.text(), "the retract R is negative", "Correct R.");
  }
  const bool isCompensated = m_machine.isCompensated();
  adviseOn(isCompensated, [&] { m_machine.rapid(start, g.location); });

  std::vector<ContourSegment> contour;
  const int motion = modal.motion;
  m_contour = &contour;
  m_contourEnd = rough.start;
  runInside(sub + 1, g.location);
  m_contour = nullptr;
  if (contour.size() <= 1) return;
  m_machine.modal.motion = motion < 0 ? motion : m_machine.modal.motion;

  // LinuxCNC assumes the tool at the end of the contour, once it has read it. Only a corner with compensation shows it.
  if (isCompensated) m_machine.placeNose(profilePoint(unit * m_contourEnd));
  ContourCycle cycle(std::move(contour), g.location, m_cycleBudget);
  const CycleOutput output = cycleOutput(g.location, unit);
  if (!isFinish) {
    cycle.rough(rough, output);
    return;
  }
  if (isCompensated)
    note(g.location, std::string("With nose compensation on, G70 goes in from the end of the contour, as LinuxCNC 2.9 "
                                 "does. ") +
                         kCompensatedFinish);
  adviseOn(isCompensated, [&] { cycle.finish(finish, output); });
}

// Adds a line of a contour.
void LinuxCncRun::collect(const ProgramBlock& block) {
  sortCodes(block);
  for (const ProgramWord& w : block.words) {
    const int tenths = w.letter == 'G' ? static_cast<int>(std::lround(10.0 * w.number)) : 0;
    if (tenths >= 400 && tenths <= 421)
      refuse(w.location, w.text(), "the contour of a cycle has no nose compensation", kCompensatedFinish);
    if (w.letter == 'M' || !isContourCode(tenths))
      refuse(w.location, w.text(), "the contour of a cycle has no such code", "Put it before or after the cycle.");
  }
  ProgramMachine::Modal& modal = m_machine.modal;
  if (code(Motion)) modal.motion = codeOf(Motion);
  word('F'), word('S'), word('T');  // without effect here
  const double unit = m_machine.unit();
  PlanePoint to = m_contourEnd;
  const auto give = [&](char absolute, char increment, double scale, auto set) {
    const ProgramWord *const a = word(absolute), *const b = word(increment);
    if (a && b) refuse(b->location, b->text(), std::string("it contradicts ") + a->text(), "Remove one of them.");
    if (b && modal.isIncremental) refuse(b->location, b->text(), "it is not possible with G91", "Write G90 before it.");
    if (a) set(scale * a->number, modal.isIncremental);
    if (b) set(scale * b->number, true);
  };
  give('X', 'U', m_machine.radius(1.0) / unit, [&](double x, bool isMore) { to.imag(isMore ? to.imag() + x : x); });
  give('Z', 'W', 1.0, [&](double z, bool isMore) { to.real(isMore ? to.real() + z : z); });
  if (to != m_contourEnd) {
    if (m_contour->size() >= kMostContourLines)
      refuse(block.location, "contour", "it has too many lines", "Divide it.");
    ContourSegment segment;
    segment.from = m_contourEnd;
    segment.to = to;
    if (modal.motion == 20 || modal.motion == 30) {
      segment.turn = modal.motion == 30 ? 1 : -1;
      segment.centre =
          arcCentre(unit * segment.from, unit * to, segment.turn, modal.isArcAbsolute, block.location) / unit;
    } else if (modal.motion != 0 && modal.motion != 10) {
      refuse(block.location, block.words.front().text(), "there is no motion for X and Z",
             "Write G0 or G1 before them.");
    }
    m_contour->push_back(segment);
    const ProgramWord *const a = word('A'), *const c = word('C');
    for (const ProgramWord* const corner : {a, c}) {
      if (!corner) continue;
      ContourSegment finish;
      finish.turn = corner == a ? -1 : 0;
      finish.from = finish.to = finish.centre = to;
      finish.corner = corner->number;
      m_contour->push_back(finish);
    }
    m_contourEnd = to;
  }
  refuseUnread();
}

void LinuxCncRun::threadCycle(const ProgramWord& g) {
  const double unit = m_machine.unit();
  const double depthUnit = m_machine.radius(1.0);  // I, J and K are diameters if X is one
  if (m_machine.modal.isDrillPlane)
    refuse(g.location, g.text(), "it works in the plane of X and Z", "Write G18 before it.");
  ThreadCycle cycle;
  cycle.start = m_machine.at();
  cycle.endZ = target().y();
  if (has('X'))
    refuse(word('X')->location, word('X')->text(), "the drive line of the thread is parallel to Z", "Remove X.");
  cycle.pitch = unit * needed('P', g, "the pitch");
  const double i = depthUnit * needed('I', g, "from the drive line to the peaks");
  cycle.peak = std::abs(i);
  cycle.isInside = i > 0.0;
  cycle.firstDepth = depthUnit * needed('J', g, "the first depth");
  cycle.depth = depthUnit * needed('K', g, "the full depth");
  cycle.degression = std::max(1.0, number('R', 1.0));
  cycle.angle = number('Q', 0.0);
  cycle.springPasses = has('H') ? whole(*word('H'), 0, 10'000) : 0;
  cycle.taper = std::max(0.0, unit * number('E', 0.0));
  const int ends = has('L') ? whole(*word('L'), 0, 3) : 0;
  cycle.hasEntryTaper = ends & 1;
  cycle.hasExitTaper = ends & 2;
  const auto require = [&](bool isRight, const char* what) {
    if (!isRight) refuse(g.location, g.text(), what, "Correct the words of the cycle.");
  };
  require(i != 0.0, "I is 0: the drive line must be beside the peaks");
  require(cycle.pitch > 0.0, "the pitch P is not above 0");
  require(cycle.firstDepth > 0.0, "the first depth J is not above 0");
  require(cycle.depth > cycle.firstDepth, "the full depth K is not above the first one J");
  require(std::abs(cycle.angle) < 80.0, "the angle Q is not between -80 and 80 degrees");
  cycle.run(m_machine, g.location);
}

// G73, G81, G82, G83, G85 and G89 along Z.
void LinuxCncRun::drill(int tenths, const SourceLocation& location) {
  const std::string name = "G" + roundedText(0.1 * tenths);
  const double unit = m_machine.unit();
  const ProgramMachine::Modal& modal = m_machine.modal;
  if (!modal.isDrillPlane)
    refuse(location, name, "in this plane it would drill across", "Write G17 before it, G18 after.");
  if (modal.isIncremental) refuse(location, name, "it is not possible with G91", "Write G90 before it.");
  const bool hasPecks = tenths == 730 || tenths == 830;
  if (code(Motion)) m_drilling = {std::nan(""), std::nan(""), std::nan(""), 0.0};
  if (const ProgramWord* const z = word('Z')) m_drilling.depth = unit * z->number;
  if (const ProgramWord* const r = word('R')) m_drilling.retract = unit * r->number;
  if (const ProgramWord* const q = hasPecks ? word('Q') : nullptr) m_drilling.peck = unit * q->number;
  if (const ProgramWord* const p = tenths == 820 || tenths == 890 ? word('P') : nullptr) m_drilling.dwell = p->number;
  const auto [depth, retract, peck, dwell] = m_drilling;
  if (!std::isfinite(depth) || !std::isfinite(retract)) refuse(location, name, "Z or R is missing", "Write both.");
  if (depth > retract) refuse(location, name, "R is below Z", "Correct R.");
  if (hasPecks && !(peck > 0.0)) refuse(location, name, "the step Q is not above 0", "Correct Q.");
  if (const ProgramWord* const l = word('L')) whole(*l, 1, 1);
  const ProgramWord* const x = word('X');
  DrillCycle cycle;
  cycle.radius = x ? m_machine.radius(x->number) : m_machine.at().x();
  cycle.depth = depth;
  cycle.retract = retract;
  cycle.end = modal.returnsToStart ? std::max(m_machine.at().y(), retract) : retract;
  cycle.peck = hasPecks ? peck : 0.0;
  cycle.isDeep = tenths == 830;
  cycle.feedsOut = tenths == 850 || tenths == 890;
  cycle.dwell = dwell;
  cycle.run(m_machine, location);
}

}  // namespace handwheel
