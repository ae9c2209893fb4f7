// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/Section.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>
#include <numeric>
#include <set>

using namespace handwheel;

class SectionTest : public QObject {
  Q_OBJECT

 private slots:
  void cube();
  void hexagonThroughACube();
  void sphere();
  void torusThroughItsVertices();
  void torusAcross();
  void hollowCountsOff();
  void overlapsCountOnce();
  void overlapsOfRandomBoxes();
  void insideOut();
  void axesOfThePlane();
  void axesNearZ();
  void blocksInLayers();
  void slicesAddUpToTheVolume();
  void openSheet();
  void touchedAtAVertexOrAnEdge();
  void inThePlaneOfAWall();
  void inTheWallsOfAHollow();
  void sheetInThePlane();
  void farFromTheOrigin();
  void oddNumbers();
  void cancelled();
};

namespace {

HalfEdgeMesh sectionMeshOf(const TriangleSoup& soup) {
  return buildMesh(soup).mesh;
}

Section cut(const TriangleSoup& soup, const Vec3& normal, double offset) {
  return sectionOf(sectionMeshOf(soup), normal, offset);
}

bool isWithin(double a, double b, double tolerance = 1e-12) {
  return std::abs(a - b) <= tolerance;
}

double volumeOf(const TriangleSoup& s) {
  double six = 0.0;
  for (const Triangle& t : s.triangles) six += s.points[t[0]].cross(s.points[t[1]]).dot(s.points[t[2]]);
  return six / 6.0;
}

}  // namespace

// The sides themselves are sections, too: the limit from inside.
void SectionTest::cube() {
  const TriangleSoup box = test::cube(2.0, Vec3(1, 2, 3));
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
    const double low = axis.dot(Vec3(1, 2, 3));
    for (const double height : {0.0, 0.3, 1.0, 1.9999999, 2.0}) {
      const Section s = cut(box, axis, low + height);
      QCOMPARE(s.curves.size(), std::size_t{1});
      QVERIFY(s.isClosed && isWithin(s.length, 8.0) && isWithin(s.area, 4.0));
    }
    for (const double height : {-1e-9, 2.000001, 5.0}) QVERIFY(cut(box, axis, low + height).curves.empty());
    // From the other side the same, the two ends exchanged.
    QVERIFY(isWithin(cut(box, -axis, -(low + 0.3)).area, 4.0));
    QVERIFY(isWithin(cut(box, -axis, -(low + 2.0)).area, 4.0));
  }
}

void SectionTest::hexagonThroughACube() {
  const Section s = cut(test::cube(), Vec3(1, 1, 1).normalized(), 1.5 / std::sqrt(3.0));
  QVERIFY(s.isClosed && isWithin(s.length, 3.0 * std::sqrt(2.0)) && isWithin(s.area, 0.75 * std::sqrt(3.0)));
}

// Inside the circle of the sphere and outside that of the ball within all faces.
void SectionTest::sphere() {
  const TriangleSoup ball = test::icosphere(4);
  double inner = 1.0;
  for (const Triangle& t : ball.triangles) {
    const Vec3 n = (ball.points[t[1]] - ball.points[t[0]]).cross(ball.points[t[2]] - ball.points[t[0]]).normalized();
    inner = std::min(inner, n.dot(ball.points[t[0]]));
  }
  QVERIFY(inner > 0.99);
  for (const Vec3& direction : test::directions(20)) {
    for (const double h : {-0.7, -0.2, 0.0, 0.5, 0.9}) {
      const Section s = cut(ball, direction, h);
      QCOMPARE(s.curves.size(), std::size_t{1});
      QVERIFY(s.area <= M_PI * (1.0 - h * h) && s.area >= M_PI * (inner * inner - h * h));
      QVERIFY(s.length <= 2.0 * M_PI * std::sqrt(1.0 - h * h));
      QVERIFY(s.length >= 2.0 * M_PI * std::sqrt(inner * inner - h * h));
    }
  }
}

