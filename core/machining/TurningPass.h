// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/ControlPointCut.h"
#include "machining/lathe/LatheTool.h"
#include "machining/thread/ThreadCut.h"

#include <optional>

namespace handwheel {

// How a nose cuts: exactly what it sweeps, or by moving control points (ControlPointCut).
enum class TurningMethod { Trim, Poles };

// One pass of a tool along a turned part, as it was recorded. Repeating the passes of a part on its stock gives the
// same profile, bit for bit.
struct TurningPass {
  static constexpr std::size_t kMostPoints = 10'000'000;
  static constexpr double kTouch = 1e-3;  // mm: what takes less off touches only, as where the work has sprung back
  static constexpr double kLeastNose = 0.05, kLargestNose = 50.0;  // mm, of the noses that a user may choose

  double noseRadius = 1.0;          // mm; 0: an ideal point, which cuts by Trim
  std::vector<ProfilePoint> path;   // of the centre of the nose, (r, z); mm
  std::vector<double> times;        // s, of each point since the first; as many, never falling
  std::vector<double> speeds = {};  // r/min of the spindle on the way to each point; empty: they are not known
  TurningSide side = TurningSide::Outside;
  TurningMethod method = TurningMethod::Trim;
  double resolution = 1.0;  // mm, between control points where these are moved
  bool isInParts = true;    // of TurningMethod::Poles: a depth is taken in parts, as ControlPointCut has it
  // Of a lathe: its shape cuts, and the path is that of its tip. Null: the round nose alone.
  std::shared_ptr<const LatheTool> tool = {};
  // Of a thread: the pass leaves a groove (PartThreads) in the profile, which stays as it is: the envelope.
  std::optional<ThreadCut> thread = {};
  // r/min that the levers asked for on the way to each point, where the motor could not hold that; empty: it could.
  std::vector<double> askedSpeeds = {};
  bool isOfProgram = false;  // a program has moved the tool, and no hand
};

// Cuts as this pass does, with the centre of its nose from a to b. Returns the samples that changed.
TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& how, const ProfilePoint& a, const ProfilePoint& b);

// How deep a point that moves straight from a to b is in the material, mm, on the radius at most; 0 outside of it, and
// where only one of two neighbouring samples has the material. O(samples below).
double pointDepth(const TurnedProfile& profile, const ProfilePoint& a, const ProfilePoint& b);

// Cuts a pass. The profile is incomplete when it was cancelled.
TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& pass, Progress progress = {});

// Samples that the passes of a file may visit, each time that they do: some ten seconds. Only a hostile file asks for
// more.
inline constexpr std::uint64_t kMostCutAgain = 1'000'000'000;

// How many samples cut() visits at most: what it costs. O(points).
std::uint64_t samplesUnder(const TurnedProfile& profile, const TurningPass& pass);

}  // namespace handwheel
