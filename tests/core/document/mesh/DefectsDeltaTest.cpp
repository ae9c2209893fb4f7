// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/DefectsDelta.h"

#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "document/UndoCommand.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>
#include <QTest>

using namespace handwheel;

namespace {

bool same(const Defects& a, const Defects& b) {
  const auto sameLoop = [](const BoundaryLoop& x, const BoundaryLoop& y) {
    return x.id == y.id && x.halfEdges == y.halfEdges && x.borderEdges == y.borderEdges && x.length == y.length &&
           x.planarity == y.planarity && x.isSheetBoundary == y.isSheetBoundary && x.centre == y.centre &&
           x.box.min() == y.box.min() && x.box.max() == y.box.max();
  };
  const auto samePart = [](const Component& x, const Component& y) {
    return x.faceCount == y.faceCount && x.area == y.area && x.volume == y.volume && x.debris == y.debris &&
           x.faces == y.faces;
  };
  return std::equal(a.loops.begin(), a.loops.end(), b.loops.begin(), b.loops.end(), sameLoop) &&
         std::equal(a.components.begin(), a.components.end(), b.components.begin(), b.components.end(), samePart) &&
         a.nonManifoldEdges == b.nonManifoldEdges && a.nonManifoldVertices == b.nonManifoldVertices &&
         a.degenerateFaces == b.degenerateFaces && a.duplicateFaces == b.duplicateFaces &&
         a.nearVertices == b.nearVertices && a.box.min() == b.box.min() && a.box.max() == b.box.max();
}

// A sheet of n × n squares with a hole in every third of both directions.
TriangleSoup sieve(std::uint32_t n) {
  TriangleSoup soup = test::grid(n + 1, n + 1, false, false,
                                 [](std::uint32_t i, std::uint32_t j) { return Vec3(j, i, 0.1 * ((i * j) % 5)); });
  std::vector<Triangle> kept;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const std::size_t square = f / 2;
    if (square / n % 3 != 1 || square % n % 3 != 1) kept.push_back(soup.triangles[f]);
  }
  soup.triangles = kept;
  return soup;
}

HalfEdgeMesh anyChange(HalfEdgeMesh mesh) {
  const auto changes = *rc::gen::inRange(0, 5);
  const auto vertex = [&] { return *rc::gen::inRange<Vertex>(0, static_cast<Vertex>(mesh.vertexSlots())); };
  for (int i = 0; i < changes; ++i) {
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        if (const auto f = *rc::gen::inRange<Face>(0, static_cast<Face>(mesh.faceSlots())); mesh.isLive(f)) {
          mesh.removeFace(f);
        }
        break;
      case 1:
        mesh.setPosition(vertex(), mesh.position(vertex()));
        break;
      default:
        mesh.addFace({vertex(), vertex(), vertex()});
    }
  }
  relink(mesh);
  return mesh;
}

}  // namespace

class DefectsDeltaTest : public QObject {
  Q_OBJECT

 private slots:
  void swapIsItsOwnInverse() {
    QVERIFY(rc::check([] {
      const HalfEdgeMesh mesh = buildMesh(sieve(9)).mesh;
      const Defects before = findDefects(mesh), after = findDefects(anyChange(mesh));
      DefectsDelta delta = DefectsDelta::between(before, after);
      Defects defects = before;
      for (const Defects* expected : {&after, &before, &after}) {
        delta.swap(defects);
        RC_ASSERT(same(defects, *expected));
      }
    }));
  }

  // The size of a history step depends on the edit, not on the number of defects elsewhere in the mesh.
  void aStepHoldsTheChangeOnly() {
    const auto bytesOfAStep = [](std::uint32_t n) {
      const auto document = test::meshDocument(sieve(n));
      HalfEdgeMesh mesh = document->mesh();
      mesh.removeFace(0);
      relink(mesh);
      document->commit("Remove", inspected(mesh));
      return static_cast<const UndoCommand*>(document->history()->command(0))->edit().bytes();
    };
    const std::size_t few = bytesOfAStep(9), many = bytesOfAStep(90);
    // The outer edge, whose length changes, is a loop of four sides.
    QVERIFY2(many < few + 4 * 90 * sizeof(HalfEdge) * 2, qPrintable(QString("%1 and %2").arg(few).arg(many)));
  }
};

HANDWHEEL_TEST(DefectsDeltaTest)
#include "DefectsDeltaTest.moc"
