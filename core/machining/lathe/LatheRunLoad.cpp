// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What a cut does to the spindle and to the part: LatheRun.
#include "machining/force/CuttingFeel.h"
#include "machining/lathe/GrindingContact.h"
#include "machining/lathe/LatheRunTry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

bool isOfBending(CutWarning::Rule rule) {
  using Rule = CutWarning::Rule;
  return rule == Rule::Slenderness || rule == Rule::Deflection || rule == Rule::Chatter;
}

// Returns the force with which a moving tool presses the work towards the axis, N. A tool that is drawn out of its cut
// does not pull the work after it. passive: the direction of the radial force on the tool.
double thrustOf(const CutForces& forces, const ProfilePoint& passive, const ProfilePoint& displacement) {
  const double back = displacement.isZero() ? 0.0 : -displacement.x() / displacement.norm();
  return std::max(0.0, passive.x() * forces.radial + back * forces.feed);
}

}  // namespace

bool LatheRun::isStalled(double speedBefore) const {
  const LatheState& now = m_machine.state();
  return now.direction != 0 && std::abs(speedBefore) >= kAtRest && std::abs(now.speed) < kAtRest &&
         m_load.torque > spindleTorque(m_machine.setup().spindle, now.speed);
}

// The law gives the force of the cut over the last samples.
void LatheRun::measure(const LatheStep& step, double dt) {
  const ProfilePoint tip = m_machine.tip(), displacement = tip - std::exchange(m_tip, tip);
  CutMeter::Move move{(step.to - step.from).norm(), step.cut.area, step.cut.volume, step.turns, dt, step.edge};
  if (step.isRing) move.area = move.volume = 0.0;  // the end of an existing groove
  m_meter.add(move, m_profile.spacing());
  const double speed = m_machine.state().speed;
  LatheLoad load;
  load.isCutting = m_meter.isCutting();
  load.cut = m_meter.cut(speed);
  load.radius = m_meter.radius();
  load.passive = m_load.passive;
  if (!displacement.isZero() && m_lastTool) load.passive = m_lastTool->passiveDirection(displacement);
  press(load, displacement / dt);
  m_thrust = 0.0;
  const CuttingForceModel* const law = m_material && load.isCutting ? m_material->lawOf(cuttingTool()) : nullptr;
  if (law) {
    const LatheSpindle& spindle = m_machine.setup().spindle;
    load.forces = worn(law->at(m_meter.chip(speed)), m_machine.setup().wear);
    load.torque = cuttingTorque(load.forces, 2.0 * load.radius);
    load.power = motorPower(cuttingPower(load.forces, load.cut), driveOf(spindle).efficiency);
    m_thrust = m_balanced.value_or(thrustOf(load.forces, load.passive, displacement));
    load.isOutsideModel = !law->covers(load.cut);
    load.isOverloaded = load.torque > spindleTorque(spindle, speed);
  }
  if (!law) m_chatter = 0.0;
  load.chatter = m_chatter;
  m_load = load;
  m_sinceJudged += dt;
  if (!law || m_sinceJudged < kJudged) return;
  m_sinceJudged = 0.0;
  judge();
}

// A grinding tool is pressed against the work, and rubs on it while the work turns.
void LatheRun::press(LatheLoad& load, const ProfilePoint& velocity) {
  const ProfilePoint tip = m_machine.tip();
  const auto inPost = tool();
  if (!inPost || !inPost->isAbrasive()) return;
  const GrindingContact contact = grindingContact(m_profile, *inPost, tip);
  const double force = grindingForce(contact, holdOf(*inPost), velocity);
  const bool isTurning = std::abs(m_machine.state().speed) >= kAtRest;
  load.press = force * contact.normal;
  load.forces = {isTurning ? kGrindingFriction * force : 0.0, std::abs(load.press.y()), std::abs(load.press.x())};
  load.torque = cuttingTorque(load.forces, 2.0 * std::abs(tip.x()));
  const LatheSpindle& spindle = m_machine.setup().spindle;
  const double speed = m_machine.state().speed;
  const CutConditions rubbed{0.0, 0.0, surfaceSpeed(std::abs(speed), 2.0 * std::abs(tip.x()))};
  load.power = motorPower(cuttingPower(load.forces, rubbed), driveOf(spindle).efficiency);
  load.isOverloaded = load.torque > spindleTorque(spindle, speed);
}

