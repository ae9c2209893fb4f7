// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/ToolRunner.h"

#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "ToolEvents.h"

#include <QSignalSpy>
#include <QTest>
#include <stdexcept>

using namespace handwheel;
using test::Kind;

class ToolRunnerTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void routesToTheTool();
  void onlyWhatIsDeclaredAndPossibleIsDone();
  void finishedMeansTheEnd();
  void aToolThatThrowsIsDropped_data();
  void aToolThatThrowsIsDropped();
  void itsOwnEditsAreTakenBack();
  void othersEditsStay();
  void theDocumentGoes();
  void theDocumentGoesDuringACall();
  void stopsItselfDuringACall();
  void aNewToolTakesItsPlace();
  void settlesBeforeItEnds();
  void whatFailsIsNotSettled();
  void jobsAreProtected();

 private:
  std::unique_ptr<MeshDocument> m_document;
};

namespace {

void edit(MeshDocument& document, Face f) {
  HalfEdgeMesh mesh = document.mesh();
  mesh.removeFace(f);
  document.commit("Edit", inspected(mesh));
}

// A tool that records its input, and acts as the test requires.
class Probe : public Tool {
 public:
  struct Notes {
    std::vector<std::string> calls;
    std::function<ToolReply()> onPointer = [] { return ToolReply::Used; };
    std::function<void()> onChange = [] {};
    std::function<void()> onSettle = [] {};
    bool isEnabled = true;
    bool isGone = false;
    Tool* tool = nullptr;
  };
  explicit Probe(Notes& notes) : m_notes(notes) { notes.tool = this; }
  ~Probe() override { m_notes.isGone = true; }

  std::string id() const override { return "probe"; }
  ToolReply pointer(const PointerEvent&) override {
    m_notes.calls.push_back("pointer");
    return m_notes.onPointer();
  }
  ToolReply perform(std::string_view action) override {
    m_notes.calls.push_back("perform " + std::string(action));
    return action == "commit" ? ToolReply::Finished : ToolReply::Used;
  }
  std::vector<ToolAction> actions() const override {
    return {{"", "Click", "nothing"},
            {"commit", "Return", "take"},
            {"flip", "F", "turn over", m_notes.isEnabled},
            {"revert", "Esc", "leave"}};
  }
  void setSetting(std::string_view id, const PropertyValue&) override {
    m_notes.calls.push_back("set " + std::string(id));
  }
  void documentChanged() override {
    m_notes.calls.push_back("changed");
    m_notes.onChange();
  }
  void settle() override { m_notes.onSettle(); }
  void tell() { reportUpdated(); }

 private:
  Notes& m_notes;
};

}  // namespace

void ToolRunnerTest::init() {
  m_document = test::meshDocument(test::icosphere(1));
}

void ToolRunnerTest::routesToTheTool() {
  ToolRunner runner;
  QSignalSpy updated(&runner, &ToolRunner::updated);
  Probe::Notes notes;
  QCOMPARE(runner.pointer({}), ToolReply::Ignored);
  QCOMPARE(runner.perform("commit"), ToolReply::Ignored);
  runner.setSetting("size", 1.0);
  runner.start(std::make_unique<Probe>(notes), *m_document);
  QVERIFY(runner.tool() == notes.tool && runner.document() == m_document.get());
  QCOMPARE(runner.pointer({}), ToolReply::Used);
  QCOMPARE(runner.perform("flip"), ToolReply::Used);
  runner.setSetting("size", 1.0);
  edit(*m_document, 3);
  static_cast<Probe*>(notes.tool)->tell();
  QCOMPARE(updated.count(), 6);
  QCOMPARE(notes.calls, (std::vector<std::string>{"pointer", "perform flip", "set size", "changed"}));
}

void ToolRunnerTest::onlyWhatIsDeclaredAndPossibleIsDone() {
  ToolRunner runner;
  Probe::Notes notes;
  runner.start(std::make_unique<Probe>(notes), *m_document);
  QCOMPARE(runner.perform("flip"), ToolReply::Used);
  QCOMPARE(runner.perform("Click"), ToolReply::Ignored);  // a hint is no action
  notes.isEnabled = false;
  for (const char* action : {"flip", "unknown", ""}) QCOMPARE(runner.perform(action), ToolReply::Ignored);
  QCOMPARE(notes.calls, std::vector<std::string>{"perform flip"});
}

