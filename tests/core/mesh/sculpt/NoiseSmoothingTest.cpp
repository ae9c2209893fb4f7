// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/NoiseSmoothing.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>
#include <random>

using namespace handwheel;

class NoiseSmoothingTest : public QObject {
  Q_OBJECT

 private slots:
  void sphere();
  void cubeKeepsItsEdges();
  void onlyThePart();
  void keepsTheBorder();
  void odd();
  void cancels();
  void sameInEverySizeAndPosition();
  void ringsAroundABorder();
};

namespace {

// Surface of the cube from 0 to 1, each side n × n squares.
TriangleSoup noiseSmoothingCubeOfCells(std::uint32_t n) {
  TriangleSoup soup;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {0.0, 1.0}) {
      TriangleSoup one = test::grid(n + 1, n + 1, false, false, [&](std::uint32_t i, std::uint32_t j) {
        Vec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = double(i) / n;
        p[(axis + 2) % 3] = double(j) / n;
        return p;
      });
      test::append(soup, side == 1.0 ? one : test::turnedOver(one));
    }
  }
  return soup;
}

HalfEdgeMesh noisy(const HalfEdgeMesh& clean, double sigma) {
  std::mt19937 random(7);
  std::normal_distribution<double> error(0.0, sigma);
  HalfEdgeMesh mesh = clean;
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v)
    mesh.setPosition(v, mesh.position(v) + Vec3(error(random), error(random), error(random)));
  return mesh;
}

template <class Distance>
double rms(const HalfEdgeMesh& mesh, Distance distance) {
  double sum = 0.0;
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) sum += std::pow(distance(mesh.position(v)), 2);
  return std::sqrt(sum / static_cast<double>(mesh.vertexSlots()));
}

double toUnitCube(const Vec3& p) {
  const Vec3 off = (p - Vec3::Constant(0.5)).cwiseAbs() - Vec3::Constant(0.5);
  return off.maxCoeff() > 0.0 ? off.cwiseMax(0.0).norm() : off.maxCoeff();
}

double toUnitSphere(const Vec3& p) {
  return p.norm() - 1.0;
}

bool anyTurned(const HalfEdgeMesh& before, const HalfEdgeMesh& after) {
  for (Face f = 0; f < before.faceSlots(); ++f)
    if (!(unitNormal(before.points(f)).dot(unitNormal(after.points(f))) > 0.0)) return true;
  return false;
}

}  // namespace

// An edge is 0.07 long; the noise a seventh of it.
void NoiseSmoothingTest::sphere() {
  const HalfEdgeMesh rough = noisy(buildMesh(test::icosphere(4)).mesh, 0.01);
  HalfEdgeMesh mesh = rough;
  QVERIFY(smoothNoise(mesh, FaceSelection::all(mesh)));
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(!anyTurned(rough, mesh));
  const double before = rms(rough, toUnitSphere), after = rms(mesh, toUnitSphere);
  qInfo("sphere: RMS %.5f before, %.5f after", before, after);
  QVERIFY(after < 0.5 * before);
  QVERIFY(std::abs(test::volume(mesh.compact().soup) / test::volume(test::icosphere(4)) - 1.0) < 0.01);
}

void NoiseSmoothingTest::cubeKeepsItsEdges() {
  const HalfEdgeMesh clean = buildMesh(noiseSmoothingCubeOfCells(20)).mesh, rough = noisy(clean, 0.007);
  HalfEdgeMesh mesh = rough;
  QVERIFY(smoothNoise(mesh, FaceSelection::all(mesh)));
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(!anyTurned(rough, mesh));
  const double before = rms(rough, toUnitCube), after = rms(mesh, toUnitCube);
  // Distance of the vertices on edges and corners from their positions before the noise: rounded edges would be 0.02
  // inside.
  double inside = 0.0;
  std::size_t n = 0;
  for (Vertex v = 0; v < clean.vertexSlots(); ++v) {
    const Vec3 off = (clean.position(v) - Vec3::Constant(0.5)).cwiseAbs();
    if ((off.array() == 0.5).count() < 2) continue;
    inside += toUnitCube(mesh.position(v));
    ++n;
  }
  inside /= static_cast<double>(n);
  qInfo("cube: RMS %.5f before, %.5f after; edges %.5f", before, after, inside);
  QVERIFY(after < 0.35 * before);
  QVERIFY(std::abs(inside) < 0.004);
}

