// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BatchFixture.h"
#include "TestClass.h"

#include <utime.h>

using namespace handwheel;
using Json = nlohmann::json;

// A batch that was stopped goes on, and believes a report only as far as it makes sense.
class BatchResumeTest : public QObject {
  Q_OBJECT

 private slots:
  void resumesWhatWasKilled() {
    const Fixture fixture;
    putGoodFiles(fixture);
    putInto(fixture, "in/large.off", largeTube());
    Batch batch(fixture, {"in", "-o", "out"});
    QTRY_VERIFY_WITH_TIMEOUT(batch.childFor("in/large.off") != 0, 30000);
    const pid_t child = batch.childFor("in/large.off");
    QVERIFY(tellsOf(fixture, "in/a.off"));
    batch.send(SIGKILL);
    QCOMPARE(batch.finish().code, -1);
    QTRY_VERIFY(isGone(child));  // it does not outlive the batch
    QCOMPARE(fixture.json("out/repair-report.json").at("summary").at("not_done").get<int>(), 3);
    QVERIFY(!QFile::exists(fixture.path() + "/out/large.off"));

    const QDateTime written = QFileInfo(fixture.path() + "/out/a.off").lastModified();
    const Ran ran = fixture.run({"repair", "in", "-o", "out", "--resume"});
    QVERIFY(ran.code == 0 || ran.code == 2);
    QVERIFY(lineWith(ran, "in/a.off").endsWith(" (done before)"));
    QCOMPARE(ran.out.count("done before"), 1);
    QCOMPARE(QFileInfo(fixture.path() + "/out/a.off").lastModified(), written);
    QCOMPARE(fixture.json("out/repair-report.json").at("summary").at("not_done").get<int>(), 0);
    QCOMPARE(QDir(fixture.path() + "/out").entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             (QStringList{"a.off", "large.off", "repair-report.json", "sub"}));
  }

  void resumeDoesWhatHasChanged() {
    const Fixture fixture;
    putGoodFiles(fixture);
    putInto(fixture, "in/bad.off", "OFF\nnonsense\n");
    const auto doneBefore = [&](const QStringList& more) {
      const Ran ran = fixture.run(QStringList{"repair", "in", "-o", "out", "--resume"} + more);
      return ran.code == 1 ? ran.out.count("done before") : -1;
    };
    QCOMPARE(doneBefore({}), 0);  // there is no earlier run
    QCOMPARE(doneBefore({}), 3);  // failed files are tried again
    QCOMPARE(doneBefore({"-j", "2", "--time-limit", "1000"}), 3);
    QVERIFY(QFile::remove(fixture.path() + "/out/a.off"));
    QCOMPARE(doneBefore({}), 2);
    putInto(fixture, "in/sub/b.off", cube(2.0).off() + "\n");
    QCOMPARE(doneBefore({}), 2);
    const utimbuf earlier{1000, 1000};
    QCOMPARE(::utime(qPrintable(fixture.path() + "/in/a.off"), &earlier), 0);
    QCOMPARE(doneBefore({}), 2);
    putInto(fixture, "out/sub/c.off", "cut short");
    QCOMPARE(doneBefore({}), 2);
    QCOMPARE(doneBefore({"--fill", "ear"}), 0);
    QCOMPARE(doneBefore({"--fill=ear"}), 3);
    QCOMPARE(fixture.json("out/repair-report.json").at("options").at(0).get<std::string>(), std::string("--fill=ear"));
  }

  void reportThatIsNone_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("text") << QByteArray("my thesis");
    QTest::newRow("other JSON") << QByteArray("{\"before\": 1}");
    QTest::newRow("a list") << QByteArray("[]");
    QTest::newRow("files of another kind") << QByteArray("{\"batch\": \"1\", \"files\": {}}");
    QTest::newRow("deep") << QByteArray(100000, '[');
  }
  void reportThatIsNone() {
    QFETCH(QByteArray, content);
    const Fixture fixture;
    putGoodFiles(fixture);
    fixture.put("r.json", content);
    const Ran ran = fixture.run({"repair", "in", "-o", "out", "--report", "r.json", "--resume"});
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.startsWith("handwheel: r.json is not a report to resume from: "), ran.err);
    QCOMPARE(fixture.content("r.json"), content);
  }

  // Entries that make no sense are as if they were not there.
  void reportWithNonsense() {
    const Fixture fixture;
    putGoodFiles(fixture);
    QCOMPARE(fixture.run({"repair", "in", "-o", "out"}).code, 0);
    Json report = fixture.json("out/repair-report.json");
    report["files"][0]["input_bytes"] = "many";
    report["files"][1]["state"] = 7;
    report["files"].push_back(nullptr);
    report["files"].push_back({{"state", "closed"}, {"notes", 3}, {"seconds", "x"}});
    fixture.put("out/repair-report.json", QByteArray::fromStdString(report.dump()));
    const Ran ran = fixture.run({"repair", "in", "-o", "out", "--resume"});
    QCOMPARE(ran.code, 0);
    QCOMPARE(ran.out.count("done before"), 1);
    QVERIFY(lineWith(ran, "in/sub/c.off").endsWith("(done before)"));
  }
};

HANDWHEEL_TEST(BatchResumeTest)
#include "BatchResumeTest.moc"