void ToolRunnerTest::finishedMeansTheEnd() {
  ToolRunner runner;
  QSignalSpy ended(&runner, &ToolRunner::ended);
  Probe::Notes notes;
  runner.start(std::make_unique<Probe>(notes), *m_document);
  QCOMPARE(runner.perform("commit"), ToolReply::Finished);
  QVERIFY(notes.isGone && !runner.tool() && !runner.document());
  QCOMPARE(ended.count(), 1);
  edit(*m_document, 3);  // there is no listener any more
  QCOMPARE(notes.calls, std::vector<std::string>{"perform commit"});
}

void ToolRunnerTest::aToolThatThrowsIsDropped_data() {
  QTest::addColumn<bool>("isStandard");
  QTest::newRow("exception") << true;
  QTest::newRow("anything") << false;
}

void ToolRunnerTest::aToolThatThrowsIsDropped() {
  QFETCH(bool, isStandard);
  ToolRunner runner;
  QSignalSpy ended(&runner, &ToolRunner::ended), failed(&runner, &ToolRunner::failed);
  Probe::Notes notes;
  notes.onPointer = [=]() -> ToolReply {
    if (isStandard) throw std::runtime_error("out of luck");
    throw 7;
  };
  runner.start(std::make_unique<Probe>(notes), *m_document);
  QCOMPARE(runner.pointer({}), ToolReply::Used);
  QVERIFY(notes.isGone && !runner.tool());
  QCOMPARE(ended.count(), 1);
  QCOMPARE(failed.count(), 1);
  QCOMPARE(failed[0][0].toString(), isStandard ? QString("out of luck") : QString("unknown exception"));
}

// An edit, then the failure, in the same event; also if the failure is the reaction to the edit.
void ToolRunnerTest::itsOwnEditsAreTakenBack() {
  for (const bool inAnswer : {false, true}) {
    const HalfEdgeMesh before = m_document->mesh();
    const int index = m_document->history()->index();
    ToolRunner runner;
    QSignalSpy failed(&runner, &ToolRunner::failed);
    Probe::Notes notes;
    notes.onPointer = [&]() -> ToolReply {
      edit(*m_document, 5);
      edit(*m_document, 6);
      if (!inAnswer) throw std::runtime_error("too late");
      return ToolReply::Finished;
    };
    if (inAnswer) notes.onChange = [] { throw std::runtime_error("too late"); };
    runner.start(std::make_unique<Probe>(notes), *m_document);
    runner.pointer({});
    QCOMPARE(failed.count(), 1);
    QVERIFY(notes.isGone);
    QVERIFY(test::sameMesh(m_document->mesh(), before));
    QCOMPARE(m_document->history()->index(), index);
  }
}

void ToolRunnerTest::othersEditsStay() {
  ToolRunner runner;
  Probe::Notes notes;
  runner.start(std::make_unique<Probe>(notes), *m_document);
  runner.pointer({});
  edit(*m_document, 5);
  notes.onPointer = []() -> ToolReply { throw std::runtime_error("now"); };
  runner.pointer({});
  QVERIFY(notes.isGone);
  QVERIFY(!m_document->mesh().isLive(5));
}

void ToolRunnerTest::theDocumentGoes() {
  ToolRunner runner;
  QSignalSpy ended(&runner, &ToolRunner::ended);
  Probe::Notes notes;
  runner.start(std::make_unique<Probe>(notes), *m_document);
  m_document.reset();
  QVERIFY(notes.isGone && !runner.tool());
  QCOMPARE(ended.count(), 1);
  QCOMPARE(runner.pointer({}), ToolReply::Ignored);
  QVERIFY(notes.calls.empty());
}

void ToolRunnerTest::theDocumentGoesDuringACall() {
  for (const bool throws : {false, true}) {
    init();
    ToolRunner runner;
    Probe::Notes notes;
    notes.onPointer = [&] {
      m_document.reset();
      if (notes.isGone) qFatal("The tool went while it was at work.");
      if (throws) throw std::runtime_error("gone");
      return ToolReply::Used;
    };
    runner.start(std::make_unique<Probe>(notes), *m_document);
    runner.pointer({});
    QVERIFY(notes.isGone && !runner.tool());
  }
}

