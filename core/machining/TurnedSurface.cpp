// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurnedSurface.h"

#include "machining/thread/HelicalBand.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::uint32_t kLeastRingSegments = 24, kMostRingSegments = 256;
constexpr double kMostRingPoints =
    4e6;  // limit of the points of all rings, unless they have the least number of segments

// Half of the tolerance is for the circle: R (1 - cos(pi / n)) <= chord / 2.
std::uint32_t segmentsFor(const TurnedProfile& profile, double chord) {
  double largest = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i) largest = std::max(largest, profile.radius(i));
  const double cosine = 1.0 - 0.5 * chord / std::max(largest, 1e-300);
  if (!(cosine > 0.0)) return kLeastRingSegments;
  const double needed = std::ceil(M_PI / std::acos(std::min(cosine, 1.0 - 1e-12)));
  const double affordable = kMostRingPoints / static_cast<double>(profile.size());
  const double most = std::clamp<double>(affordable, kLeastRingSegments, kMostRingSegments);
  return static_cast<std::uint32_t>(std::clamp<double>(needed, kLeastRingSegments, most));
}

std::shared_ptr<const std::vector<ProfilePoint>> unitCircle(std::uint32_t segments) {
  auto circle = std::make_shared<std::vector<ProfilePoint>>();
  for (std::uint32_t k = 0; k < segments; ++k) {
    const double angle = 2.0 * M_PI * k / segments;
    circle->emplace_back(std::cos(angle), std::sin(angle));
  }
  return circle;
}

// Adds rings of points around the axis and the bands between them; a ring of radius 0 is one point. The material is on
// the left of the path from ring to ring, as (r, z) is drawn. On a thread the rings follow its groove.
class RingBuilder {
 public:
  RingBuilder(TriangleSoup& soup, const std::vector<ProfilePoint>& circle, const PartThreads* threads)
      : m_soup(soup), m_circle(circle), m_threads(threads), m_segments(static_cast<std::uint32_t>(circle.size())) {}

  // otherSide: mm, radius of the other side of the wall.
  void add(TurningSide side, double radius, double otherSide, double z) {
    const Ring ring{
        {static_cast<std::uint32_t>(m_soup.points.size()), radius, otherSide, z}, radius > 0.0 ? m_segments : 1, side};
    const bool isThreaded = ring.count > 1 && m_threads && m_threads->between(side, z, z, radius, radius);
    for (std::uint32_t k = 0; k < ring.count; ++k) {
      const double r = isThreaded ? m_threads->radius(side, radius, otherSide, z, 2.0 * M_PI * k / m_segments) : radius;
      m_soup.points.emplace_back(r * m_circle[k].x(), r * m_circle[k].y(), z);
    }
    if (m_hasLast) join(m_last, ring);
    m_last = ring;
    m_hasLast = true;
  }

  // Leaves out the band between the previous ring and the next.
  void interrupt() { m_hasLast = false; }

 private:
  struct Ring : SurfaceRing {
    std::uint32_t count = 0;
    TurningSide side = TurningSide::Outside;
  };

  void join(const Ring& a, const Ring& b) {
    const bool isBand = m_threads && a.side == b.side && a.z != b.z && a.count > 1 && b.count > 1;
    const Ring &lower = a.z < b.z ? a : b, &upper = a.z < b.z ? b : a;
    const ThreadGroove* groove =
        isBand ? m_threads->between(a.side, lower.z, upper.z, lower.radius, upper.radius) : nullptr;
    if (groove) return addHelicalBand(m_soup, m_circle, *m_threads, *groove, lower, upper);
    joinPlainly(a.first, a.count, b.first, b.count);
  }

  void joinPlainly(std::uint32_t a, std::uint32_t countA, std::uint32_t b, std::uint32_t countB) {
    for (std::uint32_t k = 0; k < m_segments; ++k) {
      const std::uint32_t next = k + 1 == m_segments ? 0 : k + 1;
      const std::uint32_t a0 = a + (countA > 1 ? k : 0), a1 = a + (countA > 1 ? next : 0);
      const std::uint32_t b0 = b + (countB > 1 ? k : 0), b1 = b + (countB > 1 ? next : 0);
      if (countA > 1) m_soup.triangles.push_back({a0, a1, b1});
      if (countB > 1) m_soup.triangles.push_back({a0, b1, b0});
    }
  }

