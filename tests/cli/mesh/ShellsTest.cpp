// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

namespace {

nlohmann::json shellsInspected(const Fixture& fixture, const QString& name) {
  return nlohmann::json::parse(fixture.run({"inspect", name, "--json"}).out.toStdString());
}

}  // namespace

class ShellsTest : public QObject {
  Q_OBJECT

 private slots:
  void apartAndTogether_data() {
    QTest::addColumn<QString>("format");
    for (const char* name : {"stl", "ply", "obj", "off", "3mf"}) QTest::newRow(name) << name;
  }
  void apartAndTogether() {
    QFETCH(QString, format);
    const Fixture fixture;
    fixture.put("a.off", cube(2).add(tetrahedron(), {5, 0, 0}).add(cube(1), {0, 5, 0}).off());
    const Ran ran = fixture.run({"split", "a.off", "-o", "parts", "--format", format});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.out.count('\n'), 3);
    QStringList names;
    for (int i = 1; i <= 3; ++i) names << QString("parts/a-%1.%2").arg(i).arg(format);
    const double volumes[] = {8.0, 1.0 / 6.0, 1.0};
    for (int i = 0; i < 3; ++i)
      QVERIFY(std::abs(shellsInspected(fixture, names[i])["volume_mm3"].get<double>() - volumes[i]) < 1e-6);
    QCOMPARE(fixture.run({"split", "a.off", "-o", "parts", "--format", format}).code, 1);  // they are there already
    QVERIFY(QFile::remove(fixture.path() + "/" + names[0]));
    QCOMPARE(fixture.run({"split", "a.off", "-o", "parts", "--format", format}).code, 1);
    QVERIFY(!QFile::exists(fixture.path() + "/" + names[0]));  // all or none
    fixture.run({"split", "a.off", "-o", "again", "--format", format});
    QVERIFY(
        QFile::rename(fixture.path() + "/again/" + QFileInfo(names[0]).fileName(), fixture.path() + "/" + names[0]));

    QCOMPARE(fixture.run(QStringList{"merge"} + names + QStringList{"-o", "b.handwheel"}).code, 0);
    const auto report = shellsInspected(fixture, "b.handwheel");
    QCOMPARE(report["triangles"].get<int>(), 28);
    QVERIFY(std::abs(report["volume_mm3"].get<double>() - (9.0 + 1.0 / 6.0)) < 1e-6);
  }

  // Numbers of double precision among those of single precision are not rounded.
  void mergedWithoutRounding() {
    const Fixture fixture;
    fixture.put("a.off", cube(1).off());
    fixture.put("b.off", cube(1.0 / 3.0).off());
    QCOMPARE(fixture.run({"convert", "a.off", "a.stl"}).code, 0);
    QCOMPARE(fixture.run({"merge", "a.stl", "b.off", "-o", "c.ply"}).code, 0);
    QCOMPARE(fixture.run({"split", "c.ply", "-o", "parts"}).code, 0);
    QVERIFY(std::abs(shellsInspected(fixture, "parts/c-2.ply")["volume_mm3"].get<double>() - 1.0 / 27.0) < 1e-12);
  }

  void mistakes() {
    const Fixture fixture;
    fixture.put("a.off", cube().off());
    QCOMPARE(fixture.run({"split", "a.off"}).code, 1);
    QCOMPARE(fixture.run({"split", "a.off", "-o", "parts", "--format", "docx"}).code, 1);
    QCOMPARE(fixture.run({"split", "missing.off", "-o", "parts"}).code, 1);
    QCOMPARE(fixture.run({"split", "a.off", "-o", "a.off"}).code, 1);  // no folder
    QCOMPARE(fixture.run({"merge", "a.off", "missing.off", "-o", "b.off"}).code, 1);
    QCOMPARE(fixture.run({"merge", "a.off"}).code, 1);
    QCOMPARE(fixture.run({"merge", "a.off", "-o", "b.docx"}).code, 1);
    QCOMPARE(fixture.names(), QStringList{"a.off"});
  }
};

HANDWHEEL_TEST(ShellsTest)
#include "ShellsTest.moc"
