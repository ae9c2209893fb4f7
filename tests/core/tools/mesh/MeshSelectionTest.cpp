// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/MeshSelection.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "tools/mesh/SelectSettings.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

class MeshSelectionTest : public QObject {
  Q_OBJECT

 private slots:
  void addAndRemove();
  void keysOutliveEditsElsewhere();
  void dropsWhatIsGone();
  void outlinesOfFaces();
  void stepsBackAndForward();
  void stepsAreBounded();
  void settingsMatterByMode();
  void settingsRefuseWhatTheyAreNot();
  void brushInPixels();
};

void MeshSelectionTest::addAndRemove() {
  MeshSelection a{{1, 2}, {10}}, b{{2, 3}, {10, 20}};
  a.add(b);
  QVERIFY((a == MeshSelection{{1, 2, 3}, {10, 20}}));
  a.remove({{1, 9}, {10, 30}});
  QVERIFY((a == MeshSelection{{2, 3}, {20}}));
  QVERIFY(!a.empty() && !MeshSelection({}, {20}).empty() && !MeshSelection({5}, {}).empty());
  a.remove(a);
  QVERIFY(a.empty());
}

void MeshSelectionTest::keysOutliveEditsElsewhere() {
  HalfEdgeMesh mesh = buildMesh(test::sphereWithHoles(3, 3, 0.3)).mesh;
  const auto before = findBoundaryLoops(mesh);
  QCOMPARE(before.size(), std::size_t(3));
  const Vertex key = keyOf(mesh, before[1]);
  QCOMPARE(loopWithKey(mesh, before, key), &before[1]);
  QCOMPARE(loopWithKey(mesh, before, kNone), nullptr);
  const std::vector<Vec3> outline = outlineOf(mesh, before[1]);
  QCOMPARE(outline.size(), before[1].halfEdges.size() + 1);
  QCOMPARE(outline.front(), outline.back());
  Face far = 0;  // on no loop's edge
  const auto touchesALoop = [&](Face f) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
      for (const BoundaryLoop& loop : before)
        for (const HalfEdge g : loop.halfEdges)
          if (mesh.from(g) == mesh.from(h)) return true;
    return false;
  };
  while (touchesALoop(far)) ++far;
  mesh.removeFace(far);
  const auto after = findBoundaryLoops(mesh);
  QCOMPARE(after.size(), std::size_t(4));
  QVERIFY(loopWithKey(mesh, after, key)->centre.isApprox(before[1].centre));
}

void MeshSelectionTest::dropsWhatIsGone() {
  HalfEdgeMesh mesh = buildMesh(test::sphereWithoutCap(2)).mesh;
  const auto loops = findBoundaryLoops(mesh);
  MeshSelection selection{{0, 1, 5000}, {keyOf(mesh, loops[0]), 12345}};
  mesh.removeFace(1);
  selection.dropDead(mesh, loops);
  QVERIFY((selection == MeshSelection{{0}, {keyOf(mesh, loops[0])}}));
  selection.dropDead(HalfEdgeMesh(), {});
  QVERIFY(selection.empty());
}

void MeshSelectionTest::outlinesOfFaces() {
  const HalfEdgeMesh ring = buildMesh(test::annulus(16, 2, 1.0, 2.0)).mesh;
  const auto lines = outlinesOf(ring, FaceSelection::all(ring));
  QCOMPARE(lines.size(), std::size_t(2));
  for (const std::vector<Vec3>& line : lines) {
    QCOMPARE(line.size(), std::size_t(17));
    QCOMPARE(line.front(), line.back());
    for (const Vec3& p : line) QVERIFY(std::abs(p.norm() - line[0].norm()) < 1e-12);
  }
  const auto one = outlinesOf(ring, {5});
  QCOMPARE(one.size(), std::size_t(1));
  QCOMPARE(one[0].size(), std::size_t(4));
  const HalfEdgeMesh closed = buildMesh(test::icosphere(1)).mesh;
  QVERIFY(outlinesOf(closed, FaceSelection::all(closed)).empty() && outlinesOf(closed, {}).empty());
}

