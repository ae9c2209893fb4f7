// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/OverlapUnion.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/repair/Repair.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/SolidAngle.h"

#include <QTest>
#include <algorithm>
#include <numeric>
#include <random>

using namespace handwheel;

namespace {

using Boxes = std::vector<Box>;

Box block(const Vec3& corner, const Vec3& size) {
  return {corner, corner + size};
}

TriangleSoup surfaceOf(const Boxes& boxes) {
  TriangleSoup soup;
  for (const Box& b : boxes) {
    test::append(soup, test::box(b.min(), b.sizes()));
  }
  return soup;
}

// Returns the exact volume of the union, by inclusion and exclusion.
double unionVolume(const Boxes& boxes) {
  double volume = 0.0;
  for (unsigned subset = 1; subset < 1u << boxes.size(); ++subset) {
    Box common(Vec3::Constant(-1e9), Vec3::Constant(1e9));
    int count = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if ((subset >> i & 1u) == 0) continue;
      common = common.intersection(boxes[i]);
      ++count;
    }
    if (!common.isEmpty()) volume += count % 2 == 1 ? common.volume() : -common.volume();
  }
  return volume;
}

// Tilts all planes; volumes stay, and so do the coordinates exact.
TriangleSoup shearedWalls(TriangleSoup s) {
  for (Vec3& p : s.points) {
    p.z() += 0.5 * p.x() + 0.25 * p.y();
    p.x() += 0.5 * p.y();
  }
  return s;
}

// A prism over a regular triangle of side 1, of this height and without its lid. The base is its largest face.
TriangleSoup openPrism(double height) {
  TriangleSoup s;
  for (const double z : {0.0, height})
    for (int i = 0; i < 3; ++i)
      s.points.emplace_back(std::cos(2.0 * M_PI * i / 3.0) / std::sqrt(3.0),
                            std::sin(2.0 * M_PI * i / 3.0) / std::sqrt(3.0), z);
  s.triangles = {{0, 2, 1}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return s;
}

const Box kCube = block({0, 0, 0}, {10, 10, 10});

}  // namespace

// Solids that overlap and have walls in common become their union.
class OverlapUnionTest : public QObject {
  Q_OBJECT

 private slots:
  void unions_data();
  void unions();
  void rotated_data() { unions_data(); }
  void rotated();
  void grids();
  void withoutACommonWallBothStay();
  void anInnerBodyStays();
  void aHoleElsewhere();
  void windingDoubt();
  void cancelled();

 private:
  static TriangleSoup repaired(const TriangleSoup& soup, NumberType numbers) {
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    RepairOptions options;
    options.fill.numbers = numbers;
    options.cutCrossings = true;
    repair(mesh, options);
    [&] {
      QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
      QCOMPARE(validate(mesh), std::string());
    }();
    return mesh.compact().soup;
  }
};

void OverlapUnionTest::unions_data() {
  QTest::addColumn<Boxes>("boxes");
  const auto row = [](const char* name, const Boxes& boxes) { QTest::newRow(name) << boxes; };
  const Vec3 ten(10, 10, 10);
  row("moved in x", {kCube, block({5, 0, 0}, ten)});
  row("moved by a third", {kCube, block({10.0 / 3.0, 0, 0}, ten)});
  row("moved a little", {kCube, block({0.125, 0, 0}, ten)});
  row("moved in x and y", {kCube, block({4, 2, 0}, ten)});
  row("a bar across a side", {kCube, block({5, 2, 0}, {10, 6, 10})});
  row("a bar on the base", {kCube, block({5, 2, 0}, {10, 6, 6})});
  row("in a corner", {kCube, block({0, 0, 0}, {5, 5, 5})});
  row("on one face", {kCube, block({2, 3, 0}, {5, 5, 5})});
  row("through two faces", {kCube, block({2, 3, 0}, {5, 5, 10})});
  row("equal", {kCube, kCube});
  row("with all of a face", {kCube, block({0, 0, 0}, {10, 10, 15})});
  row("the lower half", {kCube, block({0, 0, 0}, {10, 10, 5})});
  row("three in a row", {kCube, block({5, 0, 0}, ten), block({10, 0, 0}, ten)});
  row("three, all overlapping", {kCube, block({3, 0, 0}, ten), block({6, 0, 0}, ten)});
  row("three around a corner", {kCube, block({5, 0, 0}, ten), block({0, 5, 0}, ten)});
  row("touching and overlapping", {kCube, block({10, 0, 0}, ten), block({5, 2, 10}, {10, 6, 3})});
}

