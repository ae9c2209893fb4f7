// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyProperties.h"

#include "Shelf.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const Property* found(const std::vector<Property>& all, const std::string& id) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const Property& p) { return p.id == id; });
  return at == all.end() ? nullptr : &*at;
}

double numberOf(const Document& document, const std::string& id) {
  const auto all = document.properties();
  const Property* property = found(all, id);
  return property ? std::get<double>(property->value) : std::nan("");
}

}  // namespace

class BodyPropertiesTest : public QObject {
  Q_OBJECT

 private slots:
  void everyEditablePropertyTakesItsRange() {
    const auto document = newShelf();
    for (const PrimitiveDescription& each : primitives())
      add(*document, body(each.id, valueOf(PrimitiveGeometry::make(each.primitive,
                                                                   std::vector<double>(each.dimensions.size(), 5.0)))));
    std::size_t tried = 0;
    for (const Property& property : document->properties()) {
      if (!bodyOfProperty(property.id) || !property.editable || !std::holds_alternative<double>(property.value))
        continue;
      ++tried;
      for (double value : {property.least, property.largest, 0.25 * property.largest}) {
        QVERIFY2(document->setProperty(property.id, value).hasValue(), property.id.c_str());
        QVERIFY(std::abs(numberOf(*document, property.id) - value) < 1e-9 * std::max(1.0, std::abs(value)));
      }
      for (double wrong : {property.largest * 1.1, std::nan(""), double(INFINITY)}) {
        const Status refused = document->setProperty(property.id, wrong);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::ValueOutOfRange);
      }
      QCOMPARE(document->setProperty(property.id, true).error().code, ErrorCode::ElementMalformed);
    }
    QVERIFY(tried > 0);
  }

  void anglesAreThoseOfThePose() {
    const auto document = newShelf();
    add(*document, body("a"));
    const double quarter = 0.5 * std::numbers::pi;
    QVERIFY(document->setProperty("body.1.x", 3.0).hasValue());
    QVERIFY(document->setProperty("body.1.rz", quarter).hasValue());
    const Pose& pose = document->bodies().withId(1)->pose;
    QVERIFY((pose * Vec3(1, 0, 0)).isApprox(Vec3(3, 1, 0), 1e-12));
    QVERIFY(isRigid(pose));
  }

  void dimensionsChangeTheShape() {
    const auto document = newShelf();
    add(*document, body("a", cube(10)));
    QVERIFY(document->setProperty("body.1.size_y", 30.0).hasValue());
    QCOMPARE(document->bodies().withId(1)->geometry->bounds().max(), Vec3(5, 15, 5));
    document->history()->undo();
    QCOMPARE(document->bodies().withId(1)->geometry->bounds().max(), Vec3(5, 5, 5));
  }

  void colours() {
    const auto document = newShelf();
    add(*document, body("a"));
    QVERIFY(document->setProperty("body.1.colour", std::string("#ff8000")).hasValue());
    QCOMPARE(document->bodies().withId(1)->look.colour, (std::array<float, 3>{1.0f, 128 / 255.0f, 0.0f}));
    QCOMPARE(std::get<std::string>(found(document->properties(), "body.1.colour")->value), "#ff8000");
    for (const char* wrong : {"", "red", "#12345", "#1234567", "#12345g", "#-1-1-1"}) {
      const Status refused = document->setProperty("body.1.colour", std::string(wrong));
      QVERIFY(!refused);
      QCOMPARE(refused.error().code, ErrorCode::ElementMalformed);
    }
  }

  void switchesAndNames() {
    const auto document = newShelf();
    add(*document, body("a"));
    add(*document, body("b"));
    QVERIFY(document->setProperty("body.1.visible", false).hasValue());
    QVERIFY(!document->bodies().withId(1)->visible && document->bodies().withId(2)->visible);
    QVERIFY(document->setProperty("body.2.smooth", false).hasValue());
    QVERIFY(!document->bodies().withId(2)->look.smooth);
    QCOMPARE(document->setProperty("body.2.name", std::string("a")).error().code, BodyError::NameTaken);
    QCOMPARE(document->setProperty("body.2.name", std::string()).error().code, BodyError::NameUnusable);
  }

  void linksAreShown() {
    const auto document = newShelf();
    Body linked = body("a");
    linked.link = BodyLink{"/parts/a.stl", {}, "00", LinkState::Missing};
    add(*document, linked);
    const auto all = document->properties();
    QCOMPARE(std::get<std::string>(found(all, "body.1.link")->value), "/parts/a.stl");
    const Property* state = found(all, "body.1.link_state");
    QCOMPARE(std::get<std::string>(state->value), "missing");
    QVERIFY(!state->editable && !state->problem.empty());
    QCOMPARE(document->setProperty("body.1.link", std::string("b")).error().code, ErrorCode::Unsupported);
  }

  void otherNamesAreNotOfBodies() {
    for (const char* id : {"", "body", "body.", "body.x.name", "body.1", "body.-1.x", "joint.body.1.x", "display_unit"})
      QVERIFY2(!bodyOfProperty(id), id);
    QCOMPARE(bodyOfProperty("body.12.x"), std::optional<BodyId>(12));
    const auto document = newShelf();
    add(*document, body("a"));
    for (const char* id : {"body.1.none", "body.2.x", "body.01.x", "body.1.radius", "body.1.x "})
      QCOMPARE(document->setProperty(id, 1.0).error().code, ErrorCode::ReferenceMissing);
    QVERIFY(document->setProperty("display_unit", 1.0).hasValue());
  }
};

HANDWHEEL_TEST(BodyPropertiesTest)
#include "BodyPropertiesTest.moc"
