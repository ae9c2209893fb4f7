// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "BuildPaths.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <map>

using namespace handwheel;

// Drilling in the volumes of files, by paths, by programs, and in the exercise that ships.
class DrilledFilesTest : public QObject {
  Q_OBJECT

 private slots:
  // The built-in exercise without a window: it is drilled along the planned path by positions of the head alone, handed
  // in and marked. Drilling into the brain gives no points.
  void drillTheExercise_data() {
    QTest::addColumn<double>("end");
    QTest::addColumn<int>("points");
    QTest::newRow("good") << 7.5 << 100;
    QTest::newRow("into the brain") << 16.0 << 0;
  }
  void drillTheExercise() {
    QFETCH(double, end);
    QFETCH(int, points);
    const Fixture fixture;
    const QString exercise = test::sourcePath("resources/samples/exercises/skull.exercise.json");
    QCOMPARE(fixture.run({"exercise", exercise, "--stock", "-o", "stock.handwheel"}).code, 0);
    // Beside the middle by 30 mm, in front of it by 35, on the ellipsoid of 72, 90 and 66 mm, across its surface.
    const double x = 30.0, y = -35.0, z = 66.0 * std::sqrt(1.0 - x * x / 5184.0 - y * y / 8100.0);
    double in[3] = {-x / 5184.0, -y / 8100.0, -z / 4356.0};
    const double length = std::sqrt(in[0] * in[0] + in[1] * in[1] + in[2] * in[2]);
    const double from = -8.0 - 3.0, to = end - 3.0;  // positions of the centre of a head of 6 mm
    QByteArray path("t_s,x_mm,y_mm,z_mm\n");
    for (const double depth : {from, to})
      path += QStringLiteral("%1,%2,%3,%4\n")
                  .arg(depth - from)  // 1 mm/s
                  .arg(x + depth * in[0] / length, 0, 'f', 6)
                  .arg(y + depth * in[1] / length, 0, 'f', 6)
                  .arg(z + depth * in[2] / length, 0, 'f', 6)
                  .toLatin1();
    fixture.put("p.csv", path);
    const Ran drilled =
        fixture.run({"drill", "stock.handwheel", "--path", "p.csv", "--rate", "100", "-o", "work.handwheel", "--json"});
    QCOMPARE(drilled.err, QByteArray());
    QCOMPARE(drilled.code, 0);
    // 8 mm of air, then the 6.5 mm of bone a little obliquely to the inner table.
    const double through = jsonOf(drilled)["breakthrough_s"].get<double>();
    QVERIFY2(through > 14.0 && through < 14.7, QByteArray::number(through));
    QCOMPARE(
        fixture.run({"exercise", exercise, "--hand-in", "work.handwheel", "--name", "Ada", "-o", "ada.handwheel"}).code,
        0);
    const Ran marked = fixture.run({"mark", exercise, "ada.handwheel", "--csv", "class.csv", "--report", "ada.html"});
    QCOMPARE(marked.code, 0);
    const QList<QByteArray> row = fixture.content("class.csv").split('\n').at(1).split(',');
    QVERIFY2(row.contains(QByteArray::number(points)), fixture.content("class.csv"));
    const QByteArray report = fixture.content("ada.html");
    QVERIFY(report.contains("Thrust") && report.contains("Breakthrough: the drill is through"));
    QCOMPARE(report.contains("entered the forbidden region"), points == 0);
    QVERIFY(report.contains("alt=\"work0-picture-0\"") && report.contains("The hole in section"));
    QVERIFY(report.contains("Largest thrust: ") && report.contains("Largest torque: "));
  }

