// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/ControlPointCut.h"
#include "machining/lathe/LatheTool.h"
#include "machining/thread/ThreadCut.h"

#include <optional>

namespace handwheel {

// The method by which a nose cuts. Trim removes exactly the material that the nose sweeps; Poles moves control points
// (ControlPointCut).
enum class TurningMethod { Trim, Poles };

// One pass of a tool along a turned part, as it was recorded. Repeating the passes of a part on its stock gives the
// same profile, bit for bit.
struct TurningPass {
  static constexpr std::size_t kMostPoints = 10'000'000;
  static constexpr double kTouch =
      1e-3;  // mm; with a smaller depth the tool only touches the work, for example where it has sprung back
  static constexpr double kLeastNose = 0.05,
                          kLargestNose = 50.0;  // mm; limits of the nose radius that a user may choose

  double noseRadius = 1.0;          // mm; 0: an ideal point, which cuts by Trim
  std::vector<ProfilePoint> path;   // path of the centre of the nose, (r, z); mm
  std::vector<double> times;        // s, time of each point after the first point; the times never fall
  std::vector<double> speeds = {};  // spindle speed of the move to each point, r/min; empty: not known
  TurningSide side = TurningSide::Outside;
  TurningMethod method = TurningMethod::Trim;
  double resolution = 1.0;  // mm, spacing of the control points, for TurningMethod::Poles
  bool isInParts = true;    // TurningMethod::Poles takes a depth in parts (ControlPointCut)
  // The lathe tool, whose shape cuts; the path is then the path of its tip. Null: a round nose alone cuts.
  std::shared_ptr<const LatheTool> tool = {};
  // The thread that the pass cuts. The pass adds a groove (PartThreads); the profile, which is the envelope, does not
  // change.
  std::optional<ThreadCut> thread = {};
  // Spindle speed that the levers asked for in the move to each point, r/min. The list is empty if the motor could hold
  // all speeds.
  std::vector<double> askedSpeeds = {};
  bool isOfProgram = false;  // a program moved the tool
  // After the pass the samples of the part are taken from its exact section. Early versions of the program kept the
  // samples that were cut step by step, and their passes are repeated with false.
  bool isExact = false;
  // Direction of the tip from the centre of the nose of a tool without a body, as tipDirection() gives it. Such a tool
  // has a leading edge across the axis and a trailing edge along it. (0, 0): a round nose without edges.
  ProfilePoint edges{0, 0};
  // The points of `path` from `first` to `last` approximate an arc with this bulge, which begins and ends in them.
  struct Arc {
    std::uint32_t first = 0, last = 0;
    double bulge = 0.0;  // bulge of ProfileSegment
    bool operator==(const Arc&) const = default;
  };
  std::vector<Arc> arcs = {};  // in ascending order; they do not overlap
  bool isOfCommand = false;    // a command made the pass: no hand and no program moved a tool
};

// Cuts by the method and with the tool of a pass while the nose centre, or the tip of the tool, moves straight from a
// to b. Returns the samples that changed.
TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& how, const ProfilePoint& a, const ProfilePoint& b);

// Cuts the samples only, as `cut` does if a pass is not exact.
TurnedProfile::Range cutSamples(TurnedProfile& profile, const TurningPass& how, const ProfilePoint& a,
                                const ProfilePoint& b);

// Returns the largest depth (mm) in the material of a point that moves straight from a to b, at most the radius of the
// work. The depth is 0 outside of the material, and where only one of two neighbouring samples has material. O(samples
// between a and b).
double pointDepth(const TurnedProfile& profile, const ProfilePoint& a, const ProfilePoint& b);

// Cuts a pass into the profile, which then has its section (TurnedProfile::section()). number: the index of the pass in
// the part. Returns the samples that changed. If cancelled, only the first moves of the pass are cut.
TurnedProfile::Range cut(TurnedProfile& profile, const std::shared_ptr<const TurningPass>& pass, std::uint32_t number,
                         Progress progress = {});
TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& pass, Progress progress = {});

// Largest number of samples that the passes of a file may visit when they are repeated, which takes about ten seconds.
// Only a hostile file needs more.
inline constexpr std::uint64_t kMostCutAgain = 1'000'000'000;

// Returns the largest number of samples that cut() visits for this pass, a measure of its cost. O(points).
std::uint64_t samplesUnder(const TurnedProfile& profile, const TurningPass& pass);

}  // namespace handwheel
