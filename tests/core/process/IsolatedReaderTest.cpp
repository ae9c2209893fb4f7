// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "process/IsolatedReader.h"

#include "TestClass.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <QProcess>
#include <QTest>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

using namespace handwheel;

namespace {

using namespace std::chrono_literals;

IsolatedReader hostile() {
  return {test::buildPath("tests/HostileReader").toStdString(), "A Library", {}};
}

Result<std::string> readAs(const std::string& how, std::string_view bytes = {}) {
  return readIsolated(hostile(), {how}, bytes);
}

// Returns "CODE: reason", or the content.
QString outcomeOf(const Result<std::string>& read) {
  if (read) return QStringLiteral("read ") + QString::fromStdString(*read);
  const Error& error = read.error();
  if (error.code == ErrorCode::OutOfMemory) return QStringLiteral("memory");
  if (error.code == ErrorCode::Cancelled) return QStringLiteral("cancelled");
  if (error.code != ErrorCode::LibraryFailed || error.arguments.size() != 2) return QStringLiteral("another error");
  return QString::fromStdString(error.arguments[0] + ": " + error.arguments[1]);
}

// Returns the number of processes that were started with this word.
int processesWith(const std::string& mark) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ostringstream words;
    words << std::ifstream(entry.path() / "cmdline").rdbuf();  // empty for a process that has just ended
    if (words.str().find(std::string(1, '\0') + mark + '\0') != std::string::npos) ++count;
  }
  return count;
}

std::size_t openFiles() {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {}));
}

// Returns the time from the cancel until the reader is gone.
std::chrono::steady_clock::duration timeToCancel(const char* how) {
  JobState job;
  const std::string mark = "cancelled-" + std::to_string(getpid());
  std::chrono::steady_clock::time_point cancelled;
  std::thread person([&] {
    std::this_thread::sleep_for(300ms);
    cancelled = std::chrono::steady_clock::now();
    job.cancelled = true;
  });
  IsolatedReader reader = hostile();
  reader.limits.mostOutput = ~std::size_t{0};
  const auto read = readIsolated(reader, {how, mark}, "", Progress(job));
  const auto end = std::chrono::steady_clock::now();
  person.join();
  if (outcomeOf(read) != "cancelled" || processesWith(mark) != 0) qFatal("%s: it was not cancelled", how);
  return end - cancelled;
}

}  // namespace

class IsolatedReaderTest : public QObject {
  Q_OBJECT

 private:
  std::size_t m_openBefore = 0;

 private slots:
  void init() { m_openBefore = openFiles(); }

  // After any test: no child is left, not even a dead one, and no file is open.
  void cleanup() {
    QVERIFY(waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD);
    QCOMPARE(openFiles(), m_openBefore);
  }

  void answersAreHandedOver() {
    QCOMPARE(outcomeOf(readAs("echo", "bytes")), QString("read bytes"));
    QCOMPARE(outcomeOf(readAs("echo")), QString("read "));
    QCOMPARE(outcomeOf(readAs("say")), QString("read content"));  // and not what the library prints
    std::string all;
    for (int i = 0; i < 1 << 20; ++i) all.push_back(static_cast<char>(i * 7));
    QVERIFY(readAs("echo", all).value() == all);
  }

  void failuresAreErrors_data() {
    QTest::addColumn<QString>("how");
    QTest::addColumn<QString>("outcome");
    QTest::newRow("refuses") << "refuse"
                             << "A Library: it is not what it says";
    QTest::newRow("throws") << "throw"
                            << "A Library: an exception of the library";
    QTest::newRow("aborts") << "abort"
                            << "A Library: it crashed on this file";
    QTest::newRow("recurses") << "recurse"
                              << "A Library: it crashed on this file";
    QTest::newRow("is killed") << "kill"
                               << "A Library: the system ended it; it may have run out of memory";
    QTest::newRow("exits") << "exit"
                           << "A Library: its answer is not valid";
    QTest::newRow("garbage") << "garbage"
                             << "A Library: its answer is not valid";
    QTest::newRow("a long reason") << "babble"
                                   << "A Library: its answer is not valid";
  }
  void failuresAreErrors() {
    QFETCH(QString, how);
    QFETCH(QString, outcome);
    QCOMPARE(outcomeOf(readAs(how.toStdString(), "bytes")), outcome);
  }

  void aMissingProgram() {
    IsolatedReader none = hostile();
    none.program = "/no/such/program";
    QCOMPARE(outcomeOf(readIsolated(none, {}, "bytes")), QString("A Library: its process cannot be started"));
  }

  void limits() {
    IsolatedReader reader = hostile();
    reader.limits.memory = std::min(reader.limits.memory, std::uint64_t{256} << 20);
    if (reader.limits.memory != 0) QCOMPARE(outcomeOf(readIsolated(reader, {"allocate"}, "")), QString("memory"));
    reader = hostile();
    reader.limits.cpu = 1s;
    QCOMPARE(outcomeOf(readIsolated(reader, {"work"}, "")), QString("A Library: it took longer than 1 s"));
    reader = hostile();
    reader.limits.wall = 1s;
    for (const char* how : {"sleep", "close", "complain"})
      QCOMPARE(outcomeOf(readIsolated(reader, {how}, "")), QString("A Library: it took longer than 1 s"));
    reader = hostile();
    reader.limits.mostOutput = 1 << 20;
    for (const char* how : {"flood", "large"})
      QCOMPARE(outcomeOf(readIsolated(reader, {how}, "")), QString("A Library: its answer is too large"));
  }

