// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheTool.h"

namespace handwheel {

// The depth of an abrasive tool in a part, averaged over its contact surface. He 2008, 5.1.1.1.
struct GrindingContact {
  double depth = 0.0;         // mm, mean along the normals (5-1, 5-2); 0: no contact
  ProfilePoint normal{0, 0};  // mean of the normals out of the material (5-4), (r, z), of length 1
  bool isEmpty() const { return !(depth > 0.0); }
};

// Returns the contact of a tool with its tip at this point. The pieces of the surface are those between the samples
// below the tool. O(samples below it).
GrindingContact grindingContact(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& tip);

// Returns the depth that a tool would have in the material if its tip moved straight between these positions, mm along
// r, from the surface on its side. It counts beyond the axis, too, where no material is left: there a cut is no deeper
// than the work is thick. 0: no contact. O(samples below it).
double pressedDepth(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                    const ProfilePoint& to);

// The stiffness and the largest force with which a tool is held: a disk by a slide, file and paper by a hand.
struct GrindingHold {
  double stiffness = 0.0;  // N/mm
  double damping = 0.0;    // N·s/mm
  double most = 0.0;       // N
  // mm; largest depth, at the largest force: a hand or a slide cannot press the tool deeper.
  double deepest() const { return stiffness > 0.0 ? most / stiffness : 0.0; }
};
GrindingHold holdOf(const LatheTool& tool);

// Returns the force, N, out of the material along the mean normal: F = k d − ζ V (5-3), with the speed V out of it.
// velocity: velocity of the tool, mm/s. Never pulls, and never exceeds the largest force of the hold.
double grindingForce(const GrindingContact& contact, const GrindingHold& hold, const ProfilePoint& velocity);

// Friction along the motion of the surface, as a share of that force: usual between abrasives and metal.
inline constexpr double kGrindingFriction = 0.4;

}  // namespace handwheel
