// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <utility>

using namespace handwheel;

namespace {

nlohmann::json drillJson(const QByteArray& out) {
  return nlohmann::json::parse(out.toStdString());
}

}  // namespace

// Voxels of triangles are made near the head only.
class DrillTest : public QObject {
  Q_OBJECT

 private slots:
  // Near the head, or of all of the part: the same figures, of fewer voxels. A top that is missing is closed by a lid.
  void asAllOfThePart() {
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,10.1,9.9,23\n1,10.1,9.9,-4\n1.5,10.1,9.9,23\n");
    const QStringList words{"drill",  "a.off",   "--path", "p.csv",  "--tool",
                            "ball:4", "--voxel", "0.25",   "--rate", "200"};
    const Ran near = fixture.run(QStringList(words) << "--json");
    QCOMPARE(near.err, QByteArray());
    QCOMPARE(near.code, 0);
    const Ran all = fixture.run(QStringList(words) << "--whole"
                                                   << "--json");
    QCOMPARE(all.code, 0);
    const auto figures = drillJson(near.out), whole = drillJson(all.out);
    for (const char* const key : {"removed_mm3", "max_thrust_N", "max_torque_Nmm", "energy_J", "breakthrough_s"}) {
      const double value = figures[key].get<double>();
      QVERIFY2(value > 0.0 && std::abs(value - whole[key].get<double>()) <= 1e-9 * value, key);
    }
    QVERIFY(figures["hybrid"].get<bool>() && !whole["hybrid"].get<bool>());
    QVERIFY(figures["voxels_at_most"].get<double>() < whole["voxels_at_most"].get<double>());
    QVERIFY(!figures.contains("predicted_bytes") && whole.contains("predicted_bytes"));
    QVERIFY(fixture.run(words).out.contains("Voxels were made near the head"));
    const Ran saved = fixture.run(QStringList(words) << "-o"
                                                     << "b.handwheel"
                                                     << "--json");
    QCOMPARE(saved.code, 0);
    QVERIFY(!drillJson(saved.out)["hybrid"].get<bool>());
    // A part that is a volume already needs no voxels from triangles.
    QVERIFY(!drillJson(fixture.run({"drill", "b.handwheel", "--path", "p.csv", "--json"}).out).contains("hybrid"));
  }

