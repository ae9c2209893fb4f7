// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColladaDocuments.h"
#include "TestClass.h"
#include "mesh/structure/MeshErrors.h"

#include <QTest>
#include <clocale>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

class ColladaReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void primitives_data();
  void primitives();
  void indicesBetweenOthers();
  void accessorsPickOut();
  void placements();
  void instances();
  void mirrorsTurnTheFaces();
  void damage_data();
  void damage();
  void instancesOfThemselves();
  void fewBytesMuchWork();
  void nothingToSee();
  void cancelled();
  void numbersDoNotFollowTheLocale();
};
void ColladaReaderTest::primitives_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<int>("triangles");
  QTest::addColumn<double>("area");  // seen from above
  const QString input = "<input semantic='VERTEX' source='#v' offset='0'/>";
  const auto element = [&](const QString& name, const QString& lists) {
    return "<" + name + ">" + input + lists + "</" + name + ">";
  };
  QTest::newRow("triangles") << element("triangles", "<p>0 1 3 1 4 3</p>") << 2 << 1.0;
  QTest::newRow("polylist") << element("polylist", "<vcount>4 3</vcount><p>0 2 8 6 0 1 3</p>") << 3 << 4.5;
  QTest::newRow("lists in pieces") << element("polylist", "<vcount>4 3</vcount><p>0 2 8 6</p><p>0 1 3</p>") << 3 << 4.5;
  QTest::newRow("polygons") << element("polygons", "<p>0 2 8 6</p><p>0 1 3</p>") << 3 << 4.5;
  // An L: as a fan from its first corner it would cover more.
  QTest::newRow("concave") << element("polygons", "<p>2 5 4 7 6 0</p>") << 4 << 3.0;
  QTest::newRow("strip") << element("tristrips", "<p>0 1 3 4 6 7</p>") << 4 << 2.0;
  QTest::newRow("fan") << element("trifans", "<p>0 2 8 6</p>") << 2 << 4.0;
  QTest::newRow("lines beside") << element("lines", "<p>0 1</p>") + element("triangles", "<p>0 1 3</p>") << 1 << 0.5;
  QTest::newRow("two") << element("triangles", "<p>0 1 3</p>") + element("polygons", "<p>1 4 3</p>") << 2 << 1.0;
}

void ColladaReaderTest::primitives() {
  QFETCH(QString, text);
  QFETCH(int, triangles);
  QFETCH(double, area);
  const ColladaMesh mesh = readOrThrow(document(geometry(text.toStdString()) + scene()));
  QVERIFY(mesh.damage.empty());
  QCOMPARE(int(mesh.soup.triangles.size()), triangles);
  QVERIFY(std::abs(areaVector(mesh.soup).z() - area) < 1e-12);
  double covered = 0.0;
  for (const Triangle& t : mesh.soup.triangles) {
    const TriangleSoup one{mesh.soup.points, {t}};
    covered += std::abs(areaVector(one).z());
  }
  QVERIFY(std::abs(covered - area) < 1e-12);  // No triangle is inverted
}

void ColladaReaderTest::indicesBetweenOthers() {
  const ColladaMesh mesh = readOrThrow(document(
      geometry("<triangles><input semantic='NORMAL' source='#x' offset='0'/><input semantic='VERTEX' source='#v' "
               "offset='1'/><input semantic='TEXCOORD' source='#x' offset='2'/><p>7 0 7 8 2 8 6 6 6</p></triangles>") +
      scene()));
  QVERIFY(mesh.damage.empty());
  QVERIFY(std::abs(areaVector(mesh.soup).z() - 2.0) < 1e-12);
}

void ColladaReaderTest::accessorsPickOut() {
  const ColladaMesh mesh = readOrThrow(document(
      "<library_geometries><geometry id='g'><mesh><source id='p'><float_array>9 0 0 0 9 1 0 0 9 0 1 0</float_array>"
      "<technique_common><accessor count='3' stride='4' offset='1'/></technique_common></source>"
      "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>" +
      kTriangles + "</mesh></geometry></library_geometries>" + scene()));
  QVERIFY(areaVector(mesh.soup).isApprox(Vec3(0, 0, 0.5)));
}

