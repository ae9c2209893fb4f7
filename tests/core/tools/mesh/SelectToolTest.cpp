// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SelectFixture.h"
#include "TestClass.h"
#include "proximity/ClosestPoint.h"
#include "tools/mesh/MeshPreview.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

class SelectToolTest : public QObject {
  Q_OBJECT

 private slots:
  void clicks();
  void clickOnNothingClears();
  void turningTheCameraDoesNotClear();
  void clicksAtAHole();
  void doubleClickTakesThePart();
  void brushCoversADisc();
  void brushAddsAndRemoves();
  void brushStrokeIsOneStep();
  void brushInPixels();
  void lassoSeesOrGoesThrough();
  void connectedAndAngle();
  void hoverShowsWhatAClickWouldSelect();
  void secondButton();
};

void SelectToolTest::clicks() {
  SelectFixture b(plates());
  const Face first = upper(3, 4) + 1, second = upper(7, 2);  // above the diagonal, below it
  b.click(3.2, 4.8);
  QCOMPARE(b.faces(), std::vector<Face>{first});
  b.click(7.8, 2.2);
  QCOMPARE(b.faces(), std::vector<Face>{second});
  b.click(3.2, 4.8, kShift);
  QCOMPARE(b.faces(), (std::vector<Face>{first, second}));
  b.click(7.8, 2.2, kControl);
  QCOMPARE(b.faces(), std::vector<Face>{first});
  b.click(7.8, 2.2, kControl);
  b.click(20, 20, kControl);
  b.click(20, 20, kShift);
  QCOMPARE(b.faces(), std::vector<Face>{first});
  QVERIFY(meshPreviewOf(b.tool.preview()).selected == (FaceSelection{first}));
}

void SelectToolTest::clickOnNothingClears() {
  SelectFixture b(plates());
  b.click(3.2, 4.8);
  QCOMPARE(b.tool.pointer(above(Kind::Press, 20, 20)), ToolReply::Ignored);  // the camera may turn
  QCOMPARE(b.tool.pointer(above(Kind::Release, 20, 20)), ToolReply::Used);
  QCOMPARE(b.count(), std::size_t(0));
}

void SelectToolTest::turningTheCameraDoesNotClear() {
  SelectFixture b(plates());
  b.click(3.2, 4.8);
  b.tool.pointer(above(Kind::Press, 20, 20));
  QCOMPARE(b.tool.pointer(above(Kind::Drag, 22, 20)), ToolReply::Ignored);
  QCOMPARE(b.tool.pointer(above(Kind::Release, 22, 20)), ToolReply::Ignored);
  QCOMPARE(b.count(), std::size_t(1));
}

void SelectToolTest::clicksAtAHole() {
  SelectFixture b(sphereWithoutCap(3));
  const Vertex key = keyOf(b.document->mesh(), b.document->defects().loops.at(0));
  b.click(0, 0);
  QVERIFY(b.tool.selection() == (MeshSelection{{}, {key}}));
  QCOMPARE(b.tool.preview().lines.size(), std::size_t(1));
  b.click(0.7, 0, kShift);
  QCOMPARE(b.count(), std::size_t(1));
  b.click(0.01, 0.01, kControl);
  QVERIFY(b.tool.selection().loops.empty() && b.count() == 1);
  b.tool.pointer(above(Kind::Hover, 0, 0));
  QCOMPARE(b.tool.preview().lines.size(), std::size_t(1));
  b.tool.pointer(above(Kind::Leave, 0, 0));
  QVERIFY(b.tool.preview().lines.empty());
}

void SelectToolTest::doubleClickTakesThePart() {
  SelectFixture b(plates());
  b.click(3.2, 4.8);
  b.tool.pointer(above(Kind::DoubleClick, 3.2, 4.8));
  b.tool.pointer(above(Kind::Release, 3.2, 4.8));
  QCOMPARE(b.count(), std::size_t(200));
  QCOMPARE(b.faces().front(), Face(200));
}

