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

// Returns the load by the balance of energy: the work of feed and spindle equals that of the chips (He 2008, A-6 and
// A-7, with the ktc that is missing in the printed A-7). removed: mm³ in the time dt, s. feed: mm/s, of the head.
// spindle: rad/s. Zero if nothing was removed, or if the drill neither moves nor turns.
DrillLoad drillLoad(const DrillMaterial& material, const DrillBit& tool, double removed, double dt, double feed,
                    double spindle);

// Returns the load by Allotta (1996), (3-22) and (3-23). strength: Ks, N/mm²; pressure: specific cutting pressure Ru,
// N/mm²; feed: mm per revolution. The angle of a ball is that of a hemisphere, π; the load of a saw is zero.
DrillLoad referenceLoad(const DrillBit& tool, double strength, double pressure, double feed);

// Returns the reference load with the constants for which both laws agree for a ball deep in the material: Ks = kp / (2
// ktc), Ru = kp / 5. feed: mm/s; spindle: rad/s. Zero if it does not turn.
DrillLoad agreeingReference(const DrillMaterial& material, const DrillBit& tool, double feed, double spindle);

// Returns the voxel size at which a head at this feed, mm/s, removes whole steps of density in each cycle of the servo
// loop: (3-20). rate: Hz. levels: s, levels of density; step: Δs.
double drillVoxel(double feed, double rate, double levels = 255.0, double step = 1.0);

}  // namespace handwheel
