// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrilledTriangles.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshValidator.h"
#include "proximity/SelfIntersection.h"
#include "volume/drilling/DrillBits.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace handwheel;

namespace {

// A plate whose top is at z = 0, around the z axis; mm.
TriangleSoup flatPlate(double edge, double thickness) {
  return test::box({-0.5 * edge, -0.5 * edge, -thickness}, {edge, edge, thickness});
}

struct JoinedDrilling {
  DrilledTriangles joined;
  bool isExact = false;
  double removed = 0.0;  // mm³, by voxels
  double missing = 0.0;  // mm³, by triangles

  // Drills straight between the positions, in so many cycles each, with the shank along the axis.
  JoinedDrilling(const TriangleSoup& soup, double voxel, const char* tool, const std::vector<Vec3>& positions,
                 const Vec3& axis = Vec3::UnitZ(), NumberType numbers = NumberType::Float64) {
    constexpr int kCycles = 120;
    DrillRecord hole;
    hole.setup.tool = *drillBitOf(tool);
    HybridPart part = *HybridPart::of(soup, voxel);
    DrillRun run(part, hole.setup);
    for (std::size_t i = 1; i < positions.size(); ++i)
      for (int k = i == 1 ? 0 : 1; k <= kCycles; ++k) {
        const Vec3 position = positions[i - 1] + static_cast<double>(k) / kCycles * (positions[i] - positions[i - 1]);
        hole.poses.push_back(DrillPose::of(position, axis, 1e-3 * static_cast<double>(hole.poses.size())));
        move(run, hole.poses[hole.poses.size() - 1]);
      }
    joined = drilledTriangles(soup, part, hole, numbers);
    isExact = part.isExact();
    removed = run.removed();
    missing = test::volume(soup) - test::volume(joined.mesh.compact().soup);
  }

  // Returns the flaw of the mesh; empty: none.
  std::string flaw() const {
    if (joined.problem != SubtractionProblem::None)
      return "refused for " + std::to_string(static_cast<int>(joined.problem));
    if (!isExact) return "voxels";
    const TriangleSoup soup = joined.mesh.compact().soup;
    if (!test::countEdges(soup).sound()) return "edges";
    if (!selfIntersections(soup.points, soup.triangles).value().empty()) return "self-intersections";
    return validate(joined.mesh);
  }
};

std::array<test::Coordinates, 3> fromTheLeast(const TrianglePoints& p) {
  std::array<test::Coordinates, 3> corners{test::coordinates(p[0]), test::coordinates(p[1]), test::coordinates(p[2])};
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

// Returns the number of triangles at the beginning of a result that are not from the part.
std::size_t strangers(const Subtraction& joined, const TriangleSoup& part) {
  std::set<std::array<test::Coordinates, 3>> all;
  for (const Triangle& t : part.triangles)
    all.insert(fromTheLeast({part.points[t[0]], part.points[t[1]], part.points[t[2]]}));
  std::size_t count = 0;
  for (Face f = 0; f < joined.kept; ++f) count += !all.contains(fromTheLeast(joined.mesh.points(f)));
  return count;
}

}  // namespace

// Holes in the triangles of a part.
class DrilledTrianglesTest : public QObject {
  Q_OBJECT

 private slots:
  // Through a plate, 16 voxels to the diameter: the section times the thickness within 1 %, one handle, and the eight
  // triangles of the sides as they were.
  void throughAPlate_data() {
    QTest::addColumn<QString>("tool");
    QTest::addColumn<bool>("isSingle");
    QTest::newRow("ball") << "ball:4" << false;
    QTest::newRow("ball, in the numbers of STL") << "ball:4" << true;
    QTest::newRow("twist drill") << "twist:4" << false;
  }
  void throughAPlate() {
    QFETCH(QString, tool);
    QFETCH(bool, isSingle);
    const TriangleSoup plate = flatPlate(30.0, 4.0);
    const JoinedDrilling drilled(plate, 0.25, tool.toLatin1(), {{0.113, -0.271, 6.0}, {0.113, -0.271, -9.0}},
                                 Vec3::UnitZ(), isSingle ? NumberType::Float32 : NumberType::Float64);
    QCOMPARE(drilled.flaw(), std::string());
    const double exact = M_PI * 4.0 * 4.0;
    QVERIFY2(std::abs(drilled.missing / exact - 1.0) < 0.01, QByteArray::number(drilled.missing / exact));
    QVERIFY(std::abs(drilled.missing / drilled.removed - 1.0) < 0.02);
    QCOMPARE(test::eulerCharacteristic(drilled.joined.mesh), 0L);
    QCOMPARE(drilled.joined.kept, std::size_t{8});
    QCOMPARE(strangers(drilled.joined, plate), std::size_t{0});
    // New points are on the plate's faces or on the wall of the hole, within the chord of a cell's diagonal.
    const TriangleSoup soup = drilled.joined.mesh.compact().soup;
    for (const Vec3& p : soup.points) {
      const double away = std::abs(std::hypot(p.x() - 0.113, p.y() + 0.271) - 2.0);
      QVERIFY(away < 0.25 || std::abs(p.x()) == 15.0);
    }
  }