void ToolRunnerTest::stopsItselfDuringACall() {
  ToolRunner runner;
  Probe::Notes notes;
  notes.onPointer = [&] {
    runner.stop();
    if (notes.isGone) qFatal("The tool went while it was at work.");
    return ToolReply::Used;
  };
  runner.start(std::make_unique<Probe>(notes), *m_document);
  runner.pointer({});
  QVERIFY(notes.isGone && !runner.tool());
}

void ToolRunnerTest::aNewToolTakesItsPlace() {
  ToolRunner runner;
  QSignalSpy ended(&runner, &ToolRunner::ended);
  Probe::Notes first, second;
  runner.start(std::make_unique<Probe>(first), *m_document);
  const auto other = test::meshDocument(test::icosphere(1));
  runner.start(std::make_unique<Probe>(second), *other);
  QVERIFY(first.isGone && !second.isGone);
  QCOMPARE(ended.count(), 1);
  edit(*m_document, 3);
  QVERIFY(second.calls.empty());
  edit(*other, 3);
  QCOMPARE(second.calls, std::vector<std::string>{"changed"});
  m_document.reset();
  QVERIFY(!second.isGone);
}

// The work is settled for any end of the tool, while its document lives; and whenever the document requests it.
void ToolRunnerTest::settlesBeforeItEnds() {
  ToolRunner runner;
  Probe::Notes notes, other;
  int settled = 0;
  notes.onSettle = [&] {
    if (notes.isGone) qFatal("The tool went before it could settle.");
    if (settled++ == 0) edit(*m_document, 5);
  };
  runner.start(std::make_unique<Probe>(notes), *m_document);
  m_document->settle();
  QCOMPARE(settled, 1);
  QVERIFY(!m_document->mesh().isLive(5) && runner.tool());
  runner.start(std::make_unique<Probe>(other), *m_document);
  QCOMPARE(settled, 2);
  QVERIFY(notes.isGone);
  m_document->settle();
  QCOMPARE(settled, 2);
  notes.isGone = false;
  runner.start(std::make_unique<Probe>(notes), *m_document);
  QCOMPARE(runner.perform("commit"), ToolReply::Finished);
  QCOMPARE(settled, 3);
  notes.isGone = false;
  runner.start(std::make_unique<Probe>(notes), *m_document);
  m_document.reset();
  QVERIFY(notes.isGone);
  QCOMPARE(settled, 3);
}

void ToolRunnerTest::whatFailsIsNotSettled() {
  ToolRunner runner;
  QSignalSpy failed(&runner, &ToolRunner::failed);
  Probe::Notes notes;
  int settled = 0;
  notes.onSettle = [&] { ++settled; };
  notes.onPointer = []() -> ToolReply { throw std::runtime_error("now"); };
  runner.start(std::make_unique<Probe>(notes), *m_document);
  runner.pointer({});
  QCOMPARE(settled, 0);
  notes.isGone = false;
  notes.onSettle = [&] {
    edit(*m_document, 6);
    throw std::runtime_error("full");
  };
  runner.start(std::make_unique<Probe>(notes), *m_document);
  runner.stop();
  QVERIFY(notes.isGone && !runner.tool());
  QCOMPARE(failed.count(), 2);
  QVERIFY(m_document->mesh().isLive(6));
}

void ToolRunnerTest::jobsAreProtected() {
  ToolRunner runner;
  QSignalSpy updated(&runner, &ToolRunner::updated), failed(&runner, &ToolRunner::failed);
  Probe::Notes notes;
  runner.start(std::make_unique<Probe>(notes), *m_document);
  bool delivered = false;
  runner.deliver([&] { delivered = true; });
  QVERIFY(delivered);
  QCOMPARE(updated.count(), 2);
  runner.deliver([] { throw std::bad_alloc(); });
  QCOMPARE(failed.count(), 1);
  QVERIFY(notes.isGone);
  delivered = false;
  runner.deliver([&] { delivered = true; });
  QVERIFY(!delivered);  // there is nobody to whom it could be
}

HANDWHEEL_TEST(ToolRunnerTest)
#include "ToolRunnerTest.moc"
