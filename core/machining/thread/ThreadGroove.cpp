// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/thread/ThreadGroove.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kSameBottom = 1e-4;  // mm; tolerance of points that are left out of a recorded path

// Returns the vector from the middle of the nose, or the tip of a lathe's tool, to the bottom of the groove.
ProfilePoint toBottom(const TurningPass& pass) {
  const double away = pass.side == TurningSide::Bore ? pass.noseRadius : -pass.noseRadius;
  const ProfilePoint centre = pass.tool ? pass.tool->noseCentre() : ProfilePoint(0.0, 0.0);
  return centre + ProfilePoint(away, 0.0);
}

// Returns the parts of a path with one direction along z, each rising.
std::vector<std::vector<ProfilePoint>> runsOf(const std::vector<ProfilePoint>& path, const ProfilePoint& shift) {
  std::vector<std::vector<ProfilePoint>> runs;
  int direction = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double along = path[i].y() - path[i - 1].y();
    if (!path[i].allFinite() || !path[i - 1].allFinite() || along == 0.0) continue;
    const int is = along > 0.0 ? 1 : -1;
    if (is != direction || runs.back().back() != path[i - 1] + shift) runs.push_back({path[i - 1] + shift});
    direction = is;
    runs.back().push_back(path[i] + shift);
  }
  for (auto& run : runs) {
    if (run.front().y() > run.back().y()) std::reverse(run.begin(), run.end());
  }
  return runs;
}

bool isStraight(const std::vector<ProfilePoint>& line, std::size_t from, std::size_t to) {
  for (std::size_t k = from + 1; k < to; ++k) {
    const double t = (line[k].y() - line[from].y()) / (line[to].y() - line[from].y());
    if (std::abs(std::lerp(line[from].x(), line[to].x(), t) - line[k].x()) > kSameBottom) return false;
  }
  return true;
}

std::vector<ProfilePoint> thinned(const std::vector<ProfilePoint>& line) {
  constexpr std::size_t kLongest = 256;  // points; keeps the search short
  std::vector<ProfilePoint> kept{line.front()};
  std::size_t from = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (i + 1 - from < kLongest && isStraight(line, from, i + 1)) continue;
    kept.push_back(line[i]);
    from = i;
  }
  kept.push_back(line.back());
  return kept;
}

}  // namespace

ThreadGroove::ThreadGroove(const TurningPass& pass, std::vector<ProfilePoint> bottom)
    : m_cut(*pass.thread),
      m_side(pass.side),
      m_nose(pass.noseRadius),
      m_edge(m_cut, m_nose),
      m_bottom(std::move(bottom)) {
  const auto [least, largest] = std::minmax_element(
      m_bottom.begin(), m_bottom.end(), [](const ProfilePoint& a, const ProfilePoint& b) { return a.x() < b.x(); });
  m_deepest = m_side == TurningSide::Bore ? largest->x() : least->x();
}

std::vector<ThreadGroove> ThreadGroove::of(const TurningPass& pass) {
  std::vector<ThreadGroove> grooves;
  if (!pass.thread || !pass.thread->isSound()) return grooves;
  for (const auto& run : runsOf(pass.path, toBottom(pass))) {
    std::vector<ProfilePoint> bottom = thinned(run);
    const double turns = (bottom.back().y() - bottom.front().y()) / pass.thread->pitch;
    if (bottom.size() <= kMostBottoms && turns <= kMostTurns) grooves.push_back(ThreadGroove(pass, std::move(bottom)));
  }
  return grooves;
}

double ThreadGroove::bottomAt(double z) const {
  const auto next = std::lower_bound(m_bottom.begin(), m_bottom.end(), z,
                                     [](const ProfilePoint& p, double at) { return p.y() < at; });
  if (next != m_bottom.begin() && next != m_bottom.end()) {
    const ProfilePoint &a = next[-1], &b = *next;
    return std::lerp(a.x(), b.x(), (z - a.y()) / (b.y() - a.y()));
  }
  const ProfilePoint& end = next == m_bottom.end() ? m_bottom.back() : m_bottom.front();
  const double beyond = std::abs(z - end.y()), runOut = kRunOut * m_cut.lead();
  if (beyond > runOut) return m_side == TurningSide::Bore ? 0.0 : std::numeric_limits<double>::infinity();
  const double rise = m_cut.pitch * beyond / runOut;  // exceeds the height of any thread of 60°
  return m_side == TurningSide::Bore ? end.x() - rise : end.x() + rise;
}

double ThreadGroove::radius(double z, double angle) const {
  const bool isBore = m_side == TurningSide::Bore;
  double best = isBore ? 0.0 : std::numeric_limits<double>::infinity();
  const double above = z - m_cut.offset - m_cut.rise() * angle / (2.0 * M_PI);
  const double nearest = std::round(above / m_cut.pitch);
  for (const double groove : {nearest - 1.0, nearest, nearest + 1.0}) {
    const double distance = above - groove * m_cut.pitch;
    const double bottom = bottomAt(z - distance), height = m_edge.heightAt(distance);
    best = isBore ? std::max(best, bottom - height) : std::min(best, bottom + height);
  }
  return best;
}

bool ThreadGroove::touches(const TurnedProfile& profile) const {
  const double spacing = profile.spacing(), last = static_cast<double>(profile.size() - 1);
  const double first = std::clamp(std::ceil(from() / spacing), 0.0, last), end = std::min(to() / spacing, last);
  for (auto i = static_cast<std::size_t>(first); static_cast<double>(i) <= end; ++i) {
    const double bottom = bottomAt(profile.z(i));
    const bool isBelow = m_side == TurningSide::Bore ? bottom > profile.inner(i) : bottom < profile.radius(i);
    if (isBelow && profile.hasMaterial(i)) return true;
  }
  return false;
}

bool ThreadGroove::isWithin(const ThreadGroove& other) const {
  constexpr double kShare = 1e-6;
  const bool isSameForm = m_cut.pitch == other.m_cut.pitch && m_cut.starts == other.m_cut.starts &&
                          m_cut.isLeft == other.m_cut.isLeft && m_cut.angle == other.m_cut.angle &&
                          m_cut.flat == other.m_cut.flat && m_side == other.m_side && m_nose == other.m_nose;
  if (!isSameForm) return false;
  const double apart = m_cut.offset - other.m_cut.offset;
  const double shift = apart - m_cut.pitch * std::round(apart / m_cut.pitch), aside = std::abs(shift);
  if (from() - shift < other.from() - aside - kShare || to() - shift > other.to() + aside + kShare) return false;
  // It is within if it is displaced by no more than its flanks lie within those of the other one, all along.
  const double out = m_side == TurningSide::Bore ? -1.0 : 1.0;
  const auto isBelow = [&](double bottom, double z) {
    const double beside = std::clamp(z - shift, other.from(), other.to());
    const double higher = out * (bottom - other.bottomAt(beside));
    return higher >= 0.0 && aside <= higher * std::tan(0.5 * m_cut.angle) + kShare * m_cut.pitch;
  };
  const auto isOwnBelow = [&](const ProfilePoint& p) { return isBelow(p.x(), p.y()); };
  const auto isBelowAt = [&](const ProfilePoint& p) {
    const double z = p.y() + shift;
    return z < from() || z > to() || isBelow(bottomAt(z), z);
  };
  return std::all_of(m_bottom.begin(), m_bottom.end(), isOwnBelow) &&
         std::all_of(other.m_bottom.begin(), other.m_bottom.end(), isBelowAt);
}

}  // namespace handwheel
