// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/BodySet.h"

#include "TestClass.h"
#include "scene/PrimitiveGeometry.h"

#include <rapidcheck.h>
#include <QTest>
#include <map>

using namespace handwheel;

namespace {

BodyPointer ball(BodyId id, const std::string& name) {
  static const GeometryPointer geometry = *PrimitiveGeometry::make(Primitive::Sphere, {1.0});
  return std::make_shared<const Body>(Body{.id = id, .name = name, .geometry = geometry});
}

}  // namespace

class BodySetTest : public QObject {
  Q_OBJECT

 private slots:
  void emptySets() {
    const BodySet none;
    QVERIFY(none.empty() && !none.withId(1) && !none.withName(""));
    QCOMPARE(none.freeId(), 1u);
    QVERIFY(none.without(1) == none);
  }

  // Against a map.
  void asAMap() {
    QVERIFY(rc::check("a set of bodies is a map", [] {
      BodySet set;
      std::map<BodyId, std::string> model;
      BodyId highest = 0;
      for (int step = *rc::gen::inRange(0, 40); step > 0; --step) {
        const BodyId id = *rc::gen::inRange<BodyId>(1, 12);
        const BodySet before = set;
        const std::size_t count = before.size();
        if (*rc::gen::arbitrary<bool>()) {
          const std::string name = std::to_string(step);
          set = set.with(ball(id, name));
          model[id] = name;
          highest = std::max(highest, id);
        } else {
          set = set.without(id);
          model.erase(id);
        }
        RC_ASSERT(before.size() == count);  // versions stay
      }
      RC_ASSERT(set.size() == model.size());
      RC_ASSERT(set.freeId() == highest + 1);
      auto expected = model.begin();
      for (const BodyPointer& body : set) {
        RC_ASSERT(body->id == expected->first);
        RC_ASSERT(body->name == expected->second);
        RC_ASSERT(set.withId(body->id) == body);
        RC_ASSERT(set.withName(body->name) == body);
        ++expected;
      }
    }));
  }

  void versionsShareBodies() {
    const BodySet two = BodySet().with(ball(1, "a")).with(ball(2, "b"));
    const BodySet changed = two.with(ball(1, "c"));
    QCOMPARE(changed.withId(2), two.withId(2));
    QCOMPARE(two.withId(1)->name, "a");
    QVERIFY(changed != two);
    QVERIFY(changed.with(ball(1, "a")) == two);
  }

  void numbersAreNotUsedAgain() {
    const BodySet set = BodySet().with(ball(7, "a")).without(7);
    QVERIFY(set.empty());
    QCOMPARE(set.freeId(), 8u);
    QVERIFY(set == BodySet());
    QCOMPARE(set.withFreeId(20).freeId(), 20u);
    QCOMPARE(set.withFreeId(2).freeId(), 8u);
  }
};

HANDWHEEL_TEST(BodySetTest)
#include "BodySetTest.moc"
