// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

nlohmann::json figuresOf(const Ran& ran) {
  return nlohmann::json::parse(ran.out.toStdString());
}

// A shoulder of 30 mm at Z -40 on a bar of 40 mm, in three passes of an ideal point.
const QByteArray kShoulder =
    "G21 G18 G7\nG97 S800 M3\nG95 F0.2\nG0 X44 Z2\nX36\nG1 Z-40\nX42\nG0 Z2\nX33\nG1 Z-40\nX42\nG0 Z2\nX30\nG1 "
    "Z-40\nX42\nG0 Z2\nM2\n";

}  // namespace

// 'handwheel turn --program': a program cuts a bar.
class TurnProgramTest : public QObject {
  Q_OBJECT

 private slots:
  // The volume between two cylinders; the time from lengths, feeds and the rapid speed; power and force together.
  void aShoulderIsTurned() {
    const Fixture fixture;
    fixture.put("p.ngc", kShoulder);
    const Ran ran = fixture.run({"turn", "cylinder:40x100", "--program", "p.ngc", "-o", "part.step", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json json = figuresOf(ran);
    QCOMPARE(json.size(), std::size_t{8});
    const double expected = M_PI * (400.0 - 225.0) * 40.0;
    QVERIFY2(std::abs(json["removed_mm3"].get<double>() / expected - 1.0) < 1e-3, ran.out);
    QCOMPARE(json["collisions"].get<int>(), 0);
    QVERIFY(json["profile_error_mm"].is_null());
    // Cut lengths 3·42 + 3 + 4.5 + 6 at 0.2 mm · 800/min.
    QVERIFY(json["time_s"].get<double>() > (3 * 42.0 + 13.5) / 160.0 * 60.0);
    // Kienzle, medium carbon steel: 1.5 to 2 mm deep at 0.2 mm are several hundred newtons.
    QVERIFY(json["max_force_N"].get<double>() > 300.0 && json["max_force_N"].get<double>() < 3000.0);
    const double speed = M_PI * 40.0 * 800.0 / 1000.0;  // m/min
    // 80 % of the motor's power come to the cut.
    const double ofMotor = json["max_motor_power_kW"].get<double>();
    QVERIFY(std::abs(0.8 * ofMotor - json["max_power_kW"].get<double>()) < 1e-9);
    QVERIFY(json["max_power_kW"].get<double>() < json["max_force_N"].get<double>() * speed / 60000.0 * 1.01);
    QVERIFY(fixture.names().contains("part.step"));
    const Ran document = fixture.run({"turn", "cylinder:40x100", "--program", "p.ngc", "-o", "part.handwheel"});
    QVERIFY2(document.code == 0, document.err);
    QCOMPARE(fixture.run({"turn", "part.handwheel", "--replay"}).code, 0);
    // The part itself as a target.
    const Ran same = fixture.run(
        {"turn", "cylinder:40x100", "--program", "p.ngc", "--target", "part.handwheel", "-o", "again.stl", "--json"});
    QVERIFY2(same.code == 0, same.err);
    QVERIFY(figuresOf(same)["profile_error_mm"].get<double>() < 0.02);
  }

  void fanucTurnsTheSame() {
    const Fixture fixture;
    fixture.put("p.nc",
                "%\nO1\nG21 G18 G99\nT0101\nG97 S800 M3\nG0 X44. Z2.\nG90 X36. Z-40. F0.2\nX33.\nX30.\nM30\n%\n");
    const Ran ran =
        fixture.run({"turn", "cylinder:40x100", "--program", "p.nc", "--dialect", "fanuc", "-o", "a.step", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const double expected = M_PI * (400.0 - 225.0) * 40.0;
    QVERIFY(std::abs(figuresOf(ran)["removed_mm3"].get<double>() / expected - 1.0) < 1e-3);
  }

  // The settings of a control besides the program: increments of 0.001 mm, and the switches of block skips. /2 skips a
  // cut from Ø36 to Ø30.
  void readsAsTheControlIsSet() {
    const Fixture fixture;
    fixture.put("p.nc", "G21 G99\nT0101\nG97 S800 M3\nG0 X44000 Z2000\nG90 X36000 Z-40000 F0.2\n/2 X30000\nM30\n");
    const auto removed = [&](const QStringList& options) {
      const Ran ran = fixture.run(
          QStringList{"turn", "cylinder:40x100", "--program", "p.nc", "--dialect", "fanuc", "-o", "a.step", "--json"} +
          options);
      return ran.code == 0 ? figuresOf(ran)["removed_mm3"].get<double>() : -1.0;
    };
    QVERIFY(std::abs(removed({"--increments"}) / (M_PI * (400.0 - 225.0) * 40.0) - 1.0) < 1e-3);
    QVERIFY(std::abs(removed({"--increments", "--block-skip", "1,2"}) / (M_PI * (400.0 - 324.0) * 40.0) - 1.0) < 1e-3);
    QVERIFY(removed({"--block-skip", "0"}) == -1.0 && removed({"--block-skip", "1,"}) == -1.0);
    QCOMPARE(fixture.run({"turn", "cylinder:40x9", "--program", "p.nc", "-o", "a.step", "--increments"}).code, 1);
  }

  // An alarm of the program is an error that tells its message, and nothing is written.
  void tellsTheAlarm() {
    const Fixture fixture;
    fixture.put("p.nc", "G97 S800 M3\n#1=5.\nIF[#1 GT 3.] THEN #3000=1 (TOO BIG)\nG0 X36. Z2.\nG1 Z-10. F0.2\n");
    const Ran ran = fixture.run({"turn", "cylinder:40x100", "--program", "p.nc", "--dialect", "fanuc", "-o", "a.step"});
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains("p.nc, line 3: the program stops with the alarm 3001: TOO BIG."), ran.err);
    QVERIFY(!QFile::exists(fixture.path() + "/a.step"));
  }

  // A nose of 2 mm leaves its fillet at the shoulder: the square minus the quarter circle, by Pappus' theorem.
  void theNoseLeavesAFillet() {
    const Fixture fixture;
    fixture.put("p.ngc", kShoulder);
    const Ran ran =
        fixture.run({"turn", "cylinder:40x100", "--program", "p.ngc", "--nose", "2", "-o", "a.step", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const double r = 2.0, area = r * r * (1.0 - 0.25 * M_PI);
    // centroid of the remaining area, from the axis
    const double centroid = 15.0 + (10.0 - 3.0 * M_PI) / (12.0 - 3.0 * M_PI) * r;
    const double expected = M_PI * (400.0 - 225.0) * 40.0 - 2.0 * M_PI * centroid * area;
    QVERIFY2(std::abs(figuresOf(ran)["removed_mm3"].get<double>() / expected - 1.0) < 1e-3, ran.out);
  }

  void aStillSpindleIsReported() {
    const Fixture fixture;
    fixture.put("p.ngc", "G21 G18 G7 S500\nF100\nG0 X44 Z2\nX36\nG1 Z-20\nM2\n");
    const Ran ran = fixture.run({"turn", "cylinder:40x100", "--program", "p.ngc", "-o", "a.stl", "--json"});
    QCOMPARE(figuresOf(ran)["collisions"].get<int>(), 1);
    QVERIFY2(ran.err.contains("line 5: feed into material with the spindle at rest"), ran.err);
  }

  // M6 stops the spindle of a LinuxCNC, and is named where it did.
  void theChangeThatStoppedTheSpindleIsNamed() {
    const Fixture fixture;
    const QByteArray cut = "G0 X44 Z2\nX36\nG1 Z-20\nM2\n", why = ": M6 has stopped it. Write M3 or M4 after M6.";
    fixture.put("p.ngc", "G21 G18 G7 S500 F100 M3\nT1 M6\n" + cut);
    fixture.put("q.ngc", "G21 G18 G7 S500 F100 M3\nT1 M6\nM3\nM5\n" + cut);
    const Ran changed = fixture.run({"turn", "cylinder:40x100", "--program", "p.ngc", "-o", "a.stl"});
    QVERIFY2(changed.err.contains("line 5: feed into material with the spindle at rest" + why), changed.err);
    const Ran stopped = fixture.run({"turn", "cylinder:40x100", "--program", "q.ngc", "-o", "b.stl"});
    QVERIFY2(stopped.err.contains("line 7: feed into material with the spindle at rest.\n"), stopped.err);
  }

  // 10 mm come off by a blade of 3 mm that is fed over the axis: a cylinder of 40 x 10 mm, with the fillets that the
  // corners of 0.2 mm leave at no wall here. The table has a mistyped id as well.
  void partingOffIsTold() {
    const Fixture fixture;
    fixture.put("t.tbl", "T1 P1 X0 Z0 ;parting-3\nT2 P2 X0 Z0 D0.8 Q2 ;right-rouging\n");
    fixture.put("p.ngc", "G21 G18 G7 G95 F0.1\nT1 M6 G43\nS500 M3\nG0 X44 Z-13\nG1 X-1\nG0 X60\nM2\n");
    const QStringList words = {"turn",    "cylinder:40x100", "--program", "p.ngc",
                               "--tools", "t.tbl",           "-o",        "a.handwheel"};
    const Ran ran = fixture.run(words + QStringList{"--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json json = figuresOf(ran);
    QCOMPARE(json["parted_off"].size(), std::size_t{1});
    QVERIFY2(std::abs(json["parted_off"][0]["length_mm"].get<double>() - 10.0) < 1e-6, ran.out);
    QVERIFY2(std::abs(json["parted_off"][0]["volume_mm3"].get<double>() / (M_PI * 4000.0) - 1.0) < 1e-6, ran.out);
    QVERIFY(json["warnings"][0]["text"].get<std::string>().find("t.tbl, line 2: 'right-rouging'") == 0);
    QVERIFY2(ran.err.contains("t.tbl, line 2: 'right-rouging' is no tool of the lathe"), ran.err);
    const Ran text = fixture.run(words);
    QVERIFY2(text.out.contains("Parted off: a piece of 10 mm length and 12566.4 mm³."), text.out);
    // The piece that lies there is not told again.
    fixture.put("q.ngc", "G21 G18 G7 G95 F0.1\nS500 M3\nG0 X38 Z-11\nG1 Z-40\nG0 X60\nM2\n");
    const Ran more = fixture.run({"turn", "a.handwheel", "--program", "q.ngc", "-o", "b.handwheel", "--json"});
    QVERIFY2(!figuresOf(more).contains("parted_off"), more.out);
  }

  // The material of the workpiece gives the forces, as in its replay; --material does where it is given. By Kienzle's
  // law both forces are as their k of this chip.
  void theMaterialOfTheWorkpieceIsCut() {
    const Fixture fixture;
    fixture.put("p.ngc", kShoulder);
    const auto force = [&](const QByteArray& material, const QStringList& more = {}) {
      fixture.run({"new", "workpiece", "diameter=40", "length=100", "material=" + material, "-o", "bar.handwheel"});
      const Ran ran = fixture.run(
          QStringList{"turn", "bar.handwheel", "--program", "p.ngc", "-o", "part.handwheel", "--json"} + more);
      const bool isTold = ran.err.contains("the material '" + material + "' is not known");
      return std::pair(figuresOf(ran)["max_force_N"].get<double>(), isTold);
    };
    const auto usual = force(""), stainless = force("Stainless steel, austenitic");
    QVERIFY(stainless.first > 1.2 * usual.first && !usual.second && !stainless.second);
    QVERIFY(force("austenitic-stainless-steel") == stainless);
    QVERIFY(force("", {"--material", "austenitic-stainless-steel"}) == stainless);
    QVERIFY(force("cheese") == std::pair(usual.first, true));
    const Ran set = fixture.run({"set", "bar.handwheel", "material=chalk", "-o", "c.handwheel"});
    QVERIFY2(set.code == 0 && set.err.contains("material: no known material: forces are those of"), set.err);
    const Ran bar = fixture.run({"turn", "cylinder:40x100", "--program", "p.ngc", "--material",
                                 "austenitic-stainless-steel", "-o", "d.handwheel"});
    QVERIFY2(bar.code == 0, bar.err);
    QVERIFY(fixture.run({"inspect", "d.handwheel"}).out.contains("material: Stainless steel, austenitic"));
  }

  // Z of sizes and of the finish count from the zero of the document, which is the free end of a bar that has no file.
  void oneZIsInspected() {
    const Fixture fixture;
    fixture.put("p.ngc", "G21 G18 G7 G95 F0.2\nS500 M3\nG0 X36 Z2\nG1 Z-40\nX44\nM2\n");
    fixture.run({"turn", "cylinder:40x100", "--program", "p.ngc", "--nose", "0.8", "-o", "a.handwheel"});
    const Ran ran = fixture.run({"inspect", "a.handwheel", "--json"});
    const nlohmann::json document = figuresOf(ran)["document"];
    const nlohmann::json outside = document["finish"]["outside"];
    QVERIFY2(!outside.empty(), ran.out);
    const nlohmann::json& last = outside.back();
    QVERIFY(std::abs(last["to"].get<double>()) < 0.02 && std::abs(last["from"].get<double>() + 39.9) < 0.2);
    const Ran text = fixture.run({"inspect", "a.handwheel"});
    QVERIFY2(text.out.contains("Z below: the end of the bar in the chuck is at Z -100, its free end at Z 0"), text.out);
  }

  // M4 is one warning in the report, no collision; with the post in front and the inserts down it is right, and the
  // post is saved with the document. A program for such a machine says M4.
  void theToolPostDecidesTheSense() {
    const Fixture fixture;
    fixture.put("p.ngc", "G21 G18 G7 S500 M4\nF100\nG0 X44 Z2\nX36\nG1 Z-20\nX44\nG0 Z2\nX34\nG1 Z-20\nM2\n");
    const QStringList turn = {"turn", "cylinder:40x100", "--program", "p.ngc", "-o", "a.handwheel", "--json"};
    const Ran usual = fixture.run(turn);
    QVERIFY2(usual.code == 0, usual.err);
    const nlohmann::json json = figuresOf(usual);
    QCOMPARE(json["collisions"].get<int>(), 0);
    QCOMPARE(json["warnings"].size(), std::size_t{1});
    QCOMPARE(json["warnings"][0]["line"].get<int>(), 5);
    QVERIFY2(usual.err.contains("line 5: The spindle turns away from the cutting edge"), usual.err);
    const Ran front = fixture.run(turn + QStringList{"--post", "front", "--insert", "down"});
    QVERIFY2(front.code == 0 && !figuresOf(front).contains("warnings"), front.err);
    fixture.put("deeper.ngc", "G21 G18 G7 S500 M4\nF100\nG0 X44 Z2\nX30\nG1 Z-20\nM2\n");
    const Ran again = fixture.run({"turn", "a.handwheel", "--program", "deeper.ngc", "-o", "b.handwheel", "--json"});
    QVERIFY2(again.code == 0 && !figuresOf(again).contains("warnings"), again.err);
    const Ran written = fixture.run({"program", "a.handwheel", "-o", "m4.ngc"});
    QVERIFY2(written.code == 0 && fixture.content("m4.ngc").contains("M4"), written.err);
    QVERIFY(fixture.run({"program", "a.handwheel", "--post", "front", "-o", "m3.ngc"}).code == 0);
    QVERIFY(fixture.content("m3.ngc").contains("M3"));
    QVERIFY(fixture.run(turn + QStringList{"--post", "above"}).err.contains("--post is behind or front"));
    QVERIFY(fixture.run({"turn", "a.handwheel", "--replay", "--insert", "up"}).err.contains("--program"));
  }

  // The formula of a drill (docs/forces.md): 25.75 N·m, 1.348 kW and 2207 N.
  void aDrillIsReported() {
    const Fixture fixture;
    fixture.put("p.ngc", "G21 G18 G7 G95 F0.2 G97 S500 M3\nG0 X0 Z3\nG1 Z-30\nG0 Z5\nM2\n");
    const Ran ran = fixture.run(
        {"turn", "cylinder:40x100", "--program", "p.ngc", "--nose", "10", "-o", "part.handwheel", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json drilling = figuresOf(ran)["drilling"];
    QVERIFY(drilling["diameter_mm"] == 20.0);
    QVERIFY(std::abs(drilling["torque_Nm"].get<double>() - 25.75) < 0.3);
    QVERIFY(std::abs(drilling["power_kW"].get<double>() - 1.348) < 0.015);
    QVERIFY(std::abs(drilling["thrust_N"].get<double>() - 2207.0) < 25.0);
  }

  void collisionsAreCounted() {
    const Fixture fixture;
    fixture.put("p.ngc", "G21 G18 G7 S500 M3\nF100\nG0 X44 Z2\nG0 X30 Z-20\nG0 X44\nG0 Z-105\nG0 X10\nM2\n");
    const Ran ran = fixture.run({"turn", "cylinder:40x100", "--program", "p.ngc", "-o", "a.stl", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    QVERIFY(figuresOf(ran)["collisions"].get<int>() >= 2);
    QVERIFY2(ran.err.contains("line 4: rapid move through material") && ran.err.contains("chuck"), ran.err);
  }

  // A word for a bar is not a file: its problem is reported.
  void impossibleBars() {
    const Fixture fixture;
    fixture.put("p.ngc", kShoulder);
    const std::pair<const char*, const char*> cases[] = {
        {"cylinder:0x100", "diameter of the bar has to be above 0"},
        {"cylinder:-40x100", "diameter of the bar has to be above 0"},
        {"cylinder:40x0", "length of the bar has to be above 0"},
        {"cylinder:nanx100", "diameter of the bar has to be above 0"},
        {"cylinder:40xinf", "length of the bar has to be at most"},
        {"cylinder:1e9x100", "diameter of the bar has to be at most"},
        {"cylinder:40x1e999", "length of the bar has to be at most"},
        {"cylinder:1e-9x100", "diameter of the bar has to be at least"},
        {"cylinder:40", "with an x between them"},
        {"cylinder:40x", "length of the bar is missing"},
        {"cylinder:x100", "diameter of the bar is missing"},
        {"cylinder:40,5x100", "not a number: 40,5. Write it with a point"},
        {"cylinder:40xbar", "not a number: bar"}};
    for (const auto& [word, sentence] : cases) {
      const Ran turned = fixture.run({"turn", word, "--program", "p.ngc", "-o", "a.step"});
      QVERIFY2(turned.code == 1 && turned.err.contains(sentence), word + turned.err);
      const Ran program = fixture.run({"program", "p.ngc", "--stock", word, "-o", "a.ngc"});
      QVERIFY2(program.code == 1 && program.err.contains(sentence), word + program.err);
    }
    QVERIFY(fixture.run({"program", "p.ngc", "--stock", "40x100", "-o", "a.ngc"}).err.contains("cylinder:40x100"));
  }

  // A drawing becomes cycles, and these the part; recorded passes become a program, and this the same part.
  void programsAreWritten() {
    const Fixture fixture;
    QByteArray drawing = "0\nSECTION\n2\nENTITIES\n";
    const double corners[][2] = {{0, 0}, {0, 15}, {30, 15}, {30, 10}, {50, 10}, {50, 0}};
    for (int i = 0; i < 5; ++i) {
      drawing += "0\nLINE\n8\n0\n";
      for (int k = 0; k < 2; ++k)
        drawing += QStringLiteral("1%1\n%2\n2%1\n%3\n").arg(k).arg(corners[i + k][0]).arg(corners[i + k][1]).toUtf8();
    }
    fixture.put("t.dxf", drawing + "0\nENDSEC\n0\nEOF\n");
    for (const char* const dialect : {"linuxcnc", "fanuc"}) {
      const Ran made =
          fixture.run({"program", "t.dxf", "--stock", "cylinder:40x100", "--dialect", dialect, "-o", "t.ngc"});
      QVERIFY2(made.code == 0, made.err);
      const Ran turned = fixture.run({"turn", "cylinder:40x100", "--program", "t.ngc", "--dialect", dialect, "--nose",
                                      "0.4", "--target", "t.dxf", "-o", "t.handwheel", "--json"});
      QVERIFY2(turned.code == 0, turned.err);
      QCOMPARE(figuresOf(turned)["collisions"].get<int>(), 0);
      QVERIFY2(figuresOf(turned)["profile_error_mm"].get<double>() < 0.2, turned.out);  // the nose in the corner
      QVERIFY2(fixture.run({"program", "t.handwheel", "--dialect", dialect, "-o", "again.ngc"}).code == 0, "");
      const Ran again = fixture.run({"turn", "cylinder:40x100", "--program", "again.ngc", "--dialect", dialect,
                                     "--nose", "0.4", "-o", "again.stl", "--json"});
      QVERIFY2(again.code == 0, again.err);
      const double ratio =
          figuresOf(again)["removed_mm3"].get<double>() / figuresOf(turned)["removed_mm3"].get<double>();
      QVERIFY2(std::abs(ratio - 1.0) < 2e-3, again.out);
    }
    QCOMPARE(fixture.run({"program", "t.dxf", "--stock", "cylinder:20x100", "-o", "x.ngc"}).code, 1);
    // No command writes over its input, nor a program over a document.
    const auto keeps = [&](const char* name, const QStringList& words) {
      const QByteArray before = fixture.content(name);
      return fixture.run(words).code == 1 && fixture.content(name) == before && !before.isEmpty();
    };
    QVERIFY(keeps("t.handwheel", {"program", "t.handwheel", "-o", "t.handwheel"}));
    QVERIFY(keeps("t.handwheel", {"program", "t.dxf", "--stock", "cylinder:40x100", "-o", "t.handwheel"}));
    QVERIFY(keeps("t.dxf", {"program", "t.dxf", "--stock", "cylinder:40x100", "-o", "t.dxf"}));
    QVERIFY(keeps("t.dxf", {"target", "t.dxf", "-o", "t.dxf"}));
    QVERIFY(keeps("t.handwheel", {"turn", "cylinder:40x100", "--program", "again.ngc", "--target", "t.handwheel", "-o",
                                  "t.handwheel"}));
    QCOMPARE(fixture.run({"program", "none.svg", "-o", "x.ngc"}).code, 1);
  }

  // A sleeve of 24 mm inside: without a drill its bore stays solid, 12 mm from the wall to the axis, and that is
  // reported.
  void aBoreThatIsLeftIsReported() {
    const Fixture fixture;
    QByteArray drawing = "0\nSECTION\n2\nENTITIES\n";
    const double corners[][2] = {{0, 12}, {0, 18}, {50, 18}, {50, 12}, {0, 12}};
    for (int i = 0; i < 4; ++i) {
      drawing += "0\nLINE\n8\n0\n";
      for (int k = 0; k < 2; ++k)
        drawing += QStringLiteral("1%1\n%2\n2%1\n%3\n").arg(k).arg(corners[i + k][0]).arg(corners[i + k][1]).toUtf8();
    }
    fixture.put("t.dxf", drawing + "0\nENDSEC\n0\nEOF\n");
    const Ran left = fixture.run({"program", "t.dxf", "--stock", "cylinder:40x100", "-o", "t.ngc"});
    QVERIFY2(left.code == 0, left.err);
    QVERIFY2(left.err.contains("leaves up to 12 mm over the target, in its bore") && left.err.contains("--drill 20."),
             left.err);
    const Ran bored = fixture.run({"program", "t.dxf", "--stock", "cylinder:40x100", "--drill", "auto", "-o", "b.ngc"});
    QVERIFY2(bored.code == 0 && !bored.err.contains("leaves"), bored.err);
  }

  void mistakesHaveLineAndColumn() {
    const Fixture fixture;
    fixture.put("p.ngc", "G21 G18\nG0 X10\nG1 X8 Y2 F100\nM2\n");
    const Ran ran = fixture.run({"turn", "cylinder:40x100", "--program", "p.ngc", "-o", "a.step"});
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains("p.ngc") && ran.err.contains("line 3") && ran.err.contains("column 7, Y2"), ran.err);
    QVERIFY(!fixture.names().contains("a.step"));
    // A target that cannot be read is reported before anything is cut or written.
    fixture.put("good.ngc", kShoulder);
    fixture.put("bad.dxf", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n");
    for (const char* const target : {"none.dxf", "bad.dxf"})
      QCOMPARE(
          fixture.run({"turn", "cylinder:40x100", "--program", "good.ngc", "--target", target, "-o", "a.step"}).code,
          1);
    QVERIFY(!fixture.names().contains("a.step"));
    fixture.put("air.ngc", "G0 X100\nM2\n");
    QCOMPARE(fixture.run({"turn", "cylinder:40x100", "--program", "air.ngc", "-o", "a.step"}).code, 2);
    for (const char* const stock :
         {"cylinder:40", "cylinder:0x100", "cylinder:axb", "cylinder:nanx1", "none.handwheel"})
      QCOMPARE(fixture.run({"turn", stock, "--program", "p.ngc", "-o", "a.step"}).code, 1);
    QCOMPARE(fixture.run({"turn", "cylinder:40x9", "--program", "p.ngc", "-o", "a.step", "--material", "cheese"}).code,
             1);
    QCOMPARE(fixture.run({"turn", "cylinder:40x9", "--program", "p.ngc", "-o", "a.step", "--dialect", "x"}).code, 1);
  }
};

HANDWHEEL_TEST(TurnProgramTest)
#include "TurnProgramTest.moc"
