// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/time/TimeAxis.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

bool isFinite(const QPointF& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y());
}

// Returns the points from the beginning to the end of a recording, ascending in both; decreasing ones are left out.
std::vector<QPointF> ascending(const std::vector<QPointF>& points, double duration) {
  std::vector<QPointF> kept;
  for (const QPointF& p : points) {
    if (!isFinite(p) || p.x() < 0.0 || p.x() > duration) continue;
    if (kept.empty() || (p.x() >= kept.back().x() && p.y() >= kept.back().y())) kept.push_back(p);
  }
  return kept;
}

double between(double from, double to, double share) {
  return from + (to - from) * share;
}

}  // namespace

void TimeAxis::setRecordings(const std::vector<TimeLineRecording>& recordings) {
  m_lanes.clear();
  for (const TimeLineRecording& recording : recordings) {
    const double duration = std::isfinite(recording.duration) ? std::max(0.0, recording.duration) : 0.0;
    m_lanes.push_back({duration, ascending(recording.distance, duration)});
  }
  setKind(m_kind);
}

bool TimeAxis::hasDistance() const {
  const auto isKnown = [](const Lane& lane) {
    return lane.distance.size() > 1 && lane.distance.back().y() > lane.distance.front().y();
  };
  return !m_lanes.empty() && std::all_of(m_lanes.begin(), m_lanes.end(), isKnown);
}

double TimeAxis::length(std::size_t recording) const {
  const Lane& lane = m_lanes[recording];
  return m_kind == Kind::Time ? lane.duration : lane.distance.back().y() - lane.distance.front().y();
}

double TimeAxis::length() const {
  double longest = 0.0;
  for (std::size_t i = 0; i < m_lanes.size(); ++i) longest = std::max(longest, length(i));
  return longest;
}

double TimeAxis::timeAt(std::size_t recording, double position) const {
  const Lane& lane = m_lanes[recording];
  if (m_kind == Kind::Time) return std::clamp(position, 0.0, lane.duration);
  const double distance = lane.distance.front().y() + position;
  const auto after = std::lower_bound(lane.distance.begin(), lane.distance.end(), distance,
                                      [](const QPointF& p, double value) { return p.y() < value; });
  if (after == lane.distance.end()) return lane.duration;
  if (after == lane.distance.begin()) return after->x();
  const QPointF& before = *(after - 1);
  return between(before.x(), after->x(), (distance - before.y()) / (after->y() - before.y()));
}

double TimeAxis::positionAt(std::size_t recording, double time) const {
  const Lane& lane = m_lanes[recording];
  if (m_kind == Kind::Time) return std::clamp(time, 0.0, lane.duration);
  const auto after = std::upper_bound(lane.distance.begin(), lane.distance.end(), time,
                                      [](double value, const QPointF& p) { return value < p.x(); });
  const double start = lane.distance.front().y();
  if (after == lane.distance.begin()) return 0.0;
  if (after == lane.distance.end()) return lane.distance.back().y() - start;
  const QPointF& before = *(after - 1);
  return between(before.y(), after->y(), (time - before.x()) / (after->x() - before.x())) - start;
}

std::vector<QPointF> thinnedCurve(const std::vector<QPointF>& points, std::size_t most) {
  std::vector<QPointF> sound;
  sound.reserve(points.size());
  std::copy_if(points.begin(), points.end(), std::back_inserter(sound), isFinite);
  const std::size_t groups = std::max<std::size_t>(1, most / 4);
  if (sound.size() <= 4 * groups) return sound;
  std::vector<QPointF> kept;
  const auto lower = [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); };
  for (std::size_t group = 0; group < groups; ++group) {
    const auto first = sound.begin() + static_cast<std::ptrdiff_t>(group * sound.size() / groups);
    const auto end = sound.begin() + static_cast<std::ptrdiff_t>((group + 1) * sound.size() / groups);
    const auto [least, largest] = std::minmax_element(first, end, lower);
    // The first and the last are kept, too: a group that rises or falls keeps its ends.
    for (auto at : {first, std::min(least, largest), std::max(least, largest), end - 1}) {
      if (kept.empty() || kept.back() != *at) kept.push_back(*at);
    }
  }
  return kept;
}

}  // namespace handwheel
