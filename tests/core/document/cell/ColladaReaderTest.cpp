// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/ColladaReader.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <QDirIterator>
#include <QTest>
#include <algorithm>
#include <clocale>
#include <cmath>

using namespace handwheel;

namespace {

const std::string kTriangles =
    "<triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2</p></triangles>";

// Nine points in a square grid of side 1, at z = 0, 1, 2, … times a tenth; one geometry "g" with these primitives.
std::string geometry(const std::string& primitives = kTriangles) {
  std::string numbers;
  for (int i = 0; i < 9; ++i)
    numbers += std::to_string(i % 3) + " " + std::to_string(i / 3) + " 0." + std::to_string(i) + "\n";
  return "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' count='27'>" + numbers +
         "</float_array><technique_common><accessor source='#a' count='9' stride='3'><param name='X' type='float'/>"
         "<param name='Y' type='float'/><param name='Z' type='float'/></accessor></technique_common></source>"
         "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>" +
         primitives + "</mesh></geometry></library_geometries>";
}

std::string scene(const std::string& nodes = "<node><instance_geometry url='#g'/></node>") {
  return "<library_visual_scenes><visual_scene id='s'>" + nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>";
}

std::string document(const std::string& inside, const std::string& asset = "") {
  return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>" +
         asset + "</asset>" + inside + "</COLLADA>";
}

ColladaMesh readOrThrow(const std::string& bytes) {
  Result<ColladaMesh> mesh = readCollada(bytes);
  if (!mesh) throw std::runtime_error("not read: error " + std::to_string(int(mesh.error().code)));
  return std::move(mesh).value();
}

Vec3 gridPoint(int i) {
  return {double(i % 3), double(i / 3), i / 10.0};
}

// The corners' positions, as often as they are used, in a fixed order.
std::vector<std::array<double, 3>> cornersOf(const TriangleSoup& soup) {
  std::vector<std::array<double, 3>> corners;
  for (const Triangle& t : soup.triangles)
    for (std::uint32_t c : t) corners.push_back({soup.points[c].x(), soup.points[c].y(), soup.points[c].z()});
  std::sort(corners.begin(), corners.end());
  return corners;
}

Vec3 areaVector(const TriangleSoup& soup) {
  Vec3 sum = Vec3::Zero();
  for (const Triangle& t : soup.triangles)
    sum += (soup.points[t[1]] - soup.points[t[0]]).cross(soup.points[t[2]] - soup.points[t[0]]) / 2;
  return sum;
}

void addNode(const aiNode& node, const aiMatrix4x4& above, const aiScene& scene, TriangleSoup& soup) {
  const aiMatrix4x4 placement = above * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    const auto base = std::uint32_t(soup.points.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D p = placement * mesh.mVertices[v];
      soup.points.emplace_back(p.x, p.y, p.z);
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const auto* i = mesh.mFaces[f].mIndices;
      if (mesh.mFaces[f].mNumIndices == 3) soup.triangles.push_back({base + i[0], base + i[1], base + i[2]});
    }
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) addNode(*node.mChildren[c], placement, scene, soup);
}

TriangleSoup byAnotherReader(const std::string& bytes) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate, "dae");
  TriangleSoup soup;
  if (scene) addNode(*scene->mRootNode, aiMatrix4x4(), *scene, soup);
  return soup;
}

}  // namespace

class ColladaReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void unitsOnce_data();
  void unitsOnce();
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
  void nothingToSee();
  void cancelled();
  void numbersDoNotFollowTheLocale();
  void filesAsAnotherReaderSeesThem_data();
  void filesAsAnotherReaderSeesThem();
};