// Row by row as written, steps in the order in which they stand.
void ColladaReaderTest::placements() {
  const std::pair<const char*, Vec3> kSteps[] = {
      {"<matrix>0 -1 0 5  1 0 0 6  0 0 1 7  0 0 0 1</matrix>", {5, 7, 7.1}},
      {"<translate>1 0 0</translate><rotate>0 0 1 90</rotate>", {1, 1, 0.1}},
      {"<rotate>0 0 1 90</rotate><translate>1 0 0</translate>", {0, 2, 0.1}},
      {"<scale>2 3 4</scale>", {2, 0, 0.4}},
      {"<rotate>0 0 2 90</rotate>", {0, 1, 0.1}},
  };
  for (const auto& [steps, expected] : kSteps) {
    const ColladaMesh mesh = readOrThrow(
        document(geometry() + scene("<node>" + std::string(steps) + "<instance_geometry url='#g'/></node>")));
    QVERIFY2((mesh.soup.points[mesh.soup.triangles[0][1]] - expected).norm() < 1e-12, steps);
  }
}

void ColladaReaderTest::instances() {
  const std::string library =
      "<library_nodes><node id='n'><translate>0 0 5</translate><instance_geometry url='#g'/></node></library_nodes>";
  const ColladaMesh mesh = readOrThrow(
      document(geometry() + library +
               scene("<node><translate>1 0 0</translate><instance_node url='#n'/><node><instance_geometry url='#g'/>"
                     "</node></node><node><instance_node url='#n'/></node>")));
  QCOMPARE(mesh.soup.triangles.size(), std::size_t{3});
  std::vector<Vec3> firsts;
  for (const Triangle& t : mesh.soup.triangles) firsts.push_back(mesh.soup.points[t[0]]);
  QVERIFY(firsts == (std::vector<Vec3>{{1, 0, 5}, {1, 0, 0}, {0, 0, 5}}));
}

void ColladaReaderTest::mirrorsTurnTheFaces() {
  const ColladaMesh mesh = readOrThrow(
      document(geometry("<triangles><input semantic='VERTEX' source='#v' offset='0'/><p>0 2 6</p></triangles>") +
               scene("<node><scale>-1 1 1</scale><instance_geometry url='#g'/></node>")));
  QVERIFY(std::abs(areaVector(mesh.soup).z() - 2.0) < 1e-12);
}

void ColladaReaderTest::damage_data() {
  QTest::addColumn<QString>("text");  // beside one good triangle
  const QString input = "<input semantic='VERTEX' source='#v' offset='0'/>";
  QTest::newRow("index out of range") << "<triangles>" + input + "<p>0 1 9</p></triangles>";
  QTest::newRow("huge index") << "<triangles>" + input + "<p>0 1 4294967295</p></triangles>";
  QTest::newRow("negative index") << "<triangles>" + input + "<p>0 1 -1</p></triangles>";
  QTest::newRow("words") << "<triangles>" + input + "<p>a b c</p></triangles>";
  QTest::newRow("cut short") << "<triangles>" + input + "<p>0 1</p></triangles>";
  QTest::newRow("polygon of two") << "<polylist>" + input + "<vcount>2</vcount><p>0 1</p></polylist>";
  QTest::newRow("count of none") << "<polylist>" + input + "<vcount>0</vcount><p>0 1 2</p></polylist>";
  QTest::newRow("count too large") << "<polylist>" + input + "<vcount>9</vcount><p>0 1 2</p></polylist>";
  QTest::newRow("counts missing") << "<polylist>" + input + "<p>0 1 2</p></polylist>";
  QTest::newRow("hole") << "<polygons>" + input + "<ph><p>0 2 8 6</p><h>0 1 4</h></ph></polygons>";
  QTest::newRow("no vertices")
      << "<triangles><input semantic='VERTEX' source='#none' offset='0'/><p>0 1 2</p></triangles>";
  QTest::newRow("no input") << "<triangles><p>0 1 2</p></triangles>";
  QTest::newRow("vast offset")
      << "<triangles><input semantic='VERTEX' source='#v' offset='4000000000'/><p>0 1 2</p></triangles>";
}

void ColladaReaderTest::damage() {
  QFETCH(QString, text);
  const ColladaMesh mesh = readOrThrow(document(geometry(text.toStdString() + kTriangles) + scene()));
  QCOMPARE(mesh.soup.triangles.size(), std::size_t{1});
  QVERIFY(!mesh.damage.empty());
  QVERIFY(mesh.damage[0].position.kind == InputPosition::Kind::Line);
}

