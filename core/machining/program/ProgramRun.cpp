// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramRun.h"

#include "base/NumberText.h"
#include "machining/program/ProgramArc.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/dialects/FanucRun.h"
#include "machining/program/dialects/LinuxCncRun.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kMostNotes = 100;
constexpr int kLocals = 33;  // Fanuc; LinuxCNC has 30

std::uint32_t bitOf(char letter) {
  if (letter == 'c') return 1u << 26;  // ,C
  if (letter == 'r') return 1u << 27;  // ,R
  return letter >= 'A' && letter <= 'Z' ? 1u << (letter - 'A') : 0u;
}

}  // namespace

Result<ToolPath> runProgram(std::string_view text, const ProgramSetup& setup, Progress progress) {
  try {
    if (setup.dialect == ProgramDialect::Fanuc) return FanucRun(text, setup, progress).run();
    return LinuxCncRun(text, setup, progress).run();
  } catch (const ProgramRefusal& refusal) {
    return refusal.error;
  }
}

ProgramRun::ProgramRun(std::string_view text, const ProgramSetup& setup, Progress progress)
    : m_setup(setup),
      m_progress(progress),
      m_outline(text, setup.dialect),
      m_variables(setup.dialect == ProgramDialect::Fanuc ? kLocals : 30, setup.dialect == ProgramDialect::Fanuc),
      m_machine(setup, m_path),
      m_cycleBudget(progress) {
  m_variables.setSystem({[this](int n, const SourceLocation& location) { return systemVariable(n, location); },
                         [this](const std::string& name) { return systemVariable(name); },
                         [this](const ProgramAssignment& assignment) { return setSystemVariable(assignment); }});
}

ToolPath ProgramRun::run() {
  runTo(m_outline.size());
  if (!m_isDone && !m_frames.empty() && m_setup.dialect == ProgramDialect::Fanuc)
    refuseMissingReturn({m_outline.size(), 1});
  if (m_machine.isCompensated()) m_machine.endCompensation();
  return std::move(m_path);
}

void ProgramRun::refuseMissingReturn(const SourceLocation& location) {
  refuse(location, "M99", "the subprogram that was called has no end before this line", "End it with M99.");
}

void ProgramRun::runTo(std::uint32_t end) {
  while (!m_isDone && m_next < end) step();
}

void ProgramRun::runInside(std::uint32_t begin, const SourceLocation& location) {
  const ProgramBlock* const block = m_block;
  const std::uint32_t read = m_read, after = m_next;
  call(begin, {}, 1, true, location);
  const std::size_t depth = m_frames.size();
  while (!m_isDone && m_next < m_outline.size() && m_frames.size() >= depth) step();
  m_next = after;
  m_block = block;
  m_read = read;
}

void ProgramRun::runLines(std::uint32_t begin, std::uint32_t end) {
  const ProgramBlock* const block = m_block;
  const std::uint32_t read = m_read, after = m_next;
  m_next = begin;
  while (!m_isDone && m_next >= begin && m_next < end) step();
  m_next = after;
  m_block = block;
  m_read = read;
}

void ProgramRun::runAhead(int most, const std::function<bool()>& isEnough) {
  const ProgramBlock* const block = m_block;
  const std::uint32_t read = m_read, after = m_next;
  for (int i = 0; i < most && !m_isDone && m_next < m_outline.size() && !isEnough(); ++i) step();
  m_isDone = false;
  m_next = after;
  m_block = block;
  m_read = read;
}

void ProgramRun::step() {
  constexpr std::uint64_t kLook = 256;  // blocks between two checks of the cancel flag
  if (++m_path.blocks > m_setup.mostBlocks)
    throw ProgramRefusal{
        {ProgramError::Endless, {std::to_string(m_setup.mostBlocks)}, InputPosition::line(m_next + 1), {}}};
  if (m_path.blocks % kLook == 0) {
    if (m_progress.cancelled()) throw ProgramRefusal{{ErrorCode::Cancelled, {}, {}, {}}};
    m_progress.set(static_cast<double>(m_next) / m_outline.size());
  }
  const std::uint32_t i = m_next++;
  ProgramScanner scanner(m_outline.line(i), i + 1);
  if (skipsRest(scanner, m_setup)) return;
  obeyComment(i, scanner);
  if (scanner.peek() != '\0') readLine(i, scanner);
}

void ProgramRun::call(std::uint32_t begin, const std::vector<ProgramValue>& arguments, int repeats,
                      bool hasOwnVariables, const SourceLocation& location) {
  if (m_frames.size() >= kDeepest)
    refuse(location, "call", "subprograms call each other too deeply", "Look for a subprogram that calls itself.");
  Frame frame;
  frame.returnTo = m_next;
  frame.begin = begin;
  frame.repeats = repeats - 1;
  frame.hasOwnVariables = hasOwnVariables;
  m_frames.push_back(std::move(frame));
  if (hasOwnVariables) m_variables.enter(arguments);
  m_next = begin;
}

void ProgramRun::returnFromCall() {
  Frame& frame = m_frames.back();
  if (frame.repeats > 0) {
    --frame.repeats;
    m_next = frame.begin;
    return;
  }
  if (frame.restores && frame.saved) restoreModes(*frame.saved);
  if (frame.hasOwnVariables) m_variables.leave();
  m_next = frame.returnTo;
  m_frames.pop_back();
}

