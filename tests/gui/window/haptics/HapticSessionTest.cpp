// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HapticDevices.h"
#include "window/WindowServices.h"
#include "window/haptics/HapticSession.h"

#include <QSettings>
#include <QSignalSpy>
#include <QThreadPool>
#include <QtTest>
#include <atomic>
#include <mutex>
#include "OwnSettings.h"
#include "TestClass.h"
#include "haptics/device/DeviceErrors.h"
#include "haptics/recording/ForceRecorder.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Ten seconds pass in one.
class HurriedClock : public ServoClock {
 public:
  std::int64_t now() noexcept override { return 10 * m_clock.now(); }
  void waitUntil(std::int64_t time) noexcept override { m_clock.waitUntil(time / 10); }

 private:
  MonotonicClock m_clock;
};

class DeafDevice : public ScriptedDevice {
 public:
  using ScriptedDevice::ScriptedDevice;
  Status open(Progress) override { return Error{DeviceError::NotResponding, {"a greeting"}, {}, {}}; }
};

// The devices that the test plugs in.
struct Plugged {
  std::mutex mutex;
  std::vector<DeviceInfo> listings;
  std::shared_ptr<ScriptedDevice::Log> log = std::make_shared<ScriptedDevice::Log>();

  void set(std::vector<DeviceInfo> all) {
    const std::lock_guard lock(mutex);
    listings = std::move(all);
  }
};

class FakeDriver : public DeviceDriver {
 public:
  explicit FakeDriver(Plugged& plugged) : m_plugged(plugged) {}
  std::string id() const override { return "fake"; }
  std::vector<DeviceInfo> find() override {
    const std::lock_guard lock(m_plugged.mutex);
    return m_plugged.listings;
  }
  std::unique_ptr<Device> make(const std::string& address) override {
    if (address == "deaf") return std::make_unique<DeafDevice>(m_plugged.log);
    return address.starts_with("well") ? std::make_unique<ScriptedDevice>(m_plugged.log) : nullptr;
  }

 private:
  Plugged& m_plugged;
};

// A session with all that it needs.
struct HapticSessionFixture {
  Plugged plugged;
  QThreadPool pool;
  JobRunner jobs{JobRunner::Policy::Queue, pool};
  WindowServices services;
  HurriedClock clock;
  std::unique_ptr<HapticSession> session;
  std::vector<Message> messages;

  HapticSessionFixture() {
    std::vector<std::unique_ptr<DeviceDriver>> drivers;
    drivers.push_back(std::make_unique<FakeDriver>(plugged));
    session = std::make_unique<HapticSession>(HapticSession::Parts{jobs, pool, services, clock}, std::move(drivers));
    QObject::connect(session.get(), &HapticSession::message, session.get(),
                     [this](const Message& message) { messages.push_back(message); });
  }
  ~HapticSessionFixture() {
    session.reset();
    pool.waitForDone();
  }
  bool waitForOpen() {
    return QTest::qWaitFor([this] { return session->latest() != nullptr; }, 20000);
  }
};

}  // namespace

class HapticSessionTest : public QObject {
  Q_OBJECT

 private:
  test::OwnSettings m_settings;

 private slots:
  void initTestCase() { m_settings.use(); }
  void init() { QSettings().clear(); }

  void withoutADeviceNothingRuns() {
    HapticSessionFixture fixture;
    QSignalSpy sampled(fixture.session.get(), &HapticSession::sampled);
    fixture.session->takeUp();
    fixture.session->setMapping({});
    fixture.session->setView({}, {});
    fixture.session->startForceTest();
    QTest::qWait(100);
    QVERIFY(!fixture.session->isOpen() && !fixture.session->latest() && !fixture.session->measure());
    QVERIFY(fixture.session->chosen().driver.empty());
    QCOMPARE(fixture.services.haptics().counters().ticks, std::uint64_t(0));
    QVERIFY(!fixture.services.haptics().isRunning());
    QCOMPARE(sampled.count(), 0);
  }

