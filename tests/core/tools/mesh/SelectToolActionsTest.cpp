// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChecks.h"
#include "SelectFixture.h"
#include "TestClass.h"
#include "WaitingServices.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

class SelectToolActionsTest : public QObject {
  Q_OBJECT

 private slots:
  void actionsOnTheSelection();
  void previousAndNext();
  void deleteIsOneEdit();
  void selectingIsNoEdit();
  void escLeavesStepByStep();
  void selectFromAList();
  void jobsComeLater();
  void lateJobsAreDropped();
  void oldHierarchy();
  void noHierarchy();
};

void SelectToolActionsTest::actionsOnTheSelection() {
  SelectFixture fixture(plates());
  for (const char* id : {"grow", "shrink", "delete", "previous", "next"}) QVERIFY(!isEnabled(fixture.tool, id));
  fixture.tool.perform("all");
  QCOMPARE(fixture.count(), std::size_t(400));
  fixture.tool.perform("invert");
  QCOMPARE(fixture.count(), std::size_t(0));
  fixture.click(5.3, 5.7);
  fixture.tool.perform("grow");
  QCOMPARE(fixture.count(), std::size_t(13));  // all faces that touch a triangle of a grid with parallel diagonals
  fixture.tool.perform("shrink");
  QCOMPARE(fixture.faces(), std::vector<Face>{upper(5, 5) + 1});
  fixture.tool.perform("invert");
  QCOMPARE(fixture.count(), std::size_t(399));
  QCOMPARE(fixture.tool.perform("unknown"), ToolReply::Ignored);
}

void SelectToolActionsTest::previousAndNext() {
  SelectFixture fixture(plates());
  fixture.click(3.2, 4.8);
  const MeshSelection one = fixture.tool.selection();
  fixture.tool.perform("grow");
  fixture.tool.perform("previous");
  QVERIFY(fixture.tool.selection() == one);
  QVERIFY(isEnabled(fixture.tool, "next"));
  fixture.tool.perform("next");
  QCOMPARE(fixture.count(), std::size_t(13));
  fixture.tool.perform("previous");
  fixture.tool.perform("previous");
  QVERIFY(fixture.tool.selection().empty());
}

void SelectToolActionsTest::deleteIsOneEdit() {
  SelectFixture fixture(plates());
  QObject::connect(fixture.document.get(), &Document::changed, [&] { fixture.tool.documentChanged(); });
  const HalfEdgeMesh before = fixture.document->mesh();
  fixture.click(5.3, 5.7);
  fixture.tool.perform("grow");
  const MeshSelection selected = fixture.tool.selection();
  QCOMPARE(fixture.tool.perform("delete"), ToolReply::Used);
  QCOMPARE(fixture.document->history()->count(), 1);
  QCOMPARE(fixture.document->history()->text(0), QString("Delete faces"));
  QCOMPARE(validate(fixture.document->mesh()), std::string());
  for (Face f = 0; f < 400; ++f) QCOMPARE(fixture.document->mesh().isLive(f), !selected.faces.contains(f));
  QCOMPARE(fixture.document->defects().loops.size(), std::size_t(3));
  QVERIFY(fixture.tool.selection().empty());
  fixture.document->history()->undo();
  QVERIFY(sameMesh(fixture.document->mesh(), before));
  fixture.tool.perform("previous");
  QVERIFY(fixture.tool.selection() == selected);
}

void SelectToolActionsTest::selectingIsNoEdit() {
  SelectFixture fixture(plates(), kBrush);
  const auto revision = fixture.document->revision();
  fixture.stroke({{5, 5}, {8, 5}});
  for (const char* id : {"all", "invert", "grow", "shrink", "previous", "next", "revert"}) fixture.tool.perform(id);
  QCOMPARE(fixture.document->history()->count(), 0);
  QCOMPARE(fixture.document->revision(), revision);
}

void SelectToolActionsTest::escLeavesStepByStep() {
  SelectFixture fixture(plates());
  fixture.click(3.2, 4.8);
  fixture.tool.pointer(above(Kind::Press, 5.2, 5.8));
  QCOMPARE(fixture.tool.perform("revert"), ToolReply::Used);
  QCOMPARE(fixture.tool.pointer(above(Kind::Release, 5.2, 5.8)), ToolReply::Ignored);
  QCOMPARE(fixture.faces(), std::vector<Face>{upper(3, 4) + 1});
  QCOMPARE(fixture.tool.perform("revert"), ToolReply::Used);
  QVERIFY(fixture.tool.selection().empty());
  QCOMPARE(fixture.tool.perform("revert"), ToolReply::Finished);
  fixture.click(3.2, 4.8);
  QCOMPARE(fixture.tool.perform("commit"), ToolReply::Finished);
  QCOMPARE(fixture.count(), std::size_t(1));  // for the next tool
}

