// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/Decimation.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/measure/Deviation.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>
#include <numbers>

using namespace handwheel;

class DecimationTest : public QObject {
  Q_OBJECT

 private slots:
  void toACount();
  void toTheLast();
  void flatFacesGoWithoutError();
  void withinAnError();
  void sameAtEverySize();
  void errorNearNothing();
  void bordersStay();
  void bordersMayShrink();
  void creasesStay();
  void nothingNewMeets();
  void sharedPositionsAndSeamsStay();
  void degenerateFaces();
  void extremes();
  void cancelled();
  void anyShape();
};

namespace {

HalfEdgeMesh meshOf(const TriangleSoup& soup) {
  return buildMesh(soup).mesh;
}

// A cube whose sides are n × n cells.
TriangleSoup fineCube(std::uint32_t n) {
  TriangleSoup s;
  for (int k = 0; k < 3; ++k) {
    for (double side : {0.0, 1.0}) {
      const TriangleSoup sheet = test::grid(n + 1, n + 1, false, false, [&](std::uint32_t i, std::uint32_t j) {
        Vec3 p = Vec3::Constant(side);
        p[(k + 1) % 3] = double(i) / n;
        p[(k + 2) % 3] = double(j) / n;
        return p;
      });
      test::append(s, side > 0.0 ? sheet : test::turnedOver(sheet));
    }
  }
  return s;
}

double hausdorff(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  const auto d = deviation(a, b, {.samples = 50'000});
  if (!d) qFatal("no deviation");
  return d->hausdorff();
}

std::set<test::Coordinates> borderPositions(const HalfEdgeMesh& mesh) {
  std::set<test::Coordinates> positions;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (mesh.isBorder(h)) positions.insert(test::coordinates(mesh.position(mesh.from(h))));
  return positions;
}

}  // namespace

void DecimationTest::toACount() {
  for (std::size_t faces : {1000u, 321u, 20u}) {
    HalfEdgeMesh mesh = meshOf(test::icosphere(4));
    const DecimationReport report = decimate(mesh, {.faces = faces});
    QCOMPARE(report.facesBefore, std::size_t{5120});
    QCOMPARE(report.facesAfter, faces - faces % 2);  // a closed surface loses two at a time
    QCOMPARE(mesh.liveFaceCount(), report.facesAfter);
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(test::countEdges(mesh).sound());
    QCOMPARE(test::eulerCharacteristic(mesh), 2l);
    // Half an edge of an even tessellation, squared, over the radius.
    const double edge = std::sqrt(16.0 * std::numbers::pi / (std::sqrt(3.0) * double(faces)));
    QVERIFY(hausdorff(mesh, meshOf(test::icosphere(4))) < 0.5 * edge * edge);
  }
}

void DecimationTest::toTheLast() {
  HalfEdgeMesh sphere = meshOf(test::icosphere(3)), torus = meshOf(test::torus(24, 16));
  decimate(sphere, {});
  QCOMPARE(validate(sphere), std::string());
  QVERIFY(sphere.liveFaceCount() >= 4 && sphere.liveFaceCount() <= 12);
  decimate(torus, {});
  QCOMPARE(validate(torus), std::string());
  QCOMPARE(test::eulerCharacteristic(torus), 0l);
  QVERIFY(torus.liveFaceCount() >= 14);  // no torus has fewer (Möbius)
}

void DecimationTest::flatFacesGoWithoutError() {
  HalfEdgeMesh mesh = meshOf(fineCube(12));
  decimate(mesh, {.faces = 60});
  QCOMPARE(mesh.liveFaceCount(), std::size_t{60});
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1.0) < 1e-9);
  QVERIFY(std::abs(test::area(mesh.compact().soup) - 6.0) < 1e-9);
}

void DecimationTest::withinAnError() {
  std::size_t last = 100'000;
  for (double error : {0.001, 0.01, 0.05}) {
    const HalfEdgeMesh original = meshOf(test::bumpySphere(4));
    HalfEdgeMesh mesh = original;
    const DecimationReport report = decimate(mesh, {.error = error});
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(report.largestDistance && *report.largestDistance <= error);
    QVERIFY(hausdorff(mesh, original) <= error);  // at other samples
    QVERIFY(report.facesAfter < last);
    last = report.facesAfter;
  }
  QVERIFY(last < 300);
}

// Powers of two change no digit. At 2^±332, 1e±100, squares of areas vanish or overflow.
void DecimationTest::sameAtEverySize() {
  for (const DecimationMethod method : {DecimationMethod::Bounded, DecimationMethod::Quadric}) {
    std::vector<TriangleSoup> made;
    std::vector<double> distances;
    for (const int exponent : {0, -332, -140, 140, 332}) {
      HalfEdgeMesh mesh = meshOf(test::moved(test::bumpySphere(3), Vec3::Zero(), std::ldexp(1.0, exponent)));
      const DecimationReport report = decimate(mesh, {.faces = 200, .method = method, .measureDistance = true});
      made.push_back(test::moved(mesh.compact().soup, Vec3::Zero(), std::ldexp(1.0, -exponent)));
      distances.push_back(std::ldexp(report.largestDistance.value_or(-1.0), -exponent));
      QCOMPARE(made.back().triangles.size(), made.front().triangles.size());
      if (method == DecimationMethod::Bounded) {
        QVERIFY(made.back().triangles == made.front().triangles);
        QVERIFY(made.back().points == made.front().points);
      }
      QVERIFY(std::abs(distances.back() - distances.front()) < 1e-12);
    }
  }
}