void OverlapUnionTest::unions() {
  QFETCH(Boxes, boxes);
  const TriangleSoup soup = surfaceOf(boxes);
  for (const NumberType numbers : {NumberType::Float32, NumberType::Float64}) {
    TriangleSoup given = soup;
    for (Vec3& p : given.points) p = rounded(p, numbers);
    const TriangleSoup left = repaired(given, numbers);
    QVERIFY(test::countEdges(left).sound());
    QCOMPARE(test::pieces(buildMesh(left).mesh).size(), std::size_t{1});
    const double tolerance = numbers == NumberType::Float32 ? 1e-3 : 1e-8;
    QVERIFY2(std::abs(test::volume(left) - unionVolume(boxes)) < tolerance,
             qPrintable(QString::number(test::volume(left), 'g', 15)));
    const TriangleSoup tilted = repaired(shearedWalls(given), NumberType::Float64);
    QVERIFY(test::countEdges(tilted).sound());
    QVERIFY(std::abs(test::volume(tilted) - unionVolume(boxes)) < 1e-3);
  }
}

// Rotated, no wall lies in another any more: all are off by the rounding of their corners. Either that is mended as for
// upright walls, or nothing intersects.
void OverlapUnionTest::rotated() {
  QFETCH(Boxes, boxes);
  std::mt19937 random(7);
  std::normal_distribution<double> any;
  int mended = 0;
  for (int turn = 0; turn < 6; ++turn) {
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized();
    const Vec3 shift = turn % 2 == 0 ? Vec3(0, 0, 0) : Vec3(any(random), any(random), any(random)) * 100.0;
    for (const NumberType numbers : {NumberType::Float32, NumberType::Float64}) {
      TriangleSoup given = surfaceOf(boxes);
      for (Vec3& p : given.points) p = rounded(Vec3(rotation * p + shift), numbers);
      const bool isCrossing = test::meetingPairs(buildMesh(given).mesh) > 0;
      const TriangleSoup left = repaired(given, numbers);
      QVERIFY(test::countEdges(left).sound());
      const double tolerance = numbers == NumberType::Float32 ? 1e-1 : 1e-8;
      const double wanted = isCrossing ? unionVolume(boxes) : test::volume(given);
      QVERIFY2(std::abs(test::volume(left) - wanted) < tolerance,
               qPrintable(QString::number(test::volume(left), 'g', 15)));
      mended += isCrossing;
    }
  }
  QVERIFY(mended >= 8);
}

// A cube and a box at every position of a grid that has common walls with it.
void OverlapUnionTest::grids() {
  int tried = 0;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int size = 1; size < 4; ++size) {
        const Boxes boxes{block({0, 0, 0}, {4, 4, 4}), block({1.0 * x, 1.0 * y, 0}, {1.0 * size, 2, 4})};
        const TriangleSoup left = repaired(surfaceOf(boxes), NumberType::Float64);
        QVERIFY(test::countEdges(left).sound());
        QVERIFY(std::abs(test::volume(left) - unionVolume(boxes)) < 1e-9);
        ++tried;
      }
    }
  }
  QCOMPARE(tried, 27);
}

// The union and, inside it, what they have in common.
void OverlapUnionTest::withoutACommonWallBothStay() {
  const TriangleSoup left = repaired(surfaceOf({kCube, block({5, 2, 2}, {10, 6, 6})}), NumberType::Float64);
  QVERIFY(std::abs(test::volume(left) - 1360.0) < 1e-9);
}

