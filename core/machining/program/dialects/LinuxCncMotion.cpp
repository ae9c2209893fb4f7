// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/dialects/LinuxCncRun.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr const char* kAxes = "XZ";

}  // namespace

ProfilePoint LinuxCncRun::target() {
  const ProgramMachine::Modal& modal = m_machine.modal;
  ProfilePoint to = m_machine.at();
  const ProgramWord *const x = word('X'), *const z = word('Z');
  if (x) to.x() = m_machine.radius(x->number) + (modal.isIncremental ? to.x() : 0.0);
  if (z) to.y() = m_machine.unit() * z->number + (modal.isIncremental ? to.y() : 0.0);
  return to;
}

void LinuxCncRun::runNonModal(int tenths, const ProgramWord& g) {
  const auto refuseCompensated = [&] {
    if (m_machine.isCompensated())
      refuse(g.location, g.text(), "it is not possible with nose compensation", "Write G40 before it.");
  };
  switch (tenths) {
    case 40:
      m_machine.dwell(needed('P', g, "the time in seconds"), g.location);
      return;
    case 100:
      refuseCompensated();
      setCoordinates(g);
      return;
    case 281:
    case 301:
      m_machine.home[tenths == 281 ? 0 : 1] = m_machine.toMachine(m_machine.at());
      return;
    case 280:
    case 300:
      refuseCompensated();
      home(tenths, g);
      return;
    default:
      refuseCompensated();
      setOffsets(tenths, g);
      return;
  }
}

void LinuxCncRun::home(int tenths, const ProgramWord& g) {
  const bool hasX = has('X'), hasZ = has('Z');
  m_machine.rapid(target(), g.location);
  ProfilePoint to = m_machine.fromMachine(m_machine.home[tenths == 280 ? 0 : 1]);
  if (hasX && !hasZ) to.y() = m_machine.at().y();
  if (hasZ && !hasX) to.x() = m_machine.at().x();
  m_machine.rapid(to, g.location);
}

// G52, G92 and its variants. G92.3 restores the last shift of G92, unless G92.1 came after it.
void LinuxCncRun::setOffsets(int tenths, const ProgramWord& g) {
  if (tenths == 921) m_savedShift = {0, 0};
  if (tenths != 920 && tenths != 520) {
    m_machine.setShift(tenths == 923 ? m_savedShift : ProfilePoint(0, 0));
    return;
  }
  if (!has('X') && !has('Z')) refuse(g.location, g.text(), "an axis is missing", "Write X or Z.");
  ProfilePoint shift = m_machine.shift();
  const ProgramWord *const x = word('X'), *const z = word('Z');
  const bool isLocal = tenths == 520;
  if (x)
    shift.x() = isLocal ? m_machine.radius(x->number) : shift.x() + m_machine.at().x() - m_machine.radius(x->number);
  if (z)
    shift.y() = isLocal ? m_machine.unit() * z->number : shift.y() + m_machine.at().y() - m_machine.unit() * z->number;
  m_machine.setShift(shift);
  m_savedShift = shift;
}

// G10 L2 and L20.
void LinuxCncRun::setCoordinates(const ProgramWord& g) {
  const double l = needed('L', g, "2 or 20");
  if (l != 2.0 && l != 20.0)
    refuse(g.location, g.text(), "only L2 and L20 set something here", "Set the tools in the table of tools.");
  const int p = whole({'P', needed('P', g, "the number of the coordinate system, 1 for G54"), true, g.location}, 0,
                      ProgramMachine::kSystems);
  const int system = p == 0 ? m_machine.system() : p - 1;
  ProfilePoint offset = m_machine.systemOffset(system);
  const ProgramWord *const x = word('X'), *const z = word('Z');
  if (const ProgramWord* const y = word('Y'); y && y->number != 0.0)
    refuse(y->location, y->text(), "a lathe has no Y axis", "Remove it.");
  const ProfilePoint here = m_machine.toMachine(m_machine.at()) - m_machine.shift() - m_machine.toolOffset();
  if (x) offset.x() = l == 2.0 ? m_machine.radius(x->number) : here.x() - m_machine.radius(x->number);
  if (z) offset.y() = l == 2.0 ? m_machine.unit() * z->number : here.y() - m_machine.unit() * z->number;
  m_machine.setSystem(system, offset);
}

