// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/CreaseFill.h"

#include "CreasedShapes.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>
#include <functional>

using namespace handwheel;

namespace {

using Distance = std::function<double(const Vec3&)>;

FillOptions creaseFillOnly(FillMethod method) {
  FillOptions options;
  options.method = method;
  options.tryOthers = false;
  return options;
}

// The root of the mean square distance of the patch from the surface, by area.
double rms(const Patch& patch, const Distance& distance) {
  constexpr int kCuts = 4;
  double squares = 0.0, area = 0.0;
  for (const Triangle& t : patch.triangles) {
    const Vec3 a = patch.points[t[0]], u = (patch.points[t[1]] - a) / kCuts, v = (patch.points[t[2]] - a) / kCuts;
    for (int i = 0; i < kCuts; ++i) {
      for (int j = 0; j < kCuts - i; ++j) {
        const double d = distance(a + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v), part = u.cross(v).norm();
        squares += part * d * d;
        area += part;
      }
    }
  }
  return std::sqrt(squares / area);
}

struct CreaseFillErrors {
  std::vector<double> fair, crease;  // RMS / diameter of the hole
  double p90(std::vector<double> values) const {
    std::sort(values.begin(), values.end());
    return values[values.size() * 9 / 10];
  }
};

// Cuts a ball out of the part around each centre and fills the hole with both methods.
CreaseFillErrors cutAndFill(const TriangleSoup& part, const std::vector<Vec3>& centres, double radius,
                            const Distance& distance) {
  CreaseFillErrors errors;
  for (const Vec3& centre : centres) {
    const HalfEdgeMesh mesh = buildMesh(test::withHole(part, centre, radius)).mesh;
    const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
    const HoleFiller filler(mesh);
    const FillAttempt fair = filler.propose(loop, {}),
                      crease = filler.propose(loop, creaseFillOnly(FillMethod::Crease));
    if (fair.failure != FillFailure::None || crease.failure != FillFailure::None) continue;
    errors.fair.push_back(rms(fair.patch, distance) / loop.box.diagonal().norm());
    errors.crease.push_back(rms(crease.patch, distance) / loop.box.diagonal().norm());
  }
  return errors;
}

// Returns the number of the patch's own points for which isOn() is true.
std::size_t countOn(const Patch& patch, const std::function<bool(const Vec3&)>& isOn) {
  return std::count_if(patch.points.begin() + static_cast<std::ptrdiff_t>(patch.loopSize), patch.points.end(), isOn);
}

}  // namespace

class CreaseFillTest : public QObject {
  Q_OBJECT

 private slots:
  void halvesTheErrorOnCubes();
  void halvesTheErrorOnRims();
  void flatSidesStayFlat();
  void valleysToo();
  void cornersComeBack();
  void withoutCreasesAsFair();
  void keepsTheWholePartSound();
  void anySizeAndPosition();
  void cancels();
};

void CreaseFillTest::halvesTheErrorOnCubes() {
  const TriangleSoup cube = test::roughCube(24, 7);
  std::mt19937 random(1);
  std::vector<Vec3> centres;
  for (int i = 0; i < 25; ++i) {
    const auto unit = [&] { return random() / 4294967296.0; };
    // Along one of the edges parallel to z, off it by less than half the radius.
    centres.emplace_back((i % 2 ? 1.0 : -1.0) + 0.2 * (unit() - 0.5), 1.0 + 0.2 * (unit() - 0.5), unit() - 0.5);
  }
  for (double radius : {0.2, 0.35}) {
    const CreaseFillErrors errors = cutAndFill(cube, centres, radius, test::distanceToCube);
    QCOMPARE(errors.crease.size(), centres.size());
    QVERIFY2(errors.p90(errors.crease) <= 0.5 * errors.p90(errors.fair),
             qPrintable(QString("%1 %2").arg(errors.p90(errors.crease)).arg(errors.p90(errors.fair))));
  }
}

void CreaseFillTest::halvesTheErrorOnRims() {
  const TriangleSoup part = test::roughCylinder(120, 7);
  std::mt19937 random(2);
  std::vector<Vec3> centres;
  for (int i = 0; i < 25; ++i) {
    const auto unit = [&] { return random() / 4294967296.0; };
    const double u = 2.0 * M_PI * unit(), r = 1.0 + 0.1 * (unit() - 0.5);
    centres.emplace_back(r * std::cos(u), r * std::sin(u), 1.0 + 0.1 * (unit() - 0.5));
  }
  for (double radius : {0.2, 0.4}) {
    const CreaseFillErrors errors = cutAndFill(part, centres, radius, test::distanceToCylinder);
    QCOMPARE(errors.crease.size(), centres.size());
    QVERIFY2(errors.p90(errors.crease) <= 0.5 * errors.p90(errors.fair),
             qPrintable(QString("%1 %2").arg(errors.p90(errors.crease)).arg(errors.p90(errors.fair))));
  }
}

// A clean cut across a cube's edge leaves two flat sides and a straight crease, exactly.
void CreaseFillTest::flatSidesStayFlat() {
  const TriangleSoup cube = test::roughCube(24, 0);
  const HalfEdgeMesh mesh = buildMesh(test::withHole(cube, Vec3(1.02, 1.01, 0.1), 0.3)).mesh;
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  const FillAttempt attempt = HoleFiller(mesh).propose(loop, creaseFillOnly(FillMethod::Crease));
  QVERIFY(attempt.failure == FillFailure::None);
  QVERIFY(attempt.patch.method == FillMethod::Crease);
  QCOMPARE(attempt.patch.bridges.size(), std::size_t{1});
  QVERIFY(rms(attempt.patch, test::distanceToCube) < 1e-9);
  QVERIFY(countOn(attempt.patch,
                  [](const Vec3& p) { return std::abs(p.x() - 1.0) < 1e-9 && std::abs(p.y() - 1.0) < 1e-9; }) >= 4);
}

