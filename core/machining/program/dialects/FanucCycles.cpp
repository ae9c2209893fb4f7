// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/dialects/FanucRun.h"

#include "base/NumberText.h"
#include "machining/program/ProgramArc.h"
#include "machining/program/cycles/ThreadCycle.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kMostContour = 100'000;
constexpr int kMostPecks = 1'000'000;
constexpr double kDeepestLevel = 50.0, kLeastDepth = 0.01;  // mm, limits of a depth of cut that can be meant
constexpr double kMostRelief = 200.0;                       // mm, limit of the first distance of G73

double sign(double x) {
  return x < 0.0 ? -1.0 : 1.0;
}

// Goes from one coordinate to another in steps of this length, the last one shorter. f: called with each coordinate.
void inSteps(double from, double to, double step, const auto& f) {
  if (from == to) return;
  const double count = step > 0.0 ? std::ceil(std::abs(to - from) / step - 1e-9) : 1.0;
  for (double i = 1.0; i < count; ++i) f(from + sign(to - from) * i * step);  // added up, tiny steps go nowhere
  f(to);
}

// Returns the length and the height of a contour, its approach included.
PlanePoint extentOf(const std::vector<ContourSegment>& contour) {
  PlanePoint least = contour.front().from, most = least;
  for (const ContourSegment& segment : contour) {
    least = {std::min(least.real(), segment.to.real()), std::min(least.imag(), segment.to.imag())};
    most = {std::max(most.real(), segment.to.real()), std::max(most.imag(), segment.to.imag())};
  }
  return most - least;
}

}  // namespace

// Returns the moves from line N p to line N q.
FanucRun::Contour FanucRun::contourOf(const ProgramWord& g) {
  if (m_contour) refuse(g.location, g.text(), "a contour cannot contain a cycle", "Put the cycle outside of it.");
  Contour contour;
  const auto lineOf = [&](char letter, const char* meaning) {
    const double n = needed(letter, g, meaning);
    const std::uint32_t line =
        n >= 0.0 && n <= 1e8 ? m_outline.numbered(static_cast<int>(std::lround(n)), g.location.line - 1) : kNone;
    if (line == kNone)
      refuse(g.location, letter + roundedText(n), "there is no line N" + roundedText(n), "Correct it.");
    return line;
  };
  contour.begin = lineOf('P', "the line where the contour begins");
  contour.end = lineOf('Q', "the line where the contour ends");
  if (contour.end < contour.begin) refuse(g.location, "Q", "the contour ends before it begins", "Exchange P and Q.");
  if (contour.begin <= g.location.line - 1 && g.location.line - 1 <= contour.end)
    refuse(g.location, g.text(), "the cycle is inside its own contour", "Put it before the contour.");
  const int motion = m_machine.modal.motion;
  m_contour = &contour.segments;
  m_contourEnd = planePoint(m_machine.at()) / m_machine.unit();
  m_contourCuts = 0;
  m_corners.clear();
  m_namesBoth.reset();
  runLines(contour.begin, contour.end + 1);
  m_contour = nullptr;
  m_machine.modal.motion = motion;
  contour.namesBoth = m_namesBoth.value_or(false);
  contour.segments.resize(m_contourCuts);  // rapid moves at its end lead away from it
  finishCorners(contour.segments);
  if (contour.segments.size() < 2)
    refuse(g.location, g.text(), "the contour has no cuts", "Write its moves between the lines P and Q.");
  return contour;
}

void FanucRun::collect(const ProgramBlock& block) {
  sortCodes(block);
  for (const ProgramWord& w : block.words) {
    const int n = static_cast<int>(std::lround(w.number));
    const bool isAmong = w.letter != 'M' && (w.letter != 'G' || n <= 3 || (n >= 40 && n <= 42) || n == 18);
    if (!isAmong && m_cornerWord) refuseLonely(*m_cornerWord);
    if (!isAmong)
      refuse(w.location, w.text(), "the contour of a cycle has no such code", "Put it before or after the contour.");
  }
  if (code(Motion)) m_machine.modal.motion = 10 * codeOf(Motion);
  word('F'), word('S'), word('T');  // those are for finishing
  const int motion = m_machine.modal.motion / 10;
  const double unit = m_machine.unit(), half = m_machine.radius(1.0) / unit;
  PlanePoint to = m_contourEnd;
  if (const ProgramWord* const x = word('X')) to.imag(half * x->number);
  if (const ProgramWord* const u = word('U')) to.imag(to.imag() + half * u->number);
  if (const ProgramWord* const z = word('Z')) to.real(z->number);
  if (const ProgramWord* const w = word('W')) to.real(to.real() + w->number);
  if (hasAxis() && !m_namesBoth) m_namesBoth = (has('X') || has('U')) && (has('Z') || has('W'));
  if (to != m_contourEnd) {
    if (motion > 3) refuse(block.location, "contour", "it has moves other than G0 to G3", "Write only these.");
    if (m_contour->size() >= kMostContour) refuse(block.location, "contour", "it has too many lines", "Divide it.");
    ContourSegment segment;
    segment.from = m_contourEnd;
    segment.to = to;
    if (motion >= 2) {
      segment.turn = motion == 3 ? 1 : -1;
      segment.centre = arcCentre(unit * segment.from, unit * to, segment.turn, false, block.location) / unit;
    }
    const std::optional<Corner> corner = motion > 0 ? cornerOf(motion) : std::nullopt;
    if (corner) m_corners.push_back({m_contour->size(), *corner, *corner->word});
    m_contour->push_back(segment);
    m_contourEnd = to;
    if (motion > 0) m_contourCuts = m_contour->size();
  }
  refuseUnread();
}

