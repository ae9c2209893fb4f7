// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/FillHoleTool.h"

#include "FillServices.h"
#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "ToolEvents.h"
#include "mesh/structure/MeshValidator.h"
#include "tools/ToolRunner.h"

#include <QTest>

using namespace handwheel;
using test::Kind;

class FillHoleToolTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void clickShowsAPatch();
  void fillsOneAfterTheOther();
  void nextAndPrevious();
  void keepsOpen();
  void escTakesThePreviewBack();
  void tellsWhyNot();
  void lateAnswersAreNotShown();
  void followsTheDocument();
  void whileTheWorkerCommits();
  void quickerThanThePatch();
  void deviceButton();
  void nothingToFill();

 private:
  void start(const TriangleSoup& soup);
  void follow();
  std::vector<BoundaryLoop> loops() const { return m_document->defects().loops; }
  Vertex key(std::size_t i) const { return keyOf(m_document->mesh(), m_document->defects().loops.at(i)); }
  // The key of the hole that is chosen.
  Vertex chosen() const { return m_tool->loop() ? keyOf(m_document->mesh(), *m_tool->loop()) : kNone; }

  std::unique_ptr<MeshDocument> m_document;
  FillHoleTool* m_answering = nullptr;
  std::unique_ptr<FillHoleTool> m_tool;
};

using State = FillHoleTool::State;

void FillHoleToolTest::init() {
  start(test::sphereWithHoles(3, 4, 0.3));
  QCOMPARE(loops().size(), std::size_t(4));
}

void FillHoleToolTest::start(const TriangleSoup& soup) {
  m_answering = nullptr;
  m_document = test::meshDocument(soup);
  m_tool = std::make_unique<FillHoleTool>(*m_document, test::fillServices(*m_document, m_answering));
  m_answering = m_tool.get();
  follow();
}

void FillHoleToolTest::follow() {
  connect(m_document.get(), &Document::changed, this, [this] { m_tool->documentChanged(); });
}

void FillHoleToolTest::clickShowsAPatch() {
  start(test::sphereWithoutCap(3));
  const HalfEdgeMesh before = m_document->mesh();
  QCOMPARE(m_tool->pointer(test::above(Kind::Hover, 0, 0)), ToolReply::Used);
  QCOMPARE(m_tool->preview().lines.size(), std::size_t(1));
  QCOMPARE(m_tool->pointer(test::above(Kind::Press, 0.7, 0)), ToolReply::Ignored);  // no hole there
  QVERIFY(m_tool->state() == State::Choosing && !test::isEnabled(*m_tool, "commit"));
  QCOMPARE(m_tool->pointer(test::above(Kind::Press, 0, 0)), ToolReply::Used);
  QVERIFY(m_tool->state() == State::Ready && test::isEnabled(*m_tool, "commit"));
  const ToolPreview preview = m_tool->preview();
  QCOMPARE(preview.parts.size(), std::size_t(1));
  QCOMPARE(preview.lines.size(), std::size_t(1));
  // The patch has the loop as its border, and closes the sphere to what a unit sphere is, but for the flat triangles.
  TriangleSoup closed = m_document->mesh().compact().soup;
  test::append(closed, *preview.parts[0].soup);
  QVERIFY(test::countEdges(closed).sound());
  QVERIFY(std::abs(test::volume(closed) - 4.0 / 3.0 * M_PI) < 0.08);
  QVERIFY(test::sameMesh(m_document->mesh(), before));
  QCOMPARE(m_document->history()->count(), 0);
  m_tool->pointer(test::above(Kind::Leave, 0, 0));
  QCOMPARE(m_tool->preview().lines.size(), std::size_t(1));  // the line of the chosen one stays
}

void FillHoleToolTest::fillsOneAfterTheOther() {
  const HalfEdgeMesh before = m_document->mesh();
  m_tool->perform("next");
  for (int left = 3; left >= 0; --left) {
    QVERIFY(m_tool->state() == State::Ready);
    QCOMPARE(m_tool->perform("commit"), left > 0 ? ToolReply::Used : ToolReply::Finished);
    QCOMPARE(loops().size(), std::size_t(left));
    QCOMPARE(validate(m_document->mesh()), std::string());
  }
  QVERIFY(test::countEdges(m_document->mesh()).sound());
  QCOMPARE(m_document->history()->count(), 4);
  m_document->history()->setIndex(0);
  QVERIFY(test::sameMesh(m_document->mesh(), before));
}