  void theLoopRunsAsLongAsTheDeviceIsOpen() {
    HapticSessionFixture fixture;
    fixture.session->choose("simulated", "hand");
    QVERIFY(fixture.waitForOpen());
    QVERIFY(fixture.session->simulatedHand() && !fixture.session->mouse());
    QVERIFY(fixture.services.haptics().isRunning());
    QCOMPARE(fixture.session->latest()->device.status, DeviceStatus::Ready);
    QTRY_VERIFY(fixture.session->rate() > 0.0);
    fixture.session->close();
    QVERIFY(!fixture.session->isOpen() && !fixture.session->latest());
    QVERIFY(!fixture.services.haptics().isRunning());
    const std::uint64_t ticks = fixture.services.haptics().counters().ticks;
    QSignalSpy sampled(fixture.session.get(), &HapticSession::sampled);
    QTest::qWait(100);
    QCOMPARE(fixture.services.haptics().counters().ticks, ticks);
    QCOMPARE(sampled.count(), 0);
  }

  // The last thing sent is no force, and the device is closed once.
  void closingIsZeroForce() {
    HapticSessionFixture fixture;
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    fixture.session->setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(1.0, 0.0, 0.0); }));
    QTRY_VERIFY(fixture.session->latest()->sent.force.x() > 0.5);
    fixture.session->close();
    QVERIFY(fixture.plugged.log->last.isZero());
    QTRY_VERIFY(fixture.jobs.isIdle());
    QCOMPARE(fixture.plugged.log->closes, 1);
  }

  // The force goes before the loop stops, and comes back; ticks are counted on.
  void anotherRateIsTakenUpWithoutABlow() {
    HapticSessionFixture fixture;
    struct Seen {
      int reads = 0;
      std::vector<double> rests;  // N that went when a loop stopped: a write without a reading
    };
    const auto seen = std::make_shared<Seen>();
    fixture.plugged.log->onWrite = [seen](const ScriptedDevice::Log& log, const DeviceForce&) {
      if (log.reads == seen->reads) seen->rests.push_back(log.last.force.norm());
      seen->reads = log.reads;
    };
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    QCOMPARE(fixture.session->measure()->periods().binSeconds(), 0.001 / 64.0);
    fixture.session->setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(6.0, 0.0, 0.0); }));
    QTRY_VERIFY(fixture.session->latest()->sent.force.x() > 5.5);
    const std::uint64_t tick = fixture.session->latest()->tick;
    ServoSettings servo;
    servo.rate = 2000.0;
    servo.velocityWindow = 0.005;
    fixture.session->setServo(servo);
    fixture.session->setServo(ServoSettings{});  // if there are several, the last counts
    fixture.session->setServo(servo);
    QTRY_COMPARE(fixture.session->measure()->periods().binSeconds(), 0.0005 / 64.0);
    QTRY_VERIFY(fixture.session->latest()->sent.force.x() > 5.5);
    QVERIFY(fixture.session->latest()->tick > tick);
    fixture.session->close();
    QCOMPARE(seen->rests.size(), std::size_t(2));
    QVERIFY(seen->rests[0] <= 0.02);
  }

  void aForceThatIsOffStaysOff() {
    HapticSessionFixture fixture;
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    fixture.session->setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(1.0, 0.0, 0.0); }));
    ServoSettings servo;
    servo.rate = 2000.0;
    fixture.session->setServo(servo);
    fixture.session->setForceOn(false);
    QTRY_COMPARE(fixture.session->measure()->periods().binSeconds(), 0.0005 / 64.0);
    QTest::qWait(300);  // three seconds of the loop
    QVERIFY(fixture.session->latest()->sent.isZero());
  }

  void whatCannotBeOpenedIsReported() {
    for (const char* address : {"deaf", "nowhere"}) {
      HapticSessionFixture fixture;
      fixture.session->choose("fake", address);
      QCOMPARE(fixture.session->chosen().address, std::string(address));
      QTRY_VERIFY(fixture.jobs.isIdle());
      QVERIFY(!fixture.session->isOpen() && fixture.session->chosen().driver.empty());
      QCOMPARE(fixture.messages.size(), std::size_t(1));
      QCOMPARE(fixture.messages[0].weight, Message::Weight::Error);
      QVERIFY(!fixture.messages[0].detail.isEmpty() && !fixture.messages[0].advice.isEmpty());
    }
  }

  // At the start of the program nobody has asked for it.
  void whatIsNotThereAnyMoreIsNoNews() {
    QSettings().setValue("haptics/driver", "fake");
    QSettings().setValue("haptics/address", "nowhere");
    HapticSessionFixture fixture;
    fixture.session->takeUp();
    QTRY_VERIFY(fixture.jobs.isIdle());
    QVERIFY(!fixture.session->isOpen() && fixture.messages.empty());
  }

  void choiceAndMappingAreRemembered() {
    WorkspaceMapping mapping;
    mapping.axes = {DeviceAxis{2, true}, DeviceAxis{0, false}, DeviceAxis{1, true}};
    mapping.scale = 0.25;
    mapping.forceGain = 2.0;
    mapping.deadZone = 1.5;
    mapping.clutchButtons = 5;
    {
      HapticSessionFixture fixture;
      fixture.session->choose("fake", "well");
      QVERIFY(fixture.waitForOpen());
      fixture.session->setMapping(mapping);
    }
    HapticSessionFixture fixture;
    fixture.session->takeUp();
    QVERIFY(fixture.waitForOpen());
    QCOMPARE(fixture.session->chosen().address, std::string("well"));
    const WorkspaceMapping kept = fixture.session->mapping();
    QVERIFY(kept.viewFromDevice() == mapping.viewFromDevice());
    QCOMPARE(kept.scale, 0.25);
    QCOMPARE(kept.forceGain, 2.0);
    QCOMPARE(kept.deadZone, 1.5);
    QCOMPARE(kept.clutchButtons, 5u);
    fixture.session->close();
    fixture.session->takeUp();
    QVERIFY(fixture.session->chosen().driver.empty());  // closed by hand, it stays closed
  }

  // In contact the scale is changed; whoever makes the scene for the new one takes his time. No tick feels the one
  // without the other, and the force comes back by the ramp.
  void anotherScaleIsFeltWithItsScene() {
    HapticSessionFixture fixture;
    std::atomic<double> sent{0.0}, largest{0.0};
    std::atomic<int> ticks{0};
    fixture.plugged.log->onWrite = [&](const ScriptedDevice::Log&, const DeviceForce& force) {
      sent = force.force.norm();
      if (sent > largest) largest = sent.load();
      ++ticks;
    };
    fixture.plugged.log->state.position = {2, 0, 0};
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    const auto publish = [&](bool isDiscontinuous) {
      const double stiffness = fixture.session->mappingInScene().sceneStiffness(0.5);
      fixture.session->setScene(sceneOf(
          [=](const TipState& tip, ForceOut& out) {
            out.stiffness = stiffness;
            out.proxy.setZero();
            out.force = -stiffness * tip.position;
          },
          isDiscontinuous));
    };
    publish(true);
    QTRY_VERIFY(std::abs(sent - 1.0) < 1e-6);
    largest = 0.0;
    QObject::connect(fixture.session.get(), &HapticSession::viewChanged, fixture.session.get(), [&] {
      publish(false);
      QThread::msleep(20);
    });
    WorkspaceMapping mapping = fixture.session->mapping();
    mapping.scale /= 10.0;
    fixture.session->setMapping(mapping);
    const int before = ticks;
    QTRY_VERIFY(ticks > before + 2);
    QVERIFY2(sent < 0.5, "without the ramp");
    QTRY_VERIFY(sent > 0.9);
    QVERIFY2(largest < 1.0 + 1e-6, qPrintable(QString::number(largest)));
    fixture.session->close();
  }

  // The loop takes the last of the mappings that follow closely: the jump is not lost with the one before it.
  void aTipThatIsToJumpJumps() {
    HapticSessionFixture fixture;
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    CameraState camera;
    camera.height = 200.0;
    fixture.session->setView(camera, {});
    for (const double x : {30.0, -40.0, 50.0}) {
      camera.centre.x() = x;  // the old position of the tip is within this view, too
      fixture.session->setView(camera, {});
      fixture.session->recentre();
      fixture.session->setView(camera, {});
      const auto offset = [&] {
        return fixture.session->latest()->tip.position.x() -
               fixture.session->latest()->device.position.x() * fixture.session->mappingInScene().scale;
      };
      QTRY_VERIFY(std::abs(offset() - x) < 1e-6);
    }
  }

  void settingsThatMakeNoSenseAreNotTaken() {
    QSettings().setValue("haptics/simulated/axes", "+0+0+2");
    QSettings().setValue("haptics/simulated/scale", "nan");
    QSettings().setValue("haptics/simulated/force_gain", -1);
    HapticSessionFixture fixture;
    fixture.session->choose("simulated", "hand");
    QVERIFY(fixture.waitForOpen());
    QVERIFY(fixture.session->mapping().viewFromDevice() == Eigen::Matrix3d::Identity());
    QCOMPARE(fixture.session->mapping().scale, 1.0);
    QCOMPARE(fixture.session->mapping().forceGain, 1.0);
  }

  // Nobody looks at the list: the session looks itself until the device is back, at another port.
  void pluggedInAgainItIsOpenedAgain() {
    HapticSessionFixture fixture;
    auto isGone = std::make_shared<std::atomic<bool>>(false);
    fixture.plugged.log->onRead = [isGone](ScriptedDevice::Log& log) {
      const bool isAway = isGone->load() && log.closes == 0;  // the one that comes back is another
      log.state.status = isAway ? DeviceStatus::Absent : DeviceStatus::Ready;
    };
    fixture.plugged.set({{"fake", "well", "Well"}});
    fixture.session->setWatching(true);
    QTRY_COMPARE(fixture.session->found().size(), 4);
    fixture.session->setWatching(false);
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    fixture.plugged.set({});
    isGone->store(true);
    QTRY_COMPARE(fixture.session->status(), DeviceStatus::Absent);
    QTRY_COMPARE(fixture.session->found().size(), 3);
    QCOMPARE(fixture.session->chosen().address, std::string("well"));
    fixture.plugged.set({{"fake", "well/2", "Well"}});
    QTRY_COMPARE_WITH_TIMEOUT(fixture.session->chosen().address, std::string("well/2"), 20000);
    QVERIFY(fixture.waitForOpen());
    QCOMPARE(fixture.session->latest()->device.status, DeviceStatus::Ready);
    QCOMPARE(fixture.messages.size(), std::size_t(1));  // the message that it was gone
  }

  // A driver that lists its device always never shows that it came back: the message opens it.
  void whatNeverLeavesTheListIsOpenedByTheMessage() {
    HapticSessionFixture fixture;
    auto isGone = std::make_shared<std::atomic<bool>>(false);
    fixture.plugged.log->onRead = [isGone](ScriptedDevice::Log& log) {
      const bool isAway = isGone->load() && log.closes == 0;
      log.state.status = isAway ? DeviceStatus::Absent : DeviceStatus::Ready;
    };
    fixture.plugged.set({{"fake", "well", "Well"}});
    fixture.session->setWatching(true);
    QTRY_COMPARE(fixture.session->found().size(), 4);
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    isGone->store(true);
    QTRY_COMPARE(fixture.session->status(), DeviceStatus::Absent);
    QTRY_COMPARE(fixture.plugged.log->closes, 1);
    QCOMPARE(fixture.messages.size(), std::size_t(1));
    QVERIFY2(fixture.messages[0].advice.contains(fixture.messages[0].actionText),
             qPrintable(fixture.messages[0].advice));
    fixture.messages[0].action();
    QVERIFY(fixture.waitForOpen());
    QCOMPARE(fixture.session->status(), DeviceStatus::Ready);
  }

  void whatIsPluggedInIsFound() {
    HapticSessionFixture fixture;
    QCOMPARE(fixture.session->found().size(), 3);
    QCOMPARE(fixture.session->found()[0].driver, std::string("simulated"));
    QCOMPARE(fixture.session->found()[1].address, std::string("turned-hand"));
    QCOMPARE(fixture.session->found()[2].driver, std::string("mouse"));
    QSignalSpy changed(fixture.session.get(), &HapticSession::foundChanged);
    fixture.plugged.set({{"fake", "well", "Well"}});
    fixture.session->setWatching(true);
    QTRY_COMPARE(fixture.session->found().size(), 4);
    QCOMPARE(fixture.session->found()[3].name, std::string("Well"));
    fixture.plugged.set({});
    QTRY_COMPARE_WITH_TIMEOUT(fixture.session->found().size(), 3, 20000);
    QCOMPARE(changed.count(), 2);
    fixture.session->setWatching(false);
  }

  // An unplugged device is reported once, and keeps neither a thread nor the device open.
  void unplugging() {
    HapticSessionFixture fixture;
    QSignalSpy recorded(fixture.session.get(), &HapticSession::recorded);
    auto isGone = std::make_shared<std::atomic<bool>>(false);
    fixture.plugged.log->onRead = [isGone](ScriptedDevice::Log& log) {
      log.state.status = isGone->load() ? DeviceStatus::Absent : DeviceStatus::Ready;
    };
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    fixture.session->startRecording();
    isGone->store(true);
    QTRY_COMPARE(fixture.session->status(), DeviceStatus::Absent);
    QVERIFY(!fixture.session->isOpen() && !fixture.services.haptics().isRunning());
    QCOMPARE(fixture.session->chosen().address, std::string("well"));
    const std::uint64_t ticks = fixture.services.haptics().counters().ticks;
    QTRY_VERIFY(fixture.jobs.isIdle());
    QCOMPARE(fixture.plugged.log->closes, 1);
    QVERIFY(fixture.plugged.log->last.isZero());
    QTest::qWait(50);
    QCOMPARE(fixture.services.haptics().counters().ticks, ticks);
    QCOMPARE(fixture.messages.size(), std::size_t(1));
    QCOMPARE(recorded.count(), 1);
  }

  // Two seconds of the loop are given to a device to recover.
  void failing() {
    HapticSessionFixture fixture;
    auto isFailed = std::make_shared<std::atomic<bool>>(false);
    fixture.plugged.log->onRead = [isFailed](ScriptedDevice::Log& log) {
      log.state.status = isFailed->load() ? DeviceStatus::Failed : DeviceStatus::Ready;
    };
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    isFailed->store(true);
    QTRY_COMPARE(fixture.session->status(), DeviceStatus::Failed);
    QVERIFY(fixture.session->isOpen());
    isFailed->store(false);
    QTRY_COMPARE(fixture.session->status(), DeviceStatus::Ready);
    const double recovered = fixture.session->latest()->tip.time;
    QTRY_VERIFY(fixture.session->latest()->tip.time > recovered + 3.0);
    isFailed->store(true);
    QTRY_VERIFY(!fixture.session->isOpen());
    QCOMPARE(fixture.session->status(), DeviceStatus::Failed);
    QVERIFY(!fixture.services.haptics().isRunning());
  }

  void theForceTestIsGentleAndEnds() {
    HapticSessionFixture fixture;
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    Vec3 most = Vec3::Zero();
    connect(fixture.session.get(), &HapticSession::sampled, fixture.session.get(), [&] {
      const Vec3 sent = fixture.session->latest()->sent.force.cwiseAbs();
      most = most.cwiseMax(sent);
    });
    QSignalSpy wanted(fixture.session.get(), &HapticSession::sceneRequested);
    fixture.session->startForceTest();
    QVERIFY(fixture.session->isTesting());
    // Dropped: it would push with 5 N.
    fixture.session->setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(5.0, 0.0, 0.0); }));
    QTRY_VERIFY_WITH_TIMEOUT(!fixture.session->isTesting(), 20000);
    QCOMPARE(wanted.count(), 1);
    QVERIFY(most.maxCoeff() <= HapticSession::kTestForce + 1e-9);
    QVERIFY(most.maxCoeff() > 0.0);
    QTRY_VERIFY(fixture.session->latest()->sent.isZero());
  }

  // Else its forces would be compared with the scene before, when the recording is felt again.
  void aRecordingTellsTheForceTestFromScenes() {
    HapticSessionFixture fixture;
    fixture.session->choose("fake", "well");
    QVERIFY(fixture.waitForOpen());
    Recording recording;
    connect(fixture.session.get(), &HapticSession::recorded, fixture.session.get(),
            [&](const Recording& all) { recording = all; });
    fixture.session->startRecording();
    fixture.session->setScene(std::make_unique<HapticScene>(), R"({"surface":{}})");
    QTRY_VERIFY(fixture.session->recorder()->ticks() > 50);
    fixture.session->startForceTest();
    QTRY_VERIFY_WITH_TIMEOUT(!fixture.session->isTesting(), 20000);
    const std::size_t atEnd = fixture.session->recorder()->ticks();
    QTRY_VERIFY(fixture.session->recorder()->ticks() > atEnd + 50);
    fixture.session->stopRecording();
    std::vector<RecordedEvent> scenes;
    for (const RecordedEvent& event : recording.events()) {
      if (event.text.starts_with(kSceneEvent)) scenes.push_back(event);
    }
    QCOMPARE(scenes.size(), std::size_t{3});
    QCOMPARE(scenes[0].text, std::string(R"(scene {"surface":{}})"));
    QCOMPARE(scenes[1].text, std::string(R"(scene {"test":{}})"));
    QCOMPARE(scenes[2].text, std::string("scene {}"));
    for (std::size_t i = 0; i < recording.size(); ++i) {
      const std::uint64_t tick = recording[i].tick;
      if (tick < scenes[1].tick || tick >= scenes[2].tick) QVERIFY(recording[i].felt.force.isZero(0.0));
    }
  }
};

HANDWHEEL_TEST(HapticSessionTest)
#include "HapticSessionTest.moc"
