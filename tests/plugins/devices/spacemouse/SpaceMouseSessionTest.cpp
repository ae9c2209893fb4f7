// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/SpaceMouseEmulator.h"

#include "TestClass.h"
#include "haptics/device/DeviceErrors.h"
#include "spacemouse/Driver.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <QTemporaryDir>
#include <QtTest>
#include <thread>

using namespace handwheel;
using namespace handwheel::spacemouse;

namespace {

// A daemon that only listens, at a path.
class Listener {
 public:
  explicit Listener(const std::string& path) : m_socket(::socket(AF_UNIX, SOCK_STREAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof(address.sun_path) - 1);
    if (::bind(m_socket, reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0 || ::listen(m_socket, 8) != 0) {
      qFatal("cannot listen");
    }
  }
  ~Listener() { ::close(m_socket); }
  int accept() const { return ::accept(m_socket, nullptr, nullptr); }

 private:
  int m_socket;
};

}  // namespace

class SpaceMouseSessionTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<SpaceMouseEmulator> m_mouse;
  std::shared_ptr<FakeClock> m_clock;
  std::unique_ptr<HidSession> m_session;

  static Hid oneHid() {
    return {[] {
              return std::vector<Hid::Entry>{{"/dev/hidraw7", "SpaceMouse Compact", 2}};
            },
            [](const std::string& path) -> Result<std::unique_ptr<HidTransport>> {
              return Error{DeviceError::Unreachable, {"test"}, {}, path};
            }};
  }

 private slots:
  void init() {
    m_mouse = std::make_shared<SpaceMouseEmulator>();
    m_clock = std::make_shared<FakeClock>();
    m_session = hidSession(m_mouse, m_clock);
    QVERIFY(m_session->open({}).hasValue());
  }

  void theLampIsOnWhileItIsOpen() {
    QVERIFY(m_mouse->lamp);
    m_session->close();
    QVERIFY(!m_mouse->lamp);
  }

  void allWaitingReportsMakeOneReading() {
    m_mouse->reports = {{1, 94, 1, 0, 0, 0, 0}, {2, 0, 0, 0, 0, 0, 0}, {3, 2, 0}, {1, 175, 0, 0, 0, 0, 0}};
    const DeviceState state = m_session->exchange({});
    QCOMPARE(state.status, DeviceStatus::Ready);
    QVERIFY((state.position - Vec3(0.5 * kTravel, 0, 0)).norm() < 1e-12);
    QCOMPARE(state.buttons, 2u);
  }

  // A gap in the reports is no release; a second without any is, by the clock and not by the number of readings.
  void restIsAMatterOfTime() {
    m_mouse->reports = {{1, 94, 1, 0, 0, 0, 0}};
    m_session->exchange({});
    const double start = m_clock->now();
    while (m_clock->now() < start + 0.95 * kHeld) QVERIFY(m_session->exchange({}).position.x() == kTravel);
    while (m_clock->now() < start + 1.05 * kHeld) m_session->exchange({});
    QVERIFY(m_session->exchange({}).position.isZero(0.0));
    m_mouse->reports = {{1, 94, 1, 0, 0, 0, 0}};
    QVERIFY(m_session->exchange({}).position.x() == kTravel);
  }

  void unpluggedWhilePushedItIsAtRest() {
    m_mouse->reports = {{1, 94, 1, 0, 0, 0, 0}};
    m_session->exchange({});
    m_mouse->gone = true;
    const DeviceState state = m_session->exchange({});
    QCOMPARE(state.status, DeviceStatus::Absent);
    QVERIFY(state.position.isZero(0.0));
  }

  // The daemon's z is away from the user, and its records may come in any pieces.
  void recordsOfTheDaemon() {
    const std::array<std::int32_t, 8> motion = {0, 35, 70, 105, 350, 0, 0, 16};
    const std::array<std::int32_t, 8> press = {1, 1, 1, 0, 0, 0, 0, 0};
    for (const std::size_t piece : {1u, 7u, 32u, 64u}) {
      auto peer = std::make_shared<SpaceNavEmulator>();
      peer->longestRead = piece;
      peer->send(motion);
      peer->send(press);
      SocketSession session([&]() -> Result<std::unique_ptr<ByteStream>> {
        return std::unique_ptr<ByteStream>(std::make_unique<FakeStream>(peer, m_clock));
      });
      QVERIFY(session.open({}).hasValue());
      DeviceState state;
      while (!peer->toHost.empty()) state = session.exchange({});
      QVERIFY((state.position - kTravel * Vec3(0.1, 0.2, -0.3)).norm() < 1e-12);
      QVERIFY(state.orientation.isApprox(Eigen::Quaterniond(Eigen::AngleAxisd(kFullTilt, Vec3::UnitX())), 1e-12));
      QCOMPARE(state.buttons, 2u);
      peer->send({2, 1, 0, 0, 0, 0, 0, 0});
      peer->send({1, -5, 1, 0, 0, 0, 0, 0});
      peer->send({99, 1, 2, 3, 4, 5, 6, 7});
      while (!peer->toHost.empty()) state = session.exchange({});
      QCOMPARE(state.buttons, 0u);
      for (int i = 0; i < 500; ++i) QVERIFY(session.exchange({}).position == state.position);  // held still
    }
  }

  // The daemon and hidraw show the same device: one of them is listed, never both.
  void neverBoth() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("spnav.sock").toStdString();
    spacemouse::Driver driver(oneHid(), {path});
    QCOMPARE(driver.find().size(), std::size_t(1));
    QCOMPARE(driver.find()[0].address, std::string("/dev/hidraw7"));
    {
      const Listener daemon(path);
      QCOMPARE(driver.find().size(), std::size_t(1));
      QCOMPARE(driver.find()[0].address, path);
      QVERIFY(driver.make("/dev/hidraw7") == nullptr);
      QVERIFY(driver.make(path) != nullptr);
    }
    QCOMPARE(::unlink(path.c_str()), 0);
    QCOMPARE(driver.find()[0].address, std::string("/dev/hidraw7"));
    QVERIFY(driver.make(path) == nullptr);
    QVERIFY(driver.make("/dev/hidraw7") != nullptr);
  }

  void aSocketThatNobodyListensOnIsNoDaemon() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("spnav.sock").toStdString();
    { const Listener gone(path); }
    spacemouse::Driver driver(oneHid(), {path});
    QCOMPARE(driver.find()[0].address, std::string("/dev/hidraw7"));
  }

  void throughARealSocket() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("spnav.sock").toStdString();
    const Listener daemon(path);
    spacemouse::Driver driver(oneHid(), {path});
    const std::unique_ptr<Device> device = driver.make(path);
    QVERIFY(device != nullptr);
    ::close(daemon.accept());  // the check whether somebody listens
    QVERIFY(device->open({}).hasValue());
    const int client = daemon.accept();
    const std::array<std::int32_t, 8> motion = {0, 350, 0, 0, 0, 0, 0, 16};
    QCOMPARE(::write(client, motion.data(), sizeof(motion)), ssize_t(sizeof(motion)));
    QTRY_VERIFY(device->read().position.x() == kTravel);
    ::close(client);
    QTRY_COMPARE(device->read().status, DeviceStatus::Absent);
  }
};

HANDWHEEL_TEST(SpaceMouseSessionTest)
#include "SpaceMouseSessionTest.moc"
