// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/clay/ClayDab.h"

#include "ClosedSurface.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "proximity/SelfIntersection.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"
#include "volume/surface/VolumeToSurface.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <functional>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kClayVoxel = 0.25;  // mm

// The signs and, up to some voxels from the surface, the depths of all samples around the origin against a function
// that gives the depth, mm. Returns the largest error, voxels.
double worst(const SparseVolume& volume, const std::function<double(const Vec3&)>& depth, int reach,
             double band = 3.0) {
  double most = 0.0;
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x) {
        const VoxelIndex at(x, y, z);
        const double expected = depth(volume.centre(at)) / volume.voxel(),
                     found = volume.sample(at) / VolumeBlock::kUnit;
        if (std::abs(expected) < 1e-3) continue;
        const double limited = std::clamp(expected, -band, band);
        most = std::max(most, std::abs(std::clamp(found, -band, band) - limited));
      }
  return most;
}

ClayDab dabOf(ClayAction action, const Vec3& centre, double radius) {
  ClayDab dab;
  dab.action = action;
  dab.centre = centre;
  dab.radius = radius;
  dab.falloff = 0.0;
  return dab;
}

// Returns true if an error is below a limit, and prints it otherwise.
bool isBelow(double error, double limit) {
  if (error < limit) return true;
  qWarning() << error << "is not below" << limit;
  return false;
}

double depthOfBall(const Vec3& p, double radius) {
  return radius - p.norm();
}

}  // namespace

class ClayDabTest : public QObject {
  Q_OBJECT

 private slots:
  void ballIsExact() {
    const SparseVolume ball = ballOfVoxels(6.0, kClayVoxel);
    QVERIFY(isBelow(worst(
                        ball, [](const Vec3& p) { return depthOfBall(p, 6.0); }, 30),
                    1e-4));
    const double exact = 4.0 / 3.0 * M_PI * 216.0;
    QVERIFY(isBelow(std::abs(ball.material() - exact), 0.004 * exact));
  }

  // Union and difference of balls have the signs of the shapes, and depths that are never too large.
  void addAndCarve() {
    const Vec3 at(5.0, 1.0, -2.0);
    SparseVolume added = ballOfVoxels(6.0, kClayVoxel), carved = added;
    QVERIFY(!applyDab(added, dabOf(ClayAction::Add, at, 4.0)).empty());
    QVERIFY(!applyDab(carved, dabOf(ClayAction::Carve, at, 4.0)).empty());
    const auto two = [&](const Vec3& p) { return std::max(depthOfBall(p, 6.0), depthOfBall(p - at, 4.0)); };
    const auto less = [&](const Vec3& p) { return std::min(depthOfBall(p, 6.0), -depthOfBall(p - at, 4.0)); };
    QVERIFY(isBelow(worst(added, two, 40), 1e-3));
    QVERIFY(isBelow(worst(carved, less, 40), 1e-3));
    // Nothing is left of the one when the other goes around it.
    QVERIFY(!applyDab(carved, dabOf(ClayAction::Carve, Vec3::Zero(), 7.0)).empty());
    QVERIFY(carved.isEmpty());
    QCOMPARE(carved.material(), 0.0);
  }

  // A swept ball removes the same material as a capsule.
  void sweptBall() {
    SparseVolume carved = ballOfVoxels(6.0, kClayVoxel);
    ClayDab dab = dabOf(ClayAction::Carve, {4.0, 3.0, 2.0}, 1.5);
    dab.displacement = Vec3(5.0, 1.0, -1.0);
    QVERIFY(!applyDab(carved, dab).empty());
    const auto less = [&](const Vec3& p) {
      double nearest = std::numeric_limits<double>::infinity();  // by testing positions along the displacement
      for (int i = 0; i <= 2000; ++i)
        nearest = std::min(nearest, (p - dab.centre + i / 2000.0 * dab.displacement).norm());
      return std::min(depthOfBall(p, 6.0), nearest - 1.5);
    };
    QVERIFY(isBelow(worst(carved, less, 26), 0.02));
  }

