// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReadDescription.h"
#include "TestClass.h"

#include <unistd.h>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <clocale>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const QByteArray kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const QByteArray kOff = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const QByteArray kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const QByteArray kStl =
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid\n";

QByteArray utf16(const QByteArray& text, bool big, bool mark) {
  QByteArray wide = mark ? (big ? "\xFE\xFF" : "\xFF\xFE") : "";
  for (char c : text) wide += big ? QByteArray(1, '\0') + c : c + QByteArray(1, '\0');
  return wide;
}

const auto kFormats = {MeshFormat::Stl, MeshFormat::Ply, MeshFormat::Obj, MeshFormat::Off, MeshFormat::ThreeMf};

// A flat grid of cells × cells squares.
TriangleSoup grid(std::uint32_t cells) {
  TriangleSoup soup;
  for (std::uint32_t i = 0; i <= cells; ++i)
    for (std::uint32_t j = 0; j <= cells; ++j) soup.points.emplace_back(i, j, 0);
  for (std::uint32_t i = 0; i < cells; ++i)
    for (std::uint32_t j = 0; j < cells; ++j) {
      const std::uint32_t a = i * (cells + 1) + j, b = a + cells + 1;
      soup.triangles.push_back({a, b, b + 1});
      soup.triangles.push_back({a, b + 1, a + 1});
    }
  return soup;
}

}  // namespace

class MeshFormatTest : public QObject {
  Q_OBJECT
 private slots:
  void contentDecides() {
    const std::pair<QByteArray, MeshFormat> files[] = {
        {kObj, MeshFormat::Obj},
        {kOff, MeshFormat::Off},
        {kPly, MeshFormat::Ply},
        {kStl, MeshFormat::Stl},
        {QByteArray::fromStdString(writeMesh(read(kObj)->soup, MeshFormat::ThreeMf, NumberType::Float32)),
         MeshFormat::ThreeMf}};
    for (const auto& [bytes, format] : files)
      for (const char* name : {"", "a.stl", "a.obj", "a.off", "a.ply", "a.3mf", "a.txt", "a"}) {
        const auto file = read(bytes, false, name);
        QVERIFY2(file, name);
        QCOMPARE(file->format, format);
        QCOMPARE(describe(file), kTriangle);
      }
  }

  void namesDecideWhereContentDoesNot() {
    const QByteArray headless = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    QCOMPARE(describe(read(headless, false, "a.OFF")), kTriangle);
    QCOMPARE(describe(read(headless, false, "a.txt")), QString("FormatUnknown(.stl,.ply,.obj,.off,.3mf,.step,.stp)"));
    QCOMPARE(describe(read("hello", false, "a.stl")), QString("FormatUnknown(.stl,.ply,.obj,.off,.3mf,.step,.stp)"));
    QCOMPARE(describe(read(QByteArray(5, '\1'), false, "a.stl")), QString("DataTruncated(bytes,84,5) byte 5"));
    QCOMPARE(describe(read("hello", false, "a.obj")), QString("NoTriangles"));
    QCOMPARE(describe(read("hello", false, "a.ply")), QString("HeaderMalformed(ply) line 1"));
    QCOMPARE(describe(read("hello", false, "a.off")), QString("HeaderMalformed(OFF) line 1"));
    QCOMPARE(describe(read("hello", false, "a.3mf")), QString("ArchiveMalformed(Not a zip archive)"));
    QCOMPARE(describe(read("hello", false, "a")), QString("FormatUnknown(.stl,.ply,.obj,.off,.3mf,.step,.stp)"));
    QCOMPARE(describe(read("", false, "a.stl")), QString("FileEmpty"));
  }

  void wideTextIsRefused() {
    for (bool big : {false, true})
      for (bool mark : {false, true})
        for (const char* name : {"a.obj", "a.off", ""})
          QCOMPARE(describe(read(utf16(kObj, big, mark), false, name)), QString("TextEncoding(UTF-16)"));
    QCOMPARE(describe(read(QByteArray("\xFF\xFE\0\0v\0\0\0", 8), false, "a.obj")), QString("TextEncoding(UTF-32)"));
  }

  void formatsOfNames() {
    QVERIFY(formatForName("a.stl") == MeshFormat::Stl);
    QVERIFY(formatForName("/b.obj/A.PLY") == MeshFormat::Ply);
    QVERIFY(formatForName("a.stl.Obj") == MeshFormat::Obj);
    QVERIFY(formatForName(".off") == MeshFormat::Off);
    QVERIFY(formatForName("a.3MF") == MeshFormat::ThreeMf);
    for (const char* name : {"", "stl", "a.", "a.stl2", "a.st"}) QVERIFY2(!formatForName(name), name);
  }

