// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/refit/Refit.h"

#include "TestClass.h"
#include "nurbs/StepWriter.h"
#include "nurbs/Tessellation.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

// A bar of 40 × 60 mm with a bore of radius 8 below `low` and above `high`.
TurnedProfile boredFromBothEnds(double low, double high) {
  TurnedProfile part({40.0, 60.0, 0.0}, 0.5);
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part.z(i) <= low || part.z(i) >= high) part.limitInner(i, 8.0);
  }
  return part;
}

TurnedCurves onlyPiece(const TurnedProfile& part) {
  const auto outlines = outlinesOf(part);
  if (outlines.size() != 1) qFatal("%zu pieces", outlines.size());
  const Result<TurnedCurves> curves = curvesOf(outlines[0], 1e-6, part.spacing(), 5.0);
  if (!curves) qFatal("no curves");
  return *curves;
}

double volumeOfTriangles(const ProfileCurve& curve) {
  TessellationOptions options;
  options.chord = 0.01;
  const Result<TriangleSoup> soup = tessellate(curve, options);
  if (!soup) qFatal("no triangles");
  double sum = 0.0;
  for (const Triangle& t : soup->triangles)
    sum += soup->points[t[0]].dot(soup->points[t[1]].cross(soup->points[t[2]])) / 6.0;
  return sum;
}

}  // namespace

class TurnedOutlineTest : public QObject {
  Q_OBJECT

 private slots:
  void aBar() {
    const TurnedCurves curves = onlyPiece(TurnedProfile({40.0, 60.0, 0.0}, 0.5));
    QCOMPARE(curves.outside.nurbs().poles.size(), std::size_t{3});
    QVERIFY(curves.outside.nurbs().poles[0] == ProfilePoint(20.0, 5.0));
    QVERIFY(curves.outside.nurbs().poles[2] == ProfilePoint(20.0, 65.0));
  }

  // Each as a solid of Open CASCADE and as triangles: valid, and of the volume of the profile.
  void boredSolids_data() {
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<bool>("isClosed");
    QTest::newRow("blind, upper end") << -1.0 << 30.0 << false;
    QTest::newRow("blind, lower end") << 30.0 << 70.0 << false;
    QTest::newRow("both ends") << 20.0 << 40.0 << false;
    QTest::newRow("through") << 30.0 << 30.0 << true;
  }
  void boredSolids() {
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(bool, isClosed);
    const TurnedProfile part = boredFromBothEnds(low, high);
    const TurnedCurves curves = onlyPiece(part);
    QCOMPARE(curves.outside.isClosed(), isClosed);
    QVERIFY(curves.cavities.empty());
    QVERIFY(std::abs(volumeOfTriangles(curves.outside) / part.volume() - 1.0) < 2e-3);
    const auto bytes = writeStep(curves.outside);
    QVERIFY(bytes);
    const auto report = inspectStep(*bytes);
    QVERIFY(report && report->isValid);
    QCOMPARE(report->solids, std::size_t{1});
    QVERIFY2(std::abs(report->volume / part.volume() - 1.0) < 1e-6, qPrintable(QString::number(report->volume)));
    QVERIFY(std::abs(report->area / part.area() - 1.0) < 1e-6);
    QVERIFY(std::abs(report->bounds.min().z() - 5.0) < 1e-5 && std::abs(report->bounds.max().z() - 65.0) < 1e-5);
  }

  // Bored through and parted in two: both are closed, and taper to where nothing is left.
  void twoPieces() {
    TurnedProfile part = boredFromBothEnds(30.0, 30.0);
    part.limitOuter(40, 3.0);
    const auto outlines = outlinesOf(part);
    QCOMPARE(outlines.size(), std::size_t{2});
    double volume = 0.0;
    for (const TurnedOutline& outline : outlines) {
      QVERIFY(outline.isClosed);
      volume += volumeOfTriangles(curvesOf(outline, 1e-6, part.spacing(), 0.0)->outside);
    }
    QVERIFY(std::abs(volume / part.volume() - 1.0) < 2e-3);
  }

  void aHollowInside() {
    TurnedProfile part({40.0, 60.0, 0.0}, 0.5);
    for (std::size_t i = 40; i < 80; ++i) part.limitInner(i, 8.0);
    const TurnedCurves curves = onlyPiece(part);
    QCOMPARE(curves.cavities.size(), std::size_t{1});
    QVERIFY(!curves.outside.isClosed());
    const double volume = volumeOfTriangles(curves.outside) - volumeOfTriangles(curves.cavities[0]);
    QVERIFY(std::abs(volume / part.volume() - 1.0) < 2e-3);
  }

  void nothingLeft() {
    TurnedProfile part({40.0, 60.0, 0.0}, 0.5);
    for (std::size_t i = 0; i < part.size(); ++i) part.limitOuter(i, 0.0);
    QVERIFY(outlinesOf(part).empty());
  }
};

HANDWHEEL_TEST(TurnedOutlineTest)
#include "TurnedOutlineTest.moc"