void ColladaReaderTest::unitsOnce_data() {
  QTest::addColumn<QString>("unit");
  QTest::addColumn<QString>("up");
  QTest::addColumn<double>("metres");
  for (const char* up : {"", "<up_axis>X_UP</up_axis>", "<up_axis>Y_UP</up_axis>", "<up_axis>Z_UP</up_axis>"}) {
    QTest::addRow("none %s", up) << "" << up << 1.0;
    for (double metres : {1.0, 0.001, 0.0254, 0.01})
      QTest::addRow("%g %s", metres, up) << QString("<unit name='u' meter='%1'/>").arg(metres) << up << metres;
  }
}

// Whatever stands in nodes is in the document's unit, too. The up axis changes nothing.
void ColladaReaderTest::unitsOnce() {
  QFETCH(QString, unit);
  QFETCH(QString, up);
  QFETCH(double, metres);
  const std::string node = "<node><translate>10 0 0</translate><instance_geometry url='#g'/></node>";
  const std::string bytes = document(geometry() + scene(node), (unit + up).toStdString());
  const ColladaMesh mesh = readOrThrow(bytes);
  QVERIFY(mesh.damage.empty());
  QCOMPARE(mesh.soup.triangles.size(), std::size_t{1});
  for (int i = 0; i < 3; ++i) {
    const Vec3 expected = metres * (gridPoint(i) + Vec3(10, 0, 0));
    QVERIFY((mesh.soup.points[mesh.soup.triangles[0][std::size_t(i)]] - expected).norm() < 1e-15);
  }
  const auto other = cornersOf(byAnotherReader(bytes)), own = cornersOf(mesh.soup);
  QCOMPARE(own.size(), other.size());
  for (std::size_t i = 0; i < own.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) QVERIFY(std::abs(own[i][k] - other[i][k]) < 1e-5 * metres);
}

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
  QVERIFY(std::abs(covered - area) < 1e-12);  // none lies the other way round
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
  QVERIFY(mesh.damage[0].place.kind == Place::Kind::Line);
}

// What overflows the stack of others: a node that holds itself, and nodes that double at each step.
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

void ColladaReaderTest::nothingToSee() {
  QCOMPARE(readCollada(document("")).error().code, ErrorCode::NoTriangles);
  QCOMPARE(readCollada(document(geometry())).error().code, ErrorCode::NoTriangles);
  QCOMPARE(readCollada(document(geometry() + scene("<node><instance_geometry url='#none'/></node>"))).error().code,
           ErrorCode::NoTriangles);
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

void ColladaReaderTest::filesAsAnotherReaderSeesThem_data() {
  QTest::addColumn<QString>("path");
  if (qEnvironmentVariableIsEmpty("HANDWHEEL_DATA")) QSKIP("HANDWHEEL_DATA is not set: real meshes are left out");
  QDirIterator files(qEnvironmentVariable("HANDWHEEL_DATA") + "/robots", {"*.dae"}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QString path = files.next();
    QTest::newRow(qPrintable(path.section('/', -5))) << path;
  }
}

void ColladaReaderTest::filesAsAnotherReaderSeesThem() {
  QFETCH(QString, path);
  QFile file(path);
  QVERIFY(file.open(QIODevice::ReadOnly));
  const std::string bytes = file.readAll().toStdString();
  const ColladaMesh mesh = readOrThrow(bytes);
  QVERIFY(mesh.damage.empty());
  const TriangleSoup expected = byAnotherReader(bytes);
  QCOMPARE(mesh.soup.triangles.size(), expected.triangles.size());
  Box own, other;
  for (const auto& c : cornersOf(mesh.soup)) own.extend(Vec3(c[0], c[1], c[2]));
  for (const auto& c : cornersOf(expected)) other.extend(Vec3(c[0], c[1], c[2]));
  QVERIFY((own.min() - other.min()).norm() < 1e-6 && (own.max() - other.max()).norm() < 1e-6);
  QVERIFY((areaVector(mesh.soup) - areaVector(expected)).norm() < 1e-6);
}

QTEST_GUILESS_MAIN(ColladaReaderTest)
#include "ColladaReaderTest.moc"
