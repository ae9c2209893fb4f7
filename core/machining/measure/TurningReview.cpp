// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/TurningReview.h"

#include "machining/finish/FinishMeter.h"
#include "machining/force/ChipGrowth.h"
#include "machining/lathe/LatheTool.h"
#include "machining/thread/ThreadChip.h"

#include "machining/PassSteps.h"
#include "machining/section/SectionSource.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr std::size_t kMostCrashes = 1'000;
// Tolerance of the largest feed, as a share of it: work that yields makes the path of a tool longer than that of its
// slides, which keep the feed.
constexpr double kFeedSlack = 0.01;

double sideRadius(const TurnedProfile& profile, TurningSide side, std::size_t i) {
  return side == TurningSide::Outside ? profile.radius(i) : profile.inner(i);
}

// Returns true if the nose, or the shank that comes to it from outside, is within the jaws.
bool isInChuck(const TurningPass& pass, const ProfilePoint& centre, const ReviewedLathe& lathe) {
  if (!(lathe.chuckHeight > 0.0) || pass.side == TurningSide::Bore) return false;
  const double nose = pass.tool ? 0.0 : pass.noseRadius;  // the path of a tool is that of its tip
  return centre.y() - nose < lathe.chuckHeight && centre.x() - nose < 0.5 * lathe.chuckDiameter;
}

// r/min in the move to a point.
double speedAt(const TurningPass& pass, std::size_t i, const ReviewedLathe& lathe) {
  return i < pass.speeds.size() ? pass.speeds[i] : lathe.spindleSpeed;
}

// r/min that the levers asked for there.
double askedAt(const TurningPass& pass, std::size_t i, double speed) {
  return i < pass.askedSpeeds.size() ? std::max(pass.askedSpeeds[i], speed) : speed;
}

// Returns the share of a move that is cut before its load is taken, at most 0.5 mm long. A sample is removed as a whole
// when the edge reaches its middle: over a whole number of samples along the axis the removed area is exact. The moves
// of earlier versions are repeated as they were made.
double shareOf(const TurningPass& pass, const ProfilePoint& from, const ProfilePoint& to, double spacing) {
  constexpr double kLongest = 0.5, kMostParts = 10'000.0;  // mm
  const double length = (to - from).norm(), axial = std::abs(to.y() - from.y());
  if (!pass.isExact || !(length > kLongest)) return 1.0;
  const double samples = std::floor(kLongest * axial / length / spacing);
  const double share = 2.0 * axial > length && samples >= 1.0 ? samples * spacing / axial : kLongest / length;
  return std::clamp(share, 1.0 / kMostParts, 1.0);
}

// Returns the load of a cut on the lathe; only for comparison.
double weightOf(const CutMoment& moment) {
  return moment.depth * moment.chip * moment.asked;
}

// Returns the radius of the tip at a point of the path of a pass, mm.
double tipRadius(const TurningPass& pass, const ProfilePoint& p) {
  if (pass.tool) return p.x();
  const double usual = pass.side == TurningSide::Outside ? -1.0 : 1.0;
  return p.x() + pass.noseRadius * (pass.edges.isZero() ? usual : pass.edges.x());
}

// Returns the radius of the drill that makes a move of a pass between two points, mm; 0: another tool.
double drillRadius(const TurningPass& pass, const ProfilePoint& a, const ProfilePoint& b) {
  constexpr double kOnAxis = 1e-9;  // mm
  if (pass.tool) return pass.tool->kind == LatheToolKind::Drill ? pass.tool->reach() : 0.0;
  const bool isOnAxis = std::abs(a.x()) <= kOnAxis && std::abs(b.x()) <= kOnAxis;
  return pass.side == TurningSide::Bore && isOnAxis ? pass.noseRadius : 0.0;
}

}  // namespace

// A short sequence of moves that counts as one cut.
struct TurningReview::Stretch {
  static constexpr double kLongest = 0.5;  // mm; hand movements have steps shorter than the distance of the samples

  double length = 0.0, seconds = 0.0, turns = 0.0, time = 0.0;
  double chip = 0.0;   // mm, the thickest
  double asked = 0.0;  // turns that the spindle would have made at the requested speed
  double axial = 0.0;  // mm, travel along the axis
  double area = 0.0;   // mm², removed area of the section
  TurnedProfile::Range changed;
  double largest = 0.0;  // mm, the largest radius that was cut
  double tip = 0.0;      // mm, the largest radius of the tip of a program's tool; 0: another pass
  bool isDrilling = false;
  ProfilePoint position{0, 0};
};

TurningReview::TurningReview(const TurnedProfile& bar) : m_profile(bar) {
  for (std::size_t i = 0; i < bar.size(); ++i) {
    m_outerRadii.push_back(bar.radius(i));
    m_boreRadii.push_back(bar.inner(i));
  }
}

