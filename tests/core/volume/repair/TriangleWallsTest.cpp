// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/TriangleWalls.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/search/FaceHierarchy.h"
#include "mesh/structure/MeshBuilder.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"
#include "volume/surface/VolumeToSurface.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

using namespace handwheel;

class TriangleWallsTest : public QObject {
  Q_OBJECT

 private slots:
  // Each is closed, faces outward, and has the area of its triangle times the thickness.
  void prisms() {
    std::mt19937 random(3);
    TriangleSoup soup = test::randomSoup(random, 20, 50);
    soup.triangles.push_back({0, 0, 1});
    const TriangleSoup walls = wallsOf(soup, 0.25);
    QVERIFY(test::countEdges(walls).sound());
    QVERIFY(std::abs(measureForWalls(soup).areaWith(0.25) / test::area(walls) - 1.0) < 1e-9);
    QVERIFY(std::abs(measureForWalls(soup).areaWith(0.0) / test::area(soup) - 1.0) < 1e-9);
    QVERIFY(std::abs(test::volume(walls) - 0.25 * test::area(soup)) < 1e-9 * test::area(soup));
  }

  // A bent strip is as thick everywhere as asked for, but at its rims: 99 % of the wall's surface within a tenth of a
  // voxel of what the chords of the strip and of the arcs around its edges allow, all of it within 0.6 voxels.
  void aBentSheet() {
    constexpr int kSteps = 24;
    constexpr double kRadius = 20.0, kWall = 1.2, kVoxel = 0.2;
    TriangleSoup strip;
    for (int j = 0; j <= kSteps; ++j)
      for (int i = 0; i <= kSteps; ++i) {
        const double angle = 0.35 + 1.75 * i / kSteps;
        strip.points.emplace_back(kRadius * std::cos(angle), kRadius * std::sin(angle), 30.0 * j / kSteps);
      }
    for (std::uint32_t j = 0; j < kSteps; ++j)
      for (std::uint32_t i = 0; i < kSteps; ++i) {
        const std::uint32_t first = j * (kSteps + 1) + i;
        strip.triangles.push_back({first, first + 1, first + kSteps + 2});
        strip.triangles.push_back({first + kSteps + 2, first, first + kSteps + 1});
      }
    std::swap(strip.triangles[100][0], strip.triangles[100][1]);  // the orientation of a triangle does not matter
    const auto made = volumeOfSurface(wallsOf(strip, kWall), kVoxel);
    QVERIFY(made.hasValue());
    QVERIFY2(made->nearShare > 1.0 - kThinShare, qPrintable(QString::number(made->nearShare)));
    std::vector<double> all;
    for (const Vec3& p : surfaceOf(made->volume).points) {
      const double angle = std::atan2(p.y(), p.x());
      if (angle < 0.45 || angle > 2.0 || p.z() < 2.0 || p.z() > 28.0) continue;
      all.push_back(std::abs(std::hypot(p.x(), p.y()) - kRadius));
    }
    QVERIFY(all.size() > 5000);
    std::sort(all.begin(), all.end());
    const double sag = kRadius * (1.0 - std::cos(0.5 * 1.75 / kSteps)), least = 0.5 * kWall - sag;
    QVERIFY2(all[all.size() / 100] > least - 0.1 * kVoxel, qPrintable(QString::number(all[all.size() / 100])));
    QVERIFY2(all.front() > least - 0.6 * kVoxel, qPrintable(QString::number(all.front())));
    QVERIFY2(all.back() < 0.5 * kWall + sag + 0.1 * kVoxel, qPrintable(QString::number(all.back())));
  }

  // At the tip of a cone of triangles, and at its foot, nothing is missing: what is within half of the thickness of the
  // surface is in the wall, and nothing else.
  void corners() {
    const TriangleSoup ball = test::icosphere(1);
    constexpr double kWall = 0.3, kVoxel = 0.05;
    const auto made = volumeOfSurface(wallsOf(ball, kWall), kVoxel);
    QVERIFY(made.hasValue());
    double least = kWall, most = 0.0;
    const HalfEdgeMesh mesh = buildMesh(ball).mesh;
    const FaceHierarchy faces(mesh);
    for (const Vec3& p : surfaceOf(made->volume).points) {
      const double away = (*faces.nearest(p) - p).norm();
      if (away < least) qInfo("%g at %g %g %g", away, p.x(), p.y(), p.z());
      least = std::min(least, away);
      most = std::max(most, away);
    }
    // A chord of 0.35 rad lies 1.5 % of the radius below its arc; a flat corner of a cone somewhat more.
    QVERIFY2(least > 0.95 * 0.5 * kWall - 0.5 * kVoxel, qPrintable(QString::number(least)));
    QVERIFY2(most < 0.5 * kWall + 0.1 * kVoxel, qPrintable(QString::number(most)));
  }

  // A disc encloses nothing; its wall is a plate.
  void aVolumeOfASheet() {
    const TriangleSoup disc = test::disc(64, 8, 10.0);
    const auto none = volumeOfSurface(disc, 0.25);
    QVERIFY(!none.hasValue() && none.error().code == VolumeErrors::NothingInside);
    const auto plate = volumeOfSurface(wallsOf(disc, 2.0), 0.25);
    QVERIFY(plate.hasValue());
    QVERIFY(std::abs(plate->volume.material() - 2.0 * test::area(disc)) < 0.02 * 2.0 * test::area(disc));
  }
};

HANDWHEEL_TEST(TriangleWallsTest)
#include "TriangleWallsTest.moc"