void LinuxCncRun::runMotion(const ProgramBlock& block) {
  const int given = codeOf(Motion);
  const int nonModal = codeOf(NonModal);
  const bool isTaken = nonModal == 100 || nonModal == 280 || nonModal == 300 || nonModal == 520 || nonModal == 920 ||
                       codeOf(ToolLength) == 431;
  bool hasAxis = false;
  for (const char* axis = kAxes; *axis; ++axis) hasAxis = hasAxis || has(*axis);
  if (isTaken && hasAxis) {
    if (given >= 0 && given != 800)
      refuse(code(Motion)->location, code(Motion)->text(), "two codes in this line use X and Z", "Divide the line.");
    return;
  }
  if (given == 800) {
    m_machine.modal.motion = -1;
    return;
  }
  const int motion = given >= 0 ? given : m_machine.modal.motion;
  if (code(InMachine)) {
    if (motion != 0 && motion != 10)
      refuse(code(InMachine)->location, "G53", "it needs G0 or G1", "Write G53 G0 X... Z...");
    m_machine.modal.motion = motion;
    straightInMachine(motion, *code(InMachine));
    return;
  }
  if (given < 0 && !hasAxis) return;
  const SourceLocation location = given >= 0 ? code(Motion)->location : block.location;
  if (motion < 0)
    refuse(location, block.words.front().text(), "there is no motion for X and Z", "Write G0 or G1 before them.");
  const bool isContour = motion >= 700 && motion < 730;
  if (!isContour && motion != 760) m_machine.modal.motion = motion;
  if (isContour)
    contourCycle(motion, *code(Motion));
  else if (motion == 760)
    threadCycle(*code(Motion));
  else if (motion == 730 || (motion > 800 && motion < 900))
    drill(motion, location);
  else
    move(motion, location);
}

void LinuxCncRun::straightInMachine(int motion, const ProgramWord& g) {
  if (m_machine.isCompensated())
    refuse(g.location, g.text(), "it is not possible with nose compensation", "Write G40 before it.");
  if (m_machine.modal.isIncremental)
    refuse(g.location, g.text(), "it is not possible with G91", "Write G90 before it.");
  const ProgramWord *const x = word('X'), *const z = word('Z');
  const ProfilePoint in(x ? m_machine.radius(x->number) : 0.0, z ? m_machine.unit() * z->number : 0.0);
  ProfilePoint to = m_machine.fromMachine(in);
  if (!x) to.x() = m_machine.at().x();
  if (!z) to.y() = m_machine.at().y();
  motion == 0 ? m_machine.rapid(to, g.location) : m_machine.feed(to, g.location);
}

void LinuxCncRun::move(int motion, const SourceLocation& location) {
  const ProfilePoint to = target();
  switch (motion) {
    case 0:
      m_machine.rapid(to, location);
      return;
    case 10:
      m_machine.feed(to, location);
      return;
    case 330: {
      const ProgramWord* const k = word('K');
      if (!k || !(std::abs(k->number) > 0.0))
        refuse(location, "G33", "the pitch is missing", "Write K, the way for one revolution.");
      m_machine.thread(to, std::abs(k->number) * m_machine.unit(), location);
      return;
    }
    default: {
      const int turn = motion == 30 ? 1 : -1;
      if (m_machine.modal.isDrillPlane)
        refuse(location, turn > 0 ? "G3" : "G2", "an arc on a lathe lies in the plane of X and Z",
               "Write G18 before it.");
      if (const ProgramWord* const p = word('P'); p && p->number != 1.0)
        refuse(p->location, p->text(), "an arc on a lathe has one turn", "Remove P.");
      const PlanePoint centre =
          arcCentre(planePoint(m_machine.at()), planePoint(to), turn, m_machine.modal.isArcAbsolute, location);
      m_machine.arc(turn, to, profilePoint(centre), location);
      return;
    }
  }
}

}  // namespace handwheel
