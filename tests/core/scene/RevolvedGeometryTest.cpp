// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/RevolvedGeometry.h"

#include "MeshChecks.h"
#include "Surfaces.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

class RevolvedGeometryTest : public QObject {
  Q_OBJECT

 private slots:
  void theSurfaceIsWithinTheChord() {
    const auto profile = ProfileCurve::polyline({{20, 0}, {20, 10}, {8, 30}});
    const auto geometry = RevolvedGeometry::make(*profile, 0.01);
    QVERIFY(geometry);
    const TriangleSoup& soup = *geometry.value()->surface();
    QVERIFY(countEdges(soup).sound());
    // A cylinder and a frustum; inscribed within 0.01 mm of the surface.
    const double pi = std::numbers::pi, area = 2 * pi * 20 * 10 + pi * 28 * std::hypot(12, 20);
    const double exact = pi * 400 * 10 + pi / 3 * 20 * (400 + 20 * 8 + 64);
    QVERIFY(volumeOf(soup) < exact && volumeOf(soup) > exact - 0.01 * area);
    QVERIFY(std::abs(geometry.value()->bounds().max().z() - 30) < 1e-12);
  }

  void aChordThatIsTooFineIsMadeCoarser() {
    const auto profile = ProfileCurve::polyline({{1e5, 0}, {1e5, 10}, {2e5, 20}});
    const auto geometry = RevolvedGeometry::make(*profile, RevolvedGeometry::kLeastChord);
    const std::size_t triangles = geometry.value()->surface()->triangles.size();
    QVERIFY(triangles > 0 && triangles <= RevolvedGeometry::kMostTriangles);
  }

  void manyPolesStillHaveASurface() {
    std::vector<ProfilePoint> points;
    for (std::size_t i = 0; i < ProfileCurve::kMostPoles; ++i) points.emplace_back(1e6 + 1e5 * (i % 2), double(i));
    const auto geometry = RevolvedGeometry::make(*ProfileCurve::polyline(points), 1e-4);
    QVERIFY(geometry.value()->surface()->triangles.size() <= RevolvedGeometry::kMostTriangles);
  }

  void chordsAreChecked() {
    const auto profile = ProfileCurve::polyline({{20, 0}, {20, 10}});
    for (double wrong : {0.0, -1.0, 1e-5, 2e3, std::nan("")}) {
      const auto refused = RevolvedGeometry::make(*profile, wrong);
      QVERIFY(!refused);
      QCOMPARE(refused.error().code, ErrorCode::ValueOutOfRange);
    }
  }
};

HANDWHEEL_TEST(RevolvedGeometryTest)
#include "RevolvedGeometryTest.moc"