  // Not through: a cylinder with half a ball before it, and no handle.
  void blindHole() {
    const TriangleSoup plate = flatPlate(30.0, 8.0);
    const JoinedDrilling drilled(plate, 0.25, "ball:6", {{0.113, -0.271, 8.0}, {0.113, -0.271, -2.0}});
    QCOMPARE(drilled.flaw(), std::string());
    const double exact = M_PI * 9.0 * 2.0 + 2.0 / 3.0 * M_PI * 27.0;
    QVERIFY2(std::abs(drilled.missing / exact - 1.0) < 0.01, QByteArray::number(drilled.missing / exact));
    QCOMPARE(test::eulerCharacteristic(drilled.joined.mesh), 2L);
    QCOMPARE(drilled.joined.kept, std::size_t{10});
  }

  // Along the side of a plate half of the section is in it; two holes are two handles; from within, a cavity.
  void otherHoles() {
    const TriangleSoup plate = flatPlate(30.0, 4.0);
    const JoinedDrilling side(plate, 0.25, "ball:4", {{15.0, 3.3, 6.0}, {15.0, 3.3, -9.0}});
    QCOMPARE(side.flaw(), std::string());
    QVERIFY(std::abs(side.missing / (M_PI * 2.0 * 4.0) - 1.0) < 0.01);
    QCOMPARE(test::eulerCharacteristic(side.joined.mesh), 2L);

    const JoinedDrilling two(
        plate, 0.25, "ball:4",
        {{-8.1, 1.3, 6.0}, {-8.1, 1.3, -9.0}, {-8.1, 1.3, 6.0}, {7.3, -2.2, 6.0}, {7.3, -2.2, -9.0}});
    QCOMPARE(two.flaw(), std::string());
    QVERIFY(std::abs(two.missing / (2.0 * M_PI * 4.0 * 4.0) - 1.0) < 0.01);
    QCOMPARE(test::eulerCharacteristic(two.joined.mesh), -2L);

    const TriangleSoup block = test::box({0, 0, 0}, {20, 20, 20});
    const JoinedDrilling cavity(block, 0.25, "ball:6", {{9.1, 10.2, 9.7}, {12.1, 10.2, 9.7}});
    QCOMPARE(cavity.flaw(), std::string());
    QVERIFY(std::abs(cavity.missing / (M_PI * 9.0 * 3.0 + 4.0 / 3.0 * M_PI * 27.0) - 1.0) < 0.01);
    QCOMPARE(cavity.joined.kept, std::size_t{12});
  }

  // Fine triangles away from the hole stay, each of them: the part keeps what it has beside the hole, to the last
  // digit.
  void restStays() {
    const TriangleSoup ball = test::moved(test::icosphere(4), Vec3(0.1, -0.2, -7.0), 7.0);
    double edge = 0.0;
    for (const Triangle& t : ball.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        edge = std::max(edge, (ball.points[t[k]] - ball.points[t[(k + 1) % 3]]).norm());
    const JoinedDrilling drilled(ball, 0.2, "burr:3", {{0.613, -0.421, 4.0}, {0.613, -0.421, -19.0}});
    QCOMPARE(drilled.flaw(), std::string());
    QCOMPARE(test::eulerCharacteristic(drilled.joined.mesh), 0L);
    QCOMPARE(strangers(drilled.joined, ball), std::size_t{0});
    std::size_t far = 0;
    for (const Triangle& t : ball.triangles)
      far += std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
        return std::hypot(ball.points[v].x() - 0.613, ball.points[v].y() + 0.421) > 1.5 + edge;
      });
    QVERIFY(drilled.joined.kept >= far && 10 * far > 9 * ball.triangles.size());
  }