// Skips the contour that follows the cycle.
void FanucRun::goBehind(const Contour& contour) {
  for (std::uint32_t i = m_next; i < contour.begin; ++i)
    if (ProgramScanner(m_outline.line(i), i + 1).peek() != '\0') return;
  if (contour.begin >= m_next) m_next = contour.end + 1;
}

// G70: the moves of the contour unchanged, then back.
void FanucRun::finish(const ProgramWord& g) {
  const ProfilePoint start = m_machine.at();
  const ProgramVariables variables = m_variables;
  const Control control = m_control;
  const std::size_t notes = m_path.notes.size();
  const Contour contour = contourOf(g);
  m_variables = variables;  // the lines are run once more
  m_control = control;
  m_path.notes.resize(notes);
  runLines(contour.begin, contour.end + 1);
  if (m_machine.isCompensated()) m_machine.endCompensation();
  m_machine.rapid(start, g.location);
  goBehind(contour);
}

// Notes a value that the first line of a cycle has not set, once. A control has a parameter for it. values: what is not
// set and what it is, as "the retract (R), so it is 0.5 mm".
void FanucRun::tellUnset(bool& isKnown, const ProgramWord& g, const std::string& values) {
  if (std::exchange(isKnown, true)) return;
  note(g.location,
       "No " + g.text() + " in a line before sets " + values + ". A control takes its parameter: write it.");
}

// G71 and G72: two lines, or one with the depth D.
void FanucRun::rough(int number, const ProgramWord& g) {
  const double unit = m_machine.unit();
  const bool isFacing = number == 72;
  const ProgramWord *const u = word('U'), *const w = word('W'), *const r = word('R'), *const d = word('D');
  if (!has('P') && !has('Q')) {
    const ProgramWord* const depth = isFacing ? w : u;
    if (depth) m_cycle.depth = unit * std::abs(depth->number);
    if (r) m_cycle.retract = unit * std::abs(r->number);
    m_cycle.isDepthKnown |= depth != nullptr;
    m_cycle.isRetractKnown |= r != nullptr;
    if (depth) require(m_cycle.depth <= kDeepestLevel, *depth, "no tool cuts as deep as this");
    if (r) require(m_cycle.retract <= kDeepestLevel, *r, "the retract is longer than any cut is deep");
    return;
  }
  if (d) m_cycle.depth = std::abs(increment(*d));
  m_cycle.isDepthKnown |= d != nullptr;
  if (d) require(m_cycle.depth <= kDeepestLevel, *d, "no tool cuts as deep as this");
  if (d && !d->hasPoint && m_cycle.depth < kLeastDepth && m_cycle.depth > 0.0)
    refuse(d->location, d->text(), "without a decimal point it is in 0.001 mm or 0.0001 inch, less than a chip",
           "Write a decimal point.");
  if (!(m_cycle.depth > 0.0))
    refuse(g.location, g.text(), "the depth of cut is 0", "Write it as U in a line before (D).");
  tellUnset(m_cycle.isDepthKnown, g, std::string("the depth of cut (") + (isFacing ? "W" : "U") + "), so it is 1 mm");
  tellUnset(m_cycle.isRetractKnown, g, "the retract (R), so it is 0.5 mm");
  Contour contour = contourOf(g);
  const PlanePoint allowance(w ? w->number : 0.0, u ? m_machine.radius(u->number) / unit : 0.0);
  const PlanePoint extent = extentOf(contour.segments);
  if (u) require(std::abs(allowance.imag()) <= extent.imag(), *u, "the allowance is larger than all that is cut");
  if (w) require(std::abs(allowance.real()) <= extent.real(), *w, "the allowance is longer than the contour");
  for (std::size_t i = 0; i < contour.segments.size(); ++i) {
    ContourSegment& segment = contour.segments[i];
    const PlanePoint from = segment.from;
    segment.move(allowance);
    if (i == 0) segment.from = from;
  }
  ContourCycle::Roughing how;
  how.start = planePoint(m_machine.at()) / unit;
  how.isFacing = isFacing;
  how.depth = m_cycle.depth / unit;
  how.retract = m_cycle.retract / unit;
  how.mode = {.cutsStart = false, .followsWall = contour.namesBoth};
  how.isMonotonic = !contour.namesBoth;
  const ProfilePoint start = m_machine.at();
  ContourCycle(contour.segments, g.location, m_cycleBudget).rough(how, cycleOutput(g.location, unit));
  m_machine.rapid(isFacing ? ProfilePoint(m_machine.at().x(), start.y()) : ProfilePoint(start.x(), m_machine.at().y()),
                  g.location);
  m_machine.rapid(start, g.location);
  goBehind(contour);
}