std::optional<TurningReview> TurningReview::make(const TurnedProfile& bar, Passes passes, const ReviewedLathe& lathe,
                                                 Progress progress, std::shared_ptr<const PartThreads> threads) {
  TurningReview review(bar);
  review.m_threads = std::move(threads);
  FinishMeter meter(bar, SurfaceFinish(bar.size()), lathe.spindleSpeed);
  std::uint64_t work = 0;
  for (const auto& pass : passes) work += samplesUnder(bar, *pass) + pass->path.size();
  if (work > kMostWork) return std::nullopt;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const double from = static_cast<double>(i) / static_cast<double>(passes.size());
    const double to = static_cast<double>(i + 1) / static_cast<double>(passes.size());
    const TurnedProfile before = review.m_profile;
    review.repeat(*passes[i], i, lathe, meter, progress.part(from, to));
    if (progress.cancelled()) return std::nullopt;
    review.follow(settlePass(review.m_profile, before, passes[i], static_cast<std::uint32_t>(i), progress));
    meter.renew(review.m_profile);
  }
  review.m_finish = meter.finish();
  return review;
}

void TurningReview::repeat(const TurningPass& pass, std::size_t number, const ReviewedLathe& lathe, FinishMeter& meter,
                           Progress progress) {
  constexpr std::size_t kLook = 256;  // points between two checks of the cancel flag
  const double start = m_seconds;
  bool wasInChuck = false, wasRapid = false;
  constexpr double kClear = 3.0;  // samples; after a shorter travel without a cut the tool is still in the material
  Stretch cutting;
  ChipGrowth chip;
  double distanceClear = 0.0;         // mm
  std::size_t inJaws = kMostCrashes;  // index of the crash that continues there
  const auto crash = [&](CrashMoment::What what, double time, std::size_t point) {
    if (m_crashes.size() < kMostCrashes) m_crashes.push_back({what, number, time, pass.path[point], 0.0, point, point});
  };
  // A thread is cut at its pitch.
  const bool isThreading = pass.tool && pass.tool->kind == LatheToolKind::Threading;
  const PassSteps steps(pass, static_cast<std::uint32_t>(number));
  for (std::size_t i = 0; i < pass.path.size(); ++i) {
    if (i % kLook == 0 && progress.cancelled()) return;
    const ProfilePoint &from = pass.path[i == 0 ? 0 : i - 1], &to = pass.path[i];
    const double seconds = i == 0 ? 0.0 : pass.times[i] - pass.times[i - 1], distance = (to - from).norm();
    const double time = start + pass.times[i];
    m_pathLength += distance;
    const bool inChuck = isInChuck(pass, to, lathe);
    if (inChuck && !wasInChuck) {
      inJaws = m_crashes.size();
      crash(CrashMoment::What::Chuck, time, i);
    }
    if (inChuck && inJaws < m_crashes.size()) m_crashes[inJaws].last = i;
    wasInChuck = inChuck;

    const double speed = speedAt(pass, i, lathe), share = shareOf(pass, from, to, m_profile.spacing());
    TurnedProfile::Range all;
    double deepest = 0.0;
    for (double done = 0.0; done < 1.0;) {
      const double end = done + 1.01 * share < 1.0 ? done + share : 1.0, part = end - done;
      const bool isWhole = part == 1.0, isAligned = end < 1.0;
      const TurnedProfile::Range changed = steps.cut(m_profile, i, done, end);
      done = end;
      all.extend(changed);
      deepest = std::max(deepest, take(cutting, pass.side, changed));
      distanceClear = changed.isEmpty() ? distanceClear + part * distance : 0.0;
      if (distanceClear > kClear * m_profile.spacing())
        chip.end();
      else if (!changed.isEmpty() || chip.thickness() > 0.0)
        chip.add(part * distance, part * seconds * speed / 60.0);
      if (changed.isEmpty()) {
        endStretch(cutting, number);
        continue;
      }
      cutting.length += part * distance;
      cutting.axial += isAligned || !pass.isExact ? 0.0 : part * std::abs(to.y() - from.y());
      cutting.changed.extend(changed);
      cutting.seconds += part * seconds;
      cutting.turns += part * seconds * speed / 60.0;
      cutting.chip = std::max(cutting.chip, chip.thickness());
      cutting.asked += part * seconds * askedAt(pass, i, speed) / 60.0;
      cutting.time = time - (1.0 - end) * seconds;
      cutting.position = from + end * (to - from);
      if (pass.isOfProgram) {
        for (const double at : {end - part, end})
          cutting.tip = std::max(cutting.tip, std::abs(tipRadius(pass, from + at * (to - from))));
      }
      cutting.isDrilling = drillRadius(pass, from, to) > 0.0;
      if (!isWhole || cutting.length >= Stretch::kLongest) endStretch(cutting, number);
    }
    meter.add(pass, i, static_cast<std::uint32_t>(number), m_profile, all);
    const bool isFast = !isThreading && meter.feed() > (1.0 + kFeedSlack) * lathe.largestFeed;
    const bool isRapid = deepest > TurningPass::kTouch && isFast;
    if (isRapid && !wasRapid) crash(CrashMoment::What::RapidInMaterial, time, i);
    wasRapid = isFast && (isRapid || wasRapid);
    if (isRapid && m_crashes.back().what == CrashMoment::What::RapidInMaterial) {
      m_crashes.back().feed = std::max(m_crashes.back().feed, meter.feed());
      m_crashes.back().last = i;
    }
  }
  endStretch(cutting, number);
  if (pass.thread) addThread(pass, number, lathe);
  if (!pass.times.empty()) m_seconds += pass.times.back();
}

