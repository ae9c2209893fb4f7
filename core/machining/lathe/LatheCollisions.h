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

// Why a contact is a crash.
enum class CrashCause {
  Contact,        // these parts must not touch at all
  Rapid,          // the power traverse ran into the work
  SpindleAtRest,  // the edge was pushed into work that does not turn
  Reversed,       // the edge cut while the work turned against its back
  TooDeep,        // the cut is deeper than the edge is high
  Overload        // the motor cannot turn the spindle against this cut
};
const char* sentenceOf(CrashCause cause);  // English, context "LathePart"

// A crash: what met what, where and when.
struct LatheCollision {
  LathePart moving = LathePart::CuttingEdge;
  LathePart struck = LathePart::Work;
  CrashCause cause = CrashCause::Contact;
  ProfilePoint place{0.0, 0.0};  // mm, (r, z)
  double depth = 0.0;            // mm: how far they would have been in each other; 0 where that is not known
  double time = 0.0;             // s, of the machine
  std::string tool;              // id of the tool that was in use
  double passes = -1.0;          // that the part had by then, the one under way included; below 0: not known

  bool operator==(const LatheCollision&) const = default;
};

// A part of a lathe with its section.
struct LatheSolid {
  LathePart part = LathePart::Chuck;
  RoundedPolygon section;
};

// The largest outer, or least inner, radius of a part between the jaws, mm.
double grippedRadius(const TurnedProfile& profile, const LatheChuck& chuck);

// The sections of what stands or turns around the axis: chuck, jaws, and the tailstock with its quill. gripped: mm,
// radius that the jaws are closed on. They are drawn from these sections, too. drill: of the tailstock; null: none.
std::vector<LatheSolid> chuckSolids(const LatheChuck& chuck, double gripped);
std::vector<LatheSolid> tailstockSolids(const LatheTailstock& tailstock, double quillTip, const LatheTool* drill);
// Those of what moves with a tool, relative to its tip: edge, holder, tool post and slide.
std::vector<LatheSolid> toolSolids(const LatheTool& tool);

// Where the moved solids touch the others; none where nothing does. O(pairs).
std::optional<LatheCollision> contactBetween(const std::vector<LatheSolid>& moved, const ProfilePoint& at,
                                             const std::vector<LatheSolid>& others);

// Where a holder, a tool post or a fitting is in the work, deeper than its tolerance; the edge is not asked. within:
// mm, a radius that no material exceeds.
std::optional<LatheCollision> contactWithWork(const std::vector<LatheSolid>& moved, const ProfilePoint& from,
                                              const ProfilePoint& to, const TurnedProfile& work, double within);

}  // namespace handwheel
