// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/CutSurface.h"
#include "fidelity/MeasuredSettings.h"
#include "fidelity/VirtualScanner.h"
#include "mesh/structure/MeshBuilder.h"
#include "viewport/surface/SurfaceGeometry.h"

#include <QTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

const FidelityRegistry& registry() {
  static const FidelityRegistry all = measuredSettings();
  return all;
}

double errorAt(const FidelityCase& c, double value, std::uint64_t seed = 1) {
  return c.run(value, seed, {}).error;
}

FidelityCase onMesh(const char* id, const TriangleSoup& soup) {
  const auto shared = std::make_shared<const TriangleSoup>(soup);
  return casesOnMesh(id, "mesh", [shared] { return shared; }).at(0);
}

}  // namespace

class CasesTest : public QObject {
  Q_OBJECT

 private slots:
  void shapes();
  void everyCaseRuns_data();
  void everyCaseRuns();
  void exactParts_data();
  void exactParts();
  void scansAreOfTheirPart_data() { exactParts_data(); }
  void scansAreOfTheirPart();
  void holesAreCutAndKnown();
  void holesAcrossSharpEdges();
  void creasesCarryEdgesThroughHoles();
  void tornVerticesOfAMesh();
  void patchesOfAMesh();
  void blocksOfAnySize();
  void piecesOfAVolume();
  void standInsOfAMesh();
  void fewerTrianglesOfAMesh();
  void sidesOfRoundShapes();
  void smallAndDegenerateMeshes_data();
  void smallAndDegenerateMeshes();
};

