// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyChanges.h"

#include "Shelf.h"
#include "TestClass.h"
#include "document/scene/BodyEdit.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

template <class T>
ErrorCode codeOf(const Result<T>& result) {
  return result ? ErrorCode::Cancelled : result.error().code;
}

// One step of a user, of any sort. Returns false where it changes nothing.
bool anyStep(ShelfDocument& document, DragPhase phase) {
  const BodySet& bodies = document.bodies();
  std::unique_ptr<Edit> edit;
  const int what = *rc::gen::inRange(0, 4);
  if (what == 0 || bodies.empty()) {
    edit = valueOf(addBodyEdit(bodies, anyBody(bodies)));
  } else {
    const BodyPointer chosen = *(bodies.begin() + *rc::gen::inRange<long>(0, long(bodies.size())));
    Body changed = *chosen;
    if (what == 1) changed.pose = anyPose();
    if (what == 2) changed.name = freeBodyName(bodies, *rc::gen::element<std::string>("vice", "table"));
    if (what == 3) {
      const BodyId ids[] = {chosen->id, (*bodies.begin())->id};
      edit = *rc::gen::arbitrary<bool>() ? removeBodiesEdit(bodies, ids) : showBodiesEdit(bodies, ids, false);
    } else {
      edit = valueOf(changeBodyEdit(bodies, std::move(changed)));
    }
  }
  if (!edit) return false;
  document.commit("Step", std::move(edit), phase);
  return true;
}

}  // namespace

class BodyChangesTest : public QObject {
  Q_OBJECT

 private slots:
  void undoAndRedoAreInverse() {
    const auto same = [](const BodySet& a, const BodySet& b) { return a == b && a.freeId() == b.freeId(); };
    QVERIFY(rc::check("undo and redo", [&] {
      const auto document = newShelf();
      std::vector<BodySet> states{document->bodies()};
      for (int i = *rc::gen::inRange(0, 15); i > 0; --i) {
        const int before = document->history()->count();
        const auto phase = *rc::gen::arbitrary<bool>() ? DragPhase::Continues : DragPhase::Ends;
        if (!anyStep(*document, phase)) continue;
        if (document->history()->count() == before) states.back() = document->bodies();
        if (document->history()->count() > before) states.push_back(document->bodies());
      }
      RC_ASSERT(states.size() == std::size_t(document->history()->count()) + 1);
      for (std::size_t i = states.size(); i-- > 1;) {
        RC_ASSERT(same(document->bodies(), states[i]));
        document->history()->undo();
      }
      RC_ASSERT(same(document->bodies(), states[0]));
      for (std::size_t i = 1; i < states.size(); ++i) {
        document->history()->redo();
        RC_ASSERT(same(document->bodies(), states[i]));
      }
    }));
  }

  void twoBodiesMovedAndRenamed() {
    const auto document = newShelf();
    add(*document, body("vice"));
    add(*document, body("table"));
    QSignalSpy changed(document.get(), &Document::changed);
    QVERIFY(document->setProperty("body.1.x", 12.5).hasValue());
    QVERIFY(document->setProperty("body.2.name", std::string("bench")).hasValue());
    QCOMPARE(changed.count(), 2);
    QCOMPARE(document->bodies().withId(1)->pose.translation(), Vec3(12.5, 0, 0));
    QCOMPARE(document->bodies().withId(2)->name, "bench");
    for (int i = 0; i < 2; ++i) document->history()->undo();
    QCOMPARE(document->bodies().withId(1)->pose.translation(), Vec3(0, 0, 0));
    QCOMPARE(document->bodies().withId(2)->name, "table");
  }

  void aDragIsOneStep() {
    const auto document = newShelf();
    add(*document, body("vice"));
    for (double x : {1.0, 2.0, 3.0}) QVERIFY(document->setProperty("body.1.x", x, DragPhase::Continues).hasValue());
    QVERIFY(document->setProperty("body.1.x", 4.0).hasValue());
    QCOMPARE(document->history()->count(), 2);
    document->history()->undo();
    QCOMPARE(document->bodies().withId(1)->pose.translation().x(), 0.0);
  }

