// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"

#include <sys/stat.h>
#include <unistd.h>
#include <QTest>
#include <clocale>

using namespace handwheel;

namespace {

const char* const kCubeJson = R"({
  "triangles": 12,
  "vertices": 8,
  "state": "closed, manifold, oriented, free of self-intersections, one piece",
  "components": 1,
  "closed": true,
  "manifold": true,
  "oriented": true,
  "inside_out_bodies": 0,
  "one_sided_pieces": 0,
  "euler_characteristic": 2,
  "boundary_loops": 0,
  "loops": [],
  "non_manifold_edges": 0,
  "non_manifold_vertices": 0,
  "degenerate_faces": 0,
  "duplicate_faces": 0,
  "reversed_faces": 0,
  "near_vertices": 0,
  "debris": 0,
  "nested_bodies": 0,
  "self_intersecting_pairs": 0,
  "area_mm2": 6.0,
  "volume_mm3": 1.0,
  "bounding_box_mm": [
    [
      0.0,
      0.0,
      0.0
    ],
    [
      1.0,
      1.0,
      1.0
    ]
  ],
  "unit_doubtful": false
}
)";

const char* const kOpenCubeJson = R"({
  "triangles": 10,
  "vertices": 8,
  "state": "not closed, manifold, oriented, free of self-intersections, one piece",
  "components": 1,
  "closed": false,
  "manifold": true,
  "oriented": true,
  "inside_out_bodies": 0,
  "one_sided_pieces": 0,
  "euler_characteristic": 1,
  "boundary_loops": 1,
  "loops": [
    {
      "id": 0,
      "number": 1,
      "edges": 4,
      "length_mm": 2.0,
      "area_mm2": 0.25,
      "planarity": 0.0,
      "islands": 0,
      "sheet_boundary": false,
      "rim": false
    }
  ],
  "non_manifold_edges": 0,
  "non_manifold_vertices": 0,
  "degenerate_faces": 0,
  "duplicate_faces": 0,
  "reversed_faces": 0,
  "near_vertices": 0,
  "debris": 0,
  "nested_bodies": 0,
  "self_intersecting_pairs": 0,
  "area_mm2": 1.25,
  "volume_mm3": null,
  "bounding_box_mm": [
    [
      0.0,
      0.0,
      0.0
    ],
    [
      0.5,
      0.5,
      0.5
    ]
  ],
  "unit_doubtful": true
}
)";

const char* const kOpenCubeText =
    "Triangles                 10\n"
    "Vertices                  8\n"
    "State                     not closed, manifold, oriented, free of self-intersections, one piece\n"
    "Boundary loops            1\n"
    "Non-manifold edges        0\n"
    "Non-manifold vertices     0\n"
    "Degenerate triangles      0\n"
    "Duplicate triangles       0\n"
    "Area (mm2)                1.25\n"
    "Volume (mm3)              undefined, the surface is open\n"
    "Bounding box (mm)         0, 0, 0 to 0.5, 0.5, 0.5\n"
    "\n"
    "Holes\n"
    "                name    id   edges     length (mm)      area (mm2)   planarity   islands\n"
    "              Hole 1     0       4               2            0.25           0         0\n"
    "\n"
    "The part measures 0.5 × 0.5 × 0.5 mm, if its numbers are millimetres: the file does not say its unit. 'handwheel "
    "edit' with the step 'place --unit m' converts it from metres; cm and in are possible, too.\n";

}  // namespace

class InspectTest : public QObject {
  Q_OBJECT

 private:
  nlohmann::json statistics(const QByteArray& off) {
    const Fixture fixture;
    fixture.put("a.off", off);
    const Ran ran = fixture.run({"inspect", "a.off", "--json"});
    if (ran.code != 0) qWarning("%s", ran.err.constData());
    return ran.code == 0 ? nlohmann::json::parse(ran.out.toStdString()) : nlohmann::json::object();
  }

