// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/ThinParts.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "volume/SurfaceToVolume.h"
#include "volume/repair/VolumeRepair.h"

#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

TriangleSoup block(const Vec3& sizes, const Vec3& first = Vec3::Zero()) {
  TriangleSoup made = cube(1.0);
  for (Vec3& p : made.points) p = first + sizes.cwiseProduct(p);
  return made;
}

TriangleSoup turned(TriangleSoup soup) {
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.3, Vec3::UnitX()) * Eigen::AngleAxisd(0.5, Vec3::UnitY()) *
                                Eigen::AngleAxisd(0.7, Vec3::UnitZ()))
                                   .toRotationMatrix();
  for (Vec3& p : soup.points) p = turn * p;
  return soup;
}

// Two planes that meet at this angle (degrees) in an edge along y, closed where they are 20 mm from it.
TriangleSoup wedge(double angle) {
  const double half = 20.0 * std::tan(0.5 * angle * M_PI / 180.0);
  TriangleSoup made;
  made.points = {{0, 0, 0}, {0, 20, 0}, {20, 0, half}, {20, 20, half}, {20, 0, -half}, {20, 20, -half}};
  made.triangles = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}, {2, 4, 3}, {3, 4, 5}, {0, 4, 2}, {1, 3, 5}};
  return made;
}

ThinFigures thin(const TriangleSoup& surface, ThinKind kind, double voxel = 0.5) {
  const Result<SurfaceVolume> made = volumeOfSurface(surface, voxel);
  return made ? thinFigures(made->thin, kind, made->volume) : ThinFigures{};
}

}  // namespace

class ThinPartsTest : public QObject {
  Q_OBJECT

 private slots:
  // A plate of 30 × 30 × 0.3 mm has 2 · 900 + 4 · 9 = 1836 mm² of surface, and encloses 270 mm³.
  void plates() {
    for (const TriangleSoup& plate : {block({30, 30, 0.3}), turned(block({30, 30, 0.3}))}) {
      const Result<VolumeRepair> repair = repairByVolume(plate, {.voxel = 0.5});
      QVERIFY(repair.hasValue());
      QVERIFY(std::abs(repair->enclosed - 270.0) < 1e-6);
      QCOMPARE(repair->walls.below, 1.0);
      QVERIFY(std::abs(repair->walls.area - 1836.0) < 20.0);
      QVERIFY(std::abs(repair->walls.least - 0.3) < 1e-6);
      // Half of the volume or more is lost, and so it is said of most of the surface.
      QVERIFY(repair->walls.isChanged() && repair->walls.changedShare > 0.8);
      QCOMPARE(repair->gaps.area, 0.0);
    }
    QCOMPARE(thin(block({30, 30, 1.1}), ThinKind::Walls).area, 0.0);
    const ThinFigures kept = thin(block({30, 30, 0.9}), ThinKind::Walls);
    QVERIFY(kept.area > 1800.0 && !kept.isChanged());
    QVERIFY(std::abs(kept.least - 0.9) < 1e-6);
  }

  // Nothing of a solid is thin at its edges and corners, down to angles of 45°.
  void sharpEdges() {
    TriangleSoup tetrahedron;
    tetrahedron.points = {{10, 10, 10}, {10, -10, -10}, {-10, 10, -10}, {-10, -10, 10}};
    tetrahedron.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    for (const TriangleSoup& solid : {cube(20.0), turned(cube(20.0)), moved(icosphere(4), Vec3::Zero(), 10.0),
                                      tetrahedron, wedge(60.0), turned(wedge(45.0))})
      for (const ThinKind kind : {ThinKind::Walls, ThinKind::Gaps}) QCOMPARE(thin(solid, kind).area, 0.0);
  }

  // A wedge is thin where no ball of 1 mm fits within 1.5 mm: at 10° the ball is 0.5 / sin 5° = 5.74 mm from the edge.
  void tapersToAnEdge() {
    const ThinFigures edge = thin(wedge(10.0), ThinKind::Walls);
    const double strip = 0.5 / std::sin(5.0 * M_PI / 180.0) - 1.5;  // at least, on either side
    QVERIFY2(edge.area > 2.0 * 20.0 * strip && edge.area < 2.0 * 20.0 * (strip + 0.5),
             qPrintable(QString::number(edge.area)));
    QVERIFY(edge.least < 0.05 && edge.at.x() < 0.5);
    QVERIFY(edge.isChanged() && edge.changedShare < 0.1);
  }

  // A ball whose wall is 0.3 mm is thin all over; a needle of 0.4 mm, too.
  void shellsAndNeedles() {
    TriangleSoup shell = moved(icosphere(4), Vec3::Zero(), 10.0);
    append(shell, turnedOver(moved(icosphere(4), Vec3::Zero(), 9.7)));
    const ThinFigures all = thin(shell, ThinKind::Walls);
    QVERIFY(all.share > 0.99 && std::abs(all.least - 0.3) < 0.002 && all.isChanged());
    const ThinFigures needle = thin(turned(block({0.4, 0.4, 20})), ThinKind::Walls);
    QVERIFY(needle.share > 0.99 && std::abs(needle.least - 0.4) < 1e-6 && needle.isChanged());
  }

  // A rib of 14 × 0.3 × 4 mm on a block: 2 · 56 + 2 · 1.2 + 4.2 mm² of it, less what is next to the block.
  void ribOnABlock() {
    TriangleSoup part = block({20, 20, 10});
    append(part, block({14, 0.3, 5}, Vec3(3, 3, 9)));
    const ThinFigures rib = thin(part, ThinKind::Walls);
    QVERIFY2(rib.area > 75.0 && rib.area < 130.0, qPrintable(QString::number(rib.area)));
    QVERIFY(rib.share < 0.08 && rib.at.z() > 10.0 && rib.isChanged());
  }

  // Between two blocks, 20 × 20 mm face each other at 0.3 mm. At 1.1 mm they are more than two voxels apart. Where gaps
  // are to be filled they are no surprise.
  void gaps() {
    const auto blocks = [](double gap) {
      TriangleSoup both = block({20, 20, 5});
      append(both, block({20, 20, 5}, Vec3(0, 0, 5 + gap)));
      return both;
    };
    const ThinFigures filled = thin(blocks(0.3), ThinKind::Gaps);
    QVERIFY(std::abs(filled.area - 800.0) < 20.0 && std::abs(filled.least - 0.3) < 1e-6 && filled.isChanged());
    const ThinFigures kept = thin(blocks(0.9), ThinKind::Gaps);
    QVERIFY(std::abs(kept.area - 800.0) < 20.0 && !kept.isChanged());
    QCOMPARE(thin(blocks(1.1), ThinKind::Gaps).area, 0.0);
    QCOMPARE(thin(blocks(0.3), ThinKind::Walls).area, 0.0);
    const Result<VolumeRepair> wanted = repairByVolume(blocks(0.3), {.voxel = 0.5, .gaps = 0.5});
    QVERIFY(wanted.hasValue());
    QCOMPARE(wanted->gaps.area, 0.0);
  }
};

HANDWHEEL_TEST(ThinPartsTest)
#include "ThinPartsTest.moc"