  TriangleSoup& m_soup;
  const std::vector<ProfilePoint>& m_circle;
  const PartThreads* m_threads;
  std::uint32_t m_segments;
  Ring m_last;
  bool m_hasLast = false;
};

// The samples of a block that have rings, from the first to the last: a chord to the next sample would deviate from the
// profile by more than the tolerance.
class RingSamples {
 public:
  RingSamples(const TurnedProfile& profile, bool isInner, double chord)
      : m_profile(profile), m_isInner(isInner), m_chord(chord) {}

  double radius(std::size_t i) const { return m_isInner ? m_profile.inner(i) : m_profile.radius(i); }

  std::vector<std::size_t> between(std::size_t first, std::size_t last) const {
    constexpr std::size_t kLongest = 64;  // samples between two rings, so that the search for straight ones is short
    std::vector<std::size_t> samples{first};
    for (std::size_t i = first + 1; i < last; ++i) {
      const bool isAtEnd = !m_profile.hasMaterial(i) && (m_profile.hasMaterial(i - 1) || m_profile.hasMaterial(i + 1));
      if (isAtEnd || i - samples.back() >= kLongest || !isStraight(samples.back(), i)) samples.push_back(i);
    }
    samples.push_back(last);
    return samples;
  }

 private:
  // Returns true if the samples from `from` to i lie on the chord to i + 1.
  bool isStraight(std::size_t from, std::size_t i) const {
    const double next = radius(i + 1), first = radius(from);
    const double span = static_cast<double>(i + 1 - from);
    for (std::size_t j = from + 1; j <= i; ++j) {
      const double t = static_cast<double>(j - from) / span;
      if (std::abs(first + t * (next - first) - radius(j)) > m_chord) return false;
    }
    return true;
  }

  const TurnedProfile& m_profile;
  bool m_isInner;
  double m_chord;
};

}  // namespace

TurnedSurface::TurnedSurface(const TurnedProfile& profile, double chord, std::shared_ptr<const PartThreads> threads)
    : m_chord(chord), m_threads(std::move(threads)), m_circle(unitCircle(segmentsFor(profile, chord))) {
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

void TurnedSurface::setThreads(const TurnedProfile& profile, std::shared_ptr<const PartThreads> threads,
                               const TurnedProfile::Range& changed) {
  m_threads = std::move(threads);
  update(profile, changed);
}

// Builds the outside upwards with the flat ends of the part, and the bore downwards.
std::shared_ptr<const TriangleSoup> TurnedSurface::build(const TurnedProfile& profile, std::size_t block) const {
  auto soup = std::make_shared<TriangleSoup>();
  RingBuilder rings(*soup, *m_circle, m_threads.get());
  const auto outer = [&](std::size_t i) {
    rings.add(TurningSide::Outside, profile.radius(i), profile.inner(i), profile.z(i));
  };
  const auto inner = [&](std::size_t i) {
    rings.add(TurningSide::Bore, profile.inner(i), profile.radius(i), profile.z(i));
  };
  const std::size_t first = block * kBlockSamples;
  const std::size_t last = std::min(first + kBlockSamples, profile.size() - 1);
  const auto isGap = [&](std::size_t i, std::size_t j) { return !profile.hasMaterial(i) && !profile.hasMaterial(j); };
  const RingSamples outside(profile, false, 0.5 * m_chord);
  std::vector<std::size_t> samples = outside.between(first, last);
  soup->points.reserve((samples.size() + 2) * m_circle->size());
  soup->triangles.reserve(2 * (samples.size() + 2) * m_circle->size());
  if (first == 0 && profile.hasMaterial(0)) inner(0);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (k > 0 && isGap(samples[k - 1], samples[k])) rings.interrupt();
    outer(samples[k]);
  }
  if (last == profile.size() - 1 && profile.hasMaterial(last)) inner(last);
  if (!profile.isBored()) return soup;
  rings.interrupt();
  samples = RingSamples(profile, true, 0.5 * m_chord).between(first, last);
  for (std::size_t k = samples.size(); k-- > 0;) {
    if (k + 1 < samples.size() && isGap(samples[k], samples[k + 1])) rings.interrupt();
    inner(samples[k]);
  }
  return soup;
}

}  // namespace handwheel
