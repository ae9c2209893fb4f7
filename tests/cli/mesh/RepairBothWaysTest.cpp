// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

// A repair by triangles and by volume, compared, of which one is written.
class RepairBothWaysTest : public QObject {
  Q_OBJECT

 private slots:
  // Both methods close a hole in a cube. The triangle repair moves nothing, and its result is written.
  void trianglesKeepWhatIsSound() {
    const Fixture fixture;
    Shape open = cube(10.0);
    open.faces.pop_back();
    fixture.put("a.off", open.off());
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.off", "--by", "both", "--voxel", "0.5", "--json"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto result = nlohmann::json::parse(ran.out.toStdString());
    QCOMPARE(result["written"].get<std::string>(), std::string("triangles"));
    QCOMPARE(result["ways"].size(), std::size_t{2});
    QCOMPARE(result["ways"][0]["scan_distance_mm"].get<double>(), 0.0);
    QCOMPARE(result["ways"][0]["triangles"].get<int>(), 12);
    QVERIFY(result["ways"][1]["sound"].get<bool>());
    QVERIFY(result["ways"][1]["scan_distance_mm"].get<double>() < 0.5);
    QCOMPARE(fixture.inspected("b.off").at("volume_mm3").get<double>(), 1000.0);
  }

  // Cubes through one another intersect after a repair by triangles, which cuts only when asked. By volume they are
  // one.
  void volumeWhereTrianglesLeaveDefects() {
    const Fixture fixture;
    Shape two = cube(10.0);
    two.add(cube(10.0), {5.0, 5.0, 5.0});
    fixture.put("a.off", two.off());
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl", "--by", "both", "--voxel", "0.25"}, "de_DE.UTF-8");
    QCOMPARE(ran.code, 0);
    QVERIFY2(ran.out.contains("b.stl: the repair by volume"), ran.out.constData());
    const auto mesh = fixture.inspected("b.stl");
    QCOMPARE(mesh.at("components").get<int>(), 1);
    QVERIFY(std::abs(mesh.at("volume_mm3").get<double>() / 1875.0 - 1.0) < 0.02);
    // The other method succeeds too, and then its result is written.
    const Ran cut =
        fixture.run({"repair", "a.off", "-o", "c.off", "--by", "both", "--voxel", "0.25", "--cut-crossings"});
    QCOMPARE(cut.code, 0);
    QVERIFY2(cut.out.contains("c.off: the repair by triangles"), cut.out.constData());
    QCOMPARE(fixture.inspected("c.off").at("self_intersecting_pairs").get<int>(), 0);
  }

  // A volume has no sheets: one beside a body is lost, so the result is that of the triangles, with the reason.
  void whatAVolumeLoses() {
    const Fixture fixture;
    Shape part = cube(10.0);
    part.add({{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}, {{0, 1, 2}}}, {30.0, 0.0, 0.0});
    fixture.put("a.off", part.off());
    const QStringList words = {"repair", "a.off", "-o", "b.off", "--by", "both", "--voxel", "0.5"};
    const Ran ran = fixture.run(words);
    QCOMPARE(ran.code, 2);
    QVERIFY2(ran.out.contains("the repair by triangles. That by volume has lost open sheets"), ran.out);
    const auto result = nlohmann::json::parse(fixture.run(words + QStringList{"--json"}).out.toStdString());
    QVERIFY(result["ways"][1]["sound"].get<bool>());
    // The farthest corner is 30 mm from the cube's side, at its height.
    QVERIFY(std::abs(result["lost_by_volume_mm"].get<double>() - 30.0) < 0.5);
    QCOMPARE(fixture.inspected("b.off").at("triangles").get<int>(), 13);
  }

  // A surface that encloses nothing has no volume: the row says so, and the result of the triangle repair is written.
  void withoutVolume() {
    const Fixture fixture;
    fixture.put("flat.off", "OFF\n3 1 0\n0 0 0\n10 0 0\n0 10 0\n3 0 1 2\n");
    const Ran ran = fixture.run({"repair", "flat.off", "-o", "b.off", "--by", "both", "--json"});
    QCOMPARE(ran.code, 2);
    const auto result = nlohmann::json::parse(ran.out.toStdString());
    QCOMPARE(result["written"].get<std::string>(), std::string("triangles"));
    QVERIFY(result["ways"][1]["error"].get<std::string>().find("encloses no volume") != std::string::npos);
    QVERIFY(fixture.names().contains("b.off"));
  }