  // Down through a block of 20 mm: a hole of the ball's diameter, the work of its volume, and the time at which the
  // front comes out.
  void drill() {
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    QByteArray path("t_s,x_mm,y_mm,z_mm\n0,10,10,25\n6,10,10,-5\n");  // 5 mm/s
    fixture.put("p.csv", path);
    const Ran ran = fixture.run({"drill", "a.off", "--path", "p.csv", "--tool", "ball:6", "--voxel", "0.35", "--rate",
                                 "250", "--rpm", "1200", "-o", "b.handwheel", "--forces", "f.csv", "--json"},
                                "de_DE.UTF-8");
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto figures = jsonOf(ran);
    const double hole = M_PI * 9.0 * 20.0;
    QVERIFY(std::abs(figures["removed_mm3"].get<double>() / hole - 1.0) < 0.01);
    QVERIFY(std::abs(figures["energy_J"].get<double>() / (0.25 * hole) - 1.0) < 0.01);  // 250 N/mm²
    // The front is 3 mm below the centre: at z = 0 after 22 mm.
    QVERIFY(std::abs(figures["breakthrough_s"].get<double>() - 22.0 / 5.0) < 0.1);
    // kp A f / (f + ktc d ω / 2), (A-6) with the rate of the full section.
    const double thrust = 250.0 * M_PI * 9.0 * 5.0 / (5.0 + 0.5 * 1.64 * 6.0 * 2.0 * M_PI * 20.0);
    QVERIFY(std::abs(figures["max_thrust_N"].get<double>() / thrust - 1.0) < 0.2);
    QVERIFY(std::abs(figures["max_torque_Nmm"].get<double>() / (1.64 * 3.0 * thrust) - 1.0) < 0.2);
    QVERIFY(fixture.content("f.csv").startsWith("t_s,x_mm,y_mm,z_mm,thrust_N"));
    const auto inspected = fixture.inspected("b.handwheel");
    QCOMPARE(inspected["document"]["voxel"].get<double>(), 0.35);
    const Ran text = fixture.run({"drill", "b.handwheel", "--path", "p.csv"});
    QCOMPARE(text.code, 0);
    QVERIFY(text.out.contains("not verified"));
  }

  // A hole of 12 mm in pecks of 5: the thrust is there three times, and falls to nothing between them; one without
  // pecks has it once. Both take the same from the block.
  void drillByProgram() {
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    const QByteArray begin = "G21 G90\nS1200 M3\nG0 X10 Y10 Z22\n", end = "G80\nM30\n";
    fixture.put("pecks.ngc", begin + "G83 Z8 R21 Q5 F300\n" + end);
    fixture.put("plain.ngc", begin + "G81 Z8 R21 F300\n" + end);
    std::map<QString, double> removed;
    for (const QString name : {"pecks", "plain"}) {
      const Ran ran = fixture.run({"drill", "a.off", "--program", name + ".ngc", "--tool", "ball:6", "--voxel", "0.35",
                                   "--rate", "250", "--forces", name + ".csv", "--json"});
      QCOMPARE(ran.err, QByteArray());
      QCOMPARE(ran.code, 0);
      removed[name] = jsonOf(ran)["removed_mm3"].get<double>();
      // A cylinder from the top, less half a ball that the foremost point is ahead by.
      QVERIFY(std::abs(removed[name] / (M_PI * 9.0 * 9.0 + 18.0 * M_PI) - 1.0) < 0.01);
      int pecks = 0;
      double last = -1.0;  // s, of a cycle with thrust
      for (const QByteArray& line : fixture.content(name + ".csv").split('\n').mid(1)) {
        const QList<QByteArray> cells = line.split(',');
        if (cells.size() < 5 || !(cells[4].toDouble() > 1.0)) continue;
        const double time = cells[0].toDouble();
        pecks += time - last > 0.15;
        last = time;
      }
      QCOMPARE(pecks, name == "pecks" ? 3 : 1);
    }
    QVERIFY(std::abs(removed["pecks"] / removed["plain"] - 1.0) < 0.01);
    fixture.put("bad.ngc", begin + "G2 X3 Y4\n");
    const Ran bad = fixture.run({"drill", "a.off", "--program", "bad.ngc"});
    QCOMPARE(bad.code, 1);
    QVERIFY2(bad.err.contains("bad.ngc") && bad.err.contains("line 4") && bad.err.contains("G2"), bad.err);
    QCOMPARE(fixture.run({"drill", "a.off", "--program", "plain.ngc", "--path", "p.csv"}).code, 1);
  }

  void whatCannotBeDrilled_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("no path") << QStringList{"drill", "a.off"} << QByteArray("--path FILE is missing");
    QTest::newRow("no file") << QStringList{"drill", "a.off", "--path", "none.csv"} << QByteArray("none.csv");
    QTest::newRow("no drill") << QStringList{"drill", "a.off", "--path", "p.csv", "--tool", "chisel:3"}
                              << QByteArray("chisel:3");
    QTest::newRow("no material") << QStringList{"drill", "a.off", "--path", "p.csv", "--material", "moon"}
                                 << QByteArray("moon");
    QTest::newRow("bad path") << QStringList{"drill", "a.off", "--path", "a.off"} << QByteArray("Line 1");
  }
  void whatCannotBeDrilled() {
    QFETCH(QStringList, words);
    QFETCH(QByteArray, says);
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,10,10,25\n1,10,10,20\n");
    const Ran ran = fixture.run(words);
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains(says), ran.err);
  }
};

HANDWHEEL_TEST(DrilledFilesTest)
#include "DrilledFilesTest.moc"