  void aMoveSharesTheShapeAndCostsOneBody() {
    const auto document = newShelf();
    TriangleSoup soup;
    for (int i = 0; i < 30'000; ++i) soup.points.emplace_back(i, i % 7, i % 11);
    for (std::uint32_t i = 0; i + 2 < 30'000; ++i) soup.triangles.push_back({i, i + 1, i + 2});
    const auto shape = std::make_shared<const MeshGeometry>(std::move(soup));
    add(*document, body("scan", shape));
    Body moved = *document->bodies().withId(1);
    moved.pose.translation().x() = 5.0;
    auto edit = valueOf(changeBodyEdit(document->bodies(), moved));
    edit->exchange(*document);
    QCOMPARE(document->bodies().withId(1)->geometry, GeometryPointer(shape));
    QVERIFY(edit->bytes() < 2000);
  }

  void numbersOfRemovedBodiesAreNotUsedAgain() {
    const auto document = newShelf();
    add(*document, body("a"));
    const BodyId ids[] = {1};
    document->commit("Remove", removeBodiesEdit(document->bodies(), ids));
    add(*document, body("b"));
    QCOMPARE((*document->bodies().begin())->id, 2u);
  }

  // Else the same commands after an undo would make another file.
  void undoGivesTheNumberBack() {
    const auto document = newShelf();
    add(*document, body("a"));
    document->history()->undo();
    QCOMPARE(document->bodies().freeId(), 1u);
    add(*document, body("b"));
    QCOMPARE((*document->bodies().begin())->id, 1u);
  }

  void namesAreChecked() {
    const auto document = newShelf();
    add(*document, body("vice"));
    const auto adding = [&](const std::string& name) { return codeOf(addBodyEdit(document->bodies(), body(name))); };
    QCOMPARE(adding("vice"), BodyError::NameTaken);
    for (const std::string& wrong :
         {std::string(), std::string(" "), std::string(" a"), std::string("a\nb"), std::string("\xff"),
          std::string("a\0b", 3), std::string(kLongestBodyName + 1, 'a')}) {
      QCOMPARE(adding(wrong), BodyError::NameUnusable);
    }
    QCOMPARE(adding(std::string(kLongestBodyName, 'a')), ErrorCode::Cancelled);
    QCOMPARE(adding("Tür"), ErrorCode::Cancelled);
  }

  void freeNames() {
    BodySet bodies;
    const auto take = [&](const std::string& preferred) {
      Body made = body(freeBodyName(bodies, preferred));
      made.id = bodies.freeId();
      bodies = bodies.with(std::make_shared<const Body>(made));
      return made.name;
    };
    QCOMPARE(take("vice"), "vice");
    QCOMPARE(take("vice"), "vice 2");
    QCOMPARE(take("vice"), "vice 3");
    QCOMPARE(take("vice 2"), "vice 2 2");
    QCOMPARE(take(""), "body");
    std::string longest;
    while (longest.size() + 2 <= kLongestBodyName) longest += "ü";
    QCOMPARE(take(longest), longest);
    QVERIFY(isBodyName(take(longest)));
  }

  void posesAreChecked() {
    const BodySet none;
    const auto adding = [&](const Pose& pose) {
      Body made = body("a");
      made.pose = pose;
      return codeOf(addBodyEdit(none, made));
    };
    for (double wrong : {std::nan(""), double(INFINITY), 2 * kFarthestBody}) {
      Pose pose = Pose::Identity();
      pose.translation().z() = wrong;
      QCOMPARE(adding(pose), ErrorCode::ValueOutOfRange);
    }
    Pose scaled = Pose::Identity();
    scaled.linear() *= 2.0;
    QCOMPARE(adding(scaled), ErrorCode::ElementMalformed);
  }

  void whatIsNotThereAndWhatStays() {
    const auto document = newShelf();
    add(*document, body("a"));
    Body other = body("b");
    other.id = 9;
    QCOMPARE(codeOf(changeBodyEdit(document->bodies(), other)), BodyError::BodyMissing);
    QVERIFY(!valueOf(changeBodyEdit(document->bodies(), *document->bodies().withId(1))));
    const BodyId missing[] = {9}, here[] = {1, 1};
    QVERIFY(!removeBodiesEdit(document->bodies(), missing));
    QVERIFY(!showBodiesEdit(document->bodies(), here, true));
    QVERIFY(showBodiesEdit(document->bodies(), here, false));
  }
};

HANDWHEEL_TEST(BodyChangesTest)
#include "BodyChangesTest.moc"
