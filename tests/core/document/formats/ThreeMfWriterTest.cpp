// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "TestClass.h"
#include "ThreeMfText.h"
#include "document/container/ZipReader.h"

#include <assimp/scene.h>
#include <rapidcheck.h>
#include <QProcess>
#include <QTest>
#include <assimp/Importer.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

std::string written(const TriangleSoup& soup) {
  return writeMesh(soup, MeshFormat::ThreeMf, NumberType::Float32);
}

// The corners of all triangles, as assimp reads them with its own ZIP and XML readers.
std::vector<Vec3> cornersByAssimp(const std::string& bytes) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "3mf");
  std::vector<Vec3> corners;
  for (unsigned m = 0; scene && m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
      for (unsigned k = 0; k < mesh.mFaces[f].mNumIndices; ++k) {
        const aiVector3D& v = mesh.mVertices[mesh.mFaces[f].mIndices[k]];
        corners.emplace_back(v.x, v.y, v.z);
      }
  }
  return corners;
}

}  // namespace

class ThreeMfWriterTest : public QObject {
  Q_OBJECT
 private slots:
  void modelText() {
    const TriangleSoup soup{{{0.1, -2, 1e21}, {1e-5, 0, 123456}, {0.30000000000000004, 1, 0}}, {{0, 1, 2}}};
    const std::string bytes = writeMesh(soup, MeshFormat::ThreeMf, NumberType::Float64);
    ZipReader zip(bytes, {.largest = 1 << 20, .allowance = 1 << 20});
    QVERIFY(zip.names() == (std::vector<std::string>{"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"}));
    const auto model = zip.read("3D/3dmodel.model");
    QVERIFY(model);
    QVERIFY(model->find("unit=\"millimeter\"") != std::string::npos);
    QVERIFY(model->find("<vertex x=\"0.1\" y=\"-2\" z=\"1e+21\"/>\n<vertex x=\"1e-05\" y=\"0\" z=\"123456\"/>\n"
                        "<vertex x=\"0.30000000000000004\" y=\"1\" z=\"0\"/>\n") != std::string::npos);
    QVERIFY(model->find("<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>") != std::string::npos);
  }

  // Python's ZIP and XML readers find the elements that the specification requires.
  void packageParts() {
    const QString program =
        "import io, sys, zipfile, xml.etree.ElementTree as E\n"
        "z = zipfile.ZipFile(io.BytesIO(sys.stdin.buffer.read()))\n"
        "assert z.testzip() is None\n"
        "types = {e.get('Extension') for e in E.fromstring(z.read('[Content_Types].xml'))}\n"
        "r = E.fromstring(z.read('_rels/.rels'))[0]\n"
        "m = E.fromstring(z.read(r.get('Target')[1:]))\n"
        "n = '{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}'\n"
        "assert m.tag == n + 'model'\n"
        "o = m.find(n + 'resources/' + n + 'object')\n"
        "i = m.find(n + 'build/' + n + 'item')\n"
        "assert i.get('objectid') == o.get('id')\n"
        "print(sorted(types), m.get('unit'), len(list(m.iter(n + 'vertex'))), len(list(m.iter(n + 'triangle'))))\n";
    QProcess process;
    process.start("python3", {"-c", program});
    const std::string bytes = written(icosphere(2));
    process.write(bytes.data(), static_cast<qint64>(bytes.size()));
    process.closeWriteChannel();
    QVERIFY(process.waitForFinished());
    QCOMPARE(QString(process.readAllStandardOutput()).trimmed() + process.readAllStandardError(),
             QString("['model', 'rels'] millimeter 162 320"));
  }

  void assimpReadsTheSame() {
    const TriangleSoup soup = moved(bumpySphere(3), Vec3(100, -20, 3), 25.0);
    const std::vector<Vec3> corners = cornersByAssimp(written(soup));
    QCOMPARE(corners.size(), 3 * soup.triangles.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 expected = rounded(soup.points[soup.triangles[i / 3][i % 3]], NumberType::Float32);
      QVERIFY((corners[i] - expected).norm() <= 1e-5 * expected.norm());  // its own parser of numbers is not exact
    }
  }

  // Our result for other files is that of assimp: several objects and transforms.
  void assimpPutsTogetherTheSame() {
    const QByteArray bytes = package(model(object(1, kMesh) + object(2, kMesh), item(1) + item(2)));
    const auto file = read(bytes);
    QVERIFY(file);
    const std::vector<Vec3> corners = cornersByAssimp(bytes.toStdString());
    QCOMPARE(corners.size(), 3 * file->soup.triangles.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
      QVERIFY((corners[i] - file->soup.points[file->soup.triangles[i / 3][i % 3]]).norm() < 1e-6);
  }
};

HANDWHEEL_TEST(ThreeMfWriterTest)
#include "ThreeMfWriterTest.moc"
