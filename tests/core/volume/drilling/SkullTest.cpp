// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/Skull.h"

#include "ClosedSurface.h"
#include "TestClass.h"
#include "volume/VolumeSampler.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <cmath>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

double outOf(const Vec3& p, const Vec3& half) {
  return p.cwiseQuotient(half).norm();
}

}  // namespace

class SkullTest : public QObject {
  Q_OBJECT

 private slots:
  // The tables are where their ellipsoids are: on the axes and at the burr hole.
  void tablesAreEllipsoids() {
    const SparseVolume skull = skullOfVoxels(0.8);
    const auto first = firstHit(skull, {0.0, 0.0, 100.0}, -Vec3::UnitZ());
    QVERIFY(first && std::abs(first->point.z() - 66.0) < 0.05);
    const auto side = firstHit(skull, {100.0, 0.0, 0.0}, -Vec3::UnitX());
    QVERIFY(side && std::abs(side->point.x() - 72.0) < 0.05);
    const auto behind = firstHit(skull, {0.0, 150.0, 0.0}, -Vec3::UnitY());
    QVERIFY(behind && std::abs(behind->point.y() - 90.0) < 0.05);
    const auto inside = firstHit(skull, Vec3::Zero(), Vec3::UnitZ());
    QVERIFY(inside && std::abs(inside->point.z() - 59.5) < 0.05);
    const SkullSite site = skullSite();
    QVERIFY(std::abs(outOf(site.entry, Skull::kOuter) - 1.0) < 1e-12);
    const auto hit = firstHit(skull, site.entry - 20.0 * site.direction, site.direction);
    QVERIFY(hit && (hit->point - site.entry).norm() < 0.05);
    QVERIFY(hit->normal.dot(-site.direction) > 0.999);
  }

  // The material is what points thrown at random find by the equations of the bodies.
  void materialByThrownPoints() {
    const SparseVolume skull = skullOfVoxels(0.8);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const Vec3 low(-75.0, -97.0, -100.0), size(150.0, 190.0, 170.0);
    const int count = 400'000;
    int inside = 0, wrong = 0;
    const VolumeSampler sampler(skull);
    for (int i = 0; i < count; ++i) {
      const Vec3 p = low + size.cwiseProduct(Vec3(unit(random), unit(random), unit(random)));
      const auto in = [&](const Vec3& centre, const Vec3& half) { return outOf(p - centre, half) < 1.0; };
      const bool isBone = (in({0, 0, 0}, {72, 90, 66}) || in({0, -50, -50}, {56, 38, 46})) &&
                          !in({0, 0, 0}, {65.5, 83.5, 59.5}) && !in({-30, -84, -44}, {18, 24, 16}) &&
                          !in({30, -84, -44}, {18, 24, 16}) && !in({0, -88, -68}, {11, 22, 14}) &&
                          !in({0, 18, -66}, {15, 18, 16});
      inside += isBone;
      const double depth = sampler.depthAt(p).depth;
      wrong += isBone != (depth > 0.0) && std::abs(depth) > 0.4;  // half a voxel: where bodies meet at an edge
    }
    QCOMPARE(wrong, 0);
    const double expected = size.prod() * inside / count, share = static_cast<double>(inside) / count;
    const double spread = size.prod() * std::sqrt(share * (1.0 - share) / count);
    QVERIFY(std::abs(skull.material() - expected) < 5.0 * spread);
  }

  // The skull looks along -y, as a patient's does, and so at the viewer of the front view: there is the face with the
  // openings of its eyes and nose, and the great foramen lies behind the middle of the base.
  void looksForwards() {
    const SparseVolume skull = skullOfVoxels(1.0);
    const auto fromFront = [&](double x, double z) { return firstHit(skull, {x, -150.0, z}, Vec3::UnitY()); };
    const auto bridge = fromFront(0.0, -44.0), nose = fromFront(0.0, -68.0);
    QVERIFY(bridge && nose && nose->point.y() > bridge->point.y() + 10.0);
    for (const double side : {-1.0, 1.0}) {
      const auto eye = fromFront(30.0 * side, -44.0);
      QVERIFY(eye && eye->point.y() > bridge->point.y() + 10.0);
    }
    // From behind there is the vault alone: nothing is as low as the face, and no opening.
    QVERIFY(!firstHit(skull, {0.0, 150.0, -70.0}, -Vec3::UnitY()) ||
            firstHit(skull, {0.0, 150.0, -70.0}, -Vec3::UnitY())->point.y() < 0.0);
    QVERIFY(!firstHit(skull, {0.0, 18.0, -150.0}, Vec3::UnitZ()) ||
            firstHit(skull, {0.0, 18.0, -150.0}, Vec3::UnitZ())->point.z() > 0.0);
    QVERIFY(skullSite().entry.y() < 0.0);  // the burr hole is at the forehead
  }

  // One closed surface; orbits and nose do not open the room of the brain.
  void surfaceIsClosed() {
    const SparseVolume skull = skullOfVoxels(1.0);
    QVERIFY(isClosedManifold(surfaceOf(skull)));
    // A line from the cranial cavity to the front meets bone at all heights and sides of orbits and nose.
    for (double z = -58.0; z <= 0.0; z += 2.0)
      for (double x = -50.0; x <= 50.0; x += 2.0) {
        const Vec3 from(x, 0.0, z);
        if (outOf(from, Skull::kInner) < 0.98) QVERIFY(firstHit(skull, from, -Vec3::UnitY()).has_value());
      }
  }

  // The brain is inside of the inner table everywhere, and leaves room below the burr hole.
  void brainHasRoom() {
    for (const SolidBall& ball : skullBrain()) {
      double nearest = 1e9;
      for (int i = 0; i <= 60; ++i)
        for (int k = 0; k < 120; ++k) {
          const double polar = M_PI * i / 60, around = 2.0 * M_PI * k / 120;
          const Vec3 on = Skull::kInner.cwiseProduct(
              Vec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)));
          nearest = std::min(nearest, (on - ball.centre).norm() - ball.radius);
        }
      QVERIFY2(nearest > 2.0 && nearest < 8.0, qPrintable(QString::number(nearest)));
    }
  }
};

HANDWHEEL_TEST(SkullTest)
#include "SkullTest.moc"
