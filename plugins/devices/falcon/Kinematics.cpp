// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/Kinematics.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel::falcon {

namespace {

// Lengths in m, named as in Stamper's thesis.
constexpr double kA = 0.060;     // arm, from the motor's shaft to its end
constexpr double kB = 0.1025;    // parallelogram
constexpr double kC = 0.01443;   // from the grip's centre to its joint
constexpr double kDE = 0.0225;   // d + e: the parallelogram's joints beyond its bars, both ends
constexpr double kF = -0.025;    // sideways offset of the grip's joint
constexpr double kR = 0.0400;    // from the axis to the motor's shaft
constexpr double kS = -0.02309;  // sideways offset of the shaft

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr Angles kAzimuth = {105 * kDegree, -15 * kDegree, -135 * kDegree};

// 1280 counts to a turn of a shaft of 14.25 mm, which drives a sector of 110 mm; 35° at zero.
constexpr double kPerCount = 14.25 * 360.0 / (1280.0 * 110.0) * kDegree;
constexpr double kAtZero = 35.0 * kDegree;

// The triangle of one leg, in the plane of its arm.
struct Leg {
  double cosine, sine;    // cosine and sine of its azimuth
  double sideways;        // v + f, out of the plane
  double across, height;  // X, Z: of the grip's joint seen from the shaft
  double reach;           // L: the parallelogram's length in the plane
};

Leg legAt(const Vec3& p, std::size_t i) {
  Leg leg{};
  leg.cosine = std::cos(kAzimuth[i]);
  leg.sine = std::sin(kAzimuth[i]);
  leg.sideways = -p.x() * leg.sine + p.y() * leg.cosine - kS + kF;
  leg.across = p.x() * leg.cosine + p.y() * leg.sine - kR + kC;
  leg.height = p.z();
  leg.reach = kDE + std::sqrt(kB * kB - leg.sideways * leg.sideways);  // b·sin θ3 = √(b² − (v+f)²)
  return leg;
}

struct AngleAndGradient {
  double angle;
  Vec3 gradient;
};

// θ1 = atan2(Z, X) − acos(D/ρ), D = (X² + Z² + a² − L²)/(2a), ρ² = X² + Z²; NaN out of reach.
AngleAndGradient armAt(const Vec3& p, std::size_t i) {
  const Leg leg = legAt(p, i);
  const double rho2 = leg.across * leg.across + leg.height * leg.height;
  const double rho = std::sqrt(rho2);
  const double d = (rho2 + kA * kA - leg.reach * leg.reach) / (2.0 * kA);
  const double cosine = d / rho;
  const Vec3 dAcross(leg.cosine, leg.sine, 0.0);
  const Vec3 dSideways(-leg.sine, leg.cosine, 0.0);
  const Vec3 dRho2 = 2.0 * (leg.across * dAcross + leg.height * Vec3::UnitZ());
  const Vec3 dReach = -leg.sideways / (leg.reach - kDE) * dSideways;
  const Vec3 dD = (dRho2 - 2.0 * leg.reach * dReach) / (2.0 * kA);
  const Vec3 dCosine = dD / rho - d / (2.0 * rho * rho2) * dRho2;
  const Vec3 dPolar = (leg.across * Vec3::UnitZ() - leg.height * dAcross) / rho2;
  return {std::atan2(leg.height, leg.across) - std::acos(cosine), dPolar + dCosine / std::sqrt(1.0 - cosine * cosine)};
}

}  // namespace

Angles anglesOf(const Counts& counts) {
  Angles angles{};
  for (std::size_t i = 0; i < 3; ++i) angles[i] = counts[i] * kPerCount + kAtZero;
  return angles;
}

std::optional<Angles> inverse(const Vec3& point) {
  Angles angles{};
  for (std::size_t i = 0; i < 3; ++i) {
    angles[i] = armAt(point, i).angle;
    if (!std::isfinite(angles[i])) return {};
  }
  return angles;
}

Eigen::Matrix3d jacobian(const Vec3& point) {
  Eigen::Matrix3d rows;
  for (std::size_t i = 0; i < 3; ++i) rows.row(static_cast<int>(i)) = armAt(point, i).gradient;
  return rows;
}

std::optional<Vec3> forward(const Angles& angles, const Vec3& guess) {
  constexpr int kMostSteps = 30;
  constexpr double kNear = 1e-12;    // rad
  constexpr double kLongest = 0.02;  // m of one step, so that none leaves the reach
  Vec3 point = guess;
  for (int step = 0; step < kMostSteps; ++step) {
    const std::optional<Angles> reached = inverse(point);
    if (!reached) return {};
    Vec3 miss;
    for (std::size_t i = 0; i < 3; ++i) miss[static_cast<int>(i)] = angles[i] - (*reached)[i];
    if (!miss.allFinite()) return {};
    if (miss.cwiseAbs().maxCoeff() < kNear) return point;
    const Vec3 move = jacobian(point).partialPivLu().solve(miss);
    if (!move.allFinite()) return {};
    point += move * std::min(1.0, kLongest / move.norm());
  }
  return {};
}

Vec3 torques(const Vec3& force, const Vec3& point) {
  return jacobian(point).transpose().partialPivLu().solve(force);
}

Counts torqueCounts(const Vec3& torque) {
  Vec3 counts = kCountsPerTorque * torque;
  if (!counts.allFinite()) return {};
  const double largest = counts.cwiseAbs().maxCoeff();
  if (largest > kMostTorque) counts *= kMostTorque / largest;
  Counts whole{};
  for (int i = 0; i < 3; ++i) whole[static_cast<std::size_t>(i)] = static_cast<int>(std::lround(counts[i]));
  return whole;
}

}  // namespace handwheel::falcon
