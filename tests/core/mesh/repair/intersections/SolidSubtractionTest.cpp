// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/SolidSubtraction.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

using namespace handwheel;

namespace {

Subtraction difference(const TriangleSoup& part, const TriangleSoup& tool, NumberType numbers = NumberType::Float64) {
  return subtractSolid(part, tool, numbers);
}

// Returns the flaw of a result apart from its shape; empty: none.
std::string flawOf(const Subtraction& done) {
  if (done.problem != SubtractionProblem::None) return "refused for " + std::to_string(static_cast<int>(done.problem));
  if (!test::countEdges(done.mesh).sound()) return "edges";
  if (test::meetingPairs(done.mesh) > 0) return "self-intersections";
  return validate(done.mesh);
}

double volumeLeft(const Subtraction& done) {
  return test::volume(done.mesh.compact().soup);
}

TriangleSoup turnedBy(TriangleSoup soup, double angle, const Vec3& axis) {
  const Eigen::AngleAxisd turn(angle, axis.normalized());
  for (Vec3& p : soup.points) p = turn * p;
  return soup;
}

// The corners of a triangle, from the least on.
std::array<test::Coordinates, 3> orderedCorners(const TrianglePoints& p) {
  std::array<test::Coordinates, 3> corners{test::coordinates(p[0]), test::coordinates(p[1]), test::coordinates(p[2])};
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

const TriangleSoup kBlock = test::box({0, 0, 0}, {10, 10, 10});

}  // namespace

// One solid less another, by their triangles.
class SolidSubtractionTest : public QObject {
  Q_OBJECT

 private slots:
  // A corner is cut off: the sides that it is not at stay.
  void corner() {
    const Subtraction done = difference(kBlock, test::box({5, 5, 5}, {10, 10, 10}));
    QCOMPARE(flawOf(done), std::string());
    QVERIFY(std::abs(volumeLeft(done) - 875.0) < 1e-9);
    QCOMPARE(done.kept, std::size_t{6});
    for (Face f = 0; f < done.kept; ++f) {
      const TrianglePoints p = done.mesh.points(f);
      const auto isAt0 = [&](Eigen::Index k) { return p[0][k] == 0.0 && p[1][k] == 0.0 && p[2][k] == 0.0; };
      QVERIFY(isAt0(0) || isAt0(1) || isAt0(2));
    }
  }

  // A rod of n sides goes through: the hole is its section times the thickness, and the result has a handle.
  void hole_data() {
    QTest::addColumn<int>("sides");
    for (const int sides : {5, 48, 700}) QTest::addRow("%d", sides) << sides;
  }
  void hole() {
    QFETCH(int, sides);
    const TriangleSoup rod =
        test::moved(test::cylinder(static_cast<std::uint32_t>(sides), 1, 2.0, 14.0, true), Vec3(4.7, 5.2, -2.0));
    const Subtraction done = difference(kBlock, rod);
    if (sides < 100) {
      QCOMPARE(flawOf(done), std::string());
    } else {
      QVERIFY(done.problem == SubtractionProblem::None && test::countEdges(done.mesh).sound());
    }
    const double section = 0.5 * sides * 4.0 * std::sin(2.0 * M_PI / sides);
    QVERIFY2(std::abs(volumeLeft(done) - (1000.0 - 10.0 * section)) < 1e-8, QByteArray::number(volumeLeft(done)));
    QCOMPARE(test::eulerCharacteristic(done.mesh), 0L);
    QCOMPARE(done.kept, std::size_t{8});
  }

  // Beside the part, within it, around it.
  void apart() {
    const Subtraction beside = difference(kBlock, test::box({20, 0, 0}, {5, 5, 5}));
    QCOMPARE(flawOf(beside), std::string());
    QCOMPARE(beside.kept, std::size_t{12});
    QCOMPARE(beside.mesh.liveFaceCount(), std::size_t{12});
    const Subtraction cavity = difference(kBlock, test::box({3, 3, 3}, {2, 2, 2}));
    QCOMPARE(flawOf(cavity), std::string());
    QCOMPARE(cavity.kept, std::size_t{12});
    QVERIFY(std::abs(volumeLeft(cavity) - 992.0) < 1e-9);
    const Subtraction nothing = difference(kBlock, test::box({-1, -1, -1}, {12, 12, 12}));
    QVERIFY(nothing.problem == SubtractionProblem::None);
    QCOMPARE(nothing.mesh.liveFaceCount(), std::size_t{0});
    const Subtraction noTool = difference(kBlock, {});
    QCOMPARE(flawOf(noTool), std::string());
    QCOMPARE(noTool.kept, std::size_t{12});
  }