void SelectToolActionsTest::selectFromAList() {
  SelectFixture fixture(plates());
  int updates = 0;
  fixture.tool.whenUpdated([&] { ++updates; });
  fixture.tool.select({{1, 2, 7777}, {55}});
  QVERIFY(fixture.tool.selection() == (MeshSelection{{1, 2}, {}}));
  QCOMPARE(updates, 1);
  fixture.tool.perform("previous");
  QVERIFY(fixture.tool.selection().empty());
}

void SelectToolActionsTest::jobsComeLater() {
  SelectFixture fixture(plates());
  WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(fixture.document->mesh());
  SelectTool tool(*fixture.document, waiting.services());
  int updates = 0;
  tool.whenUpdated([&] { ++updates; });
  tool.setSetting("mode", kConnected);
  tool.pointer(above(Kind::Press, 3.2, 4.8));
  tool.pointer(above(Kind::Release, 3.2, 4.8));
  QVERIFY(tool.selection().empty());
  const auto finish = waiting.work();
  QVERIFY(tool.selection().empty());
  finish();
  QCOMPARE(tool.selection().faces.count(), std::size_t(200));
  QCOMPARE(updates, 1);

  tool.perform("delete");
  QCOMPARE(waiting.changes.size(), std::size_t(1));
  QCOMPARE(fixture.document->history()->count(), 0);
  HalfEdgeMesh later = fixture.document->mesh();  // the change can be made on another version
  later.removeFace(300);
  waiting.changes.front().apply(later, {});
  QCOMPARE(later.liveFaceCount(), std::size_t(200));
  QCOMPARE(validate(later), std::string());
}

void SelectToolActionsTest::lateJobsAreDropped() {
  SelectFixture fixture(plates());
  WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(fixture.document->mesh());
  auto tool = std::make_unique<SelectTool>(*fixture.document, waiting.services());
  tool->setSetting("mode", kConnected);
  const auto click = [&](double x) {
    tool->pointer(above(Kind::Press, x, 4.8));
    tool->pointer(above(Kind::Release, x, 4.8));
  };
  click(3.2);
  auto first = waiting.work();
  click(3.2);  // replaces it
  QCOMPARE(waiting.cancelled, 1);
  first();
  QVERIFY(tool->selection().empty());
  auto second = waiting.work();
  QCOMPARE(tool->perform("revert"), ToolReply::Used);
  QCOMPARE(waiting.cancelled, 2);
  second();
  QVERIFY(tool->selection().empty());
  click(3.2);
  auto third = waiting.work();
  tool->documentChanged();
  third();
  QVERIFY(tool->selection().empty());
  click(3.2);
  auto fourth = waiting.work();
  tool.reset();
  QCOMPARE(waiting.cancelled, 4);
  fourth();  // finds nobody
}

// Until a hierarchy of the present mesh is there, one cannot select what is gone.
void SelectToolActionsTest::oldHierarchy() {
  SelectFixture fixture(plates());
  WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(fixture.document->mesh());
  SelectTool tool(*fixture.document, waiting.services());
  HalfEdgeMesh mesh = fixture.document->mesh();
  removeFaces(mesh, FaceSelection{upper(3, 4), upper(3, 4) + 1});
  fixture.document->commit("Edit", inspected(mesh));
  tool.documentChanged();
  for (const double mode : {kClick, kBrush, kLasso, kConnected, kAngle}) {
    tool.setSetting("mode", mode);
    tool.setSetting("through", true);
    for (const auto& event : {above(Kind::Press, 3.2, 4.8), above(Kind::Drag, 9.9, 4.8), above(Kind::Drag, 9.9, 9.9),
                              above(Kind::Release, 0.2, 9.9)})
      tool.pointer(event);
    while (!waiting.jobs.empty()) waiting.work()();
    tool.selection().faces.forEach([&](Face f) { QVERIFY(fixture.document->mesh().isLive(f)); });
  }
}

void SelectToolActionsTest::noHierarchy() {
  SelectFixture fixture(plates());
  WaitingServices waiting;
  SelectTool tool(*fixture.document, waiting.services());
  for (const double mode : {kClick, kBrush, kLasso, kConnected, kAngle}) {
    tool.setSetting("mode", mode);
    for (const Kind kind : {Kind::Hover, Kind::Press, Kind::Drag, Kind::Release, Kind::DoubleClick, Kind::Leave})
      tool.pointer(above(kind, 3.2, 4.8));
  }
  QVERIFY(tool.selection().empty());
  tool.perform("all");
  QCOMPARE(tool.selection().faces.count(), std::size_t(400));
}

HANDWHEEL_TEST(SelectToolActionsTest)
#include "SelectToolActionsTest.moc"
