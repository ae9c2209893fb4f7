// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/Document.h"

#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "document/workpiece/WorkpieceKind.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

// Returns everything that a save would write.
std::string stateOf(const Document& document) {
  const auto bytes = containerBytes(document.kind(), document.file(), *document.snapshot(), {}, Compression::None);
  RC_ASSERT(bytes.hasValue());
  return *bytes;
}

// The expected history, by the rules alone: a change is a step; within a stroke, and not across a save, changes of one
// property are one; a change without effect leaves no step.
class ExpectedHistory {
 public:
  explicit ExpectedHistory(std::string first) : m_present(std::move(first)) {}

  // property: of those whose changes merge; empty for anything else.
  void change(std::string after, const std::string& property, DragPhase stroke) {
    const bool isChange = after != m_present;
    if (isChange) {
      if (!m_isStroking) ++m_stroke;
      put({m_present, after, m_stroke, property});
      m_present = std::move(after);
    }
    if (isChange || stroke == DragPhase::Ends) m_isStroking = stroke == DragPhase::Continues;
  }
  void save() {
    m_clean = m_at;
    m_isStroking = false;
  }
  void undo() { m_present = m_steps[--m_at].before; }
  void redo() { m_present = m_steps[m_at++].after; }
  bool canUndo() const { return m_at > 0; }
  bool canRedo() const { return m_at < m_steps.size(); }

  void check(const Document& document) const {
    RC_ASSERT(stateOf(document) == m_present);
    RC_ASSERT(document.history()->count() == static_cast<int>(m_steps.size()));
    RC_ASSERT(document.history()->index() == static_cast<int>(m_at));
    RC_ASSERT(document.isModified() == (m_clean != m_at));
  }

 private:
  struct Step {
    std::string before, after;
    int stroke;
    std::string property;
  };

  void put(Step step) {
    m_steps.resize(m_at);
    if (m_clean && *m_clean > m_at) m_clean.reset();
    const bool merges = m_at > 0 && m_clean != m_at && !step.property.empty() && m_steps.back().stroke == step.stroke &&
                        m_steps.back().property == step.property;
    if (merges) {
      m_steps.back().after = std::move(step.after);
      if (m_steps.back().after == m_steps.back().before) m_steps.pop_back();
    } else {
      m_steps.push_back(std::move(step));
    }
    m_at = m_steps.size();
  }

  std::string m_present;
  std::vector<Step> m_steps;
  std::size_t m_at = 0;
  std::optional<std::size_t> m_clean = 0;
  int m_stroke = 0;
  bool m_isStroking = false;
};

// Undo, redo or save; false if the history disagrees, or it is impossible.
bool walk(Document& document, ExpectedHistory& expected) {
  switch (*rc::gen::inRange(0, 8)) {
    case 0:
    case 1:
      if (!expected.canUndo()) return false;
      document.history()->undo();
      expected.undo();
      return true;
    case 2:
    case 3:
      if (!expected.canRedo()) return false;
      document.history()->redo();
      expected.redo();
      return true;
    case 4:
      document.markSaved("/somewhere/else.handwheel", true);
      expected.save();
      return true;
    default:
      return false;
  }
}

void setProperty(Document& document, ExpectedHistory& expected, const std::string& id, const PropertyValue& value,
                 bool merges) {
  const DragPhase stroke = *rc::gen::arbitrary<bool>() ? DragPhase::Continues : DragPhase::Ends;
  const std::string before = stateOf(document);
  const bool isTaken = document.setProperty(id, value, stroke).hasValue();
  std::string after = stateOf(document);
  RC_ASSERT(isTaken || after == before);
  expected.change(std::move(after), merges ? id : std::string(), stroke);
}

// Few values, so that a stroke often comes back to where it began; some that are refused.
void changeWorkpiece(Document& document, ExpectedHistory& expected) {
  const auto id = *rc::gen::element<std::string>("diameter", "length", "position", "material", "display_unit");
  if (id == "material") {
    return setProperty(document, expected, id, *rc::gen::element<std::string>("", "C45"), true);
  }
  const double number = *rc::gen::element(-1.0, 1.0, 2.0, 50.0);
  setProperty(document, expected, id, number, id != "display_unit");
}

void changeMesh(MeshDocument& document, ExpectedHistory& expected) {
  const auto& loops = document.defects().loops;
  switch (*rc::gen::inRange(0, 4)) {
    case 0: {
      HalfEdgeMesh mesh = document.mesh();
      const auto f = *rc::gen::inRange<Face>(0, static_cast<Face>(mesh.faceSlots()));
      if (mesh.isLive(f)) mesh.removeFace(f);
      relink(mesh);
      document.commit("Remove", inspected(mesh));
      break;
    }
    case 1: {
      HalfEdgeMesh mesh = document.mesh();
      const auto v = *rc::gen::inRange<Vertex>(0, static_cast<Vertex>(mesh.vertexSlots()));
      mesh.setPosition(v, Vec3(0.5, 0.25, *rc::gen::inRange(0, 3)));
      relink(mesh);
      document.commit("Move", inspected(mesh));
      break;
    }
    case 2:
      if (loops.empty()) return;
      document.setKeptOpen(loops[*rc::gen::inRange<std::size_t>(0, loops.size())], *rc::gen::arbitrary<bool>());
      break;
    default:
      return setProperty(document, expected, "display_unit", 1.0 * *rc::gen::inRange(-1, 4), false);
  }
  expected.change(stateOf(document), {}, DragPhase::Ends);
}

