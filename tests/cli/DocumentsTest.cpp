// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;

namespace {

// One revolute joint about y, 200 mm up, with a link of 300 mm along x.
const QByteArray kArm = R"(<robot name="arm">
  <link name="base"/>
  <link name="arm"><visual><origin xyz="0.15 0 0"/><geometry><box size="0.3 0.02 0.02"/></geometry></visual></link>
  <link name="tool0"/>
  <joint name="lift" type="revolute"><parent link="base"/><child link="arm"/><origin xyz="0 0 0.2"/>
    <axis xyz="0 1 0"/><limit lower="-1.5707963267948966" upper="1.5707963267948966" velocity="1" effort="0"/></joint>
  <joint name="end" type="fixed"><parent link="arm"/><child link="tool0"/><origin xyz="0.3 0 0"/></joint>
</robot>)";

}  // namespace

// Every kind of document without a window: made, changed, described, saved, exported.
class DocumentsTest : public QObject {
  Q_OBJECT

 private slots:
  void aWorkpieceIsMadeChangedAndExported() {
    const Fixture fixture;
    QCOMPARE(fixture.run({"new", "workpiece", "diameter=25.4*2", "length=4in", "-o", "bar.handwheel"}).code, 0);
    nlohmann::json bar = jsonOf(fixture.run({"inspect", "--json", "bar.handwheel"}));
    QCOMPARE(bar["kind"].get<std::string>(), std::string("workpiece"));
    const nlohmann::json& document = bar["document"];
    QCOMPARE(document["diameter"].get<double>(), 50.8);
    QCOMPARE(document["length"].get<double>(), 101.6);
    QCOMPARE(document["volume"].get<double>(), std::numbers::pi * 25.4 * 25.4 * 101.6);

    QCOMPARE(fixture.run({"set", "bar.handwheel", "diameter=20", "display_unit=in", "-o", "bar.handwheel"}).code, 0);
    QCOMPARE(fixture.run({"convert", "bar.handwheel", "bar.step"}).code, 0);
    QVERIFY(fixture.content("bar.step").startsWith("ISO-10303-21"));
    QCOMPARE(fixture.run({"convert", "bar.handwheel", "bar.stl"}).code, 0);
    const nlohmann::json mesh = jsonOf(fixture.run({"inspect", "--json", "bar.stl"}));
    QVERIFY(mesh["closed"].get<bool>());
    const double exact = std::numbers::pi * 100.0 * 101.6;
    QVERIFY(std::abs(mesh["volume_mm3"].get<double>() / exact - 1.0) < 5e-3);
    const QByteArray text = fixture.run({"inspect", "bar.handwheel"}).out;
    QVERIFY(text.contains("diameter: 20 mm"));
    QVERIFY(text.contains("display_unit: in"));
  }

  void whatCannotBeSetIsRefusedByName() {
    const Fixture fixture;
    QCOMPARE(fixture.run({"new", "workpiece", "-o", "bar.handwheel"}).code, 0);
    const QByteArray before = fixture.content("bar.handwheel");
    for (const char* word : {"diameter=-5", "diameter=0", "diameter=nonsense", "diameter=3deg", "diametre=5",
                             "volume=7", "display_unit=furlong", "diameter"}) {
      const Ran ran = fixture.run({"set", "bar.handwheel", word, "-o", "bar.handwheel"});
      QCOMPARE(ran.code, 1);
      QVERIFY2(ran.err.startsWith("handwheel: ") && ran.err.count('\n') == 1, ran.err);
    }
    QCOMPARE(fixture.content("bar.handwheel"), before);
    QCOMPARE(fixture.run({"new", "castle", "-o", "x.handwheel"}).code, 1);
    QCOMPARE(fixture.run({"new", "mesh", "-o", "x.handwheel"}).code, 1);
  }