void CasesTest::shapes() {
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

void CasesTest::everyCaseRuns_data() {
  QTest::addColumn<QString>("id");
  QTest::addColumn<int>("index");
  for (const auto& entry : registry().entries()) {
    for (int i = 0; i < int(entry.cases.size()); ++i) {
      QTest::addRow("%s, %s", entry.setting.id.c_str(), entry.cases[i].name.c_str())
          << QString::fromStdString(entry.setting.id) << i;
    }
  }
}

// At the default there is a result with an error and a cost, and the seed alone decides on the error.
void CasesTest::everyCaseRuns() {
  QFETCH(QString, id);
  QFETCH(int, index);
  const FidelityRegistry::Entry& entry = *registry().find(id.toStdString());
  const FidelityCase& c = entry.cases[index];
  QVERIFY(!c.truth.empty());
  const FidelitySample first = c.run(entry.setting.standard, 1, {});
  QVERIFY(std::isfinite(first.error) && first.error >= 0.0);
  QVERIFY(first.cost > 0.0);
  QCOMPARE(errorAt(c, entry.setting.standard), first.error);
}

void CasesTest::exactParts_data() {
  QTest::addColumn<ExactPart>("part");
  QTest::addColumn<Vec3>("onFace");  // a place in the middle of a flat face, or of the shaft's side
  QTest::addColumn<Vec3>("normal");  // there
  QTest::addColumn<Vec3>("onCrease");
  QTest::newRow("milled") << milledPart() << Vec3(40, 20, 25) << Vec3(0, 0, 1) << Vec3(45, 70, 3);
  QTest::newRow("milled, chamfer") << milledPart() << Vec3(85, 35, 2) << Vec3(1, 1, 0) << Vec3(85, 35, -25);
  QTest::newRow("turned") << turnedPart() << Vec3(0, 22, 40) << Vec3(0, 1, 0) << Vec3(-22, 0, 20);
  QTest::newRow("turned, below") << turnedPart() << Vec3(7, 5, 0) << Vec3(0, 0, -1) << Vec3(0, -36, 0);
}

// Along the normal of a face the distance is that which one goes, on both sides, and at an edge it is none.
void CasesTest::exactParts() {
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
void CasesTest::scansAreOfTheirPart() {
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

void CasesTest::holesAcrossSharpEdges() {
  const ExactPart part = milledPart();
  const TriangleSoup scan = scanOf(part, {.pitch = 2.0});
  const CutOptions options{.holes = 8, .radius = 0.05, .distanceToCrease = part.distanceToCrease};
  const CutSurface cut = cutHoles(scan, 1, part.distance, options);
  QCOMPARE(cut.holes.size(), std::size_t{8});
  const double radius = 0.05 * part.box.diagonal().norm();
  for (std::size_t i = 0; i < cut.holes.size(); i += 2)
    QVERIFY(part.distanceToCrease(cut.holes[i].loop.centre) < radius);
}

// What the method is for: where a sharp edge goes through a hole, a patch that carries it on is nearer to the part.
void CasesTest::creasesCarryEdgesThroughHoles() {
  const FidelityRegistry::Entry& entry = *registry().find("mesh.fill_method");
  std::size_t scans = 0;
  for (const FidelityCase& c : entry.cases) {
    if (c.name.find("scanned") == std::string::npos) continue;
    ++scans;
    const double fair = errorAt(c, *valueOf(entry.setting, "fair")),
                 crease = errorAt(c, *valueOf(entry.setting, "ridge"));
    QVERIFY2(crease < fair, qPrintable(QString("%1: %2 and %3").arg(c.name.c_str()).arg(crease).arg(fair)));
  }
  QCOMPARE(scans, std::size_t{2});
}

void CasesTest::holesAreCutAndKnown() {
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

// About half of what is parted are tears, half gaps: no tolerance leaves the tears, a huge one eats the gaps.
void CasesTest::tornVerticesOfAMesh() {
  const FidelityCase c = onMesh("mesh.near_weld", torusSoup(60, 40, 20.0, 6.0));
  QCOMPARE(errorAt(c, 1e-5), 0.0);
  QVERIFY(errorAt(c, 1e-8) > 30.0 && errorAt(c, 1e-8) < 70.0);
  QVERIFY(errorAt(c, 1e-3) > 20.0 && errorAt(c, 1e-3) < 70.0);
}

void CasesTest::patchesOfAMesh() {
  const TriangleSoup soup = sphereSoup(4, 10.0);
  const FidelityCase method = onMesh("mesh.fill_method", soup), density = onMesh("mesh.patch_density", soup);
  const FidelityRegistry::Entry& entry = *registry().find("mesh.fill_method");
  const double fair = errorAt(method, *valueOf(entry.setting, "fair"));
  QVERIFY(fair < 0.5);                                             // % of the hole: it continues the curvature,
  QVERIFY(errorAt(method, *valueOf(entry.setting, "ear")) > 2.0);  // which a flat lid cannot
  QCOMPARE(errorAt(density, registry().find("mesh.patch_density")->setting.standard), fair);
  QVERIFY(casesOnMesh("nurbs.chord_mm", "mesh", nullptr).empty());
}

// However the faces are parted into blocks: each is drawn once.
void CasesTest::blocksOfAnySize() {
  const HalfEdgeMesh mesh = buildMesh(torusSoup(60, 40, 20.0, 6.0)).mesh;
  for (Face faces : {Face{1}, Face{7}, Face{1000}, kBlockFaces}) {
    QCOMPARE(blockCount(mesh, faces), (4800 + std::size_t{faces} - 1) / faces);
    std::size_t drawn = 0;
    for (std::size_t b = 0; b < blockCount(mesh, faces); ++b) {
      const SurfaceGeometry g = blockGeometry(mesh, b, Vec3::Zero(), faces);
      QVERIFY(g.indices.size() <= 3 * std::size_t{faces});
      drawn += g.indices.size() / 3;
    }
    QCOMPARE(drawn, std::size_t{4800});
  }
}

// The larger the pieces, the fewer there are; the eight octants around the middle of a ball are parted at any size. By
// which tool they are renewed does not matter.
void CasesTest::piecesOfAVolume() {
  const FidelityRegistry::Entry& entry = *registry().find("volume.pieces");
  double before = std::numeric_limits<double>::infinity();
  for (double value = entry.setting.least; value <= entry.setting.largest; ++value) {
    const double count = errorAt(entry.cases.front(), value);
    QVERIFY(count >= 8.0 && count < before);
    QCOMPARE(errorAt(entry.cases.back(), value), count);
    before = count;
  }
}

// A small mesh is drawn as it is; what stands in for a large one lies closer the more triangles it has.
void CasesTest::standInsOfAMesh() {
  const FidelityCase small = onMesh("view.coarse_triangles", sphereSoup(4, 10.0));
  QCOMPARE(small.run(2000.0, 1, {}).error, 0.0);
  QCOMPARE(small.run(2000.0, 1, {}).cost, 5120.0);
  const FidelityCase large = onMesh("view.coarse_triangles", sphereSoup(6, 10.0));  // 81,920 faces
  const FidelitySample few = large.run(2000.0, 1, {}), more = large.run(10000.0, 1, {});
  QVERIFY(few.cost < more.cost && few.cost > 1000.0 && more.cost < 20000.0);
  QVERIFY(few.error > more.error && more.error > 0.0);
  QVERIFY(few.error < 1.0);  // % of the diagonal: half a cell
}

// The distance is kept and made use of: at a hundred times of it there are far fewer triangles.
void CasesTest::fewerTrianglesOfAMesh() {
  const FidelityCase ball = onMesh("mesh.decimation_error", sphereSoup(4, 10.0));
  const FidelitySample fine = ball.run(1e-4, 1, {}), coarse = ball.run(1e-2, 1, {});
  QVERIFY(fine.error <= 0.01);  // %
  QVERIFY(coarse.error > 0.5 && coarse.error <= 1.0);
  QVERIFY(coarse.cost > 0.0 && coarse.cost < 0.1 * fine.cost && fine.cost <= 100.0);
  const FidelitySample cube = onMesh("mesh.decimation_error", test::cube()).run(1e-2, 1, {});
  QCOMPARE(cube.error, 0.0);
  QCOMPARE(cube.cost, 100.0);  // every corner counts
}

// A chord of a circle is furthest from it in its middle: by 1 - cos(pi / n) of the radius.
void CasesTest::sidesOfRoundShapes() {
  const FidelityRegistry::Entry& entry = *registry().find("cell.shape_sides");
  for (double n : {8.0, 13.0, 48.0, 128.0}) {
    const double chord = 100.0 * (1.0 - std::cos(M_PI / n));
    const FidelitySample ball = entry.cases.at(0).run(n, 1, {}), cylinder = entry.cases.at(1).run(n, 1, {});
    QVERIFY(std::abs(cylinder.error - chord) < 1e-9);
    QCOMPARE(cylinder.cost, 4.0 * n);
    QVERIFY(ball.error > chord && ball.error < 3.0 * chord);  // bent both ways
    QCOMPARE(ball.cost, 2.0 * n * (std::floor(n / 2.0) - 1.0));
  }
}

void CasesTest::smallAndDegenerateMeshes_data() {
  QTest::addColumn<int>("shape");
  QTest::newRow("one triangle") << 0;
  QTest::newRow("tetrahedron") << 1;
  QTest::newRow("Klein bottle") << 2;
  QTest::newRow("no area") << 3;
  QTest::newRow("far away") << 4;
}

// Whatever the user brings: no crash, and no error that is not a number.
void CasesTest::smallAndDegenerateMeshes() {
  QFETCH(int, shape);
  const TriangleSoup soups[] = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
                                test::tetrahedron(),
                                test::kleinBottle(20, 10),
                                {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 0, 1}}},
                                test::moved(test::icosphere(3), Vec3(1e7, 1e7, 1e7))};
  for (const auto& entry : registry().entries()) {
    for (const FidelityCase& c :
         casesOnMesh(entry.setting.id, "mesh", [&] { return std::make_shared<const TriangleSoup>(soups[shape]); })) {
      for (double value : {entry.setting.least, entry.setting.standard, entry.setting.largest}) {
        const FidelitySample sample = c.run(value, 1, {});
        QVERIFY(!std::isnan(sample.error) && sample.error >= 0.0);
        QVERIFY(std::isfinite(sample.cost) && sample.cost >= 0.0);
      }
    }
  }
}

HANDWHEEL_TEST(CasesTest)
#include "CasesTest.moc"
