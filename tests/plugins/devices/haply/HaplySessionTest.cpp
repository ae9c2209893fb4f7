// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haply/Driver.h"
#include "haply/Handshake.h"
#include "haply/HaplyEmulator.h"
#include "haptics/device/DeviceErrors.h"
#include "io/FileStream.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>
#include <QtTest>
#include <atomic>
#include <thread>

using namespace handwheel;

namespace {

// The emulated service on a real socket of this machine: one connection.
class LoopbackServer {
 public:
  LoopbackServer() : m_listener(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    if (::bind(m_listener, any, size) != 0 || ::listen(m_listener, 1) != 0 ||
        ::getsockname(m_listener, any, &size) != 0) {
      qFatal("cannot listen");
    }
    m_port = ntohs(address.sin_port);
    m_thread = std::thread([this] { serve(); });
  }

  ~LoopbackServer() {
    m_stop = true;
    ::shutdown(m_listener, SHUT_RDWR);
    m_thread.join();
    ::close(m_listener);
  }

  std::uint16_t port() const { return m_port; }
  void stop() { m_stop = true; }
  HaplyEmulator service;

 private:
  void serve() {
    const int client = ::accept(m_listener, nullptr, nullptr);
    if (client < 0) return;
    FileStream stream(client);
    std::array<std::uint8_t, 1024> bytes{};
    while (!m_stop) {
      const std::ptrdiff_t count = stream.read(bytes, 0.01);
      if (count == kGone) return;
      const std::lock_guard lock(service.mutex);
      service.receive(std::span(bytes).first(static_cast<std::size_t>(count)));
      const std::vector<std::uint8_t> out(service.toHost.begin(), service.toHost.end());
      service.toHost.clear();
      if (!stream.write(out)) return;
    }
  }

  int m_listener;
  std::uint16_t m_port = 0;
  std::atomic<bool> m_stop{false};
  std::thread m_thread;
};

}  // namespace

class HaplySessionTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<HaplyEmulator> m_service;
  std::shared_ptr<FakeClock> m_clock;
  std::unique_ptr<haply::Session> m_session;

 private slots:
  void init() {
    m_service = std::make_shared<HaplyEmulator>();
    m_clock = std::make_shared<FakeClock>();
    const auto connect = [this]() -> Result<std::unique_ptr<ByteStream>> {
      return std::unique_ptr<ByteStream>(std::make_unique<FakeStream>(m_service, m_clock));
    };
    m_session = std::make_unique<haply::Session>(connect, m_clock);
  }

  // x right, y away, z up and metres there; x right, y up, z towards the user and millimetres here.
  void readsPoseAndGrip() {
    QVERIFY(m_session->open({}).hasValue());
    QCOMPARE(m_session->capabilities().inputs, 6);
    m_session->exchange({});
    QCOMPARE(m_service->preset, std::string("arm_front_centered"));
    const DeviceState state = m_session->exchange({});
    QCOMPARE(state.status, DeviceStatus::Ready);
    QVERIFY((state.position - Vec3(10, 30, 20)).norm() < 1e-9);
    QVERIFY(!state.hasVelocity);
    QCOMPARE(state.buttons, 1u);
    // Half a turn about its z is one about our y.
    QVERIFY((state.orientation * Vec3::UnitX() + Vec3::UnitX()).norm() < 1e-12);
    QVERIFY((state.orientation * Vec3::UnitY() - Vec3::UnitY()).norm() < 1e-12);
  }

  void pushesInItsFrame() {
    QVERIFY(m_session->open({}).hasValue());
    m_session->exchange({});
    m_session->exchange({Vec3(1, 2, 3), Vec3::Zero(), 0.0});
    QVERIFY((*m_service->force - Vec3(1, -3, 2)).norm() < 1e-12);
    m_session->close();
    QVERIFY(m_service->force->isZero(0.0));
    QVERIFY(m_service->saidGoodbye);
  }

  void oneMessageForEachFrame() {
    QVERIFY(m_session->open({}).hasValue());
    const int before = m_service->messages;
    for (int i = 0; i < 100; ++i) m_session->exchange({});
    QVERIFY(m_service->messages - before >= 99 && m_service->messages - before <= 100);
    QVERIFY(m_service->toHost.empty());
  }

  void piecesAndPingsAndFragments() {
    m_service->fragment = 30;
    m_service->longestRead = 7;
    m_service->pings = true;
    QVERIFY(m_session->open({}).hasValue());
    m_session->exchange({});
    for (int i = 0; i < 20; ++i) QVERIFY((m_session->exchange({}).position - Vec3(10, 30, 20)).norm() < 1e-9);
    QVERIFY(m_service->pongs > 20);
  }

  void uncalibratedItNeedsTheUser() {
    m_service->calibrated = false;
    QVERIFY(m_session->open({}).hasValue());
    m_session->exchange({});
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::NeedsHoming);
  }

  void aStallFailsAndComesBack() {
    QVERIFY(m_session->open({}).hasValue());
    m_session->exchange({});
    m_service->stalled = true;
    const int before = m_service->messages;
    const double start = m_clock->now();
    m_session->exchange({});
    m_session->exchange({});
    QCOMPARE(m_service->messages - before, 1);  // it waits for the outstanding answer
    while (m_clock->now() < start + 0.3) m_session->exchange({});
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Failed);
    m_service->stalled = false;
    m_session->exchange({});
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Ready);
  }

  void nobodyThereOrNothingPluggedIn() {
    m_service->replyInstead = R"({"session_id":1,"inverse3":[]})";
    QCOMPARE(m_session->open({}).error().code, DeviceError::NotResponding);
    m_service->gone = true;
    QCOMPARE(m_session->open({}).error().code, DeviceError::NotResponding);
  }

  // RFC 6455, section 4.1: each connection has a key of its own, and only a server that answers that key is accepted.
  void shakesHandsAsTheStandardWants() {
    QCOMPARE(haply::acceptFor("dGhlIHNhbXBsZSBub25jZQ=="), std::string("s3pPLMBiTxaQ9kYGzzhZRbK+xOo="));  // section 1.3
    QVERIFY(m_session->open({}).hasValue());
    const std::string first = m_service->key;
    init();
    m_service->consent = "HTTP/1.1 101 OK\r\nupgrade: WebSocket\r\nCONNECTION: keep-alive, upgrade\r\n";
    QVERIFY(m_session->open({}).hasValue());
    QVERIFY(!first.empty() && m_service->key != first);
    init();
    m_service->answersTheKey = false;
    QCOMPARE(m_session->open({}).error().code, DeviceError::NotResponding);
    for (const char* wrong : {"HTTP/1.1 200 OK\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n",
                              "HTTP/1.1 101 OK\r\nConnection: Upgrade\r\n", "HTTP/1.1 101 OK\r\nUpgrade: websocket\r\n",
                              "HTTP/1.1 101 OK\r\nUpgrade: h2c\r\nConnection: Upgrade\r\n"}) {
      init();
      m_service->consent = wrong;
      QCOMPARE(m_session->open({}).error().code, DeviceError::NotResponding);
    }
  }

  // Every known version has slightly different names; nonsense gives nothing.
  void framesOfAllVersions() {
    const auto read = [](const char* text) { return haply::readFrame(text); };
    const auto old =
        read(R"({"inverse3":[{"device_id":"1","position":{"x":0,"y":0,"z":1},"velocity":{"x":0,"y":1,"z":0}}]})");
    QVERIFY(old && old->position && old->velocity);
    QVERIFY((*old->position - Vec3(0, 1000, 0)).norm() < 1e-9);
    QVERIFY((*old->velocity - Vec3(0, 0, -1000)).norm() < 1e-9);
    const auto grip =
        read(R"({"inverse3":[{"device_id":"1"}],"wireless_verse_grip":[{"state":{"buttons":{"b":true,"c":1}}}]})");
    QCOMPARE(grip->buttons, 6u);
    QVERIFY(!grip->position && !grip->orientation);
    for (const char* text : {"", "{", "[]", "null", R"({"inverse3":{}})", R"({"inverse3":[{}]})", R"({"inverse3":[7]})",
                             R"({"inverse3":[{"device_id":""}]})", R"({"inverse3":[{"device_id":7}]})"}) {
      QVERIFY2(!read(text), text);
    }
    for (const char* text : {R"({"x":1e308,"y":0,"z":0})", R"({"x":1e999,"y":0,"z":0})", R"({"x":0,"y":0})",
                             R"({"x":"1","y":0,"z":0})", R"([0,0,0])", R"({"x":11,"y":0,"z":0})"}) {
      const std::string whole =
          R"({"inverse3":[{"device_id":"1","state":{"cursor_position":)" + std::string(text) + "}}]}";
      const auto frame = haply::readFrame(whole);
      QVERIFY2(!frame || !frame->position, text);
    }
  }

  void throughARealSocket() {
    LoopbackServer server;
    haply::Driver driver;
    qputenv("HANDWHEEL_HAPLY_PORT", QByteArray::number(server.port()));
    QCOMPARE(driver.find().size(), std::size_t(1));
    const std::unique_ptr<Device> device = driver.make(driver.find()[0].address);
    QVERIFY(device != nullptr && driver.make("elsewhere:1") == nullptr);
    QVERIFY(device->open({}).hasValue());
    QTRY_COMPARE(device->read().status, DeviceStatus::Ready);
    QVERIFY((device->read().position - Vec3(10, 30, 20)).norm() < 1e-9);
    server.stop();
    QTRY_COMPARE(device->read().status, DeviceStatus::Absent);
    qunsetenv("HANDWHEEL_HAPLY_PORT");
  }

  void theKernelsTableOfSockets() {
    const char* const table =
        "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid\n"
        "   0: 0100007F:2711 00000000:0000 0A 00000000:00000000 00:00000000 00000000     0\n"
        "   1: 0100007F:1F90 0100007F:2712 01 00000000:00000000 00:00000000 00000000     0\n";
    QVERIFY(haply::listens(table, 10001));
    QVERIFY(!haply::listens(table, 8080));   // connected, not listening
    QVERIFY(!haply::listens(table, 10002));  // somebody else's
    QVERIFY(!haply::listens("", 10001));
  }
};

HANDWHEEL_TEST(HaplySessionTest)
#include "HaplySessionTest.moc"
