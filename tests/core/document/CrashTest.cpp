// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CrashModel.h"
#include "TestClass.h"
#include "document/FileBytes.h"
#include "document/recovery/OrphanedAutosaves.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>

using namespace handwheel;
using namespace handwheel::test;

// A child edits, autosaves and saves; it is killed at a random moment; the files on the disk are compared with its
// reports. HANDWHEEL_CRASHES: number of runs.

namespace {

constexpr std::int64_t kInterval =
    40'000;  // microseconds between a change and its autosave: 20 s, five hundred times faster

// Limit for a child that hangs; long, as a busy machine may suspend it.
constexpr std::int64_t kPatience = 120'000'000;  // microseconds

struct Event {
  std::string what;
  std::int64_t edits = 0;
  std::int64_t time = 0;  // microseconds
};

std::int64_t now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(time).count();
}

class Victim {
 public:
  Victim(const QString& file, const QString& root, int seed) {
    const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "CrashWriter";
    m_process.start(QString::fromStdString(program.string()),
                    {file, root, QString::number(seed), QString::number(kInterval)});
  }

  void readFor(std::int64_t microseconds) {
    const std::int64_t end = now() + microseconds;
    for (std::int64_t left = microseconds; left > 0; left = end - now()) read(static_cast<int>(left / 1000));
  }

  // Returns false if it did not come.
  bool waitFor(const QByteArray& word) {
    const qsizetype from = m_output.size();
    for (const std::int64_t end = now() + kPatience; now() < end; read(100))
      if (m_output.indexOf(word, from) >= 0) return true;
    return false;
  }

  // The time at which it was killed.
  std::int64_t kill() {
    const std::int64_t time = now();
    m_process.kill();
    m_process.waitForFinished();
    m_output += m_process.readAllStandardOutput();
    return time;
  }

  bool wasKilled() const { return m_process.exitStatus() == QProcess::CrashExit; }

  std::vector<Event> events() const {
    std::vector<Event> events;
    const QList<QByteArray> lines = m_output.split('\n');
    for (qsizetype i = 0; i + 1 < lines.size(); ++i) {  // the last one has no end
      const QList<QByteArray> words = lines[i].split(' ');
      events.push_back({words.at(0).toStdString(), words.at(1).toLongLong(), words.at(2).toLongLong()});
    }
    return events;
  }

 private:
  void read(int milliseconds) {
    m_process.waitForReadyRead(milliseconds);
    m_output += m_process.readAllStandardOutput();
  }

  QProcess m_process;
  QByteArray m_output;
};

std::int64_t editsInFile(const std::filesystem::path& file) {
  const auto bytes = readFileBytes(file);
  return bytes ? CrashModel::editsIn(*bytes) : -1;
}

// Figures over all crashes.
struct Tally {
  int crashes = 0, whileSaving = 0, whileStoring = 0, recovered = 0, promptly = 0;
  std::int64_t longestLoss = 0, longestWrite = 0;  // microseconds
};

// The events until the moment of the crash.
struct Story {
  std::int64_t saved = 0;     // edits in the last save that was reported as done
  std::int64_t saving = -1;   // in one that was under way
  std::int64_t stored = -1;   // in the last autosave that was done, when no later save made it void
  std::int64_t storing = -1;  // in one that was under way
  std::int64_t lastIdle = 0;  // when nothing was due
  std::int64_t longestWrite = 0;
};

Story storyOf(const std::vector<Event>& events, std::int64_t end) {
  Story story;
  std::int64_t began = 0;
  for (const Event& event : events) {
    if (event.what == "saving") story.saving = event.edits;
    if (event.what == "saved") story.saved = std::exchange(story.saving, -1);
    if (event.what == "storing") story.storing = event.edits, began = event.time;
    if (event.what == "stored") {
      story.stored = std::exchange(story.storing, -1);
      story.longestWrite = std::max(story.longestWrite, event.time - began);
    }
    if (event.what == "removed") story.stored = -1;
    if (event.what == "idle") story.lastIdle = event.time;
  }
  if (story.storing >= 0) story.longestWrite = std::max(story.longestWrite, end - began);
  return story;
}

