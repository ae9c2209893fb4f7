// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/TimedRun.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

// The points of a run without motions in which nothing moves.
struct Moving {
  std::vector<ArmValues> points;
  std::vector<double> extents, zones;
};

Moving movingOf(std::span<const ArmValues> points, std::span<const double> extents, std::span<const double> zones) {
  Moving moving{{points.front()}, {}, {}};
  for (std::size_t i = 0; i < extents.size(); ++i) {
    if (!(extents[i] > 0.0)) continue;
    moving.points.push_back(points[i + 1]);
    moving.extents.push_back(extents[i]);
    moving.zones.push_back(i < zones.size() ? zones[i] : 0.0);
  }
  return moving;
}

// Returns the largest share of the limits that a joint reaches, squared for accelerations and so on.
double largestRatio(const ArmValues& reached, const ArmValues& most) {
  return reached.size() == 0 ? 0.0 : (reached.array().abs() / most.array()).maxCoeff();
}

}  // namespace

// A cubic spline through the points, without curvature at its ends.
std::vector<TimedRun::Piece> TimedRun::smoothPieces(std::span<const ArmValues> points,
                                                    std::span<const double> extents) {
  const std::size_t count = extents.size();
  std::vector<ArmValues> slopes, seconds(count + 1, ArmValues::Zero(points[0].size()));
  for (std::size_t i = 0; i < count; ++i) slopes.emplace_back((points[i + 1] - points[i]) / extents[i]);
  // Elimination in the tridiagonal equations of the second derivatives.
  std::vector<double> above(count + 1, 0.0);
  for (std::size_t i = 1; i < count; ++i) {
    const double pivot = 2.0 * (extents[i - 1] + extents[i]) - extents[i - 1] * above[i - 1];
    above[i] = extents[i] / pivot;
    seconds[i] = (6.0 * (slopes[i] - slopes[i - 1]) - extents[i - 1] * seconds[i - 1]) / pivot;
  }
  for (std::size_t i = count; i-- > 1;) seconds[i] -= above[i] * seconds[i + 1];
  std::vector<Piece> pieces;
  double begin = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    pieces.push_back({begin, points[i], slopes[i] - extents[i] / 6.0 * (2.0 * seconds[i] + seconds[i + 1]), seconds[i],
                      (seconds[i + 1] - seconds[i]) / extents[i]});
    begin += extents[i];
  }
  return pieces;
}

TimedRun TimedRun::stopping(std::span<const ArmValues> points, std::span<const double> extents, double speed,
                            const JointRates& most) {
  TimedRun run;
  const Moving moving = movingOf(points, extents, {});
  if (moving.extents.empty()) {
    const ArmValues still = ArmValues::Zero(points[0].size());
    run.m_pieces.push_back({0.0, points[0], still, still, still});
    return run;
  }
  run.m_pieces = smoothPieces(moving.points, moving.extents);
  // The largest derivatives of each joint: the first is quadratic in a piece, and the second linear.
  ArmValues first = ArmValues::Zero(points[0].size()), second = first, third = first;
  for (std::size_t i = 0; i < run.m_pieces.size(); ++i) {
    const Piece& piece = run.m_pieces[i];
    const double extent = moving.extents[i];
    run.m_extent += extent;
    const ArmValues after = piece.second + extent * piece.third;
    second = second.cwiseMax(piece.second.cwiseAbs()).cwiseMax(after.cwiseAbs());
    third = third.cwiseMax(piece.third.cwiseAbs());
    for (Eigen::Index k = 0; k < first.size(); ++k) {
      const auto at = [&](double x) {
        return std::abs(piece.first[k] + x * (piece.second[k] + 0.5 * x * piece.third[k]));
      };
      const double turn = piece.third[k] != 0.0 ? std::clamp(-piece.second[k] / piece.third[k], 0.0, extent) : 0.0;
      first[k] = std::max({first[k], at(0.0), at(turn), at(extent)});
    }
  }
  double velocity = std::min(speed, 1.0 / largestRatio(first, most.velocity));
  double acceleration = 1.0 / largestRatio(first, most.acceleration), jerk = 1.0 / largestRatio(first, most.jerk);
  // Along curves joints accelerate at an even speed, too: all of it is made slower in time.
  const ArmValues turning = velocity * velocity * second + acceleration * first;
  const ArmValues jerking =
      velocity * velocity * velocity * third + 3.0 * velocity * acceleration * second + jerk * first;
  const double slower =
      std::max({1.0, std::sqrt(largestRatio(turning, most.acceleration)), std::cbrt(largestRatio(jerking, most.jerk))});
  velocity /= slower;
  acceleration /= slower * slower;
  jerk /= slower * slower * slower;
  run.m_profile = RestToRest(run.m_extent, velocity, acceleration, jerk);
  return run;
}