  // The tool of a one-joint arm goes round a circle of 300 mm about (0, 0, 200).
  // Which endings there are depends on what is to be written; what is read depends on nothing.
  void errorsNameTheEndingsThatFit() {
    const Fixture fixture;
    fixture.put("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    fixture.put("env.sh", "export A=1\n");
    const Ran made = fixture.run({"new", "workpiece", "-o", "x.foo"});
    QVERIFY(made.err.contains("'.foo'"));
    QVERIFY2(made.err.contains("ends in .step, .stp, .stl, .ply, .obj, .off, .3mf, .dxf, .svg, .pdf or .handwheel."),
             made.err.constData());
    const Ran converted = fixture.run({"convert", "a.off", "x.docx"});
    QVERIFY2(converted.err.contains("ends in .stl, .ply, .obj, .off, .3mf or .handwheel."), converted.err.constData());
    const Ran split = fixture.run({"split", "a.off", "--format", "foo", "-o", "parts"});
    QVERIFY2(split.err.contains("ends in .stl, .ply, .obj, .off or .3mf."), split.err.constData());
    for (const QStringList& words :
         {QStringList{"inspect", "env.sh"}, QStringList{"convert", "env.sh", "x.handwheel"}}) {
      const Ran read = fixture.run(words);
      QVERIFY2(read.err.contains("not a file that Handwheel can read"), read.err.constData());
      for (const char* ending : {".stl", ".3mf", ".step", ".urdf", ".handwheel"})
        QVERIFY2(read.err.contains(ending), read.err);
    }
  }

  void aRobotMovesAndOpensWithoutItsDescription() {
    const Fixture fixture;
    fixture.put("arm.urdf", kArm);
    QCOMPARE(fixture.run({"set", "arm.urdf", "joint.lift=-30deg", "-o", "arm.handwheel"}).code, 0);
    QVERIFY(QFile::remove(fixture.path() + "/arm.urdf"));
    const nlohmann::json cell = jsonOf(fixture.run({"inspect", "--json", "arm.handwheel"}));
    QCOMPARE(cell["kind"].get<std::string>(), std::string("cell"));
    const nlohmann::json& joint = cell["document"]["joints"][0];
    QCOMPARE(joint["name"].get<std::string>(), std::string("lift"));
    QCOMPARE(joint["value"].get<double>(), -std::numbers::pi / 6.0);
    QVERIFY(joint["effort"].is_null());  // zero: the file does not know it
    const auto position = cell["document"]["tool"]["position"].get<std::vector<double>>();
    QVERIFY(std::abs(position[0] - 300.0 * std::cos(std::numbers::pi / 6.0)) < 1e-9);
    QVERIFY(std::abs(position[2] - (200.0 + 150.0)) < 1e-9);
    const QByteArray text = fixture.run({"inspect", "arm.handwheel"}).out;
    QVERIFY2(text.contains("  joint.lift: -30 deg (-90 deg to 90 deg)\n"), text);
    QVERIFY2(text.contains("  joints.unknown_effort: all joints\n") && !text.contains("is not known"), text);
    QCOMPARE(fixture.run({"set", "arm.handwheel", "joint.lift=1e-11rad", "-o", "level.handwheel"}).code, 0);
    const QByteArray level = fixture.run({"inspect", "level.handwheel"}).out;
    QVERIFY2(level.contains("  joint.lift: 0 deg (-90"), level);  // displayed like the remainder of a sum
    QCOMPARE(fixture.run({"set", "arm.handwheel", "joint.lift=120deg", "-o", "x.handwheel"}).code,
             1);  // beyond its limit
    const Ran repair = fixture.run({"repair", "arm.handwheel", "-o", "x.stl"});
    QCOMPARE(repair.code, 1);
    QVERIFY(repair.err.contains("not supported"));
  }

  // A mesh goes through the container with every triangle as it was, and is repaired into one.
  void meshesLiveInContainersToo() {
    const Fixture fixture;
    fixture.put("cube.off", openCube(0.1).off());
    QCOMPARE(fixture.run({"convert", "cube.off", "cube.handwheel"}).code, 0);
    QCOMPARE(fixture.run({"convert", "cube.handwheel", "back.stl"}).code, 0);
    QCOMPARE(fixture.run({"convert", "cube.off", "direct.stl"}).code, 0);
    QCOMPARE(fixture.content("back.stl"), fixture.content("direct.stl"));
    QCOMPARE(fixture.run({"repair", "cube.handwheel", "-o", "whole.handwheel", "--report", "r.json"}).code, 0);
    const nlohmann::json whole = jsonOf(fixture.run({"inspect", "--json", "whole.handwheel"}));
    QVERIFY(whole["closed"].get<bool>());
    QVERIFY(std::abs(whole["volume_mm3"].get<double>() - 1e-3) < 1e-12);
  }

  void aDamagedContainerTellsWhatIsMissing() {
    const Fixture fixture;
    fixture.put("cube.off", openCube(1.0).off());
    QCOMPARE(fixture.run({"convert", "cube.off", "cube.handwheel"}).code, 0);
    const QByteArray whole = fixture.content("cube.handwheel");
    for (qsizetype length = 0; length < whole.size(); length += whole.size() / 20 + 1) {
      fixture.put("cut.handwheel", whole.left(length));
      const Ran ran = fixture.run({"inspect", "cut.handwheel"});
      QVERIFY2(ran.code == 0 || ran.code == 1, ran.err);
      QVERIFY(ran.code == 0 || ran.err.startsWith("handwheel: "));
    }
  }
};

HANDWHEEL_TEST(DocumentsTest)
#include "DocumentsTest.moc"
