// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/dialects/FanucRun.h"

#include "base/NumberText.h"
#include "machining/program/cycles/DrillCycle.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

void FanucRun::runOnce(const ProgramBlock& block, int number, const ProgramWord& g) {
  if (m_machine.isCompensated() && number != 4 && number != 65)
    refuse(g.location, g.text(), "it is not possible with nose compensation", "Write G40 before it.");
  switch (number) {
    case 4: {
      const ProgramWord *const p = word('P'), *const x = word('X'), *const u = word('U');
      if (!p && !x && !u)
        refuse(g.location, g.text(), "the time is missing", "Write P in milliseconds or U in seconds.");
      m_machine.dwell(p ? (p->hasPoint ? p->number : 1e-3 * p->number) : (x ? x : u)->number, g.location);
      return;
    }
    case 28:
    case 30:
      home(number, g);
      return;
    case 50:
      setCoordinates(g);
      return;
    case 52: {
      ProfilePoint shift = m_machine.shift();
      if (const ProgramWord* const x = word('X')) shift.x() = m_machine.radius(x->number);
      if (const ProgramWord* const z = word('Z')) shift.y() = m_machine.unit() * z->number;
      m_machine.setShift(shift);
      return;
    }
    case 53:
      moveInMachine(g);
      return;
    case 65:
      callMacro(block, g);
      return;
    case 70:
      finish(g);
      return;
    case 71:
    case 72:
      rough(number, g);
      return;
    case 73:
      repeatPattern(g);
      return;
    case 74:
    case 75:
      peck(number, g);
      return;
    default:
      threadCycle(g);
      return;
  }
}

void FanucRun::home(int number, const ProgramWord& g) {
  const bool hasX = has('X') || has('U'), hasZ = has('Z') || has('W');
  if (number == 30)
    if (const ProgramWord* const p = word('P'); p && p->number != 2.0)
      refuse(p->location, p->text(), "there is only the second reference position here", "Write P2, or nothing.");
  m_machine.rapid(target(), g.location);
  ProfilePoint to = m_machine.fromMachine(m_machine.home[number == 28 ? 0 : 1]);
  if (hasX && !hasZ) to.y() = m_machine.at().y();
  if (hasZ && !hasX) to.x() = m_machine.at().x();
  m_machine.rapid(to, g.location);
}

// G50: the clamp of the spindle, or the coordinates of the tool's position.
void FanucRun::setCoordinates(const ProgramWord& g) {
  if (const ProgramWord* const s = word('S')) {
    if (!(s->number > 0.0)) refuse(s->location, s->text(), "the greatest speed is not above 0", "Write S in r/min.");
    m_machine.modal.mostSpindle = s->number;
  }
  if (!hasAxis()) {
    if (!has('S')) refuse(g.location, g.text(), "S, X or Z is missing", "Write G50 S2000 for the greatest speed.");
    return;
  }
  const ProfilePoint here = m_machine.at();
  m_machine.setShift(m_machine.shift() + here - target());
}

void FanucRun::moveInMachine(const ProgramWord& g) {
  const ProgramWord *const x = word('X'), *const z = word('Z');
  if (!x && !z) refuse(g.location, g.text(), "X or Z is missing", "Write G53 X0 or G53 Z0.");
  const int motion = codeOf(Motion) >= 0 ? codeOf(Motion) : m_machine.modal.motion / 10;
  if (motion != 0 && motion != 1) refuse(g.location, g.text(), "it needs G0 or G1", "Write G53 G0 X... Z...");
  m_machine.modal.motion = 10 * motion;
  ProfilePoint to =
      m_machine.fromMachine({x ? m_machine.radius(x->number) : 0.0, z ? m_machine.unit() * z->number : 0.0});
  if (!x) to.x() = m_machine.at().x();
  if (!z) to.y() = m_machine.at().y();
  motion == 0 ? m_machine.rapid(to, g.location) : m_machine.feed(to, g.location);
}

void FanucRun::runMotion(const ProgramBlock& block) {
  ProgramMachine::Modal& modal = m_machine.modal;
  if (code(Motion)) modal.motion = 10 * codeOf(Motion);
  if (code(Drilling)) modal.motion = codeOf(Drilling) == 80 ? 0 : 10 * codeOf(Drilling);
  if (!hasAxis()) return;
  const SourceLocation location = code(Motion) ? code(Motion)->location : block.location;
  const int motion = modal.motion / 10;
  if (modal.motion < 0)
    refuse(location, block.words.front().text(), "there is no motion for X and Z", "Write G0 or G1 before them.");
  switch (motion) {
    case 0:
      m_machine.rapid(target(), location);
      return;
    case 1:
    case 2:
    case 3:
      cut(motion, location);
      return;
    case 32: {
      const ProfilePoint from = m_machine.at(), to = target();
      const double measured = lead(code(Motion) ? *code(Motion) : block.words.front());
      m_machine.thread(to, measured * alongPath(to - from), location);
      return;
    }
    case 90:
    case 92:
    case 94:
      boxCycle(motion, location);
      return;
    default:
      drill(motion, location);
      return;
  }
}

