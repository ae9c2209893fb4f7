// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/CutWarnings.h"

#include "base/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace handwheel {

double deflection(const SlenderWork& work, double force) noexcept {
  const double secondMoment = std::numbers::pi * std::pow(work.diameter, 4) / 64.0;  // mm⁴
  const double stiffness = work.modulus * secondMoment;
  const double length = work.length, position = std::clamp(work.position, 0.0, std::max(length, 0.0));
  if (!(force > 0.0) || position == 0.0) return 0.0;
  if (!(stiffness > 0.0)) return std::numeric_limits<double>::infinity();
  const double free = force * position * position * position / (3.0 * stiffness);
  if (!work.hasTailstock) return free;
  // The centre pushes back: its reaction P a² (3L − a) / 2L³ lifts the cut by R a² (3L − a) / 6EI.
  const double share = position / length, arm = 3.0 - share;
  return free * (1.0 - share * arm * arm / 4.0);
}

std::vector<CutWarning> warningsFor(const CutConditions& cut, const CutForces& forces, const CuttingEdge& edge,
                                    const SlenderWork& work, const SpindleDrive& drive, const CutRules& rules) {
  using Rule = CutWarning::Rule;
  std::vector<CutWarning> warnings;
  const auto judge = [&](Rule rule, double value, double limit) {
    if (value > limit) warnings.push_back({rule, value, limit});
  };
  judge(Rule::Power, motorPower(cuttingPower(forces, cut), drive.efficiency), drive.power);
  judge(Rule::Torque, cuttingTorque(forces, work.cut > 0.0 ? work.cut : work.diameter), drive.torque);
  judge(Rule::Slenderness, work.length / work.diameter,
        work.hasTailstock ? rules.supportedSlenderness : rules.freeSlenderness);
  const double bent = deflection(work, forces.radial);
  judge(Rule::Deflection, 2.0 * bent, rules.deflection);
  if (bent > 0.0) {
    // Kr = radial / (ap f) and k = radial / bent: the radial force cancels out.
    const double stable = 2.0 * rules.damping * (1.0 + rules.damping) * cut.depth * cut.feed / bent;
    judge(Rule::Chatter, cut.depth, stable);
  }
  const double chip = cut.feed * std::sin(edge.approach.value_or(kUsualApproach));
  const double least = kLeastChipByEdge * rules.edgeRadius;
  if (forces.cutting > 0.0 && std::min(chip, cut.depth) < least)
    warnings.push_back({Rule::Rubbing, std::min(chip, cut.depth), least});
  return warnings;
}

std::string textOf(const CutWarning& warning) {
  const std::string value = roundedText(warning.value, 3), limit = roundedText(warning.limit, 3);
  switch (warning.rule) {
    case CutWarning::Rule::Power:
      return "Power: the cut takes " + value + " kW of the motor, which has " + limit + " kW.";
    case CutWarning::Rule::Torque:
      return "Torque: the cut takes " + value + " N·m at the spindle, which has " + limit + " N·m.";
    case CutWarning::Rule::Slenderness:
      return "L/D: the work stands out " + value + " times its diameter; without more support " + limit +
             " times is the rule.";
    case CutWarning::Rule::Deflection:
      return "Deflection: the work gives way and becomes " + value + " mm thicker here; the limit is " + limit + " mm.";
    case CutWarning::Rule::Chatter:
      return "Chatter: " + value + " mm of depth; up to " + limit + " mm is stable at any spindle speed.";
    case CutWarning::Rule::Pressing:
      return "Pressing: the tool is laid on the work, and cannot be fed " + value + " mm into it; all its force goes " +
             limit + " mm.";
    case CutWarning::Rule::Rubbing:
      break;
  }
  const std::string chip = warning.value < kLeastShownChip ? "less than " + roundedText(kLeastShownChip, 3) : value;
  return "Rubbing: a chip of " + chip + " mm is not cut but rubbed; " + limit + " mm is the least.";
}

const char* wordFor(CutWarning::Rule rule) {
  constexpr std::array kWords{"power", "torque", "l/d", "deflection", "chatter", "rubbing", "pressing"};
  return kWords[static_cast<std::size_t>(rule)];
}

}  // namespace handwheel
