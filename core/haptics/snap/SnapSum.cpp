// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/snap/SnapSum.h"

#include <cmath>

namespace handwheel {
namespace {

// The strongest features, each once.
class Strongest {
 public:
  explicit Strongest(SnapResult& pull) : m_pull(pull) {}

  void add(const SnapFeature& feature, double force) {
    std::uint32_t at = 0;
    while (at < m_pull.featureCount && m_pull.features[at] != feature) ++at;
    if (at == m_pull.featureCount) {
      if (at == SnapResult::kShown && force <= m_forces[--at]) return;
      m_pull.featureCount = at + 1;
    } else if (force <= m_forces[at]) {
      return;
    }
    for (; at > 0 && m_forces[at - 1] < force; --at) {
      m_forces[at] = m_forces[at - 1];
      m_pull.features[at] = m_pull.features[at - 1];
    }
    m_forces[at] = force;
    m_pull.features[at] = feature;
  }

 private:
  SnapResult& m_pull;
  std::array<double, SnapResult::kShown> m_forces = {};
};

}  // namespace

void SnapSum::add(const Term& term) {
  m_terms[m_size++] = term;
  if (m_size == 2 * m_most + 2) keepNearest();
}

// Keeps the terms that may act, and the first that may not as the last. In linear time, and rarely: a heap takes
// longer.
void SnapSum::keepNearest() {
  const auto begin = m_terms.begin();
  const auto last = begin + static_cast<std::ptrdiff_t>(m_most);
  std::nth_element(begin, last, begin + static_cast<std::ptrdiff_t>(m_size),
                   [](const Term& a, const Term& b) { return a.distance2 < b.distance2; });
  m_size = m_most + 1;
  m_limit2 = last->distance2;
}

// Collects the nearest terms; returns the snap distance that is left.
double SnapSum::gather(const SnapField& field, double distance, const Vec3& hand, bool& isCutShort) {
  m_size = 0;
  m_limit2 = distance * distance;
  for (std::size_t d = 0; d < SnapField::kDimensions; ++d) {
    const bool isAll = field.layer(d).forEachNear(
        hand, [&] { return m_limit2; },
        [&](const SnapItem& item, const Vec3& closest, double distance2) {
          if (const double count = item.countAt(hand); count != 0.0)
            add({closest - hand, distance2, count, item.feature});
        });
    isCutShort |= !isAll;
  }
  if (m_size <= m_most) return distance;
  keepNearest();
  return std::sqrt(m_limit2);
}

SnapResult SnapSum::step(const SnapField& field, const SnapProfile& profile, const Vec3& hand) {
  SnapResult pull;
  pull.proxy = hand;
  pull.distance = profile.distance();
  if (!hand.allFinite() || profile.distance() == 0.0) return pull;
  pull.distance = gather(field, profile.distance(), hand - field.origin(), pull.isCutShort);
  const bool isShrunk = pull.distance < profile.distance();
  const SnapProfile acting = profile.within(pull.distance);
  // A snap distance that moves with the hand adds at most as much again: |dF/dls| <= largest |dF/dx| in all shapes.
  const double slope = profile.largestSlope() * (isShrunk ? 2.0 : 1.0);
  Strongest strongest(pull);
  for (std::size_t i = 0; i < m_size; ++i) {
    const Term& term = m_terms[i];
    const double x = std::sqrt(term.distance2);
    const double force = acting.force(x);
    if (x >= acting.distance()) continue;
    pull.slope += std::abs(term.count) * slope;
    strongest.add(term.feature, std::abs(term.count) * force);
    if (force > 0.0) pull.force += (term.count * force / x) * term.displacement;
  }
  return pull;
}

}  // namespace handwheel
