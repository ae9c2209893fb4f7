// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../window/WindowTestMain.h"
#include "RandomUser.h"
#include "builtin/BuiltInKinds.h"
#include "window/JobRunner.h"
#include "window/MainWindow.h"

#include <QDeadlineTimer>
#include <QThreadPool>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr int kUsualSeconds = 15;
constexpr int kRoundSeconds = 60;    // after that everything is undone, and a new window begins
constexpr int kLongestSilence = 90;  // s without an action: the window hangs (sanitizers make it slow)

int number(const char* name, int otherwise) {
  bool isNumber = false;
  const int value = qEnvironmentVariableIntValue(name, &isNumber);
  return isNumber ? value : otherwise;
}

// Ends the program with a stack for the debugger when the window thread has done nothing for too long.
class HangWatch {
 public:
  HangWatch() : m_thread([this] { watch(); }) {}
  ~HangWatch() {
    m_isOver = true;
    m_thread.join();
  }
  void alive() { ++m_beats; }

 private:
  void watch() {
    std::uint64_t last = 0;
    for (int silent = 0; !m_isOver; ++silent) {
      if (std::exchange(last, m_beats.load()) != m_beats.load()) silent = 0;
      if (silent > 10 * kLongestSilence) {
        std::fputs("RandomUseTest: the window hangs\n", stderr);
        std::abort();
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }

  std::atomic<bool> m_isOver{false};
  std::atomic<std::uint64_t> m_beats{0};
  std::thread m_thread;
};

}  // namespace

// A user who does anything at all with the window. HANDWHEEL_RANDOM_SECONDS is the duration, HANDWHEEL_RANDOM_SEED the
// seed.
class RandomUseTest : public QObject {
  Q_OBJECT

 private:
  void round(std::uint32_t seed, int seconds, HangWatch& watch) {
    const BuiltInKinds kinds(builtInKinds());
    QThreadPool workers;
    workers.setMaxThreadCount(kJobThreads);
    useWindow(workers, kinds.set, seed, seconds, watch);
    if (QTest::currentTestFailed()) return;
    // The window has cancelled its remaining work.
    QVERIFY2(workers.waitForDone(1000 * kLongestSilence / 2), "a cancelled job goes on");
    watch.alive();
  }

  void useWindow(QThreadPool& workers, const KindSet& kinds, std::uint32_t seed, int seconds, HangWatch& watch) {
    MainWindow window(workers, kinds);
    window.resize(900, 620);  // little is to be drawn, so that there is time for more actions
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    RandomUser user(window, kinds.documents, seed);
    const QDeadlineTimer end(1000LL * seconds);
    while (!end.hasExpired() && user.problems().isEmpty()) {
      user.act();
      watch.alive();
    }
    user.undoEverything([&watch] { watch.alive(); });
    watch.alive();
    QVERIFY2(user.problems().isEmpty(),
             qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(user.problems().join("; "))));
  }

 private slots:
  void neitherCrashesNorHangsNorLosesDocuments() {
    HangWatch watch;
    const QDeadlineTimer end(1000LL * number("HANDWHEEL_RANDOM_SECONDS", kUsualSeconds));
    for (auto seed = static_cast<std::uint32_t>(number("HANDWHEEL_RANDOM_SEED", 1)); !end.hasExpired(); ++seed) {
      std::printf("seed %u\n", seed);
      std::fflush(stdout);
      round(seed, std::min<int>(kRoundSeconds, static_cast<int>(end.remainingTime() / 1000) + 1), watch);
      if (QTest::currentTestFailed()) return;
    }
  }
};

HANDWHEEL_TEST_RUN(RandomUseTest, [](int argc, char** argv) {
  const QTemporaryDir home;  // pictures and recent files of this run alone
  for (const char* name : {"HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"})
    qputenv(name, QFile::encodeName(home.path()));
  QDir::setCurrent(home.path());
  return runWindowTest<RandomUseTest>(argc, argv);
})
#include "RandomUseTest.moc"