// Adds a cut for each turn of a thread.
void TurningReview::addThread(const TurningPass& pass, std::size_t number, const ReviewedLathe& lathe) {
  constexpr double kMostCuts = 500.0;
  const std::vector<ThreadGroove> grooves = ThreadGroove::of(pass);
  for (std::size_t i = 1; i < pass.path.size() && !grooves.empty(); ++i) {
    const ProfilePoint from = pass.path[i - 1], travel = pass.path[i] - from;
    const double cuts = std::clamp(std::ceil(std::abs(travel.y()) / pass.thread->pitch), 1.0, kMostCuts);
    for (double k = 0.5; k < cuts; k += 1.0) {
      const ProfilePoint at = from + k / cuts * travel;
      const auto groove = std::find_if(grooves.begin(), grooves.end(),
                                       [&](const auto& each) { return each.from() <= at.y() && at.y() <= each.to(); });
      const double sample = std::floor(at.y() / m_profile.spacing());
      if (groove == grooves.end() || !(sample >= 0.0 && sample < static_cast<double>(m_profile.size()))) continue;
      const double radius = sideRadius(m_profile, pass.side, static_cast<std::size_t>(sample));
      if (!m_profile.hasMaterial(static_cast<std::size_t>(sample)) || !(radius > 0.0)) continue;
      const TurnChip chip = chipOf(*groove, m_threads.get(), at.y(), radius);
      if (!(chip.width > 0.0)) continue;
      const double time = m_seconds + std::lerp(pass.times[i - 1], pass.times[i], k / cuts);
      const double thickness = chip.area / chip.width, speed = speedAt(pass, i, lathe);
      m_moments.push_back({number, time, at, chip.width, thickness, thickness, surfaceSpeed(speed, 2.0 * radius),
                           surfaceSpeed(askedAt(pass, i, speed), 2.0 * radius), radius, false});
      if (m_moments.size() >= 2 * kMostMoments) thinMoments();
    }
  }
  m_threads = PartThreads::with(m_threads, pass);
}

void TurningReview::follow(const TurnedProfile::Range& changed) {
  for (std::size_t i = changed.first; i < changed.last; ++i) {
    m_outerRadii[i] = m_profile.radius(i);
    m_boreRadii[i] = m_profile.inner(i);
  }
}

double TurningReview::take(Stretch& stretch, TurningSide side, TurnedProfile::Range changed) {
  double deepest = 0.0;
  std::vector<double>& radii = side == TurningSide::Outside ? m_outerRadii : m_boreRadii;
  for (std::size_t i = changed.first; i < changed.last; ++i) {
    const double before = std::exchange(radii[i], sideRadius(m_profile, side, i));
    const double depth = std::abs(before - radii[i]);
    stretch.area += depth * m_profile.spacing();
    stretch.largest = std::max({stretch.largest, before, radii[i]});
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

// A cut that begins has covered less than a sample, but removes the whole sample. So does one along the axis between
// two samples, by one sample at most.
void TurningReview::endStretch(Stretch& stretch, std::size_t pass) {
  const Stretch done = std::exchange(stretch, Stretch());
  if (!(done.length > 0.0 && done.turns > 0.0)) return;  // work at rest is not cut: that is a crash
  const double feed = done.length / done.turns;
  const double spacing = m_profile.spacing(), samples = static_cast<double>(done.changed.last - done.changed.first);
  const double covered = std::clamp(samples * spacing, done.axial, done.axial + spacing);
  const double longer = 2.0 * done.axial > done.length ? covered / done.axial : 1.0;
  const double depth = done.area / std::max(longer * done.length, spacing);
  const double radius = done.isDrilling ? done.largest - 0.5 * std::min(depth, done.largest) : done.largest;
  // A control holds the surface speed at the tip.
  const double fast = done.tip > 0.0 && !done.isDrilling ? std::min(done.tip, radius) : radius;
  const double perTurn = done.seconds > 0.0 ? 2.0 * M_PI * fast * 60.0 / done.seconds / 1000.0 : 0.0;
  m_moments.push_back({pass, done.time, done.position, depth, feed, std::min(feed, done.chip), perTurn * done.turns,
                       perTurn * std::max(done.asked, done.turns), radius, done.isDrilling});
  if (m_moments.size() >= 2 * kMostMoments) thinMoments();
}

// Keeps the heavier cut of each two neighbours.
void TurningReview::thinMoments() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < m_moments.size(); i += 2) {
    const bool second = i + 1 < m_moments.size() && weightOf(m_moments[i + 1]) > weightOf(m_moments[i]);
    m_moments[kept++] = m_moments[second ? i + 1 : i];
  }
  m_moments.resize(kept);
}

}  // namespace handwheel
