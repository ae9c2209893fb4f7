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

// By the balance of energy: what the feed and the spindle do is what the chips take (He 2008, A-6 and A-7, with the ktc
// that the printed A-7 lacks). removed: mm³ in the time dt, s. feed: mm/s, of the head. spindle: rad/s. Nothing
// removed, or a drill that neither goes nor turns: nothing.
DrillLoad drillLoad(const DrillMaterial& material, const DrillBit& tool, double removed, double dt, double feed,
                    double spindle);

// The reference of Allotta (1996), (3-22) and (3-23): strength Ks and specific cutting pressure Ru of the material,
// N/mm²; feed: mm per revolution. Of a ball its angle is that of a hemisphere, π; of a saw
// it says nothing.
DrillLoad referenceLoad(const DrillBit& tool, double strength, double pressure, double feed);

// The same with the constants by which both laws agree on a ball deep in the material: Ks = kp / (2 ktc), Ru = kp / 5.
// feed: mm/s; spindle: rad/s. Nothing where it does not turn.
DrillLoad agreeingReference(const DrillMaterial& material, const DrillBit& tool, double feed, double spindle);

// The voxel at which a head at this feed, mm/s, takes whole steps of density in each cycle of the servo loop, rate in
// Hz: (3-20). levels: s, of density; step: Δs.
double drillVoxel(double feed, double rate, double levels = 255.0, double step = 1.0);

}  // namespace handwheel