// G73: the contour repeatedly, each time nearer.
void FanucRun::repeatPattern(const ProgramWord& g) {
  const double unit = m_machine.unit();
  const ProgramWord *const u = word('U'), *const w = word('W'), *const r = word('R');
  if (!has('P') && !has('Q')) {
    m_cycle.relief = {u ? unit * u->number : 0.0, w ? unit * w->number : 0.0};
    if (u) require(std::abs(m_cycle.relief.x()) <= kMostRelief, *u, "no bar has as much to cut as this");
    if (w) require(std::abs(m_cycle.relief.y()) <= kMostRelief, *w, "no bar has as much to cut as this");
    if (r) m_cycle.passes = whole(*r, 1, 1000);
    m_cycle.isPatternKnown |= u || w || r;
    return;
  }
  tellUnset(m_cycle.isPatternKnown, g, "the relief (U, W) and the number of passes (R), so the contour is cut once");
  const Contour contour = contourOf(g);
  const ProfilePoint start = m_machine.at();
  const ProfilePoint allowance(u ? m_machine.radius(u->number) : 0.0, w ? unit * w->number : 0.0);
  const int passes = m_cycle.passes;
  for (int pass = 0; pass < passes; ++pass) {
    const double left = passes > 1 ? 1.0 - static_cast<double>(pass) / (passes - 1) : 0.0;
    const ProfilePoint by = allowance + left * m_cycle.relief;
    const auto moved = [&](const PlanePoint& p) { return ProfilePoint(profilePoint(unit * p) + by); };
    m_machine.rapid(start + by, g.location);
    m_machine.rapid(moved(contour.segments.front().to), g.location);
    for (std::size_t i = 1; i < contour.segments.size(); ++i) {
      const ContourSegment& s = contour.segments[i];
      s.turn == 0 ? m_machine.feed(moved(s.to), g.location)
                  : m_machine.arc(s.turn, moved(s.to), moved(s.centre), g.location);
    }
    m_machine.rapid({(start + by).x(), m_machine.at().y()}, g.location);
  }
  m_machine.rapid(start, g.location);
  goBehind(contour);
}

// G74 along Z and G75 along X: in steps, and side by side.
void FanucRun::peck(int number, const ProgramWord& g) {
  const ProgramWord *const r = word('R'), *const p = word('P'), *const q = word('Q'), *const i = word('I'),
                           *const k = word('K'), *const d = word('D');
  if (!hasAxis()) {
    if (r) m_cycle.peckRetract = m_machine.unit() * std::abs(r->number);
    if (r) require(m_cycle.peckRetract <= kDeepestLevel, *r, "the retract is longer than any step");
    m_cycle.isPeckKnown |= r != nullptr;
    return;
  }
  tellUnset(m_cycle.isPeckKnown, g, "the retract (R), so it is 0.5 mm");
  const bool isAlongZ = number == 74;
  const ProfilePoint start = m_machine.at(), to = target();
  const int in = isAlongZ ? 1 : 0;  // the axis of the steps
  double stepX = p ? std::abs(increment(*p)) : 0.0, stepZ = q ? std::abs(increment(*q)) : 0.0;
  if (i) stepX = m_machine.unit() * std::abs(i->number);
  if (k) stepZ = m_machine.unit() * std::abs(k->number);
  const double step = isAlongZ ? stepZ : stepX, aside = isAlongZ ? stepX : stepZ;
  if (d && d->number != 0.0) refuse(d->location, d->text(), "there is no relief at the bottom", "Remove it.");
  if (r && r->number != 0.0) refuse(r->location, r->text(), "there is no relief at the bottom", "Remove it.");
  const auto stepsOf = [&](int axis, double size) {
    return size > 0.0 ? std::abs(to[axis] - start[axis]) / size : 1.0;
  };
  if (!(stepsOf(in, step) * (1.0 + stepsOf(1 - in, aside)) <= kMostPecks))
    refuse(g.location, g.text(), "the cycle has more than 1000000 steps", "Use larger steps.");
  const auto plunge = [&](double side) {
    const auto at = [&](double depth) { return isAlongZ ? ProfilePoint(side, depth) : ProfilePoint(depth, side); };
    m_machine.rapid(at(start[in]), g.location);
    inSteps(start[in], to[in], step, [&](double depth) {
      m_machine.feed(at(depth), g.location);
      if (depth != to[in]) m_machine.rapid(at(depth - sign(to[in] - start[in]) * m_cycle.peckRetract), g.location);
    });
    m_machine.rapid(at(start[in]), g.location);
  };
  plunge(start[1 - in]);
  if (aside > 0.0) inSteps(start[1 - in], to[1 - in], aside, plunge);
  m_machine.rapid(start, g.location);
}

