// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "LargeInputs.h"
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"

#include <sys/resource.h>
#include <QStandardPaths>
#include <QTest>
#include <optional>

using namespace handwheel;

namespace {

const QByteArray kOld = "what was there before";

// Runs the program with so many mebibytes of addresses; none: as many as there are.
Ran runWithin(const Fixture& fixture, std::optional<rlim_t> mebibytes, const QStringList& words) {
  QProcess process;
  QProcessEnvironment environment = environmentWith("C");
  environment.remove("DISPLAY");
  process.setProcessEnvironment(environment);
  process.setWorkingDirectory(fixture.path());
  process.setChildProcessModifier([mebibytes] {
    if (!mebibytes) return;
    const rlimit limit{*mebibytes << 20, *mebibytes << 20};
    setrlimit(RLIMIT_AS, &limit);
  });
  process.start(test::programPath(), words);
  return process.waitForFinished(120000) ? resultOf(process) : Ran{};
}

bool isDone(const Ran& ran) {
  return ran.code == 0 || ran.code == 2;
}

// A limit within which it comes to its end, and does not with one smaller by up to the step. enough: taken to be one.
rlim_t leastFor(const Fixture& fixture, const QStringList& words, rlim_t step, rlim_t enough = 512) {
  rlim_t least = enough, tooLittle = 128;
  while (least - tooLittle > step) {
    const rlim_t middle = (least + tooLittle) / 2;
    (isDone(runWithin(fixture, middle, words)) ? least : tooLittle) = middle;
  }
  return least;
}

// A closed torus: with nothing to repair, looking at the result takes the most memory.
QByteArray torus(int n) {
  const auto at = [n](int x, int y) {
    const double u = 2 * M_PI * x / n, v = 2 * M_PI * y / n;
    const double r = 3 + std::cos(v);
    return std::array<double, 3>{r * std::cos(u), r * std::sin(u), std::sin(v)};
  };
  return grid(n, n, at, [](int, int) { return false; }).off();
}

}  // namespace

// Near the end of memory.
class MemoryTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    if (runWithin(Fixture(), 4096, {"--version"}).code != 0) QSKIP("a build with sanitizers takes more addresses");
  }

  // Either the whole of the new file and no error, or an error and the old one.
  void oldFileOrNewFile_data() {
    QTest::addColumn<QStringList>("words");
    // A repair with a report does all that this one does.
    if (test::withLargeInputs()) QTest::newRow("repair") << QStringList{"repair", "a.off", "-o", "b.stl"};
    QTest::newRow("with a report") << QStringList{"repair", "a.off", "-o", "b.stl", "--report", "r.json"};
    QTest::newRow("convert") << QStringList{"convert", "a.off", "b.stl"};
    QTest::newRow("edit") << QStringList{"edit", "a.off", "delete 1", "-o", "b.stl"};
  }
  void oldFileOrNewFile() {
    QFETCH(QStringList, words);
    constexpr rlim_t kStep = 5;
    const Fixture fixture;
    fixture.put("a.off", torus(test::sized(24, 60)));
    QVERIFY(isDone(runWithin(fixture, {}, words)));
    const QByteArray whole = fixture.content("b.stl");
    const QStringList names = fixture.names();
    const rlim_t least = leastFor(fixture, words, 2 * kStep);
    for (rlim_t limit = least + kStep; limit > least - 4 * kStep; limit -= kStep) {
      fixture.put("b.stl", kOld);
      if (names.contains("r.json")) fixture.put("r.json", kOld);
      const Ran ran = runWithin(fixture, limit, words);
      const bool isEnded = isDone(ran) || ran.code == 1;
      if (!isEnded && runWithin(fixture, limit, {"--version"}).code != 0) break;  // no room for the libraries
      QVERIFY2(isEnded, ran.err);
      QCOMPARE(fixture.content("b.stl"), isDone(ran) ? whole : kOld);
      if (names.contains("r.json")) QCOMPARE(fixture.content("r.json") == kOld, !isDone(ran));
      QCOMPARE(fixture.names(), names);
      if (!isDone(ran)) QVERIFY2(ran.err.contains(": there is not enough memory. "), ran.err);
    }
  }

  // Its file is named, and what to do; no crash of the graphics is left to guess from.
  void pictureSaysSo_data() {
    QTest::addColumn<int>("mebibytes");
    for (int limit : {300, 450, 600}) QTest::addRow("%d MiB", limit) << limit;
  }
  void pictureSaysSo() {
    if (QStandardPaths::findExecutable("xvfb-run").isEmpty()) QSKIP("xvfb-run is not installed");
    QFETCH(int, mebibytes);
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    const Ran ran = runWithin(fixture, mebibytes, {"picture", "a.off", "p.png"});
    if (ran.code == 0) QSKIP("it is enough here");
    if (runWithin(fixture, mebibytes, {"--version"}).code != 0) QSKIP("there is no room for the libraries");
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains("handwheel: a.off: there is not enough memory. "), ran.err);
    QCOMPARE(fixture.names(), QStringList{"a.off"});
  }

  // Tests that memory may run out after the graphics have drawn, while the pixels are read and flipped.
  void lastStepsOfAPictureSaySo() {
    if (QStandardPaths::findExecutable("xvfb-run").isEmpty()) QSKIP("xvfb-run is not installed");
    constexpr rlim_t kStep = 3;  // one picture takes as much
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    const QStringList words{"picture", "a.off", "p.png"};
    const rlim_t least = leastFor(fixture, words, kStep, 600);
    for (rlim_t limit = least; limit > least - 5 * kStep; limit -= kStep) {
      QFile::remove(fixture.path() + "/p.png");
      const Ran ran = runWithin(fixture, limit, words);
      QCOMPARE(fixture.names().contains("p.png"), ran.code == 0);
      if (ran.code == 0) continue;
      QCOMPARE(ran.code, 1);
      QVERIFY2(ran.err.contains("handwheel: a.off: there is not enough memory. "), ran.err);
    }
  }

  // The repair stands without its picture.
  void noPictureIsNoFailure() {
    if (QStandardPaths::findExecutable("xvfb-run").isEmpty()) QSKIP("xvfb-run is not installed");
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    const Ran ran = runWithin(fixture, 450, {"repair", "a.off", "-o", "b.stl", "--screenshot", "p.png"});
    QCOMPARE(ran.code, 0);
    QVERIFY2(ran.err.contains("memory"), ran.err);
    QCOMPARE(fixture.names(), (QStringList{"a.off", "b.stl"}));
  }
};

HANDWHEEL_TEST(MemoryTest)
#include "MemoryTest.moc"
