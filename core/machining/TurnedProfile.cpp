// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurnedProfile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// The lower side of a disc at z; infinite beside it.
double lowerSide(const ProfilePoint& centre, double radius, double z) {
  const double offset = z - centre.y();
  const double under = radius * radius - offset * offset;
  return under >= 0.0 ? centre.x() - std::sqrt(under) : kNone;
}

// The lower tangent of two equal discs: a segment, rising in z.
class LowerTangent {
 public:
  LowerTangent(const ProfilePoint& a, const ProfilePoint& b, double radius) {
    const ProfilePoint along = b - a;
    const double length = along.norm();
    if (!(std::abs(along.y()) > 0.0)) return;  // a plunge: the discs alone bound it
    ProfilePoint down(-along.y() / length, along.x() / length);
    if (down.x() > 0.0) down = -down;
    m_from = a + radius * down;
    m_to = b + radius * down;
    if (m_from.y() > m_to.y()) std::swap(m_from, m_to);
  }
  double at(double z) const {
    if (!(z >= m_from.y() && z <= m_to.y()) || m_from.y() == m_to.y()) return kNone;
    const double t = (z - m_from.y()) / (m_to.y() - m_from.y());
    return m_from.x() + t * (m_to.x() - m_from.x());
  }

 private:
  ProfilePoint m_from{0, 0}, m_to{0, 0};
};

double distanceToChord(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
  const ProfilePoint along = b - a;
  const double length = along.norm();
  return length > 0.0 ? std::abs(along.x() * (p - a).y() - along.y() * (p - a).x()) / length : (p - a).norm();
}

}  // namespace

void TurnedProfile::Range::extend(const Range& other) {
  if (other.isEmpty()) return;
  *this = isEmpty() ? other : Range{std::min(first, other.first), std::max(last, other.last)};
}

TurnedProfile::TurnedProfile(const StockCylinder& stock, double spacing) {
  const double steps = std::ceil(stock.length / spacing);
  const auto count = static_cast<std::size_t>(std::clamp(steps, 1.0, static_cast<double>(kMostSamples - 1)));
  m_spacing = stock.length / static_cast<double>(count);
  for (std::size_t i = 0; i <= count; ++i) m_radii.push_back(0.5 * stock.diameter);
}

TurnedProfile TurnedProfile::fromRadii(const std::vector<double>& radii, double length) {
  TurnedProfile profile;
  profile.m_spacing = length / static_cast<double>(radii.size() - 1);
  for (const double r : radii) profile.m_radii.push_back(r);
  return profile;
}

TurnedProfile::Range TurnedProfile::samplesUnder(const ProfilePoint& a, const ProfilePoint& b,
                                                 double noseRadius) const {
  if (!a.allFinite() || !b.allFinite() || !(noseRadius > 0.0)) return {};
  const double from = std::min(a.y(), b.y()) - noseRadius, to = std::max(a.y(), b.y()) + noseRadius;
  const double last = static_cast<double>(size() - 1);
  if (to < 0.0 || from > length()) return {};
  const auto begin = static_cast<std::size_t>(std::clamp(std::ceil(from / m_spacing), 0.0, last));
  const auto end = static_cast<std::size_t>(std::clamp(std::floor(to / m_spacing), 0.0, last));
  return {begin, end + 1};
}

TurnedProfile::Range TurnedProfile::cut(const ProfilePoint& a, const ProfilePoint& b, double noseRadius) {
  Range changed;
  const Range under = samplesUnder(a, b, noseRadius);
  const LowerTangent tangent(a, b, noseRadius);
  for (std::size_t i = under.first; i < under.last; ++i) {
    const double at = z(i);
    const double low = std::min({lowerSide(a, noseRadius, at), lowerSide(b, noseRadius, at), tangent.at(at)});
    const double left = std::max(low, 0.0);
    if (!(left < m_radii[i])) continue;
    m_radii.set(i, left);
    changed.extend({i, i + 1});
  }
  return changed;
}

double TurnedProfile::volume() const {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < size(); ++i) {
    const double r = m_radii[i], s = m_radii[i + 1];
    sum += r * r + r * s + s * s;
  }
  return M_PI / 3.0 * m_spacing * sum;
}

double TurnedProfile::area() const {
  const double first = m_radii[0], last = m_radii[size() - 1];
  double sum = first * first + last * last;
  for (std::size_t i = 0; i + 1 < size(); ++i) {
    sum += (m_radii[i] + m_radii[i + 1]) * std::hypot(m_spacing, m_radii[i + 1] - m_radii[i]);
  }
  return M_PI * sum;
}

std::size_t TurnedProfile::pieces() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < size(); ++i) count += m_radii[i] > 0.0 && (i == 0 || !(m_radii[i - 1] > 0.0)) ? 1 : 0;
  return count;
}

// Greedy: each chord goes as far as all samples under it allow, doubling and halving its length.
std::vector<ProfilePoint> TurnedProfile::polyline(double chord) const {
  const auto point = [this](std::size_t i) { return ProfilePoint(m_radii[i], z(i)); };
  const auto fits = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from + 1; i < to; ++i) {
      if (distanceToChord(point(i), point(from), point(to)) > chord) return false;
    }
    return true;
  };
  std::vector<ProfilePoint> points{point(0)};
  for (std::size_t at = 0; at + 1 < size();) {
    std::size_t step = 1;
    while (at + 2 * step < size() && fits(at, at + 2 * step)) step *= 2;
    std::size_t next = at + step;
    for (std::size_t half = step; half > 0; half /= 2) {
      if (next + half < size() && fits(at, next + half)) next += half;
    }
    points.push_back(point(next));
    at = next;
  }
  return points;
}

bool TurnedProfile::operator==(const TurnedProfile& other) const {
  if (m_spacing != other.m_spacing || size() != other.size()) return false;
  for (std::size_t page = 0; page < m_radii.pageCount(); ++page) {
    if (m_radii.sharesPage(other.m_radii, page)) continue;
    const std::size_t end = std::min(size(), (page + 1) * PagedArray<double>::kPageSize);
    for (std::size_t i = page * PagedArray<double>::kPageSize; i < end; ++i) {
      if (m_radii[i] != other.m_radii[i]) return false;
    }
  }
  return true;
}

}  // namespace handwheel
