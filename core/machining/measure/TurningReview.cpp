// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/TurningReview.h"

#include "machining/lathe/LatheTool.h"
#include "machining/measure/RoughnessGrade.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace handwheel {

namespace {

constexpr std::size_t kMostCrashes = 1'000;

double sideRadius(const TurnedProfile& profile, TurningSide side, std::size_t i) {
  return side == TurningSide::Outside ? profile.radius(i) : profile.inner(i);
}

// Whether the nose, or the shank that comes to it from outside, is within the jaws.
bool isInChuck(const TurningPass& pass, const ProfilePoint& centre, const ReviewedLathe& lathe) {
  if (!(lathe.chuckHeight > 0.0) || pass.side == TurningSide::Bore) return false;
  const double nose = pass.tool ? 0.0 : pass.noseRadius;  // the path of a tool is that of its tip
  return centre.y() - nose < lathe.chuckHeight && centre.x() - nose < 0.5 * lathe.chuckDiameter;
}

// r/min on the way to a point.
double speedAt(const TurningPass& pass, std::size_t i, const ReviewedLathe& lathe) {
  return i < pass.speeds.size() ? pass.speeds[i] : lathe.spindleSpeed;
}

// The feed: how far the tool went in the last revolution of the spindle while it cut. From point to point the hand and
// the clock of the mouse give anything.
class FeedMeter {
 public:
  void clear() { *this = {}; }
  // Of one more move. way: mm. mm per revolution; infinite while the spindle stands.
  double add(double way, double turns, bool isTurning) {
    if (!isTurning) return way > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
    m_moves.push_back({way, turns});
    m_way += way;
    m_turns += turns;
    while (m_moves.size() > 1 && m_turns - m_moves.front().turns >= 1.0) {
      m_way -= m_moves.front().way;
      m_turns -= m_moves.front().turns;
      m_moves.pop_front();
    }
    return m_moves.size() == 1 && turns >= 1.0 ? way / turns : m_way / std::max(m_turns, 1.0);
  }

 private:
  struct Move {
    double way, turns;
  };
  std::deque<Move> m_moves;
  double m_way = 0.0, m_turns = 0.0;
};

// How much a cut asks of the lathe; only to compare.
double weightOf(const CutMoment& moment) {
  return moment.depth * moment.feed * moment.speed;
}

}  // namespace

// The moves that are taken as one cut.
struct TurningReview::Way {
  static constexpr double kLongest = 0.5;  // mm: hands move in steps that are shorter than the samples are apart

  double length = 0.0, seconds = 0.0, turns = 0.0, time = 0.0;
  double area = 0.0;     // mm², that left the section
  double largest = 0.0;  // mm, the largest radius that was cut
  ProfilePoint place{0, 0};
};

TurningReview::TurningReview(const TurnedProfile& bar) : m_profile(bar), m_outer(bar.size()), m_bore(bar.size()) {
  for (std::size_t i = 0; i < bar.size(); ++i) {
    m_outerRadii.push_back(bar.radius(i));
    m_boreRadii.push_back(bar.inner(i));
  }
}

std::optional<TurningReview> TurningReview::make(const TurnedProfile& bar, Passes passes, const ReviewedLathe& lathe,
                                                 Progress progress) {
  TurningReview review(bar);
  std::uint64_t work = 0;
  for (const auto& pass : passes) work += samplesUnder(bar, *pass) + pass->path.size();
  if (work > kMostWork) return std::nullopt;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const double from = static_cast<double>(i) / static_cast<double>(passes.size());
    const double to = static_cast<double>(i + 1) / static_cast<double>(passes.size());
    review.repeat(*passes[i], i, lathe, progress.part(from, to));
    if (progress.cancelled()) return std::nullopt;
  }
  return review;
}

