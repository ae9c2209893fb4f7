// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/clay/ClayStamp.h"

#include "../SolidShapes.h"
#include "ClosedSurface.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "proximity/SelfIntersection.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"
#include "volume/clay/ClayMask.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtTest>
#include <cmath>
#include <functional>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kTop = 12.0;  // mm, of the plate
constexpr double kCell = 0.25;

SparseVolume plate() {
  return boxOfVoxels({24.0, 24.0, kTop}, {-12.0, -12.0, 0.0}, kCell);
}

std::shared_ptr<const ClayStamp> stampOf(int width, int height, const std::function<double(double, double)>& at) {
  std::vector<float> heights;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      heights.push_back(static_cast<float>(at((column + 0.5) / width * 2.0 - 1.0, 1.0 - (row + 0.5) / height * 2.0)));
  return std::make_shared<const ClayStamp>(width, height, std::move(heights));
}

ClayDab stampDab(ClayAction action, std::shared_ptr<const ClayStamp> stamp) {
  ClayDab dab;
  dab.action = action;
  dab.centre = Vec3(0.5, -0.25, kTop);
  dab.radius = 8.0;
  dab.stamp = std::move(stamp);
  return dab;
}

double heightAt(const SparseVolume& volume, double x, double y) {
  return firstHit(volume, {x, y, 40.0}, -Vec3::UnitZ())->point.z();
}

}  // namespace

class ClayStampTest : public QObject {
  Q_OBJECT

 private slots:
  // Between the middles of cells heights are linear, beyond the last ones they stay, and outside there is none.
  void heightsBetweenCells() {
    const ClayStamp stamp(2, 1, {0.2f, 0.8f});  // the longer side goes from -1 to 1: the other from -0.5 to 0.5
    const auto isAt = [&](double x, double y, double height) { return std::abs(stamp.at(x, y) - height) < 1e-6; };
    QVERIFY(isAt(-0.5, 0.0, 0.2));
    QVERIFY(isAt(0.5, 0.3, 0.8));
    QVERIFY(isAt(0.0, -0.2, 0.5));
    QVERIFY(isAt(0.25, 0.0, 0.65));
    QVERIFY(isAt(-0.9, 0.49, 0.2));
    for (const auto& [x, y] : {std::pair(-1.01, 0.0), {1.01, 0.0}, {0.0, 0.51}, {0.0, -0.51}, {std::nan(""), 0.0}})
      QCOMPARE(stamp.at(x, y), 0.0);
    const ClayStamp upright(1, 2, {1.0f, 0.0f});  // the first row is the uppermost
    QVERIFY(std::abs(upright.at(0.0, 0.5) - 1.0) < 1e-6);
    QVERIFY(std::abs(upright.at(0.0, -0.5)) < 1e-6);
  }

  void builtIn() {
    for (int i = 0; i < kBuiltInStamps; ++i) {
      const auto stamp = builtInStamp(static_cast<BuiltInStamp>(i));
      double least = 1.0, most = 0.0;
      for (double y = -0.99; y < 1.0; y += 0.02)
        for (double x = -0.99; x < 1.0; x += 0.02) {
          least = std::min(least, stamp->at(x, y));
          most = std::max(most, stamp->at(x, y));
        }
      QVERIFY(least >= 0.0 && least < 0.05);
      QVERIFY(most <= 1.0 && most > 0.9);
    }
    const auto dome = builtInStamp(BuiltInStamp::Dome), pyramid = builtInStamp(BuiltInStamp::Pyramid);
    for (double x = -0.8; x < 0.9; x += 0.1) {
      QVERIFY(std::abs(dome->at(x, 0.3) - std::sqrt(std::max(0.0, 1.0 - x * x - 0.09))) < 0.01);
      QVERIFY(std::abs(pyramid->at(x, 0.3) - (1.0 - std::max(std::abs(x), 0.3))) < 0.02);
    }
  }

