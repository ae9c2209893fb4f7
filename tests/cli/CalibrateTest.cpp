// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "Program.h"
#include "TestClass.h"

#include <QTest>
#include <csignal>
#include <set>

using namespace handwheel;

namespace {

const QStringList kCalibrate{"measure", "--calibrate"};
const char* const kFile = "Handwheel/Handwheel/calibration.json";  // path that the window uses, below the cache folder

std::set<std::string> keptIds(const Fixture& cache) {
  std::set<std::string> ids;
  const auto kept = cache.json(kFile);
  for (const auto& curve : kept.at("curves")) ids.insert(curve.at("setting").get<std::string>());
  return ids;
}

}  // namespace

// Measures the machine on the command line, like the window's button "Measure this machine".
class CalibrateTest : public QObject {
  Q_OBJECT

 private slots:
  // A folder of its own for each test, as the user's cache folder.
  void init() {
    m_cache.emplace();
    qputenv("XDG_CACHE_HOME", m_cache->path().toLocal8Bit());
  }

  // One setting after the other: what was kept of the first stays.
  void whatWasMeasuredIsKept() {
    const Fixture fixture;
    const Ran first = fixture.run(kCalibrate + QStringList{"nurbs.chord_mm"});
    QCOMPARE(first.code, 0);
    QCOMPARE(first.err, QByteArray());
    for (const char* words : {"Machine: ", "Saved in: ", "\n  setting ", "\n  nurbs.chord_mm  ms "})
      QVERIFY2(first.out.contains(words), words);
    QCOMPARE(keptIds(*m_cache), std::set<std::string>{"nurbs.chord_mm"});

    const Ran second = fixture.run(kCalibrate + QStringList{"document.undo_granularity", "--json", "--csv", "a.csv"});
    QCOMPARE(second.code, 0);
    QCOMPARE(keptIds(*m_cache), (std::set<std::string>{"document.undo_granularity", "nurbs.chord_mm"}));
    const auto json = nlohmann::json::parse(second.out.toStdString());
    const auto kept = m_cache->json(kFile);
    QCOMPARE(json.at("settings").size(), std::size_t{1});
    QVERIFY(json.at("settings")[0].at("setting") == "document.undo_granularity");
    QVERIFY(json.at("machine") == kept.at("machine"));
    QCOMPARE(QString::fromStdString(json.at("file")), m_cache->path() + "/" + kFile);
    QVERIFY(fixture.content("a.csv").contains("document.undo_granularity,"));
    // The figures that are shown are those that are kept.
    const auto& rows = json.at("settings")[0].at("rows");
    for (const auto& curve : kept.at("curves")) {
      if (curve.at("setting") != "document.undo_granularity") continue;
      QCOMPARE(curve.at("rows").size(), rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i) QVERIFY(curve.at("rows")[i].at("cost") == rows[i].at("cost"));
    }
  }

  // Measurements of another machine are not mixed with those of this one.
  void anotherMachineIsForgotten() {
    const Fixture fixture;
    QCOMPARE(fixture.run(kCalibrate + QStringList{"nurbs.chord_mm"}).code, 0);
    auto other = m_cache->json(kFile);
    other["machine"] = "Abacus, 1 cores";
    m_cache->put(kFile, QByteArray::fromStdString(other.dump()));
    QCOMPARE(fixture.run(kCalibrate + QStringList{"document.undo_granularity"}).code, 0);
    QCOMPARE(keptIds(*m_cache), std::set<std::string>{"document.undo_granularity"});
    QVERIFY(m_cache->json(kFile).at("machine") != "Abacus, 1 cores");
  }

  // It is shown all the same.
  void whatCannotBeKeptIsReported() {
    qputenv("XDG_CACHE_HOME", "/proc/nowhere");
    const Fixture fixture;
    const Ran ran = fixture.run(kCalibrate + QStringList{"nurbs.chord_mm"});
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.out.contains("nurbs.chord_mm") && !ran.out.contains("Saved in"));
    QVERIFY(ran.err.startsWith("handwheel: ") && ran.err.count('\n') == 1);
  }

  void wrongWords() {
    const Fixture fixture;
    for (const QStringList& words :
         {QStringList{"--steps", "3"}, QStringList{"--repeats=2"}, QStringList{"--list"},
          QStringList{"--input", "a.stl"}, QStringList{"--budget", "ms=1"}, QStringList{"--write-curves", "."},
          QStringList{"view.coarse"}, QStringList{"servo.velocity_window"}}) {
      const Ran ran = fixture.run(kCalibrate + words);
      QCOMPARE(ran.code, 1);
      QCOMPARE(ran.out, QByteArray());
      QVERIFY(ran.err.endsWith("Try 'handwheel help measure'.\n"));
    }
    QVERIFY(m_cache->names().isEmpty());
  }

  // A curve that is not whole is not kept.
  void interrupted() {
    const Fixture fixture;
    QProcess process;
    process.setWorkingDirectory(fixture.path());
    process.start(test::programPath(), kCalibrate);
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(catches(process.processId(), SIGINT), 30000);
    QTest::qWait(700);  // into the servo loop's ticks
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(kLongestRun));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 130);
    QCOMPARE(process.readAllStandardError(), QByteArray("handwheel: Cancelled.\n"));
    QCOMPARE(process.readAllStandardOutput(), QByteArray());
    if (!m_cache->names().isEmpty()) QVERIFY(!keptIds(*m_cache).empty());  // on a machine that is quicker than that
  }

 private:
  std::optional<Fixture> m_cache;
};

HANDWHEEL_TEST(CalibrateTest)
#include "CalibrateTest.moc"