// Returns the z at which a cut presses on the work, mm: the nose of a tool that goes along the axis, and the edge of a
// thread. Material that is being faced or parted off holds nothing, however thin it gets, so that other cuts press on
// the work behind them.
double LatheRun::heightPressed(const Try& tried) const {
  if (tried.thread) return tried.to.y();
  if (tried.cut.isEmpty()) return m_pressed;
  if (tried.goesAlong()) return tried.to.y() + tried.tool->noseCentre().y();
  return m_profile.z(tried.cut.changed.first) - m_profile.spacing();
}

SlenderWork LatheRun::beamAtCut() {
  const LatheSetup& setup = m_machine.setup();
  SlenderWork beam = m_beam.at(m_profile, m_pressed);
  if (m_material) beam.modulus = m_material->modulus;
  beam.cut = 2.0 * m_load.radius;
  constexpr double kOnCentre = 0.5;  // mm
  beam.hasTailstock = setup.tailstock.fitting == LatheFitting::Centre &&
                      m_machine.quillTip() <= setup.chuck.grip + beam.length + kOnCentre;
  return beam;
}

// Returns the cut that a tool would make on its path along the axis if the work were rigid, from the surface before it;
// nothing if it does not go along the axis.
std::optional<CutConditions> LatheRun::cutAhead(const Try& tried) const {
  if (!tried.goesAlong() || tried.thread || tried.cut.isEmpty() || !(tried.motion.turns > 0.0)) return std::nullopt;
  const TurnedProfile::Range& touched = tried.cut.changed;
  const bool isTowardsChuck = tried.to.y() < tried.from.y();
  const std::size_t here = isTowardsChuck ? touched.first : touched.last - 1;
  const std::size_t next = isTowardsChuck ? (here > 0 ? here - 1 : 0) : std::min(here + 1, m_profile.size() - 1);
  const double surface = std::max(m_profile.radius(here), m_profile.radius(next));
  CutConditions cut;
  cut.depth = std::max(0.0, surface - tried.to.x());
  cut.feed = (tried.to - tried.from).norm() / tried.motion.turns;
  cut.speed = surfaceSpeed(std::abs(m_machine.state().speed), surface + tried.to.x());
  return cut;
}

// Returns the distance by which the work gives way to a tool, mm, as the beam that it is. Along the axis that is the
// distance δ = c·F(a - δ) at which work of the compliance c pushes back as hard as a tool presses that is set to the
// depth a. For other cuts the force is that of the last step.
double LatheRun::yielding(const Try& tried) {
  const CuttingForceModel* const law = m_material ? m_material->lawOf(indexOf(tried.tool.get())) : nullptr;
  if (!law) return 0.0;
  const SlenderWork beam = beamAtCut();
  const double compliance = beam.position > 0.0 ? deflection(beam, 1.0) : 0.0;
  const auto cut = cutAhead(tried);
  if (!cut) return compliance * m_thrust;
  const ProfilePoint displacement = tried.to - tried.from, passive = tried.tool->passiveDirection(displacement);
  const auto thrust = [&](double yielded) {
    const CutConditions left{cut->depth - yielded, cut->feed, cut->speed};
    return thrustOf(worn(law->at(left), m_machine.setup().wear), passive, displacement);
  };
  constexpr double kExact = 1e-7;  // mm
  double low = 0.0, high = std::min(cut->depth, compliance * thrust(0.0));
  while (high - low > kExact) {
    const double middle = 0.5 * (low + high);
    (compliance * thrust(middle) > middle ? low : high) = middle;
  }
  m_balanced = thrust(low);
  return low;
}

// Judges by the speed that the levers ask for: a spindle that has slowed down needs less power. A drill presses along
// the axis: nothing bends away from it, nor swings across.
void LatheRun::judge() {
  const SlenderWork beam = beamAtCut();
  const bool isDrilling = m_lastTool->kind == LatheToolKind::Drill;
  CutConditions asked = m_load.cut;
  asked.speed = surfaceSpeed(std::abs(m_machine.targetSpeed()), beam.cut);
  CutForces bending = m_load.forces;
  bending.radial = m_thrust;
  auto broken = warningsFor(asked, bending, edgeOf(*m_lastTool), beam, driveOf(m_machine.setup().spindle));
  if (isDrilling) std::erase_if(broken, [](const CutWarning& warning) { return isOfBending(warning.rule); });
  m_warnings.judge(broken, m_machine.state().time, m_lastTool->id);
  m_chatter = 0.0;
  for (const CutWarning& warning : broken) {
    if (warning.rule == CutWarning::Rule::Chatter) m_chatter = std::min(1.0, warning.value / warning.limit - 1.0);
  }
}

}  // namespace handwheel
