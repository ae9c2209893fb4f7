// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/ControlPointCut.h"
#include "machining/lathe/LatheTool.h"
#include "machining/thread/ThreadCut.h"

#include <optional>

namespace handwheel {

// The method by which a nose cuts. Trim removes exactly the sweep, Poles moves control points (ControlPointCut).
enum class TurningMethod { Trim, Poles };

// One pass of a tool along a turned part, as it was recorded. Repeating the passes of a part on its stock gives the
// same profile, bit for bit.
struct TurningPass {
  static constexpr std::size_t kMostPoints = 10'000'000;
  static constexpr double kTouch =
      1e-3;  // mm; a smaller depth only touches, for example where the work has sprung back
  static constexpr double kLeastNose = 0.05,
                          kLargestNose = 50.0;  // mm; limits of the nose radius that a user may choose

  double noseRadius = 1.0;          // mm; 0: an ideal point, which cuts by Trim
  std::vector<ProfilePoint> path;   // path of the centre of the nose, (r, z); mm
  std::vector<double> times;        // s; time of each point since the first; one for each point, never falling
  std::vector<double> speeds = {};  // spindle speed of the move to each point, r/min; empty: not known
  TurningSide side = TurningSide::Outside;
  TurningMethod method = TurningMethod::Trim;
  double resolution = 1.0;  // mm between control points, for TurningMethod::Poles
  bool isInParts = true;    // for TurningMethod::Poles: a depth is taken in parts (ControlPointCut)
  // The tool of a lathe: its shape cuts, and the path is that of its tip. Null: a round nose alone.
  std::shared_ptr<const LatheTool> tool = {};
  // The thread that the pass cuts: the pass leaves a groove (PartThreads) in the profile. The profile, which is the
  // envelope, does not change.
  std::optional<ThreadCut> thread = {};
  // Spindle speed that the levers asked for in the move to each point, r/min, if the motor could not hold it; empty: it
  // could.
  std::vector<double> askedSpeeds = {};
  bool isOfProgram = false;  // a program moved the tool, not a hand
};

// Cuts like this pass, with the centre of its nose moving from a to b. Returns the samples that changed.
TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& how, const ProfilePoint& a, const ProfilePoint& b);

// Returns the depth of a point that moves straight from a to b in the material: mm, at most the radius; 0 outside of
// the material, and where only one of two neighbouring samples has material. O(samples below).
double pointDepth(const TurnedProfile& profile, const ProfilePoint& a, const ProfilePoint& b);

// Cuts a pass. The profile is incomplete if it was cancelled.
TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& pass, Progress progress = {});

// Largest number of samples that the passes of a file may visit when they are repeated: about ten seconds. Only a
// hostile file needs more.
inline constexpr std::uint64_t kMostCutAgain = 1'000'000'000;

// Returns the largest number of samples that cut() visits, a measure of its cost. O(points).
std::uint64_t samplesUnder(const TurnedProfile& profile, const TurningPass& pass);

}  // namespace handwheel
