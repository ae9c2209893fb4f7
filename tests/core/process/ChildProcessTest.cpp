// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "process/ChildProcess.h"

#include "TestClass.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <QTest>
#include <cerrno>

using namespace handwheel;

namespace {

using namespace std::chrono_literals;

std::unique_ptr<ChildProcess> shell(const std::string& command, const ChildOptions& options = {}) {
  return ChildProcess::start({"/bin/sh", "-c", command}, options);
}

// Returns the child once it has ended.
std::unique_ptr<ChildProcess> ran(const std::string& command, const ChildOptions& options = {}) {
  auto child = shell(command, options);
  while (child && !child->hasEnded()) ChildProcess::wait(std::span(&child, 1), 1s);
  return child;
}

bool hasNoChildren() {
  return waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD;
}

}  // namespace

class ChildProcessTest : public QObject {
  Q_OBJECT

 private slots:
  void capturesBothStreams() {
    const auto child = ran("echo said; echo complained >&2; exit 3");
    QVERIFY(child);
    QCOMPARE(child->code(), 3);
    QCOMPARE(child->output(), std::string("said\n"));
    QCOMPARE(child->errors(), std::string("complained\n"));
    QVERIFY(!child->hasMoreOutput());
  }

  void codesOfSignalsAndOfMissingPrograms() {
    QCOMPARE(ran("kill -SEGV $$")->code(), 128 + SIGSEGV);
    auto none = ChildProcess::start({"/no/such/program"});
    while (!none->hasEnded()) ChildProcess::wait(std::span(&none, 1), 1s);
    QCOMPARE(none->code(), 127);
  }

  // The beginning of its output, the end of its errors.
  void keepsABoundedPart() {
    const auto child = ran("seq 1 100000; seq 1 100000 >&2", {.mostOutput = 1000});
    QCOMPARE(child->output().size(), std::size_t{1000});
    QVERIFY(child->output().starts_with("1\n2\n"));
    QVERIFY(child->hasMoreOutput());
    QVERIFY(child->errors().size() == 64 << 10);
    QVERIFY(child->errors().ends_with("99999\n100000\n"));
  }

  void readsWhatItIsGiven() {
    std::array<int, 2> pipe{};
    QVERIFY(pipe2(pipe.data(), O_CLOEXEC) == 0);
    QVERIFY(write(pipe[1], "given", 5) == 5);
    close(pipe[1]);
    const auto child = ran("cat", {.input = pipe[0]});
    close(pipe[0]);
    QCOMPARE(child->output(), std::string("given"));
    QCOMPARE(ran("cat")->output(), std::string());
  }

  // Streams of ours are closed, and its pipes get their numbers.
  void closedStreamsAreNoMatter() {
    const int input = dup(STDIN_FILENO);
    close(STDIN_FILENO);
    const auto child = ran("echo said; echo complained >&2; cat");
    dup2(input, STDIN_FILENO);
    close(input);
    QCOMPARE(child->output(), std::string("said\n"));
    QCOMPARE(child->errors(), std::string("complained\n"));
  }

  void itsEndKillsIt() {
    auto child = shell("sleep 1000");
    QVERIFY(child && !child->hasEnded());
    child.reset();
    QVERIFY(hasNoChildren());
  }

  void confined() {
    const auto child = ran("ulimit -c; ulimit -t; ulimit -v; ps -o pgid= -p $$; echo $$",
                           {.limits = ProcessLimits{std::uint64_t{512} << 20, 7}});
    const QStringList lines = QString::fromStdString(child->output()).split('\n');
    QVERIFY2(lines.size() >= 5, child->output().c_str());
    QVERIFY(lines[0] == "0" || lines[0] == "1");  // one byte, which shells show in blocks
    QCOMPARE(lines[1], QString("7"));
    QCOMPARE(lines[2], QString::number(512 << 10));
    QCOMPARE(lines[3].trimmed(), lines[4]);  // a group of its own
  }

  // fork() calls them, and copies the page tables of an editor that may be large; vfork() does neither.
  void copiesNoMemory() {
#ifdef __SANITIZE_THREAD__
    QSKIP("ThreadSanitizer makes a fork() of it");
#endif
    static int forks = 0;
    QCOMPARE(pthread_atfork([] { ++forks; }, nullptr, nullptr), 0);
    QCOMPARE(ran("echo said", {.limits = ProcessLimits{}})->output(), std::string("said\n"));
    QCOMPARE(forks, 0);
  }

  void wakesWhenItEnds() {
    auto child = shell("exec >&- 2>&-; sleep 0.2");
    QElapsedTimer clock;
    clock.start();
    while (!child->hasEnded() && clock.elapsed() < 20'000) ChildProcess::wait(std::span(&child, 1), 30s);
    QVERIFY(child->hasEnded() && clock.elapsed() < 20'000);
  }
};

HANDWHEEL_TEST(ChildProcessTest)
#include "ChildProcessTest.moc"