// The inside of a corner: a cube turned inside out.
void CreaseFillTest::valleysToo() {
  const TriangleSoup room = test::turnedOver(test::roughCube(24, 0));
  const HalfEdgeMesh mesh = buildMesh(test::withHole(room, Vec3(0.98, 1.01, 0.1), 0.3)).mesh;
  const FillAttempt attempt =
      HoleFiller(mesh).propose(findBoundaryLoops(mesh).at(0), creaseFillOnly(FillMethod::Crease));
  QVERIFY(attempt.failure == FillFailure::None);
  QVERIFY(attempt.patch.method == FillMethod::Crease);
  QVERIFY(rms(attempt.patch, test::distanceToCube) < 1e-9);
}

void CreaseFillTest::cornersComeBack() {
  const TriangleSoup cube = test::roughCube(24, 7);
  for (double radius : {0.1, 0.3, 0.5}) {
    const HalfEdgeMesh mesh = buildMesh(test::withHole(cube, Vec3(1.01, 1.02, 0.99), radius)).mesh;
    const FillAttempt attempt =
        HoleFiller(mesh).propose(findBoundaryLoops(mesh).at(0), creaseFillOnly(FillMethod::Crease));
    QVERIFY(attempt.failure == FillFailure::None);
    QVERIFY(attempt.patch.method == FillMethod::Crease);
    QVERIFY(rms(attempt.patch, test::distanceToCube) < 1e-9);
    QCOMPARE(countOn(attempt.patch, [](const Vec3& p) { return (p - Vec3::Ones()).norm() < 1e-9; }), std::size_t{1});
  }
}

void CreaseFillTest::withoutCreasesAsFair() {
  for (const TriangleSoup& part : {test::sphereWithoutCap(4), test::withHole(test::torus(60, 30), Vec3(2.7, 0, 0), 0.4),
                                   test::withHole(test::roughCube(24, 7), Vec3(1, 0, 0), 0.3)}) {
    const HalfEdgeMesh mesh = buildMesh(part).mesh;
    const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
    const HoleFiller filler(mesh);
    const FillAttempt fair = filler.propose(loop, creaseFillOnly(FillMethod::Fair));
    const FillAttempt crease = filler.propose(loop, creaseFillOnly(FillMethod::Crease));
    QVERIFY(fair.failure == FillFailure::None);
    QVERIFY(crease.failure == FillFailure::None);
    QVERIFY(crease.patch.method == FillMethod::Fair);
    QVERIFY(crease.patch.points == fair.patch.points);
    QVERIFY(crease.patch.triangles == fair.patch.triangles);
  }
}

void CreaseFillTest::keepsTheWholePartSound() {
  for (const TriangleSoup& part : {test::withHole(test::roughCube(16, 3), Vec3(1, 1, 0), 0.3),
                                   test::withHole(test::roughCube(16, 3), Vec3(1, 1, 1), 0.4),  // three creases
                                   test::withHole(test::roughCylinder(80, 3), Vec3(0, 1, 1), 0.3),
                                   test::withHole(test::roughSlab(16, 3), Vec3(0, 1, 0.1), 0.3)}) {  // two creases
    const HalfEdgeMesh mesh = buildMesh(part).mesh;
    HoleFiller filler(mesh);
    const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
    FillOptions options;
    options.method = FillMethod::Crease;
    const FillAttempt attempt = filler.propose(loop, options);
    QVERIFY(attempt.failure == FillFailure::None);
    filler.accept(loop, attempt.patch);
    QCOMPARE(validate(filler.mesh()), std::string());
    QVERIFY(test::countEdges(filler.mesh()).sound());
    QCOMPARE(test::meetingPairs(filler.mesh()), std::size_t{0});
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v)
      QVERIFY(test::sameBits(mesh.position(v), filler.mesh().position(v)));
  }
}

void CreaseFillTest::anySizeAndPosition() {
  const TriangleSoup cut = test::withHole(test::roughCube(24, 0), Vec3(1.02, 1.01, 0.1), 0.3);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()));
  for (const auto& [scale, shift] : {std::pair{1e-6, 0.0}, {1e6, 0.0}, {1.0, 1e4}}) {
    TriangleSoup part = cut;
    for (Vec3& p : part.points) p = scale * (turn * p) + Vec3::Constant(shift);
    const HalfEdgeMesh mesh = buildMesh(part).mesh;
    const FillAttempt attempt =
        HoleFiller(mesh).propose(findBoundaryLoops(mesh).at(0), creaseFillOnly(FillMethod::Crease));
    QVERIFY(attempt.failure == FillFailure::None);
    QVERIFY(attempt.patch.method == FillMethod::Crease);
    const auto distance = [&, s = scale, o = shift](const Vec3& p) {
      return test::distanceToCube(turn.inverse() * ((p - Vec3::Constant(o)) / s));
    };
    QVERIFY(rms(attempt.patch, distance) < 1e-6);
  }
}

void CreaseFillTest::cancels() {
  const HalfEdgeMesh mesh = buildMesh(test::withHole(test::roughCube(16, 3), Vec3(1, 1, 0), 0.3)).mesh;
  const HoleContext hole = holeContext(mesh, findBoundaryLoops(mesh).at(0));
  const Obstacles obstacles(mesh);
  QVERIFY(fillAlongCreases(hole, obstacles, tolerance::kPatchDensity));
  JobState job;
  job.cancelled = true;
  QVERIFY(!fillAlongCreases(hole, obstacles, tolerance::kPatchDensity, Continuity::Tangent, Progress(job)));
}

HANDWHEEL_TEST(CreaseFillTest)
#include "CreaseFillTest.moc"