void ProgramRun::restoreModes(const SavedModes& saved) {
  const ProgramMachine::Modal now = m_machine.modal;
  m_machine.modal = saved.modal;
  m_machine.modal.motion = now.motion;
  m_machine.modal.tool = now.tool;
  m_machine.modal.selectedTool = now.selectedTool;
  if (saved.system != m_machine.system()) m_machine.selectSystem(saved.system);
}

void ProgramRun::begin(const ProgramBlock& block) {
  m_block = &block;
  m_read = bitOf('G') | bitOf('M');
}

const ProgramWord* ProgramRun::word(char letter) {
  m_read |= bitOf(letter);
  return m_block->find(letter);
}

double ProgramRun::number(char letter, double otherwise) {
  const ProgramWord* const found = word(letter);
  return found ? found->number : otherwise;
}

double ProgramRun::needed(char letter, const ProgramWord& code, const char* meaning) {
  const ProgramWord* const found = word(letter);
  if (!found)
    refuse(code.location, code.text(), std::string("the word ") + letter + " is missing",
           std::string("Write ") + letter + ", " + meaning + ".");
  return found->number;
}

int ProgramRun::whole(const ProgramWord& w, int least, int most) const {
  const double rounded = std::round(w.number);
  if (std::abs(w.number - rounded) > 1e-4 || rounded < least || rounded > most)
    refuse(w.location, w.text(), "this is a whole number from " + std::to_string(least) + " to " + std::to_string(most),
           "Correct it.");
  return static_cast<int>(rounded);
}

void ProgramRun::refuseUnread() const {
  for (const ProgramWord& w : m_block->words) {
    if (m_read & bitOf(w.letter)) continue;
    if (w.letter == 'Y' || w.letter == 'B' || w.letter == 'V')
      refuse(w.location, w.text(), "a lathe has no axis of this name",
             "Remove the word; programs for milling do not run here.");
    refuse(w.location, w.text(), "nothing in this line uses this word",
           "Remove it, or add the code that it belongs to.");
  }
}

PlanePoint ProgramRun::arcCentre(const PlanePoint& from, const PlanePoint& to, int turn, bool isAbsolute,
                                 const SourceLocation& location) {
  const double unit = m_machine.unit();
  const ProgramWord *const i = word('I'), *const k = word('K'), *const r = word('R');
  if (r && (i || k)) refuse(r->location, r->text(), "an arc has a radius R or a centre I and K", "Remove one of them.");
  if (r) return centreFromRadius(from, to, turn, unit * r->number, r->location);
  if (!i && !k) refuse(location, turn > 0 ? "G3" : "G2", "the arc has no centre", "Write I and K, or the radius R.");
  // I is a radius, even if X is a diameter.
  const PlanePoint given(k ? unit * k->number : 0.0, i ? unit * i->number : 0.0);
  const PlanePoint centre = isAbsolute ? given : from + given;
  checkCentre(from, to, centre, location);
  return centre;
}

void ProgramRun::setSpindle(double speed) {
  m_machine.modal.spindle = m_machine.modal.isSurfaceSpeed && m_machine.modal.isInch ? 0.3048 * speed : speed;
}

void ProgramRun::note(const SourceLocation& location, std::string text) {
  if (m_path.notes.size() < kMostNotes) m_path.notes.push_back({location.line, std::move(text)});
}

CycleOutput ProgramRun::cycleOutput(const SourceLocation& location, double unit) {
  ProgramMachine& machine = m_machine;
  return {[=, &machine](const PlanePoint& to) { machine.rapid(profilePoint(unit * to), location); },
          [=, &machine](const PlanePoint& to) { machine.feed(profilePoint(unit * to), location); },
          [=, &machine](int turn, const PlanePoint& centre, const PlanePoint& to) {
            constexpr double kSame = 1e-4;  // units of the program; shorter is no arc
            const PlanePoint gap = planePoint(machine.at()) - unit * to;
            if (std::abs(gap.real()) < kSame * unit && std::abs(gap.imag()) < kSame * unit) return;
            machine.arc(turn, profilePoint(unit * to), profilePoint(unit * centre), location);
          }};
}

// Runs the M codes that both dialects have. Returns false for others.
bool ProgramRun::runCommonM(int code, const ProgramWord& m) {
  ProgramMachine::Modal& modal = m_machine.modal;
  switch (code) {
    case 0:
    case 1:
      return true;  // a stop for the operator
    case 2:
    case 30:
      m_isDone = true;
      return true;
    case 3:
    case 4:
      modal.spin = code == 3 ? 1 : -1;
      modal.isStoppedByChange = false;
      return true;
    case 5:
      modal.spin = 0;
      modal.isStoppedByChange = false;
      return true;
    case 7:
      modal.hasMist = true;
      return true;
    case 8:
      modal.hasFlood = true;
      return true;
    case 9:
      modal.hasMist = modal.hasFlood = false;
      return true;
    case 98: {
      const double label = needed('P', m, "the number of the subprogram");
      const std::uint32_t begin = m_outline.subprogram(roundedText(label, 12));
      if (begin == kNone)
        refuse(m.location, "P" + roundedText(label, 12), "there is no subprogram with this number",
               "Put it into the same file.");
      const ProgramWord* const l = word('L');
      call(begin + 1, {}, l ? whole(*l, 1, 9999) : 1, false, m.location);
      return true;
    }
    case 99:
      if (m_frames.empty())
        m_isDone = true;  // a machine would start again here
      else
        returnFromCall();
      return true;
    default:
      return false;
  }
}

}  // namespace handwheel