TimedRun TimedRun::blended(std::span<const ArmValues> points, std::span<const double> extents,
                           std::span<const double> zones, const JointRates& most) {
  Moving moving = movingOf(points, extents, zones);
  if (moving.extents.size() < 2) return stopping(points, extents, 1.0, most);
  // The polygon whose corners are rounded: points of lines within a zone are left out, as the corner passes them by.
  std::vector<ArmValues> nodes{moving.points.front()};
  std::vector<double> at{0.0}, widths{0.0};
  constexpr double kOfZone = 0.9;  // the rest is for the kink where the zone begins
  double extent = 0.0, leftOutTo = 0.0;
  const auto add = [&](const ArmValues& node, double where, double width) {
    nodes.push_back(node);
    at.push_back(where);
    widths.push_back(width);
  };
  std::vector<double> begins{0.0};
  for (const double each : moving.extents) begins.push_back(begins.back() + each);
  const auto valuesAt = [&](double where) {
    const auto i =
        static_cast<std::size_t>(std::upper_bound(begins.begin() + 1, begins.end() - 1, where) - begins.begin() - 1);
    return ArmValues(moving.points[i] +
                     (where - begins[i]) / moving.extents[i] * (moving.points[i + 1] - moving.points[i]));
  };
  for (std::size_t i = 0; i < moving.extents.size(); ++i) {
    extent += moving.extents[i];
    const double zone = i + 1 < moving.extents.size() ? moving.zones[i] : 0.0;
    if (zone > 0.0) {
      while (nodes.size() > 1 && at.back() > extent - zone * (1.0 + 1e-9) && widths.back() == 0.0) {
        nodes.pop_back();
        at.pop_back();
        widths.pop_back();
      }
      if (extent - zone > at.back() + 1e-9 * zone) add(valuesAt(extent - zone), extent - zone, 0.0);
      add(moving.points[i + 1], extent, kOfZone * zone);
      add(valuesAt(extent + zone), extent + zone, 0.0);
      leftOutTo = extent + zone * (1.0 + 1e-9);
    } else if (extent > leftOutTo || i + 1 == moving.extents.size()) {
      if (i + 1 == moving.extents.size() && extent <= at.back() * (1.0 + 1e-12)) continue;
      add(moving.points[i + 1], extent, 0.0);
    }
  }
  std::vector<bool> isZone;
  for (const double width : widths) isZone.push_back(width > 0.0);
  // Points without a zone are rounded as far as their neighbours leave room.
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    if (widths[i] > 0.0) continue;
    const auto roomTo = [&](std::size_t other) {
      const double apart = std::abs(at[other] - at[i]);
      return other > 0 && other + 1 < nodes.size() && widths[other] > 0.0 && widths[other] > 0.5 * apart
                 ? apart - widths[other]
                 : 0.5 * apart;
    };
    widths[i] = std::min(roomTo(i - 1), roomTo(i + 1));
  }
  TimedRun run;
  std::vector<double> ends, fastest;
  const ArmValues still = ArmValues::Zero(points[0].size());
  ArmValues before = nodes.front();
  double begin = 0.0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const ArmValues slope = (nodes[i] - nodes[i - 1]) / (at[i] - at[i - 1]);
    const double width = i + 1 < nodes.size() ? widths[i] : 0.0;
    const double straightTo = at[i] - width;
    if (straightTo > begin) {
      run.m_pieces.push_back({begin, before, slope, still, still});
      ends.push_back(straightTo);
      fastest.push_back(1.0);
      before += (straightTo - begin) * slope;
      begin = straightTo;
    }
    if (!(width > 0.0)) continue;
    const ArmValues next = (nodes[i + 1] - nodes[i]) / (at[i + 1] - at[i]);
    run.m_pieces.push_back({begin, before, slope, (next - slope) / (2.0 * width), still});
    ends.push_back(at[i] + width);
    // In a corner the direction changes no faster than the jerks allow: a change of d takes 2 √(d / jerk) at least.
    const bool isCorner = isZone[i];
    fastest.push_back(isCorner ? std::cbrt(width * width / std::max(1e-12, largestRatio(next - slope, most.jerk)))
                               : 1.0);
    before = nodes[i] + width * next;
    begin = at[i] + width;
  }
  run.m_extent = begin;
  run.findSpeeds(ends, fastest, most);
  return run;
}

