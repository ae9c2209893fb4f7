// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/GrindingContact.h"
#include "machining/lathe/LatheRunTry.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// mm along z that a tool springs aside while it is drawn back: 5 mm deep, an edge of 95° leans by 0.44.
constexpr double kSpring = 0.5;

// Returns the travel of a move away from the axis, or in a bore towards it; mm.
double travelBack(const LatheTool& tool, const ProfilePoint& displacement) {
  return tool.side == TurningSide::Outside ? displacement.x() : -displacement.x();
}

double largestRadius(const TurnedProfile& profile) {
  double largest = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i) largest = std::max(largest, profile.radius(i));
  return largest;
}

}  // namespace

double LatheStep::depthOfCut() const {
  const double distance = (to - from).norm();
  return distance > 0.0 ? cut.area / distance : 0.0;
}

double LatheStep::feed() const {
  return turns > 0.0 && !cut.isEmpty() ? (to - from).norm() / turns : 0.0;
}

LatheRun::LatheRun(LatheSetup setup, LatheTools tools, TurnedProfile profile, const LatheState& state,
                   std::shared_ptr<const LatheMaterial> material, std::shared_ptr<const PartThreads> threads)
    : m_machine(std::move(setup), state),
      m_tools(std::move(tools)),
      m_profile(std::move(profile)),
      m_threads(std::move(threads)),
      m_material(std::move(material)),
      m_beam(m_profile, m_machine.setup().chuck.grip) {
  m_gripped = grippedRadius(m_profile, m_machine.setup().chuck);
  m_within = largestRadius(m_profile);
  m_tip = m_machine.tip();
  m_chuck = chuckSolids(m_machine.setup().chuck, m_gripped);
  for (const auto& tool : m_tools) m_solids.push_back(toolSolids(*tool));
}

std::shared_ptr<const LatheTool> LatheRun::tool() const {
  return toolNamed(m_tools, m_machine.slot().tool);
}

std::shared_ptr<const LatheTool> LatheRun::drill() const {
  const LatheTailstock& tailstock = m_machine.setup().tailstock;
  return tailstock.fitting == LatheFitting::Drill ? toolNamed(m_tools, tailstock.drill) : nullptr;
}

std::size_t LatheRun::indexOf(const LatheTool* tool) const {
  const auto found = std::find_if(m_tools.begin(), m_tools.end(), [&](const auto& each) { return each.get() == tool; });
  return static_cast<std::size_t>(found - m_tools.begin());
}

// If post and quill move in one step, the quill is the one that drills.
LatheRun::Try LatheRun::attempt(const LatheState& before, double dt, double mostByHand) {
  const ProfilePoint tipBefore = m_machine.tip();
  const double quillBefore = m_machine.quillTip();
  Try tried;
  tried.motion = m_machine.advance(dt, mostByHand, m_load.torque);
  tried.isQuill = m_machine.setup().tailstock.isUsed() && m_machine.quillTip() != quillBefore;
  tried.isIndexed = m_machine.state().tool != before.tool;
  tried.tool = tried.isQuill ? drill() : tool();
  tried.from = tried.isQuill ? ProfilePoint(0.0, quillBefore) : tipBefore;
  tried.to = tried.isQuill ? ProfilePoint(0.0, m_machine.quillTip()) : m_machine.tip();
  tried.isPressed = tried.tool && tried.tool->isAbrasive() && tried.tool == m_lastTool && m_lastPosition != tried.to;
  tried.isRing = leavesThread(tried);
  if (!tried.tool || !tried.hasMoved()) return tried;
  tried.cut = previewCut(m_profile, *tried.tool, tried.from, tried.to);
  tried.pushed = tried.cut.depth;
  if (tried.tool->kind == LatheToolKind::Threading && !tried.isIndexed && !tried.isQuill) meetThreads(tried);
  const bool isAtRest = std::abs(m_machine.state().speed) < kAtRest;
  if (isAtRest && isDrawnOut(tried)) tried.takesNothing = true;
  if (tried.motion.isRapid && tried.pushed > kTouch && isDrawnStraight(tried)) tried.pushed = 0.0;
  return tried;
}

// Returns the depth of a tool in the work, mm.
double LatheRun::depthAt(const LatheTool& tool, const ProfilePoint& at) const {
  return previewCut(m_profile, tool, at, at).depth;
}