// G76: two lines as on a Fanuc, or one with K and D as on a Haas.
void FanucRun::threadCycle(const ProgramWord& g) {
  const double unit = m_machine.unit();
  const ProgramWord *const p = word('P'), *const q = word('Q'), *const r = word('R'), *const k = word('K'),
                           *const d = word('D'), *const a = word('A'), *const i = word('I');
  if (!hasAxis()) {
    if (p) {  // two digits each: passes of the last depth, chamfer, angle
      const int digits = whole(*p, 0, 999'999);
      m_cycle.threadPasses = std::max(1, digits / 10'000);
      m_cycle.threadChamfer = digits / 100 % 100;
      m_cycle.threadAngle = digits % 100;
    }
    if (q) m_cycle.threadLeast = std::abs(increment(*q));
    if (r) m_cycle.threadLast = std::abs(increment(*r));
    m_cycle.isThreadKnown = true;
    return;
  }
  const bool isHaas = k != nullptr;
  if (!isHaas)
    tellUnset(m_cycle.isThreadKnown, g,
              "the last passes, chamfer and angle (P) and the last depths (Q, R), so it ends "
              "with one pass, without a chamfer, at 60°");
  const ProfilePoint start = m_machine.at(), to = target();
  ThreadCycle cycle;
  cycle.start = start;
  cycle.endZ = to.y();
  cycle.pitch = lead(g);
  cycle.depth = isHaas ? unit * std::abs(k->number) : p ? std::abs(increment(*p)) : 0.0;
  cycle.firstDepth = isHaas ? (d ? std::abs(increment(*d)) : 0.0) : q ? std::abs(increment(*q)) : 0.0;
  cycle.degression = 2.0;
  cycle.angle = 0.5 * (isHaas ? (a ? a->number : 0.0) : m_cycle.threadAngle);
  cycle.leastStep = isHaas ? 0.0 : m_cycle.threadLeast;
  cycle.lastStep = isHaas ? 0.0 : m_cycle.threadLast;
  cycle.springPasses = isHaas ? 0 : m_cycle.threadPasses - 1;
  const int tenths = isHaas ? (m_chamfersThreads.value_or(false) ? 10 : 0) : m_cycle.threadChamfer;
  cycle.taper = m_chamfersThreads.value_or(true) ? 0.1 * tenths * cycle.pitch : 0.0;
  cycle.hasExitTaper = cycle.taper > 0.0;
  const double taper = isHaas ? (i ? unit * i->number : 0.0) : (r ? unit * r->number : 0.0);
  const double length = to.y() - start.y();
  cycle.isInside = to.x() > start.x();
  const double peak = to.x() + taper + (cycle.isInside ? -cycle.depth : cycle.depth);
  cycle.peak = cycle.isInside ? peak - start.x() : start.x() - peak;
  cycle.slope = length != 0.0 ? -taper / length : 0.0;
  cycle.along = alongPath({-taper, length});
  const auto check = [&](bool isRight, const char* what) {
    if (!isRight) refuse(g.location, g.text(), what, "Correct the words of the cycle.");
  };
  check(cycle.pitch > 0.0, "the lead F is not above 0");
  check(length != 0.0, "the thread has no length: Z is where the tool is");
  check(cycle.depth > 0.0, isHaas ? "the height K is 0" : "the height P is missing or 0");
  check(cycle.firstDepth > 0.0, isHaas ? "the first depth D is missing or 0" : "the first depth Q is missing or 0");
  check(cycle.firstDepth <= cycle.depth, isHaas
                                             ? "the first depth D is deeper than the thread, which has the height K"
                                             : "the first depth Q is deeper than the thread, which has the height P");
  check(cycle.leastStep <= cycle.depth, "the least depth Q of the line before is deeper than the thread");
  check(cycle.lastStep < cycle.depth, "the finishing allowance R of the line before is as deep as the thread");
  check(cycle.peak > 0.0, "the tool does not begin beside the thread");
  check(std::abs(cycle.angle) < 80.0, "the angle of the thread is not below 160 degrees");
  cycle.run(m_machine, g.location);
  m_machine.rapid(start, g.location);
}

}  // namespace handwheel
