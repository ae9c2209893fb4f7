// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

namespace {

nlohmann::json shellsInspected(const Bench& bench, const QString& name) {
  return nlohmann::json::parse(bench.run({"inspect", name, "--json"}).out.toStdString());
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
    const Bench bench;
    bench.put("a.off", cube(2).add(tetrahedron(), {5, 0, 0}).add(cube(1), {0, 5, 0}).off());
    const Ran ran = bench.run({"split", "a.off", "-o", "parts", "--format", format});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.out.count('\n'), 3);
    QStringList names;
    for (int i = 1; i <= 3; ++i) names << QString("parts/a-%1.%2").arg(i).arg(format);
    const double volumes[] = {8.0, 1.0 / 6.0, 1.0};
    for (int i = 0; i < 3; ++i)
      QVERIFY(std::abs(shellsInspected(bench, names[i])["volume_mm3"].get<double>() - volumes[i]) < 1e-6);
    QCOMPARE(bench.run({"split", "a.off", "-o", "parts", "--format", format}).code, 1);  // they are there already
    QVERIFY(QFile::remove(bench.path() + "/" + names[0]));
    QCOMPARE(bench.run({"split", "a.off", "-o", "parts", "--format", format}).code, 1);
    QVERIFY(!QFile::exists(bench.path() + "/" + names[0]));  // all or none
    bench.run({"split", "a.off", "-o", "again", "--format", format});
    QVERIFY(QFile::rename(bench.path() + "/again/" + QFileInfo(names[0]).fileName(), bench.path() + "/" + names[0]));

    QCOMPARE(bench.run(QStringList{"merge"} + names + QStringList{"-o", "b.handwheel"}).code, 0);
    const auto report = shellsInspected(bench, "b.handwheel");
    QCOMPARE(report["triangles"].get<int>(), 28);
    QVERIFY(std::abs(report["volume_mm3"].get<double>() - (9.0 + 1.0 / 6.0)) < 1e-6);
  }

  // Numbers of double precision among those of single precision are not rounded.
  void mergedWithoutRounding() {
    const Bench bench;
    bench.put("a.off", cube(1).off());
    bench.put("b.off", cube(1.0 / 3.0).off());
    QCOMPARE(bench.run({"convert", "a.off", "a.stl"}).code, 0);
    QCOMPARE(bench.run({"merge", "a.stl", "b.off", "-o", "c.ply"}).code, 0);
    QCOMPARE(bench.run({"split", "c.ply", "-o", "parts"}).code, 0);
    QVERIFY(std::abs(shellsInspected(bench, "parts/c-2.ply")["volume_mm3"].get<double>() - 1.0 / 27.0) < 1e-12);
  }

  void mistakes() {
    const Bench bench;
    bench.put("a.off", cube().off());
    QCOMPARE(bench.run({"split", "a.off"}).code, 1);
    QCOMPARE(bench.run({"split", "a.off", "-o", "parts", "--format", "docx"}).code, 1);
    QCOMPARE(bench.run({"split", "missing.off", "-o", "parts"}).code, 1);
    QCOMPARE(bench.run({"split", "a.off", "-o", "a.off"}).code, 1);  // no folder
    QCOMPARE(bench.run({"merge", "a.off", "missing.off", "-o", "b.off"}).code, 1);
    QCOMPARE(bench.run({"merge", "a.off"}).code, 1);
    QCOMPARE(bench.run({"merge", "a.off", "-o", "b.docx"}).code, 1);
    QCOMPARE(bench.names(), QStringList{"a.off"});
  }
};

HANDWHEEL_TEST(ShellsTest)
#include "ShellsTest.moc"
