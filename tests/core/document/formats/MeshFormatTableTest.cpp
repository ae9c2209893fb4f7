// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshFormatTable.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "document/DocumentErrors.h"

#include <QTest>
#include <sstream>

using namespace handwheel;

namespace {

// A format that nobody has: "CUBES", and for each the low corner and the size.
bool looksLikeCubes(std::string_view bytes) {
  return bytes.starts_with("CUBES");
}

Result<MeshFile> readCubes(std::string_view bytes, const ReadOptions&, Progress) {
  std::istringstream words{std::string(bytes.substr(5))};
  words.imbue(std::locale::classic());
  MeshFile file;
  file.numbers = NumberType::Float64;
  Vec3 corner;
  double size = 0.0;
  while (words >> corner.x() >> corner.y() >> corner.z() >> size) test::append(file.soup, test::cube(size, corner));
  return file;
}

std::string writeCubes(const TriangleSoup& soup, NumberType, Progress) {
  return "CUBES of " + std::to_string(soup.triangles.size() / 12);
}

// All it takes: a row.
MeshFormatTable withCubes(bool isWritten) {
  const auto rows = meshFormatTable().rows();
  std::vector<MeshFormatRow> all(rows.begin(), rows.end());
  all.push_back({.name = "Cubes",
                 .endings = {".cubes", ".cbs"},
                 .isText = looksLikeCubes,
                 .read = readCubes,
                 .write = isWritten ? writeCubes : nullptr,
                 .numbers = NumberType::Float64});
  return MeshFormatTable(std::move(all));
}

}  // namespace

class MeshFormatTableTest : public QObject {
  Q_OBJECT

 private slots:
  // The names that the program has for the first rows are theirs.
  void rowsAreWhatTheyAreCalled() {
    const std::pair<MeshFormat, const char*> named[] = {{MeshFormat::Stl, "STL"},
                                                        {MeshFormat::Ply, "PLY"},
                                                        {MeshFormat::Obj, "OBJ"},
                                                        {MeshFormat::Off, "OFF"},
                                                        {MeshFormat::ThreeMf, "3MF"}};
    for (const auto& [format, name] : named) {
      const MeshFormatRow& row = meshFormatTable().row(format);
      QCOMPARE(std::string(row.name), std::string(name));
      QVERIFY(row.read && (row.isBinary || row.isText) && !row.endings.empty());
      for (const std::string_view ending : row.endings)
        QVERIFY(meshFormatTable().forName("a" + std::string(ending)) == format);
    }
  }

  // The format of a row is in every list, is recognised by content and by name, read and written.
  void aFormatIsARow() {
    const MeshFormatTable table = withCubes(true);
    const auto cubes = static_cast<MeshFormat>(table.rows().size() - 1);
    QVERIFY(table.forName("a.CBS") == cubes);
    QVERIFY(!meshFormatTable().forName("a.cbs"));
    const FileFormat listed = table.fileFormats().back();
    QCOMPARE(listed.name, std::string("Cubes"));
    QCOMPARE(listed.endings, std::vector<std::string>({".cubes", ".cbs"}));
    QVERIFY(listed.reads && listed.writes);
    const auto file = table.read("CUBES 0 0 0 1  5 0 0 2", "of another name.stl", {});
    QVERIFY(file);
    QVERIFY(file->format == cubes && file->soup.triangles.size() == 24);
    QVERIFY(table.detect("\n", "a.cubes").value() == cubes);
    QCOMPARE(table.write(file->soup, cubes, NumberType::Float64), std::string("CUBES of 2"));
    const auto unknown = table.detect("what is that?", "a.txt");
    QVERIFY(!unknown);
    QCOMPARE(unknown.error().code, DocumentError::FormatUnknown);
    QCOMPARE(unknown.error().arguments,
             std::vector<std::string>({".stl", ".ply", ".obj", ".off", ".3mf", ".step", ".stp", ".cubes", ".cbs"}));
    // The others are recognised as ever.
    for (const FileFormat& format : meshFormatTable().fileFormats()) {
      if (!format.writes) continue;
      const auto known = *meshFormatTable().forName("a" + format.endings[0]);
      const std::string bytes = meshFormatTable().write(test::cube(), known, NumberType::Float32);
      QVERIFY(table.detect(bytes, {}).value() == known);
    }
  }

  void aFormatThatIsOnlyRead() {
    const FileFormat listed = withCubes(false).fileFormats().back();
    QVERIFY(listed.reads && !listed.writes);
    QCOMPARE(writtenEndings({listed}), std::vector<std::string>({".handwheel"}));
  }

  // An STL file may have any words in its first 80 bytes, those of another format, too.
  void binaryStlWithTheWordsOfAnother() {
    for (const char* start : {"ply of something", "solid", "OFF", "v 1 2 3"}) {
      std::string bytes = meshFormatTable().write(test::cube(), MeshFormat::Stl, NumberType::Float32);
      bytes.replace(0, std::string_view(start).size(), start);
      QVERIFY2(meshFormatTable().detect(bytes, {}).value() == MeshFormat::Stl, start);
    }
  }
};

HANDWHEEL_TEST(MeshFormatTableTest)
#include "MeshFormatTableTest.moc"