  // White is raised by a quarter of the radius over the square within the circle, and nothing beside it.
  void whiteIsAPlateau() {
    const auto white = std::make_shared<const ClayStamp>(1, 1, std::vector<float>{1.0f});
    for (const double strength : {1.0, 0.5}) {
      for (const double sign : {1.0, -1.0}) {
        SparseVolume volume = plate();
        ClayDab dab = stampDab(sign > 0.0 ? ClayAction::Add : ClayAction::Carve, white);
        dab.strength = strength;
        QVERIFY(!applyDab(volume, dab).empty());
        const double side = 8.0 / std::sqrt(2.0), height = kTop + sign * strength * 2.0;
        for (double y = -9.0; y <= 9.0; y += 0.7)
          for (double x = -9.0; x <= 9.0; x += 0.7) {
            const double outside = std::max(std::abs(x - 0.5), std::abs(y + 0.25)) - side;
            if (std::abs(outside) < 3.0 * kCell) continue;
            const double expected = outside < 0.0 ? height : kTop;
            QVERIFY2(std::abs(heightAt(volume, x, y) - expected) < 0.1 * kCell,
                     qPrintable(QString("%1 %2: %3").arg(x).arg(y).arg(heightAt(volume, x, y))));
          }
        QVERIFY(isClosedManifold(surfaceOf(volume)));
        QVERIFY(std::abs(volume.material() - 24.0 * 24.0 * kTop - sign * strength * 2.0 * 4.0 * side * side) <
                0.05 * strength * 8.0 * side * side);
      }
    }
  }

  // A slope is one, by the axes of the dab.
  void aSlopeIsTurned() {
    const auto slope = stampOf(64, 64, [](double x, double) { return 0.5 + 0.5 * x; });
    const double side = 8.0 / std::sqrt(2.0);
    for (const double turn : {0.0, 0.5 * M_PI, 0.6}) {
      SparseVolume volume = plate();
      ClayDab dab = stampDab(ClayAction::Add, slope);
      dab.right = Vec3(std::cos(turn), std::sin(turn), 0.0);
      dab.up = Vec3(-std::sin(turn), std::cos(turn), 0.0);
      applyDab(volume, dab);
      for (double v = -4.0; v <= 4.0; v += 0.8)
        for (double u = -4.0; u <= 4.0; u += 0.8) {
          const Vec3 at = dab.centre + u * dab.right + v * dab.up;
          const double expected = kTop + 2.0 * (0.5 + 0.5 * u / side);
          QVERIFY2(std::abs(heightAt(volume, at.x(), at.y()) - expected) < 0.15 * kCell,
                   qPrintable(QString("%1 %2: %3").arg(u).arg(v).arg(heightAt(volume, at.x(), at.y()) - expected)));
        }
    }
  }

  // Material beyond the radius along the direction does not change: the other side of the plate.
  void theFarSideStays() {
    SparseVolume volume = plate();
    ClayDab dab = stampDab(ClayAction::Carve, std::make_shared<const ClayStamp>(1, 1, std::vector<float>{1.0f}));
    dab.radius = 5.0;  // less than the plate is thick
    applyDab(volume, dab);
    for (double x = -6.0; x <= 6.0; x += 0.9) {
      const auto below = firstHit(volume, {x, 0.0, -40.0}, Vec3::UnitZ());
      QVERIFY(below && std::abs(below->point.z()) < 1e-3);
    }
  }

