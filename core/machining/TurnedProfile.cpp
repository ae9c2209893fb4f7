// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurnedProfile.h"

#include "machining/section/SectionSource.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

// Returns the lower side of a disc at z; infinite beside it.
double lowerSide(const ProfilePoint& centre, double radius, double z) {
  const double offset = z - centre.y();
  const double under = radius * radius - offset * offset;
  return under >= 0.0 ? centre.x() - std::sqrt(under) : kNowhere;
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
    if (!(z >= m_from.y() && z <= m_to.y()) || m_from.y() == m_to.y()) return kNowhere;
    const double t = (z - m_from.y()) / (m_to.y() - m_from.y());
    return m_from.x() + t * (m_to.x() - m_from.x());
  }

 private:
  ProfilePoint m_from{0, 0}, m_to{0, 0};
};

ProfilePoint mirroredPoint(const ProfilePoint& p) {
  return {-p.x(), p.y()};
}

// The lowest and the highest side of a disc that moves straight from a to b, at each z; infinite beside it.
class SweepEnvelope {
 public:
  SweepEnvelope(const ProfilePoint& a, const ProfilePoint& b, double radius)
      : m_a(a), m_b(b), m_radius(radius), m_under(a, b, radius), m_over(mirroredPoint(a), mirroredPoint(b), radius) {}
  double lower(double z) const {
    return std::min({lowerSide(m_a, m_radius, z), lowerSide(m_b, m_radius, z), m_under.at(z)});
  }
  double upper(double z) const {  // the lower side of the mirror image at the axis
    return -std::min(
        {lowerSide(mirroredPoint(m_a), m_radius, z), lowerSide(mirroredPoint(m_b), m_radius, z), m_over.at(z)});
  }

 private:
  ProfilePoint m_a, m_b;
  double m_radius;
  LowerTangent m_under, m_over;
};

// Returns the volume of a frustum between two circles at a distance 1, over π / 3.
double frustum(double r, double s) {
  return r * r + r * s + s * s;
}

bool isSamePage(const PagedArray<double>& a, const PagedArray<double>& b, std::size_t page) {
  if (a.sharesPage(b, page)) return true;
  const std::size_t end = std::min(a.size(), (page + 1) * PagedArray<double>::kPageSize);
  for (std::size_t i = page * PagedArray<double>::kPageSize; i < end; ++i) {
    if (a[i] != b[i]) return false;
  }
  return true;
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
  m_section = SectionSource::of(TurnedSection(stock));
}

TurnedProfile TurnedProfile::barOf(const StockCylinder& stock, std::size_t samples) {
  TurnedProfile bar = fromRadii(std::vector<double>(samples, 0.5 * stock.diameter), stock.length);
  bar.m_section = SectionSource::of(TurnedSection(stock));
  return bar;
}

TurnedProfile TurnedProfile::fromRadii(const std::vector<double>& radii, double length) {
  TurnedProfile profile;
  profile.m_spacing = length / static_cast<double>(radii.size() - 1);
  for (const double r : radii) profile.m_radii.push_back(r);
  return profile;
}

TurnedProfile TurnedProfile::fromRadii(const std::vector<double>& radii, const std::vector<double>& inner,
                                       double length) {
  TurnedProfile profile = fromRadii(radii, length);
  for (std::size_t i = 0; i < inner.size(); ++i) profile.limitInner(i, inner[i]);
  return profile;
}

TurnedProfile::Range TurnedProfile::samplesUnder(const ProfilePoint& a, const ProfilePoint& b,
                                                 double noseRadius) const {
  if (!a.allFinite() || !b.allFinite() || !(noseRadius > 0.0) || !std::isfinite(noseRadius)) return {};
  const double from = std::min(a.y(), b.y()) - noseRadius, to = std::max(a.y(), b.y()) + noseRadius;
  const double last = static_cast<double>(size() - 1);
  if (to < 0.0 || from > length()) return {};
  const auto begin = static_cast<std::size_t>(std::clamp(std::ceil(from / m_spacing), 0.0, last));
  const auto end = static_cast<std::size_t>(std::clamp(std::floor(to / m_spacing), 0.0, last));
  return {begin, end + 1};
}

