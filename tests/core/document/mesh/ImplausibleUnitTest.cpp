// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/ImplausibleUnit.h"

#include "TestClass.h"
#include "document/mesh/MeshKind.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <fstream>

using namespace handwheel;

namespace {

Box boxOfSize(const Vec3& size) {
  const Vec3 corner(-7.0, 3.0, 1000.0);
  return {corner, corner + size};
}

// A tetrahedron with edges along the axes of this length, in numbers of the file.
TriangleSoup tetrahedronOf(double size) {
  return {{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

}  // namespace

class ImplausibleUnitTest : public QObject {
  Q_OBJECT

 private slots:
  // The largest dimension counts, and the limits themselves are likely sizes.
  void thresholds_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::addColumn<bool>("isImplausible");
    QTest::newRow("a bunny in metres") << 0.156 << 0.155 << 0.121 << true;
    QTest::newRow("below a millimetre") << 0.0 << 0.999 << 0.5 << true;
    QTest::newRow("a millimetre") << 0.0 << 1.0 << 0.5 << false;
    QTest::newRow("a needle") << 0.01 << 0.01 << 2.0 << false;
    QTest::newRow("a bunny in millimetres") << 156.0 << 155.0 << 121.0 << false;
    QTest::newRow("ten metres") << 10.0 << 10'000.0 << 0.0 << false;
    QTest::newRow("above ten metres") << 10.0 << 10'001.0 << 0.0 << true;
  }
  void thresholds() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    QFETCH(bool, isImplausible);
    DocumentFile file;
    file.hasUnit = false;
    const Box box(Vec3::Zero(), Vec3(x, y, z));
    QCOMPARE(isUnitImplausible(file, box), isImplausible);
    file.hasUnit = true;
    QVERIFY(!isUnitImplausible(file, box));
  }

  void nothingHasNoSize() {
    DocumentFile file;
    file.hasUnit = false;
    QVERIFY(!isUnitImplausible(file, Box()));
  }

  void threeDigits() {
    const Note note = implausibleUnit(boxOfSize({0.15625, 12.5, 30'000.0}));
    QCOMPARE(note.arguments, (std::vector<std::string>{"0.156", "12.5", "30000"}));
  }

  // 3MF says its unit, STL, PLY, OBJ and OFF do not.
  void formats_data() {
    QTest::addColumn<int>("format");
    QTest::addColumn<bool>("hasUnit");
    QTest::newRow("stl") << int(MeshFormat::Stl) << false;
    QTest::newRow("ply") << int(MeshFormat::Ply) << false;
    QTest::newRow("obj") << int(MeshFormat::Obj) << false;
    QTest::newRow("off") << int(MeshFormat::Off) << false;
    QTest::newRow("3mf") << int(MeshFormat::ThreeMf) << true;
  }
  void formats() {
    QFETCH(int, format);
    QFETCH(bool, hasUnit);
    const QTemporaryDir folder;
    const std::filesystem::path path =
        folder.filePath(QStringLiteral("part.") + QString::fromLatin1(QTest::currentDataTag())).toStdString();
    const std::string bytes = writeMesh(tetrahedronOf(0.25), static_cast<MeshFormat>(format), NumberType::Float32);
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const auto opened = MeshKind().import(path, {}, {});
    QVERIFY(opened.hasValue());
    QCOMPARE(opened->file.hasUnit, hasUnit);
  }
};

HANDWHEEL_TEST(ImplausibleUnitTest)
#include "ImplausibleUnitTest.moc"
