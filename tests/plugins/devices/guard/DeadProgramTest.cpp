// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "TestClass.h"
#include "polhem/PolhemEmulator.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>
#include <QProcess>
#include <QtTest>
#include <atomic>
#include <cmath>
#include <thread>

using namespace handwheel;

namespace {

// The board of a Polhem at the other end of a pseudo-terminal.
class Board {
 public:
  Board() : m_master(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
    ::grantpt(m_master);
    ::unlockpt(m_master);
    m_thread = std::thread([this] { run(); });
  }
  ~Board() {
    m_stop = true;
    m_thread.join();
    ::close(m_master);
  }
  QString port() const { return ::ptsname(m_master); }
  double force() const { return m_force; }  // N, present force of the motors
  int lines() const { return m_lines; }
  double zeroSince() const { return m_zeroSince; }  // s, by the steady clock

 private:
  void run() {
    std::uint8_t bytes[256];
    while (!m_stop) {
      const ssize_t count = ::read(m_master, bytes, sizeof(bytes));
      if (count > 0) {
        m_emulator.receive(std::span(bytes, static_cast<std::size_t>(count)));
        ++m_lines;
      }
      if (m_emulator.force) hold(m_emulator.force->norm());
      const std::string out(m_emulator.toHost.begin(), m_emulator.toHost.end());
      m_emulator.toHost.clear();
      if (!out.empty() && ::write(m_master, out.data(), out.size()) < 0) return;
      if (count <= 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
  }

  void hold(double force) {
    if (force == 0.0 && m_force != 0.0) m_zeroSince = SteadyClock().now();
    m_force = force;
  }

  int m_master;
  PolhemEmulator m_emulator;
  std::atomic<double> m_force{0.0};
  std::atomic<int> m_lines{0};
  std::atomic<double> m_zeroSince{0.0};
  std::atomic<bool> m_stop{false};
  std::thread m_thread;
};

}  // namespace

// A program dies or hangs while its device pushes: another process stops the motors.
class DeadProgramTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<Board> m_board;
  std::unique_ptr<QProcess> m_program;

  bool isPushing() { return std::abs(m_board->force() - 1.0) < 1e-9; }

  // The time that the motors went on is printed, not judged: the machine may be busy.
  void end(int number, const char* what) {
    const double begun = SteadyClock().now();
    ::kill(static_cast<pid_t>(m_program->processId()), number);
    QTRY_COMPARE_WITH_TIMEOUT(m_board->force(), 0.0, 20000);
    qInfo("%s: zero force after %.1f ms", what, 1e3 * (m_board->zeroSince() - begun));
  }

 private slots:
  void initTestCase() { qputenv("HANDWHEEL_GUARDS", test::buildPath(GUARDS).toUtf8()); }

  void init() {
    m_board = std::make_unique<Board>();
    qputenv("HANDWHEEL_POLHEM_PORT", m_board->port().toLocal8Bit());
    m_program = std::make_unique<QProcess>();
    m_program->setProcessChannelMode(QProcess::ForwardedChannels);
    m_program->start(test::buildPath("tests/DeviceHolder"), {m_board->port()});
    QVERIFY(m_program->waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(isPushing(), 20000);
  }

  void cleanup() {
    m_program->kill();
    m_program->waitForFinished();
    m_program.reset();
    m_board.reset();
  }

  void killedItsMotorsStop() {
    end(SIGKILL, "killed");
    QTRY_COMPARE(m_program->state(), QProcess::NotRunning);
    QCOMPARE(m_board->force(), 0.0);
  }

  // The program resumes, and still requests its force: the hand has moved.
  void hangingItsMotorsStopAndStayThatWay() {
    end(SIGSTOP, "stopped");
    const int before = m_board->lines();
    ::kill(static_cast<pid_t>(m_program->processId()), SIGCONT);
    QTRY_VERIFY(m_board->lines() > before + 100);
    QCOMPARE(m_board->force(), 0.0);
  }
};

HANDWHEEL_TEST(DeadProgramTest)
#include "DeadProgramTest.moc"
