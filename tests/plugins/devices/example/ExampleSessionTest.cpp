// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "example/ExampleEmulator.h"

#include <QtTest>

using namespace handwheel;

class ExampleSessionTest : public QObject {
  Q_OBJECT

 private:
  std::shared_ptr<ExampleEmulator> m_peer;
  std::unique_ptr<ExampleSession> m_session;

 private slots:
  void init() {
    m_peer = std::make_shared<ExampleEmulator>();
    m_session = std::make_unique<ExampleSession>([this]() -> Result<std::unique_ptr<ByteStream>> {
      return std::unique_ptr<ByteStream>(std::make_unique<FakeStream>(m_peer, std::make_shared<FakeClock>()));
    });
    QVERIFY(m_session->open({}).hasValue());
  }

  void readsWhatTheDeviceSays() {
    const DeviceState state = m_session->exchange({});
    QCOMPARE(state.status, DeviceStatus::Ready);
    QVERIFY((state.position - Vec3(1.0, -2.0, 327.67)).norm() < 1e-12);
  }

  void shortReadsMakeOneAnswer() {
    m_peer->longestRead = 1;
    QVERIFY((m_session->exchange({}).position - Vec3(1.0, -2.0, 327.67)).norm() < 1e-12);
  }

  void sendsMillinewtonsAndNoMoreThanFit() {
    m_session->exchange({Vec3(1.5, -0.25, 1e9), Vec3::Zero(), 0.0});
    QVERIFY(m_peer->force.has_value());
    QVERIFY((*m_peer->force - Vec3(1.5, -0.25, 32.767)).norm() < 1e-12);
  }

  void saysThatItIsGone() {
    m_peer->gone = true;
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Absent);
    QCOMPARE(m_session->exchange({}).status, DeviceStatus::Absent);
    m_session->close();
  }
};

HANDWHEEL_TEST(ExampleSessionTest)
#include "ExampleSessionTest.moc"
