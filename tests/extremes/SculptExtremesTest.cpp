// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Extremes.h"

#include "MeshChecks.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/sculpt/NoiseSmoothing.h"
#include "mesh/sculpt/PatchLevels.h"
#include "mesh/sculpt/SculptBrush.h"
#include "mesh/search/LocalIntersections.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

// Subdividing, brushes and smoothing on every mesh at the edge of what can be.
class SculptExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void subdivides_data() { everyMesh(); }
  void subdivides();
  void levelsFollow_data() { everyMesh(10'000); }
  void levelsFollow();
  void brushes_data() { everyMesh(); }
  void brushes();
  void crossingsOfAStroke_data() { everyMesh(10'000); }
  void crossingsOfAStroke();
  void smoothsNoise_data() { everyMesh(); }
  void smoothsNoise();

 private:
  static void everyMesh(std::size_t mostTriangles = ~std::size_t{0}) {
    QTest::addColumn<TriangleSoup>("soup");
    for (const test::ExtremeMesh& mesh : test::allMeshes()) {
      const TriangleSoup soup = mesh.soup();
      if (soup.triangles.size() <= mostTriangles) QTest::newRow(mesh.name.c_str()) << soup;
    }
  }
};

namespace {

// Returns the problem of a mesh that was moved from another with the same faces; empty for none.
QString sculptExtremesProblemOf(const HalfEdgeMesh& before, const HalfEdgeMesh& after) {
  if (const std::string broken = validate(after); !broken.empty()) return QString::fromStdString(broken);
  for (Face f = 0; f < before.faceSlots(); ++f) {
    const Vec3 normal = unitNormal(before.points(f));
    if (!normal.isZero(0.0) && !(normal.dot(unitNormal(after.points(f))) > 0.0)) return QStringLiteral("turned over");
  }
  return {};
}

}  // namespace

void SculptExtremesTest::subdivides() {
  QFETCH(TriangleSoup, soup);
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  FaceSelection patch = FaceSelection::all(mesh);
  const int levels = mesh.faceSlots() < 50'000 ? 2 : 1;
  for (int level = 0; level < levels; ++level) {
    const HalfEdgeMesh before = mesh;
    const SubdivisionStep step = subdivide(mesh, patch);
    QCOMPARE(QString::fromStdString(validate(mesh)), QString());
    QCOMPARE(test::countBorder(mesh), test::countBorder(before));
    QCOMPARE(test::countSeams(mesh), test::countSeams(before));
    if (step.failure != SubdivisionFailure::None) {
      QVERIFY(test::sameMesh(mesh, before));
      break;
    }
    // Repeats the reading of levels from a file.
    const auto again = subdivisionBetween(before, patch, mesh, step.firstAdded);
    QVERIFY(again && again->faces == step.faces);
    patch = step.faces;
  }
}

// A coarse level that is moved as a whole takes the finer one along; without that, it is what it was made.
void SculptExtremesTest::levelsFollow() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  Box box;
  for (const Vec3& p : soup.points) box.extend(p);
  const double size = soup.points.empty() ? 1.0 : box.sizes().maxCoeff();
  const double reach = soup.points.empty() ? 1.0 : box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  PatchLevels levels(mesh, FaceSelection::all(mesh));
  if (levels.refine() != SubdivisionFailure::None) {
    QVERIFY(test::sameMesh(levels.mesh(), mesh));
    return;
  }
  QVERIFY(test::sameMesh(levels.mesh(0), mesh));
  const HalfEdgeMesh fine = levels.mesh();
  HalfEdgeMesh moved = mesh;
  const Vec3 shift = size * Vec3(0.5, -0.25, 0.125);
  for (Vertex v = 0; v < moved.vertexSlots(); ++v) moved.setPosition(v, moved.position(v) + shift);
  levels.replace(0, moved);
  QCOMPARE(QString::fromStdString(validate(levels.mesh())), QString());
  const double error = 1e-9 * size + 1e-14 * reach;
  for (Vertex v = 0; v < fine.vertexSlots(); ++v)
    QVERIFY((levels.mesh().position(v) - fine.position(v) - shift).stableNorm() <= error);
  levels.coarsen();
  QVERIFY(test::sameMesh(levels.mesh(), moved));
}

void SculptExtremesTest::brushes() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh whole = buildMesh(soup).mesh;
  Box box;
  for (const Vec3& p : soup.points) box.extend(p);
  const double radius = soup.points.empty() ? 1.0 : 0.2 * box.sizes().stableNorm();
  for (Face seed = 0; seed < whole.faceSlots(); seed += 1 + static_cast<Face>(whole.faceSlots() / 5)) {
    for (int brush = 0; brush < 4; ++brush) {
      HalfEdgeMesh mesh = whole;
      const BrushArea area = brushArea(mesh, seed, mesh.points(seed)[0], radius, {.movesBorder = true});
      const std::vector<VertexGoal> moves = brush == 0   ? dragged(mesh, area, Vec3::Constant(radius))
                                            : brush == 1 ? inflated(mesh, area, radius)
                                            : brush == 2 ? flattened(mesh, area, 1.0)
                                                         : smoothed(mesh, area, 1.0);
      moveTowards(mesh, moves);
      QCOMPARE(sculptExtremesProblemOf(whole, mesh), QString());
    }
  }
}

// Found near the stroke, as many as in the whole mesh.
void SculptExtremesTest::crossingsOfAStroke() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  if (before.faceSlots() == 0) return;
  HalfEdgeMesh after = before;
  const double size = findDefects(before).box.diagonal().stableNorm();
  const BrushArea area = brushArea(after, 0, after.points(0)[0], 0.3 * size, {.movesBorder = true});
  moveTowards(after, dragged(after, area, Vec3::Constant(-0.5 * size)));
  const auto change = intersectionsChange(before, after);
  QVERIFY(change && intersectionsAfter(*change, *findSelfIntersections(before)) == *findSelfIntersections(after));
}

void SculptExtremesTest::smoothsNoise() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = before;
  QVERIFY(smoothNoise(mesh, FaceSelection::all(mesh), {.movesBorder = true}));
  QCOMPARE(sculptExtremesProblemOf(before, mesh), QString());
}

HANDWHEEL_TEST(SculptExtremesTest)
#include "SculptExtremesTest.moc"