void FillHoleToolTest::nextAndPrevious() {
  for (const std::size_t i : {0, 1, 2, 3, 0}) {
    m_tool->perform("next");
    QCOMPARE(chosen(), key(i));
  }
  for (const std::size_t i : {3, 2}) {
    m_tool->perform("previous");
    QCOMPARE(chosen(), key(i));
  }
  m_tool->perform("revert");
  m_tool->perform("previous");
  QCOMPARE(chosen(), key(3));
  const FillHoleTool other(*m_document, test::fillServices(*m_document, m_answering), key(2));
  QVERIFY(other.loop() == &m_document->defects().loops[2]);
}

void FillHoleToolTest::keepsOpen() {
  m_tool->perform("next");
  m_tool->perform("next");
  m_tool->perform("keep");
  QVERIFY(m_document->isKeptOpen(loops()[1]));
  QCOMPARE(chosen(), key(2));
  m_tool->perform("previous");
  QCOMPARE(chosen(), key(0));  // past the one that stays open
  m_document->history()->undo();
  m_tool->perform("next");
  QCOMPARE(chosen(), key(1));
  for (int i = 0; i < 4; ++i) m_tool->perform("keep");
  QVERIFY(m_tool->state() == State::Choosing);
  QVERIFY(!test::isEnabled(*m_tool, "next") && !test::isEnabled(*m_tool, "keep"));
  QCOMPARE(m_tool->perform("keep"), ToolReply::Ignored);
}

void FillHoleToolTest::escTakesThePreviewBack() {
  m_tool->perform("next");
  QCOMPARE(m_tool->perform("revert"), ToolReply::Used);
  QVERIFY(m_tool->state() == State::Choosing && m_tool->preview().parts.empty());
  QCOMPARE(m_tool->perform("commit"), ToolReply::Ignored);
  QCOMPARE(m_tool->perform("revert"), ToolReply::Finished);
  QCOMPARE(m_document->history()->count(), 0);
}

void FillHoleToolTest::tellsWhyNot() {
  FillServices services = test::fillServices(*m_document, m_answering);
  std::uint64_t ticket = 0;
  services.request = [&](const FillRequest& request) { ticket = request.ticket; };
  FillHoleTool tool(*m_document, services);
  const auto reason = [&] { return test::propertyNamed(tool.settings(), "triangles")->problem; };
  std::set<std::string> reasons;
  for (int failure = 1; failure <= int(FillFailure::NarrowTriangles); ++failure) {
    tool.perform("next");
    QVERIFY(tool.state() == State::Computing && reason().empty());
    tool.previewReady(ticket, {FillFailure(failure), {}});
    QVERIFY(tool.state() == State::Impossible && !test::isEnabled(tool, "commit"));
    QCOMPARE(tool.perform("commit"), ToolReply::Ignored);
    QVERIFY(tool.preview().parts.empty());
    reasons.insert(reason());
  }
  QCOMPARE(reasons.size(), std::size_t(FillFailure::NarrowTriangles));
  QVERIFY(!reasons.contains(""));
}

void FillHoleToolTest::lateAnswersAreNotShown() {
  std::vector<FillRequest> requests;
  FillServices services = test::fillServices(*m_document, m_answering);
  services.request = [&](const FillRequest& request) { requests.push_back(request); };
  FillHoleTool tool(*m_document, services);
  int updates = 0;
  tool.whenUpdated([&] { ++updates; });
  tool.perform("next");
  tool.perform("next");
  QCOMPARE(requests.size(), std::size_t(2));
  const FillAttempt answer = HoleFiller(m_document->mesh()).propose(requests[0].loop, {});
  tool.previewReady(requests[0].ticket, answer);
  QVERIFY(tool.state() == State::Computing);
  tool.previewReady(requests[1].ticket, HoleFiller(m_document->mesh()).propose(requests[1].loop, {}));
  QVERIFY(tool.state() == State::Ready);
  tool.previewReady(requests[1].ticket, {FillFailure::NoPatch, {}});  // twice
  QVERIFY(tool.state() == State::Ready);
  QCOMPARE(updates, 1);
  tool.perform("next");
  tool.perform("revert");
  tool.previewReady(requests[2].ticket, answer);
  QVERIFY(tool.state() == State::Choosing && tool.preview().parts.empty());
}

