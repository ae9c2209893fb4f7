// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/playback/PlayedPart.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kBlock = TurnedSurface::kBlockSamples;

struct HeightRange {
  double from = 0.0, to = 0.0;  // mm
};

// Returns true if two grooves have the same surface where both are.
bool isSameWhereBoth(const ThreadGroove& a, const ThreadGroove& b) {
  constexpr int kLooks = 8;
  constexpr double kSame = 1e-9;  // mm
  if (!(a.cut() == b.cut()) || a.side() != b.side() || a.noseRadius() != b.noseRadius()) return false;
  const double from = std::max(a.from(), b.from()), to = std::min(a.to(), b.to()), pitch = a.cut().pitch;
  if (!(to - from > 2.0 * pitch)) return false;
  for (int i = 0; i < kLooks; ++i) {
    const double z = std::lerp(from + pitch, to - pitch, i / (kLooks - 1.0)), angle = 2.0 * i;
    if (!(std::abs(a.radius(z, angle) - b.radius(z, angle)) < kSame)) return false;
  }
  return true;
}

void addAround(std::vector<HeightRange>& ranges, const ThreadGroove& groove, double from, double to) {
  const double reach = groove.cut().pitch + ThreadGroove::kRunOut * groove.cut().lead();
  ranges.push_back({from - reach, to + reach});
}

// Adds the heights at which grooves of some threads are not those of others. A groove within one of the others leaves
// nothing to see.
void addDifference(std::vector<HeightRange>& ranges, const PartThreads* of, const PartThreads* others) {
  if (!of) return;
  for (const ThreadGroove& groove : of->grooves()) {
    double from = groove.from(), to = groove.to();
    bool isSeen = true;
    for (std::size_t i = 0; others && isSeen && i < others->grooves().size(); ++i) {
      const ThreadGroove& other = others->grooves()[i];
      isSeen = !groove.isWithin(other);
      if (!isSeen || !isSameWhereBoth(groove, other)) continue;
      if (other.from() <= groove.from()) from = std::max(from, other.to());
      if (other.to() >= groove.to()) to = std::min(to, other.from());
    }
    if (isSeen) addAround(ranges, groove, std::min(from, to), std::max(from, to));
  }
}

bool isSameBlock(const TurnedProfile& a, const TurnedProfile& b, std::size_t block) {
  const std::size_t last = std::min((block + 1) * kBlock, a.size() - 1);
  for (std::size_t i = block * kBlock; i <= last; ++i)
    if (a.radius(i) != b.radius(i) || a.inner(i) != b.inner(i)) return false;
  return true;
}

double largestRadius(const TurnedProfile& part) {
  double largest = 0.0;
  for (std::size_t i = 0; i < part.size(); ++i) largest = std::max(largest, part.radius(i));
  return largest;
}

}  // namespace

DisplayModel PlayedPart::at(const TurnedProfile& part, const std::shared_ptr<const PartThreads>& threads) {
  const double largest = largestRadius(part);
  // The rings of a surface have as many points as its first part needs.
  const bool isNew = !m_surface || m_part->size() != part.size() || largest > m_largest;
  if (isNew) {
    m_surface.emplace(part, m_chord, threads);
    m_largest = largest;
  } else {
    std::vector<HeightRange> ranges;
    const std::shared_ptr<const PartThreads> before = m_surface->threads();
    addDifference(ranges, threads.get(), before.get());
    addDifference(ranges, before.get(), threads.get());
    m_surface->setThreads(part, threads, {});
    for (std::size_t b = 0; b < m_surface->blocks().size(); ++b) {
      const double low = part.z(b * kBlock), high = part.z(std::min((b + 1) * kBlock, part.size() - 1));
      const bool isThreaded = std::any_of(ranges.begin(), ranges.end(), [&](const HeightRange& range) {
        return range.from <= high && range.to >= low;
      });
      if (isThreaded || !isSameBlock(*m_part, part, b)) m_surface->update(part, {b * kBlock + 1, b * kBlock + 2});
    }
  }
  m_part = part;
  DisplayModel model = displayOf(*m_surface, m_base);
  m_parted = showPartedOff(model, part, m_parted);
  return model;
}

}  // namespace handwheel
