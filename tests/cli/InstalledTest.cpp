// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"

#include <QDirIterator>
#include <QTest>
#include <memory>
#include <set>
#include <string>

using namespace handwheel;

// The program is installed into a folder that it was not configured for, as a package is made, and runs from there.
class InstalledTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> m_prefix;

  QString installed(const QString& name) const { return m_prefix->filePath(name); }
  QString program() const { return installed(BINARIES "/handwheel"); }

  QStringList filesBelow(const QString& folder) const {
    QStringList files;
    QDirIterator all(installed(folder), QDir::Files, QDirIterator::Subdirectories);
    while (all.hasNext()) files << all.next();
    return files;
  }

 private slots:
  void initTestCase() {
    for (const char* name :
         {"HANDWHEEL_PLUGINS", "HANDWHEEL_GUARDS", "HANDWHEEL_READERS", "LD_LIBRARY_PATH", "DESTDIR"})
      qunsetenv(name);
    m_prefix = std::make_unique<QTemporaryDir>();
    const Ran ran =
        runProgram(CMAKE, m_prefix->path(), {"--install", test::buildPath({}), "--prefix", m_prefix->path()});
    QVERIFY2(ran.code == 0, ran.err);
  }

  void tellsItsVersion() {
    const Fixture fixture;
    const Ran ran = runProgram(program(), fixture.path(), {"--version"});
    QVERIFY2(ran.code == 0, ran.err);
    QCOMPARE(ran.out, fixture.run({"--version"}).out);
  }

  void findsItsPlugins() {
    const Fixture fixture;
    const Ran ran = runProgram(program(), fixture.path(), {"devices", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json json = nlohmann::json::parse(ran.out.toStdString());
    std::set<std::string> drivers;
    for (const nlohmann::json& plugin : json["plugins"]) {
      QVERIFY2(plugin["error"].is_null(), plugin.dump().c_str());
      drivers.insert(plugin["driver"].get<std::string>());
    }
    // Those that need no library of others; the example is for the tests.
    for (const char* driver : {"haply", "openhaptics", "polhem"}) QVERIFY2(drivers.contains(driver), driver);
    QVERIFY(!drivers.contains("example"));
  }

  void repairsAMesh() {
    const Fixture fixture;
    fixture.put("open.off", openCube().off());
    const Ran ran = runProgram(program(), fixture.path(), {"repair", "open.off", "-o", "closed.off"});
    QVERIFY2(ran.code == 0, ran.err);
    const Ran inspected = runProgram(program(), fixture.path(), {"inspect", "closed.off", "--json"});
    QVERIFY2(inspected.code == 0, inspected.err);
    const nlohmann::json mesh = nlohmann::json::parse(inspected.out.toStdString());
    QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>());
    QCOMPARE(mesh["boundary_loops"].get<int>(), 0);
  }

  void readsAStepFile() {
    const Fixture fixture;
    for (const QStringList& words :
         {QStringList{"new", "workpiece", "-o", "bar.handwheel"}, QStringList{"convert", "bar.handwheel", "bar.step"},
          QStringList{"inspect", "bar.step"}}) {
      const Ran ran = runProgram(program(), fixture.path(), words);
      QVERIFY2(ran.code == 0, ran.err);
    }
  }

  // Not even where the build folder still stands: a package is used where there is none.
  void loadsNothingFromTheBuildFolder() {
    QStringList files{program()};
    files << filesBelow(LIBRARIES);
    QVERIFY(files.contains(installed(LIBRARIES "/guards/polhem")));
    QVERIFY(files.contains(installed(LIBRARIES "/readers/step")));
    for (const QString& file : files) {
      const Ran ran = runProgram("ldd", m_prefix->path(), {file});
      QVERIFY2(ran.code == 0, qPrintable(file + ran.err));
      QVERIFY2(!ran.out.contains("not found") && !ran.out.contains(test::buildPath({}).toUtf8()),
               qPrintable(file + '\n' + ran.out));
    }
  }

  void bringsItsSamples() {
    const QDir shipped(test::sourcePath("resources/samples"));
    QVERIFY(!shipped.isEmpty(QDir::Files));
    for (const QString& name : shipped.entryList(QDir::Files)) {
      QFile source(shipped.filePath(name));
      QFile copy(installed(DATA "/handwheel/samples/" + name));
      QVERIFY(source.open(QIODevice::ReadOnly));
      QVERIFY2(copy.open(QIODevice::ReadOnly), qPrintable(name));
      QVERIFY2(copy.readAll() == source.readAll(), qPrintable(name));
    }
  }

  // The words by which the desktop finds the program, its icon and its documents fit each other.
  void joinsTheDesktop() {
    QFile entry(installed(DATA "/applications/handwheel.desktop"));
    QVERIFY(entry.open(QIODevice::ReadOnly));
    const QByteArray text = entry.readAll();
    QVERIFY(text.startsWith("[Desktop Entry]\nType=Application\n"));
    QVERIFY(text.contains("\nExec=handwheel %F\n"));
    QVERIFY(text.contains("\nIcon=handwheel\n"));
    QVERIFY(text.contains("application/x-handwheel;"));
    QFile types(installed(DATA "/mime/packages/handwheel.xml"));
    QVERIFY(types.open(QIODevice::ReadOnly));
    QVERIFY(types.readAll().contains("type=\"application/x-handwheel\""));
    QFile icon(installed(DATA "/icons/hicolor/scalable/apps/handwheel.svg"));
    QVERIFY(icon.open(QIODevice::ReadOnly));
    const QByteArray drawing = icon.readAll();
    QVERIFY(drawing.contains("<svg") && !drawing.contains("currentColor"));
  }
};

HANDWHEEL_TEST(InstalledTest)
#include "InstalledTest.moc"