// The largest speed at each point of a grid, forwards and backwards, with velocities and accelerations within the
// limits. In a rounded corner half of the acceleration is for the direction, at the largest speed there.
void TimedRun::findSpeeds(std::span<const double> ends, std::span<const double> fastest, const JointRates& most) {
  constexpr std::size_t kMostPoints = 20'000;
  const std::size_t parts = std::clamp<std::size_t>(kMostPoints / ends.size(), 1, 32);
  struct Limits {
    double squaredSpeed, acceleration;
  };
  std::vector<Limits> limits;  // limits of each part of the grid
  m_grid.push_back({0.0, 0.0, 0.0});
  for (std::size_t i = 0; i < m_pieces.size(); ++i) {
    const Piece& piece = m_pieces[i];
    const double length = ends[i] - piece.begin;
    const ArmValues after = piece.first + length * piece.second;
    const ArmValues first = piece.first.cwiseAbs().cwiseMax(after.cwiseAbs()), second = piece.second.cwiseAbs();
    constexpr double kNothing = 1e-12;
    const double velocity = std::min({1.0, fastest[i], 1.0 / std::max(kNothing, largestRatio(first, most.velocity))});
    const double squared =
        std::min(velocity * velocity, 0.5 / std::max(kNothing, largestRatio(second, most.acceleration)));
    double acceleration = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < first.size(); ++k) {
      if (first[k] > kNothing)
        acceleration = std::min(acceleration, (most.acceleration[k] - second[k] * squared) / first[k]);
    }
    for (std::size_t part = 1; part <= parts; ++part) {
      m_grid.push_back({piece.begin + length * static_cast<double>(part) / static_cast<double>(parts), 0.0, 0.0});
      limits.push_back({squared, std::min(acceleration, 1e12)});
    }
  }
  const auto reached = [&](std::size_t part, double from) {
    return std::min(limits[part].squaredSpeed,
                    from + 2.0 * limits[part].acceleration * (m_grid[part + 1].extent - m_grid[part].extent));
  };
  for (std::size_t i = 1; i + 1 < m_grid.size(); ++i)
    m_grid[i].squaredSpeed = std::min(limits[i].squaredSpeed, reached(i - 1, m_grid[i - 1].squaredSpeed));
  for (std::size_t i = m_grid.size() - 1; i-- > 1;)
    m_grid[i].squaredSpeed = std::min(m_grid[i].squaredSpeed, reached(i, m_grid[i + 1].squaredSpeed));
  for (std::size_t i = 1; i < m_grid.size(); ++i) {
    const double speeds = std::sqrt(m_grid[i - 1].squaredSpeed) + std::sqrt(m_grid[i].squaredSpeed);
    m_grid[i].time = m_grid[i - 1].time + 2.0 * (m_grid[i].extent - m_grid[i - 1].extent) / speeds;
  }
}

double TimedRun::extentAt(double time) const {
  if (m_grid.empty()) return m_profile.at(time);
  if (!(time > 0.0)) return 0.0;
  if (time >= duration()) return m_extent;
  const auto after = std::upper_bound(m_grid.begin() + 1, m_grid.end() - 1, time,
                                      [](double t, const GridPoint& point) { return t < point.time; });
  const GridPoint &from = *(after - 1), &to = *after;
  const double passed = time - from.time, speed = std::sqrt(from.squaredSpeed);
  const double acceleration = (to.squaredSpeed - from.squaredSpeed) / (2.0 * (to.extent - from.extent));
  return std::clamp(from.extent + passed * (speed + 0.5 * acceleration * passed), from.extent, to.extent);
}

double TimedRun::timeOf(double extent) const {
  if (m_grid.empty()) return m_profile.timeOf(extent);
  if (extent >= m_extent) return duration();
  const auto after = std::upper_bound(m_grid.begin() + 1, m_grid.end() - 1, extent,
                                      [](double e, const GridPoint& point) { return e < point.extent; });
  const GridPoint &from = *(after - 1), &to = *after;
  const double passed = std::max(0.0, extent - from.extent);
  if (!(passed > 0.0)) return from.time;
  const double acceleration = (to.squaredSpeed - from.squaredSpeed) / (2.0 * (to.extent - from.extent));
  const double squared = std::max(0.0, from.squaredSpeed + 2.0 * acceleration * passed);
  return from.time + 2.0 * passed / (std::sqrt(from.squaredSpeed) + std::sqrt(squared));
}

ArmValues TimedRun::valuesAt(double extent) const {
  const auto after = std::upper_bound(m_pieces.begin() + 1, m_pieces.end(), extent,
                                      [](double e, const Piece& piece) { return e < piece.begin; });
  const Piece& piece = *(after - 1);
  const double x = extent - piece.begin;
  return piece.value + x * (piece.first + 0.5 * x * (piece.second + x / 3.0 * piece.third));
}

}  // namespace handwheel
