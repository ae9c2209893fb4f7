// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryFixture.h"
#include "TestClass.h"
#include "tools/mesh/MeshPreview.h"

#include <QTest>

using namespace handwheel;
using test::Kind;

// Tests the actions of BoundaryTool on a whole edge.
class BoundaryToolActionsTest : public QObject, private test::BoundaryFixture {
  Q_OBJECT

 private slots:
  void init() { start(test::plateWithHole()); }
  void smoothsTheEdge();
  void settingsLookAgain();
  void removesIslands();
  void removesPeninsulas();
  void tellsWhenThereIsNothing();
  void keys();
  void lateResultsAreNotShown();
  void followsTheDocument();
};

void BoundaryToolActionsTest::smoothsTheEdge() {
  start(test::sphereWithoutCap(3, 0.5));
  const HalfEdgeMesh before = mesh();
  m_tool->perform("next");
  QCOMPARE(m_tool->perform("smooth"), ToolReply::Used);
  QCOMPARE(m_tool->preview().parts.size(), std::size_t(1));
  QVERIFY(test::sameMesh(mesh(), before));
  QCOMPARE(m_tool->perform("commit"), ToolReply::Used);
  QCOMPARE(oneStep(before), std::string());
  QCOMPARE(m_tool->perform("commit"), ToolReply::Finished);
}

void BoundaryToolActionsTest::settingsLookAgain() {
  start(test::sphereWithoutCap(4, 0.5));
  m_tool->perform("next");
  m_tool->perform("smooth");
  const auto first = m_tool->preview().parts.at(0).soup->points;
  m_tool->setSetting("wavelength", 20.0);
  QVERIFY(m_tool->preview().parts.at(0).soup->points != first);
  m_tool->setSetting("wavelength", 8.0);
  QVERIFY(m_tool->preview().parts.at(0).soup->points == first);
  m_tool->setSetting("wavelength", 0.0);
  m_tool->setSetting("evenly", false);
  QVERIFY(m_tool->preview().parts.empty() && !test::isEnabled(*m_tool, "commit"));
  for (const PropertyValue& odd : {PropertyValue(std::nan("")), PropertyValue("8"), PropertyValue(true)})
    m_tool->setSetting("wavelength", odd);
  QCOMPARE(std::get<double>(test::propertyNamed(m_tool->settings(), "wavelength")->value), 0.0);
  m_tool->setSetting("wavelength", 1e300);
  QVERIFY(std::get<double>(test::propertyNamed(m_tool->settings(), "wavelength")->value) <= 100.0);
}

void BoundaryToolActionsTest::removesIslands() {
  start(test::plateWithIsland());
  const HalfEdgeMesh before = mesh();
  m_tool->pointer(test::above(Kind::Press, -4, 0));  // between island and rim
  QVERIFY(m_tool->loop() && !m_tool->loop()->isSheetBoundary);
  m_tool->perform("islands");
  const FaceSelection marked = meshPreviewOf(m_tool->preview()).selected;
  QVERIFY(marked.count() > 0 && test::isEnabled(*m_tool, "commit"));
  m_tool->perform("commit");
  QCOMPARE(oneStep(before), std::string());
  QCOMPARE(loops(), std::size_t(2));
  QCOMPARE(mesh().liveFaceCount(), before.liveFaceCount() - marked.count());
}

void BoundaryToolActionsTest::removesPeninsulas() {
  start(test::plateWithTongue());
  const HalfEdgeMesh before = mesh();
  m_tool->pointer(test::above(Kind::Press, 4, 0));
  m_tool->perform("peninsulas");
  const FaceSelection marked = meshPreviewOf(m_tool->preview()).selected;
  QVERIFY(marked.count() >= 28 && marked.count() <= 33);
  m_tool->perform("commit");
  QCOMPARE(oneStep(before), std::string());
  QCOMPARE(mesh().liveFaceCount(), before.liveFaceCount() - marked.count());
}

void BoundaryToolActionsTest::tellsWhenThereIsNothing() {
  m_tool->pointer(test::above(Kind::Press, 0, 0));
  for (const char* action : {"islands", "peninsulas"}) {
    m_tool->perform(action);
    QVERIFY(!problemOf("faces").empty() && !test::isEnabled(*m_tool, "commit"));
    QCOMPARE(m_tool->perform("commit"), ToolReply::Ignored);
    QCOMPARE(m_tool->perform("revert"), ToolReply::Used);
    QVERIFY(m_tool->loop());  // only the proposal went
  }
  QCOMPARE(m_document->history()->count(), 0);
}

void BoundaryToolActionsTest::keys() {
  std::set<std::string> inputs;
  for (const ToolAction& action : m_tool->actions())
    if (!action.id.empty()) QVERIFY2(inputs.insert(action.input).second, action.input.c_str());
  QCOMPARE(m_tool->perform("smooth"), ToolReply::Ignored);  // nothing is chosen
  m_tool->perform("next");
  const Vertex first = keyOf(mesh(), *m_tool->loop());
  m_tool->perform("next");
  QVERIFY(keyOf(mesh(), *m_tool->loop()) != first);
  m_tool->perform("previous");
  QCOMPARE(keyOf(mesh(), *m_tool->loop()), first);
  QCOMPARE(m_tool->perform("nonsense"), ToolReply::Ignored);
}

void BoundaryToolActionsTest::lateResultsAreNotShown() {
  test::WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(mesh());
  std::function<void()> late;
  {
    BoundaryTool tool(*m_document, waiting.services());
    tool.perform("next");
    tool.perform("smooth");
    QVERIFY(tool.isBusy() && !test::isEnabled(tool, "commit"));
    QCOMPARE(tool.perform("commit"), ToolReply::Ignored);
    const auto first = waiting.work();
    tool.perform("peninsulas");
    first();
    QVERIFY(tool.preview().parts.empty());
    tool.perform("revert");
    QCOMPARE(waiting.cancelled, 2);
    waiting.work()();
    QVERIFY(!tool.isBusy());
    tool.perform("smooth");
    late = waiting.work();
  }
  late();  // the tool is gone
  QCOMPARE(waiting.cancelled, 3);
}

void BoundaryToolActionsTest::followsTheDocument() {
  m_tool->pointer(test::above(Kind::Press, 0, 0));
  m_tool->perform("smooth");
  HalfEdgeMesh closed = mesh();
  FaceSelection all = FaceSelection::all(closed);
  removeFaces(closed, all);
  drag(Vec3(-2, 0, 0), Vec3(-1.5, 0, 0));
  m_document->commit("Elsewhere", inspected(closed));
  QVERIFY(!m_tool->loop() && !m_tool->isBusy());
  QCOMPARE(m_tool->pointer(test::above(Kind::Release, -1.5, 0)), ToolReply::Ignored);
  m_document->history()->undo();
  QCOMPARE(loops(), std::size_t(2));
}

HANDWHEEL_TEST(BoundaryToolActionsTest)
#include "BoundaryToolActionsTest.moc"
