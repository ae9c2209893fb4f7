// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheMachine.h"

#include <optional>

namespace handwheel {

// Parts of a lathe that can meet.
enum class LathePart { CuttingEdge, Holder, ToolPost, Slide, Fitting, Tailstock, Jaws, Chuck, Work };
inline constexpr std::size_t kLatheParts = 9;
const char* titleOf(LathePart part);  // English, context "LathePart"

// The reason why a contact is a crash.
enum class CrashCause {
  Contact,        // these parts must not touch at all
  Rapid,          // the power traverse ran into the work
  SpindleAtRest,  // the edge was pushed into work that does not turn
  Reversed,       // the edge cut while the work turned against its back
  TooDeep,        // the cut is deeper than the edge is high
  Overload        // the motor cannot turn the spindle against this cut
};
const char* sentenceOf(CrashCause cause);  // English, context "LathePart"

// A crash of a lathe: the parts that met, the position and the time.
struct LatheCollision {
  LathePart moving = LathePart::CuttingEdge;
  LathePart struck = LathePart::Work;
  CrashCause cause = CrashCause::Contact;
  ProfilePoint position{0.0, 0.0};  // mm, (r, z)
  double depth = 0.0;               // mm, overlap that the parts would have had; 0: not known
  double time = 0.0;                // s, clock of the machine
  std::string tool;                 // id of the tool that was in use
  double passes = -1.0;             // passes of the part by then, the current one included; below 0: not known

  bool operator==(const LatheCollision&) const = default;
};

// A part of a lathe with its section.
struct LatheSolid {
  LathePart part = LathePart::Chuck;
  RoundedPolygon section;
};

// Returns the largest outer, or least inner, radius of a part between the jaws, mm.
double grippedRadius(const TurnedProfile& profile, const LatheChuck& chuck);

// Returns the sections of the parts that stand or turn around the axis: chuck, jaws, and the tailstock with its quill.
// They are also drawn from these sections. gripped: mm, radius that the jaws are closed on. drill: drill in the
// tailstock; null: none.
std::vector<LatheSolid> chuckSolids(const LatheChuck& chuck, double gripped);
std::vector<LatheSolid> tailstockSolids(const LatheTailstock& tailstock, double quillTip, const LatheTool* drill);
// Returns the sections of the parts that move with a tool, relative to its tip: edge, holder, tool post and slide.
std::vector<LatheSolid> toolSolids(const LatheTool& tool);

// Returns a contact of the moved solids with the others, or nothing. O(pairs).
std::optional<LatheCollision> contactBetween(const std::vector<LatheSolid>& moved, const ProfilePoint& at,
                                             const std::vector<LatheSolid>& others);

// Returns a contact of a holder, a tool post or a fitting with the work, deeper than its tolerance; the edge is not
// tested. within: mm, a radius that no material exceeds.
std::optional<LatheCollision> contactWithWork(const std::vector<LatheSolid>& moved, const ProfilePoint& from,
                                              const ProfilePoint& to, const TurnedProfile& work, double within);

}  // namespace handwheel