  void waitsTwiceAsLongAsItMayWork() { QCOMPARE(ReaderLimits().wall.count(), 2 * ReaderLimits().cpu.count()); }

  void whatTheProcessGets() {
    IsolatedReader reader = hostile();
    reader.limits.cpu = 11s;
    const QString limits = outcomeOf(readIsolated(reader, {"limits"}, ""));
    const bool isSanitized = reader.limits.memory == 0;  // the runtime of a sanitizer lowers the limit of cores further
    QVERIFY2(limits.startsWith(isSanitized ? "read core 0\ncpu 11\n" : "read core 1\ncpu 11\n"), qPrintable(limits));
    if (!isSanitized)
      QVERIFY(limits.endsWith(QString("memory %1\n").arg(static_cast<qulonglong>(reader.limits.memory))));
  }

  // A file that a library of ours opened without saying that it is for us alone.
  void noFileIsInherited() {
    const int leaked = open("/etc/passwd", O_RDONLY);
    const QString files = outcomeOf(readAs("files", "bytes"));
    close(leaked);
    QVERIFY2(files.contains("memfd:handwheel"), qPrintable(files));
    QVERIFY2(!files.contains("passwd"), qPrintable(files));
  }

  void noSignalIsInherited() {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const auto pipeBefore = signal(SIGPIPE, SIG_IGN);
    const QString status = outcomeOf(readAs("status"));
    signal(SIGPIPE, pipeBefore);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    QVERIFY2(status.contains("SigBlk:\t0000000000000000\n"), qPrintable(status));
    const auto ignored = status.mid(status.indexOf("SigIgn:\t") + 8, 16).toULongLong(nullptr, 16);
    QCOMPARE(ignored & (1ULL << (SIGPIPE - 1)), 0ULL);
    QVERIFY(status.contains("NoNewPrivs:\t1\n"));
  }

  void progressComesBack() {
    JobState job;
    std::vector<double> seen;
    std::atomic<bool> isDone{false};
    std::thread watcher([&] {
      for (; !isDone; std::this_thread::sleep_for(5ms)) {
        const double fraction = job.fraction;
        if (seen.empty() || seen.back() != fraction) seen.push_back(fraction);
      }
    });
    const auto read = readIsolated(hostile(), {"report"}, "", Progress(job));
    isDone = true;
    watcher.join();
    QCOMPARE(outcomeOf(read), QString("read reported"));
    QVERIFY(std::is_sorted(seen.begin(), seen.end()));
    QVERIFY(std::find(seen.begin(), seen.end(), 0.5) != seen.end());
  }

  // A cancel works in any state of the reader, also before it starts. Within 250 ms on an idle machine: the shortest of
  // some tries is taken.
  void cancelKillsIt() {
    constexpr int kTries = 5;
    for (const char* how : {"sleep", "work", "flood", "complain", "close"}) {
      auto least = std::chrono::steady_clock::duration::max();
      for (int i = 0; i < kTries && least >= 250ms; ++i) least = std::min(least, timeToCancel(how));
      QVERIFY2(least < 250ms, how);
    }
    JobState job;
    job.cancelled = true;
    QCOMPARE(outcomeOf(readIsolated(hostile(), {"echo"}, "bytes", Progress(job))), QString("cancelled"));
  }

  // A program that is killed leaves none of its readers.
  void diesWithTheProgram() {
    const std::string mark = "orphan-" + std::to_string(getpid());
    {
      const QString input = test::buildPath("tests/HostileReader");
      QProcess parent;
      parent.setStandardInputFile(input);  // any file will do
      parent.start(test::buildPath("tests/HostileReader"), {"parent", QString::fromStdString(mark)});
      QVERIFY(parent.waitForStarted());
      QTRY_COMPARE(processesWith(mark), 2);  // the parent has the mark as its second word, too
      ::kill(static_cast<pid_t>(parent.processId()), SIGKILL);
      parent.waitForFinished();
    }
    QTRY_COMPARE(processesWith(mark), 0);
  }

  void onManyThreads() {
    std::atomic<int> right{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
      threads.emplace_back([&right, i] {
        for (int n = 0; n < 5; ++n) {
          const std::string bytes = std::to_string(100 * i + n);
          if (const auto read = readAs("echo", bytes); read && *read == bytes) ++right;
        }
      });
    for (std::thread& thread : threads) thread.join();
    QCOMPARE(right.load(), 40);
  }

  // The reader is started by a person who found it in the folder.
  void startedByHand() {
    QProcess program;
    program.start(test::buildPath("tests/HostileReader"), {"echo"});
    QVERIFY(program.waitForFinished());
    QCOMPARE(program.exitCode(), 2);
    QVERIFY(program.readAllStandardError().contains("to read a file"));
  }

  void whereReadersAre() {
    qunsetenv("HANDWHEEL_READERS");
    QVERIFY(QString::fromStdString(readerProgram("step")).endsWith("/readers/step"));
    qputenv("HANDWHEEL_READERS", "/elsewhere");
    QCOMPARE(readerProgram("step"), std::string("/elsewhere/step"));
    qunsetenv("HANDWHEEL_READERS");
  }
};

HANDWHEEL_TEST(IsolatedReaderTest)
#include "IsolatedReaderTest.moc"