// Documents that overflow the stack of other readers: a node that contains itself, and nodes that double at each step.
void ColladaReaderTest::instancesOfThemselves() {
  const ColladaMesh ring = readOrThrow(document(
      geometry() + scene("<node id='n'><instance_geometry url='#g'/><node><instance_node url='#n'/></node></node>")));
  QVERIFY(!ring.damage.empty());

  std::string library = "<library_nodes><node id='n0'><instance_geometry url='#g'/></node>";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "<instance_node url='#n" + std::to_string(i - 1) + "'/>";
    library += "<node id='n" + std::to_string(i) + "'>" + before + before + "</node>";
  }
  const ColladaMesh doubled = readOrThrow(
      document(geometry() + library + "</library_nodes>" + scene("<node><instance_node url='#n39'/></node>")));
  QVERIFY(!doubled.damage.empty());
  QVERIFY(doubled.soup.triangles.size() <= 100'000);
}

// Documents that take hours, or all memory, if each element costs as often as others name it.
void ColladaReaderTest::fewBytesMuchWork() {
  const auto times = [](int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  const std::string input = "<input semantic='VERTEX' source='#v' offset='0'/>";
  // Empty lists, whose counts come last.
  const ColladaMesh lists = readOrThrow(
      document(geometry(kTriangles + "<polylist>" + input + times(400'000, "<p/>") + "<vcount>3</vcount></polylist>") +
               scene()));
  QCOMPARE(lists.soup.triangles.size(), std::size_t{1});
  // A wide node, placed often.
  const ColladaMesh wide = readOrThrow(
      document(geometry() + "<library_nodes><node id='w'>" + times(200'000, "<extra/>") + "</node></library_nodes>" +
               scene("<node><instance_geometry url='#g'/>" + times(90'000, "<instance_node url='#w'/>") + "</node>")));
  QCOMPARE(wide.soup.triangles.size(), std::size_t{1});
  QVERIFY(!wide.damage.empty());
  // Many geometries with the points of one: 4000 times 30 000.
  const std::string source = "<source id='p'><float_array>" + times(90'000, "1 ") + "</float_array></source>" +
                             "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>";
  std::string geometries = "<library_geometries>", nodes;
  for (int i = 0; i < 4000; ++i) {
    const std::string id = "g" + std::to_string(i);
    geometries += "<geometry id='" + id + "'><mesh>" + (i == 0 ? source : "") + kTriangles + "</mesh></geometry>";
    nodes += "<node><instance_geometry url='#" + id + "'/></node>";
  }
  const ColladaMesh shared = readOrThrow(document(geometries + "</library_geometries>" + scene(nodes)));
  QVERIFY(shared.soup.points.size() <= 20'000'000);
  QVERIFY(!shared.damage.empty());
}

void ColladaReaderTest::nothingToSee() {
  QCOMPARE(readCollada(document("")).error().code, MeshError::NoTriangles);
  QCOMPARE(readCollada(document(geometry())).error().code, MeshError::NoTriangles);
  QCOMPARE(readCollada(document(geometry() + scene("<node><instance_geometry url='#none'/></node>"))).error().code,
           MeshError::NoTriangles);
  QCOMPARE(readCollada("<robot/>").error().code, ErrorCode::ElementMalformed);
  QCOMPARE(readCollada("").error().code, ErrorCode::ElementMalformed);
  for (const char* metres : {"0", "-1", "nan", "inf", "x"}) {
    const ColladaMesh mesh = readOrThrow(document(geometry() + scene(), "<unit meter='" + std::string(metres) + "'/>"));
    QCOMPARE(mesh.damage.size(), std::size_t{1});
    QVERIFY(mesh.soup.points[1].isApprox(gridPoint(1)));
  }
}

void ColladaReaderTest::cancelled() {
  JobState state;
  state.cancelled = true;
  QCOMPARE(readCollada(document(geometry() + scene()), Progress(state)).error().code, ErrorCode::Cancelled);
}

void ColladaReaderTest::numbersDoNotFollowTheLocale() {
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) QSKIP("the locale de_DE.UTF-8 is not installed");
  const auto mesh = readCollada(document(geometry() + scene(), "<unit meter='0.5'/>"));
  std::setlocale(LC_ALL, "C");
  QCOMPARE(mesh->soup.points[1], Vec3(0.5, 0, 0.05));
}

HANDWHEEL_TEST(ColladaReaderTest)
#include "ColladaReaderTest.moc"
