// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "TestClass.h"
#include "process/SystemMemory.h"

#include <QTest>
#include <cmath>
#include <map>

using namespace handwheel;

class VolumeTest : public QObject {
  Q_OBJECT

 private slots:
  // A mesh becomes a volume, which is inspected and becomes a mesh: a block without its top is the block.
  void thereAndBack() {
    const Fixture fixture;
    fixture.put("a.off", openCube(10.0).off());
    const Ran made = fixture.run({"voxelize", "a.off", "-o", "a.handwheel", "--voxel", "0.5", "--json"}, "de_DE.UTF-8");
    QCOMPARE(made.err, QByteArray());
    QCOMPARE(made.code, 0);
    const auto figures = jsonOf(made);
    QCOMPARE(figures["voxel_mm"].get<double>(), 0.5);
    QCOMPARE(figures["closed_boundaries"].get<int>(), 1);
    QVERIFY(std::abs(figures["volume_mm3"].get<double>() / 1000.0 - 1.0) < 0.03);
    QVERIFY(std::abs(figures["enclosed_mm3"].get<double>() / 1000.0 - 1.0) < 1e-6);
    const auto inspected = fixture.inspected("a.handwheel");
    QCOMPARE(inspected["document"]["voxel"].get<double>(), 0.5);

    QCOMPARE(fixture.run({"remesh", "a.handwheel", "-o", "b.stl"}).code, 0);
    const auto mesh = fixture.inspected("b.stl");
    QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>() && mesh["oriented"].get<bool>());
    QVERIFY(std::abs(mesh["volume_mm3"].get<double>() / 1000.0 - 1.0) < 0.01);
    const Ran fewer = fixture.run({"remesh", "a.handwheel", "-o", "c.stl", "--error", "0.2", "--json"});
    QCOMPARE(fewer.code, 0);
    const auto reduced = jsonOf(fewer);
    QVERIFY(reduced["triangles"].get<int>() < reduced["triangles_before"].get<int>() / 10);
    QVERIFY(reduced["distance_mm"].get<double>() <= 0.2);
  }

  // Before a volume is made it is said what that needs. Where it is half of the memory that is left nothing is made
  // unless somebody agrees; what is more than all of it stays refused.
  void memoryIsSaidAndAskedFor() {
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    const Ran said = fixture.run({"voxelize", "a.off", "-o", "a.handwheel", "--voxel", "2"});
    QVERIFY2(said.out.startsWith("Voxels of 2 mm need about ") && said.out.contains(" MB available"), said.out);
    const auto figures =
        jsonOf(fixture.run({"repair", "a.off", "-o", "b.stl", "--by", "volume", "--voxel", "2", "--json"}));
    const double bytes = figures["predicted_bytes"].get<double>();
    QVERIFY(bytes > 0.0 && figures["predicted_s"].get<double>() > 0.0);
    const auto voxelFor = [&](double share) {  // share of the memory; it grows with the square
      return QString::number(2.0 * std::sqrt(bytes / (share * static_cast<double>(systemMemory()))), 'g', 6);
    };
    const QList<QStringList> commands{{"voxelize", "a.off", "-o", "c.handwheel"},
                                      {"repair", "a.off", "-o", "c.stl", "--by", "volume"},
                                      {"shell", "a.off", "-o", "c.handwheel", "--wall", "4"},
                                      {"boolean", "a.off", "a.off", "--unite", "-o", "c.handwheel"}};
    for (const QStringList& command : commands) {
      const Ran large = fixture.run(QStringList(command) << "--voxel" << voxelFor(0.5));
      QCOMPARE(large.code, 1);
      QVERIFY2(large.err.contains("a.off") && large.err.contains("more than a quarter of the ") &&
                   large.err.contains("--yes"),
               large.err);
      const Ran huge = fixture.run(QStringList(command) << "--voxel" << voxelFor(3.0) << "--yes");
      QCOMPARE(huge.code, 1);
      QVERIFY2(huge.err.contains(" MB are available") && !huge.err.contains("--yes"), huge.err);
      QCOMPARE(fixture
                   .run(QStringList(command) << "--voxel"
                                             << "2"
                                             << "--yes")
                   .code,
               0);
    }
    const Ran edited = fixture.run({"edit", "a.off", "by-volume --voxel=" + voxelFor(0.5), "-o", "d.off"});
    QVERIFY2(edited.err.contains("more than a quarter"), edited.err);
  }

  // A plate of 0.3 mm between samples 1 mm apart is lost, which is a warning; of a cube alone nothing is said.
  void thinWallsAreSaid() {
    const Fixture fixture;
    Shape part = cube(10.0), plate = cube(1.0);
    fixture.put("a.off", part.off());
    for (auto& p : plate.points) p = {0.3 * p[0], 10.0 * p[1], 10.0 * p[2]};
    part.add(plate, {20.0, 0.0, 0.0});
    fixture.put("b.off", part.off());
    for (const QByteArray name : {"a", "b"}) {
      const Ran ran = fixture.run({"voxelize", name + ".off", "-o", name + ".handwheel", "--voxel", "1", "--json"});
      QCOMPARE(ran.code, 0);
      QCOMPARE(ran.err.contains("Walls thinner than a voxel (1 mm) were lost"), name == "b");
      // 212 mm² of 812 are the plate's.
      const double near = jsonOf(ran)["near_share"].get<double>();
      QVERIFY2(std::abs(near - (name == "b" ? 600.0 / 812.0 : 1.0)) < 0.01, qPrintable(QString::number(near)));
    }
  }

  // 5 km from the origin, single precision has steps of 0.5 mm: of triangles of 0.25 mm many lose their area in an STL,
  // which is said. OFF keeps all digits.
  void remeshedFilesAreChecked() {
    const Fixture fixture;
    Shape far = cube(4.0);
    for (auto& p : far.points)
      for (double& x : p) x += 5e6;
    fixture.put("a.off", far.off());
    QCOMPARE(fixture.run({"voxelize", "a.off", "-o", "a.handwheel", "--voxel", "0.25"}).code, 0);
    const Ran rounded = fixture.run({"remesh", "a.handwheel", "-o", "b.stl", "--json"});
    QCOMPARE(rounded.code, 2);
    QVERIFY(!jsonOf(rounded)["sound"].get<bool>());
    const auto inFile = fixture.inspected("b.stl");
    QVERIFY(inFile["closed"].get<bool>());
    const Ran exact = fixture.run({"remesh", "a.handwheel", "-o", "b.off", "--json"});
    QCOMPARE(exact.code, 0);
    QVERIFY(jsonOf(exact)["sound"].get<bool>());
    const auto meant = fixture.inspected("b.off");
    const int lost = inFile["degenerate_faces"].get<int>() - meant["degenerate_faces"].get<int>();
    QVERIFY(lost > 1000);
    QVERIFY2(rounded.err.contains(", " + QByteArray::number(lost) + " more triangles have no area"), rounded.err);
    const Ran fewer = fixture.run({"remesh", "a.handwheel", "-o", "c.off", "--faces", "500", "--json"});
    QCOMPARE(fewer.code, 0);
    const int left = jsonOf(fewer)["triangles"].get<int>();
    QVERIFY2(left >= 490 && left <= 500, QByteArray::number(left));
  }

  // Two blocks of meshes, the second of which is in the first by a half, as meshes and one as a volume.
  void booleans_data() {
    QTest::addColumn<QByteArray>("option");
    QTest::addColumn<double>("exact");
    QTest::addColumn<bool>("isVolume");  // the second
    QTest::newRow("unite") << QByteArray("--unite") << 8000.0 + 1000.0 - 500.0 << false;
    QTest::newRow("subtract") << QByteArray("--subtract") << 8000.0 - 500.0 << false;
    QTest::newRow("subtract a volume") << QByteArray("--subtract") << 8000.0 - 500.0 << true;
    QTest::newRow("intersect") << QByteArray("--intersect") << 500.0 << true;
  }
  void booleans() {
    QFETCH(QByteArray, option);
    QFETCH(double, exact);
    QFETCH(bool, isVolume);
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    Shape small = cube();
    for (auto& p : small.points) p = {10.0 * p[0] + 15.0, 10.0 * p[1] + 5.0, 10.0 * p[2] + 5.0};
    fixture.put("b.off", small.off());
    if (isVolume) QCOMPARE(fixture.run({"voxelize", "b.off", "-o", "b.nrrd", "--voxel", "0.3"}).code, 0);
    const char* const second = isVolume ? "b.nrrd" : "b.off";
    const Ran ran = fixture.run({"boolean", "a.off", second, option, "-o", "c.stl", "--voxel", "0.5", "--json"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto figures = jsonOf(ran);
    QCOMPARE(figures["voxel_mm"].get<double>(), 0.5);
    QVERIFY(std::abs(figures["first_mm3"].get<double>() / 8000.0 - 1.0) < 0.03);
    const auto mesh = fixture.inspected("c.stl");
    QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>());
    QVERIFY2(std::abs(mesh["volume_mm3"].get<double>() / exact - 1.0) < 0.03,
             qPrintable(QString::number(mesh["volume_mm3"].get<double>())));
  }

  void booleanInWords() {
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    fixture.put("b.off", cube(10.0).off());
    const Ran ran = fixture.run({"boolean", "a.off", "b.off", "--subtract", "-o", "c.handwheel", "--voxel", "1"});
    QCOMPARE(ran.code, 0);
    QVERIFY2(ran.out.contains("voxels of 1 mm"), ran.out);
  }

  // With sharp edges a block is the block, where marching cubes cut its edges off; and by densities it is nearly so.
  void methods() {
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    std::map<QByteArray, double> off;
    for (const QByteArray sampling : {"sign", "density"}) {
      const Ran made = fixture.run({"voxelize", "a.off", "-o", "a.handwheel", "--voxel", "1", "--method", sampling});
      QCOMPARE(made.err, QByteArray());
      for (const QByteArray polygons : {"marching", "dual"}) {
        QCOMPARE(fixture.run({"remesh", "a.handwheel", "-o", "b.stl", "--method", polygons}).code, 0);
        const auto mesh = fixture.inspected("b.stl");
        QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>() && mesh["oriented"].get<bool>());
        QCOMPARE(mesh["self_intersecting_pairs"].get<int>(), 0);
        off[sampling + polygons] = std::abs(mesh["volume_mm3"].get<double>() / 8000.0 - 1.0);
      }
    }
    QVERIFY(off["signdual"] < 1e-4);
    QVERIFY(off["signmarching"] > 10.0 * off["signdual"]);
    QVERIFY(off["densitymarching"] < 0.02);
    QCOMPARE(fixture.run({"voxelize", "a.off", "-o", "a.handwheel", "--fidelity", "volume.voxels=40"}).code, 0);
    QCOMPARE(fixture.inspected("a.handwheel")["document"]["voxel"].get<double>(), 0.5);
    QVERIFY(
        fixture.run({"voxelize", "a.off", "-o", "a.vdb", "--fidelity", "snap.radius=2"}).err.contains("does not use"));
  }

  // A wall of 2 mm in a block of 20 mm: an empty cube of 16 mm within.
  void walls() {
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    const Ran ran =
        fixture.run({"shell", "a.off", "-o", "b.stl", "--wall", "2", "--voxel", "0.5", "--json"}, "de_DE.UTF-8");
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    QVERIFY(std::abs(jsonOf(ran)["volume_mm3"].get<double>() / (8000.0 - 4096.0) - 1.0) < 0.03);
    const auto mesh = fixture.inspected("b.stl");
    QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>());
    QCOMPARE(fixture.run({"shell", "a.off", "-o", "c.nrrd", "--wall", "1", "--side", "outside", "--voxel", "0.5"}).code,
             0);
    const Ran smaller = fixture.run({"offset", "c.nrrd", "-o", "d.stl", "--distance=-0.2", "--json"});
    QCOMPARE(smaller.err, QByteArray());
    // Steiner's formula for the rounded block: the wall is left from 0.2 to 0.8 mm.
    const auto rounded = [](double d) { return 2400.0 * d + 60.0 * M_PI * d * d + 4.0 / 3.0 * M_PI * d * d * d; };
    const auto left = fixture.inspected("d.stl")["volume_mm3"].get<double>();
    QVERIFY2(std::abs(left / (rounded(0.8) - rounded(0.2)) - 1.0) < 0.05, qPrintable(QString::number(left)));
  }

  // A block beside a large one is debris below the ball of its volume, a gap is filled, corners become round.
  void wholeVolumes() {
    const Fixture fixture;
    Shape two = cube(10.0);
    two.add(cube(4.0), {12.0, 0.0, 0.0});
    fixture.put("a.off", two.off());
    const auto left = [&](const QStringList& words, const char* voxel = "0.5") {
      QStringList all = words;
      const Ran ran = fixture.run(all << "a.off"
                                      << "-o"
                                      << "b.handwheel"
                                      << "--voxel" << voxel << "--json");
      return ran.code == 0 ? jsonOf(ran)["volume_mm3"].get<double>() : -1.0;
    };
    const double across = 4.0 * std::cbrt(6.0 / M_PI);  // diameter of the ball with the volume of the small block
    QVERIFY(std::abs(left({"debris", "--below", QString::number(0.9 * across)}) / 1064.0 - 1.0) < 0.03);
    QVERIFY(std::abs(left({"debris", "--below", QString::number(1.1 * across)}) / 1000.0 - 1.0) < 0.03);
    const double closed = left({"gaps", "--radius", "2"});
    QVERIFY2(closed > 1064.0 + 20.0 && closed < 1064.0 + 60.0, qPrintable(QString::number(closed)));
    const double once = left({"smooth"}, "0.25"), often = left({"smooth", "--passes", "5"}, "0.25");
    QVERIFY(once < 1064.0 && often < once && often > 0.9 * 1064.0);
    QCOMPARE(left({"gaps"}), -1.0);
    QCOMPARE(left({"smooth", "--passes", "0"}), -1.0);
  }

  // A gap of a millimetre between two plates is filled as part of the repair.
  void repairClosesGaps() {
    const Fixture fixture;
    Shape two = cube(10.0);
    for (auto& p : two.points) p[0] *= 0.3;
    two.add(Shape(two), {4.0, 0.0, 0.0});
    fixture.put("a.off", two.off());
    const Ran ran = fixture.run(
        {"repair", "a.off", "-o", "b.stl", "--by", "volume", "--voxel", "0.25", "--close-gaps", "0.7", "--json"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto figures = jsonOf(ran);
    QVERIFY(std::abs(figures["filled_mm3"].get<double>() - 90.0) < 5.0);
    QVERIFY(figures["kept_distance_mm"].get<double>() < 0.25);
    const auto mesh = fixture.inspected("b.stl");
    QCOMPARE(mesh["components"].get<int>(), 1);
    QVERIFY(std::abs(mesh["volume_mm3"].get<double>() / 690.0 - 1.0) < 0.02);
  }

  void repairByVolume() {
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl", "--by", "volume", "--voxel", "1", "--json"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto figures = jsonOf(ran);
    QVERIFY(figures["sound"].get<bool>());
    QVERIFY(figures["scan_distance_mm"].get<double>() < 1.0);
    const auto mesh = fixture.inspected("b.stl");
    QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>());
    QCOMPARE(mesh["self_intersecting_pairs"].get<int>(), 0);
    QVERIFY(figures["kept_distance_mm"].get<double>() <= 1.0);
  }

  // A file may have triangles that are turned round, half of them, too: the volume is that of the cube.
  void repairOfTurnedTriangles() {
    const Fixture fixture;
    for (const std::size_t turned : {1u, 2u, 6u, 11u}) {
      Shape shape = cube(20.0);
      for (std::size_t i = 0; i < turned; ++i) std::swap(shape.faces[i][0], shape.faces[i][1]);
      fixture.put("a.off", shape.off());
      const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl", "--by", "volume", "--voxel", "1"});
      QCOMPARE(ran.code, 0);
      QVERIFY(std::abs(fixture.inspected("b.stl")["volume_mm3"].get<double>() / 8000.0 - 1.0) < 0.02);
    }
  }

  // A volume, too: the block comes back of its distances.
  void repairOfVolumes() {
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    for (const char* const file : {"a.nrrd", "a.vdb"}) {
      QCOMPARE(fixture.run({"voxelize", "a.off", "-o", file, "--voxel", "1"}).code, 0);
      const Ran ran = fixture.run({"repair", file, "-o", "b.stl", "--by", "volume", "--voxel", "1", "--json"});
      QCOMPARE(ran.err, QByteArray());
      QCOMPARE(ran.code, 0);
      QVERIFY(jsonOf(ran)["sound"].get<bool>());
      const auto mesh = fixture.inspected("b.stl");
      QVERIFY(std::abs(mesh["volume_mm3"].get<double>() / 8000.0 - 1.0) < 0.02);
    }
    const Ran document = fixture.run({"repair", "a.vdb", "-o", "b.handwheel", "--by", "volume"});
    QCOMPARE(document.code, 1);
  }

  void refusals_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("no output") << QStringList{"voxelize", "a.off"} << QByteArray("The option -o OUT is missing.");
    QTest::newRow("no document") << QStringList{"voxelize", "a.off", "-o", "b.stl"} << QByteArray(".handwheel");
    QTest::newRow("too fine") << QStringList{"voxelize", "a.off", "-o", "b.handwheel", "--voxel", "1e-4"}
                              << QByteArray("MB");
    QTest::newRow("too fine a repair") << QStringList{"repair", "a.off",  "-o",      "b.stl",
                                                      "--by",   "volume", "--voxel", "1e-4"}
                                       << QByteArray("MB");
    QTest::newRow("too coarse") << QStringList{"repair", "a.off", "-o", "b.stl", "--by", "volume", "--voxel", "1e4"}
                                << QByteArray("Choose smaller voxels.");
    QTest::newRow("no volume") << QStringList{"remesh", "a.off", "-o", "b.stl"} << QByteArray("it is not a volume");
    QTest::newRow("no way") << QStringList{"repair", "a.off", "-o", "b.stl", "--by", "hand"} << QByteArray("--by");
    QTest::newRow("voxel 0") << QStringList{"repair", "a.off", "-o", "b.stl", "--by", "volume", "--voxel", "0"}
                             << QByteArray("above 0");
    QTest::newRow("both ways") << QStringList{"repair", "a.off",         "-o",  "b.stl", "--by",
                                              "volume", "--open-sheets", "fill"}
                               << QByteArray("no meaning");
    QTest::newRow("no way to combine") << QStringList{"boolean", "a.off", "a.off", "-o", "b.stl"}
                                       << QByteArray("Choose one of --unite");
    QTest::newRow("two ways") << QStringList{"boolean", "a.off", "a.off", "--unite", "--subtract", "-o", "b.stl"}
                              << QByteArray("Choose one of --unite");
    QTest::newRow("nothing left") << QStringList{"boolean", "a.off", "a.off",   "--subtract",
                                                 "-o",      "b.stl", "--voxel", "0.5"}
                                  << QByteArray("Nothing is left");
    QTest::newRow("no wall") << QStringList{"shell", "a.off", "-o", "b.stl"}
                             << QByteArray("The option --wall MM is missing.");
    QTest::newRow("thin wall") << QStringList{"shell", "a.off", "-o", "b.stl", "--wall", "0.5", "--voxel", "0.5"}
                               << QByteArray("voxels of at most 0.25 mm");
    QTest::newRow("huge") << QStringList{"offset", "a.off", "-o", "b.stl", "--distance", "90000", "--voxel", "0.5"}
                          << QByteArray("MB");
    QTest::newRow("shrunk away") << QStringList{"offset", "a.off", "-o", "b.stl", "--distance", "-11", "--voxel", "0.5"}
                                 << QByteArray("nothing is left");
    QTest::newRow("flat") << QStringList{"repair", "flat.off", "-o", "b.stl", "--by", "volume"}
                          << QByteArray("encloses no volume");
  }
  // Following the advice gives a closed mesh of a surface that encloses nothing.
  void wallsOfASheet() {
    const Fixture fixture;
    fixture.put("flat.off", "OFF\n3 1 0\n0 0 0\n10 0 0\n0 10 0\n3 0 1 2\n");
    const Ran none = fixture.run({"voxelize", "flat.off", "-o", "b.handwheel"});
    QCOMPARE(none.code, 1);
    QVERIFY2(none.err.contains("--wall"), none.err.constData());
    QCOMPARE(fixture.run({"voxelize", "flat.off", "-o", "b.handwheel", "--wall", "1", "--voxel", "0.25"}).code, 0);
    QCOMPARE(fixture.run({"remesh", "b.handwheel", "-o", "b.stl"}).code, 0);
    const Ran seen = fixture.run({"inspect", "b.stl"});
    QVERIFY2(seen.out.contains("closed, manifold, oriented, free of self-intersections, one piece"),
             seen.out.constData());
  }
  void refusals() {
    QFETCH(QStringList, words);
    QFETCH(QByteArray, text);
    const Fixture fixture;
    fixture.put("a.off", openCube(20.0).off());
    fixture.put("flat.off", "OFF\n3 1 0\n0 0 0\n10 0 0\n0 10 0\n3 0 1 2\n");
    const Ran ran = fixture.run(words);
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains(text), ran.err.constData());
    QVERIFY(!fixture.names().contains("b.stl") && !fixture.names().contains("b.handwheel"));
  }
};

HANDWHEEL_TEST(VolumeTest)
#include "VolumeTest.moc"