  // A bar cuts a block in two.
  void inTwo() {
    const Subtraction done = difference(kBlock, test::box({4, -1, -1}, {1.5, 12, 12}));
    QCOMPARE(flawOf(done), std::string());
    QVERIFY(std::abs(volumeLeft(done) - 850.0) < 1e-9);
    QCOMPARE(test::pieces(done.mesh).size(), std::size_t{2});
    QCOMPARE(done.kept, std::size_t{4});
  }

  // Both subtractions remove the same volume, that of the common part, in any position.
  void inBothDirections() {
    const TriangleSoup ball = test::moved(test::icosphere(3), Vec3(7.1, 6.3, 8.2), 4.0);
    for (int i = 0; i < 6; ++i) {
      const TriangleSoup block = turnedBy(kBlock, 0.37 * i + 0.11, Vec3(1.0, 0.3 * i, -0.7));
      const TriangleSoup turned = turnedBy(ball, 0.37 * i + 0.11, Vec3(1.0, 0.3 * i, -0.7));
      const Subtraction one = difference(block, turned), other = difference(turned, block);
      QCOMPARE(flawOf(one), std::string());
      QCOMPARE(flawOf(other), std::string());
      const double common = 1000.0 - volumeLeft(one);
      QVERIFY(common > 1.0);
      QVERIFY(std::abs(common - (test::volume(turned) - volumeLeft(other))) < 1e-8);
      // Kept triangles are those of the part.
      QVERIFY(other.kept > 0 && other.kept < turned.triangles.size());
      std::set<std::array<test::Coordinates, 3>> all;
      for (const Triangle& t : turned.triangles)
        all.insert(orderedCorners({turned.points[t[0]], turned.points[t[1]], turned.points[t[2]]}));
      for (Face f = 0; f < other.kept; ++f) QVERIFY(all.contains(orderedCorners(other.mesh.points(f))));
    }
  }

  // In the numbers of an STL file: each coordinate is one, and the shape is that to their digits. What rounding folds
  // is refused, which is rare.
  void singlePrecision() {
    int done = 0;
    for (int i = 0; i < 8; ++i) {
      const TriangleSoup ball = test::moved(test::icosphere(2), Vec3(5.3 + 0.013 * i, 4.1, 9.2), 2.5);
      const Subtraction less = difference(kBlock, ball, NumberType::Float32);
      if (less.problem == SubtractionProblem::Unsound) continue;
      ++done;
      QCOMPARE(flawOf(less), std::string());
      const Subtraction exact = difference(kBlock, ball);
      QVERIFY(std::abs(volumeLeft(less) - volumeLeft(exact)) < 1e-3);
      for (const Vec3& p : less.mesh.compact().soup.points) QCOMPARE(p, rounded(p, NumberType::Float32));
    }
    QVERIFY2(done >= 4, QByteArray::number(done));
  }

  // Walls on each other are cut rightly or not at all.
  void wallsOnEachOther() {
    const Subtraction done = difference(kBlock, test::box({2, 2, 5}, {6, 6, 5}));
    if (done.problem == SubtractionProblem::Unsound) return;
    QCOMPARE(flawOf(done), std::string());
    QVERIFY(std::abs(volumeLeft(done) - 820.0) < 1e-9);
  }

  void refused() {
    TriangleSoup open = kBlock;
    open.triangles.pop_back();
    const TriangleSoup tool = test::box({5, 5, 5}, {10, 10, 10});
    QVERIFY(difference(open, tool).problem == SubtractionProblem::NotClosed);
    TriangleSoup turned = kBlock;
    std::swap(turned.triangles[3][0], turned.triangles[3][1]);
    QVERIFY(difference(turned, tool).problem == SubtractionProblem::NotClosed);
    QVERIFY(difference(test::twoCubesSharingAnEdge(), tool).problem == SubtractionProblem::NotClosed);
    TriangleSoup crossing = kBlock;
    test::append(crossing, test::box({5, 5, -5}, {3, 3, 20}));
    QVERIFY(difference(crossing, tool).problem == SubtractionProblem::IntersectsItself);
    QVERIFY(difference(kBlock, open).problem == SubtractionProblem::Unsound);
    // A body that is inside out has nothing to be taken from.
    QVERIFY(difference(test::turnedOver(kBlock), tool).problem == SubtractionProblem::Unsound);
    QVERIFY(difference({}, tool).mesh.liveFaceCount() == 0);
  }
};

HANDWHEEL_TEST(SolidSubtractionTest)
#include "SolidSubtractionTest.moc"