  // A ball within the radius grows by half a voxel with each dab, and shrinks by as much: depths stay distances.
  void inflateOftenAndBack() {
    SparseVolume ball = ballOfVoxels(5.0, kClayVoxel);
    ClayDab dab = dabOf(ClayAction::Inflate, Vec3::Zero(), 12.0);
    for (int i = 0; i < 24; ++i) applyDab(ball, dab);
    QVERIFY(isBelow(worst(
                        ball, [](const Vec3& p) { return depthOfBall(p, 8.0); }, 40, 2.0),
                    0.8));
    QVERIFY(isBelow(worst(
                        ball, [](const Vec3& p) { return depthOfBall(p, 8.0); }, 40, 0.5),
                    0.4));
    dab.strength = -1.0;
    for (int i = 0; i < 24; ++i) applyDab(ball, dab);
    QVERIFY(isBelow(worst(
                        ball, [](const Vec3& p) { return depthOfBall(p, 5.0); }, 40, 0.5),
                    0.5));
  }

  // A ball goes with the tool when all of it is within the radius.
  void moveIsATranslation() {
    SparseVolume ball = ballOfVoxels(3.0, kClayVoxel);
    Vec3 centre = Vec3::Zero();
    for (int i = 0; i < 6; ++i) {
      ClayDab dab = dabOf(ClayAction::Move, centre, 9.0);
      dab.displacement = Vec3(0.4, -0.25, 0.1);
      applyDab(ball, dab);
      centre += dab.displacement;
    }
    QVERIFY(isBelow(worst(
                        ball, [&](const Vec3& p) { return depthOfBall(p - centre, 3.0); }, 36, 1.0),
                    0.3));
  }

  // A cube is smudged over the middle of its top: an even surface does not change, for any displacement. A bump there
  // is drawn out along the displacement: its middle moves along, its top sinks, and its material stays, to some per
  // cent.
  void smudgeMovesABump() {
    SparseVolume even = volumeOfSurface(moved(cube(16.0), Vec3(-8.0, -8.0, -16.0)), kClayVoxel)->volume, bumpy = even;
    const double material = even.material();
    const auto smudge = [](SparseVolume& volume, const Vec3& displacement) {
      ClayDab dab = dabOf(ClayAction::Smudge, {-3.0, 0.0, 0.0}, 4.0);
      dab.falloff = 1.0;
      dab.displacement = displacement;
      for (int i = 0; i < 30; ++i) {
        applyDab(volume, dab);
        dab.centre.x() += displacement.x();
      }
    };
    smudge(even, {0.2, 0.0, 0.3});
    smudge(even, {0.0, 0.0, -0.5});
    const VolumeSampler flat(even);
    for (int i = 0; i < 100; ++i)
      QVERIFY(std::abs(flat.depthAt({6.0 * std::sin(i), 6.0 * std::cos(3.0 * i), -0.1}).depth - 0.1) <
              0.1 * kClayVoxel);
    QVERIFY(isBelow(std::abs(even.material() / material - 1.0), 1e-4));

    applyDab(bumpy, dabOf(ClayAction::Add, {-2.0, 0.0, -2.4}, 3.2));  // a cap of 0.8 mm
    struct Bump {
      double material = 0.0, middle = 0.0, top = 0.0;  // mm³, mm along x, mm
    };
    const auto bumpOf = [&](const SparseVolume& volume) {
      Bump bump;
      const VoxelIndex zero = (-volume.origin() / volume.voxel()).array().round().cast<int>().matrix();
      for (int z = -2; z <= 12; ++z)
        for (int y = -28; y <= 28; ++y)
          for (int x = -28; x <= 28; ++x) {
            const VoxelIndex at = zero + VoxelIndex(x, y, z);
            const Vec3 p = volume.centre(at);
            const double share = std::clamp(0.5 + volume.sample(at) / VolumeBlock::kUnit, 0.0, 1.0);
            const double before = std::clamp(0.5 - p.z() / kClayVoxel, 0.0, 1.0),
                         more = (share - before) * std::pow(kClayVoxel, 3);
            bump.material += more;
            bump.middle += more * p.x();
            if (share > 0.5) bump.top = std::max(bump.top, p.z());
          }
      bump.middle /= bump.material;
      return bump;
    };
    const Bump made = bumpOf(bumpy);
    const double cap = M_PI * 0.64 * (3.0 * 3.2 - 0.8) / 3.0;
    QVERIFY(isBelow(std::abs(made.material / cap - 1.0), 0.05));
    smudge(bumpy, {0.2, 0.0, 0.0});
    const Bump drawn = bumpOf(bumpy);
    QVERIFY(isBelow(made.middle + 0.5, drawn.middle));
    QVERIFY(isBelow(drawn.top, 0.9 * made.top));
    // It is smoothed, too, which takes some of a bump as small as this.
    QVERIFY2(drawn.material > 0.7 * made.material && drawn.material < 1.1 * made.material,
             qPrintable(QString("%1 of %2").arg(drawn.material).arg(made.material)));
    QVERIFY(isClosedManifold(surfaceOf(bumpy)));
  }

