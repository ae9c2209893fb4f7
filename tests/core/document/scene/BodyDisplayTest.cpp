// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyDisplay.h"

#include "Shelf.h"
#include "TestClass.h"
#include "document/scene/BodyDescription.h"
#include "scene/UnknownGeometry.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

class BodyDisplayTest : public QObject {
  Q_OBJECT

 private slots:
  void visibleBodiesAreParts() {
    Body hidden = body("hidden");
    hidden.visible = false;
    Body red = body("red", std::make_shared<const MeshGeometry>(tetrahedron()));
    red.pose = poseOf({1, 2, 3}, {0.1, 0.2, 0.3});
    red.look = {{1.0f, 0.0f, 0.0f}, false};
    const Body unknown =
        body("unknown", std::make_shared<const UnknownGeometry>("voxels", "{}", std::map<std::string, std::string>()));
    const auto parts = displayPartsOf(with(with(with({}, hidden), red), unknown));
    QCOMPARE(parts.size(), std::size_t{1});
    QCOMPARE(bodyOfPart(parts[0].name), std::optional<BodyId>(2));
    QCOMPARE(parts[0].soup, red.geometry->surface());
    QCOMPARE(parts[0].pose.matrix(), red.pose.matrix());
    QCOMPARE(parts[0].colour, red.look.colour);
    QVERIFY(!parts[0].smooth);
  }

  void otherPartsAreNoBodies() {
    for (const char* name : {"", "body", "body.", "body.x", "body.1/0", "body.-1", "body.99999999999", "stock"})
      QVERIFY2(!bodyOfPart(name), name);
  }

  void descriptions() {
    Body linked = body("a", cube(4));
    linked.pose = poseOf({1, 2, 3}, {0, 0, 0});
    linked.link = BodyLink{"/parts/a.stl", {}, "00", LinkState::Changed};
    const nlohmann::json described = describeBodies(with({}, linked));
    QVERIFY(described == nlohmann::json::array({{{"id", 1},
                                                 {"name", "a"},
                                                 {"shape", "box"},
                                                 {"position", {1.0, 2.0, 3.0}},
                                                 {"quaternion", {1.0, 0.0, 0.0, 0.0}},
                                                 {"visible", true},
                                                 {"triangles", 12},
                                                 {"link", {{"path", "/parts/a.stl"}, {"state", "changed"}}}}}));
  }
};

HANDWHEEL_TEST(BodyDisplayTest)
#include "BodyDisplayTest.moc"