 private slots:
  void exactJson_data() {
    QTest::addColumn<QByteArray>("off");
    QTest::addColumn<QByteArray>("expected");
    QTest::newRow("cube") << cube().off() << QByteArray(kCubeJson);
    QTest::newRow("open cube") << openCube(0.5).off() << QByteArray(kOpenCubeJson);
  }
  void exactJson() {
    QFETCH(QByteArray, off);
    QFETCH(QByteArray, expected);
    const Fixture fixture;
    fixture.put("a.off", off);
    const Ran ran = fixture.run({"inspect", "a.off", "--json"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.out, expected);
    QCOMPARE(ran.code, 0);
  }

  void exactText() {
    const Fixture fixture;
    fixture.put("a.off", openCube(0.5).off());
    const Ran ran = fixture.run({"inspect", "a.off"});
    QCOMPARE(ran.out, QByteArray(kOpenCubeText));
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
  }

  // A part that is too large is advised the unit that makes it smaller, and the step does: 30 m are 30 mm in
  // micrometres.
  void aPartInMicrometres() {
    const Fixture fixture;
    fixture.put("a.off", cube(30'000.0).off());
    const Ran ran = fixture.run({"inspect", "a.off"});
    QVERIFY2(ran.out.contains("'place --unit um' converts it from micrometres."), ran.out.constData());
    QVERIFY(!ran.out.contains("converts it from metres"));
    QCOMPARE(fixture.run({"edit", "a.off", "place --unit um", "-o", "b.off"}).code, 0);
    const Ran placed = fixture.run({"inspect", "b.off"});
    QVERIFY2(placed.out.contains("0, 0, 0 to 30, 30, 30\n"), placed.out.constData());
  }

  // Decimal points and English stay, whatever the user's language.
  void sameUnderGermanLocale() {
    const char* const german = "de_DE.UTF-8";
    if (!std::setlocale(LC_ALL, german)) QSKIP("the locale de_DE.UTF-8 is not installed");
    std::setlocale(LC_ALL, "C");
    const Fixture fixture;
    fixture.put("a.off", openCube(0.5).off());
    QCOMPARE(fixture.run({"inspect", "a.off"}, german).out, QByteArray(kOpenCubeText));
    QCOMPARE(fixture.run({"inspect", "a.off", "--json"}, german).out, QByteArray(kOpenCubeJson));
    const Ran german1 = fixture.run({"inspect", "none.off"}, german);
    QCOMPARE(german1.err, fixture.run({"inspect", "none.off"}).err);
  }

  void tetrahedronFigures() {
    const auto json = statistics(tetrahedron().off());
    QVERIFY(json.at("closed"));
    QCOMPARE(json.at("triangles").get<int>(), 4);
    QVERIFY(std::abs(json.at("volume_mm3").get<double>() - 1.0 / 6.0) < 1e-15);
  }

  void twoCubes() {
    Shape both = cube();
    both.add(cube(2.0), {5, 0, 0});
    const auto json = statistics(both.off());
    QCOMPARE(json.at("components").get<int>(), 2);
    QCOMPARE(json.at("vertices").get<int>(), 16);
    QVERIFY(std::abs(json.at("volume_mm3").get<double>() - 9.0) < 1e-12);
    QCOMPARE(json.at("self_intersecting_pairs").get<int>(), 0);
    QCOMPARE(json.at("nested_bodies").get<int>(), 0);
  }

  // A solid in a solid is named, and by request goes; a cavity is none.
  void aCubeInACube() {
    Shape solid = cube(3.0), hollow = cube(3.0), inward = cube();
    solid.add(cube(), {1, 1, 1});
    for (auto& f : inward.faces) std::swap(f[0], f[1]);
    hollow.add(inward, {1, 1, 1});
    QCOMPARE(statistics(solid.off()).at("nested_bodies").get<int>(), 1);
    QCOMPARE(statistics(hollow.off()).at("nested_bodies").get<int>(), 0);
    const Fixture fixture;
    fixture.put("a.off", solid.off());
    const QByteArray text = fixture.run({"inspect", "a.off"}).out;
    QVERIFY(text.contains("Inside others             1 body\n"));
    // 27 mm³ and 1 within them; a cavity is taken off.
    QVERIFY2(text.contains("Volume (mm3)              28, of all bodies added up\n"), text.constData());
    fixture.put("b.off", hollow.off());
    const QByteArray other = fixture.run({"inspect", "b.off"}).out;
    QVERIFY2(other.contains("Volume (mm3)              26\n"), other.constData());
    const Ran kept = fixture.run({"repair", "a.off", "-o", "b.off"});
    QVERIFY2(kept.code == 0 && kept.err.contains("1 body lies inside another; --unite removes"), kept.err);
    const Ran united = fixture.run({"repair", "a.off", "--unite", "-o", "c.off"});
    QVERIFY2(united.code == 0 && united.err.isEmpty(), united.err);
    const auto json = nlohmann::json::parse(fixture.run({"inspect", "c.off", "--json"}).out.toStdString());
    QVERIFY(std::abs(json.at("volume_mm3").get<double>() - 27.0) < 1e-12);
    QCOMPARE(json.at("components").get<int>(), 1);
  }

  void insideOutCubeIsNotOriented() {
    Shape shape = cube();
    for (auto& f : shape.faces) std::swap(f[0], f[1]);
    const auto json = statistics(shape.off());
    QVERIFY(!json.at("oriented"));
    QCOMPARE(json.at("inside_out_bodies").get<int>(), 1);
    QVERIFY(std::abs(json.at("volume_mm3").get<double>() + 1.0) < 1e-15);
  }

  void moebiusStripIsOneSided() {
    const auto json = statistics(moebiusStrip(12).off());
    QCOMPARE(json.at("triangles").get<int>(), 24);
    QVERIFY(!json.at("closed"));
    QVERIFY(json.at("manifold"));
    QVERIFY(!json.at("oriented"));
    // Its one edge runs along 24 triangles; listed in two pieces where the strip had to be cut to be drawn with sides.
    int edges = 0;
    for (const auto& loop : json.at("loops")) edges += loop.at("edges").get<int>();
    QCOMPARE(edges, 24);
    QVERIFY(json.at("volume_mm3").is_null());
  }

  // A doubled face gives its three edges a third face, where no orientation is judged, and meets its twin.
  void duplicateFace() {
    Shape shape = cube();
    shape.faces.push_back(shape.faces.front());
    const auto json = statistics(shape.off());
    QCOMPARE(json.at("duplicate_faces").get<int>(), 1);
    QCOMPARE(json.at("non_manifold_edges").get<int>(), 3);
    QVERIFY(!json.at("manifold"));
    QVERIFY(json.at("oriented"));
    QVERIFY(json.at("closed"));
    QCOMPARE(json.at("self_intersecting_pairs").get<int>(), 1);
  }

  void degenerateFace() {
    Shape shape = cube();
    shape.faces.push_back({0, 1, 1});
    const auto json = statistics(shape.off());
    QCOMPARE(json.at("triangles").get<int>(), 13);
    QCOMPARE(json.at("degenerate_faces").get<int>(), 1);
    QVERIFY(json.at("closed"));
    QVERIFY(json.at("manifold"));
  }

  // Two cubes that share one corner position: one part, and a vertex with two fans.
  void cubesAtACorner() {
    Shape both = cube();
    both.add(cube(), {1, 1, 1});
    const auto json = statistics(both.off());
    QCOMPARE(json.at("components").get<int>(), 1);
    QCOMPARE(json.at("vertices").get<int>(), 15);
    QCOMPARE(json.at("non_manifold_vertices").get<int>(), 1);
    QVERIFY(!json.at("manifold"));
    QCOMPARE(json.at("non_manifold_edges").get<int>(), 0);
  }

  // Two cubes that share one edge: four faces at it.
  void cubesAtAnEdge() {
    Shape both = cube();
    both.add(cube(), {1, 1, 0});
    const auto json = statistics(both.off());
    QCOMPARE(json.at("non_manifold_edges").get<int>(), 1);
    QVERIFY(!json.at("manifold"));
    QVERIFY(json.at("closed"));
  }

  void errorsAreOneLine_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("missing") << "none.stl" << QByteArray();
    QTest::newRow("empty") << "empty.stl" << QByteArray("");
    QTest::newRow("not a mesh") << "letter.txt" << QByteArray("Dear Sir or Madam\n");
    QTest::newRow("cut off") << "cut.off" << QByteArray("OFF\n8 12 0\n0 0 0\n");
  }
  void errorsAreOneLine() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    const Fixture fixture;
    if (!content.isNull()) fixture.put(name, content);
    const Ran ran = fixture.run({"inspect", name, "--json"});
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.out, QByteArray());
    QCOMPARE(ran.err.count('\n'), 1);
    QVERIFY(ran.err.startsWith("handwheel: " + name.toUtf8()));
  }

  void unreadableFile() {
    if (geteuid() == 0) QSKIP("the superuser may read everything");
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    QCOMPARE(chmod((fixture.path() + "/a.off").toLocal8Bit(), 0), 0);
    const Ran ran = fixture.run({"inspect", "a.off"});
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.err.contains("Permission denied"));
  }

  void fileNamesMayBeAnyBytes() {
    const Fixture fixture;
    const QString name = QString::fromUtf8("Gelenk größe 2 – \"neu\".off");
    fixture.put(name, cube().off());
    QCOMPARE(fixture.run({"inspect", name, "--json"}).out, QByteArray(kCubeJson));
    fixture.put("-x.off", cube().off());
    QCOMPARE(fixture.run({"inspect", "--json", "--", "-x.off"}).out, QByteArray(kCubeJson));
  }
};

HANDWHEEL_TEST(InspectTest)
#include "InspectTest.moc"
