// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColladaDocuments.h"
#include "TestClass.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <QDirIterator>
#include <QTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The corners' positions, as often as they are used, in a fixed order.
std::vector<std::array<double, 3>> cornersOf(const TriangleSoup& soup) {
  std::vector<std::array<double, 3>> corners;
  for (const Triangle& t : soup.triangles)
    for (std::uint32_t c : t) corners.push_back({soup.points[c].x(), soup.points[c].y(), soup.points[c].z()});
  std::sort(corners.begin(), corners.end());
  return corners;
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

class ColladaComparisonTest : public QObject {
  Q_OBJECT

 private slots:
  void unitsOnce_data();
  void unitsOnce();
  void filesAsAnotherReaderSeesThem_data();
  void filesAsAnotherReaderSeesThem();
};

void ColladaComparisonTest::unitsOnce_data() {
  QTest::addColumn<QString>("unit");
  QTest::addColumn<QString>("up");
  QTest::addColumn<double>("metres");
  for (const char* up : {"", "<up_axis>X_UP</up_axis>", "<up_axis>Y_UP</up_axis>", "<up_axis>Z_UP</up_axis>"}) {
    QTest::addRow("none %s", up) << "" << up << 1.0;
    for (double metres : {1.0, 0.001, 0.0254, 0.01})
      QTest::addRow("%g %s", metres, up) << QString("<unit name='u' meter='%1'/>").arg(metres) << up << metres;
  }
}

// All content of nodes is in the document's unit, too. The up axis changes nothing.
void ColladaComparisonTest::unitsOnce() {
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

void ColladaComparisonTest::filesAsAnotherReaderSeesThem_data() {
  QTest::addColumn<QString>("path");
  if (qEnvironmentVariableIsEmpty("HANDWHEEL_DATA")) QSKIP("HANDWHEEL_DATA is not set: real meshes are left out");
  QDirIterator files(qEnvironmentVariable("HANDWHEEL_DATA") + "/robots", {"*.dae"}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QString path = files.next();
    QTest::newRow(qPrintable(path.section('/', -5))) << path;
  }
}

void ColladaComparisonTest::filesAsAnotherReaderSeesThem() {
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

HANDWHEEL_TEST(ColladaComparisonTest)
#include "ColladaComparisonTest.moc"