void SelectToolTest::brushCoversADisc() {
  SelectFixture b(plates(), kBrush);
  b.tool.setSetting("brush_unit", 0.0);
  b.tool.setSetting("brush_length", 2.3);
  QCOMPARE(b.tool.pointer(above(Kind::Press, 20, 20)), ToolReply::Ignored);
  b.stroke({{4.6, 5.1}});
  const HalfEdgeMesh& mesh = b.document->mesh();
  for (Face f = 0; f < 400; ++f) {
    const auto [p, q, r] = mesh.points(f);
    const Vec3 centre(4.6, 5.1, 5.0);
    const bool meets = f >= 200 && (closestOnTriangle(centre, p, q, r) - centre).norm() <= 2.3;
    QCOMPARE(b.tool.selection().faces.contains(f), meets);
  }
}

void SelectToolTest::brushAddsAndRemoves() {
  SelectFixture b(plates(), kBrush);
  b.tool.setSetting("brush_unit", 0.0);
  b.tool.setSetting("brush_length", 1e-3);
  b.stroke({{0.5, 0.2}, {9.5, 0.2}});
  const FaceSelection row = b.tool.selection().faces;
  QVERIFY(row.count() >= 10 && row.contains(upper(0, 0)) && row.contains(upper(9, 0)));
  b.stroke({{0.5, 3.2}, {9.5, 3.2}}, kShift);
  QCOMPARE(b.count(), 2 * row.count());
  b.stroke({{0.5, 0.2}, {9.5, 0.2}}, kControl);
  QCOMPARE(b.count(), row.count());
  QVERIFY(!b.tool.selection().faces.contains(upper(5, 0)));
  b.stroke({{0.5, 0.2}, {9.5, 0.2}});
  QVERIFY(b.tool.selection().faces == row);
}

void SelectToolTest::brushStrokeIsOneStep() {
  SelectFixture b(plates(), kBrush);
  b.stroke({{1, 1}});
  const MeshSelection before = b.tool.selection();
  b.tool.pointer(above(Kind::Press, 5, 5));
  b.tool.pointer(above(Kind::Drag, 8, 5));
  QVERIFY(!(b.tool.selection() == before));  // one sees it grow
  QVERIFY(b.tool.preview().circle && b.tool.preview().circle->first.isApprox(Vec3(8, 5, 5)));
  QCOMPARE(b.tool.perform("revert"), ToolReply::Used);
  QVERIFY(b.tool.selection() == before);
  b.stroke({{5, 5}, {8, 5}, {8, 8}});
  QVERIFY(!(b.tool.selection() == before));
  b.tool.perform("previous");
  QVERIFY(b.tool.selection() == before);
}

void SelectToolTest::brushInPixels() {
  SelectFixture b(plates(), kBrush);
  b.tool.setSetting("brush_pixels", 100.0);
  b.tool.pointer(above(Kind::Hover, 5, 5));
  QCOMPARE(b.tool.preview().circle->second, 1.0);
  b.tool.perform("larger");
  b.tool.pointer(above(Kind::Hover, 5, 5));
  QVERIFY(b.tool.preview().circle->second > 1.0);
  b.tool.perform("smaller");
  b.tool.pointer(above(Kind::Hover, 5, 5));
  QCOMPARE(b.tool.preview().circle->second, 1.0);
  PointerEvent near = above(Kind::Hover, 5, 5);
  near.eye = Vec3(5, 5, 55);  // 50 above the plate; a pixel is 0.01 at 100
  near.ray.origin = *near.eye;
  near.focus = 100.0;
  b.tool.pointer(near);
  QCOMPARE(b.tool.preview().circle->second, 0.5);
  QVERIFY(isEnabled(b.tool, "larger"));
  b.tool.setSetting("mode", kClick);
  QVERIFY(!isEnabled(b.tool, "larger"));
}