  // 0.1 mm on a part of 300 mm, whose voxels would take more than a gigabyte, in a few megabytes.
  void fineVoxelsOnALargePart() {
    const Fixture fixture;
    fixture.put("a.off", cube(300.0).off());
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,140.03,150.04,302\n1,140.03,150.04,299\n");
    const Ran ran = fixture.run(
        {"drill", "a.off", "--path", "p.csv", "--tool", "ball:3", "--voxel", "0.1", "--rate", "100", "--json"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto figures = drillJson(ran.out);
    const double exact = M_PI * 2.25 * 1.0 + 2.0 / 3.0 * M_PI * 3.375;  // a cylinder, and half a ball before it
    QVERIFY(std::abs(figures["removed_mm3"].get<double>() / exact - 1.0) < 0.01);
    QVERIFY(figures["voxel_MB_at_most"].get<double>() < 10.0 && figures["voxels_made"].get<double>() > 0.0);
  }

  // A mesh has the hole in the triangles of the part, whether its numbers are those of STL or not: the volume is that
  // of the cube less the hole, and the eight triangles of the sides are as they were.
  void holeInTheTriangles() {
    const Fixture fixture;
    fixture.put("a.off", cube(20.0).off());
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,10.3,9.4,23\n1,10.3,9.4,-4\n");
    const QStringList words{"drill",   "a.off", "--path", "p.csv", "--tool", "ball:4",
                            "--voxel", "0.25",  "--rate", "200",   "-o"};
    for (const QString name : {"b.off", "b.stl"}) {
      const Ran ran = fixture.run(QStringList(words) << name << "--json");
      QCOMPARE(ran.err, QByteArray());
      QCOMPARE(ran.code, 0);
      const auto figures = drillJson(ran.out);
      QVERIFY(figures["hybrid"].get<bool>() && figures["joined"].get<bool>() && !figures.contains("not_joined"));
      QCOMPARE(figures["kept_triangles"].get<int>(), 8);
      const auto mesh = drillJson(fixture.run({"inspect", name, "--json"}).out);
      QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>() && mesh["oriented"].get<bool>());
      QCOMPARE(mesh["self_intersecting_pairs"].get<int>(), 0);
      QCOMPARE(mesh["triangles"].get<int>(), figures["triangles"].get<int>());
      const double hole = 8000.0 - mesh["volume_mm3"].get<double>();
      QVERIFY2(std::abs(hole / (M_PI * 4.0 * 20.0) - 1.0) < 0.01, QByteArray::number(hole));
    }
    QVERIFY(fixture.run(QStringList(words) << "c.ply").out.contains("8 of"));
    const auto whole = drillJson(fixture.run(QStringList(words) + QStringList{"d.off", "--whole", "--json"}).out);
    QVERIFY(!whole["hybrid"].get<bool>() && !whole.contains("joined"));
    // A top that is missing is closed by a lid of four.
    fixture.put("a.off", openCube(20.0).off());
    const auto lidded = drillJson(fixture.run(QStringList(words) + QStringList{"e.off", "--json"}).out);
    QVERIFY(lidded["joined"].get<bool>());
    QCOMPARE(lidded["closing_triangles"].get<int>(), 4);
    QCOMPARE(lidded["kept_triangles"].get<int>(), 8);
    QVERIFY(fixture.run(QStringList(words) << "e.off").out.contains("closed by 4 triangles"));
  }

  // If that is impossible, the surface of all voxels is written, and the report states the reason.
  void holeInTheVoxels_data() {
    QTest::addColumn<bool>("isCrossing");
    QTest::addColumn<QStringList>("more");
    QTest::newRow("bodies that overlap elsewhere") << true << QStringList{};
    QTest::newRow("material left in the head") << false << QStringList{"--erosion", "2"};
  }
  void holeInTheVoxels() {
    QFETCH(bool, isCrossing);
    QFETCH(QStringList, more);
    const Fixture fixture;
    Shape part = cube(20.0);
    if (isCrossing) part.add(cube(10.0), {40.0, 40.0, 40.0}).add(cube(10.0), {45.0, 45.0, 45.0});
    fixture.put("a.off", part.off());
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,10.3,9.4,23\n1,10.3,9.4,-4\n");
    const QStringList words = QStringList{"drill",   "a.off", "--path", "p.csv", "--tool", "ball:4",
                                          "--voxel", "0.25",  "--rate", "200",   "-o",     "b.off"} +
                              more;
    const Ran ran = fixture.run(QStringList(words) << "--json");
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto figures = drillJson(ran.out);
    QVERIFY(!figures["hybrid"].get<bool>() && !figures["joined"].get<bool>());
    QVERIFY(!figures["not_joined"].get<std::string>().empty());
    const auto mesh = drillJson(fixture.run({"inspect", "b.off", "--json"}).out);
    QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>());
    QVERIFY(fixture.run(words).out.contains("because"));
  }

  // Columns that a path does not need may hold anything, also those that number the strokes of a hand elsewhere.
  void otherColumns() {
    const Fixture fixture;
    fixture.put("a.off", cube(20.0).off());
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,10.1,9.9,23\n1,10.1,9.9,15\n2,10.1,9.9,23\n3,10.1,9.9,15\n");
    fixture.put("q.csv",
                "stroke,t_s,x_mm,y_mm,z_mm,stroke\n2.5,0,10.1,9.9,23,first\n,1,10.1,9.9,15,\n-1,2,10.1,9.9,23,nan\n"
                "1,3,10.1,9.9,15\n");
    const auto removedBy = [&](const char* path) {
      const Ran ran = fixture.run(
          {"drill", "a.off", "--path", path, "--voxel", "0.25", "--rate", "100", "--tool", "ball:4", "--json"});
      if (ran.code != 0) qWarning("%s", ran.err.constData());
      return ran.code == 0 ? drillJson(ran.out)["removed_mm3"].get<double>() : -1.0;
    };
    const double removed = removedBy("p.csv");
    QVERIFY(removed > 0.0);
    QCOMPARE(removedBy("q.csv"), removed);
  }