void DecimationTest::errorNearNothing() {
  HalfEdgeMesh cube = meshOf(fineCube(8));
  const DecimationReport report = decimate(cube, {.error = 1e-9});
  QVERIFY(report.facesAfter < 100);
  QVERIFY(*report.largestDistance <= 1e-9);
  HalfEdgeMesh sphere = meshOf(test::icosphere(3));
  decimate(sphere, {.error = 1e-9});
  QCOMPARE(sphere.liveFaceCount(), std::size_t{1280});
}

void DecimationTest::bordersStay() {
  const HalfEdgeMesh original = meshOf(test::sphereWithHoles(4, 3, 0.3));
  HalfEdgeMesh mesh = original;
  decimate(mesh, {.faces = 800, .keepBorders = true});
  QVERIFY(mesh.liveFaceCount() <= 800);
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(borderPositions(mesh), borderPositions(original));
  QCOMPARE(test::countBorder(mesh), test::countBorder(original));
}

void DecimationTest::bordersMayShrink() {
  HalfEdgeMesh mesh =
      meshOf(test::grid(21, 21, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.0); }));
  decimate(mesh, {.faces = 20});
  QVERIFY(mesh.liveFaceCount() <= 20);
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(std::abs(test::area(mesh.compact().soup) - 400.0) < 1e-6);  // the straight border keeps its line
}

// A cylinder's rims: all vertices there stay on them, and they stay closed.
void DecimationTest::creasesStay() {
  const TriangleSoup soup = test::cylinder(48, 24, 1.0, 2.0, true);
  const std::set<test::Coordinates> before = test::allCoordinates(soup);
  HalfEdgeMesh mesh = meshOf(soup);
  decimate(mesh, {.faces = 100, .creaseAngle = std::numbers::pi / 4.0});
  QCOMPARE(validate(mesh), std::string());
  double low = 0.0, high = 0.0;  // lengths of the rims
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!mesh.isProper(HalfEdgeMesh::face(h)) || h > mesh.opposite(h)) continue;
    const TrianglePoints a = mesh.points(HalfEdgeMesh::face(h)), b = mesh.points(HalfEdgeMesh::face(mesh.opposite(h)));
    const auto normal = [](const TrianglePoints& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); };
    if (normal(a).dot(normal(b)) > 0.5) continue;
    const Vec3 &p = mesh.position(mesh.from(h)), &q = mesh.position(mesh.to(h));
    QVERIFY(before.contains(test::coordinates(p)) && before.contains(test::coordinates(q)));
    QVERIFY(p.z() == q.z() && (p.z() == 0.0 || p.z() == 2.0));
    (p.z() == 0.0 ? low : high) += (p - q).norm();
  }
  for (double length : {low, high}) QVERIFY(length > 0.9 * 2.0 * std::numbers::pi && length < 2.0 * std::numbers::pi);
}

// Two sheets so near to each other that coarse ones would cross.
void DecimationTest::nothingNewMeets() {
  const auto shell = [](double radius) {
    TriangleSoup s = test::bumpySphere(3);
    for (Vec3& p : s.points) p *= radius;
    return s;
  };
  TriangleSoup soup = shell(1.0);
  test::append(soup, test::turnedOver(shell(0.99)));
  HalfEdgeMesh careless = meshOf(soup), careful = careless;
  decimate(careless, {.faces = 300});
  QVERIFY(test::meetingPairs(careless) > 0);
  const DecimationReport report = decimate(careful, {.faces = 300, .avoidIntersections = true});
  QCOMPARE(validate(careful), std::string());
  QCOMPARE(test::meetingPairs(careful), std::size_t{0});
  QVERIFY(report.facesAfter < 1500);
}

void DecimationTest::sharedPositionsAndSeamsStay() {
  for (const TriangleSoup& soup : {test::twoCubesSharingAnEdge(), test::twoCubesSharingAVertex(),
                                   test::boxWithInnerWall(), test::moebiusStrip(30, 6), test::kleinBottle(30, 20)}) {
    HalfEdgeMesh mesh = meshOf(soup);
    const auto seams = test::countSeams(mesh);
    std::map<test::Coordinates, int> before, after;
    const auto count = [](const HalfEdgeMesh& m, std::map<test::Coordinates, int>& positions) {
      std::set<Vertex> used;
      for (Face f = 0; f < m.faceSlots(); ++f)
        if (m.isProper(f)) used.insert(m.triangle(f).begin(), m.triangle(f).end());
      for (Vertex v : used) ++positions[test::coordinates(m.position(v))];
    };
    count(mesh, before);
    decimate(mesh, {});
    count(mesh, after);
    QCOMPARE(validate(mesh), std::string());
    QCOMPARE(test::countSeams(mesh), seams);
    for (const auto& [position, n] : before)
      if (n > 1) QCOMPARE(after[position], n);
  }
}