// Returns true if a turning tool is drawn straight away from the axis, or in a bore towards it, with no more of it in
// the work than before. Nothing pushes it into the work then, however fast it goes.
bool LatheRun::isDrawnStraight(const Try& tried) const {
  if (tried.isQuill || tried.isIndexed || tried.tool->isAbrasive()) return false;
  const ProfilePoint displacement = tried.to - tried.from;
  const double back = travelBack(*tried.tool, displacement);
  return back > 0.0 && std::abs(displacement.y()) <= back &&
         depthAt(*tried.tool, tried.to) <= std::max(kTouch, depthAt(*tried.tool, tried.from));
}

// Returns true if a turning tool is drawn straight out of the work, or by hand aside from a shoulder, with no more of
// it in the work than before except in the shoulder that it has left: the shoulder leans by the angle of the edge, and
// the tool springs along it. So a turner draws back a tool that has stopped in the work.
bool LatheRun::isDrawnOut(const Try& tried) const {
  if (isDrawnStraight(tried)) return true;
  if (tried.isQuill || tried.isIndexed || tried.motion.isRapid || tried.tool->isAbrasive()) return false;
  const ProfilePoint displacement = tried.to - tried.from;
  const double back = travelBack(*tried.tool, displacement);
  const bool isStraight = back > 0.0 && std::abs(displacement.y()) <= back;
  if (!(back >= 0.0)) return false;
  for (const double along : {kSpring, -kSpring}) {
    if (!isStraight && !(displacement.y() * along > 0.0)) continue;
    if (depthAt(*tried.tool, tried.to + ProfilePoint(0.0, along)) <= kTouch) return true;
  }
  return false;
}

// Returns true if a tool that has come as far as its edge leans behind the front of the jaws goes back from them,
// outward or away from the chuck. The contact is counted already.
bool LatheRun::isAwayFromChuck(const Try& tried, const std::vector<LatheSolid>& solids) const {
  if (tried.isQuill || tried.isIndexed || !tried.tool) return false;
  const ProfilePoint displacement = tried.to - tried.from, beside(0.0, kSpring);
  const bool isBack = displacement.y() >= 0.0 && travelBack(*tried.tool, displacement) >= 0.0 && !displacement.isZero();
  return isBack && !contactBetween(solids, tried.to + beside, m_chuck);
}

std::optional<LatheCollision> LatheRun::cutCrash(const Try& tried) const {
  if (!tried.tool || tried.takesNothing || !(tried.cut.depth > kTouch)) return std::nullopt;
  if (tried.tool->isAbrasive() && !tried.motion.isRapid && !tried.isIndexed) return std::nullopt;  // it yields
  const double speed = m_machine.state().speed;
  LatheCollision collision;
  collision.position = tried.to;
  collision.depth = tried.cut.depth;
  if (tried.isIndexed)
    collision.cause = CrashCause::Contact;
  else if (tried.motion.isRapid && tried.pushed > kTouch)
    collision.cause = CrashCause::Rapid;
  else if (std::abs(speed) < kAtRest)
    collision.cause = CrashCause::SpindleAtRest;
  else if (speed < 0.0)
    collision.cause = CrashCause::Reversed;
  else if (tried.cut.beyond > kTouch)
    collision.cause = CrashCause::TooDeep;
  else
    return std::nullopt;
  return collision;
}

std::optional<LatheCollision> LatheRun::crashOf(const Try& tried) const {
  if (auto crash = cutCrash(tried)) return crash;
  const auto drilling = drill();
  const auto tail = tailstockSolids(m_machine.setup().tailstock, m_machine.quillTip(), drilling.get());
  if (tried.isQuill) {
    if (auto crash = contactBetween(tail, {0.0, 0.0}, m_chuck)) return crash;
    if (drilling) {
      if (auto crash = contactWithWork(tail, {0.0, 0.0}, {0.0, 0.0}, m_profile, m_within)) return crash;
    }
  }
  const auto inPost = tool();
  if (!inPost) return std::nullopt;
  const std::vector<LatheSolid>& solids = m_solids[indexOf(inPost.get())];
  const ProfilePoint tip = m_machine.tip();
  if (auto crash = contactBetween(solids, tip, m_chuck); crash && !isAwayFromChuck(tried, solids)) return crash;
  if (auto crash = contactBetween(solids, tip, tail)) return crash;
  return contactWithWork(solids, tried.isQuill || tried.isIndexed ? tip : tried.from, tip, m_profile, m_within);
}