void MeshSelectionTest::stepsBackAndForward() {
  SelectionHistory steps({{1}, {}});
  QVERIFY(!steps.canGoBack() && !steps.canGoForward());
  steps.goBack();
  steps.goForward();
  steps.change({{1}, {}});
  QVERIFY(!steps.canGoBack());  // the same is no step
  steps.change({{2}, {}});
  steps.change({{3}, {}});
  steps.goBack();
  steps.goBack();
  QVERIFY((steps.present() == MeshSelection{{1}, {}}));
  steps.goForward();
  QVERIFY((steps.present() == MeshSelection{{2}, {}}));
  QVERIFY(steps.canGoBack() && steps.canGoForward());
  steps.change({{4}, {}});  // later steps are discarded
  QVERIFY(!steps.canGoForward());
  steps.goBack();
  QVERIFY((steps.present() == MeshSelection{{2}, {}}));
}

void MeshSelectionTest::stepsAreBounded() {
  SelectionHistory steps({});
  for (Face f = 1; f <= 1000; ++f) steps.change({{f}, {}});
  int back = 0;
  for (; steps.canGoBack(); ++back) steps.goBack();
  QVERIFY(back > 10 && back < 200);
  QCOMPARE(steps.present().faces.faces(), std::vector<Face>{Face(1000 - back)});
}

void MeshSelectionTest::settingsMatterByMode() {
  using Ids = std::vector<std::string>;
  SelectSettings settings;
  const auto ids = [&](double mode) {
    Ids result;
    if (!settings.set("mode", mode) || std::get<double>(settings.properties()[0].value) != mode) return result;
    for (const Property& property : settings.properties()) result.push_back(property.id);
    return result;
  };
  QCOMPARE(ids(0), (Ids{"mode"}));
  QCOMPARE(ids(1), (Ids{"mode", "brush_unit", "brush_pixels"}));
  QVERIFY(settings.set("brush_unit", 0.0));
  QCOMPARE(ids(1), (Ids{"mode", "brush_unit", "brush_length"}));
  QCOMPARE(ids(2), (Ids{"mode", "through"}));
  QCOMPARE(ids(3), (Ids{"mode"}));
  QCOMPARE(ids(4), (Ids{"mode", "angle"}));
  QVERIFY(settings.set("through", true) && settings.through);
  QVERIFY(settings.set("angle", 0.5) && settings.angle == 0.5);
}

void MeshSelectionTest::settingsRefuseWhatTheyAreNot() {
  SelectSettings settings;
  const double inf = std::numeric_limits<double>::infinity();
  for (const PropertyValue& value : {PropertyValue(std::nan("")), PropertyValue(true), PropertyValue("1")})
    for (const char* id : {"mode", "brush_unit", "brush_length", "brush_pixels", "angle"})
      QVERIFY(!settings.set(id, value));
  for (const double value : {-1.0, 5.0, inf, -inf}) QVERIFY(!settings.set("mode", value));
  QVERIFY(!settings.set("through", 1.0));
  QVERIFY(!settings.set("unknown", 1.0));
  QVERIFY(settings.set("angle", 100.0) && settings.angle == M_PI);
  QVERIFY(settings.set("angle", -inf) && settings.angle == 0.0);
  QVERIFY(settings.set("brush_length", 0.0) && settings.brushLength > 0.0);
  for (int i = 0; i < 1000; ++i) settings.scaleBrush(2.0);
  QVERIFY(std::isfinite(settings.brushPixels));
}

void MeshSelectionTest::brushInPixels() {
  SelectSettings settings;
  settings.brushUnit = SelectSettings::Unit::Pixels;
  settings.brushPixels = 10.0;
  PickRay pickRay{{Vec3::Zero(), Vec3::UnitZ()}, std::nullopt, 0.5, 100.0};
  QCOMPARE(settings.brushRadius(pickRay, Vec3(0, 0, 300)), 5.0);
  pickRay.eye = Vec3::Zero();
  QCOMPARE(settings.brushRadius(pickRay, Vec3(0, 0, 300)), 15.0);
  settings.brushUnit = SelectSettings::Unit::Millimetres;
  settings.brushLength = 2.0;
  QCOMPARE(settings.brushRadius(pickRay, Vec3(0, 0, 300)), 2.0);
  settings.scaleBrush(1.5);
  QCOMPARE(settings.brushLength, 3.0);
  QCOMPARE(settings.brushPixels, 10.0);
}

HANDWHEEL_TEST(MeshSelectionTest)
#include "MeshSelectionTest.moc"
