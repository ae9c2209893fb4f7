// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/clay/ClayMask.h"

#include "ClosedSurface.h"
#include "TestClass.h"
#include "proximity/SelfIntersection.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"
#include "volume/clay/ClayDab.h"
#include "volume/surface/VolumeToSurface.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <functional>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kEdge = 0.25;  // mm, of a voxel
constexpr double kStep = 1.0 / 65534.0;

ClayDab maskDab(const Vec3& centre, double radius, double falloff = 1.0, double strength = 1.0) {
  ClayDab dab;
  dab.action = ClayAction::Mask;
  dab.centre = centre;
  dab.radius = radius;
  dab.falloff = falloff;
  dab.strength = strength;
  return dab;
}

double shareOf(const ClayMask& mask, const VoxelIndex& voxel) {
  return mask.block(SparseVolume::blockOf(voxel)).at(VolumeBlock::at(voxel.x() & 7, voxel.y() & 7, voxel.z() & 7));
}

void eachVoxel(int reach, const std::function<void(const VoxelIndex&)>& visit) {
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x) visit({x, y, z});
}

// A dab of each action that changes a volume.
std::vector<ClayDab> dabsAt(const Vec3& centre, double radius) {
  std::vector<ClayDab> all;
  for (int action = 0; action < static_cast<int>(ClayAction::Mask); ++action) {
    ClayDab dab;
    dab.action = static_cast<ClayAction>(action);
    dab.centre = centre;
    dab.radius = radius;
    dab.displacement = Vec3(0.3, 0.4, -0.2);
    all.push_back(dab);
  }
  return all;
}

// A ball against one of a radius, mm, in samples up to a voxel from its surface: the largest error in voxels.
double worstOfBall(const SparseVolume& ball, double radius) {
  double most = 0.0;
  eachVoxel(36, [&](const VoxelIndex& at) {
    const double depth = (radius - ball.centre(at).norm()) / kEdge;
    if (std::abs(depth) < 1.0) most = std::max(most, std::abs(ball.sample(at) / VolumeBlock::kUnit - depth));
  });
  return most;
}

}  // namespace

class ClayMaskTest : public QObject {
  Q_OBJECT

 private slots:
  // Protected entirely within half the radius, then less and less as 3 t² - 2 t³ does, not at all outside.
  void edgeOfABall() {
    ClayMask mask(ballOfVoxels(1.0, kEdge));
    QVERIFY(mask.isFree());
    QVERIFY(!mask.paint(maskDab({1.0, -0.5, 0.25}, 5.0)).empty());
    QVERIFY(!mask.isFree());
    eachVoxel(28, [&](const VoxelIndex& at) {
      const double distance = (kEdge * at.cast<double>() - Vec3(1.0, -0.5, 0.25)).norm();
      const double t = std::clamp((5.0 - distance) / 2.5, 0.0, 1.0);
      QVERIFY(std::abs(shareOf(mask, at) - t * t * (3.0 - 2.0 * t)) <= 1.1 * kStep);
    });
    // Painted again nothing changes: it is no sum.
    QVERIFY(mask.paint(maskDab({1.0, -0.5, 0.25}, 5.0)).empty());
    QVERIFY(mask.paint(maskDab({1.0, -0.5, 0.25}, 5.0, 1.0, 0.7)).empty());
  }

  // A swept ball covers a capsule; without a falloff the edge is two voxels wide.
  void sweptWithAHardEdge() {
    ClayMask mask(ballOfVoxels(1.0, kEdge));
    ClayDab dab = maskDab({3.0, 0.0, 0.0}, 1.5, 0.0);
    dab.displacement = Vec3(6.0, 0.0, 0.0);
    mask.paint(dab);
    eachVoxel(24, [&](const VoxelIndex& at) {
      const Vec3 p = kEdge * at.cast<double>();
      const double inside = 1.5 - (p - Vec3(std::clamp(p.x(), -3.0, 3.0), 0.0, 0.0)).norm();
      if (inside > 2.0 * kEdge + 1e-9) QCOMPARE(shareOf(mask, at), 1.0);
      if (inside < 0.0) QCOMPARE(shareOf(mask, at), 0.0);
    });
  }