  // A move by a quarter of the distance to the centre is 1 / 1.25 of the radius.
  void attractIsAScaling() {
    SparseVolume ball = ballOfVoxels(5.0, kClayVoxel);
    applyDab(ball, dabOf(ClayAction::Attract, Vec3::Zero(), 12.0));
    QVERIFY(isBelow(worst(
                        ball, [](const Vec3& p) { return depthOfBall(p, 4.0); }, 30, 1.0),
                    0.15));
  }

  // Along its direction a pinch changes no size, across it is a scaling.
  void pinchIsAScalingAcross() {
    SparseVolume ball = ballOfVoxels(5.0, kClayVoxel);
    ClayDab dab = dabOf(ClayAction::Pinch, Vec3::Zero(), 12.0);
    dab.direction = Vec3::UnitX();
    applyDab(ball, dab);
    const VolumeSampler sampler(ball);
    QVERIFY(isBelow(std::abs(sampler.depthAt({5.0, 0.0, 0.0}).depth), 0.1 * kClayVoxel));
    QVERIFY(isBelow(std::abs(sampler.depthAt({0.0, 4.0, 0.0}).depth), 0.1 * kClayVoxel));
    QVERIFY(isBelow(std::abs(sampler.depthAt({0.0, 0.0, -4.0}).depth), 0.1 * kClayVoxel));
  }

  // A cap becomes a plane, from both sides.
  void flattenMakesAPlane() {
    SparseVolume ball = ballOfVoxels(10.0, kClayVoxel);
    ClayDab dab = dabOf(ClayAction::Flatten, {0.0, 0.0, 10.0}, 3.0);
    for (int i = 0; i < 12; ++i) applyDab(ball, dab);
    const VolumeSampler sampler(ball);
    const double middle = firstHit(ball, {0.0, 0.0, 20.0}, -Vec3::UnitZ())->point.z();
    for (const Vec3& at : {Vec3(1.0, 0.0, 20.0), Vec3(-0.7, 0.7, 20.0), Vec3(0.0, -1.5, 20.0)}) {
      const auto hit = firstHit(ball, at, -Vec3::UnitZ());
      QVERIFY(hit);
      QVERIFY2(std::abs(hit->point.z() - middle) < 0.1 * kClayVoxel,
               qPrintable(QString::number(hit->point.z() - middle)));
    }
  }

  // Bumps go, and the ball stays.
  void smoothTakesBumps() {
    SparseVolume ball = ballOfVoxels(8.0, kClayVoxel);
    for (int i = 0; i < 40; ++i) {
      const Vec3 displacement(std::sin(3.0 * i), std::cos(5.0 * i), std::sin(7.0 * i + 1.0));
      applyDab(ball, dabOf(i % 2 ? ClayAction::Add : ClayAction::Carve, 8.0 * displacement.normalized(), 0.6));
    }
    const auto roughness = [&] {
      double sum = 0.0, squares = 0.0;
      const TriangleSoup surface = surfaceOf(ball);
      for (const Vec3& p : surface.points) {
        sum += p.norm();
        squares += p.squaredNorm();
      }
      const auto n = static_cast<double>(surface.points.size());
      return std::sqrt(std::max(0.0, squares / n - sum / n * sum / n));
    };
    const double before = roughness(), material = ball.material();
    for (int i = 0; i < 6; ++i) applyDab(ball, dabOf(ClayAction::Smooth, Vec3::Zero(), 16.0));
    QVERIFY2(roughness() < 0.5 * before, qPrintable(QString("%1 of %2").arg(roughness()).arg(before)));
    QVERIFY(isBelow(std::abs(ball.material() - material), 0.08 * material));
  }

