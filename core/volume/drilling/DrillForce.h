// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/drilling/DrillBit.h"
#include "volume/drilling/DrillMaterials.h"

namespace handwheel {

// Thrust and torque of a drill.
struct DrillLoad {
  double thrust = 0.0;  // N
  double torque = 0.0;  // N·mm
};

// Returns the load by the balance of energy: the work of feed and spindle equals that of the chips. The formulas are
// of He 2008, with the ktc that is missing in the printed A-7. removed: volume in mm³ removed in the time
// dt, s. feed: speed of the head, mm/s. spindle: rad/s. The load is zero if nothing was removed, or if the drill
// neither moves nor turns.
DrillLoad drillLoad(const DrillMaterial& material, const DrillBit& tool, double removed, double dt, double feed,
                    double spindle);

// Returns the load by Allotta (1996), as in He 2008, equations 3-22 and 3-23. strength: Ks, N/mm²; pressure: specific
// cutting pressure Ru, N/mm²; feed: mm per revolution. A ball or burr counts as a drill with a point angle of π; the
// load of a saw is zero.
DrillLoad referenceLoad(const DrillBit& tool, double strength, double pressure, double feed);

// Returns the reference load with the constants for which both laws agree for a ball deep in the material: Ks = kp / (2
// ktc), Ru = kp / 5. feed: mm/s; spindle: rad/s. The load is zero if the spindle does not turn.
DrillLoad agreeingReference(const DrillMaterial& material, const DrillBit& tool, double feed, double spindle);

// Returns the voxel size at which a head removes whole steps of density in each cycle of the servo loop (He 2008,
// equation 3-20). feed: mm/s. rate: Hz. levels: number of levels of density (s in the equation); step: levels removed
// in a cycle (Δs).
double drillVoxel(double feed, double rate, double levels = 255.0, double step = 1.0);

}  // namespace handwheel