  // Beside the part nothing is drilled, and no voxel is made.
  void besideThePart() {
    const Fixture fixture;
    fixture.put("a.off", cube(20.0).off());
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,60,10,25\n1,60,10,-5\n");
    const Ran ran = fixture.run({"drill", "a.off", "--path", "p.csv", "--voxel", "0.3", "--json"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto figures = drillJson(ran.out);
    QCOMPARE(figures["removed_mm3"].get<double>(), 0.0);
    QCOMPARE(figures["voxels_made"].get<int>(), 0);
    QVERIFY(figures["breakthrough_s"].is_null());
  }

  // Bodies that overlap: walls within them vanish, which only the whole part tells. It is made of voxels, then; the
  // hole is in one of the bodies, beside the other.
  void overlappingBodies() {
    const Fixture fixture;
    fixture.put("a.off", cube(20.0).add(cube(10.0), {15.0, 5.0, 5.0}).off());
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,8.1,10.1,24\n1,8.1,10.1,-4\n");
    const Ran ran = fixture.run(
        {"drill", "a.off", "--path", "p.csv", "--tool", "ball:4", "--voxel", "0.25", "--rate", "200", "--json"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto figures = drillJson(ran.out);
    QVERIFY(!figures["hybrid"].get<bool>());
    QVERIFY(std::abs(figures["removed_mm3"].get<double>() / (M_PI * 4.0 * 20.0) - 1.0) < 0.015);
  }

  // A body that is inside out encloses nothing, and takes nothing from the sound one beside it, however large it is:
  // the whole part tells. Alone it is refused.
  void besideABodyInsideOut() {
    const Fixture fixture;
    Shape insideOut = cube(20.0);
    for (auto& face : insideOut.faces) std::swap(face[1], face[2]);
    fixture.put("a.off", cube(5.0).add(insideOut, {10.0, 0.0, 0.0}).off());
    fixture.put("b.off", insideOut.off());
    fixture.put("p.csv", "t_s,x_mm,y_mm,z_mm\n0,2.53,2.47,8\n1,2.53,2.47,-3\n");
    const QStringList words{"--path", "p.csv", "--tool", "ball:3", "--voxel", "0.125", "--rate", "200", "--json"};
    const Ran ran = fixture.run(QStringList{"drill", "a.off"} + words);
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto figures = drillJson(ran.out);
    QVERIFY(!figures["hybrid"].get<bool>());
    const double exact = M_PI * 1.5 * 1.5 * 5.0;
    QVERIFY(std::abs(figures["removed_mm3"].get<double>() / exact - 1.0) < 0.03);  // by voxels on the border
    const Ran alone = fixture.run(QStringList{"drill", "b.off"} + words);
    QCOMPARE(alone.code, 1);
    QVERIFY(alone.out.isEmpty() && alone.err.contains("b.off"));
  }

  // The curves of He's runs have the shapes that he states.
  void experiments() {
    const Fixture fixture;
    const Ran ran = fixture.run({"drill-experiments", "feed", "--values", "10,6", "--plot", "runs.csv", "--json"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto experiment = drillJson(ran.out)["experiments"][0];
    QCOMPARE(experiment["holes"].size(), std::size_t{2});
    QCOMPARE(experiment["holes"][0]["value"].get<double>(), 6.0);
    QCOMPARE(experiment["checks"].size(), std::size_t{1});
    QVERIFY(experiment["checks"][0]["holds"].get<bool>());
    const QByteArray points = fixture.content("runs.csv");
    for (const char* const series : {"Handwheel", "He 2008", "Balance of energy", "(3-22)", "(3-23)"})
      QVERIFY(points.contains(series));
    const Ran unknown = fixture.run({"drill-experiments", "speed"});
    QCOMPARE(unknown.code, 1);
    QVERIFY(unknown.err.contains("There is no experiment speed"));
    for (const char* const values : {"", "1,", "0", "1,-2", "nan", "1e-9", "fast"})
      QCOMPARE(fixture.run({"drill-experiments", "feed", "--values", values}).code, 1);
    QCOMPARE(fixture.run({"drill-experiments", "--values", "1"}).code, 1);
  }
};

HANDWHEEL_TEST(DrillTest)
#include "DrillTest.moc"