bool LatheRun::isClear() const {
  const auto drilling = drill();
  const ProfilePoint end(0.0, m_machine.quillTip());
  const auto tail = tailstockSolids(m_machine.setup().tailstock, end.y(), drilling.get());
  if (drilling && (previewCut(m_profile, *drilling, end, end).depth > kTouch ||
                   contactWithWork(tail, {0.0, 0.0}, {0.0, 0.0}, m_profile, m_within)))
    return false;
  const auto inPost = tool();
  if (!inPost) return true;
  const std::vector<LatheSolid>& solids = m_solids[indexOf(inPost.get())];
  const ProfilePoint tip = m_machine.tip();
  return !(previewCut(m_profile, *inPost, tip, tip).depth > kTouch) && !contactBetween(solids, tip, m_chuck) &&
         !contactBetween(solids, tip, tail) && !contactWithWork(solids, tip, tip, m_profile, m_within);
}

void LatheRun::crash(LatheStep& step, LatheCollision collision, const LatheState& before) {
  const double time = m_machine.state().time;
  LatheState stopped = before;
  stopped.time = time;
  stopped.turns = m_machine.state().turns;
  m_machine.restore(stopped);
  m_machine.stop();
  collision.time = time;
  if (step.tool) collision.tool = step.tool->id;
  step.to = step.from;
  step.isHeld = true;
  if (std::exchange(m_isBlocked, true)) return;  // the same crash continues
  step.isCrash = true;
  if (m_collisions.size() < kMostCollisions) m_collisions.push_back(std::move(collision));
}

// A tool that is pressed by hand, or grinds, yields if it would remove more than it can; the work yields to an edge
// that is pressed into it from outside.
void LatheRun::cut(LatheStep& step, const Try& tried) {
  const LatheTool& tool = *tried.tool;
  const bool goesOn = m_lastTool == tried.tool && !tried.isIndexed;
  step.from = goesOn ? m_lastPosition : tried.from;
  step.to = tried.to;
  m_pressed = heightPressed(tried);
  if (!tried.cut.isEmpty()) m_balanced.reset();
  if (tool.isAbrasive()) {
    const double pressed = pressedDepth(m_profile, tool, tried.from, tried.to);
    const double lift = std::max(0.0, pressed - tool.depthPerTurn * tried.motion.turns);
    step.to.x() += tool.side == TurningSide::Outside ? lift : -lift;
    if (!goesOn) step.from = step.to;                               // its slide may be in the work already
  } else if (tool.side == TurningSide::Outside && !tried.isRing) {  // a ring is turned until the work does not yield
    step.to.x() += yielding(tried);
  }
  step.thread = tried.thread;
  if (step.thread) {
    const ThreadsBeingCut::ToolPosition position{step.to, -2.0 * M_PI * m_machine.state().turns};
    const ThreadsBeingCut::Cut groove = m_threads.cut(m_profile, tool, *step.thread, step.from.y(), position);
    step.cut = groove.removed;
    step.edge = groove.edge;
  } else if (!tried.takesNothing) {
    step.cut = cutWithTool(m_profile, tool, step.from, step.to);
  }
  m_isInThread = step.thread.has_value();
  step.isRing = tried.isRing;
  m_lastTool = tried.tool;
  m_lastPosition = step.to;
  if (!step.thread) m_beam.change(m_profile, step.cut.changed);
}

