// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/LoopSubdivision.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "SubdivisionShapes.h"
#include "TestClass.h"
#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;
using test::built;
using test::fan;

// Tests subdivided surfaces as a whole: round, even, in every size; and refusals.
class LoopSubdivisionQualityTest : public QObject {
  Q_OBJECT

 private slots:
  void closedSurfacesBecomeRound();
  void outlineAspectDoubles();
  void refusals();
  void inEverySizeAndPosition_data();
  void inEverySizeAndPosition();
};

// All faces of a closed surface are split in four; a subdivided cube is all but a sphere in the angles between faces.
void LoopSubdivisionQualityTest::closedSurfacesBecomeRound() {
  HalfEdgeMesh mesh = built(test::cube());
  FaceSelection patch = FaceSelection::all(mesh);
  for (int level = 1; level <= 4; ++level) {
    patch = subdivide(mesh, patch).faces;
    QCOMPARE(patch.count(), std::size_t(12) << (2 * level));
  }
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
  double sharpest = 1.0;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    const auto normal = [&](Face f) {
      const auto [p, q, r] = mesh.points(f);
      return Vec3((q - p).cross(r - p).normalized());
    };
    const Vec3 own = normal(HalfEdgeMesh::face(h));
    sharpest = std::min(sharpest, own.dot(normal(HalfEdgeMesh::face(mesh.opposite(h)))));
  }
  QVERIFY(sharpest > std::cos(0.35));
}

void LoopSubdivisionQualityTest::outlineAspectDoubles() {
  HalfEdgeMesh mesh = built(fan(6));
  FaceSelection patch = FaceSelection::all(mesh);
  double aspect = outlineAspect(mesh, patch);
  QVERIFY(std::abs(aspect - 2.0 / std::sqrt(3.0)) < 1e-12);  // aspect of an equilateral triangle
  for (int level = 0; level < 4; ++level) {
    patch = subdivide(mesh, patch).faces;
    const double next = outlineAspect(mesh, patch);
    QVERIFY(next > 1.6 * aspect && next < 3.2 * aspect);
    aspect = next;
  }
  const HalfEdgeMesh closed = built(test::tetrahedron());
  QCOMPARE(outlineAspect(closed, FaceSelection::all(closed)), 0.0);
}

void LoopSubdivisionQualityTest::refusals() {
  const HalfEdgeMesh sphere = built(test::icosphere(2));
  const FaceSelection all = FaceSelection::all(sphere);
  const auto refuses = [&](const HalfEdgeMesh& before, const FaceSelection& patch, const SubdivisionLimits& limits) {
    HalfEdgeMesh mesh = before;
    const SubdivisionFailure failure = subdivide(mesh, patch, limits).failure;
    return failure != SubdivisionFailure::None && !test::sameMesh(mesh, before) ? SubdivisionFailure::None : failure;
  };
  QVERIFY(refuses(sphere, {}, {}) == SubdivisionFailure::NoEdgeInside);
  QVERIFY(refuses(sphere, {7}, {}) == SubdivisionFailure::NoEdgeInside);
  QVERIFY(refuses(HalfEdgeMesh(), {3}, {}) == SubdivisionFailure::NoEdgeInside);
  QVERIFY(refuses(sphere, all, {.mostFaces = 1279}) == SubdivisionFailure::TooManyFaces);
  QVERIFY(refuses(sphere, all, {.mostFaces = 1280}) == SubdivisionFailure::None);
  JobState state;
  state.cancelled = true;
  QVERIFY(refuses(sphere, all, {.progress = Progress(state)}) == SubdivisionFailure::Cancelled);
  // 1e7 from the origin single precision knows whole millimetres only.
  const HalfEdgeMesh far = built(test::moved(test::icosphere(2), Vec3(1e7, 1e7, 1e7), 2.0));
  QVERIFY(refuses(far, all, {.numbers = NumberType::Float32}) == SubdivisionFailure::TooFine);
}

void LoopSubdivisionQualityTest::inEverySizeAndPosition_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("shift");
  QTest::newRow("1e-6") << 1e-6 << 0.0;
  QTest::newRow("1e6") << 1e6 << 0.0;
  QTest::newRow("far away") << 1.0 << 1e7;
}

void LoopSubdivisionQualityTest::inEverySizeAndPosition() {
  QFETCH(double, scale);
  QFETCH(double, shift);
  const Vec3 far(shift, -shift, shift);
  HalfEdgeMesh plain = built(test::bumpySphere(2)), mapped = built(test::moved(test::bumpySphere(2), far, scale));
  subdivide(plain, FaceSelection::all(plain));
  QVERIFY(subdivide(mapped, FaceSelection::all(mapped)).failure == SubdivisionFailure::None);
  QCOMPARE(validate(mapped), std::string());
  for (Vertex v = 0; v < plain.vertexSlots(); ++v)
    QVERIFY((scale * plain.position(v) + far - mapped.position(v)).norm() <= 1e-14 * scale + 4e-16 * 4 * shift);
}

HANDWHEEL_TEST(LoopSubdivisionQualityTest)
#include "LoopSubdivisionQualityTest.moc"
