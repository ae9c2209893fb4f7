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
  SelectFixture fixture(plates());
  const Face first = upper(3, 4) + 1, second = upper(7, 2);  // above the diagonal, below it
  fixture.click(3.2, 4.8);
  QCOMPARE(fixture.faces(), std::vector<Face>{first});
  fixture.click(7.8, 2.2);
  QCOMPARE(fixture.faces(), std::vector<Face>{second});
  fixture.click(3.2, 4.8, kShift);
  QCOMPARE(fixture.faces(), (std::vector<Face>{first, second}));
  fixture.click(7.8, 2.2, kControl);
  QCOMPARE(fixture.faces(), std::vector<Face>{first});
  fixture.click(7.8, 2.2, kControl);
  fixture.click(20, 20, kControl);
  fixture.click(20, 20, kShift);
  QCOMPARE(fixture.faces(), std::vector<Face>{first});
  QVERIFY(meshPreviewOf(fixture.tool.preview()).selected == (FaceSelection{first}));
}

void SelectToolTest::clickOnNothingClears() {
  SelectFixture fixture(plates());
  fixture.click(3.2, 4.8);
  QCOMPARE(fixture.tool.pointer(above(Kind::Press, 20, 20)), ToolReply::Ignored);  // the camera may turn
  QCOMPARE(fixture.tool.pointer(above(Kind::Release, 20, 20)), ToolReply::Used);
  QCOMPARE(fixture.count(), std::size_t(0));
}

void SelectToolTest::turningTheCameraDoesNotClear() {
  SelectFixture fixture(plates());
  fixture.click(3.2, 4.8);
  fixture.tool.pointer(above(Kind::Press, 20, 20));
  QCOMPARE(fixture.tool.pointer(above(Kind::Drag, 22, 20)), ToolReply::Ignored);
  QCOMPARE(fixture.tool.pointer(above(Kind::Release, 22, 20)), ToolReply::Ignored);
  QCOMPARE(fixture.count(), std::size_t(1));
}

void SelectToolTest::clicksAtAHole() {
  SelectFixture fixture(sphereWithoutCap(3));
  const Vertex key = keyOf(fixture.document->mesh(), fixture.document->defects().loops.at(0));
  fixture.click(0, 0);
  QVERIFY(fixture.tool.selection() == (MeshSelection{{}, {key}}));
  QCOMPARE(fixture.tool.preview().lines.size(), std::size_t(1));
  fixture.click(0.7, 0, kShift);
  QCOMPARE(fixture.count(), std::size_t(1));
  fixture.click(0.01, 0.01, kControl);
  QVERIFY(fixture.tool.selection().loops.empty() && fixture.count() == 1);
  fixture.tool.pointer(above(Kind::Hover, 0, 0));
  QCOMPARE(fixture.tool.preview().lines.size(), std::size_t(1));
  fixture.tool.pointer(above(Kind::Leave, 0, 0));
  QVERIFY(fixture.tool.preview().lines.empty());
}

void SelectToolTest::doubleClickTakesThePart() {
  SelectFixture fixture(plates());
  fixture.click(3.2, 4.8);
  fixture.tool.pointer(above(Kind::DoubleClick, 3.2, 4.8));
  fixture.tool.pointer(above(Kind::Release, 3.2, 4.8));
  QCOMPARE(fixture.count(), std::size_t(200));
  QCOMPARE(fixture.faces().front(), Face(200));
}

void SelectToolTest::brushCoversADisc() {
  SelectFixture fixture(plates(), kBrush);
  fixture.tool.setSetting("brush_unit", 0.0);
  fixture.tool.setSetting("brush_length", 2.3);
  QCOMPARE(fixture.tool.pointer(above(Kind::Press, 20, 20)), ToolReply::Ignored);
  fixture.stroke({{4.6, 5.1}});
  const HalfEdgeMesh& mesh = fixture.document->mesh();
  for (Face f = 0; f < 400; ++f) {
    const auto [p, q, r] = mesh.points(f);
    const Vec3 centre(4.6, 5.1, 5.0);
    const bool meets = f >= 200 && (closestOnTriangle(centre, p, q, r) - centre).norm() <= 2.3;
    QCOMPARE(fixture.tool.selection().faces.contains(f), meets);
  }
}