// F is modal, and shared with feeds.
double FanucRun::lead(const ProgramWord& code) {
  const double mm = m_machine.modal.feed;
  if (!(mm > 0.0)) refuse(code.location, code.text(), "the lead is missing", "Write F, the way for one revolution.");
  return mm;
}

// The lead of a thread is measured along the axis with the larger travel.
double FanucRun::alongPath(const ProfilePoint& displacement) {
  const double longest = displacement.cwiseAbs().maxCoeff();
  return longest > 0.0 ? displacement.norm() / longest : 1.0;
}

// G90, G92, G94: in, along, out and back. Modal: the next X or Z makes the next pass.
void FanucRun::boxCycle(int number, const SourceLocation& location) {
  if (m_machine.isCompensated())
    refuse(location, "G" + std::to_string(number), "it is not possible with nose compensation", "Write G40 before it.");
  const ProfilePoint start = m_machine.at();
  const ProfilePoint given = target();
  if (code(Motion)) {
    m_boxTarget = given;
    m_boxTaper = 0.0;
  }
  if (has('X') || has('U')) m_boxTarget.x() = given.x();
  if (has('Z') || has('W')) m_boxTarget.y() = given.y();
  if (const ProgramWord* const r = word('R')) m_boxTaper = m_machine.unit() * r->number;
  const ProfilePoint to = m_boxTarget;
  if (number == 94) {
    m_machine.rapid({start.x(), to.y() + m_boxTaper}, location);
    m_machine.feed(to, location);
    m_machine.feed({to.x(), start.y()}, location);
    m_machine.rapid(start, location);
    return;
  }
  m_machine.rapid({to.x() + m_boxTaper, start.y()}, location);
  if (number == 90) {
    m_machine.feed(to, location);
    m_machine.feed({start.x(), to.y()}, location);
  } else {
    const double measured = lead(code(Motion) ? *code(Motion) : ProgramWord{'G', 92.0, true, location});
    threadPass(to, measured, start, location);
    m_machine.rapid({start.x(), to.y()}, location);
  }
  m_machine.rapid(start, location);
}

// The pass of G92 to its end. After M23 it leaves the work at 45 degrees over the length of the chamfer.
void FanucRun::threadPass(const ProfilePoint& to, double measured, const ProfilePoint& start,
                          const SourceLocation& location) {
  const ProfilePoint from = m_machine.at();
  const double pitch = measured * alongPath(to - from), length = std::abs(to.y() - from.y());
  const double wanted = 0.1 * (m_cycle.threadChamfer > 0 ? m_cycle.threadChamfer : 10) * measured;
  const double chamfer = m_chamfersThreads.value_or(false) ? std::min(wanted, length) : 0.0;
  if (!(chamfer > 0.0)) {
    m_machine.thread(to, pitch, location);
    return;
  }
  const ProfilePoint begin = to + (from - to) * (chamfer / length);
  m_machine.thread(begin, pitch, location);
  const double room = start.x() - begin.x();
  const ProfilePoint end(begin.x() + std::copysign(std::min(chamfer, std::abs(room)), room), to.y());
  m_machine.thread(end, measured * alongPath(end - begin), location);
}

// G81, G82, G83 on the face. R is the signed distance from the tool to the begin of the feed; W counts from there. All
// words are modal until G80.
void FanucRun::drill(int number, const SourceLocation& location) {
  const std::string name = "G" + std::to_string(number);
  const ProfilePoint start = m_machine.at();
  const ProfilePoint to = target();
  if (code(Drilling)) m_drilling = {};
  if (const ProgramWord* const r = word('R')) m_drilling.retract = m_machine.unit() * r->number;
  if (const ProgramWord* const q = word('Q')) m_drilling.peck = increment(*q);
  if (const ProgramWord* const p = word('P')) m_drilling.dwell = p->hasPoint ? p->number : 1e-3 * p->number;
  DrillCycle cycle;
  cycle.retract = start.y() + m_drilling.retract;
  if (has('Z')) m_drilling.depth = to.y();
  if (const ProgramWord* const w = word('W')) m_drilling.depth = cycle.retract + m_machine.unit() * w->number;
  if (!m_drilling.depth) refuse(location, name, "the depth is missing", "Write Z.");
  cycle.radius = to.x();
  cycle.depth = *m_drilling.depth;
  cycle.end = start.y();
  cycle.peck = number == 83 ? m_drilling.peck : 0.0;
  cycle.isDeep = true;
  cycle.dwell = m_drilling.dwell;
  if (number == 83 && !(cycle.peck > 0.0)) refuse(location, name, "the step Q is missing", "Write Q.");
  if (cycle.depth > cycle.retract)
    refuse(location, name, "Z is above R, which is the way from where the tool is", "Correct Z or R.");
  cycle.run(m_machine, location);
}

}  // namespace handwheel