  void numberTypes() {
    for (NumberType document : {NumberType::Float32, NumberType::Float64}) {
      QCOMPARE(numberTypeOf(MeshFormat::Stl, document), NumberType::Float32);
      for (MeshFormat format : {MeshFormat::Ply, MeshFormat::Obj, MeshFormat::Off, MeshFormat::ThreeMf})
        QCOMPARE(numberTypeOf(format, document), document);
    }
  }

  void files() {
    QTemporaryDir folder;
    const auto path = [&](const char* name) { return std::filesystem::path(folder.filePath(name).toStdString()); };
    QFile file(folder.filePath("a b.obj"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(kObj);
    file.close();
    QCOMPARE(describe(readMeshFile(path("a b.obj"), {})), kTriangle);
    QCOMPARE(describe(readMeshFile(path("none.obj"), {})), QString("FileMissing"));
    QCOMPARE(readMeshFile(path("none.obj"), {}).error().subject, path("none.obj").string());
    QVERIFY(readMeshFile(path(""), {}).error().code == ErrorCode::FileUnreadable);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    QCOMPARE(describe(readMeshFile(path("a b.obj"), {})), QString("FileEmpty"));
  }

  void forbiddenFiles() {
    if (geteuid() == 0) QSKIP("the superuser may read every file");
    QTemporaryDir folder;
    QFile file(folder.filePath("a.obj"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.setPermissions({}));
    const auto read = readMeshFile(file.fileName().toStdString(), {});
    QVERIFY(!read);
    QVERIFY(read.error().code == ErrorCode::FileUnreadable);
    QVERIFY(!read.error().arguments.at(0).empty());
  }

  void cancelledBefore() {
    for (MeshFormat format : kFormats)
      for (bool partial : {false, true}) {
        JobState job;
        job.cancelled = true;
        const auto file = readMesh(writeMesh(grid(3), format, NumberType::Float32), "", {partial}, Progress(job));
        QCOMPARE(describe(file), QString("Cancelled"));
      }
  }

  void progressGoesToTheEnd() {
    for (MeshFormat format : kFormats) {
      JobState job;
      QVERIFY(readMesh(writeMesh(grid(3), format, NumberType::Float32), "", {}, Progress(job)));
      QCOMPARE(job.fraction.load(), 1.0);
    }
  }

  // All damage goes through one counter.
  void damageIsCountedBeyondAThousand() {
    QByteArray bytes = kObj;
    for (int i = 0; i < 2500; ++i) bytes += "f 1 2 9\n";
    const auto file = read(bytes, true);
    QVERIFY(file);
    QCOMPARE(file->damage.size(), std::size_t{1000});
    QCOMPARE(file->unlistedDamage, std::size_t{1500});
  }

  void longWordsAreCut() {
    const auto file = read("v 1 2 " + QByteArray(100000, 'x') + "\n", false, "a.obj");
    QVERIFY(!file);
    QVERIFY(file.error().arguments[0].size() < 100);
  }

  // German writes "1,5"; neither reading nor writing may.
  void localeHasNoSay() {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    if (!std::setlocale(LC_ALL, "de_DE.UTF-8") && !std::setlocale(LC_ALL, "de_DE.utf8"))
      QSKIP("the locale de_DE.UTF-8 is not installed");
    char proof[8];
    std::snprintf(proof, sizeof proof, "%.1f", 1.5);
    TriangleSoup soup{{{1.5, -0.25, 1e-7}, {1234567.5, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    QStringList texts;
    for (MeshFormat format : {MeshFormat::Obj, MeshFormat::Off}) {
      const std::string text = writeMesh(soup, format, NumberType::Float64);
      texts << QString::fromStdString(text) << describe(readMesh(text, "", {}));
    }
    texts << describe(read(QByteArray(kStl).replace("1 0 0", "1.5 0 0")))
          << describe(read(QByteArray(kPly).replace("1 0 0", "1.5 0 0")));
    std::setlocale(LC_ALL, before.c_str());
    QCOMPARE(QString(proof), QString("1,5"));
    QCOMPARE(texts[0], QString("# written by Handwheel\nv 1.5 -0.25 1e-07\nv 1234567.5 0 0\nv 0 1 0\nf 1 2 3\n"));
    QCOMPARE(texts[1], QString("1.5 -0.25 1e-07, 1234567.5 0 0, 0 1 0 | 0 1 2"));
    QCOMPARE(texts[2], QString("OFF\n3 1 0\n1.5 -0.25 1e-07\n1234567.5 0 0\n0 1 0\n3 0 1 2\n"));
    QCOMPARE(texts[3], texts[1]);
    QCOMPARE(texts[4], QString("0 0 0, 1.5 0 0, 0 1 0 | 0 1 2"));
    QCOMPARE(texts[5], texts[4]);
  }
};

HANDWHEEL_TEST(MeshFormatTest)
#include "MeshFormatTest.moc"