template <class Change>
void checkHistory(Document& document, Change change) {
  ExpectedHistory expected(stateOf(document));
  const auto steps = *rc::gen::inRange(1, 40);
  for (int i = 0; i < steps; ++i) {
    if (!walk(document, expected)) change(expected);
    expected.check(document);
  }
  for (; expected.canUndo(); expected.check(document)) {
    document.history()->undo();
    expected.undo();
  }
  for (; expected.canRedo(); expected.check(document)) {
    document.history()->redo();
    expected.redo();
  }
}

// A mesh with two loops.
TriangleSoup holed() {
  TriangleSoup soup = test::uvSphere(6, 8);
  soup.triangles.erase(soup.triangles.begin());
  soup.triangles.pop_back();
  return soup;
}

std::unique_ptr<Document> workpiece() {
  static const WorkpieceKind kind;
  return kind.make(DocumentKinds::blank(kind));
}

}  // namespace

class DocumentTest : public QObject {
  Q_OBJECT

 private slots:
  void historyOfAWorkpiece() {
    QVERIFY(rc::check([] {
      const auto document = workpiece();
      checkHistory(*document, [&](ExpectedHistory& expected) { changeWorkpiece(*document, expected); });
    }));
  }

  void historyOfAMesh() {
    QVERIFY(rc::check([] {
      const auto document = test::meshDocument(holed());
      checkHistory(*document, [&](ExpectedHistory& expected) { changeMesh(*document, expected); });
    }));
  }

  // The slider continues after the save: undo can still return to the saved state.
  void aStrokeThatOutlastsASave() {
    const auto document = workpiece();
    QVERIFY(document->setProperty("diameter", 60.0, DragPhase::Continues));
    document->markSaved("/a.handwheel", true);
    QVERIFY(document->setProperty("diameter", 70.0, DragPhase::Continues));
    QVERIFY(document->setProperty("diameter", 50.0, DragPhase::Ends));
    QVERIFY(document->isModified());  // 50 is where the first part began, not the second
    QCOMPARE(document->history()->count(), 2);
    document->history()->undo();
    QVERIFY(!document->isModified());
    document->history()->undo();
    QVERIFY(document->isModified());
  }

  void aStrokeBackToItsBeginningLeavesNothing() {
    const auto document = workpiece();
    document->markSaved("/a.handwheel", true);
    for (double d : {60.0, 70.0}) QVERIFY(document->setProperty("diameter", d, DragPhase::Continues));
    QVERIFY(document->setProperty("diameter", 50.0, DragPhase::Ends));
    QCOMPARE(document->history()->count(), 0);
    QVERIFY(!document->isModified());
  }

  // A refused value ends the stroke like any other.
  void aStrokeThatEndsWithARefusal() {
    const auto document = workpiece();
    QVERIFY(document->setProperty("diameter", 60.0, DragPhase::Continues));
    QVERIFY(!document->setProperty("diameter", -1.0, DragPhase::Ends));
    QVERIFY(document->setProperty("diameter", 70.0, DragPhase::Ends));
    QCOMPARE(document->history()->count(), 2);
  }

  // While an earlier state was being saved, it was undone: no state is in a file any more.
  void anEarlierStateIsWritten() {
    const auto document = workpiece();
    document->markSaved("/a.handwheel", true, FileTimestamp{1, 1});
    QVERIFY(document->setProperty("diameter", 60.0));
    document->history()->undo();
    QVERIFY(!document->isModified());
    document->markOverwritten(FileTimestamp{2, 2});
    QVERIFY(document->isModified());
    QVERIFY(document->file().stamp == (FileTimestamp{2, 2}));
    QCOMPARE(document->path(), QStringLiteral("/a.handwheel"));
  }

  // A recovered document is compared with the file that it was read from, not with its autosave.
  void whatIsRecoveredKnowsItsFile() {
    const auto document = workpiece();
    document->markRecovered("/a.handwheel", FileTimestamp{3, 4}, true);
    QVERIFY(document->isModified() && document->file().wouldLoseDataOnOverwrite());
    QVERIFY(document->file().stamp == (FileTimestamp{3, 4}));
    document->markSaved("/b.handwheel", true, FileTimestamp{5, 6});
    QVERIFY(!document->isModified() && !document->file().wouldLoseDataOnOverwrite());
    document->markRecovered({});
    QVERIFY(!document->file().stamp);
  }
};

HANDWHEEL_TEST(DocumentTest)
#include "DocumentTest.moc"