void SelectToolTest::lassoSeesOrGoesThrough() {
  SelectFixture b(plates(), kLasso);
  const std::vector<Eigen::Vector2d> around = {{1.5, 1.5}, {6.5, 1.5}, {6.5, 4.5}, {1.5, 4.5}};
  b.stroke(around);
  std::vector<Face> expected;
  for (int x = 2; x < 6; ++x)
    for (int y = 2; y < 4; ++y) expected.insert(expected.end(), {upper(x, y), upper(x, y) + 1});
  QCOMPARE(b.faces(), expected);
  b.tool.setSetting("through", true);
  b.stroke(around);
  QCOMPARE(b.count(), 2 * expected.size());
  b.stroke({{0.5, 0.5}, {4.5, 0.5}, {4.5, 9.5}, {0.5, 9.5}}, kControl);
  QCOMPARE(b.count(), 2 * 2 * 2 * 2u);  // the squares x = 4, 5 stay
  b.tool.pointer(above(Kind::Press, 0, 0));
  b.tool.pointer(above(Kind::Drag, 5, 0));
  b.tool.pointer(above(Kind::Drag, 5, 5));
  QCOMPARE(b.tool.preview().lines.at(0).size(), std::size_t(4));
  QVERIFY(b.tool.preview().lines[0][2].isApprox(Vec3(5, 5, 5)));
}

void SelectToolTest::connectedAndAngle() {
  SelectFixture b(plates(), kConnected);
  b.click(3.2, 4.8);
  QCOMPARE(b.count(), std::size_t(200));
  SelectFixture sides(cube(), kAngle);
  sides.click(0.5, 0.4);
  QCOMPARE(sides.count(), std::size_t(2));
  sides.tool.setSetting("angle", 1.58);
  sides.click(0.5, 0.4);
  QCOMPARE(sides.count(), std::size_t(12));
}

void SelectToolTest::hoverShowsWhatAClickWouldSelect() {
  SelectFixture b(plates(), kClick);
  b.tool.pointer(above(Kind::Hover, 3.2, 4.8));
  QVERIFY(meshPreviewOf(b.tool.preview()).highlighted == FaceSelection{upper(3, 4) + 1});
  b.tool.setSetting("mode", kConnected);
  QVERIFY(meshPreviewOf(b.tool.preview()).highlighted.empty());
  b.tool.pointer(above(Kind::Hover, 3.2, 4.8));
  QCOMPARE(meshPreviewOf(b.tool.preview()).highlighted.count(), std::size_t(200));
  b.tool.pointer(above(Kind::Hover, 20, 20));
  QVERIFY(meshPreviewOf(b.tool.preview()).highlighted.empty());
  QCOMPARE(b.count(), std::size_t(0));
  SelectFixture large(torus(200, 60), kConnected);  // 24 000 faces: too many to show on the way
  large.tool.pointer(above(Kind::Hover, 2.0, 0.1));
  QCOMPARE(meshPreviewOf(large.tool.preview()).highlighted.count(), std::size_t(1));
}

void SelectToolTest::secondButton() {
  SelectFixture b(plates());
  PointerEvent event = above(Kind::Press, 5, 5);
  event.button = PointerButton::Second;
  QCOMPARE(b.tool.pointer(event), ToolReply::Ignored);  // of the mouse: the camera's, or a menu's
  event.device = Pose::Identity();
  QCOMPARE(b.tool.pointer(event), ToolReply::Finished);
  // Poked with the first, deleted with the second.
  QObject::connect(b.document.get(), &Document::changed, [&] { b.tool.documentChanged(); });
  const std::size_t before = b.document->mesh().liveFaceCount();
  b.click(5.3, 5.7);
  QCOMPARE(b.tool.pointer(event), ToolReply::Used);
  QCOMPARE(b.document->mesh().liveFaceCount(), before - 1);
  QCOMPARE(b.document->history()->count(), 1);
  QCOMPARE(b.tool.pointer(event), ToolReply::Finished);
}

HANDWHEEL_TEST(SelectToolTest)
#include "SelectToolTest.moc"