// Its equators are made of vertices, some above the plane and some below by a rounding.
void SectionTest::torusThroughItsVertices() {
  constexpr std::uint32_t n = 60;
  const Section s = cut(test::torus(n, 24, 2.0, 0.7), Vec3::UnitZ(), 0.0);
  const double polygon = 0.5 * n * std::sin(2.0 * M_PI / n);
  QVERIFY(s.isClosed);
  QCOMPARE(s.curves.size(), std::size_t{2});
  QVERIFY(isWithin(s.area, polygon * (2.7 * 2.7 - 1.3 * 1.3), 1e-9));
  QVERIFY(isWithin(s.length, 2.0 * n * std::sin(M_PI / n) * (2.7 + 1.3), 1e-9));
}

void SectionTest::torusAcross() {
  const Section s = cut(test::torus(200, 200, 2.0, 0.7), Vec3(1, 2, 0).normalized(), 0.0);
  QCOMPARE(s.curves.size(), std::size_t{2});
  QVERIFY(isWithin(s.area, 2.0 * M_PI * 0.49, 2e-3) && isWithin(s.length, 4.0 * M_PI * 0.7, 2e-3));
}

void SectionTest::hollowCountsOff() {
  TriangleSoup shell = test::cube(4.0, Vec3::Constant(-2.0));
  test::append(shell, test::turnedOver(test::cube(2.0, Vec3::Constant(-1.0))));
  const Section s = cut(shell, Vec3::UnitY(), 0.25);
  QCOMPARE(s.curves.size(), std::size_t{2});
  QVERIFY(isWithin(s.area, 16.0 - 4.0) && isWithin(s.length, 16.0 + 8.0));
}

// Two boxes of 4 × 4 that share 2 × 2, one of them with a hollow of 1 × 1 in what they share, which the other fills;
// one box twice; one within another.
void SectionTest::overlapsCountOnce() {
  TriangleSoup two = test::cube(4.0);
  test::append(two, test::cube(4.0, Vec3(2, 2, 0)));
  QVERIFY(isWithin(cut(two, Vec3::UnitZ(), 1.0).area, 16.0 + 16.0 - 4.0));
  QVERIFY(isWithin(cut(two, Vec3::UnitZ(), 1.0).length, 32.0));
  TriangleSoup filled = two;
  test::append(filled, test::turnedOver(test::cube(1.0, Vec3(2.5, 2.5, 0.5))));
  QVERIFY(isWithin(cut(filled, Vec3::UnitZ(), 1.0).area, 28.0));
  TriangleSoup nested = test::cube(4.0);
  test::append(nested, test::cube(1.0, Vec3(1, 1, 1)));
  QVERIFY(isWithin(cut(nested, Vec3::UnitZ(), 1.5).area, 16.0));
  TriangleSoup touching = test::cube(2.0);
  test::append(touching, test::cube(2.0, Vec3(2, 1, 0)));
  QVERIFY(isWithin(cut(touching, Vec3::UnitZ(), 1.0).area, 8.0));
}

// Compares sections of boxes with integer corners with the covered squares of the grid, across each axis.
void SectionTest::overlapsOfRandomBoxes() {
  QVERIFY(rc::check("as many squares as are covered", [] {
    const int axis = *rc::gen::inRange(0, 3), a = (axis + 1) % 3, b = (axis + 2) % 3;
    const double tilt = *rc::gen::element(0.0, 0.3, 1.1);  // the whole is turned about the axis
    TriangleSoup all;
    std::set<std::pair<int, int>> covered;
    for (int n = *rc::gen::inRange(1, 9); n > 0; --n) {
      const int size = *rc::gen::inRange(1, 5), x = *rc::gen::inRange(0, 8), y = *rc::gen::inRange(0, 8);
      Vec3 corner = Vec3::Zero();
      corner[a] = x;
      corner[b] = y;
      test::append(all, test::cube(size, corner));
      for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) covered.emplace(x + i, y + j);
      }
    }
    const Eigen::AngleAxisd turn(tilt, Vec3::Unit(axis));
    for (Vec3& p : all.points) p = turn * p;
    const Section s = cut(all, Vec3::Unit(axis), 0.5);
    RC_ASSERT(isWithin(s.area, static_cast<double>(covered.size()), 1e-9));
  }));
}

