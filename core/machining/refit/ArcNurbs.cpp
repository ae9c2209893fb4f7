// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/refit/ArcNurbs.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace handwheel {

namespace {

constexpr double kLeastPiece = 1e-7;  // rad; a shorter piece of an arc is not split from its neighbour

// Returns the angles at which an arc is split, its ends included.
std::vector<double> partings(const ProfileSegment& arc) {
  const ProfilePoint start = arc.from - arc.centre();
  const double from = std::atan2(start.y(), start.x()), to = from + arc.angle();
  const double low = std::min(from, to), high = std::max(from, to);
  std::vector<double> angles{low};
  for (double k = std::ceil(low / M_PI_2); k * M_PI_2 < high; ++k) {
    const double angle = k * M_PI_2;
    if (angle > angles.back() + kLeastPiece && angle < high - kLeastPiece) angles.push_back(angle);
  }
  angles.push_back(high);
  if (to < from) std::reverse(angles.begin(), angles.end());
  return angles;
}

class NetBuilder {
 public:
  explicit NetBuilder(const ProfilePoint& start) {
    m_nurbs.degree = 2;
    m_nurbs.knots = {0.0, 0.0, 0.0};
    push(start, 1.0);
  }

  void line(const ProfilePoint& to) { piece(0.5 * (m_nurbs.poles.back() + to), 1.0, to); }

  void arc(const ProfileSegment& arc) {
    const ProfilePoint centre = arc.centre();
    const double radius = arc.radius();
    const std::vector<double> angles = partings(arc);
    for (std::size_t i = 1; i < angles.size(); ++i) {
      const double middle = 0.5 * (angles[i - 1] + angles[i]), cosine = std::cos(0.5 * (angles[i] - angles[i - 1]));
      const auto at = [&](double angle, double r) {
        return ProfilePoint(centre + r * ProfilePoint(std::cos(angle), std::sin(angle)));
      };
      piece(at(middle, radius / cosine), cosine, i + 1 == angles.size() ? arc.to : at(angles[i], radius));
    }
  }

  ProfileNurbs take() {
    m_nurbs.knots.push_back(m_nurbs.knots.back());
    return std::move(m_nurbs);
  }

 private:
  void piece(const ProfilePoint& middle, double weight, const ProfilePoint& to) {
    push(middle, weight);
    push(to, 1.0);
    const double knot = std::floor(m_nurbs.knots.back()) + 1.0;
    m_nurbs.knots.push_back(knot);
    m_nurbs.knots.push_back(knot);
  }
  void push(const ProfilePoint& pole, double weight) {
    m_nurbs.poles.emplace_back(std::max(0.0, pole.x()), pole.y());  // rounding must not carry it across the axis
    m_nurbs.weights.push_back(weight);
  }

  ProfileNurbs m_nurbs;
};

}  // namespace

ProfileNurbs nurbsOf(std::span<const ProfileSegment> segments) {
  NetBuilder builder(segments.front().from);
  for (const ProfileSegment& segment : segments) {
    if (segment.isArc())
      builder.arc(segment);
    else
      builder.line(segment.to);
  }
  return builder.take();
}

}  // namespace handwheel
