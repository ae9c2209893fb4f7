// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SnapShapes.h"
#include "TestClass.h"
#include "haptics/snap/SnapProxy.h"

#include <rapidcheck.h>

#include <QtTest>
#include <optional>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kSnapProxyWalkStiffness = 0.7, kSnapProxyWalkDistance = 1.0;

// The rules for several constraints, feature by feature. For features that do not touch each other.
class Rules {
 public:
  explicit Rules(const std::vector<Simplex>& simplices) : m_simplices(simplices) {}

  std::optional<std::size_t> step(const Vec3& hand) {
    const Vec3 proxy = m_held ? m_proxy : hand;
    if (!m_held || !isInReach(*m_held, hand)) {
      m_held.reset();
      for (std::size_t d = 3; d-- > 0 && !m_held;) m_held = closest(d, proxy, hand, 1e300);
    }
    if (!m_held) return m_held;
    m_proxy = nearestOn(m_simplices[*m_held], hand).cast<double>();
    for (std::size_t d = m_simplices[*m_held].dimension(); d-- > 0;)
      if (const auto lower = closest(d, m_proxy, hand, kSnapProxyWalkDistance)) {
        m_held = lower;
        m_proxy = nearestOn(m_simplices[*m_held], hand).cast<double>();
      }
    return m_held;
  }

 private:
  bool isInReach(std::size_t i, const Vec3& hand) const {
    return distanceTo(m_simplices[i], hand) <= kSnapProxyWalkDistance;
  }

  std::optional<std::size_t> closest(std::size_t d, const Vec3& proxy, const Vec3& hand, double within) const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < m_simplices.size(); ++i) {
      const Simplex& s = m_simplices[i];
      if (s.dimension() != d || !isInReach(i, hand) || distanceTo(s, proxy) > within) continue;
      if (!best || distanceTo(s, proxy) < distanceTo(m_simplices[*best], proxy)) best = i;
    }
    return best;
  }

  const std::vector<Simplex>& m_simplices;
  std::optional<std::size_t> m_held;
  Vec3 m_proxy = Vec3::Zero();
};

// A hand that wanders, and now and then leaps: at 10 m/s, or after lost ticks.
class Wanderer {
 public:
  explicit Wanderer(std::mt19937& random, double size) : m_random(random), m_size(size) {}

  Vec3 next() {
    m_hand = m_random() % 50 == 0 ? randomIn(m_random, m_size) : Vec3(m_hand + randomIn(m_random, 0.15));
    m_hand = m_hand.cwiseMax(-m_size).cwiseMin(m_size);
    return m_hand;
  }

 private:
  std::mt19937& m_random;
  double m_size;
  Vec3 m_hand = Vec3::Zero();
};

}  // namespace

class SnapProxyWalkTest : public QObject {
  Q_OBJECT

 private slots:
  void holdsWhatTheRulesSay();
  void alwaysOnAFeatureInReach();
  void followsOverAClosedSurface();
};

void SnapProxyWalkTest::holdsWhatTheRulesSay() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto simplices = randomSimplices(random, 1 + random() % 25, 2.5, 1.0);
    const SnapField field = fieldOf(simplices);
    const SnapProfile profile(SnapShape::Quadratic, kSnapProxyWalkStiffness, kSnapProxyWalkDistance);
    SnapProxy proxy;
    Rules rules(simplices);
    Wanderer wanderer(random, 3.0);
    for (int i = 0; i < 300; ++i) {
      const Vec3 hand = wanderer.next();
      const SnapResult pull = proxy.step(field, profile, hand);
      const auto expected = rules.step(hand);
      RC_ASSERT(proxy.isHeld() == expected.has_value());
      if (!expected) continue;
      RC_ASSERT(proxy.held().id == *expected);
      RC_ASSERT(pull.featureCount == 1u && pull.features[0] == proxy.held());
    }
  }));
}

// Also for features that touch and cross.
void SnapProxyWalkTest::alwaysOnAFeatureInReach() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::vector<Simplex> simplices;
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) corners.push_back(randomIn(random, 2.0));
    for (std::size_t i = 0, n = 1 + random() % 30; i < n; ++i) {
      const Vec3 &a = corners[random() % 8], &b = corners[random() % 8], &c = corners[random() % 8];
      simplices.push_back(i % 3 == 0 ? point(a) : i % 3 == 1 ? segment(a, b) : face(a, b, c));
    }
    const SnapField field = fieldOf(simplices);
    const SnapProfile profile(SnapShape::Gaussian, kSnapProxyWalkStiffness, kSnapProxyWalkDistance);
    SnapProxy proxy;
    Wanderer wanderer(random, 3.0);
    for (int i = 0; i < 200; ++i) {
      const Vec3 hand = wanderer.next();
      const SnapResult pull = proxy.step(field, profile, hand);
      double least = 1e300;
      for (const Simplex& s : simplices) least = std::min(least, static_cast<double>(distanceTo(s, hand)));
      RC_ASSERT(proxy.isHeld() == (least <= kSnapProxyWalkDistance));
      const double x = (pull.proxy - hand).norm();
      RC_ASSERT(std::abs(pull.force.norm() - profile.force(x)) <= 1e-9);
      RC_ASSERT((pull.force.cross(pull.proxy - hand)).norm() <= 1e-9);
      if (!proxy.isHeld()) continue;
      RC_ASSERT(x <= kSnapProxyWalkDistance * (1.0 + 1e-12));
      RC_ASSERT(distanceTo(simplices[proxy.held().id], pull.proxy) <= 1e-8);
    }
  }));
}

// The faces of an octahedron, the hand just outside: the proxy is the nearest point of all of it, at every tick.
void SnapProxyWalkTest::followsOverAClosedSurface() {
  std::vector<Simplex> faces;
  for (int i = 0; i < 8; ++i)
    faces.push_back(face(Vec3(i & 1 ? 5 : -5, 0, 0), Vec3(0, i & 2 ? 5 : -5, 0), Vec3(0, 0, i & 4 ? 5 : -5)));
  const SnapField field = fieldOf(faces);
  const SnapProfile profile(SnapShape::Triangular, kSnapProxyWalkStiffness, kSnapProxyWalkDistance);
  SnapProxy proxy;
  for (int i = 0; i < 20'000; ++i) {
    const double t = 0.002 * i;
    const Vec3 direction = Vec3(std::cos(t), std::sin(t) * std::cos(0.37 * t), std::sin(t) * std::sin(0.37 * t));
    const Vec3 hand = direction * (5.3 / direction.lpNorm<1>());  // 0.17 to 0.3 mm outside
    const SnapResult pull = proxy.step(field, profile, hand);
    Real least = 1e300;
    for (const Simplex& s : faces) least = std::min(least, distanceTo(s, hand));
    QVERIFY(std::abs((pull.proxy - hand).norm() - static_cast<double>(least)) <= 1e-9);
  }
}

HANDWHEEL_TEST(SnapProxyWalkTest)
#include "SnapProxyWalkTest.moc"