void SelectToolTest::brushAddsAndRemoves() {
  SelectFixture fixture(plates(), kBrush);
  fixture.tool.setSetting("brush_unit", 0.0);
  fixture.tool.setSetting("brush_length", 1e-3);
  fixture.stroke({{0.5, 0.2}, {9.5, 0.2}});
  const FaceSelection row = fixture.tool.selection().faces;
  QVERIFY(row.count() >= 10 && row.contains(upper(0, 0)) && row.contains(upper(9, 0)));
  fixture.stroke({{0.5, 3.2}, {9.5, 3.2}}, kShift);
  QCOMPARE(fixture.count(), 2 * row.count());
  fixture.stroke({{0.5, 0.2}, {9.5, 0.2}}, kControl);
  QCOMPARE(fixture.count(), row.count());
  QVERIFY(!fixture.tool.selection().faces.contains(upper(5, 0)));
  fixture.stroke({{0.5, 0.2}, {9.5, 0.2}});
  QVERIFY(fixture.tool.selection().faces == row);
}

void SelectToolTest::brushStrokeIsOneStep() {
  SelectFixture fixture(plates(), kBrush);
  fixture.stroke({{1, 1}});
  const MeshSelection before = fixture.tool.selection();
  fixture.tool.pointer(above(Kind::Press, 5, 5));
  fixture.tool.pointer(above(Kind::Drag, 8, 5));
  QVERIFY(!(fixture.tool.selection() == before));  // one sees it grow
  QVERIFY(fixture.tool.preview().circle && fixture.tool.preview().circle->first.isApprox(Vec3(8, 5, 5)));
  QCOMPARE(fixture.tool.perform("revert"), ToolReply::Used);
  QVERIFY(fixture.tool.selection() == before);
  fixture.stroke({{5, 5}, {8, 5}, {8, 8}});
  QVERIFY(!(fixture.tool.selection() == before));
  fixture.tool.perform("previous");
  QVERIFY(fixture.tool.selection() == before);
}

void SelectToolTest::brushInPixels() {
  SelectFixture fixture(plates(), kBrush);
  fixture.tool.setSetting("brush_pixels", 100.0);
  fixture.tool.pointer(above(Kind::Hover, 5, 5));
  QCOMPARE(fixture.tool.preview().circle->second, 1.0);
  fixture.tool.perform("larger");
  fixture.tool.pointer(above(Kind::Hover, 5, 5));
  QVERIFY(fixture.tool.preview().circle->second > 1.0);
  fixture.tool.perform("smaller");
  fixture.tool.pointer(above(Kind::Hover, 5, 5));
  QCOMPARE(fixture.tool.preview().circle->second, 1.0);
  PointerEvent near = above(Kind::Hover, 5, 5);
  near.eye = Vec3(5, 5, 55);  // 50 above the plate; a pixel is 0.01 at 100
  near.ray.origin = *near.eye;
  near.focus = 100.0;
  fixture.tool.pointer(near);
  QCOMPARE(fixture.tool.preview().circle->second, 0.5);
  QVERIFY(isEnabled(fixture.tool, "larger"));
  fixture.tool.setSetting("mode", kClick);
  QVERIFY(!isEnabled(fixture.tool, "larger"));
}