  // For any sequence of dabs, the surface is sound, nothing far from the dab changes, and exactly the reported blocks
  // have changed.
  void anyDabs() {
    QVERIFY(rc::check([] {
      SparseVolume volume = ballOfVoxels(1.5, kClayVoxel);
      const auto number = [](double most) { return *rc::gen::inRange(-1000, 1001) / 1000.0 * most; };
      for (int i = 0; i < 6; ++i) {
        ClayDab dab;
        dab.action = static_cast<ClayAction>(*rc::gen::inRange(0, static_cast<int>(ClayAction::Mask)));
        dab.centre = Vec3(number(2.0), number(2.0), number(2.0));
        dab.radius = 0.3 + std::abs(number(1.5));
        dab.strength = number(1.0);
        dab.falloff = std::abs(number(1.0));
        dab.displacement = Vec3(number(1.0), number(1.0), number(1.0));
        const SparseVolume before = volume;
        const std::vector<VoxelIndex> changed = applyDab(volume, dab);
        std::size_t different = 0;
        for (int z = -6; z < 6; ++z)
          for (int y = -6; y < 6; ++y)
            for (int x = -6; x < 6; ++x) {
              const VoxelIndex block(x, y, z);
              if (volume.content(block) == before.content(block)) continue;
              ++different;
              RC_ASSERT(std::find(changed.begin(), changed.end(), block) != changed.end());
              const Vec3 low = volume.centre(8 * block), high = volume.centre(8 * block + VoxelIndex::Constant(7));
              RC_ASSERT(Box(low, high).exteriorDistance(dab.centre) <=
                        dab.radius + dab.displacement.norm() + 11.0 * kClayVoxel);
            }
        RC_ASSERT(different == changed.size());
      }
      const TriangleSoup surface = surfaceOf(volume);
      RC_ASSERT(surface.triangles.empty() || isClosedManifold(surface));
      RC_ASSERT(selfIntersections(surface.points, surface.triangles)->empty());
    }));
  }

  // The mirror image of a dab does the mirror image of what it does.
  void mirrorImage() {
    const auto reversed = [](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); };
    for (int action = 0; action < static_cast<int>(ClayAction::Mask); ++action) {
      SparseVolume one = ballOfVoxels(4.0, kClayVoxel), other = one;
      ClayDab dab = dabOf(static_cast<ClayAction>(action), {3.0, 1.0, 1.5}, 2.0);
      dab.displacement = Vec3(0.3, 0.2, -0.1);
      dab.direction = Vec3(1.0, 2.0, -2.0) / 3.0;
      applyDab(one, dab);
      applyDab(other, mirrored(dab, Vec3::Zero(), 0));
      const VolumeSampler first(one), second(other);
      for (int i = 0; i < 500; ++i) {
        const Vec3 p(std::sin(i) * 5.0, std::sin(3.0 * i + 1.0) * 5.0, std::cos(2.0 * i) * 5.0);
        QVERIFY(isBelow(std::abs(first.depthAt(p).depth - second.depthAt(reversed(p)).depth), 1e-3));
      }
    }
  }

  void whatMakesNoSense() {
    SparseVolume volume = ballOfVoxels(3.0, kClayVoxel);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, std::numeric_limits<double>::infinity(), -1.0, 0.0, 1e9}) {
      QVERIFY(applyDab(volume, dabOf(ClayAction::Carve, Vec3::Zero(), bad)).empty());
    }
    QVERIFY(applyDab(volume, dabOf(ClayAction::Carve, {nan, 0.0, 0.0}, 1.0)).empty());
    QVERIFY(applyDab(volume, dabOf(ClayAction::Carve, {1e300, 0.0, 0.0}, 1.0)).empty());
    QVERIFY(applyDab(volume, dabOf(ClayAction::Smooth, {100.0, 0.0, 0.0}, 1.0)).empty());
    ClayDab none = dabOf(ClayAction::Inflate, Vec3(0.0, 0.0, 3.0), 1.0);
    none.strength = nan;
    QVERIFY(applyDab(volume, none).empty());
  }
};

HANDWHEEL_TEST(ClayDabTest)
#include "ClayDabTest.moc"
