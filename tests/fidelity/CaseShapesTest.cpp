// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChecks.h"
#include "TestClass.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/CutSurface.h"
#include "fidelity/VirtualScanner.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

// The shapes that settings are measured on are known exactly, and the holes in them.
class CaseShapesTest : public QObject {
  Q_OBJECT

 private slots:
  void shapes();
  void exactParts_data();
  void exactParts();
  void scansAreOfTheirPart_data() { exactParts_data(); }
  void scansAreOfTheirPart();
  void holesAreCutAndKnown();
  void holesAcrossSharpEdges();
};

void CaseShapesTest::shapes() {
  const TriangleSoup sphere = sphereSoup(3, 50.0), torus = torusSoup(30, 20, 60.0, 30.0);
  QCOMPARE(sphere.triangles.size(), std::size_t{20 * 64});
  QCOMPARE(torus.triangles.size(), std::size_t{1200});
  for (const Vec3& p : sphere.points) QVERIFY(std::abs(p.norm() - 50.0) < 1e-12);
  for (const Vec3& p : torus.points) QVERIFY(distanceToTorus(p, 60.0, 30.0) < 1e-12);
  QVERIFY(std::abs(distanceToTorus(Vec3::Zero(), 60.0, 30.0) - 30.0) < 1e-12);
  for (const TriangleSoup& s : {sphere, torus}) {
    QVERIFY(test::countEdges(s).sound());
    QVERIFY(test::volume(s) > 0.0);  // facing outwards
  }
  QCOMPARE(test::eulerCharacteristic(sphere), 2L);
  QCOMPARE(test::eulerCharacteristic(torus), 0L);
}

void CaseShapesTest::exactParts_data() {
  QTest::addColumn<ExactPart>("part");
  QTest::addColumn<Vec3>("onFace");  // a position in the middle of a flat face, or of the shaft's side
  QTest::addColumn<Vec3>("normal");  // there
  QTest::addColumn<Vec3>("onCrease");
  QTest::newRow("milled") << milledPart() << Vec3(40, 20, 25) << Vec3(0, 0, 1) << Vec3(45, 70, 3);
  QTest::newRow("milled, chamfer") << milledPart() << Vec3(85, 35, 2) << Vec3(1, 1, 0) << Vec3(85, 35, -25);
  QTest::newRow("turned") << turnedPart() << Vec3(0, 22, 40) << Vec3(0, 1, 0) << Vec3(-22, 0, 20);
  QTest::newRow("turned, below") << turnedPart() << Vec3(7, 5, 0) << Vec3(0, 0, -1) << Vec3(0, -36, 0);
}

// Along the normal of a face the distance is that which one goes, on both sides, and at an edge it is none.
void CaseShapesTest::exactParts() {
  QFETCH(ExactPart, part);
  QFETCH(Vec3, onFace);
  QFETCH(Vec3, normal);
  QFETCH(Vec3, onCrease);
  for (const double step : {-5.0, -0.25, 0.0, 1e-6, 4.0, 15.0}) {
    const double distance = part.distance(onFace + step * normal.normalized());
    QVERIFY2(std::abs(distance - step) < 1e-9, qPrintable(QString::number(distance)));
  }
  QVERIFY(std::abs(part.distance(onCrease)) < 1e-9);
  QVERIFY(part.distanceToCrease(onCrease) < 1e-9);
  QVERIFY(part.distanceToCrease(onFace) > 3.0);
}

// Closed, facing outwards, its samples off the part by the noise, and its volume that of the part.
void CaseShapesTest::scansAreOfTheirPart() {
  QFETCH(ExactPart, part);
  constexpr double kNoise = 0.02;
  const TriangleSoup scan = scanOf(part, {.pitch = 2.0, .noise = kNoise});
  QVERIFY(test::countEdges(scan).sound());
  QVERIFY(std::abs(test::volume(scan) / part.volume - 1.0) < 0.01);  // the edges are cut off
  double squares = 0.0;
  for (const Vec3& p : scan.points) {
    const double distance = part.distance(p);
    QVERIFY(std::abs(distance) < 6.0 * kNoise);
    squares += distance * distance;
  }
  const double rms = std::sqrt(squares / static_cast<double>(scan.points.size()));
  QVERIFY(std::abs(rms / kNoise - 1.0) < 0.05);
  QVERIFY(scanOf(part, {.pitch = 2.0, .noise = kNoise}).points == scan.points);
  QVERIFY(scanOf(part, {.pitch = 2.0, .noise = kNoise, .seed = 2}).points != scan.points);
}

void CaseShapesTest::holesAcrossSharpEdges() {
  const ExactPart part = milledPart();
  const TriangleSoup scan = scanOf(part, {.pitch = 2.0});
  const CutOptions options{.holes = 8, .radius = 0.05, .distanceToCrease = part.distanceToCrease};
  const CutSurface cut = cutHoles(scan, 1, part.distance, options);
  QCOMPARE(cut.holes.size(), std::size_t{8});
  const double radius = 0.05 * part.box.diagonal().norm();
  for (std::size_t i = 0; i < cut.holes.size(); i += 2)
    QVERIFY(part.distanceToCrease(cut.holes[i].loop.centre) < radius);
}

void CaseShapesTest::holesAreCutAndKnown() {
  const TriangleSoup soup = sphereSoup(4, 10.0);
  for (std::uint64_t seed : {1, 2, 3}) {
    const CutSurface cut = cutHoles(soup, seed, nullptr);
    QCOMPARE(cut.holes.size(), std::size_t{4});
    QCOMPARE(findBoundaryLoops(cut.filler->mesh()).size(), std::size_t{4});
    for (const CutSurface::Hole& hole : cut.holes) {
      // The rim lies on what was cut out, and the sphere bulges out of it by what is known of a cap.
      for (const Vec3& p : loopPoints(cut.filler->mesh(), hole.loop)) QVERIFY(hole.distance(p) < 1e-9);
      QVERIFY(hole.distance(10.0 * hole.loop.centre.normalized()) < 0.05);
      QVERIFY(hole.distance(hole.loop.centre) > 0.1);
    }
  }
}

HANDWHEEL_TEST(CaseShapesTest)
#include "CaseShapesTest.moc"
