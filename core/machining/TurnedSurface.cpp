// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurnedSurface.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::uint32_t kLeastSegments = 24, kMostSegments = 256;
constexpr double kMostPoints = 4e6;  // of all rings, unless they are of the least segments

// Half of the tolerance is for the circle: R (1 - cos(pi / n)) <= chord / 2.
std::uint32_t segmentsFor(const TurnedProfile& profile, double chord) {
  double largest = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i) largest = std::max(largest, profile.radius(i));
  const double cosine = 1.0 - 0.5 * chord / std::max(largest, 1e-300);
  if (!(cosine > 0.0)) return kLeastSegments;
  const double needed = std::ceil(M_PI / std::acos(std::min(cosine, 1.0 - 1e-12)));
  const double affordable = kMostPoints / static_cast<double>(profile.size());
  const double most = std::clamp<double>(affordable, kLeastSegments, kMostSegments);
  return static_cast<std::uint32_t>(std::clamp<double>(needed, kLeastSegments, most));
}

// Adds rings of points around the axis and the bands between them; a ring of radius 0 is one point.
class RingBuilder {
 public:
  RingBuilder(TriangleSoup& soup, std::uint32_t segments) : m_soup(soup), m_segments(segments) {}

  void add(double radius, double z) {
    const auto first = static_cast<std::uint32_t>(m_soup.points.size());
    const std::uint32_t count = radius > 0.0 ? m_segments : 1;
    for (std::uint32_t k = 0; k < count; ++k) {
      const double angle = 2.0 * M_PI * k / m_segments;
      m_soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    if (m_hasLast) join(m_first, m_count, first, count);
    m_first = first;
    m_count = count;
    m_hasLast = true;
  }

 private:
  void join(std::uint32_t a, std::uint32_t countA, std::uint32_t b, std::uint32_t countB) {
    for (std::uint32_t k = 0; k < m_segments; ++k) {
      const std::uint32_t next = (k + 1) % m_segments;
      const std::uint32_t a0 = a + (countA > 1 ? k : 0), a1 = a + (countA > 1 ? next : 0);
      const std::uint32_t b0 = b + (countB > 1 ? k : 0), b1 = b + (countB > 1 ? next : 0);
      if (countA > 1) m_soup.triangles.push_back({a0, a1, b1});
      if (countB > 1) m_soup.triangles.push_back({a0, b1, b0});
    }
  }

  TriangleSoup& m_soup;
  std::uint32_t m_segments;
  std::uint32_t m_first = 0, m_count = 0;
  bool m_hasLast = false;
};

// Whether sample i lies on the line of its neighbours within the tolerance, so that its ring can be left out.
bool isStraight(const TurnedProfile& profile, std::size_t from, std::size_t i, double chord) {
  const double next = profile.radius(i + 1), first = profile.radius(from);
  const double span = static_cast<double>(i + 1 - from);
  for (std::size_t j = from + 1; j <= i; ++j) {
    const double t = static_cast<double>(j - from) / span;
    if (std::abs(first + t * (next - first) - profile.radius(j)) > chord) return false;
  }
  return true;
}

}  // namespace

TurnedSurface::TurnedSurface(const TurnedProfile& profile, double chord)
    : m_chord(chord), m_segments(segmentsFor(profile, chord)) {
  const std::size_t count = (profile.size() - 2) / kBlockSamples + 1;
  for (std::size_t b = 0; b < count; ++b) m_blocks.push_back(build(profile, b));
}

void TurnedSurface::update(const TurnedProfile& profile, const TurnedProfile::Range& changed) {
  if (changed.isEmpty()) return;
  // A sample between two blocks belongs to both.
  const std::size_t first = changed.first == 0 ? 0 : (changed.first - 1) / kBlockSamples;
  const std::size_t last = std::min((changed.last - 1) / kBlockSamples, m_blocks.size() - 1);
  for (std::size_t b = first; b <= last; ++b) m_blocks[b] = build(profile, b);
}

std::shared_ptr<const TriangleSoup> TurnedSurface::build(const TurnedProfile& profile, std::size_t block) const {
  constexpr std::size_t kLongest = 64;  // samples between two rings, so that the search for straight ones is short
  auto soup = std::make_shared<TriangleSoup>();
  RingBuilder rings(*soup, m_segments);
  const std::size_t first = block * kBlockSamples;
  const std::size_t last = std::min(first + kBlockSamples, profile.size() - 1);
  if (first == 0 && profile.radius(0) > 0.0) rings.add(0.0, 0.0);
  std::size_t ring = first;
  for (std::size_t i = first; i <= last; ++i) {
    const bool isEnd = i == first || i == last;
    if (!isEnd && i - ring < kLongest && isStraight(profile, ring, i, 0.5 * m_chord)) continue;
    rings.add(profile.radius(i), profile.z(i));
    ring = i;
  }
  if (last == profile.size() - 1 && profile.radius(last) > 0.0) rings.add(0.0, profile.z(last));
  return soup;
}

}  // namespace handwheel