// Limits the depth of a tool that is pressed on the work to the force of a hand, or of its slide: the cross slide and
// the compound slide stay. The carriage continues along the work, until it meets a shoulder higher than that depth
// again. A warning reports it. Drawing back is free. Returns true if anything was held.
bool LatheRun::holdPressed(Try& tried, const LatheState& before) {
  if (!tried.tool || !tried.tool->isAbrasive() || tried.isIndexed || tried.isQuill) return false;
  const LatheTool& tool = *tried.tool;
  const double limit = holdOf(tool).deepest(), pressed = pressedDepth(m_profile, tool, tried.to, tried.to);
  const double was = pressedDepth(m_profile, tool, tried.from, tried.from), highest = std::max(2.0 * limit, was);
  if (!(pressed > std::max(limit, was))) return false;
  constexpr std::array kInward{LatheAxis::Cross, LatheAxis::Compound};
  LatheState held = m_machine.state();
  const auto keep = [&](LatheAxis axis) {
    const auto i = static_cast<std::size_t>(axis);
    held.wheels[i] = before.wheels[i];
    held.slides[i] = before.slides[i];
    held.demands[i] = 0.0;
    held.rapids[i] = 0;
    if (held.feedAxis == axis) held.feed = 0.0;
  };
  const std::array<double, kLatheAxes> slides = held.slides;
  for (const LatheAxis axis : kInward) keep(axis);
  const bool isPushed = held.slides != slides;
  if (!isPushed && pressed <= highest) return false;
  m_machine.restore(held);
  if (pressedDepth(m_profile, tool, m_machine.tip(), m_machine.tip()) > highest) {
    keep(LatheAxis::Carriage);
    held.lead = 0.0;
    held.isNutClosed = false;
    m_machine.restore(held);
  }
  m_warnings.judge({{CutWarning::Rule::Pressing, pressed, limit}}, held.time, tool.id);
  tried.to = m_machine.tip();
  tried.cut = previewCut(m_profile, tool, tried.from, tried.to);
  return true;
}

LatheStep LatheRun::step(double dt, std::span<const LatheCommand> commands) {
  const LatheStep step = move(dt, commands);
  if (dt > 0.0 && std::isfinite(dt)) measure(step, dt);
  return step;
}

LatheStep LatheRun::move(double dt, std::span<const LatheCommand> commands) {
  const LatheState start = m_machine.state();
  for (const LatheCommand& command : commands) m_machine.apply(command);
  LatheStep step;
  if (!(dt > 0.0 && std::isfinite(dt))) return step;
  const LatheSetup& setup = m_machine.setup();
  const LatheState before = m_machine.state();
  Try tried = attempt(start, dt, setup.handSpeed * dt);
  // A hand feels material, and goes through it only as fast as it can push.
  const bool isTurning = std::abs(m_machine.state().speed) >= kAtRest;
  if (isTurning && tried.motion.isByHand && !tried.motion.isRapid && tried.pushed > kTouch) {
    m_machine.restore(before);
    tried = attempt(start, dt, setup.handFeed * tried.motion.turns);
  }
  step.tool = tried.tool;
  step.turns = tried.motion.turns;
  step.from = step.to = tried.from;
  step.time = m_machine.state().time;
  if (isStalled(before.speed)) {
    LatheCollision stall;
    stall.cause = CrashCause::Overload;
    stall.position = tried.from;
    crash(step, std::move(stall), before);
    return step;
  }
  if (!tried.hasMoved()) return step;
  if (auto collision = crashOf(tried)) {
    LatheState safe = before;
    safe.tool = start.tool;
    crash(step, std::move(*collision), safe);
    return step;
  }
  const auto centre = setup.tailstock.fitting == LatheFitting::Centre && tried.isQuill;
  const bool isOnCentre = centre && contactWithWork(tailstockSolids(setup.tailstock, m_machine.quillTip(), nullptr),
                                                    {0.0, 0.0}, {0.0, 0.0}, m_profile, m_within);
  const bool isTooDeep = setup.depthLimit > 0.0 && tried.cut.depth > setup.depthLimit && !tried.isIndexed;
  if (isOnCentre || isTooDeep) {  // held, without a crash
    LatheState held = before;
    held.time = m_machine.state().time;
    held.turns = m_machine.state().turns;
    held.speed = m_machine.state().speed;
    held.demands.fill(0.0);
    held.feed = 0.0;
    held.lead = 0.0;
    held.isNutClosed = false;
    m_machine.restore(held);
    step.isHeld = true;
    if (isOnCentre || !tried.tool->isAbrasive()) return step;
    tried.to = m_machine.tip();  // it is pressed no harder, and continues
    tried.cut = previewCut(m_profile, *tried.tool, tried.from, tried.to);
  }
  m_isBlocked = false;
  step.isHeld = holdPressed(tried, before) || step.isHeld;
  if (tried.tool) cut(step, tried);
  return step;
}

}  // namespace handwheel
