// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/TriangleWalls.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"

#include <QTest>
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
