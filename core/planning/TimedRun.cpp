// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/TimedRun.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace handwheel {

namespace {

constexpr double kNothing = 1e-12;

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

// The largest derivatives of the joints along a curve, by its extent.
struct Derivatives {
  ArmValues first, second, third;
};

// Returns the fastest motion from rest to rest along a curve that keeps all rates. Along curves joints accelerate at an
// even speed, too: with speed v, acceleration a and jerk j of the extent, a joint has at most a first + v² second, and
// j first + 3 v a second + v³ third. The most that a joint may have is divided among these: lower speeds and
// accelerations leave more for the others.
RestToRest fastestProfile(double extent, double speed, const Derivatives& most, const JointRates& rates) {
  constexpr int kMostSpeeds = 40, kAccelerations = 12;
  constexpr double kSlower = 0.85;
  const auto fastest = std::min(speed, 1.0 / largestRatio(most.first, rates.velocity));
  const bool isStraight = most.second.isZero(0.0) && most.third.isZero(0.0);
  std::optional<RestToRest> best;
  double velocity = fastest;
  for (int i = 0; i < kMostSpeeds; ++i, velocity *= kSlower) {
    double hardest = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < most.first.size(); ++k) {
      const double left = rates.acceleration[k] - velocity * velocity * most.second[k];
      hardest = std::min(hardest, left <= 0.0 ? 0.0 : left / std::max(most.first[k], kNothing));
    }
    const double before = best ? best->duration() : std::numeric_limits<double>::infinity();
    for (int n = 0; n < (isStraight ? 1 : kAccelerations) && hardest > 0.0; ++n, hardest *= kSlower) {
      double jerk = std::numeric_limits<double>::infinity();
      for (Eigen::Index k = 0; k < most.first.size(); ++k) {
        const double left =
            rates.jerk[k] - velocity * (3.0 * hardest * most.second[k] + velocity * velocity * most.third[k]);
        jerk = std::min(jerk, left <= 0.0 ? 0.0 : left / std::max(most.first[k], kNothing));
      }
      if (!(jerk > 0.0)) continue;
      const RestToRest motion(extent, velocity, hardest, jerk);
      if (!best || motion.duration() < best->duration()) best = motion;
    }
    if (isStraight || (best && best->duration() >= before)) break;
  }
  if (best) return *best;
  // All of it is made slower in time.
  const double acceleration = 1.0 / largestRatio(most.first, rates.acceleration);
  const double jerk = 1.0 / largestRatio(most.first, rates.jerk);
  const ArmValues turning = fastest * fastest * most.second + acceleration * most.first;
  const ArmValues jerking =
      fastest * (fastest * fastest * most.third + 3.0 * acceleration * most.second) + jerk * most.first;
  const double slower = std::max(
      {1.0, std::sqrt(largestRatio(turning, rates.acceleration)), std::cbrt(largestRatio(jerking, rates.jerk))});
  return {extent, fastest / slower, acceleration / (slower * slower), jerk / (slower * slower * slower)};
}