  // An inverted mask is the complement, and painting in it frees or protects as before; a mask that was freed
  // everywhere is none.
  void invertedIsTheComplement() {
    QVERIFY(rc::check("paint, free, invert", [] {
      ClayMask mask(ballOfVoxels(1.0, kEdge));
      const auto count = *rc::gen::inRange(1, 6);
      for (int i = 0; i < count; ++i) {
        const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 10.0; };
        const Vec3 at(number(-40, 40), number(-40, 40), number(-40, 40));
        mask.paint(maskDab(at, number(5, 30), number(0, 11), *rc::gen::element(1.0, -1.0, 0.5, -0.3)));
        if (*rc::gen::inRange(0, 3) == 0) mask.invert();
      }
      ClayMask other = mask;
      other.invert();
      eachVoxel(10, [&](const VoxelIndex& at) {
        RC_ASSERT(shareOf(mask, 3 * at) >= 0.0);
        RC_ASSERT(shareOf(mask, 3 * at) <= 1.0);
        RC_ASSERT(std::abs(shareOf(mask, 3 * at) + shareOf(other, 3 * at) - 1.0) < 1e-12);
      });
      ClayMask& free = mask.isInverted() ? other : mask;
      free.paint(maskDab(Vec3::Zero(), 24.0, 0.0, -1.0));
      RC_ASSERT(free.isFree());
      free.invert();
      RC_ASSERT(shareOf(free, {0, 0, 0}) == 1.0);
      free.paint(maskDab(Vec3::Zero(), 3.0, 0.0, -1.0));
      RC_ASSERT(shareOf(free, {0, 0, 0}) == 0.0);
      RC_ASSERT(shareOf(free, {40, 0, 0}) == 1.0);
    }));
  }

  void whatIsKnownToBeTheSame() {
    ClayMask mask(ballOfVoxels(1.0, kEdge));
    mask.paint(maskDab({8.0, 8.0, 8.0}, 2.0));
    ClayMask other = mask;
    QVERIFY(mask.isKnownSame(other, {0, 0, 0}));
    other.paint(maskDab({40.0, 8.0, 8.0}, 2.0));  // voxel 160: the third region along x
    QVERIFY(mask.isKnownSame(other, {0, 0, 0}));
    QVERIFY(!mask.isKnownSame(other, {2, 0, 0}));
    QVERIFY(!mask.isKnownSame(other, {1, 0, 0}));  // the last cells of this region end there
    other.invert();
    QVERIFY(!mask.isKnownSame(other, {0, 0, 0}));
  }

  void nonsenseIsNotPainted() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    ClayMask mask(ballOfVoxels(1.0, kEdge));
    for (const double bad : {nan, std::numeric_limits<double>::infinity(), -1.0, 0.0, 1e9})
      QVERIFY(mask.paint(maskDab(Vec3::Zero(), bad)).empty());
    QVERIFY(mask.paint(maskDab({nan, 0.0, 0.0}, 1.0)).empty());
    QVERIFY(mask.paint(maskDab({1e300, 0.0, 0.0}, 1.0)).empty());
    QVERIFY(mask.paint(maskDab(Vec3::Zero(), 1.0, 1.0, nan)).empty());
    QVERIFY(mask.isFree());
    QCOMPARE(mask.shareAt({nan, 0.0, 0.0}), 0.0);
    SparseVolume ball = ballOfVoxels(2.0, kEdge);
    QVERIFY(applyDab(ball, maskDab({2.0, 0.0, 0.0}, 1.0)).empty());
  }

  // Half of a ball is protected: there no dab changes a sample, and elsewhere it does what it does without a mask.
  void protectedStays() {
    const SparseVolume before = ballOfVoxels(6.0, kEdge);
    ClayMask mask(before);
    mask.paint(maskDab({-40.0, 0.0, 4.0}, 40.0, 0.0));
    for (const ClayDab& dab : dabsAt({0.5, 0.5, 5.8}, 2.0)) {
      SparseVolume with = before, without = before;
      const std::vector<VoxelIndex> changed = applyDab(with, dab, &mask);
      applyDab(without, dab);
      std::size_t protectedCount = 0, changedCount = 0;
      eachVoxel(36, [&](const VoxelIndex& at) {
        const bool isNear = (before.centre(at) - dab.centre).norm() < 2.0;
        if (shareOf(mask, at) == 1.0) {
          QCOMPARE(with.sample(at), before.sample(at));
          if (isNear && without.sample(at) != before.sample(at)) ++protectedCount;
        } else if (with.sample(at) != before.sample(at)) {
          ++changedCount;
        }
        // The mask ends at x = 0: five voxels from there nothing is known of it.
        if (before.centre(at).x() > 6.0 * kEdge) QCOMPARE(with.sample(at) > 0, without.sample(at) > 0);
      });
      QVERIFY(protectedCount > 20);
      QVERIFY(changedCount > 20);
      QVERIFY(!changed.empty());
    }
    for (const ClayDab& dab : dabsAt({-3.0, 0.0, 4.5}, 1.0)) {  // all of it is protected
      SparseVolume with = before;
      QVERIFY(applyDab(with, dab, &mask).empty());
    }
  }

  // A mask of another grid protects nothing, nor does an empty one.
  void maskOfAnotherGrid() {
    ClayMask other(SparseVolume(Vec3(0.1, 0.0, 0.0), kEdge)), empty(ballOfVoxels(1.0, kEdge));
    other.invert();
    for (const ClayDab& dab : dabsAt({0.0, 0.0, 4.0}, 2.0)) {
      SparseVolume one = ballOfVoxels(4.0, kEdge), two = one, plain = one;
      applyDab(one, dab, &other);
      applyDab(two, dab, &empty);
      applyDab(plain, dab);
      eachVoxel(24, [&](const VoxelIndex& at) {
        QCOMPARE(one.sample(at), plain.sample(at));
        QCOMPARE(two.sample(at), plain.sample(at));
      });
    }
  }

  // Under a share of one half a ball grows by half as much: a quarter of a voxel with each dab.
  void halfProtectedChangesByHalf() {
    SparseVolume ball = ballOfVoxels(5.0, kEdge);
    ClayMask mask(ball);
    mask.paint(maskDab(Vec3::Zero(), 14.0, 0.0, 0.5));
    ClayDab dab;
    dab.action = ClayAction::Inflate;
    dab.radius = 10.0;
    dab.falloff = 0.0;
    for (int i = 0; i < 12; ++i) applyDab(ball, dab, &mask);
    const double error = worstOfBall(ball, 5.0 + 12 * 0.25 * kEdge);
    QVERIFY2(error < 0.35, qPrintable(QString::number(error)));
  }

  // And a ball that is added has the rest of its radius, less the share of four voxels, however often it is added.
  void addedBallIsSmaller() {
    for (const double share : {0.25, 0.5}) {
      SparseVolume added(Vec3::Zero(), kEdge);
      ClayMask mask(added);
      mask.paint(maskDab(Vec3::Zero(), 14.0, 0.0, share));
      ClayDab dab;
      dab.action = ClayAction::Add;
      dab.radius = 6.0;
      for (int i = 0; i < 3; ++i) applyDab(added, dab, &mask);
      const double radius = (1.0 - share) * 6.0 - share * 4.0 * kEdge;
      const double error = worstOfBall(added, radius);
      QVERIFY2(error < 0.35, qPrintable(QString::number(error)));
      const double exact = 4.0 / 3.0 * M_PI * radius * radius * radius;
      QVERIFY(std::abs(added.material() - exact) < 0.02 * exact);
    }
  }

  // The surface stays closed and free of self-intersections for all masks and strokes.
  void staysClosed() {
    QVERIFY(rc::check("masked strokes", [] {
      SparseVolume volume = ballOfVoxels(3.0, kEdge);
      ClayMask mask(volume);
      const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 10.0; };
      for (int i = 0; i < 12; ++i) {
        const Vec3 at(number(-35, 35), number(-35, 35), number(-35, 35));
        const int action = *rc::gen::inRange(0, 12);
        if (action >= static_cast<int>(ClayAction::Mask)) {
          mask.paint(maskDab(at, number(5, 30), number(0, 11), *rc::gen::element(1.0, -1.0, 0.6)));
          if (action == 11) mask.invert();
          continue;
        }
        ClayDab dab = dabsAt(at, number(5, 25))[static_cast<std::size_t>(action)];
        dab.strength = number(-10, 11);
        dab.falloff = number(0, 11);
        applyDab(volume, dab, &mask);
      }
      const TriangleSoup surface = surfaceOf(volume);
      RC_ASSERT(surface.triangles.empty() || isClosedManifold(surface));
      RC_ASSERT(selfIntersections(surface.points, surface.triangles)->empty());
    }));
  }
};

HANDWHEEL_TEST(ClayMaskTest)
#include "ClayMaskTest.moc"