  // One table over several files. What fails is a row, and the others go on.
  void severalFiles() {
    const Fixture fixture;
    Shape open = cube(10.0);
    open.faces.pop_back();
    fixture.put("a, open.off", open.off());
    fixture.put("flat.off", "OFF\n3 1 0\n0 0 0\n10 0 0\n0 10 0\n3 0 1 2\n");
    fixture.put("none.off", "OFF\n");
    const QStringList words{"repair", "a, open.off", "flat.off", "none.off", "-o",
                            "out",    "--by",        "both",     "--voxel",  "0.5"};
    const Ran table = fixture.run(words + QStringList{"--report", "t.csv"});
    QCOMPARE(table.code, 1);
    QVERIFY2(table.out.contains("encloses no volume"), table.out.constData());
    const QList<QByteArray> lines = fixture.content("t.csv").trimmed().split('\n');
    QCOMPARE(lines.size(), 6);  // a header, two files with two methods each, and a failure
    QVERIFY2(lines[1].startsWith("\"a, open.off\",triangles,yes,") && lines[1].contains(",12,"), lines[1]);
    QVERIFY2(lines[2].startsWith("\"a, open.off\",volume,yes,"), lines[2]);
    QVERIFY2(lines[3].startsWith("flat.off,triangles,no,") && lines[4].startsWith("flat.off,volume,no,"), lines[4]);
    QVERIFY2(lines[5].startsWith("none.off,,no,no result,"), lines[5]);
    QCOMPARE(fixture.inspected("out/a, open.off").at("volume_mm3").get<double>(), 1000.0);
    // A folder, too.
    QVERIFY(QDir(fixture.path()).mkdir("in"));
    fixture.put("in/open.off", open.off());
    const Ran folder =
        fixture.run({"repair", "in", "-o", "all", "--by", "both", "--voxel", "0.5", "--report", "t.html", "--json"});
    QCOMPARE(folder.code, 0);
    const auto repairs = nlohmann::json::parse(folder.out.toStdString())["repairs"];
    QCOMPARE(repairs.size(), std::size_t{2});
    QVERIFY(repairs[0]["written"].get<bool>() && !repairs[1]["written"].get<bool>());
    QCOMPARE(fixture.content("t.html").count("<tr>"), 3);
    QVERIFY(!fixture.content("all/open.off").isEmpty());
    QCOMPARE(fixture.run(words + QStringList{"--report", "t.json"}).code, 1);
  }

  // Each file has a process of its own, which may be ended: the table has a row for it.
  void filesThatTakeTooLong() {
    const Fixture fixture;
    fixture.put("a.off", cube(10.0).off());
    fixture.put("b.off", cube(10.0).off());
    const QStringList words{"repair", "a.off", "b.off", "-o", "out", "--by", "both", "--time-limit"};
    const Ran ran = fixture.run(words + QStringList{"0.001", "--json"});
    QCOMPARE(ran.code, 1);
    const auto repairs = nlohmann::json::parse(ran.out.toStdString())["repairs"];
    QCOMPARE(repairs.size(), std::size_t{2});
    for (const auto& row : repairs) {
      QCOMPARE(row["reason"].get<std::string>(), std::string("It took longer than 0.001 s."));
      QVERIFY(!row["written"].get<bool>());
    }
    QCOMPARE(fixture.run(words + QStringList{"1000", "--voxel", "0.5"}).code, 0);
    QCOMPARE(fixture.inspected("out/b.off").at("volume_mm3").get<double>(), 1000.0);
    QCOMPARE(fixture.run(words + QStringList{"0"}).code, 1);
    QCOMPARE(fixture.run(words + QStringList{"1000", "--format", "xyz"}).code, 1);
  }

  void refusals() {
    const Fixture fixture;
    fixture.put("a.off", cube(10.0).off());
    for (const QStringList& more : {QStringList{"--report", "r.json"}, QStringList{"a.off"}, QStringList{"-j", "2"},
                                    QStringList{"--keep-open", "3"}, QStringList{"--time-limit", "9"}}) {
      const Ran ran = fixture.run(QStringList{"repair", "a.off", "-o", "b.off", "--by", "both"} + more);
      QCOMPARE(ran.code, 1);
      QVERIFY(!ran.err.isEmpty() && !fixture.names().contains("b.off"));
    }
  }
};

HANDWHEEL_TEST(RepairBothWaysTest)
#include "RepairBothWaysTest.moc"
