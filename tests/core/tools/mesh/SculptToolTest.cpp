// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SculptFixture.h"
#include "TestClass.h"
#include "WaitingServices.h"
#include "tools/mesh/MeshPreview.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

class SculptToolTest : public QObject {
  Q_OBJECT

 private slots:
  void dragsInThePlaneOfTheView();
  void dragsWithADevice();
  void aDragAndBackIsNoStep();
  void brushes();
  void shiftSmoothsAndControlInverts();
  void escapeGivesTheStrokeUp();
  void besideTheModel();
  void onlyThePatch();
  void saysThatTheSurfaceCrossesItself();
  void strokesWaitForOneAnother();
  void whatIsGivenUpIsTakenBack();
  void whoElseChangesTheDocumentWins();
};

void SculptToolTest::dragsInThePlaneOfTheView() {
  SculptFixture fixture;
  const PointerEvent press = above(Kind::Press, 10, 10);
  QCOMPARE(fixture.runner.pointer(press), ToolReply::Used);
  fixture.runner.pointer(above(Kind::Drag, 10.4, 10.2));
  QVERIFY(meshPreviewOf(fixture.tool->preview()).previewMesh);
  QVERIFY((meshPreviewOf(fixture.tool->preview()).previewMesh->mesh.position(at(10, 10)) - Vec3(10.4, 10.2, 0)).norm() <
          1e-5);
  QCOMPARE(fixture.document->mesh().position(at(10, 10)), Vec3(10, 10, 0));  // only shown
  QCOMPARE(fixture.tool->forces().size(), std::size_t(1));
  fixture.runner.pointer(above(Kind::Drag, 10.6, 9.8));
  fixture.runner.pointer(above(Kind::Release, 10.5, 10.1));
  QVERIFY((fixture.document->mesh().position(at(10, 10)) - Vec3(10.5, 10.1, 0)).norm() < 1e-5);
  QCOMPARE(fixture.steps(), 1);
  QVERIFY(!meshPreviewOf(fixture.tool->preview()).previewMesh && fixture.tool->forces().empty());
  QCOMPARE(fixture.check(), std::string());
  fixture.document->history()->undo();
  QCOMPARE(fixture.document->mesh().position(at(10, 10)), Vec3(10, 10, 0));
}

void SculptToolTest::dragsWithADevice() {
  SculptFixture fixture;
  fixture.lift(1.5);
  QVERIFY(std::abs(fixture.height() - 1.5) < 1e-6);
  QVERIFY(fixture.height(10, 11) > 0.5 && fixture.height(10, 11) < 1.5);
  QCOMPARE(fixture.height(10, 14), 0.0);  // 4 mm off
  QCOMPARE(fixture.steps(), 1);
  PointerEvent second = above(Kind::Press, 10, 10);
  second.device = Pose::Identity();
  second.button = PointerButton::Second;
  QCOMPARE(fixture.runner.pointer(second), ToolReply::Finished);
}

void SculptToolTest::aDragAndBackIsNoStep() {
  SculptFixture fixture;
  fixture.stroke({{10, 10}, {11, 10}, {10, 10}});
  QCOMPARE(fixture.steps(), 0);
  QVERIFY(!meshPreviewOf(fixture.tool->preview()).previewMesh);
}

void SculptToolTest::brushes() {
  SculptFixture fixture;
  fixture.runner.setSetting("strength", 1.0);
  fixture.runner.setSetting("brush", kInflate);
  fixture.stroke({{8, 10}, {12, 10}});
  const double raised = fixture.height();
  QVERIFY(raised > 0.2);
  fixture.runner.setSetting("brush", kFlatten);
  fixture.stroke({{8, 10}, {12, 10}});
  QVERIFY(fixture.height() < raised);
  fixture.runner.setSetting("brush", kSmooth);
  fixture.stroke({{8, 10}, {12, 10}});
  QCOMPARE(fixture.steps(), 3);
  QCOMPARE(fixture.check(), std::string());
  QCOMPARE(fixture.height(0, 0), 0.0);
  fixture.document->history()->setIndex(0);
  for (Vertex v = 0; v < fixture.document->mesh().vertexSlots(); ++v)
    QCOMPARE(fixture.document->mesh().position(v).z(), 0.0);
}

