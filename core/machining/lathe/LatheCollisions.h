// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheMachine.h"

#include <optional>

namespace handwheel {

// The parts of a lathe that can touch each other.
enum class LathePart { CuttingEdge, Holder, ToolPost, Slide, Fitting, Tailstock, Jaws, Chuck, Work };
inline constexpr std::size_t kLatheParts = 9;
const char* titleOf(LathePart part);  // English text, translated in the context "LathePart"

// The reason why a contact is a crash.
enum class CrashCause {
  Contact,        // these parts must not touch at all
  Rapid,          // the power traverse ran into the work
  SpindleAtRest,  // the edge was pushed into work that does not turn
  Reversed,       // the edge cut while the work turned the wrong way, against the back of the edge
  TooDeep,        // the cut is deeper than the cutting edge is long
  Overload        // the motor cannot turn the spindle against this cut
};
const char* sentenceOf(CrashCause cause);  // English text, translated in the context "LathePart"

// A crash of a lathe: the parts that met, the position and the time.
struct LatheCollision {
  LathePart moving = LathePart::CuttingEdge;
  LathePart struck = LathePart::Work;
  CrashCause cause = CrashCause::Contact;
  ProfilePoint position{0.0, 0.0};  // mm, (r, z)
  double depth = 0.0;               // mm, overlap that the parts would have if the step were made; 0: not known
  double time = 0.0;                // s, clock of the machine
  std::string tool;                 // id of the tool that was in use
  double passes = -1.0;             // number of passes at that time, including the current one; below 0: not known

  bool operator==(const LatheCollision&) const = default;
};

// A part of a lathe with its section in the half plane.
struct LatheSolid {
  LathePart part = LathePart::Chuck;
  RoundedPolygon section;
};

// Returns the largest outer radius (mm) of a part between the jaws, or the least inner radius if they grip in a bore.
double grippedRadius(const TurnedProfile& profile, const LatheChuck& chuck);

// Return the sections of the parts around the axis: chuck and jaws, and the tailstock with its quill. The parts are
// also drawn from these sections. gripped: the radius on which the jaws are closed, mm. quillTip: the z of the tip of
// the quill's fitting, mm. drill: the drill in the tailstock; null: none.
std::vector<LatheSolid> chuckSolids(const LatheChuck& chuck, double gripped);
std::vector<LatheSolid> tailstockSolids(const LatheTailstock& tailstock, double quillTip, const LatheTool* drill);
// Returns the sections of the parts that move with a tool, relative to its tip: edge, holder, tool post and slide.
std::vector<LatheSolid> toolSolids(const LatheTool& tool);

// Returns a contact of the solids, moved to `at`, with the other solids, or nothing if they do not touch. O(pairs).
std::optional<LatheCollision> contactBetween(const std::vector<LatheSolid>& moved, const ProfilePoint& at,
                                             const std::vector<LatheSolid>& others);

// Returns a contact with the work of a holder, a tool post or a fitting that moves between two positions. Contacts
// within the tolerance are ignored, and the edge is not tested. within: a radius that no material exceeds, mm.
std::optional<LatheCollision> contactWithWork(const std::vector<LatheSolid>& moved, const ProfilePoint& from,
                                              const ProfilePoint& to, const TurnedProfile& work, double within);

}  // namespace handwheel
