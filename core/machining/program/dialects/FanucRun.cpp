// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/dialects/FanucRun.h"

#include "base/NumberText.h"

#include <cmath>

namespace handwheel {

namespace {

using FeedModes = ProgramMachine::FeedMode;

constexpr FanucRun::Code kFanucCodes[] = {
    {0, FanucRun::Motion},    {1, FanucRun::Motion},    {2, FanucRun::Motion},    {3, FanucRun::Motion},
    {32, FanucRun::Motion},   {90, FanucRun::Motion},   {92, FanucRun::Motion},   {94, FanucRun::Motion},
    {4, FanucRun::Once},      {28, FanucRun::Once},     {30, FanucRun::Once},     {50, FanucRun::Once},
    {52, FanucRun::Once},     {53, FanucRun::Once},     {65, FanucRun::Once},     {70, FanucRun::Once},
    {71, FanucRun::Once},     {72, FanucRun::Once},     {73, FanucRun::Once},     {74, FanucRun::Once},
    {75, FanucRun::Once},     {76, FanucRun::Once},     {96, FanucRun::Spindle},  {97, FanucRun::Spindle},
    {98, FanucRun::FeedMode}, {99, FanucRun::FeedMode}, {20, FanucRun::Units},    {21, FanucRun::Units},
    {40, FanucRun::Nose},     {41, FanucRun::Nose},     {42, FanucRun::Nose},     {80, FanucRun::Drilling},
    {81, FanucRun::Drilling}, {82, FanucRun::Drilling}, {83, FanucRun::Drilling}, {54, FanucRun::System},
    {55, FanucRun::System},   {56, FanucRun::System},   {57, FanucRun::System},   {58, FanucRun::System},
    {59, FanucRun::System},   {18, FanucRun::Other},    {61, FanucRun::Other},    {64, FanucRun::Other}};

const char* remedyForFanucCode(int number) {
  switch (number) {
    case 17:
    case 19:
      return "A lathe works in the plane of X and Z: write G18.";
    case 33:
      return "This is a thread of LinuxCNC: write G32 with the lead F, or choose that dialect.";
    case 91:
    case 95:
      return "In system A write U and W for increments, G98 and G99 for the feed.";
    case 34:
      return "A thread of changing lead is not simulated.";
    case 66:
    case 67:
      return "Write G65 in each line instead.";
    case 84:
      return "Tapping is not simulated: cut the thread with G32, G92 or G76.";
    default:
      return "Remove it; docs/programs.md lists the words that are understood.";
  }
}

constexpr int kConveyorOn = 31, kConveyorOff = 33;  // codes of Haas
constexpr int kChamfers = 23, kNoChamfers = 24;     // codes of most machines for the end of a thread

}  // namespace

FanucRun::FanucRun(std::string_view text, const ProgramSetup& setup, Progress progress)
    : ProgramRun(text, setup, progress) {
  m_machine.modal.isDiameter = true;
  m_machine.modal.feedMode = FeedModes::PerRevolution;
  m_control.begin = setup.begin != 0 ? setup.begin : std::time(nullptr);
}

int FanucRun::codeOf(int group) const {
  return code(group) ? static_cast<int>(std::lround(code(group)->number)) : -1;
}

double FanucRun::increment(const ProgramWord& w) const {
  if (w.hasPoint) return m_machine.unit() * w.number;
  return w.number * (m_machine.modal.isInch ? 1e-4 * ProgramMachine::kInch : 1e-3);
}

// Turns lengths without a decimal point from least increments into the units of the program. P, Q and D are always such
// numbers, and are read by increment().
void FanucRun::scaleIncrements(ProgramBlock& block) const {
  bool isInch = m_machine.modal.isInch, isDwell = false, isPattern = false;
  for (const ProgramWord& w : block.words) {
    if (w.letter != 'G') continue;
    if (w.number == 20.0 || w.number == 21.0) isInch = w.number == 20.0;
    isDwell = isDwell || w.number == 4.0;
    isPattern = isPattern || w.number == 73.0;
  }
  for (ProgramWord& w : block.words) {
    const bool isLength = std::string_view("XZUWIJKRCcr").find(w.letter) != std::string_view::npos;
    if (w.hasPoint || !isLength || (isPattern && w.letter == 'R')) continue;
    w.number *= isInch && !isDwell ? 1e-4 : 1e-3;
    w.hasPoint = true;
  }
}

// Refuses a length of a cycle that cannot be meant.
void FanucRun::require(bool isRight, const ProgramWord& w, const char* what) const {
  if (isRight) return;
  const bool isPlain = !w.hasPoint && !m_setup.hasIncrements && w.letter != 'P' && w.letter != 'Q' && w.letter != 'D';
  refuse(w.location, w.text(), what,
         isPlain ? "Without a decimal point it is in mm or inch here: write one, or choose that such numbers are "
                   "increments."
                 : "Correct it.");
}

void FanucRun::sortCodes(const ProgramBlock& block) {
  m_codes.fill(nullptr);
  for (const ProgramWord& w : block.words) {
    if (w.letter != 'G') continue;
    const int number = std::abs(w.number) < 1e5 ? static_cast<int>(std::lround(w.number)) : -1;
    const Code* found = nullptr;
    for (const Code& known : kFanucCodes)
      if (known.number == number && std::abs(w.number - number) < 1e-6) found = &known;
    if (!found) refuse(w.location, w.text(), "this code is not supported on a lathe", remedyForFanucCode(number));
    const ProgramWord*& slot = m_codes[found->group];
    if (slot && found->group != Other)
      refuse(w.location, w.text(), "it contradicts " + slot->text() + " in the same line", "Remove one of them.");
    slot = &w;
  }
}

ProfilePoint FanucRun::target() {
  ProfilePoint to = m_corner.value_or(m_machine.at());
  const ProgramWord *const x = word('X'), *const u = word('U'), *const z = word('Z'), *const w = word('W');
  if (x && u) refuse(u->location, u->text(), "it contradicts " + x->text(), "Write X or U, not both.");
  if (z && w) refuse(w->location, w->text(), "it contradicts " + z->text(), "Write Z or W, not both.");
  if (x) to.x() = m_machine.radius(x->number);
  if (u) to.x() += m_machine.radius(u->number);
  if (z) to.y() = m_machine.unit() * z->number;
  if (w) to.y() += m_machine.unit() * w->number;
  return to;
}

void FanucRun::execute(const ProgramBlock& block) {
  sortCodes(block);
  runModes();
  setTool();
  runM(block, false);
  const int once = codeOf(Once);
  if (once >= 0) runOnce(block, once, *code(Once));
  const bool leavesAxes = once == 4 || (once >= 28 && once != 65);
  if (!leavesAxes && once != 65) runMotion(block);
  runM(block, true);
  refuseUnread();
}

void FanucRun::runModes() {
  ProgramMachine::Modal& modal = m_machine.modal;
  if (codeOf(Units) >= 0) modal.isInch = codeOf(Units) == 20;
  if (codeOf(FeedMode) >= 0) {
    const FeedModes mode = codeOf(FeedMode) == 98 ? FeedModes::PerMinute : FeedModes::PerRevolution;
    if (mode != modal.feedMode) modal.feed = 0.0;
    modal.feedMode = mode;
  }
  setSpindleMode();
  const int once = codeOf(Once);
  if (const ProgramWord* const f = word('F'); f && once != 65) {
    if (!(f->number >= 0.0)) refuse(f->location, f->text(), "a feed is not negative", "Correct it.");
    const bool isPerTurn =
        modal.feedMode == FeedModes::PerRevolution || once == 76 || codeOf(Motion) == 32 || codeOf(Motion) == 92;
    if (m_setup.hasIncrements && isPerTurn && !f->hasPoint && f->number != 0.0)
      refuse(f->location, f->text(), "a control counts this feed per revolution by its parameters",
             "Write it with a decimal point.");
    modal.feed = m_machine.unit() * f->number;  // also the lead of a thread
  }
  if (const ProgramWord* const s = word('S'); s && once != 50 && once != 65) {
    if (!(s->number >= 0.0))
      refuse(s->location, s->text(), "a spindle speed is not negative", "Write M4 to turn back.");
    setSpindle(s->number);
    m_control.speed = s->number;
    if (modal.isSurfaceSpeed) m_surfaceSpeed = modal.spindle;
  }
  if (codeOf(System) >= 0) {
    if (m_machine.isCompensated())
      refuse(code(System)->location, code(System)->text(), "the coordinates cannot change with nose compensation",
             "Write G40 before it.");
    m_machine.selectSystem(codeOf(System) - 54);
  }
  if (code(Nose)) {
    compensation(codeOf(Nose), *code(Nose));
    m_control.nose = codeOf(Nose);
  }
  if (const int path = codeOf(Other); path == 61 || path == 64) m_control.path = path;
}

// G97 keeps the present speed of the spindle, G96 the last surface speed, unless S is given.
void FanucRun::setSpindleMode() {
  ProgramMachine::Modal& modal = m_machine.modal;
  const ProgramWord* const g = code(Spindle);
  if (!g) return;
  const bool isSurface = codeOf(Spindle) == 96;
  if (isSurface == modal.isSurfaceSpeed) return;
  if (isSurface) {
    if (!has('S') && !m_surfaceSpeed)
      refuse(g->location, g->text(), "the surface speed is missing", "Write S in m/min.");
    modal.spindle = m_surfaceSpeed.value_or(0.0);
  } else {
    ToolMove now;
    now.isSurfaceSpeed = true;
    now.spindle = modal.spindle;
    now.mostSpindle = modal.mostSpindle;
    modal.spindle = spindleAt(now, m_machine.at().x());
  }
  modal.isSurfaceSpeed = isSurface;
}

// T0101: the tool and its offset.
void FanucRun::setTool() {
  const ProgramWord* const t = codeOf(Once) == 65 ? nullptr : word('T');
  if (!t) return;
  const int number = whole(*t, 0, 9999);
  if (number > 0 && number < 100)
    refuse(t->location, t->text(), "the tool and its offset have two digits each", "Write T0101.");
  if (m_machine.isCompensated())
    refuse(t->location, t->text(), "the tool cannot be changed with nose compensation", "Write G40 before it.");
  m_control.tool = number;
  if (number >= 100) m_machine.changeTool(number / 100);
  m_machine.modal.selectedTool = number % 100;
  const int offset = number % 100;
  m_machine.setToolOffset(offset == 0 ? ProfilePoint(0, 0) : m_setup.tool(offset).offset, offset == 0 ? -1 : offset);
}

void FanucRun::compensation(int number, const ProgramWord& g) {
  if (number == 40) {
    m_machine.endCompensation();
    return;
  }
  const ProgramTool& tool = m_setup.tool(m_machine.modal.selectedTool);
  if (m_machine.isCompensated()) m_machine.endCompensation();  // to the other side
  m_machine.compensate(number == 41 ? 1 : -1, tool.noseRadius, tipDirection(ProgramDialect::Fanuc, tool.orientation),
                       g.location);
}

void FanucRun::runM(const ProgramBlock& block, bool isAfterMotion) {
  if (codeOf(Once) == 65) return;
  for (const ProgramWord& m : block.words) {
    if (m.letter != 'M') continue;
    const int number = whole(m, 0, 999);
    const bool isBefore =
        number == 3 || number == 4 || number == 7 || number == 8 || number == kChamfers || number == kNoChamfers;
    if (isBefore == isAfterMotion) continue;
    m_control.lastM = number;
    if (number == kConveyorOn || number == kConveyorOff) {
      note(m.location, "M" + std::to_string(number) + " (chip conveyor) has no effect here.");
    } else if (number == kChamfers || number == kNoChamfers) {
      m_chamfersThreads = number == kChamfers;
    } else if (number == 98) {
      // The last four digits are the program, those before them the number of runs.
      const int p = whole({'P', needed('P', m, "the number of the subprogram"), true, m.location}, 1, 99'999'999);
      const int repeats = has('L') ? whole(*word('L'), 1, 9999) : std::max(1, p / 10'000);
      const std::uint32_t begin = m_outline.subprogram(std::to_string(p > 9999 ? p % 10'000 : p));
      if (begin == kNone)
        refuse(m.location, "P" + std::to_string(p), "there is no subprogram with this number",
               "Put it into the same file.");
      call(begin + 1, {}, repeats, false, m.location);
    } else if (number == 99 && has('P') && !m_frames.empty()) {
      const int n = whole(*word('P'), 1, 99'999'999);
      const bool isLast = m_frames.back().repeats == 0;
      const std::uint32_t caller = m_frames.back().returnTo - 1;
      returnFromCall();
      if (!isLast) continue;
      m_next = m_outline.numbered(n, caller);
      if (m_next == kNone)
        refuse(m.location, "P" + std::to_string(n), "there is no line with this number", "Correct P.");
    } else if (!runCommonM(number, m)) {
      refuse(m.location, m.text(), "this code is not supported on a lathe",
             "Remove it; docs/programs.md lists the words that are understood.");
    }
  }
}

}  // namespace handwheel
