// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/UrdfReader.h"

#include "Robots.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

class UrdfShapesTest : public QObject {
  Q_OBJECT

 private slots:
  void shapes();
  void colours();
  void damagedShapesAreLeftOut_data();
  void damagedShapesAreLeftOut();
};

void UrdfShapesTest::shapes() {
  const std::string finger = "<geometry><mesh filename='f.stl' scale='1 2 -3'/></geometry>";
  const RobotModel robot =
      readOrThrow(robotOf(link("a",
                               "<visual><origin xyz='0 0 1'/><geometry><box size='1 2 3'/></geometry></visual>"
                               "<visual><geometry><cylinder radius='0.5' length='2'/></geometry></visual>"
                               "<collision><geometry><sphere radius='0.25'/></geometry></collision>"
                               "<visual>" +
                                   finger + "</visual><collision>" + finger + "</collision>")))
          .robot;
  const Link& a = robot.links[0];
  QCOMPARE(a.visuals.size(), std::size_t{3});
  QCOMPARE(a.collisions.size(), std::size_t{2});
  QCOMPARE(robot.shapes.size(), std::size_t{4});  // the mesh once
  QVERIFY(robot.shapes[a.visuals[0].shape] == Shape(BoxShape{{1000, 2000, 3000}}));
  QVERIFY(a.visuals[0].origin.translation() == Vec3(0, 0, 1000));
  QVERIFY(robot.shapes[a.visuals[1].shape] == Shape(CylinderShape{500, 2000}));
  QVERIFY(robot.shapes[a.collisions[0].shape] == Shape(SphereShape{250}));
  QVERIFY(robot.shapes[a.visuals[2].shape] == Shape(MeshShape{"f.stl", {1, 2, -3}}));
  QCOMPARE(a.visuals[2].shape, a.collisions[1].shape);
}

void UrdfShapesTest::colours() {
  const auto visual = [](const std::string& material) {
    return "<visual><geometry><sphere radius='1'/></geometry>" + material + "</visual>";
  };
  const RobotModel robot =
      readOrThrow(robotOf("<material name='red'><color rgba='1 0 0 1'/></material>" +
                          link("a", visual("<material name='red'/>") + visual("<material name='later'/>") + visual("") +
                                        visual("<material name='none'/>") +
                                        visual("<material name=''><color rgba='2 .5 -1 1'/></material>")) +
                          link("b", visual("<material name='later'><color rgba='0 0 1 1'/></material>")) +
                          joint("j", "fixed", "a", "b")))
          .robot;
  const auto& visuals = robot.links[0].visuals;
  QVERIFY(visuals[0].colour == (ShapeColour{1, 0, 0}));
  QVERIFY(visuals[1].colour == (ShapeColour{0, 0, 1}));
  QVERIFY(!visuals[2].colour && !visuals[3].colour);
  QVERIFY(visuals[4].colour == (ShapeColour{1, 0.5f, 0}));
}

void UrdfShapesTest::damagedShapesAreLeftOut_data() {
  QTest::addColumn<QString>("visual");
  for (const char* text :
       {"", "<geometry/>", "<geometry><mesh/></geometry>", "<geometry><mesh filename=''/></geometry>",
        "<geometry><box size='1 1'/></geometry>", "<geometry><box size='1 0 1'/></geometry>",
        "<geometry><box/></geometry>", "<geometry><sphere radius='-1'/></geometry>",
        "<geometry><sphere radius='nan'/></geometry>", "<geometry><cylinder radius='1'/></geometry>",
        "<geometry><capsule radius='1' length='1'/></geometry>",
        "<geometry><mesh filename='a.stl' scale='0 1 1'/></geometry>",
        "<geometry><mesh filename='a.stl' scale='1e300 1 1'/></geometry>",
        "<origin xyz='nan 0 0'/><geometry><sphere radius='1'/></geometry>"})
    QTest::newRow(text) << QString(text);
}

void UrdfShapesTest::damagedShapesAreLeftOut() {
  QFETCH(QString, visual);
  const std::string good = "<visual><geometry><sphere radius='1'/></geometry></visual>";
  const ImportedRobot read = readOrThrow(robotOf(link("a", "<visual>" + visual.toStdString() + "</visual>" + good)));
  QCOMPARE(read.robot.links[0].visuals.size(), std::size_t{1});
  QCOMPARE(read.damage.size(), std::size_t{1});
  QVERIFY(read.damage[0].position.kind == InputPosition::Kind::Line);
}

HANDWHEEL_TEST(UrdfShapesTest)
#include "UrdfShapesTest.moc"