void DecimationTest::degenerateFaces() {
  TriangleSoup soup = test::icosphere(3);
  test::addNeedles(soup, 7, 0, {0.3, 0.6});
  soup.triangles.push_back({1, 1, 2});
  HalfEdgeMesh mesh = meshOf(soup);
  const DecimationReport report = decimate(mesh, {.faces = 200, .error = 0.2});
  QCOMPARE(report.removedDegenerate, std::size_t{1});
  QCOMPARE(report.facesAfter, std::size_t{200});
  QCOMPARE(validate(mesh), std::string());
}

void DecimationTest::extremes() {
  HalfEdgeMesh none;
  QCOMPARE(decimate(none, {.error = 1.0}).facesAfter, std::size_t{0});
  HalfEdgeMesh one = meshOf({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}});
  QCOMPARE(decimate(one, {}).facesAfter, std::size_t{1});
  HalfEdgeMesh flat = meshOf({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)}, {{0, 1, 2}, {0, 2, 3}}});
  decimate(flat, {.error = 1.0});
  QCOMPARE(validate(flat), std::string());
  // The result is equally good far from the origin, in any unit.
  const double plain = [] {
    HalfEdgeMesh mesh = meshOf(test::icosphere(4));
    decimate(mesh, {.faces = 500});
    return hausdorff(mesh, meshOf(test::icosphere(4)));
  }();
  for (const auto& [shift, scale] : {std::pair(1e6, 1.0), std::pair(0.0, 1e-9), std::pair(0.0, 1e12)}) {
    const HalfEdgeMesh original = meshOf(test::moved(test::icosphere(4), Vec3::Constant(shift), scale));
    HalfEdgeMesh mesh = original;
    decimate(mesh, {.faces = 500, .avoidIntersections = true});
    QCOMPARE(mesh.liveFaceCount(), std::size_t{500});
    QVERIFY(hausdorff(mesh, original) < 1.2 * scale * plain);
  }
  // A hub: collapses go round its rim.
  HalfEdgeMesh wheel = meshOf(test::cylinder(3000, 1, 1.0, 1.0, true));
  decimate(wheel, {.faces = 200});
  QVERIFY2(wheel.liveFaceCount() <= 200, qPrintable(QString::number(wheel.liveFaceCount())));
  QCOMPARE(validate(wheel), std::string());
}

void DecimationTest::cancelled() {
  const HalfEdgeMesh original = meshOf(test::bumpySphere(3));
  HalfEdgeMesh mesh = original;
  JobState job;
  job.cancelled = true;
  for (const DecimationOptions& options : {DecimationOptions{.faces = 10}, DecimationOptions{.error = 0.1}}) {
    QVERIFY(decimate(mesh, options, Progress(job)).cancelled);
    QVERIFY(test::sameMesh(mesh, original));
  }
  // It looks at the flag for each edge, as to check one may take long: a face goes with half an edge at most.
  JobState looking;
  const DecimationReport report = decimate(mesh, {.error = 0.05}, Progress(looking));
  QVERIFY(report.facesAfter < report.facesBefore);
  QVERIFY(looking.polls >= (report.facesBefore - report.facesAfter) / 2);
}

void DecimationTest::anyShape() {
  QVERIFY(rc::check("valid, of the same topology, and no face turned over", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const std::vector<TriangleSoup> shapes{test::bumpySphere(2),           test::torus(20, 10),
                                           test::moebiusStrip(20, 4),      test::sphereWithHoles(3, 4, 0.3),
                                           test::annulus(20, 4, 1.0, 2.0), test::randomBlocks(random, 12, 3),
                                           test::randomSoup(random, 60, 4)};
    HalfEdgeMesh mesh = meshOf(*rc::gen::elementOf(shapes));
    const auto flag = [] { return *rc::gen::arbitrary<bool>(); };
    DecimationOptions options{.faces = *rc::gen::inRange<std::size_t>(0, 200), .keepBorders = flag()};
    if (flag()) options.creaseAngle = 0.7;
    if (flag()) options.error = 0.05;
    options.avoidIntersections = flag();
    const long euler = test::eulerCharacteristic(mesh);
    const std::size_t pairs = options.avoidIntersections ? test::meetingPairs(mesh) : 0;
    const DecimationReport report = decimate(mesh, options);
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(test::eulerCharacteristic(mesh) == euler);
    RC_ASSERT(report.facesAfter == mesh.liveFaceCount());
    RC_ASSERT(!options.error || report.largestDistance.value_or(0.0) <= *options.error);
    if (options.avoidIntersections) RC_ASSERT(test::meetingPairs(mesh) <= pairs);
  }));
}

HANDWHEEL_TEST(DecimationTest)
#include "DecimationTest.moc"
