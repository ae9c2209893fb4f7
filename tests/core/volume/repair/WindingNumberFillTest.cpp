// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/WindingNumberFill.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"
#include "volume/repair/BoundaryCaps.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A ball without what is above a saddle, of a radius in voxels: one wide bent hole. height: of the saddle's middle, in
// radii.
TriangleSoup bowl(double radius, double height) {
  TriangleSoup ball = icosphere(5);
  std::erase_if(ball.triangles, [&](const Triangle& t) {
    const Vec3 p = (ball.points[t[0]] + ball.points[t[1]] + ball.points[t[2]]) / 3.0;
    return p.z() > height + 0.3 * (p.x() * p.x() - p.y() * p.y());
  });
  for (Vec3& p : ball.points) p *= radius;
  return ball;
}

}  // namespace

class WindingNumberFillTest : public QObject {
  Q_OBJECT

 private slots:
  // The blocks that are looked at are as many as predicted, within a factor of two, whatever the size is.
  void predicted_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("height");
    for (const double radius : {40.0, 120.0, 250.0})
      for (const double height : {-0.3, 0.0, 0.5}) QTest::addRow("%g, %g", radius, height) << radius << height;
  }
  void predicted() {
    QFETCH(double, radius);
    QFETCH(double, height);
    TriangleSoup closed = bowl(radius, height);
    const BoundaryCaps caps = closeBoundaries(closed, 4.0);
    QVERIFY(!caps.wide.empty());
    const double predicted = WindingNumberFill::predictedBlocks(closed, caps.wide);
    const auto found = static_cast<double>(WindingNumberFill(closed, caps.wide, {}).blocks().size());
    QVERIFY2(found < 2.0 * predicted && predicted < 2.0 * found,
             qPrintable(QString("%1 for %2").arg(predicted).arg(found)));
  }

  // Membranes over a hole of a hundred metres, in voxels of a millimetre, would need too much memory; this is detected
  // before they are begun.
  void refused() {
    const Result<SurfaceVolume> made = volumeOfSurface(bowl(50'000.0, 0.0), 1.0);
    QCOMPARE(made.error().code, VolumeErrors::TooLarge);
    QCOMPARE(made.error().arguments.size(), std::size_t{3});
    TriangleSoup closed = bowl(50'000.0, 0.0);
    const BoundaryCaps caps = closeBoundaries(closed, 4.0);
    const double bytes = WindingNumberFill::predictedBlocks(closed, caps.wide) * WindingNumberFill::kBytes;
    QVERIFY(bytes > 1e12);
    QVERIFY(std::stod(made.error().arguments[1]) > 1e-6 * bytes);
  }
};

HANDWHEEL_TEST(WindingNumberFillTest)
#include "WindingNumberFillTest.moc"