void SculptToolTest::shiftSmoothsAndControlInverts() {
  SculptFixture fixture;
  fixture.runner.setSetting("brush", kInflate);
  fixture.stroke({{10, 10}}, kControl);
  const double pressed = fixture.height();
  QVERIFY(pressed < -0.05);
  fixture.stroke({{10, 10}, {11, 10}, {9, 10}, {10, 10}}, kShift);
  QVERIFY(fixture.height() > pressed);
}

void SculptToolTest::escapeGivesTheStrokeUp() {
  SculptFixture fixture;
  fixture.runner.pointer(above(Kind::Press, 10, 10));
  fixture.runner.pointer(above(Kind::Drag, 12, 10));
  QVERIFY(meshPreviewOf(fixture.tool->preview()).previewMesh);
  QCOMPARE(fixture.runner.perform("revert"), ToolReply::Used);
  QVERIFY(!meshPreviewOf(fixture.tool->preview()).previewMesh);
  QCOMPARE(fixture.runner.pointer(above(Kind::Release, 12, 10)), ToolReply::Ignored);
  QCOMPARE(fixture.steps(), 0);
  QCOMPARE(fixture.runner.perform("revert"), ToolReply::Finished);
}

void SculptToolTest::besideTheModel() {
  SculptFixture fixture;
  QCOMPARE(fixture.runner.pointer(above(Kind::Press, 40, 10)), ToolReply::Ignored);  // the camera may turn
  QCOMPARE(fixture.runner.pointer(above(Kind::Drag, 10, 10)), ToolReply::Ignored);
  fixture.runner.pointer(above(Kind::Hover, 10, 10));
  QVERIFY(fixture.tool->preview().circle && fixture.tool->preview().circle->second == 3.0);
  fixture.runner.pointer(above(Kind::Leave, 10, 10));
  QVERIFY(!fixture.tool->preview().circle);
}

void SculptToolTest::onlyThePatch() {
  SculptFixture fixture(middle());
  QCOMPARE(fixture.tool->preview().lines.size(), std::size_t(1));
  fixture.runner.setSetting("radius", 8.0);
  fixture.lift(2.0);
  QVERIFY(fixture.height() > 1.9);
  for (Vertex v = 0; v < 441; ++v) {
    const Vec3& p = fixture.document->mesh().position(v);
    const bool isInside = p.x() > 6 && p.x() < 14 && p.y() > 6 && p.y() < 14;
    QVERIFY(isInside || p.z() == 0.0);
  }
  fixture.runner.perform("whole");
  QVERIFY(fixture.tool->preview().lines.empty());
  fixture.lift(2.0, 4.0);
  QVERIFY(fixture.height(4, 10) > 1.9);
}

// A plate above the sheet, pulled down through it.
void SculptToolTest::saysThatTheSurfaceCrossesItself() {
  TriangleSoup soup = sheet();
  TriangleSoup lower = sheet();
  for (Vec3& p : lower.points) p.z() -= 1.0;
  append(soup, lower);
  SculptFixture fixture({}, soup);
  fixture.lift(-0.7);
  QVERIFY(!propertyNamed(fixture.tool->settings(), "crossings"));
  const std::size_t offered = fixture.tool->actions().size();
  fixture.lift(-0.7);
  QVERIFY(!findSelfIntersections(fixture.document->mesh())->empty());
  const auto pairs = findSelfIntersections(fixture.document->mesh())->size();
  QVERIFY(std::get<double>(propertyNamed(fixture.tool->settings(), "crossings")->value) == static_cast<double>(pairs));
  QVERIFY(!propertyNamed(fixture.tool->settings(), "crossings")->problem.empty());
  QCOMPARE(fixture.tool->actions().size(), offered + 1);
  QCOMPARE(fixture.tool->actions()[0].input, std::string("Ctrl+Z"));
  fixture.document->history()->undo();
  QVERIFY(!propertyNamed(fixture.tool->settings(), "crossings"));
  fixture.lift(-0.7);
  QVERIFY(propertyNamed(fixture.tool->settings(), "crossings"));
  fixture.lift(0.1, 4.0);  // elsewhere
  QVERIFY(!propertyNamed(fixture.tool->settings(), "crossings"));
}

