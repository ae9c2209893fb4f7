// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "TestClass.h"
#include "haptics/device/DeviceErrors.h"
#include "polhem/Driver.h"
#include "polhem/PolhemEmulator.h"

#include <fcntl.h>
#include <rapidcheck.h>
#include <stdlib.h>
#include <unistd.h>
#include <QTemporaryDir>
#include <QtTest>
#include <atomic>
#include <cmath>
#include <thread>

using namespace handwheel;
using polhem::parseLine;

namespace {

std::span<const std::uint8_t> polhemSessionBytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string forceText(const Vec3& force) {
  const polhem::Line line = polhem::forceLine(force);
  return {line.begin(), line.end()};
}

}  // namespace

class PolhemSessionTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<PolhemEmulator> m_peer;
  std::shared_ptr<FakeClock> m_clock;
  std::unique_ptr<polhem::Session> m_session;

 private slots:
  void init() {
    m_peer = std::make_shared<PolhemEmulator>();
    m_clock = std::make_shared<FakeClock>();
    m_session = std::make_unique<polhem::Session>(
        [this]() -> Result<std::unique_ptr<ByteStream>> {
          return std::unique_ptr<ByteStream>(std::make_unique<FakeStream>(m_peer, m_clock));
        },
        m_clock);
  }

  // Byte by byte after uhaptikfabriken.h 0.2: "%hd %hd %hd %hd %hd %hd %hd" in mN with command 2, then blanks up to
  // byte 62, and a line feed as byte 63.
  void forcesAsTheDeviceReadsThem() {
    const std::string line = forceText(Vec3(1.5, -0.25, 0.0));
    QCOMPARE(line, std::string("1500 -250 0 2 0 0 0                                            \n"));
    QCOMPARE(line.size(), std::size_t(64));
    QVERIFY(forceText(Vec3(1e9, -1e9, std::nan(""))).starts_with("32767 -32767 0 2 0 0 0 "));
  }

  // "% 8.3f % 8.3f % 8.3f % 7.4f % 7.4f % 7.4f % 7.4f %hd\n", then blanks up to byte 62, and a line feed as byte 63.
  void aLineAsTheDeviceWritesIt() {
    const std::string line(" -59.276   13.383 -148.002  0.0919 -1.8483  1.0370 -1.9512 0\n  \n");
    QCOMPARE(line.size(), std::size_t(64));
    polhem::LineReader reader;
    QCOMPARE(reader.take(polhemSessionBytesOf(line)), 1);
    QCOMPARE(reader.reading().position, Vec3(-59.276, 13.383, -148.002));
    QCOMPARE(reader.reading().angles[0], 0.0919);
    QCOMPARE(reader.take(polhemSessionBytesOf(line)), 1);  // the blanks between are none
    QCOMPARE(PolhemEmulator().line(), line);
  }

  // A line quoted by the manufacturer's own header.
  void aLineAsDocumented() {
    const auto reading = parseLine(" -59.276   13.383 -148.002   0.0919 -1.8483  1.0370 -1.9512 0");
    QVERIFY(reading.has_value());
    QCOMPARE(reading->position, Vec3(-59.276, 13.383, -148.002));
    QCOMPARE(reading->angles[3], -1.9512);
  }

  void orientationIsTheChainOfItsJoints() {
    polhem::Reading reading;
    reading.angles = {0.3, 0.0, 0.0, 0.0};
    QVERIFY(reading.orientation().isApprox(Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vec3::UnitZ())), 1e-12));
    reading.angles = {0.0, 0.3, 0.0, 0.3};  // about y there and back
    QVERIFY(reading.orientation().isApprox(Eigen::Quaterniond::Identity(), 1e-12));
    reading.angles = {M_PI_2, 0.0, M_PI_2, 0.0};  // first about x, seen from the pen, then about z
    QVERIFY((reading.orientation() * Vec3::UnitY() - Vec3::UnitZ()).norm() < 1e-12);
    QVERIFY((reading.orientation() * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-12);
  }

  // For any number of lost bytes at any position: no false reading, and the next line is read.
  void aLineThatLostBytesIsPassedOver() {
    PolhemEmulator whole, after;
    after.position[0] = 77.0;
    const std::string line = whole.line();
    const std::size_t content = line.find('\n') + 1;
    for (std::size_t from = 0; from < content; ++from) {
      for (std::size_t lost = 1; from + lost <= content; ++lost) {
        polhem::LineReader reader;
        std::string broken = line;
        (void)reader.take(polhemSessionBytesOf(broken.erase(from, lost)));
        const double x = reader.reading().position.x();
        QVERIFY(x == 0.0 || (x == -59.276 && from == content - 1));  // unless only its end was lost
        QCOMPARE(reader.take(polhemSessionBytesOf(after.line())), 1);
        QCOMPARE(reader.reading().position.x(), 77.0);
      }
    }
  }

  void anyBytesInAnyPieces() {
    const bool ok = rc::check([this](std::vector<std::uint8_t> noise) {
      polhem::LineReader reader;
      (void)reader.take(noise);
      RC_ASSERT(reader.reading().position.allFinite());
      (void)reader.take(polhemSessionBytesOf("\n"));
      const std::string line = m_peer->line();
      int readings = 0;
      for (std::size_t at = 0; at < line.size();) {
        const auto length = static_cast<std::size_t>(*rc::gen::inRange(1, 64));
        readings += reader.take(polhemSessionBytesOf(line.substr(at, length)));
        at += length;
      }
      RC_ASSERT(readings == 1);
      RC_ASSERT(reader.reading().position == Vec3(-59.276, 13.383, -148.002));
    });
    QVERIFY(ok);
    for (const char* text : {"", "1 2 3 4 5 6 7", "   1.000    2.000    3.000   4.0000  5.0000  6.0000  7.0000 inf",
                             "9e99.000    2.000    3.000   4.0000  5.0000  6.0000  7.0000 0",
                             "   1.000    2.000    3.000   4.0000  5.0000  6.0000  7.0000 0 0"}) {
      QVERIFY2(!parseLine(text), text);
    }
  }

  void readsAndPushesInOurFrame() {
    m_peer->booting = 5;  // opening the line has reset the board
    QVERIFY(m_session->open({}).hasValue());
    const DeviceState state = m_session->exchange({Vec3(1, 2, 3), Vec3::Zero(), 0.0});
    QCOMPARE(state.status, DeviceStatus::Ready);
    QVERIFY((state.position - Vec3(13.383, -148.002, -59.276)).norm() < 1e-9);
    QVERIFY((*m_peer->force - Vec3(3, 1, 2)).norm() < 1e-12);
    m_session->close();
    QVERIFY(m_peer->force->isZero(0.0));
  }

  void aBoardThatNeverAnswers() {
    m_peer->stalled = true;
    QCOMPARE(m_session->open({}).error().code, DeviceError::NotResponding);
    JobState job;
    job.cancelled = true;
    QCOMPARE(m_session->open(Progress(job)).error().code, ErrorCode::Cancelled);
    m_peer->gone = true;
    QCOMPARE(m_session->open({}).error().code, DeviceError::Unreachable);
  }

  void aLateAnswerIsNotTakenForTheNext() {
    QVERIFY(m_session->open({}).hasValue());
    m_peer->lateOnce = true;
    m_session->exchange({});
    QVERIFY(!m_peer->late.empty());
    m_peer->toHost.assign(m_peer->late.begin(), m_peer->late.end());  // the late answer arrives
    m_peer->position[1] = 42.0;
    QCOMPARE(m_session->exchange({}).position.x(), 42.0);
  }

  void aStallFailsAndComesBack() {
    QVERIFY(m_session->open({}).hasValue());
    m_peer->loses = 3;  // every line is cut short, which counts as none
    const double start = m_clock->now();
    while (m_clock->now() < start + 0.2) m_session->exchange({});
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Failed);
    m_peer->loses = 0;
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Ready);
  }

  void throughARealTerminal() {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    QVERIFY(master >= 0 && ::grantpt(master) == 0 && ::unlockpt(master) == 0);
    std::atomic<bool> stop{false};
    std::thread board([&, peer = m_peer] {
      char bytes[256];
      while (!stop) {
        const ssize_t count = ::read(master, bytes, sizeof(bytes));
        if (count > 0) peer->receive(polhemSessionBytesOf({bytes, static_cast<std::size_t>(count)}));
        const std::string out(peer->toHost.begin(), peer->toHost.end());
        peer->toHost.clear();
        if (!out.empty() && ::write(master, out.data(), out.size()) < 0) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
    qputenv("HANDWHEEL_POLHEM_PORT", ::ptsname(master));
    qputenv("HANDWHEEL_GUARDS", test::buildPath(GUARDS).toUtf8());
    polhem::Driver driver("/nowhere");
    const std::unique_ptr<Device> device = driver.make(::ptsname(master));
    const bool opened = device && device->open({}).hasValue();
    const bool ready = opened && QTest::qWaitFor([&] { return device->read().status == DeviceStatus::Ready; });
    const Vec3 position = ready ? device->read().position : Vec3::Zero();
    stop = true;
    board.join();
    ::close(master);
    QVERIFY(ready);
    QVERIFY((position - Vec3(13.383, -148.002, -59.276)).norm() < 1e-9);
    QTRY_COMPARE(device->read().status, DeviceStatus::Absent);
    qunsetenv("HANDWHEEL_POLHEM_PORT");
  }

  void onlyBoardsOfItsKindAreListed() {
    const QTemporaryDir folder;
    const auto board = [&](const QString& name, const QByteArray& vendor, const QByteArray& product) {
      const QString device = "usb/" + name;
      QDir(folder.path()).mkpath(device + "/1.0");
      QDir(folder.path()).mkpath("tty/" + name);
      QFile::link(folder.filePath(device + "/1.0"), folder.filePath("tty/" + name + "/device"));
      for (const auto& [file, text] :
           {std::pair(QString("idVendor"), vendor), std::pair(QString("idProduct"), product)}) {
        QFile out(folder.filePath(device + "/" + file));
        if (!out.open(QIODevice::WriteOnly)) qFatal("cannot write");
        out.write(text + "\n");
      }
    };
    board("ttyACM1", "16c0", "0483");
    board("ttyACM0", "2341", "0043");  // an Arduino
    board("ttyUSB0", "16c0", "0483");
    polhem::Driver driver(folder.filePath("tty").toStdString(), "/dev");
    const auto found = driver.find();
    QCOMPARE(found.size(), std::size_t(1));
    QCOMPARE(found[0].address, std::string("/dev/ttyACM1"));
    QVERIFY(driver.make("/dev/ttyACM0") == nullptr);
  }
};

HANDWHEEL_TEST(PolhemSessionTest)
#include "PolhemSessionTest.moc"