// Returns the mean acceleration of a ramp from rest to a speed that keeps acceleration and jerk.
double meanAcceleration(double speed, double acceleration, double jerk) {
  if (!(acceleration * acceleration < speed * jerk)) return 0.5 * std::sqrt(speed * jerk);
  return speed / (speed / acceleration + acceleration / jerk);
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
  run.m_profile = fastestProfile(run.m_extent, speed, {first, second, third}, most);
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

// The largest speed along the run, forwards and backwards, with velocities and accelerations within the limits. In a
// rounded corner half of the acceleration is for the direction, at the largest speed there. Ramps take as long as those
// that keep the jerk, so that a path with blends is no faster than a line without corners.
void TimedRun::findSpeeds(std::span<const double> ends, std::span<const double> fastest, const JointRates& most) {
  constexpr double kUnlimited = 1e12;
  struct Limits {
    double length, squaredSpeed, acceleration;
  };
  std::vector<Limits> limits;  // one for each piece
  for (std::size_t i = 0; i < m_pieces.size(); ++i) {
    const Piece& piece = m_pieces[i];
    const double length = ends[i] - piece.begin;
    const ArmValues after = piece.first + length * piece.second;
    const ArmValues first = piece.first.cwiseAbs().cwiseMax(after.cwiseAbs()), second = piece.second.cwiseAbs();
    const double velocity = std::min({1.0, fastest[i], 1.0 / std::max(kNothing, largestRatio(first, most.velocity))});
    const double squared =
        std::min(velocity * velocity, 0.5 / std::max(kNothing, largestRatio(second, most.acceleration)));
    double acceleration = kUnlimited, jerk = kUnlimited;
    for (Eigen::Index k = 0; k < first.size(); ++k) {
      if (!(first[k] > kNothing)) continue;
      acceleration = std::min(acceleration, (most.acceleration[k] - second[k] * squared) / first[k]);
      jerk = std::min(jerk, most.jerk[k] / first[k]);
    }
    acceleration = std::min(acceleration, meanAcceleration(std::sqrt(squared), acceleration, jerk));
    limits.push_back({length, squared, acceleration});
  }
  std::vector<double> squared(limits.size() + 1, 0.0);  // squared speeds where pieces meet
  const auto reached = [&](std::size_t i, double from) {
    return std::min(limits[i].squaredSpeed, from + 2.0 * limits[i].acceleration * limits[i].length);
  };
  for (std::size_t i = 1; i < limits.size(); ++i)
    squared[i] = std::min(limits[i].squaredSpeed, reached(i - 1, squared[i - 1]));
  for (std::size_t i = limits.size(); i-- > 1;) squared[i] = std::min(squared[i], reached(i, squared[i + 1]));
  m_speeds.push_back({0.0, 0.0, 0.0});
  const auto add = [&](double extent, double squaredSpeed) {
    const SpeedPoint& last = m_speeds.back();
    const double speeds = std::sqrt(last.squaredSpeed) + std::sqrt(squaredSpeed);
    if (extent > last.extent && speeds > 0.0)
      m_speeds.push_back({extent, squaredSpeed, last.time + 2.0 * (extent - last.extent) / speeds});
  };
  for (std::size_t i = 0; i < limits.size(); ++i) {
    // Up to the largest speed and down from it, or up and down to where the ramps meet.
    const auto& [length, largest, acceleration] = limits[i];
    const double begin = m_pieces[i].begin, from = squared[i], to = squared[i + 1];
    const double up = (largest - from) / (2.0 * acceleration), down = (largest - to) / (2.0 * acceleration);
    if (up + down <= length) {
      add(begin + up, largest);
      add(begin + length - down, largest);
    } else {
      const double meet = std::clamp(0.5 * (length + (to - from) / (2.0 * acceleration)), 0.0, length);
      add(begin + meet, std::min(largest, from + 2.0 * acceleration * meet));
    }
    add(ends[i], to);
  }
}

double TimedRun::extentAt(double time) const {
  if (m_speeds.empty()) return m_profile.at(time);
  if (!(time > 0.0)) return 0.0;
  if (time >= duration()) return m_extent;
  const auto after = std::upper_bound(m_speeds.begin() + 1, m_speeds.end() - 1, time,
                                      [](double t, const SpeedPoint& point) { return t < point.time; });
  const SpeedPoint &from = *(after - 1), &to = *after;
  const double passed = time - from.time, speed = std::sqrt(from.squaredSpeed);
  const double acceleration = (to.squaredSpeed - from.squaredSpeed) / (2.0 * (to.extent - from.extent));
  return std::clamp(from.extent + passed * (speed + 0.5 * acceleration * passed), from.extent, to.extent);
}

double TimedRun::timeOf(double extent) const {
  if (m_speeds.empty()) return m_profile.timeOf(extent);
  if (extent >= m_extent) return duration();
  const auto after = std::upper_bound(m_speeds.begin() + 1, m_speeds.end() - 1, extent,
                                      [](double e, const SpeedPoint& point) { return e < point.extent; });
  const SpeedPoint &from = *(after - 1), &to = *after;
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