  // Through a ball anyhow: a handle each time, and nothing but the hole is taken, as voxels count it. Lines through the
  // middle run through corners of voxels and triangles.
  void anyWayThrough() {
    const TriangleSoup ball = test::moved(test::icosphere(3), Vec3::Zero(), 7.0);
    std::mt19937 random(20);
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    for (int i = 0; i < 8; ++i) {
      const Vec3 along = i == 0   ? Vec3(1.0, 0.0, 0.0)
                         : i == 1 ? Vec3(1.0, 1.0, 1.0).normalized()
                                  : Vec3(within(random), within(random), within(random)).normalized();
      const Vec3 beside = i < 2 ? Vec3(Vec3::Zero()) : Vec3(2.0 * Vec3(within(random), within(random), within(random)));
      const JoinedDrilling drilled(ball, 0.2, "ball:3", {beside + 12.0 * along, beside - 12.0 * along}, Vec3::UnitZ(),
                                   i % 2 == 0 ? NumberType::Float64 : NumberType::Float32);
      QCOMPARE(drilled.flaw(), std::string());
      QCOMPARE(test::eulerCharacteristic(drilled.joined.mesh), 0L);
      QVERIFY(std::abs(drilled.missing / drilled.removed - 1.0) < 0.03);
      if (i % 2 == 0) QCOMPARE(strangers(drilled.joined, ball), std::size_t{0});
    }
  }

  // A saw goes through a block that lies anyhow, and parts it.
  void sawnInTwo() {
    TriangleSoup block = test::box({-5.0, -2.0, -3.0}, {10.0, 4.0, 6.0});
    for (Vec3& p : block.points) p = Eigen::AngleAxisd(0.2, Vec3(0.3, 0.8, 0.5).normalized()) * p;
    const JoinedDrilling drilled(block, 0.2, "saw:30:1.6", {{0.07, 0.03, 24.0}, {0.07, 0.03, 8.0}}, Vec3::UnitX());
    QCOMPARE(drilled.flaw(), std::string());
    QCOMPARE(test::pieces(drilled.joined.mesh).size(), std::size_t{2});
    QVERIFY(std::abs(drilled.missing / drilled.removed - 1.0) < 0.02);
  }

  void nothingIsCut() {
    const TriangleSoup plate = flatPlate(20.0, 4.0);
    const JoinedDrilling drilled(plate, 0.25, "ball:4", {{40.0, 0.0, 6.0}, {40.0, 0.0, -9.0}});
    QCOMPARE(drilled.flaw(), std::string());
    QCOMPARE(drilled.joined.kept, std::size_t{12});
    QVERIFY(std::abs(drilled.missing) < 1e-9);
  }

  // A hole that the part had is closed as it is for voxels: one face of a side is missing, and a boundary of three
  // edges gets a triangle. It is not among those that are kept.
  void openPart() {
    TriangleSoup open = flatPlate(20.0, 4.0);
    const Triangle gone = open.triangles.back();  // triangle of a side
    open.triangles.pop_back();
    for (const std::uint32_t v : gone) QCOMPARE(open.points[v].x(), 10.0);
    const JoinedDrilling drilled(open, 0.25, "ball:4", {{0.1, 0.2, 6.0}, {0.1, 0.2, -9.0}});
    QCOMPARE(drilled.flaw(), std::string());
    QCOMPARE(drilled.joined.closing, std::size_t{1});
    QCOMPARE(drilled.joined.kept, std::size_t{7});
    QCOMPARE(strangers(drilled.joined, open), std::size_t{0});
    const double left = test::volume(drilled.joined.mesh.compact().soup);
    QVERIFY(std::abs((20.0 * 20.0 * 4.0 - left) / (M_PI * 4.0 * 4.0) - 1.0) < 0.01);
    const JoinedDrilling whole(flatPlate(20.0, 4.0), 0.25, "ball:4", {{0.1, 0.2, 6.0}, {0.1, 0.2, -9.0}});
    QCOMPARE(whole.joined.closing, std::size_t{0});
  }

  // A part that intersects itself far from the hole is left to voxels.
  void crossingPart() {
    TriangleSoup crossing = flatPlate(20.0, 4.0);
    test::append(crossing, test::box({40, 40, 40}, {10, 10, 10}));
    test::append(crossing, test::box({45, 45, 45}, {10, 10, 10}));
    const JoinedDrilling drilled(crossing, 0.25, "ball:4", {{0.1, 0.2, 6.0}, {0.1, 0.2, -9.0}});
    QVERIFY(drilled.isExact);
    QVERIFY(drilled.joined.problem == SubtractionProblem::IntersectsItself);
    QCOMPARE(drilled.joined.mesh.liveFaceCount(), std::size_t{0});
  }
};

HANDWHEEL_TEST(DrilledTrianglesTest)
#include "DrilledTrianglesTest.moc"
