// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/MakeFaceTool.h"

#include "HoleShapes.h"
#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "TestClass.h"
#include "ToolEvents.h"
#include "WaitingServices.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;
using test::Kind;

class MakeFaceToolTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { start(test::plateWithHole()); }
  void threeClicks();
  void clockwiseIsTurned();
  void refuses_data();
  void refuses();
  void stepsBack();
  void onlyPointsOfTheBorder();
  void closesAHole();
  void theMeshChangedMeanwhile();

 private:
  void start(const TriangleSoup& soup);
  ToolReply click(double x, double y) { return m_tool->pointer(test::above(Kind::Press, x, y)); }

  std::unique_ptr<MeshDocument> m_document;
  std::unique_ptr<MakeFaceTool> m_tool;
};

void MakeFaceToolTest::start(const TriangleSoup& soup) {
  m_tool.reset();
  m_document = test::meshDocument(soup);
  m_tool = std::make_unique<MakeFaceTool>(*m_document, immediateServices(*m_document));
  connect(m_document.get(), &Document::changed, this, [this] { m_tool->documentChanged(); });
}

void MakeFaceToolTest::threeClicks() {
  const HalfEdgeMesh before = m_document->mesh();
  QCOMPARE(click(-2, -2), ToolReply::Used);
  QCOMPARE(click(-1, -2), ToolReply::Used);
  m_tool->pointer(test::above(Kind::Hover, -2, -1));
  QCOMPARE(m_tool->problem(), JoinProblem::None);
  QCOMPARE(m_tool->preview().parts.size(), std::size_t(1));
  QVERIFY(test::sameMesh(m_document->mesh(), before));
  QCOMPARE(click(-2, -1), ToolReply::Used);
  const HalfEdgeMesh after = m_document->mesh();
  QCOMPARE(after.liveFaceCount(), before.liveFaceCount() + 1);
  QCOMPARE(validate(after), std::string());
  QCOMPARE(m_document->history()->count(), 1);
  m_document->history()->undo();
  QVERIFY(test::sameMesh(m_document->mesh(), before));
  m_document->history()->redo();
  QVERIFY(test::sameMesh(m_document->mesh(), after));
  QCOMPARE(m_tool->cornerCount(), std::size_t(0));
}

// The face gets the orientation of its neighbours.
void MakeFaceToolTest::clockwiseIsTurned() {
  for (const auto& [x, y] : {std::pair(-2, -1), std::pair(-1, -2), std::pair(-2, -2)}) click(x, y);
  QCOMPARE(m_document->history()->count(), 1);
  const TrianglePoints p = m_document->mesh().points(static_cast<Face>(m_document->mesh().faceSlots() - 1));
  QVERIFY((p[1] - p[0]).cross(p[2] - p[0]).z() > 0.0);
}

void MakeFaceToolTest::refuses_data() {
  QTest::addColumn<QPointF>("first");
  QTest::addColumn<QPointF>("second");
  QTest::addColumn<QPointF>("third");
  QTest::newRow("touches in points") << QPointF(-2, 0) << QPointF(0, -2) << QPointF(2, 0);
  QTest::newRow("far corner") << QPointF(-1, -2) << QPointF(0, -2) << QPointF(0, 2);
  QTest::newRow("a line") << QPointF(-1, -2) << QPointF(0, -2) << QPointF(1, -2);
  QTest::newRow("on the plate") << QPointF(-5, -5) << QPointF(-4, -5) << QPointF(-5, -4);
  QTest::newRow("the first again") << QPointF(-2, -2) << QPointF(-1, -2) << QPointF(-2, -2);
}

void MakeFaceToolTest::refuses() {
  QFETCH(QPointF, first);
  QFETCH(QPointF, second);
  QFETCH(QPointF, third);
  const HalfEdgeMesh before = m_document->mesh();
  for (const QPointF& p : {first, second, third}) click(p.x(), p.y());
  QVERIFY(m_tool->problem() != JoinProblem::None);
  QVERIFY(!m_tool->settings().at(0).problem.empty());
  QVERIFY(m_tool->preview().parts.empty());
  QCOMPARE(m_document->history()->count(), 0);
  QVERIFY(test::sameMesh(m_document->mesh(), before));
  QCOMPARE(m_tool->cornerCount(), std::size_t(2));  // another third corner may do
}

void MakeFaceToolTest::stepsBack() {
  QVERIFY(!test::isEnabled(*m_tool, "back"));
  click(-2, -2);
  click(-1, -2);
  QCOMPARE(m_tool->perform("back"), ToolReply::Used);
  QCOMPARE(m_tool->cornerCount(), std::size_t(1));
  QCOMPARE(m_tool->perform("revert"), ToolReply::Used);
  QCOMPARE(m_tool->cornerCount(), std::size_t(0));
  QCOMPARE(m_tool->perform("revert"), ToolReply::Finished);
  QCOMPARE(m_tool->perform("back"), ToolReply::Ignored);
  PointerEvent event = test::above(Kind::Press, -2, -2);
  click(-2, -2);
  event.button = PointerButton::Second;
  event.device = Pose::Identity();
  QCOMPARE(m_tool->pointer(event), ToolReply::Used);
  QCOMPARE(m_tool->cornerCount(), std::size_t(0));
}

void MakeFaceToolTest::onlyPointsOfTheBorder() {
  QCOMPARE(click(-3, -3), ToolReply::Ignored);
  QCOMPARE(click(0, 0), ToolReply::Ignored);
  click(-2, -2);
  click(-2, -2);
  QCOMPARE(m_tool->cornerCount(), std::size_t(1));
}

void MakeFaceToolTest::closesAHole() {
  start(test::plateWithout(4, [](double x, double y) { return std::hypot(x - 1.0 / 3, y - 2.0 / 3) < 0.1; }));
  QCOMPARE(m_document->defects().loops.size(), std::size_t(2));
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 1), std::pair(0, 1)}) click(x, y);
  QCOMPARE(m_document->defects().loops.size(), std::size_t(1));
  QCOMPARE(validate(m_document->mesh()), std::string());
}

void MakeFaceToolTest::theMeshChangedMeanwhile() {
  test::WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(m_document->mesh());
  m_tool = std::make_unique<MakeFaceTool>(*m_document, waiting.services());
  for (const auto& [x, y] : {std::pair(-2, -2), std::pair(-1, -2), std::pair(-2, -1)}) click(x, y);
  HalfEdgeMesh empty, once = m_document->mesh();
  waiting.changes.at(0).apply(empty, {});
  QCOMPARE(empty.faceSlots(), std::size_t(0));
  waiting.changes.at(0).apply(once, {});
  HalfEdgeMesh twice = once;
  waiting.changes.at(0).apply(twice, {});
  QVERIFY(test::sameMesh(once, twice) && !test::sameMesh(once, m_document->mesh()));
}

HANDWHEEL_TEST(MakeFaceToolTest)
#include "MakeFaceToolTest.moc"