  // Stamped on a ball and its mirror image; what is masked stays.
  void mirroredAndMasked() {
    const auto stamp = stampOf(32, 32, [](double x, double y) { return x > 0.0 && y > 0.0 ? 1.0 : 0.0; });
    ClayDab dab = stampDab(ClayAction::Add, stamp);
    dab.centre = Vec3(3.0, 1.0, 5.0);
    dab.radius = 2.5;
    dab.direction = dab.centre.normalized();
    dab.right = Vec3::UnitY().cross(dab.direction).normalized();
    dab.up = dab.direction.cross(dab.right);
    SparseVolume one = ballOfVoxels(dab.centre.norm(), kCell), other = one, masked = one;
    const SparseVolume before = one;
    QVERIFY(!applyDab(one, dab).empty());
    QVERIFY(!applyDab(other, mirrored(dab, Vec3::Zero(), 0)).empty());
    const VolumeSampler first(one), second(other);
    int changed = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 p = dab.centre + 3.0 * Vec3(std::sin(i), std::sin(3.0 * i + 1.0), std::cos(2.0 * i));
      const Vec3 reversed(-p.x(), p.y(), p.z());
      // Further from the surface depths depend on the blocks, which are not mirrored.
      const double depth = first.depthAt(p).depth, image = second.depthAt(reversed).depth;
      if (std::abs(depth) < 1.5 * kCell)
        QVERIFY2(std::abs(depth - image) < 0.04 * kCell, qPrintable(QString("%1 %2").arg(depth).arg(image)));
      if (std::abs(first.depthAt(p).depth - VolumeSampler(before).depthAt(p).depth) > 0.1 * kCell) ++changed;
    }
    QVERIFY(changed > 30);
    ClayMask all(before);
    all.invert();
    QVERIFY(applyDab(masked, dab, &all).empty());
  }

  // However steep a stamp is, the surface stays closed and meets itself nowhere.
  void staysClosed() {
    const auto noise = stampOf(64, 64, [](double x, double y) {
      return std::abs(std::sin(1000.0 * std::sin(37.0 * x + 91.0 * y) + 13.0 * y));
    });
    SparseVolume volume = ballOfVoxels(5.0, kCell);
    for (int i = 0; i < 8; ++i) {
      ClayDab dab = stampDab(i % 3 == 2 ? ClayAction::Carve : ClayAction::Add, noise);
      dab.direction = Vec3(std::sin(i), std::cos(2.0 * i), std::cos(i)).normalized();
      dab.centre = 5.0 * dab.direction;
      dab.right = dab.direction.unitOrthogonal();
      dab.up = dab.direction.cross(dab.right);
      dab.radius = 4.0;
      applyDab(volume, dab);
    }
    const TriangleSoup surface = surfaceOf(volume);
    QVERIFY(isClosedManifold(surface));
    QVERIFY(selfIntersections(surface.points, surface.triangles)->empty());
  }

  // The heights of a ball over the plane are those of the upper half, and 0 beside it.
  void ofASurface() {
    const auto stamp = stampOfSurface(moved(icosphere(5), {7.0, -3.0, 100.0}, 20.0));
    QVERIFY(stamp);
    for (double y = -0.95; y < 1.0; y += 0.1)
      for (double x = -0.95; x < 1.0; x += 0.1) {
        const double square = 1.0 - x * x - y * y;
        if (std::abs(square) < 0.05) continue;
        // The lowest point that is visible from above lies at the rim.
        const double expected = square > 0.0 ? std::sqrt(square) : 0.0;
        QVERIFY2(std::abs(stamp->at(x, y) - expected) < 0.1,
                 qPrintable(QString("%1 %2: %3").arg(x).arg(y).arg(stamp->at(x, y))));
      }
    QVERIFY(!stampOfSurface({}));
    const TriangleSoup flat{{{0.0, 0.0, 1.0}, {4.0, 0.0, 1.0}, {0.0, 4.0, 1.0}}, {{0, 1, 2}}};
    QVERIFY(!stampOfSurface(flat));
    const TriangleSoup upright{{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 0.0, 4.0}}, {{0, 1, 2}}};
    QVERIFY(!stampOfSurface(upright));
    const TriangleSoup endless{{{0.0, 0.0, 0.0}, {INFINITY, 0.0, 0.0}, {0.0, 1.0, 4.0}}, {{0, 1, 2}}};
    QVERIFY(!stampOfSurface(endless));
  }
};

HANDWHEEL_TEST(ClayStampTest)
#include "ClayStampTest.moc"
