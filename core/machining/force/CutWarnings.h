// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CuttingEdge.h"

#include <string>
#include <vector>

namespace handwheel {

// The capacity of the spindle drive of a lathe.
struct SpindleDrive {
  double power = 3.0;       // kW, rated power of the motor
  double torque = 100.0;    // N·m, torque at the spindle
  double efficiency = 0.8;  // in (0, 1], from the motor to the cut
  bool operator==(const SpindleDrive&) const = default;
};

// Round work that a cut bends. It is a shaft of one diameter, held in a chuck, with or without the centre of a
// tailstock.
struct SlenderWork {
  double diameter = 40.0;   // mm
  double length = 100.0;    // mm, overhang from the chuck
  double position = 100.0;  // mm, distance of the cut from the chuck; 0 to length
  double modulus = 210e3;   // N/mm², modulus of elasticity
  bool hasTailstock = false;
  double cut = 0.0;  // mm, diameter at the cut; 0: the diameter of the shaft
};

// Returns the deflection of the work at the cut, mm, under a force (N) perpendicular to the axis. The work is an
// elastic beam that is clamped in the chuck and free at its other end, or supported by the tailstock. The deflection of
// work without thickness is infinite.
double deflection(const SlenderWork& work, double force) noexcept;

// A workshop rule that a cut breaks, with the value and the limit.
struct CutWarning {
  enum class Rule {
    Power,        // kW, power of the motor
    Torque,       // N·m, torque at the spindle
    Slenderness,  // length divided by diameter
    Deflection,   // mm on the diameter, twice the deflection of the axis
    Chatter,      // mm, depth of cut
    Rubbing,      // mm, thickness of the chip
    Pressing,     // mm, depth by which a grinding tool or file was pressed into the work
  };
  Rule rule = Rule::Power;
  double value = 0.0;  // value of this cut
  double limit = 0.0;  // limit of the rule
  bool operator==(const CutWarning&) const = default;
};

inline constexpr std::size_t kCutRules = 7;

// The limits of the rules that do not depend on the machine.
struct CutRules {
  // Largest length divided by diameter, for work with a free end and for work in a tailstock. The values are from
  // workshop books; they were not verified.
  double freeSlenderness = 4.0, supportedSlenderness = 10.0;
  double deflection = 0.02;  // mm on the diameter, largest deflection
  double damping = 0.03;     // damping ratio of the work's vibration
  double edgeRadius = 0.03;  // mm, radius of a honed carbide edge
};
// Fraction of the edge radius below which a chip is not cut but rubbed (about 0.3 for steel, Albrecht 1960)
inline constexpr double kLeastChipByEdge = 0.3;

// Returns the rules that a cut breaks. The rule of chatter is broken if the depth exceeds 2 k ζ (1 + ζ) / Kr, the depth
// that is stable at any spindle speed for work of the stiffness k and a specific radial force Kr (Tobias and Fishwick
// 1958; Tlusty). May be called on any thread; allocates memory.
std::vector<CutWarning> warningsFor(const CutConditions& cut, const CutForces& forces, const CuttingEdge& edge,
                                    const SlenderWork& work, const SpindleDrive& drive, const CutRules& rules = {});

// Thinnest chip whose thickness is shown as a number, mm.
inline constexpr double kLeastShownChip = 1e-3;

// Returns the warning in English, one sentence with the value and the limit.
std::string textOf(const CutWarning& warning);
// Returns a stable word for the rule, for example "power".
const char* wordFor(CutWarning::Rule rule);

}  // namespace handwheel