// A change takes its time; the next stroke begins on what is shown, and each becomes a step of its own.
void SculptToolTest::strokesWaitForOneAnother() {
  const auto document = meshDocument(sheet());
  WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(document->mesh());
  ToolRunner runner;
  runner.start(std::make_unique<SculptTool>(*document, waiting.services()), *document);
  runner.setSetting("radius", 3.0);
  const auto* tool = static_cast<const SculptTool*>(runner.tool());
  for (const double x : {10.5, 11.0, 11.5}) {
    runner.pointer(above(Kind::Press, x - 0.5, 10));
    runner.pointer(above(Kind::Release, x, 10));
  }
  QCOMPARE(waiting.changes.size(), std::size_t(3));
  QVERIFY((meshPreviewOf(tool->preview()).previewMesh->mesh.position(at(10, 10)) - Vec3(11.5, 10, 0)).norm() < 1e-5);
  for (int step = 1; step <= 3; ++step) {
    const MeshChange change = waiting.changes.front();
    waiting.changes.pop_front();
    HalfEdgeMesh mesh = document->mesh();
    change.apply(mesh, {});
    QVERIFY(document->commit(QString(change.text), inspected(mesh)));
    change.ended();
    QCOMPARE(document->history()->count(), step);
    QCOMPARE(meshPreviewOf(tool->preview()).previewMesh != nullptr, step < 3);
  }
  QVERIFY((document->mesh().position(at(10, 10)) - Vec3(11.5, 10, 0)).norm() < 1e-5);
}

void SculptToolTest::whatIsGivenUpIsTakenBack() {
  const auto document = meshDocument(sheet());
  WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(document->mesh());
  ToolRunner runner;
  runner.start(std::make_unique<SculptTool>(*document, waiting.services()), *document);
  for (int i = 0; i < 2; ++i) {
    runner.pointer(above(Kind::Press, 10, 10));
    runner.pointer(above(Kind::Release, 10.5, 10));
  }
  QVERIFY(meshPreviewOf(runner.tool()->preview()).previewMesh);
  waiting.changes[0].ended();  // cancelled
  QVERIFY(!meshPreviewOf(runner.tool()->preview()).previewMesh);
  waiting.changes[1].ended();  // without the first there is nothing that it could change
  QVERIFY(!meshPreviewOf(runner.tool()->preview()).previewMesh);
  runner.stop();
  waiting.changes[1].ended();  // reaches nobody
}

void SculptToolTest::whoElseChangesTheDocumentWins() {
  const auto document = meshDocument(sheet());
  WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(document->mesh());
  ToolRunner runner;
  runner.start(std::make_unique<SculptTool>(*document, waiting.services()), *document);
  runner.pointer(above(Kind::Press, 10, 10));
  runner.pointer(above(Kind::Release, 10.5, 10));
  HalfEdgeMesh other = document->mesh();
  other.removeFace(0);
  document->commit(QStringLiteral("other"), inspected(other));
  QVERIFY(!meshPreviewOf(runner.tool()->preview()).previewMesh);
  HalfEdgeMesh mesh = document->mesh();
  waiting.changes.front().apply(mesh, {});
  QVERIFY(sameMesh(mesh, document->mesh()));
  waiting.changes.front().ended();
  QCOMPARE(document->mesh().position(at(10, 10)), Vec3(10, 10, 0));
}

HANDWHEEL_TEST(SculptToolTest)
#include "SculptToolTest.moc"
