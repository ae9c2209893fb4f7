// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/SessionDevicePanel.h"

#include "OwnSettings.h"
#include "TestClass.h"
#include "panels/device/ForcePlot.h"
#include "window/WindowServices.h"
#include "window/haptics/HapticSession.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QThreadPool>
#include <QtTest>

using namespace handwheel;

namespace {

// A session with the devices that every machine has, and its panel.
struct SessionDevicePanelFixture {
  QThreadPool pool;
  JobRunner jobs{JobRunner::Policy::Queue, pool};
  WindowServices services;
  MonotonicClock clock;
  std::unique_ptr<HapticSession> session =
      std::make_unique<HapticSession>(HapticSession::Parts{jobs, pool, services, clock});
  std::unique_ptr<SessionDevicePanel> dock = std::make_unique<SessionDevicePanel>(*session);

  ~SessionDevicePanelFixture() {
    dock.reset();
    session.reset();
    pool.waitForDone();
  }
  template <class Part>
  Part* part(const char* name) {
    return dock->findChild<Part*>(name);
  }
  QString headline() { return part<QLabel>("deviceHeadline")->text(); }
  // Chooses a device like the user: by its name in the list.
  void choose(const QString& name) {
    auto* list = part<QComboBox>("deviceChoice");
    list->setCurrentIndex(list->findText(name));
    emit list->activated(list->currentIndex());
  }
  bool waitForTick() {
    return QTest::qWaitFor([this] { return session->latest() != nullptr; }, 20000);
  }
};

}  // namespace

class SessionDevicePanelTest : public QObject {
  Q_OBJECT

 private:
  test::OwnSettings m_settings;

 private slots:
  void initTestCase() { m_settings.use(); }
  void init() { QSettings().clear(); }

  void aDeviceIsChosenSeenAndLeft() {
    SessionDevicePanelFixture fixture;
    fixture.dock->show();
    fixture.choose("Simulated hand");
    QCOMPARE(fixture.session->chosen().driver, std::string("simulated"));
    QCOMPARE(fixture.headline(), QString("Starting…"));
    QVERIFY(fixture.waitForTick());
    QTRY_COMPARE(fixture.headline(), QString("Ready"));
    QTRY_VERIFY(fixture.part<ForcePlot>("forcePlot")->trace().size() > 3);
    QTRY_VERIFY(fixture.part<QLabel>("servoRate")->text().contains("ticks a second"));
    fixture.choose("No device");
    QVERIFY(!fixture.session->isOpen());
    QCOMPARE(fixture.headline(), QString("No device in use"));
    QCOMPARE(fixture.part<ForcePlot>("forcePlot")->trace().size(), std::size_t(0));
  }

  void whatTheUserChangesReachesTheSession() {
    SessionDevicePanelFixture fixture;
    fixture.dock->show();
    fixture.choose("Simulated hand");
    QVERIFY(fixture.waitForTick());
    auto* force = fixture.part<QCheckBox>("forceOn");
    QVERIFY(force->isChecked());
    force->click();
    QVERIFY(!fixture.session->isForceOn());
    fixture.session->setForceOn(true);  // from elsewhere
    QVERIFY(force->isChecked());
    auto* right = fixture.part<QWidget>("property/right")->findChild<QComboBox*>("propertyChoice");
    QCOMPARE(right->currentIndex(), 0);
    emit right->activated(3);  // Y, inverted
    QCOMPARE(fixture.session->mapping().axes[0].axis, 1);
    QVERIFY(fixture.session->mapping().axes[0].isInverted);
    QCOMPARE(right->currentIndex(), 3);
    WorkspaceMapping mapping = fixture.session->mapping();
    mapping.axes[0] = {1, false};
    fixture.session->setMapping(mapping);  // from elsewhere
    QCOMPARE(right->currentIndex(), 2);
  }

  void theMouseWaitsForThePointer() {
    SessionDevicePanelFixture fixture;
    fixture.dock->show();
    fixture.choose("Mouse as device");
    QVERIFY(fixture.waitForTick());
    QTRY_COMPARE(fixture.headline(), QString("The pointer is outside the view"));
    QVERIFY(fixture.part<QLabel>("deviceDetail")->text().contains("without this"));
  }

  // Nothing is shown to nobody, though the loop goes on.
  void hiddenItAsksForNothing() {
    SessionDevicePanelFixture fixture;
    fixture.session->choose("simulated", "hand");
    QVERIFY(fixture.waitForTick());
    QSignalSpy sampled(fixture.session.get(), &HapticSession::sampled);
    QTRY_VERIFY(sampled.size() > 3);
    QCOMPARE(fixture.part<ForcePlot>("forcePlot")->trace().size(), std::size_t(0));
    fixture.dock->show();
    QTRY_VERIFY(fixture.part<ForcePlot>("forcePlot")->trace().size() > 3);
    fixture.dock->hide();
    sampled.clear();
    QTRY_VERIFY(sampled.size() > 3);
    QCOMPARE(fixture.part<ForcePlot>("forcePlot")->trace().size(), std::size_t(0));
  }
};

HANDWHEEL_WIDGET_TEST(SessionDevicePanelTest)
#include "SessionDevicePanelTest.moc"
