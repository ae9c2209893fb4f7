// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/finish/SurfaceFinish.h"
#include "machining/thread/PartThreads.h"

#include <memory>
#include <span>

namespace handwheel {

// The parameters of the lathe for a review of passes.
struct ReviewedLathe {
  double spindleSpeed = 800.0;  // r/min, for passes that do not record their spindle speed
  double chuckHeight = 0.0;    // mm, height above the lower end of the part up to which the chuck holds it; 0: no chuck
  double chuckDiameter = 0.0;  // mm
  double largestFeed = 2.0;    // mm per revolution, largest feed that a tool survives in material deeper than kTouch
};

// A contact of a tool with something that it must not touch.
struct CrashMoment {
  enum class What { Chuck, RapidInMaterial };
  What what = What::Chuck;
  std::size_t pass = 0;
  double time = 0.0;            // s since the start of the first pass, without the pauses between passes
  ProfilePoint position{0, 0};  // position of the centre of the nose
  // mm per revolution, largest feed of RapidInMaterial; infinite if the spindle was at rest
  double feed = 0.0;
  std::size_t first = 0, last = 0;  // first and last point of the crash on the path of the pass
};

// The conditions of a cut over a short distance, half a millimetre or less.
struct CutMoment {
  std::size_t pass = 0;
  double time = 0.0;  // s since the start of the first pass, without the pauses between passes
  ProfilePoint position{0, 0};
  // mm, width of the cut across the feed: removed area of the half section divided by the distance; of a thread the
  // length of the edge that cuts, and the chip is what the pass removes beyond the passes before
  double depth = 0.0;
  double feed = 0.0;    // mm per revolution
  double chip = 0.0;    // mm, largest chip thickness; it is less than the feed in the first turn in material
  double speed = 0.0;   // m/min, surface speed at `radius`, or at the tip of a tool that a program moves
  double asked = 0.0;   // m/min, speed that the levers asked for; higher than `speed` if the motor was overloaded
  double radius = 0.0;  // mm, largest radius that was cut; of a drill the middle of the part of its lips that cuts
  bool isDrilling = false;
};

class FinishMeter;

// The results of a part's passes: finish, crashes, cuts, time. The review repeats the passes on the bar. The same
// passes give the same results.
class TurningReview {
 public:
  // Largest number of samples that the passes may visit; if they visit more, there is no review. An hour of cutting on
  // the manual lathe visits 2e9 samples: 500 moves a second with a thousand samples below the tool.
  static constexpr std::uint64_t kMostWork = 4'000'000'000;
  static constexpr std::size_t kMostMoments = 2'000;  // limit; of neighbouring moments only the heaviest cut is kept

  using Passes = std::span<const std::shared_ptr<const TurningPass>>;

  // Reviews the passes. bar: the part before the first pass. Returns nothing if the passes visit more than kMostWork
  // samples, or if it was cancelled. threads: those of the part before the first pass; may be null.
  static std::optional<TurningReview> make(const TurnedProfile& bar, Passes passes, const ReviewedLathe& lathe,
                                           Progress progress = {}, std::shared_ptr<const PartThreads> threads = {});

  const TurnedProfile& profile() const { return m_profile; }  // the part after the last pass
  double seconds() const { return m_seconds; }                // s, duration of all passes
  double pathLength() const { return m_pathLength; }          // mm
  const std::vector<CrashMoment>& crashes() const { return m_crashes; }
  const std::vector<CutMoment>& moments() const { return m_moments; }  // in ascending order of time
  // Returns the finish of the part after the last pass.
  const SurfaceFinish& finish() const { return m_finish; }

 private:
  explicit TurningReview(const TurnedProfile& bar);
  struct Stretch;
  void repeat(const TurningPass& pass, std::size_t number, const ReviewedLathe& lathe, FinishMeter& meter,
              Progress progress);
  void addThread(const TurningPass& pass, std::size_t number, const ReviewedLathe& lathe);
  // Takes the radii of samples that the end of a pass changed.
  void follow(const TurnedProfile::Range& changed);
  double take(Stretch& stretch, TurningSide side, TurnedProfile::Range changed);  // mm, the largest change of a radius
  void endStretch(Stretch& stretch, std::size_t pass);
  void thinMoments();

  TurnedProfile m_profile;
  std::vector<double> m_outerRadii, m_boreRadii;  // mm, radii before the present move
  SurfaceFinish m_finish;
  std::shared_ptr<const PartThreads> m_threads;  // before the present pass; may be null
  std::vector<CrashMoment> m_crashes;
  std::vector<CutMoment> m_moments;
  double m_seconds = 0.0, m_pathLength = 0.0;
};

}  // namespace handwheel
