// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "io/ThreadedDevice.h"

#include <QtTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <thread>

using namespace handwheel;

namespace {

// Counts what this thread allocates with new.
thread_local std::size_t allocations = 0;

// A session as slow and as careless with memory as a protocol may be; its requests and readings are in
// ThreadedDeviceBoard.
struct ThreadedDeviceBoard {
  std::atomic<int> exchanges{0};
  std::atomic<double> lastForce{0.0};
  std::atomic<double> largestForce{0.0};
  std::atomic<double> x{1.0};
  std::atomic<bool> gone{false};
  std::atomic<bool> closed{false};
};

class SlowSession final : public handwheel::Session {
 public:
  explicit SlowSession(ThreadedDeviceBoard& board) : m_board(board) {}
  DeviceCapabilities capabilities() const override { return {}; }
  Status open(Progress) override { return Done{}; }

  DeviceState exchange(const DeviceForce& force) noexcept override {
    const std::vector<int> rubbish(1000, 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(rubbish.size() / 500));
    m_board.lastForce = force.force.z();
    m_board.largestForce = std::max(m_board.largestForce.load(), force.force.z());
    ++m_board.exchanges;
    DeviceState state;
    state.status = m_board.gone ? DeviceStatus::Absent : DeviceStatus::Ready;
    state.position = Vec3(m_board.x, 0, 0);
    return state;
  }
  void close() noexcept override { m_board.closed = true; }

 private:
  ThreadedDeviceBoard& m_board;
};

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

class ThreadedDeviceTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<ThreadedDeviceBoard> m_board;
  std::unique_ptr<ThreadedDevice> m_device;

 private slots:
  void init() {
    m_board = std::make_unique<ThreadedDeviceBoard>();
    m_device = std::make_unique<ThreadedDevice>(std::make_unique<SlowSession>(*m_board));
    QVERIFY(m_device->open({}).hasValue());
    QTRY_COMPARE(m_device->read().status, DeviceStatus::Ready);
  }

  void cleanup() { m_device.reset(); }

  // For a slow device, the servo thread goes on: many ticks to one exchange, and not one allocation.
  void theServoThreadNeitherWaitsNorAllocates() {
    const int exchanges = m_board->exchanges;
    const std::size_t before = allocations;
    for (int i = 0; i < 100'000; ++i) {
      m_device->write({Vec3(0, 0, 2), Vec3::Zero(), 0.0});
      if (!m_device->read().position.allFinite()) break;
    }
    const std::size_t allocated = allocations - before;
    QCOMPARE(allocated, std::size_t(0));
    QVERIFY(m_board->exchanges - exchanges < 100'000);
    QTRY_COMPARE(m_board->largestForce, 2.0);
  }

  void aForceEndsWithTheServoLoop() {
    m_device->write({Vec3(0, 0, 2), Vec3::Zero(), 0.0});
    QTRY_COMPARE(m_board->largestForce, 2.0);  // the last one may be over before a busy machine looks
    QTRY_COMPARE(m_board->lastForce, 0.0);
  }

  void aReadingThatIsNoNumberKeepsTheLastPosition() {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      m_board->x = 1.0;
      QTRY_COMPARE(m_device->read().status, DeviceStatus::Ready);
      m_board->x = bad;
      QTRY_COMPARE(m_device->read().status, DeviceStatus::Failed);
      QCOMPARE(m_device->read().position.x(), 1.0);
    }
  }

  void theSessionIsClosedWhereItRuns() {
    m_device->close();
    QVERIFY(m_board->closed);
    const int exchanges = m_board->exchanges;
    m_device->write({Vec3(0, 0, 2), Vec3::Zero(), 0.0});
    QTest::qSleep(20);
    QCOMPARE(m_board->exchanges.load(), exchanges);
  }

  void aDeviceThatIsGoneIsNotAskedAgain() {
    m_board->gone = true;
    QTRY_COMPARE(m_device->read().status, DeviceStatus::Absent);
    QTRY_VERIFY(m_board->closed);
    const int exchanges = m_board->exchanges;
    QTest::qSleep(20);
    QCOMPARE(m_board->exchanges.load(), exchanges);
  }
};

HANDWHEEL_TEST(ThreadedDeviceTest)
#include "ThreadedDeviceTest.moc"
