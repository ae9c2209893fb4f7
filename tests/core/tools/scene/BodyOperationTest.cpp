// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/scene/BodyOperation.h"

#include "TestClass.h"
#include "document/OperationText.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyErrors.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"

#include <QTest>
#include <numbers>

using namespace handwheel;

namespace {

const DocumentKinds kNoKinds{{}};

// From words, as the command line does.
OperationValues valuesOf(std::initializer_list<std::pair<const char*, const char*>> options) {
  OperationValues values(bodyOperation());
  for (const auto& [id, word] : options) {
    const std::string problem = readWord(values, *bodyOperation().find(id), word);
    if (!problem.empty()) qFatal("%s", problem.c_str());
  }
  return values;
}

BodySet oneCube() {
  Body cube{.id = 1, .name = "cube", .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {1, 1, 1})};
  return BodySet().with(std::make_shared<const Body>(std::move(cube)));
}

ErrorCode codeOf(std::initializer_list<std::pair<const char*, const char*>> options) {
  const auto change = bodyChange(valuesOf(options), oneCube(), kNoKinds, {});
  return change ? ErrorCode::Cancelled : change.error().code;
}

}  // namespace

class BodyOperationTest : public QObject {
  Q_OBJECT

 private slots:
  void valuesThatFitTogether() {
    QVERIFY(problemOfBodyValues(valuesOf({{"add", "sphere:5"}, {"name", "ball"}, {"at", "1,2,3"}})).empty());
    QVERIFY(problemOfBodyValues(valuesOf({{"remove", "cube"}})).empty());
    QVERIFY(!problemOfBodyValues(valuesOf({})).empty());
    QVERIFY(!problemOfBodyValues(valuesOf({{"remove", "cube"}, {"update", "cube"}})).empty());
    QVERIFY(!problemOfBodyValues(valuesOf({{"remove", "cube"}, {"at", "1,2,3"}})).empty());
    QVERIFY(!problemOfBodyValues(valuesOf({{"add", "box:1,2,3"}, {"link", ""}})).empty());
    QVERIFY(!problemOfBodyValues(valuesOf({{"add", "box:1,2"}})).empty());
    QVERIFY(problemOfBodyValues(valuesOf({{"add", "box.stl"}, {"link", ""}})).empty());
  }

  void everyPrimitiveCanBeAdded() {
    for (const char* what : {"box:1,2,3", "cylinder:1,2", "sphere:1", "cone:1,2", "sphere:1e-3"}) {
      const auto change = bodyChange(valuesOf({{"add", what}, {"turn", "0,0,90"}}), oneCube(), kNoKinds, {});
      QVERIFY2(change && change->edit, what);
    }
  }

  void whatCannotBeDone() {
    QCOMPARE(codeOf({{"add", "box:1,2"}}), ErrorCode::CountMismatch);
    QCOMPARE(codeOf({{"add", "sphere:0"}}), ErrorCode::ValueOutOfRange);
    QCOMPARE(codeOf({{"add", "sphere:x"}}), ErrorCode::NumberMalformed);
    QCOMPARE(codeOf({{"add", "sphere:"}}), ErrorCode::NumberMalformed);
    QCOMPARE(codeOf({{"add", "sphere:1"}, {"name", "cube"}}), BodyError::NameTaken);
    QCOMPARE(codeOf({{"add", "/none/a.stl"}}), ErrorCode::FileMissing);
    QCOMPARE(codeOf({{"remove", "2"}}), BodyError::BodyMissing);
    QCOMPARE(codeOf({{"update", "cube"}}), BodyError::NotLinked);
  }

  // Silently one of two would be the wrong one.
  void aNameThatIsTheNumberOfAnother() {
    Body second{.id = 2, .name = "1", .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {1, 1, 1})};
    const BodySet bodies = oneCube().with(std::make_shared<const Body>(std::move(second)));
    const auto change = bodyChange(valuesOf({{"remove", "1"}}), bodies, kNoKinds, {});
    QVERIFY(!change && change.error().code == BodyError::Ambiguous);
    QVERIFY(bodyChange(valuesOf({{"remove", "2"}}), bodies, kNoKinds, {})->edit);
  }

  void anotherFileGoesWithUpdate() {
    QVERIFY(problemOfBodyValues(valuesOf({{"update", "cube"}, {"from", "a.stl"}})).empty());
    QVERIFY(!problemOfBodyValues(valuesOf({{"from", "a.stl"}})).empty());
    QVERIFY(!problemOfBodyValues(valuesOf({{"remove", "cube"}, {"from", "a.stl"}})).empty());
    QCOMPARE(codeOf({{"update", "cube"}, {"from", "/none/a.stl"}}), ErrorCode::FileMissing);
  }

  // The bodies may change while a file is read for one of them.
  void aBodyIsUpdatedAsItIsByThen() {
    Body body = *oneCube().withId(1);
    body.name = "vice";
    body.pose = poseOf({1, 2, 3}, Vec3::Zero());
    const BodySet later = BodySet().with(std::make_shared<const Body>(body));
    const OperationValues values = valuesOf({{"update", "cube"}, {"from", "/none/b.stl"}});
    ImportedBody read;
    read.body.id = 1;
    read.body.geometry = *PrimitiveGeometry::make(Primitive::Sphere, {1});
    read.body.link = BodyLink{"/none/b.stl", {}, "b", LinkState::Present};
    const auto change = bodyChange(values, later, read);
    QVERIFY(change && change->edit);
    QCOMPARE(change->name, std::string("vice"));
    const auto tooLate = bodyChange(values, BodySet(), read);
    QVERIFY(!tooLate && tooLate.error().code == BodyError::BodyMissing);
  }

  void bodiesAreNamedByNameOrNumber() {
    for (const char* name : {"cube", "1"}) {
      const auto change = bodyChange(valuesOf({{"remove", name}}), oneCube(), kNoKinds, {});
      QVERIFY(change && change->edit);
    }
    const auto nothing = bodyChange(valuesOf({{"unlink", "cube"}}), oneCube(), kNoKinds, {});
    QVERIFY(nothing && !nothing->edit);  // it has no link
  }
};

HANDWHEEL_TEST(BodyOperationTest)
#include "BodyOperationTest.moc"