void SectionTest::insideOut() {
  QVERIFY(isWithin(cut(test::turnedOver(test::cube(2.0)), Vec3::UnitX(), 1.0).area, 4.0));
}

void SectionTest::axesOfThePlane() {
  for (const Vec3& normal : test::directions(50)) {
    const auto [u, v] = axesOfPlane(normal);
    QVERIFY(isWithin(u.norm(), 1.0) && isWithin(v.norm(), 1.0) && isWithin((u.cross(v) - normal).norm(), 0.0));
  }
  for (const Vec3& normal : {Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ()), Vec3(Vec3(1e-13, 0, 1).normalized())}) {
    const auto [u, v] = axesOfPlane(normal);
    QVERIFY(isWithin((u.cross(v) - normal).norm(), 0.0) && isWithin((u - Vec3::UnitX()).norm(), 0.0));
  }
  QVERIFY(isWithin((axesOfPlane(Vec3::UnitX()).u - Vec3::UnitY()).norm(), 0.0));
}

// Blocks that touch at edges and corners: each layer has as much area as it has blocks. In the plane between two layers
// the lower one counts, and of bodies that begin there the upper one.
void SectionTest::blocksInLayers() {
  QVERIFY(rc::check("the area of a layer is the number of its blocks", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    constexpr std::uint32_t kSide = 4;
    const TriangleSoup soup = test::randomBlocks(random, *rc::gen::inRange<std::size_t>(1, 50), kSide);
    const HalfEdgeMesh mesh = sectionMeshOf(soup);
    double volume = 0.0;
    for (std::uint32_t layer = 0; layer < kSide; ++layer) {
      const Section between = sectionOf(mesh, Vec3::UnitZ(), layer),
                    within = sectionOf(mesh, Vec3::UnitZ(), layer + 0.3);
      RC_ASSERT(between.isClosed && within.isClosed);
      RC_ASSERT(isWithin(within.area, std::round(within.area), 1e-9));
      const double lower = layer == 0 ? 0.0 : sectionOf(mesh, Vec3::UnitZ(), layer - 0.7).area;
      RC_ASSERT(between.area >= lower - 1e-9);
      if (layer == 0) RC_ASSERT(isWithin(between.area, within.area, 1e-9));
      volume += within.area;
    }
    RC_ASSERT(isWithin(volume, volumeOf(soup), 1e-9));
  }));
}

// Cavalieri: by Simpson's rule, which is exact between the vertices of a polyhedron as areas are quadratic there.
void SectionTest::slicesAddUpToTheVolume() {
  QVERIFY(rc::check("the areas of all slices add up to the volume", [] {
    const TriangleSoup shape = *rc::gen::element(test::bumpySphere(1), test::torus(7, 5), test::tetrahedron());
    const Vec3 normal = test::directions(97)[*rc::gen::inRange<std::size_t>(0, 97)];
    const HalfEdgeMesh mesh = sectionMeshOf(shape);
    std::vector<double> heights;
    for (const Vec3& p : shape.points) heights.push_back(normal.dot(p));
    std::sort(heights.begin(), heights.end());
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
      const double width = heights[i + 1] - heights[i];
      if (width < 1e-7) continue;
      const auto area = [&](double share) {
        const Section s = sectionOf(mesh, normal, heights[i] + share * width);
        RC_ASSERT(s.isClosed);
        return s.area;
      };
      // Open at both ends (Milne), as at the ends themselves a piece may have just begun.
      sum += width / 3.0 * (2.0 * area(0.25) - area(0.5) + 2.0 * area(0.75));
    }
    RC_ASSERT(isWithin(sum, volumeOf(shape), 1e-5));
  }));
}