// Only the walls that end at a common one go.
void OverlapUnionTest::anInnerBodyStays() {
  TriangleSoup soup = surfaceOf({kCube, block({5, 0, 0}, {10, 10, 10}), block({6, 4, 4}, {2, 2, 2})});
  const TriangleSoup left = repaired(soup, NumberType::Float64);
  QVERIFY(test::countEdges(left).sound());
  QCOMPARE(test::pieces(buildMesh(left).mesh).size(), std::size_t{2});
  QVERIFY(std::abs(test::volume(left) - 1508.0) < 1e-9);
}

// Far from the common walls a small hole changes the winding numbers by little: the union has the hole.
void OverlapUnionTest::aHoleElsewhere() {
  TriangleSoup soup = surfaceOf({kCube, block({5, 0, 0}, {10, 10, 10})});
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), {{0, 4, 4}, {0, 5, 4}, {0, 4, 5}});
  // The wall x = 0 is made of the triangles that have all corners there.
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return soup.points[v].x() == 0.0; });
  });
  const auto at = [&](double y, double z) {
    const auto found = std::find(soup.points.begin(), soup.points.end(), Vec3(0, y, z));
    return static_cast<std::uint32_t>(found - soup.points.begin());
  };
  const std::uint32_t a = at(0, 0), b = at(10, 0), c = at(10, 10), d = at(0, 10);
  const std::uint32_t p = first, q = first + 1, r = first + 2;
  for (const Triangle& t :
       std::vector<Triangle>{{a, q, b}, {a, p, q}, {a, d, r}, {a, r, p}, {b, q, c}, {q, r, c}, {r, d, c}})
    soup.triangles.push_back(t);
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  std::vector<Face> faces(mesh.faceSlots());
  std::iota(faces.begin(), faces.end(), 0u);
  QVERIFY(removeAllSelfIntersections(mesh, faces, NumberType::Float64).changed);
  const TriangleSoup left = mesh.compact().soup;
  QCOMPARE(test::countEdges(left).border, std::size_t{3});
  QVERIFY(std::abs(test::area(left) - (2.0 * 100.0 + 4.0 * 150.0 - 0.5)) < 1e-9);
}

// Two equal prisms without a lid. Seen from the middle of the base, the lid has a solid angle Ω, and the winding number
// in front of the base, 0 for closed ones, is -Ω / 2π.
void OverlapUnionTest::windingDoubt() {
  const auto lidFrom = [](double height) {
    const TriangleSoup s = openPrism(height);
    return solidAngle({s.points[3], s.points[4], s.points[5]}, Vec3::Zero());
  };
  const auto removed = [&](double share) {
    double low = 0.1, high = 0.8;  // heights at which the base is larger than a triangle of a side
    const double wanted = 2.0 * M_PI * share * tolerance::kWindingDoubt;
    if (lidFrom(low) < wanted || lidFrom(high) > wanted) qFatal("no such height");
    for (int i = 0; i < 100; ++i) (lidFrom(0.5 * (low + high)) > wanted ? low : high) = 0.5 * (low + high);
    const TriangleSoup prism = openPrism(low);
    HalfEdgeMesh mesh = buildMesh(prism).mesh;
    std::vector<Vertex> again;  // built together, one would be turned over: their borders meet
    for (const Vec3& p : prism.points) again.push_back(mesh.addVertex(p));
    for (const Triangle& t : prism.triangles) mesh.addFace({again[t[0]], again[t[1]], again[t[2]]});
    return uniteAtWalls(mesh, 0, Uniting::SharedWalls);
  };
  QCOMPARE(removed(0.98), std::size_t{7});
  QCOMPARE(removed(1.02), std::size_t{0});
}

void OverlapUnionTest::cancelled() {
  TriangleSoup soup = surfaceOf({kCube, kCube});
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  JobState state;
  state.cancelled = true;
  QCOMPARE(uniteAtWalls(mesh, 0, Uniting::SharedWalls, Progress(state)), std::size_t{0});
  QCOMPARE(mesh.liveFaceCount(), std::size_t{24});
  QCOMPARE(uniteAtWalls(mesh, 0, Uniting::SharedWalls), std::size_t{12});
}

HANDWHEEL_TEST(OverlapUnionTest)
#include "OverlapUnionTest.moc"