void judge(const std::vector<Event>& events, std::int64_t end, const std::filesystem::path& file,
           const std::filesystem::path& root, Tally& tally) {
  const Story story = storyOf(events, end);

  // The saved file is the last one, or the one that was being written.
  const std::int64_t inFile = std::filesystem::exists(file) ? editsInFile(file) : 0;
  QVERIFY2(inFile == story.saved || (inFile > 0 && inFile == story.saving), "the saved file");

  const OrphanedAutosaves leftovers(root);
  QVERIFY(leftovers.skipped().empty());
  QVERIFY(leftovers.found().size() <= 1);
  std::int64_t recovered = 0;
  if (!leftovers.found().empty()) {
    recovered = editsInFile(leftovers.found()[0].file);
    QVERIFY2(recovered >= 0, "the autosave is damaged");
    QCOMPARE(leftovers.found()[0].info.path, file.string());
  }
  const std::int64_t best = std::max(inFile, recovered);
  QVERIFY2(best >= story.stored, "an autosave that was done is gone");

  // The autosaver was idle when the oldest lost edit was not yet due; since then it was busy with that one write.
  const auto lost =
      std::find_if(events.begin(), events.end(), [&](const Event& e) { return e.what == "edit" && e.edits > best; });
  const std::int64_t loss = lost == events.end() ? 0 : end - lost->time;
  QVERIFY2(loss <= kInterval + (end - story.lastIdle), "too much work is lost");

  ++tally.crashes;
  tally.whileSaving += story.saving >= 0;
  tally.whileStoring += story.storing >= 0;
  tally.recovered += recovered > inFile;
  tally.promptly += loss <= kInterval + story.longestWrite + kInterval / 5;
  tally.longestLoss = std::max(tally.longestLoss, loss);
  tally.longestWrite = std::max(tally.longestWrite, story.longestWrite);
  for (const OrphanedAutosave& leftover : leftovers.found()) leftovers.discard(leftover);
}

}  // namespace

class CrashTest : public QObject {
  Q_OBJECT

 private slots:
  void killedAtAnyMoment() {
    const int crashes = std::max(1, qEnvironmentVariableIntValue("HANDWHEEL_CRASHES") > 0
                                        ? qEnvironmentVariableIntValue("HANDWHEEL_CRASHES")
                                        : 60);
    std::mt19937 random(20);
    Tally tally;
    for (int i = 0; i < crashes; ++i) {
      QTemporaryDir folder;
      const QString file = folder.filePath("part.handwheel"), root = folder.filePath("recovery");
      Victim victim(file, root, i);
      QVERIFY(victim.waitFor("edit"));
      // The autosaver is at work at all.
      if (i % 4 == 2) QVERIFY(victim.waitFor("stored"));
      victim.readFor(random() % 200'000);
      // Every other kill is during a write.
      if (i % 4 == 1) QVERIFY(victim.waitFor("saving"));
      if (i % 4 == 3) QVERIFY(victim.waitFor("storing"));
      if (i % 2 == 1) victim.readFor(random() % 6000);
      const std::int64_t end = victim.kill();
      QVERIFY(victim.wasKilled());
      judge(victim.events(), end, file.toStdString(), root.toStdString(), tally);
      QVERIFY2(!QTest::currentTestFailed(), qPrintable(QString("crash %1").arg(i)));
      QVERIFY(OrphanedAutosaves(root.toStdString()).found().empty());
    }
    // The time is printed, not checked: the machine may be busy.
    qInfo(
        "%d crashes, %d while saving, %d while autosaving; %d recovered; longest loss %.1f ms, longest autosave %.1f "
        "ms, "
        "interval %.1f ms; %d within interval and one write",
        tally.crashes, tally.whileSaving, tally.whileStoring, tally.recovered, 1e-3 * tally.longestLoss,
        1e-3 * tally.longestWrite, 1e-3 * kInterval, tally.promptly);
    QVERIFY(tally.recovered > 0);
    QVERIFY(tally.whileSaving > 0 && tally.whileStoring > 0);
  }
};

HANDWHEEL_TEST(CrashTest)
#include "CrashTest.moc"