void TurningReview::repeat(const TurningPass& pass, std::size_t number, const ReviewedLathe& lathe, Progress progress) {
  constexpr std::size_t kLook = 256;  // points between two looks at the cancel flag
  const double start = m_seconds;
  bool wasInChuck = false, wasRapid = false;
  Way cutting;
  FeedMeter meter;
  const auto crash = [&](CrashMoment::What what, double time, const ProfilePoint& place) {
    if (m_crashes.size() < kMostCrashes) m_crashes.push_back({what, number, time, place});
  };
  // A thread is cut at its pitch.
  const bool isThreading = pass.tool && pass.tool->kind == LatheToolKind::Threading;
  for (std::size_t i = 0; i < pass.path.size(); ++i) {
    if (i % kLook == 0 && progress.cancelled()) return;
    const ProfilePoint &from = pass.path[i == 0 ? 0 : i - 1], &to = pass.path[i];
    const double seconds = i == 0 ? 0.0 : pass.times[i] - pass.times[i - 1], way = (to - from).norm();
    const double time = start + pass.times[i];
    m_pathLength += way;
    const bool inChuck = isInChuck(pass, to, lathe);
    if (inChuck && !wasInChuck) crash(CrashMoment::What::Chuck, time, to);
    wasInChuck = inChuck;

    const TurnedProfile::Range changed = cut(m_profile, pass, from, to);
    const double speed = speedAt(pass, i, lathe), turns = seconds * speed / 60.0;
    if (changed.isEmpty()) meter.clear();
    const double feed = changed.isEmpty() ? 0.0 : meter.add(way, turns, speed > 0.0);
    const bool isRapid = !isThreading && feed > lathe.largestFeed;
    if (isRapid && !wasRapid) crash(CrashMoment::What::RapidInMaterial, time, to);
    wasRapid = isRapid;
    if (changed.isEmpty()) {
      endWay(cutting);
      continue;
    }
    leave(pass, changed, feed);
    cutting.length += way;
    cutting.seconds += seconds;
    cutting.turns += turns;
    cutting.time = time;
    cutting.place = to;
    take(cutting, pass.side, changed);
    if (cutting.length >= Way::kLongest) endWay(cutting);
  }
  endWay(cutting);
  if (!pass.times.empty()) m_seconds += pass.times.back();
}

// A cut leaves what its feed and nose leave. An abrasive takes the crests off: the cusps of a nose are four times as
// high as their Ra, f²/(8 R) and f²/(32 R), and once as much has gone, the surface is that of the abrasive.
void TurningReview::leave(const TurningPass& pass, TurnedProfile::Range changed, double feed) {
  constexpr double kMicrometres = 1e3, kHeightOfRa = 4.0;
  std::vector<SampleFinish>& finish = pass.side == TurningSide::Outside ? m_outer : m_bore;
  const std::vector<double>& before = pass.side == TurningSide::Outside ? m_outerRadii : m_boreRadii;
  if (pass.tool && pass.tool->isAbrasive()) {
    for (std::size_t k = changed.first; k < changed.last; ++k) {
      const double gone = kMicrometres * std::abs(before[k] - sideRadius(m_profile, pass.side, k));
      if (finish[k].isCut)
        finish[k].roughness = std::max(pass.tool->leastRoughness, finish[k].roughness - gone / kHeightOfRa);
    }
    return;
  }
  const double left = idealRoughness(feed, pass.tool ? pass.tool->noseRadius : pass.noseRadius);
  for (std::size_t k = changed.first; k < changed.last; ++k) finish[k] = {left, true};
}

void TurningReview::take(Way& way, TurningSide side, TurnedProfile::Range changed) {
  std::vector<double>& radii = side == TurningSide::Outside ? m_outerRadii : m_boreRadii;
  for (std::size_t i = changed.first; i < changed.last; ++i) {
    const double before = std::exchange(radii[i], sideRadius(m_profile, side, i));
    way.area += std::abs(before - radii[i]) * m_profile.spacing();
    way.largest = std::max({way.largest, before, radii[i]});
  }
}

void TurningReview::endWay(Way& way) {
  const Way done = std::exchange(way, Way());
  if (!(done.length > 0.0)) return;
  const double feed = done.length / done.turns;
  const double speed =
      done.seconds > 0.0 ? 2.0 * M_PI * done.largest * (60.0 * done.turns / done.seconds) / 1000.0 : 0.0;
  m_moments.push_back({done.time, done.place, done.area / done.length, feed, speed});
  if (m_moments.size() >= 2 * kMostMoments) thinMoments();
}

// Of each two neighbours the heavier cut stays.
void TurningReview::thinMoments() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < m_moments.size(); i += 2) {
    const bool second = i + 1 < m_moments.size() && weightOf(m_moments[i + 1]) > weightOf(m_moments[i]);
    m_moments[kept++] = m_moments[second ? i + 1 : i];
  }
  m_moments.resize(kept);
}

std::optional<FinishReading> TurningReview::finish(TurningSide side, AxisRange range) const {
  constexpr double kMayBeRougher = 0.16;
  const std::vector<SampleFinish>& finish = side == TurningSide::Outside ? m_outer : m_bore;
  FinishReading reading;
  std::vector<double> all;
  for (std::size_t i = 0; i < finish.size(); ++i) {
    const double z = m_profile.z(i);
    if (!(z >= range.from && z <= range.to)) continue;
    if (!finish[i].isCut) return std::nullopt;
    all.push_back(finish[i].roughness);
    if (all.back() > reading.largest) reading.largest = all.back(), reading.largestAt = z;
  }
  if (all.empty()) return std::nullopt;
  const auto rougher = static_cast<std::size_t>(kMayBeRougher * static_cast<double>(all.size()));
  const auto read = all.end() - 1 - static_cast<std::ptrdiff_t>(rougher);
  std::nth_element(all.begin(), read, all.end());
  reading.roughness = *read;
  return reading;
}

}  // namespace handwheel