void SectionTest::openSheet() {
  const TriangleSoup sheet =
      test::grid(9, 9, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.0); });
  const Section s = cut(sheet, Vec3::UnitX(), 3.25);
  QCOMPARE(s.curves.size(), std::size_t{1});
  QVERIFY(!s.isClosed && !s.curves[0].closed && isWithin(s.length, 8.0) && s.area == 0.0);
  QVERIFY(isWithin((s.curves[0].points.front() - s.curves[0].points.back()).norm(), 8.0));
  QCOMPARE(cut(test::withHole(sheet, Vec3(4, 4, 0), 0.5), Vec3::UnitX(), 3.5).curves.size(), std::size_t{2});
}

// An apex or an edge in the plane with the body above it: nothing of it is a section.
void SectionTest::touchedAtAVertexOrAnEdge() {
  const TriangleSoup body{{Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(-1, 1, 1), Vec3(-1, -1, 1)},
                          {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  QVERIFY(isWithin(volumeOf(body), 2.0 / 3.0));
  QVERIFY(cut(body, Vec3::UnitZ(), 0.0).curves.empty());
  QVERIFY(cut(body, -Vec3::UnitZ(), 0.0).curves.empty());
  TriangleSoup roof = body;
  roof.points[1] = Vec3(1, 0, 0);  // now an edge lies in the plane
  QVERIFY(cut(roof, Vec3::UnitZ(), 0.0).curves.empty());
  QVERIFY(cut(roof, Vec3::UnitZ(), 1e-9).area > 0.0);
}

// A step of 4 × 4 × 1 with 2 × 4 on it up to 3, as one body; also turned, and far from the origin.
void SectionTest::inThePlaneOfAWall() {
  // The profile in x and z, drawn out along y.
  const std::vector<Eigen::Vector2d> profile = {{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 3}, {0, 3}};
  TriangleSoup step;
  for (const double y : {0.0, 4.0})
    for (const Eigen::Vector2d& p : profile) step.points.emplace_back(p.x(), y, p.y());
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    step.triangles.push_back({i, i + 6, j});
    step.triangles.push_back({j, i + 6, j + 6});
  }
  for (const Triangle& t : {Triangle{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}}) {
    step.triangles.push_back(t);
    step.triangles.push_back({t[0] + 6, t[2] + 6, t[1] + 6});
  }
  QVERIFY(isWithin(std::abs(volumeOf(step)), 16.0 + 16.0));
  TriangleSoup both = step;  // with a body whose lid is at the shelf, and one that begins there
  test::append(both, test::moved(test::cube(1.0), Vec3(10, 0, 0)));
  test::append(both, test::moved(test::cube(1.5), Vec3(20, 0, 1)));
  struct Wall {
    double height, area, length;
  };
  const std::vector<Wall> walls = {{0.0, 16.0, 16.0}, {1.0, 16.0, 16.0}, {3.0, 8.0, 12.0}};
  const Eigen::Quaterniond turns[] = {Eigen::Quaterniond::Identity(),
                                      Eigen::Quaterniond(0.3, 0.5, -0.7, 0.2).normalized()};
  for (const Eigen::Quaterniond& turn : turns) {
    for (const Vec3& far : {Vec3(0, 0, 0), Vec3(1e6, -1e6, 1e6)}) {
      for (const bool isSingle : {false, true}) {
        if (isSingle && !far.isZero()) continue;
        const auto placed = [&](TriangleSoup s) {
          for (Vec3& p : s.points) p = turn * p + far;
          if (isSingle)
            for (Vec3& p : s.points) p = p.cast<float>().cast<double>();
          return s;
        };
        const Vec3 normal = turn * Vec3::UnitZ();
        const double precision = far.isZero() ? 1e-5 : 1e-8 * 1e6;
        for (const Wall& wall : walls) {
          const Section s = cut(placed(step), normal, normal.dot(far) + wall.height);
          QVERIFY(s.isClosed);
          QCOMPARE(s.curves.size(), std::size_t{1});
          QVERIFY(s.facesInPlane >= 2);
          QVERIFY2(isWithin(s.area, wall.area, precision), qPrintable(QString::number(s.area)));
          QVERIFY(isWithin(s.length, wall.length, precision));
        }
        const Section s = cut(placed(both), normal, normal.dot(far) + 1.0);
        QVERIFY(s.isClosed && isWithin(s.area, 16.0 + 1.0 + 2.25, precision));
      }
    }
  }
}

// A hollow is cut off where it is cut just below its lid, and not where it begins: that plane is of material.
void SectionTest::inTheWallsOfAHollow() {
  TriangleSoup shell = test::cube(4.0);
  test::append(shell, test::turnedOver(test::cube(2.0, Vec3(1, 1, 1))));
  QVERIFY(isWithin(cut(shell, Vec3::UnitZ(), 1.0).area, 16.0));
  QVERIFY(isWithin(cut(shell, Vec3::UnitZ(), 3.0).area, 12.0));
}

void SectionTest::sheetInThePlane() {
  const TriangleSoup sheet =
      test::grid(3, 3, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 2.0); });
  const Section s = cut(sheet, Vec3::UnitZ(), 2.0);
  QVERIFY(s.curves.empty() && s.isTouched);
  QCOMPARE(s.facesInPlane, std::size_t{8});
}

