// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileSegment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

// An arc flatter than this is computed as its chord: its rise is below the rounding of its ends.
constexpr double kFlatBulge = 1e-12;

ProfilePoint turned(const ProfilePoint& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

double cross(const ProfilePoint& a, const ProfilePoint& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Directions of an arc's points from its centre: along +r, +z, -r, -z.
constexpr std::array<std::array<double, 2>, 4> kExtremes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

}  // namespace

double ProfileSegment::radius() const {
  if (std::abs(bulge) < kFlatBulge) return std::numeric_limits<double>::infinity();
  return 0.25 * (to - from).norm() * (1.0 / std::abs(bulge) + std::abs(bulge));
}

ProfilePoint ProfileSegment::centre() const {
  const ProfilePoint along = to - from, left(-along.y(), along.x());
  return 0.5 * (from + to) + 0.25 * (1.0 / bulge - bulge) * left;
}

double ProfileSegment::length() const {
  const double chord = (to - from).norm(), half = 0.5 * angle();
  return std::abs(half) < 1e-6 ? chord : chord * half / std::sin(half);
}

// The chord from the start is turned against the whole chord by half of the remaining angle; no radius is needed.
ProfilePoint ProfileSegment::at(double t) const {
  if (t <= 0.0) return from;
  if (t >= 1.0) return to;
  const double half = 0.5 * angle();
  const double share = std::abs(half) < 1e-9 ? t : std::sin(t * half) / std::sin(half);
  return from + share * turned(to - from, -(1.0 - t) * half);
}

ProfilePoint ProfileSegment::direction(double t) const {
  const double chord = (to - from).norm();
  if (!(chord > 0.0)) return {0, 0};
  return turned((to - from) / chord, (2.0 * t - 1.0) * 0.5 * angle());
}

ProfilePoint ProfileSegment::nearest(const ProfilePoint& p) const {
  if (std::abs(bulge) < kFlatBulge) {
    const ProfilePoint along = to - from;
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? std::clamp((p - from).dot(along) / square, 0.0, 1.0) : 0.0;
    return t == 1.0 ? to : ProfilePoint(from + t * along);
  }
  const ProfilePoint outward = p - centre(), v = p - from, along = to - from, left(-along.y(), along.x());
  const double distance = outward.norm();
  const ProfilePoint nearEnd = v.squaredNorm() <= (p - to).squaredNorm() ? from : to;
  if (!(distance > 0.0)) return nearEnd;  // all points are equally near
  // The test is between the radii to both ends, by the tangents there; the distance from the circle is by the power of
  // the point: both are exact for any distance of the centre.
  const double cosine = 1.0 - bulge * bulge, sine = 2.0 * bulge;  // for half of the angle, times 1 + bulge²
  const bool isPastStart = v.dot(cosine * along - sine * left) >= 0.0;
  const bool isBeforeEnd = (p - to).dot(cosine * along + sine * left) <= 0.0;
  const bool isBeside = std::abs(bulge) <= 1.0 ? isPastStart && isBeforeEnd : isPastStart || isBeforeEnd;
  if (!isBeside) return nearEnd;
  const double power = v.dot(v - along) - 0.5 * (1.0 / bulge - bulge) * v.dot(left);
  return p - power / (distance + radius()) / distance * outward;
}

ProfileBox ProfileSegment::box() const {
  ProfileBox box(from);
  box.extend(to);
  if (std::abs(bulge) < kFlatBulge) return box;
  const ProfilePoint c = centre();
  const double r = radius(), turn = bulge > 0.0 ? 1.0 : -1.0;
  for (const auto& extreme : kExtremes) {
    const ProfilePoint outward(extreme[0], extreme[1]);
    double swept = turn * std::atan2(cross(from - c, outward), (from - c).dot(outward));
    if (swept < 0.0) swept += 2.0 * M_PI;
    if (swept <= std::abs(angle())) box.extend(ProfilePoint(c + r * outward));
  }
  return box;
}

ProfileSegment ProfileSegment::piece(double a, double b) const {
  return {at(a), at(b), bulge == 0.0 ? 0.0 : std::tan((b - a) * std::atan(bulge))};
}

// Gauss and Legendre's rule of eight points on pieces of at most 30°: exact to rounding.
double ProfileSegment::squareMoment() const {
  static constexpr std::array<std::array<double, 2>, 4> kRule{{{0.1834346424956498, 0.3626837833783620},
                                                               {0.5255324099163290, 0.3137066458778873},
                                                               {0.7966664774136267, 0.2223810344533745},
                                                               {0.9602898564975363, 0.1012285362903763}}};
  if (!isArc()) {
    const double a = from.x(), b = to.x();
    return (to.y() - from.y()) * (a * a + a * b + b * b) / 3.0;
  }
  const double whole = length();
  const auto pieces = static_cast<int>(std::ceil(std::abs(angle()) / (M_PI / 6.0)));
  double sum = 0.0;
  for (int k = 0; k < pieces; ++k) {
    for (const auto& [node, weight] : kRule) {
      for (const double side : {-node, node}) {
        const double t = (k + 0.5 * (1.0 + side)) / pieces, r = at(t).x();
        sum += weight * r * r * direction(t).y();
      }
    }
  }
  return sum * 0.5 * whole / pieces;
}

std::optional<ProfileSegment> arcThrough(const ProfilePoint& a, const ProfilePoint& m, const ProfilePoint& b) {
  const ProfilePoint u = m - a, v = b - m, w = b - a;
  if (!(u.norm() > 0.0) || !(v.norm() > 0.0) || !(w.norm() > 0.0)) return std::nullopt;
  // By the inscribed angle, the angle between u and v is half of the arc's.
  const double sine = cross(u, v) / (u.norm() * v.norm()), cosine = u.dot(v) / (u.norm() * v.norm());
  if (std::abs(sine) < kFlatBulge && cosine > 0.0) return ProfileSegment{a, b, 0.0};
  return ProfileSegment{a, b, std::tan(0.5 * std::atan2(sine, cosine))};
}

ProfileSegment arcAround(const ProfilePoint& centre, double radius, double from, double to) {
  const auto point = [&](double angle) {
    return ProfilePoint(centre + radius * ProfilePoint(std::cos(angle), std::sin(angle)));
  };
  return {point(from), point(to), std::tan(0.25 * (to - from))};
}

}  // namespace handwheel
