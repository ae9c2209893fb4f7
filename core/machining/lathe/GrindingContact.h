// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheTool.h"

namespace handwheel {

// The depth of an abrasive tool in a part, averaged over its contact surface. He 2008, 5.1.1.1.
struct GrindingContact {
  double depth = 0.0;         // mm, the mean along the normals (5-1, 5-2); 0: no contact
  ProfilePoint normal{0, 0};  // the mean of the normals out of the material (5-4), (r, z), of length 1
  bool isEmpty() const { return !(depth > 0.0); }
};

// The contact of a tool whose tip is at this point. The pieces of the surface are those between the samples below the
// tool. O(samples below it).
GrindingContact grindingContact(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& tip);

// How deep a tool whose tip moves straight from one place to another would be in the material, mm along r, from the
// surface on its side. Beyond the axis, too, where there is no material to count: there a cut is no deeper than the
// work is thick. 0: no contact. O(samples below it).
double pressedDepth(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                    const ProfilePoint& to);

// How stiffly a tool is held, and how hard it can be pressed: a disk stands in a slide, file and paper are in a hand.
struct GrindingHold {
  double stiffness = 0.0;  // N/mm
  double damping = 0.0;    // N·s/mm
  double most = 0.0;       // N
  // mm: no force presses the tool deeper than this; beyond it a hand, or a slide, cannot go.
  double deepest() const { return stiffness > 0.0 ? most / stiffness : 0.0; }
};
GrindingHold holdOf(const LatheTool& tool);

// N, out of the material along the mean normal: F = k d − ζ V (5-3), with the speed V out of it. velocity: of the tool,
// mm/s. Never pulls, and never more than the hold has.
double grindingForce(const GrindingContact& contact, const GrindingHold& hold, const ProfilePoint& velocity);

// Of that force, along the way of the surface: what is usual between abrasives and metal.
inline constexpr double kGrindingFriction = 0.4;

}  // namespace handwheel