void FillHoleToolTest::followsTheDocument() {
  m_tool->perform("next");
  m_tool->perform("next");
  const Vertex second = key(1), third = key(2);
  // Somebody else fills the first: the second stays chosen, and is looked at anew.
  HoleFiller first(m_document->mesh());
  first.accept(loops()[0], first.propose(loops()[0], {}).patch);
  m_document->commit("Elsewhere", inspected(first.mesh()));
  QCOMPARE(chosen(), second);
  QVERIFY(m_tool->state() == State::Ready);
  // The chosen one goes: the next is chosen.
  HoleFiller filler(m_document->mesh());
  filler.accept(loops()[0], filler.propose(loops()[0], {}).patch);
  m_document->commit("Elsewhere", inspected(filler.mesh()));
  QCOMPARE(chosen(), third);
}

void FillHoleToolTest::whileTheWorkerCommits() {
  FillServices services = test::fillServices(*m_document, m_answering);
  std::function<void()> later;
  const auto now = services.commit;
  services.commit = [&](const BoundaryLoop& loop, const FillAttempt& attempt) {
    later = [=] { now(loop, attempt); };
    return true;
  };
  m_tool = std::make_unique<FillHoleTool>(*m_document, services);
  m_answering = m_tool.get();
  m_tool->perform("next");
  QCOMPARE(m_tool->perform("commit"), ToolReply::Used);
  QVERIFY(m_tool->state() == State::Committing && !test::isEnabled(*m_tool, "commit"));
  QCOMPARE(m_tool->perform("commit"), ToolReply::Ignored);
  const Vertex second = key(1);
  later();
  QCOMPARE(loops().size(), std::size_t(3));
  QCOMPARE(chosen(), second);
  QVERIFY(m_tool->state() == State::Ready);
}

// Whoever presses Enter before the patch is there gets it as soon as it is; where the owner is busy, it stays as it
// was.
void FillHoleToolTest::quickerThanThePatch() {
  FillServices services = test::fillServices(*m_document, m_answering);
  std::vector<FillRequest> requests;
  bool isFree = false;
  services.request = [&](const FillRequest& request) { requests.push_back(request); };
  const auto now = services.commit;
  services.commit = [&](const BoundaryLoop& loop, const FillAttempt& attempt) { return isFree && now(loop, attempt); };
  m_tool = std::make_unique<FillHoleTool>(*m_document, services);
  const auto answer = [&] {
    const FillRequest asked = requests.back();
    m_tool->previewReady(asked.ticket, HoleFiller(m_document->mesh()).propose(asked.loop, {}));
  };
  m_tool->perform("next");
  QVERIFY(m_tool->state() == State::Computing && test::isEnabled(*m_tool, "commit"));
  answer();
  QVERIFY(m_tool->state() == State::Ready);
  QCOMPARE(m_tool->perform("commit"), ToolReply::Ignored);
  QVERIFY(m_tool->state() == State::Ready && m_tool->preview().parts.size() == 1);
  QCOMPARE(loops().size(), std::size_t(4));

  isFree = true;
  m_tool->perform("next");
  QCOMPARE(m_tool->perform("commit"), ToolReply::Used);
  QCOMPARE(loops().size(), std::size_t(4));
  answer();
  QCOMPARE(loops().size(), std::size_t(3));
  QVERIFY(m_tool->state() == State::Computing);  // the next hole
  answer();
  QVERIFY(m_tool->state() == State::Ready);  // no fill was requested
  QCOMPARE(loops().size(), std::size_t(3));
}

void FillHoleToolTest::deviceButton() {
  PointerEvent event = test::above(Kind::Press, 0, 0);
  event.button = PointerButton::Second;
  m_tool->perform("next");
  QCOMPARE(m_tool->pointer(event), ToolReply::Ignored);
  event.device = Pose::Identity();
  QCOMPARE(m_tool->pointer(event), ToolReply::Used);
  QCOMPARE(loops().size(), std::size_t(3));
}

void FillHoleToolTest::nothingToFill() {
  start(test::icosphere(2));
  m_tool->perform("next");
  m_tool->perform("previous");
  QVERIFY(m_tool->state() == State::Choosing && !m_tool->loop());
  QCOMPARE(m_tool->pointer(test::above(Kind::Press, 0, 0)), ToolReply::Ignored);
  start({});
  m_tool->perform("next");
  m_tool->pointer(test::above(Kind::Hover, 0, 0));
  QVERIFY(m_tool->state() == State::Choosing);
  start(test::disc(12, 3));  // only a rim: left open unless one asks for it
  m_tool->perform("next");
  QVERIFY(m_tool->state() == State::Choosing);
  m_tool->pointer(test::above(Kind::Press, 1.0, 0.02));
  QVERIFY(m_tool->loop() && m_tool->loop()->isSheetBoundary);
}

HANDWHEEL_TEST(FillHoleToolTest)
#include "FillHoleToolTest.moc"
