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
  SelectFixture b(plates());
  for (const char* id : {"grow", "shrink", "delete", "previous", "next"}) QVERIFY(!isEnabled(b.tool, id));
  b.tool.perform("all");
  QCOMPARE(b.count(), std::size_t(400));
  b.tool.perform("invert");
  QCOMPARE(b.count(), std::size_t(0));
  b.click(5.3, 5.7);
  b.tool.perform("grow");
  QCOMPARE(b.count(), std::size_t(13));  // all that touch a triangle of a grid cut one way
  b.tool.perform("shrink");
  QCOMPARE(b.faces(), std::vector<Face>{upper(5, 5) + 1});
  b.tool.perform("invert");
  QCOMPARE(b.count(), std::size_t(399));
  QCOMPARE(b.tool.perform("unknown"), ToolReply::Ignored);
}

void SelectToolActionsTest::previousAndNext() {
  SelectFixture b(plates());
  b.click(3.2, 4.8);
  const MeshSelection one = b.tool.selection();
  b.tool.perform("grow");
  b.tool.perform("previous");
  QVERIFY(b.tool.selection() == one);
  QVERIFY(isEnabled(b.tool, "next"));
  b.tool.perform("next");
  QCOMPARE(b.count(), std::size_t(13));
  b.tool.perform("previous");
  b.tool.perform("previous");
  QVERIFY(b.tool.selection().empty());
}

void SelectToolActionsTest::deleteIsOneEdit() {
  SelectFixture b(plates());
  QObject::connect(b.document.get(), &Document::changed, [&] { b.tool.documentChanged(); });
  const HalfEdgeMesh before = b.document->mesh();
  b.click(5.3, 5.7);
  b.tool.perform("grow");
  const MeshSelection selected = b.tool.selection();
  QCOMPARE(b.tool.perform("delete"), ToolReply::Used);
  QCOMPARE(b.document->history()->count(), 1);
  QCOMPARE(b.document->history()->text(0), QString("Delete faces"));
  QCOMPARE(validate(b.document->mesh()), std::string());
  for (Face f = 0; f < 400; ++f) QCOMPARE(b.document->mesh().isLive(f), !selected.faces.contains(f));
  QCOMPARE(b.document->defects().loops.size(), std::size_t(3));
  QVERIFY(b.tool.selection().empty());
  b.document->history()->undo();
  QVERIFY(sameMesh(b.document->mesh(), before));
  b.tool.perform("previous");
  QVERIFY(b.tool.selection() == selected);
}

void SelectToolActionsTest::selectingIsNoEdit() {
  SelectFixture b(plates(), kBrush);
  const auto revision = b.document->revision();
  b.stroke({{5, 5}, {8, 5}});
  for (const char* id : {"all", "invert", "grow", "shrink", "previous", "next", "revert"}) b.tool.perform(id);
  QCOMPARE(b.document->history()->count(), 0);
  QCOMPARE(b.document->revision(), revision);
}

void SelectToolActionsTest::escLeavesStepByStep() {
  SelectFixture b(plates());
  b.click(3.2, 4.8);
  b.tool.pointer(above(Kind::Press, 5.2, 5.8));
  QCOMPARE(b.tool.perform("revert"), ToolReply::Used);
  QCOMPARE(b.tool.pointer(above(Kind::Release, 5.2, 5.8)), ToolReply::Ignored);
  QCOMPARE(b.faces(), std::vector<Face>{upper(3, 4) + 1});
  QCOMPARE(b.tool.perform("revert"), ToolReply::Used);
  QVERIFY(b.tool.selection().empty());
  QCOMPARE(b.tool.perform("revert"), ToolReply::Finished);
  b.click(3.2, 4.8);
  QCOMPARE(b.tool.perform("commit"), ToolReply::Finished);
  QCOMPARE(b.count(), std::size_t(1));  // for the next tool
}

void SelectToolActionsTest::selectFromAList() {
  SelectFixture b(plates());
  int updates = 0;
  b.tool.whenUpdated([&] { ++updates; });
  b.tool.select({{1, 2, 7777}, {55}});
  QVERIFY(b.tool.selection() == (MeshSelection{{1, 2}, {}}));
  QCOMPARE(updates, 1);
  b.tool.perform("previous");
  QVERIFY(b.tool.selection().empty());
}

void SelectToolActionsTest::jobsComeLater() {
  SelectFixture b(plates());
  WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(b.document->mesh());
  SelectTool tool(*b.document, waiting.services());
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
  QCOMPARE(b.document->history()->count(), 0);
  HalfEdgeMesh later = b.document->mesh();  // the change can be made on another version
  later.removeFace(300);
  waiting.changes.front().apply(later, {});
  QCOMPARE(later.liveFaceCount(), std::size_t(200));
  QCOMPARE(validate(later), std::string());
}

void SelectToolActionsTest::lateJobsAreDropped() {
  SelectFixture b(plates());
  WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(b.document->mesh());
  auto tool = std::make_unique<SelectTool>(*b.document, waiting.services());
  tool->setSetting("mode", kConnected);
  const auto click = [&](double x) {
    tool->pointer(above(Kind::Press, x, 4.8));
    tool->pointer(above(Kind::Release, x, 4.8));
  };
  click(3.2);
  auto first = waiting.work();
  click(3.2);  // takes its place
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
  SelectFixture b(plates());
  WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(b.document->mesh());
  SelectTool tool(*b.document, waiting.services());
  HalfEdgeMesh mesh = b.document->mesh();
  removeFaces(mesh, FaceSelection{upper(3, 4), upper(3, 4) + 1});
  b.document->commit("Edit", inspected(mesh));
  tool.documentChanged();
  for (const double mode : {kClick, kBrush, kLasso, kConnected, kAngle}) {
    tool.setSetting("mode", mode);
    tool.setSetting("through", true);
    for (const auto& event : {above(Kind::Press, 3.2, 4.8), above(Kind::Drag, 9.9, 4.8), above(Kind::Drag, 9.9, 9.9),
                              above(Kind::Release, 0.2, 9.9)})
      tool.pointer(event);
    while (!waiting.jobs.empty()) waiting.work()();
    tool.selection().faces.forEach([&](Face f) { QVERIFY(b.document->mesh().isLive(f)); });
  }
}

void SelectToolActionsTest::noHierarchy() {
  SelectFixture b(plates());
  WaitingServices waiting;
  SelectTool tool(*b.document, waiting.services());
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
