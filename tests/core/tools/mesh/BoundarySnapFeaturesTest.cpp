// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/BoundarySnapFeatures.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "haptics/snap/SnapProxy.h"
#include "mesh/structure/MeshBuilder.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

struct Tube {
  HalfEdgeMesh mesh = buildMesh(cylinder(12, 3, 10.0, 30.0, false)).mesh;
  std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
};

}  // namespace

class BoundarySnapFeaturesTest : public QObject {
  Q_OBJECT

 private slots:
  // An open tube has two rims of twelve points and edges, each as long as a side of a regular polygon.
  void pointsAndEdgesOfEveryRim() {
    const Tube tube;
    QCOMPARE(tube.loops.size(), std::size_t{2});
    const LoopSnapField scene = boundarySnapFeatures(tube.mesh, tube.loops, {});
    QVERIFY(std::abs(scene.spacing - 2.0 * 10.0 * std::sin(M_PI / 12)) < 1e-12);
    SnapProxy proxy;
    const SnapProfile profile(SnapShape::Triangular, 0.3, 1.0);
    for (const BoundaryLoop& loop : tube.loops)
      for (const HalfEdge h : loop.halfEdges) {
        const Vec3 from = tube.mesh.position(tube.mesh.from(h)), to = tube.mesh.position(tube.mesh.to(h));
        proxy.release();
        SnapResult pull = proxy.step(scene.field, profile, 1.01 * from);
        QVERIFY(pull.features[0] == (SnapFeature{SnapKind::Point, tube.mesh.from(h)}));
        proxy.release();
        pull = proxy.step(scene.field, profile, 0.5 * (from + to) + Vec3(0, 0, 0.1));
        QVERIFY(pull.features[0] == (SnapFeature{SnapKind::Segment, h}));
      }
  }

  // Each rim is one closed curve feature.
  void aRimAsACurve() {
    const Tube tube;
    const LoopSnapField scene =
        boundarySnapFeatures(tube.mesh, tube.loops, {.vertices = false, .edges = false, .curves = true});
    SnapProxy proxy;
    const SnapProfile profile(SnapShape::Triangular, 0.3, 1.0);
    for (std::size_t i = 0; i < tube.loops.size(); ++i)
      for (const HalfEdge h : tube.loops[i].halfEdges) {
        const SnapResult pull = proxy.step(scene.field, profile, 1.01 * tube.mesh.position(tube.mesh.from(h)));
        QVERIFY(pull.features[0] == (SnapFeature{SnapKind::Curve, static_cast<std::uint32_t>(i)}));
      }
  }

  void nothingIsOpen() {
    const HalfEdgeMesh mesh = buildMesh(cube(10.0)).mesh;
    const LoopSnapField scene = boundarySnapFeatures(mesh, findBoundaryLoops(mesh), {});
    QVERIFY(scene.field.empty());
    QCOMPARE(scene.spacing, 0.0);
  }
};

HANDWHEEL_TEST(BoundarySnapFeaturesTest)
#include "BoundarySnapFeaturesTest.moc"
