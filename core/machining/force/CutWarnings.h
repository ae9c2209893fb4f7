// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CuttingEdge.h"

#include <string>
#include <vector>

namespace handwheel {

// What the spindle drive of a lathe can do.
struct SpindleDrive {
  double power = 3.0;       // kW, of the motor
  double torque = 100.0;    // N·m, at the spindle
  double efficiency = 0.8;  // in (0, 1], from the motor to the cut
  bool operator==(const SpindleDrive&) const = default;
};

// Round work that a cut bends: a shaft of one diameter, held in a chuck, and in a tailstock's centre or not.
struct SlenderWork {
  double diameter = 40.0;  // mm
  double length = 100.0;   // mm, that stands out of the chuck
  double place = 100.0;    // mm, of the cut from the chuck; 0 to length
  double modulus = 210e3;  // N/mm², of elasticity
  bool hasTailstock = false;
  double cut = 0.0;  // mm, diameter that the cut is at; 0: that of the shaft
};

// How far the work gives way at the cut, mm, by a force across it (N). Elastic beam, clamped in the chuck and free, or
// supported at its other end. Infinite for work without thickness.
double deflection(const SlenderWork& work, double force) noexcept;

// A rule of the workshop that a cut breaks.
struct CutWarning {
  enum class Rule {
    Power,        // kW, of the motor
    Torque,       // N·m, at the spindle
    Slenderness,  // length by diameter
    Deflection,   // mm, twice that of the axis, so as the diameter shows it
    Chatter,      // mm, depth of cut
    Rubbing,      // mm, thickness of the chip
    Pressing,     // mm, that a tool which is laid on the work was pressed into it
  };
  Rule rule = Rule::Power;
  double value = 0.0;  // of this cut
  double limit = 0.0;  // of the rule
  bool operator==(const CutWarning&) const = default;
};

inline constexpr std::size_t kCutRules = 7;

// The limits of the rules that are no property of a machine.
struct CutRules {
  // Length by diameter of work that stands free, and with a tailstock. Of workshop books; not verified here.
  double freeSlenderness = 4.0, supportedSlenderness = 10.0;
  double deflection = 0.02;  // mm, of the diameter
  double damping = 0.03;     // of the work's swing, as a share of the critical one
  double edgeRadius = 0.03;  // mm, of a honed carbide edge
};
// A chip thinner than this share of the edge's radius is not cut but rubbed (about 0.3 for steel, Albrecht 1960).
inline constexpr double kLeastChipByEdge = 0.3;

// The rules that a cut breaks. Chatter: the depth is beyond 2 k ζ (1 + ζ) / Kr, which is stable at any spindle speed,
// for work of the stiffness k and a specific radial force Kr (Tobias and Fishwick 1958; Tlusty). Any thread; allocates.
std::vector<CutWarning> warningsFor(const CutConditions& cut, const CutForces& forces, const CuttingEdge& edge,
                                    const SlenderWork& work, const SpindleDrive& drive, const CutRules& rules = {});

// The thinnest chip whose thickness is stated in digits, mm.
inline constexpr double kLeastShownChip = 1e-3;

// The rule in English, one sentence with the value and the limit.
std::string textOf(const CutWarning& warning);
// A stable word for the rule: "power".
const char* wordFor(CutWarning::Rule rule);

}  // namespace handwheel