void SectionTest::farFromTheOrigin() {
  const Vec3 far(3e6, -5e6, 1e6);
  const Section near = cut(test::bumpySphere(3), Vec3::UnitX(), 0.125);
  const Section away = cut(test::moved(test::bumpySphere(3), far), Vec3::UnitX(), 0.125 + far.x());
  QVERIFY(away.isClosed && isWithin(near.area, away.area, 1e-8) && isWithin(near.length, away.length, 1e-7));
  const Section tiny = cut(test::moved(test::bumpySphere(3), Vec3::Zero(), 1e-9), Vec3::UnitX(), 0.125e-9);
  QVERIFY(isWithin(tiny.area * 1e18, near.area, 1e-9));
}

void SectionTest::oddNumbers() {
  QVERIFY(sectionOf({}, Vec3::UnitX(), 0.0).curves.empty());
  TriangleSoup s = test::cube();
  s.points.emplace_back(std::nan(""), 0.0, 0.0);
  s.triangles.push_back({0, 1, 8});
  s.triangles.push_back({0, 0, 7});
  const Section with = cut(s, Vec3::UnitZ(), 0.5);
  QVERIFY(isWithin(with.length, 4.0) || !with.isClosed);
  for (const SectionCurve& curve : with.curves) {
    for (const Vec3& p : curve.points) QVERIFY(p.allFinite());
  }
  QVERIFY(cut(test::cube(), Vec3::UnitZ(), std::nan("")).curves.empty());
}

void SectionTest::cancelled() {
  JobState job;
  job.cancelled = true;
  QVERIFY(sectionOf(sectionMeshOf(test::cube()), Vec3::UnitZ(), 0.5, Progress(job)).curves.empty());
}

// Across Z and the normal, from a sine of kAlongAxis between them on; nearer, X in the plane.
void SectionTest::axesNearZ() {
  for (const double share : {0.5, 2.0}) {
    const double sine = share * tolerance::kAlongAxis;
    const Vec3 normal(0.0, sine, std::sqrt(1.0 - sine * sine));
    const Vec3 expected = share > 1.0 ? Vec3(-1, 0, 0) : Vec3(1, 0, 0);  // Z × normal
    QVERIFY((axesOfPlane(normal).u - expected).norm() < 1e-12);
  }
}

HANDWHEEL_TEST(SectionTest)
#include "SectionTest.moc"