void SelectToolTest::lassoSeesOrGoesThrough() {
  SelectFixture fixture(plates(), kLasso);
  const std::vector<Eigen::Vector2d> around = {{1.5, 1.5}, {6.5, 1.5}, {6.5, 4.5}, {1.5, 4.5}};
  fixture.stroke(around);
  std::vector<Face> expected;
  for (int x = 2; x < 6; ++x)
    for (int y = 2; y < 4; ++y) expected.insert(expected.end(), {upper(x, y), upper(x, y) + 1});
  QCOMPARE(fixture.faces(), expected);
  fixture.tool.setSetting("through", true);
  fixture.stroke(around);
  QCOMPARE(fixture.count(), 2 * expected.size());
  fixture.stroke({{0.5, 0.5}, {4.5, 0.5}, {4.5, 9.5}, {0.5, 9.5}}, kControl);
  QCOMPARE(fixture.count(), 2 * 2 * 2 * 2u);  // the squares x = 4, 5 stay
  fixture.tool.pointer(above(Kind::Press, 0, 0));
  fixture.tool.pointer(above(Kind::Drag, 5, 0));
  fixture.tool.pointer(above(Kind::Drag, 5, 5));
  QCOMPARE(fixture.tool.preview().lines.at(0).size(), std::size_t(4));
  QVERIFY(fixture.tool.preview().lines[0][2].isApprox(Vec3(5, 5, 5)));
}

void SelectToolTest::connectedAndAngle() {
  SelectFixture fixture(plates(), kConnected);
  fixture.click(3.2, 4.8);
  QCOMPARE(fixture.count(), std::size_t(200));
  SelectFixture sides(cube(), kAngle);
  sides.click(0.5, 0.4);
  QCOMPARE(sides.count(), std::size_t(2));
  sides.tool.setSetting("angle", 1.58);
  sides.click(0.5, 0.4);
  QCOMPARE(sides.count(), std::size_t(12));
}

void SelectToolTest::hoverShowsWhatAClickWouldSelect() {
  SelectFixture fixture(plates(), kClick);
  fixture.tool.pointer(above(Kind::Hover, 3.2, 4.8));
  QVERIFY(meshPreviewOf(fixture.tool.preview()).highlighted == FaceSelection{upper(3, 4) + 1});
  fixture.tool.setSetting("mode", kConnected);
  QVERIFY(meshPreviewOf(fixture.tool.preview()).highlighted.empty());
  fixture.tool.pointer(above(Kind::Hover, 3.2, 4.8));
  QCOMPARE(meshPreviewOf(fixture.tool.preview()).highlighted.count(), std::size_t(200));
  fixture.tool.pointer(above(Kind::Hover, 20, 20));
  QVERIFY(meshPreviewOf(fixture.tool.preview()).highlighted.empty());
  QCOMPARE(fixture.count(), std::size_t(0));
  SelectFixture large(torus(200, 60), kConnected);  // 24 000 faces: too many to show during the gesture
  large.tool.pointer(above(Kind::Hover, 2.0, 0.1));
  QCOMPARE(meshPreviewOf(large.tool.preview()).highlighted.count(), std::size_t(1));
}

void SelectToolTest::secondButton() {
  SelectFixture fixture(plates());
  PointerEvent event = above(Kind::Press, 5, 5);
  event.button = PointerButton::Second;
  QCOMPARE(fixture.tool.pointer(event), ToolReply::Ignored);  // events of the mouse: for the camera, or a menu
  event.device = Pose::Identity();
  QCOMPARE(fixture.tool.pointer(event), ToolReply::Finished);
  // Poked with the first, deleted with the second.
  QObject::connect(fixture.document.get(), &Document::changed, [&] { fixture.tool.documentChanged(); });
  const std::size_t before = fixture.document->mesh().liveFaceCount();
  fixture.click(5.3, 5.7);
  QCOMPARE(fixture.tool.pointer(event), ToolReply::Used);
  QCOMPARE(fixture.document->mesh().liveFaceCount(), before - 1);
  QCOMPARE(fixture.document->history()->count(), 1);
  QCOMPARE(fixture.tool.pointer(event), ToolReply::Finished);
}

HANDWHEEL_TEST(SelectToolTest)
#include "SelectToolTest.moc"
