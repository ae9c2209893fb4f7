// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What a cut does to the spindle and to the part: LatheRun.
#include "machining/force/CuttingFeel.h"
#include "machining/lathe/LatheRun.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

bool LatheRun::isStalled(double speedBefore) const {
  const LatheState& now = m_machine.state();
  return now.direction != 0 && std::abs(speedBefore) >= kAtRest && std::abs(now.speed) < kAtRest &&
         m_load.torque > spindleTorque(m_machine.setup().spindle, now.speed);
}

// The law says the force of the cut as it was over the last samples.
void LatheRun::measure(const LatheStep& step, double dt) {
  m_meter.add({(step.to - step.from).norm(), step.cut.area, step.cut.volume, step.turns, dt}, m_profile.spacing());
  const double speed = m_machine.state().speed;
  LatheLoad load;
  load.isCutting = m_meter.isCutting();
  load.cut = m_meter.cut(speed);
  load.radius = m_meter.radius();
  if (load.isCutting && m_lastTool->isAbrasive()) {
    load.forces = pressure();
    load.torque = cuttingTorque(load.forces, 2.0 * load.radius);
  }
  const CuttingForceModel* const law = m_material && load.isCutting ? m_material->lawOf(cuttingTool()) : nullptr;
  if (law) {
    const LatheSpindle& spindle = m_machine.setup().spindle;
    load.forces = worn(law->at(load.cut), m_machine.setup().wear);
    load.torque = cuttingTorque(load.forces, 2.0 * load.radius);
    load.power = motorPower(cuttingPower(load.forces, load.cut), driveOf(spindle).efficiency);
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

// What left since the step before has the finish of what took it.
void LatheRun::roughen(const LatheStep& step) {
  if (step.cut.isEmpty()) return;
  const LatheTool& tool = *step.tool;
  const double turned = turnedRoughness(m_load.cut.feed, tool.noseRadius);
  const auto change = [&](TurningSide side, std::size_t i, double& before, double now) {
    if (before == now) return;
    const double was = m_finish.at(side, i, before).value_or(SurfaceFinish::kDrawn);
    const double removed = std::abs(before - now);
    m_finish.set(side, i, now, tool.isAbrasive() ? abradedRoughness(was, removed, tool.leastRoughness) : turned);
    before = now;
  };
  for (std::size_t i = step.cut.changed.first; i < step.cut.changed.last; ++i) {
    change(TurningSide::Outside, i, m_outer[i], m_profile.radius(i));
    change(TurningSide::Bore, i, m_inner[i], m_profile.inner(i));
  }
}

// A spring along the normal: F = k d, with the mean depth d of what is under the tool (He 2008, 5-2, 5-3), and friction
// along the way of the surface. A disk stands in the slide, file and paper are held by hand.
CutForces LatheRun::pressure() const {
  constexpr double kOfDisk = 500.0, kOfHand = 20.0, kFriction = 0.4;  // N/mm
  const bool isDisk = m_lastTool->kind == LatheToolKind::GrindingDisk;
  const double force = (isDisk ? kOfDisk : kOfHand) * m_pressed;
  return {kFriction * force, 0.0, force};
}

// By the speed that the levers ask for: a spindle that has slowed down needs less power.
void LatheRun::judge() {
  const LatheSetup& setup = m_machine.setup();
  SlenderWork beam = beamOf(m_profile, setup.chuck.grip, m_lastPlace.y());
  beam.modulus = m_material->modulus;
  beam.cut = 2.0 * m_load.radius;
  constexpr double kOnCentre = 0.5;  // mm
  beam.hasTailstock = setup.tailstock.fitting == LatheFitting::Centre &&
                      m_machine.quillTip() <= setup.chuck.grip + beam.length + kOnCentre;
  m_compliance = beam.place > 0.0 ? deflection(beam, 1.0) : 0.0;
  CutConditions asked = m_load.cut;
  asked.speed = surfaceSpeed(std::abs(m_machine.targetSpeed()), beam.cut);
  const auto broken = warningsFor(asked, m_load.forces, edgeOf(*m_lastTool), beam, driveOf(setup.spindle));
  m_warnings.judge(broken, m_machine.state().time, m_lastTool->id);
  m_chatter = 0.0;
  for (const CutWarning& warning : broken) {
    if (warning.rule == CutWarning::Rule::Chatter) m_chatter = std::min(1.0, warning.value / warning.limit - 1.0);
  }
}

}  // namespace handwheel