void NoiseSmoothingTest::onlyThePart() {
  const HalfEdgeMesh rough = noisy(buildMesh(test::icosphere(3)).mesh, 0.01);
  const FaceSelection part = FaceSelection::where(rough.faceSlots(), [](Face f) { return f % 1280 < 400; });
  HalfEdgeMesh mesh = rough;
  const auto moved = smoothNoise(mesh, part);
  QVERIFY(moved && !moved->faces.empty());
  for (const Face f : moved->faces) QVERIFY(part.contains(f));
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (part.contains(f)) continue;
    for (const Vertex v : mesh.triangle(f)) QVERIFY(test::sameBits(mesh.position(v), rough.position(v)));
  }
}

void NoiseSmoothingTest::keepsTheBorder() {
  const HalfEdgeMesh rough = noisy(buildMesh(test::sphereWithoutCap(3)).mesh, 0.01);
  for (const bool moves : {false, true}) {
    HalfEdgeMesh mesh = rough;
    QVERIFY(smoothNoise(mesh, FaceSelection::all(mesh), {.movesBorder = moves}));
    bool isSame = true;
    for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
      if (mesh.isBorder(h))
        isSame = isSame && test::sameBits(mesh.position(mesh.from(h)), rough.position(mesh.from(h)));
    QCOMPARE(isSame, !moves);
    QCOMPARE(validate(mesh), std::string());
  }
}

void NoiseSmoothingTest::odd() {
  HalfEdgeMesh empty;
  QVERIFY(smoothNoise(empty, {}));
  QVERIFY(smoothNoise(empty, {4}));
  TriangleSoup needles = test::cube();
  test::addNeedles(needles, 0, 0, {0.3, 0.6});
  for (const TriangleSoup& soup : {needles, test::twoCubesSharingAnEdge(), test::boxWithInnerWall(),
                                   test::moebiusStrip(12, 3), test::tetrahedron()}) {
    const HalfEdgeMesh before = buildMesh(soup).mesh;
    HalfEdgeMesh mesh = before;
    QVERIFY(smoothNoise(mesh, FaceSelection::all(mesh)));
    QCOMPARE(validate(mesh), std::string());
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) QVERIFY(mesh.position(v).allFinite());
  }
}

void NoiseSmoothingTest::cancels() {
  const HalfEdgeMesh rough = noisy(buildMesh(test::icosphere(3)).mesh, 0.01);
  HalfEdgeMesh mesh = rough;
  JobState state;
  state.cancelled = true;
  QVERIFY(!smoothNoise(mesh, FaceSelection::all(mesh), {.progress = Progress(state)}));
  QVERIFY(test::sameMesh(mesh, rough));
}

void NoiseSmoothingTest::sameInEverySizeAndPosition() {
  const HalfEdgeMesh rough = noisy(buildMesh(test::icosphere(3)).mesh, 0.01);
  HalfEdgeMesh plain = rough;
  smoothNoise(plain, FaceSelection::all(plain));
  for (const auto& [scale, shift] : {std::pair(1e-6, 0.0), std::pair(1e6, 0.0), std::pair(1.0, 1e7)}) {
    const Vec3 far(shift, shift, shift);
    HalfEdgeMesh mesh = rough;
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) mesh.setPosition(v, scale * mesh.position(v) + far);
    smoothNoise(mesh, FaceSelection::all(mesh));
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v)
      QVERIFY((mesh.position(v) - scale * plain.position(v) - far).norm() < 1e-6 * scale);
  }
}

void NoiseSmoothingTest::ringsAroundABorder() {
  const HalfEdgeMesh mesh = buildMesh(test::annulus(16, 8, 1.0, 2.0)).mesh;
  QCOMPARE(facesAtBorder(mesh, 0).count(), std::size_t(2 * 32));
  QCOMPARE(facesAtBorder(mesh, 1).count(), std::size_t(4 * 32));
  const HalfEdgeMesh closed = buildMesh(test::cube()).mesh;
  QVERIFY(facesAtBorder(closed, 3).empty() && facesAtBorder(HalfEdgeMesh(), 2).empty());
}

HANDWHEEL_TEST(NoiseSmoothingTest)
#include "NoiseSmoothingTest.moc"