bool TurnedProfile::limitOuter(std::size_t i, double radius) {
  if (!std::isfinite(radius)) return false;
  const double left = std::max(radius, inner(i));
  return left < m_radii[i] && set(i, left, inner(i));
}

bool TurnedProfile::limitInner(std::size_t i, double radius) {
  if (!std::isfinite(radius)) return false;
  const double left = std::min(radius, m_radii[i]);
  return left > inner(i) && set(i, m_radii[i], left);
}

bool TurnedProfile::set(std::size_t i, double outer, double inner) {
  const bool isOuter = m_radii[i] != outer, isInner = this->inner(i) != inner;
  if (isOuter || isInner) m_section.reset();
  if (isOuter) m_radii.set(i, outer);
  if (!isInner) return isOuter;
  if (m_inner.empty()) {
    for (std::size_t k = 0; k < size(); ++k) m_inner.push_back(0.0);
  }
  m_inner.set(i, inner);
  return true;
}

TurnedProfile::Range TurnedProfile::cut(const ProfilePoint& a, const ProfilePoint& b, double noseRadius) {
  Range changed;
  const Range under = samplesUnder(a, b, noseRadius);
  const SweepEnvelope sweep(a, b, noseRadius);
  for (std::size_t i = under.first; i < under.last; ++i) {
    const double at = z(i);
    if (isBored() && m_inner[i] > 0.0 && sweep.upper(at) <= m_inner[i]) continue;
    if (limitOuter(i, sweep.lower(at))) changed.extend({i, i + 1});
  }
  return changed;
}

TurnedProfile::Range TurnedProfile::cutBore(const ProfilePoint& a, const ProfilePoint& b, double noseRadius) {
  Range changed;
  const Range under = samplesUnder(a, b, noseRadius);
  const SweepEnvelope sweep(a, b, noseRadius);
  for (std::size_t i = under.first; i < under.last; ++i) {
    const double at = z(i);
    if (sweep.lower(at) < m_radii[i] && limitInner(i, sweep.upper(at))) changed.extend({i, i + 1});
  }
  return changed;
}

double TurnedProfile::volume() const {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < size(); ++i)
    sum += frustum(m_radii[i], m_radii[i + 1]) - frustum(inner(i), inner(i + 1));
  return M_PI / 3.0 * m_spacing * sum;
}

double TurnedProfile::area() const {
  const auto end = [this](std::size_t i) { return m_radii[i] * m_radii[i] - inner(i) * inner(i); };
  const auto side = [this](double r, double s) { return (r + s) * std::hypot(m_spacing, s - r); };
  double sum = end(0) + end(size() - 1);
  for (std::size_t i = 0; i + 1 < size(); ++i) {
    if (!hasMaterial(i) && !hasMaterial(i + 1)) continue;
    sum += side(m_radii[i], m_radii[i + 1]) + (isBored() ? side(m_inner[i], m_inner[i + 1]) : 0.0);
  }
  return M_PI * sum;
}

std::vector<TurnedProfile::Range> TurnedProfile::pieces() const {
  std::vector<Range> pieces;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!hasMaterial(i)) continue;
    if (pieces.empty() || pieces.back().last < i) pieces.push_back({i, i});
    pieces.back().last = i + 1;
  }
  return pieces;
}

bool TurnedProfile::operator==(const TurnedProfile& other) const {
  if (m_spacing != other.m_spacing || size() != other.size()) return false;
  for (std::size_t page = 0; page < m_radii.pageCount(); ++page) {
    if (!isSamePage(m_radii, other.m_radii, page)) return false;
  }
  if (isBored() != other.isBored()) return false;
  for (std::size_t page = 0; page < m_inner.pageCount(); ++page) {
    if (!isSamePage(m_inner, other.m_inner, page)) return false;
  }
  return true;
}

}  // namespace handwheel
