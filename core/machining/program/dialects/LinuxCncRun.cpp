// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/dialects/LinuxCncRun.h"

#include <cmath>

namespace handwheel {

namespace {

using Modal = ProgramMachine::Modal;
using FeedMode = ProgramMachine::FeedMode;

constexpr LinuxCncRun::Code kCodes[] = {
    {0, LinuxCncRun::Motion},        {10, LinuxCncRun::Motion},       {20, LinuxCncRun::Motion},
    {30, LinuxCncRun::Motion},       {330, LinuxCncRun::Motion},      {700, LinuxCncRun::Motion},
    {710, LinuxCncRun::Motion},      {711, LinuxCncRun::Motion},      {712, LinuxCncRun::Motion},
    {720, LinuxCncRun::Motion},      {721, LinuxCncRun::Motion},      {722, LinuxCncRun::Motion},
    {730, LinuxCncRun::Motion},      {760, LinuxCncRun::Motion},      {800, LinuxCncRun::Motion},
    {810, LinuxCncRun::Motion},      {820, LinuxCncRun::Motion},      {830, LinuxCncRun::Motion},
    {850, LinuxCncRun::Motion},      {890, LinuxCncRun::Motion},      {40, LinuxCncRun::NonModal},
    {100, LinuxCncRun::NonModal},    {280, LinuxCncRun::NonModal},    {281, LinuxCncRun::NonModal},
    {300, LinuxCncRun::NonModal},    {301, LinuxCncRun::NonModal},    {520, LinuxCncRun::NonModal},
    {920, LinuxCncRun::NonModal},    {921, LinuxCncRun::NonModal},    {922, LinuxCncRun::NonModal},
    {923, LinuxCncRun::NonModal},    {530, LinuxCncRun::InMachine},   {170, LinuxCncRun::Plane},
    {180, LinuxCncRun::Plane},       {900, LinuxCncRun::Distance},    {910, LinuxCncRun::Distance},
    {901, LinuxCncRun::ArcDistance}, {911, LinuxCncRun::ArcDistance}, {930, LinuxCncRun::Feed},
    {940, LinuxCncRun::Feed},        {950, LinuxCncRun::Feed},        {200, LinuxCncRun::Units},
    {210, LinuxCncRun::Units},       {400, LinuxCncRun::Nose},        {410, LinuxCncRun::Nose},
    {420, LinuxCncRun::Nose},        {411, LinuxCncRun::Nose},        {421, LinuxCncRun::Nose},
    {430, LinuxCncRun::ToolLength},  {431, LinuxCncRun::ToolLength},  {490, LinuxCncRun::ToolLength},
    {980, LinuxCncRun::Return},      {990, LinuxCncRun::Return},      {540, LinuxCncRun::System},
    {550, LinuxCncRun::System},      {560, LinuxCncRun::System},      {570, LinuxCncRun::System},
    {580, LinuxCncRun::System},      {590, LinuxCncRun::System},      {591, LinuxCncRun::System},
    {592, LinuxCncRun::System},      {593, LinuxCncRun::System},      {610, LinuxCncRun::Path},
    {611, LinuxCncRun::Path},        {640, LinuxCncRun::Path},        {960, LinuxCncRun::Spindle},
    {970, LinuxCncRun::Spindle},     {70, LinuxCncRun::Lathe},        {80, LinuxCncRun::Lathe}};

// Returns the remedy for a code that this lathe does not have.
const char* remedyForCode(int code) {
  switch (code / 10) {
    case 5:
      return "Write splines as arcs or short lines.";
    case 19:
    case 17:
      return "A lathe works in the plane of X and Z: write G18.";
    case 31:
    case 38:
      return "There is no probe: write the measured number.";
    case 32:
    case 50:
      return "This is a word of Fanuc: choose that dialect, or write G33 for a thread.";
    case 68:
    case 69:
      return "The coordinates of a lathe do not turn.";
    case 74:
    case 84:
      return "Tapping is not simulated: cut the thread with G33 or G76.";
    default:
      return "Remove it; docs/programs.md lists the words that are understood.";
  }
}

}  // namespace

int LinuxCncRun::codeOf(int group) const {
  return code(group) ? static_cast<int>(std::lround(10.0 * code(group)->number)) : -1;
}

void LinuxCncRun::sortCodes(const ProgramBlock& block) {
  m_codes.fill(nullptr);
  for (const ProgramWord& word : block.words) {
    if (word.letter != 'G') continue;
    const double tenth = 10.0 * word.number;
    const int number = std::abs(tenth) < 1e5 ? static_cast<int>(std::lround(tenth)) : -1;
    const Code* found = nullptr;
    for (const Code& known : kCodes)
      if (known.tenths == number && std::abs(tenth - number) < 1e-6) found = &known;
    if (!found) refuse(word.location, word.text(), "this code is not supported on a lathe", remedyForCode(number));
    const ProgramWord*& slot = m_codes[found->group];
    if (slot)
      refuse(word.location, word.text(), "it contradicts " + slot->text() + " in the same line", "Remove one of them.");
    slot = &word;
  }
}

void LinuxCncRun::execute(const ProgramBlock& block) {
  sortCodes(block);
  runModes();  // the feed mode precedes F and S, which are in the units in effect before this line
  setFeedAndSpeed(block);
  runToolAndSpindle(block);
  runModes2();
  if (code(NonModal)) runNonModal(codeOf(NonModal), *code(NonModal));
  runMotion(block);
  runStops(block);
  refuseUnread();
}

void LinuxCncRun::runModes() {
  Modal& modal = m_machine.modal;
  const int feed = codeOf(Feed);
  const FeedMode mode = feed == 930   ? FeedMode::InverseTime
                        : feed == 950 ? FeedMode::PerRevolution
                                      : FeedMode::PerMinute;
  if (feed >= 0 && mode != modal.feedMode) {
    modal.feedMode = mode;
    modal.feed = 0.0;
  }
  if (codeOf(Spindle) == 960) {
    modal.isSurfaceSpeed = true;
    const double most = number('D', 0.0);
    if (has('D') && !(most > 0.0))
      refuse(word('D')->location, word('D')->text(), "the greatest speed of the spindle is not above 0",
             "Write D in r/min.");
    modal.mostSpindle = most;
    needed('S', *code(Spindle), "the surface speed");
  } else if (codeOf(Spindle) == 970) {
    modal.isSurfaceSpeed = false;
    modal.mostSpindle = 0.0;
  }
}

void LinuxCncRun::setFeedAndSpeed(const ProgramBlock&) {
  Modal& modal = m_machine.modal;
  if (const ProgramWord* const f = word('F')) {
    if (f->number < 0.0) refuse(f->location, f->text(), "a feed rate is not negative", "Correct it.");
    modal.feed = modal.feedMode == FeedMode::InverseTime ? f->number : f->number * m_machine.unit();
  } else if (modal.feedMode == FeedMode::InverseTime) {
    modal.feed = 0.0;  // each move has its own feed
  }
  if (const ProgramWord* const s = word('S')) {
    if (s->number < 0.0)
      refuse(s->location, s->text(), "a spindle speed is not negative", "Write M4 to turn it backwards.");
    setSpindle(s->number);
  }
}

void LinuxCncRun::runToolAndSpindle(const ProgramBlock& block) {
  Modal& modal = m_machine.modal;
  constexpr int kLargestTool = 65535;
  if (const ProgramWord* const t = word('T')) modal.selectedTool = whole(*t, 0, kLargestTool);
  for (const ProgramWord& m : block.words) {
    if (m.letter != 'M') continue;
    const int code = whole(m, 0, 999);
    switch (code) {
      case 6:
      case 61:
        if (m_machine.isCompensated())
          refuse(m.location, m.text(), "the tool cannot be changed with nose compensation", "Write G40 before it.");
        if (code == 6) modal.isStoppedByChange = modal.spin != 0 || modal.isStoppedByChange;
        if (code == 6) modal.spin = 0;
        m_machine.changeTool(code == 61 ? whole({'Q', needed('Q', m, "the tool"), true, m.location}, 0, kLargestTool)
                                        : modal.selectedTool);
        break;
      case 0:
      case 1:
      case 2:
      case 30:
      case 60:
      case 98:
      case 99:  // at the end of the block
      case 48:
      case 49:  // overrides of the operator
        break;
      case 70:
      case 73:
        if (m_frames.empty()) m_frames.emplace_back().returnTo = m_outline.size();
        m_frames.back().saved = {modal, m_machine.system()};
        m_frames.back().restores = code == 73;
        break;
      case 71:
        if (!m_frames.empty()) m_frames.back().saved.reset();
        break;
      case 72:
        if (m_frames.empty() || !m_frames.back().saved)
          refuse(m.location, m.text(), "no state was saved", "Write M70 before it.");
        restoreModes(*m_frames.back().saved);
        break;
      default:
        if (!runCommonM(code, m))
          refuse(m.location, m.text(), "this code is not supported on a lathe",
                 "Remove it; docs/programs.md lists the words that are understood.");
    }
  }
}

void LinuxCncRun::runModes2() {
  Modal& modal = m_machine.modal;
  if (codeOf(Plane) >= 0) {
    if (m_machine.isCompensated())
      refuse(code(Plane)->location, code(Plane)->text(), "the plane cannot change with nose compensation",
             "Write G40 before it.");
    modal.isDrillPlane = codeOf(Plane) == 170;
  }
  if (codeOf(Units) >= 0) modal.isInch = codeOf(Units) == 200;
  if (codeOf(Lathe) >= 0) modal.isDiameter = codeOf(Lathe) == 70;
  if (code(Nose)) compensation(codeOf(Nose), *code(Nose));
  if (code(ToolLength)) toolLength(codeOf(ToolLength), *code(ToolLength));
  if (const int system = codeOf(System); system >= 0) {
    if (m_machine.isCompensated())
      refuse(code(System)->location, code(System)->text(), "the coordinates cannot change with nose compensation",
             "Write G40 before it.");
    m_machine.selectSystem(system <= 590 ? (system - 540) / 10 : 5 + system - 590);
  }
  if (codeOf(Path) == 640) word('P'), word('Q');  // the path is followed exactly
  if (codeOf(Distance) >= 0) modal.isIncremental = codeOf(Distance) == 910;
  if (codeOf(ArcDistance) >= 0) modal.isArcAbsolute = codeOf(ArcDistance) == 901;
  if (codeOf(Return) >= 0) modal.returnsToStart = codeOf(Return) == 980;
}

void LinuxCncRun::compensation(int tenths, const ProgramWord& g) {
  if (tenths == 400) {
    m_machine.endCompensation();
    return;
  }
  if (m_machine.modal.isDrillPlane)
    refuse(g.location, g.text(), "nose compensation works in the plane of X and Z", "Write G18 before it.");
  const int side = tenths / 10 == 41 ? 1 : -1;
  double radius = 0.0;
  int orientation = 0;
  if (tenths % 10 == 1) {
    radius = 0.5 * m_machine.unit() * needed('D', g, "the diameter of the nose");
    if (!(radius >= 0.0)) refuse(g.location, g.text(), "the diameter of the nose is negative", "Use the other side.");
    if (const ProgramWord* const l = word('L')) orientation = whole(*l, 0, 9);
  } else {
    const ProgramWord* const d = word('D');
    const ProgramTool& tool = m_setup.tool(d ? whole(*d, 0, 65535) : m_machine.modal.tool);
    radius = tool.noseRadius;
    orientation = tool.orientation;
  }
  m_machine.compensate(side, radius, tipDirection(ProgramDialect::LinuxCnc, orientation), g.location);
}

void LinuxCncRun::toolLength(int tenths, const ProgramWord& g) {
  if (m_machine.isCompensated())
    refuse(g.location, g.text(), "the tool offset cannot change with nose compensation", "Write G40 before it.");
  if (tenths == 490) {
    m_machine.setToolOffset({0, 0}, -1);
  } else if (tenths == 430) {
    const ProgramWord* const h = word('H');
    const int number = h ? whole(*h, 0, 65535) : m_machine.modal.tool;
    m_machine.setToolOffset(m_setup.tool(number).offset, number);
  } else {
    ProfilePoint offset = m_machine.toolOffset();
    if (const ProgramWord* const x = word('X')) offset.x() = m_machine.radius(x->number);
    if (const ProgramWord* const z = word('Z')) offset.y() = m_machine.unit() * z->number;
    m_machine.setToolOffset(offset, -1);
  }
}

void LinuxCncRun::runStops(const ProgramBlock& block) {
  for (const ProgramWord& m : block.words) {
    const int number = m.letter == 'M' ? static_cast<int>(std::lround(m.number)) : -1;
    if (number == 60) continue;
    if (number == 0 || number == 1 || number == 2 || number == 30 || number == 98 || number == 99)
      runCommonM(number, m);
  }
}

}  // namespace handwheel
