// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What a cut does to the spindle and to the part: LatheRun.
#include "machining/force/CuttingFeel.h"
#include "machining/lathe/GrindingContact.h"
#include "machining/lathe/LatheRun.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

bool isOfBending(CutWarning::Rule rule) {
  using Rule = CutWarning::Rule;
  return rule == Rule::Slenderness || rule == Rule::Deflection || rule == Rule::Chatter;
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
    // A tool that is drawn out of its cut does not pull the work after it.
    const double back = displacement.isZero() ? 0.0 : -displacement.x() / displacement.norm();
    m_thrust = std::max(0.0, load.passive.x() * load.forces.radial + back * load.forces.feed);
    load.isOutsideModel = !law->covers(load.cut);
    load.isOverloaded = load.torque > spindleTorque(spindle, speed);
  }
  if (!law) m_compliance = m_chatter = 0.0;
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

// Judges by the speed that the levers ask for: a spindle that has slowed down needs less power. Material that is being
// faced or parted off holds nothing, however thin it gets: the beam is the work behind the cut. A drill presses along
// the axis: nothing bends away from it, nor swings across.
void LatheRun::judge() {
  const LatheSetup& setup = m_machine.setup();
  SlenderWork beam = beamOf(m_profile, setup.chuck.grip, m_behindCut);
  beam.modulus = m_material->modulus;
  beam.cut = 2.0 * m_load.radius;
  constexpr double kOnCentre = 0.5;  // mm
  beam.hasTailstock = setup.tailstock.fitting == LatheFitting::Centre &&
                      m_machine.quillTip() <= setup.chuck.grip + beam.length + kOnCentre;
  const bool isDrilling = m_lastTool->kind == LatheToolKind::Drill;
  m_compliance = beam.position > 0.0 && !isDrilling ? deflection(beam, 1.0) : 0.0;
  CutConditions asked = m_load.cut;
  asked.speed = surfaceSpeed(std::abs(m_machine.targetSpeed()), beam.cut);
  CutForces bending = m_load.forces;
  bending.radial = m_thrust;
  auto broken = warningsFor(asked, bending, edgeOf(*m_lastTool), beam, driveOf(setup.spindle));
  if (isDrilling) std::erase_if(broken, [](const CutWarning& warning) { return isOfBending(warning.rule); });
  m_warnings.judge(broken, m_machine.state().time, m_lastTool->id);
  m_chatter = 0.0;
  for (const CutWarning& warning : broken) {
    if (warning.rule == CutWarning::Rule::Chatter) m_chatter = std::min(1.0, warning.value / warning.limit - 1.0);
  }
}

}  // namespace handwheel
