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

// What is plugged in, as the test has it.
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
    HapticSessionFixture b;
    QSignalSpy sampled(b.session.get(), &HapticSession::sampled);
    b.session->takeUp();
    b.session->setMapping({});
    b.session->setView({}, {});
    b.session->startForceTest();
    QTest::qWait(100);
    QVERIFY(!b.session->isOpen() && !b.session->latest() && !b.session->measure());
    QVERIFY(b.session->chosen().driver.empty());
    QCOMPARE(b.services.haptics().counters().ticks, std::uint64_t(0));
    QVERIFY(!b.services.haptics().isRunning());
    QCOMPARE(sampled.count(), 0);
  }

  void theLoopRunsAsLongAsTheDeviceIsOpen() {
    HapticSessionFixture b;
    b.session->choose("simulated", "hand");
    QVERIFY(b.waitForOpen());
    QVERIFY(b.session->simulatedHand() && !b.session->mouse());
    QVERIFY(b.services.haptics().isRunning());
    QCOMPARE(b.session->latest()->device.status, DeviceStatus::Ready);
    QTRY_VERIFY(b.session->rate() > 0.0);
    b.session->close();
    QVERIFY(!b.session->isOpen() && !b.session->latest());
    QVERIFY(!b.services.haptics().isRunning());
    const std::uint64_t ticks = b.services.haptics().counters().ticks;
    QSignalSpy sampled(b.session.get(), &HapticSession::sampled);
    QTest::qWait(100);
    QCOMPARE(b.services.haptics().counters().ticks, ticks);
    QCOMPARE(sampled.count(), 0);
  }

  // The last thing sent is no force, and the device is closed once.
  void closingIsZeroForce() {
    HapticSessionFixture b;
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    b.session->setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(1.0, 0.0, 0.0); }));
    QTRY_VERIFY(b.session->latest()->sent.force.x() > 0.5);
    b.session->close();
    QVERIFY(b.plugged.log->last.isZero());
    QTRY_VERIFY(b.jobs.isIdle());
    QCOMPARE(b.plugged.log->closes, 1);
  }

  // The force goes before the loop stops, and comes back; ticks are counted on.
  void anotherRateIsTakenUpWithoutABlow() {
    HapticSessionFixture b;
    struct Seen {
      int reads = 0;
      std::vector<double> rests;  // N that went when a loop stopped: a write without a reading
    };
    const auto seen = std::make_shared<Seen>();
    b.plugged.log->onWrite = [seen](const ScriptedDevice::Log& log, const DeviceForce&) {
      if (log.reads == seen->reads) seen->rests.push_back(log.last.force.norm());
      seen->reads = log.reads;
    };
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    QCOMPARE(b.session->measure()->periods().binSeconds(), 0.001 / 64.0);
    b.session->setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(6.0, 0.0, 0.0); }));
    QTRY_VERIFY(b.session->latest()->sent.force.x() > 5.5);
    const std::uint64_t tick = b.session->latest()->tick;
    ServoSettings servo;
    servo.rate = 2000.0;
    servo.velocityWindow = 0.005;
    b.session->setServo(servo);
    b.session->setServo(ServoSettings{});  // of more than one, the last counts
    b.session->setServo(servo);
    QTRY_COMPARE(b.session->measure()->periods().binSeconds(), 0.0005 / 64.0);
    QTRY_VERIFY(b.session->latest()->sent.force.x() > 5.5);
    QVERIFY(b.session->latest()->tick > tick);
    b.session->close();
    QCOMPARE(seen->rests.size(), std::size_t(2));
    QVERIFY(seen->rests[0] <= 0.02);
  }

  void aForceThatIsOffStaysOff() {
    HapticSessionFixture b;
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    b.session->setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(1.0, 0.0, 0.0); }));
    ServoSettings servo;
    servo.rate = 2000.0;
    b.session->setServo(servo);
    b.session->setForceOn(false);
    QTRY_COMPARE(b.session->measure()->periods().binSeconds(), 0.0005 / 64.0);
    QTest::qWait(300);  // three seconds of the loop
    QVERIFY(b.session->latest()->sent.isZero());
  }

  void whatCannotBeOpenedIsTold() {
    for (const char* address : {"deaf", "nowhere"}) {
      HapticSessionFixture b;
      b.session->choose("fake", address);
      QCOMPARE(b.session->chosen().address, std::string(address));
      QTRY_VERIFY(b.jobs.isIdle());
      QVERIFY(!b.session->isOpen() && b.session->chosen().driver.empty());
      QCOMPARE(b.messages.size(), std::size_t(1));
      QCOMPARE(b.messages[0].weight, Message::Weight::Error);
      QVERIFY(!b.messages[0].detail.isEmpty() && !b.messages[0].advice.isEmpty());
    }
  }

  // At the start of the program nobody has asked for it.
  void whatIsNotThereAnyMoreIsNoNews() {
    QSettings().setValue("haptics/driver", "fake");
    QSettings().setValue("haptics/address", "nowhere");
    HapticSessionFixture b;
    b.session->takeUp();
    QTRY_VERIFY(b.jobs.isIdle());
    QVERIFY(!b.session->isOpen() && b.messages.empty());
  }

  void choiceAndMappingAreRemembered() {
    WorkspaceMapping mapping;
    mapping.axes = {DeviceAxis{2, true}, DeviceAxis{0, false}, DeviceAxis{1, true}};
    mapping.scale = 0.25;
    mapping.forceGain = 2.0;
    mapping.deadZone = 1.5;
    mapping.clutchButtons = 5;
    {
      HapticSessionFixture b;
      b.session->choose("fake", "well");
      QVERIFY(b.waitForOpen());
      b.session->setMapping(mapping);
    }
    HapticSessionFixture b;
    b.session->takeUp();
    QVERIFY(b.waitForOpen());
    QCOMPARE(b.session->chosen().address, std::string("well"));
    const WorkspaceMapping kept = b.session->mapping();
    QVERIFY(kept.viewFromDevice() == mapping.viewFromDevice());
    QCOMPARE(kept.scale, 0.25);
    QCOMPARE(kept.forceGain, 2.0);
    QCOMPARE(kept.deadZone, 1.5);
    QCOMPARE(kept.clutchButtons, 5u);
    b.session->close();
    b.session->takeUp();
    QVERIFY(b.session->chosen().driver.empty());  // closed by hand, it stays closed
  }

  // In contact the scale is changed; whoever makes the scene for the new one takes his time. No tick feels the one
  // without the other, and the force comes back by the ramp.
  void anotherScaleIsFeltWithItsScene() {
    HapticSessionFixture b;
    std::atomic<double> sent{0.0}, largest{0.0};
    std::atomic<int> ticks{0};
    b.plugged.log->onWrite = [&](const ScriptedDevice::Log&, const DeviceForce& force) {
      sent = force.force.norm();
      if (sent > largest) largest = sent.load();
      ++ticks;
    };
    b.plugged.log->state.position = {2, 0, 0};
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    const auto publish = [&](bool isDiscontinuous) {
      const double stiffness = b.session->mappingInScene().sceneStiffness(0.5);
      b.session->setScene(sceneOf(
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
    QObject::connect(b.session.get(), &HapticSession::viewChanged, b.session.get(), [&] {
      publish(false);
      QThread::msleep(20);
    });
    WorkspaceMapping mapping = b.session->mapping();
    mapping.scale /= 10.0;
    b.session->setMapping(mapping);
    const int before = ticks;
    QTRY_VERIFY(ticks > before + 2);
    QVERIFY2(sent < 0.5, "without the ramp");
    QTRY_VERIFY(sent > 0.9);
    QVERIFY2(largest < 1.0 + 1e-6, qPrintable(QString::number(largest)));
    b.session->close();
  }

  // The loop takes the last of the mappings that follow closely: the jump is not lost with the one before it.
  void aTipThatIsToJumpJumps() {
    HapticSessionFixture b;
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    CameraState camera;
    camera.height = 200.0;
    b.session->setView(camera, {});
    for (const double x : {30.0, -40.0, 50.0}) {
      camera.centre.x() = x;  // where the tip was is within this view, too
      b.session->setView(camera, {});
      b.session->recentre();
      b.session->setView(camera, {});
      const auto offset = [&] {
        return b.session->latest()->tip.position.x() -
               b.session->latest()->device.position.x() * b.session->mappingInScene().scale;
      };
      QTRY_VERIFY(std::abs(offset() - x) < 1e-6);
    }
  }

  void settingsThatMakeNoSenseAreNotTaken() {
    QSettings().setValue("haptics/simulated/axes", "+0+0+2");
    QSettings().setValue("haptics/simulated/scale", "nan");
    QSettings().setValue("haptics/simulated/force_gain", -1);
    HapticSessionFixture b;
    b.session->choose("simulated", "hand");
    QVERIFY(b.waitForOpen());
    QVERIFY(b.session->mapping().viewFromDevice() == Eigen::Matrix3d::Identity());
    QCOMPARE(b.session->mapping().scale, 1.0);
    QCOMPARE(b.session->mapping().forceGain, 1.0);
  }

  // Nobody looks at the list: the session looks itself until the device is back, at another port.
  void pluggedInAgainItIsOpenedAgain() {
    HapticSessionFixture b;
    auto isGone = std::make_shared<std::atomic<bool>>(false);
    b.plugged.log->onRead = [isGone](ScriptedDevice::Log& log) {
      const bool isAway = isGone->load() && log.closes == 0;  // the one that comes back is another
      log.state.status = isAway ? DeviceStatus::Absent : DeviceStatus::Ready;
    };
    b.plugged.set({{"fake", "well", "Well"}});
    b.session->setWatching(true);
    QTRY_COMPARE(b.session->found().size(), 4);
    b.session->setWatching(false);
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    b.plugged.set({});
    isGone->store(true);
    QTRY_COMPARE(b.session->status(), DeviceStatus::Absent);
    QTRY_COMPARE(b.session->found().size(), 3);
    QCOMPARE(b.session->chosen().address, std::string("well"));
    b.plugged.set({{"fake", "well/2", "Well"}});
    QTRY_COMPARE_WITH_TIMEOUT(b.session->chosen().address, std::string("well/2"), 20000);
    QVERIFY(b.waitForOpen());
    QCOMPARE(b.session->latest()->device.status, DeviceStatus::Ready);
    QCOMPARE(b.messages.size(), std::size_t(1));  // that it was gone
  }

  // A driver that lists its device always never shows that it came back: the message opens it.
  void whatNeverLeavesTheListIsOpenedByTheMessage() {
    HapticSessionFixture b;
    auto isGone = std::make_shared<std::atomic<bool>>(false);
    b.plugged.log->onRead = [isGone](ScriptedDevice::Log& log) {
      const bool isAway = isGone->load() && log.closes == 0;
      log.state.status = isAway ? DeviceStatus::Absent : DeviceStatus::Ready;
    };
    b.plugged.set({{"fake", "well", "Well"}});
    b.session->setWatching(true);
    QTRY_COMPARE(b.session->found().size(), 4);
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    isGone->store(true);
    QTRY_COMPARE(b.session->status(), DeviceStatus::Absent);
    QTRY_COMPARE(b.plugged.log->closes, 1);
    QCOMPARE(b.messages.size(), std::size_t(1));
    QVERIFY2(b.messages[0].advice.contains(b.messages[0].actionText), qPrintable(b.messages[0].advice));
    b.messages[0].action();
    QVERIFY(b.waitForOpen());
    QCOMPARE(b.session->status(), DeviceStatus::Ready);
  }

  void whatIsPluggedInIsFound() {
    HapticSessionFixture b;
    QCOMPARE(b.session->found().size(), 3);
    QCOMPARE(b.session->found()[0].driver, std::string("simulated"));
    QCOMPARE(b.session->found()[1].address, std::string("turned-hand"));
    QCOMPARE(b.session->found()[2].driver, std::string("mouse"));
    QSignalSpy changed(b.session.get(), &HapticSession::foundChanged);
    b.plugged.set({{"fake", "well", "Well"}});
    b.session->setWatching(true);
    QTRY_COMPARE(b.session->found().size(), 4);
    QCOMPARE(b.session->found()[3].name, std::string("Well"));
    b.plugged.set({});
    QTRY_COMPARE_WITH_TIMEOUT(b.session->found().size(), 3, 20000);
    QCOMPARE(changed.count(), 2);
    b.session->setWatching(false);
  }

  // An unplugged device is reported once, and keeps neither a thread nor the device open.
  void unplugging() {
    HapticSessionFixture b;
    QSignalSpy recorded(b.session.get(), &HapticSession::recorded);
    auto isGone = std::make_shared<std::atomic<bool>>(false);
    b.plugged.log->onRead = [isGone](ScriptedDevice::Log& log) {
      log.state.status = isGone->load() ? DeviceStatus::Absent : DeviceStatus::Ready;
    };
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    b.session->startRecording();
    isGone->store(true);
    QTRY_COMPARE(b.session->status(), DeviceStatus::Absent);
    QVERIFY(!b.session->isOpen() && !b.services.haptics().isRunning());
    QCOMPARE(b.session->chosen().address, std::string("well"));
    const std::uint64_t ticks = b.services.haptics().counters().ticks;
    QTRY_VERIFY(b.jobs.isIdle());
    QCOMPARE(b.plugged.log->closes, 1);
    QVERIFY(b.plugged.log->last.isZero());
    QTest::qWait(50);
    QCOMPARE(b.services.haptics().counters().ticks, ticks);
    QCOMPARE(b.messages.size(), std::size_t(1));
    QCOMPARE(recorded.count(), 1);
  }

  // Two seconds of the loop are given to a device to recover.
  void failing() {
    HapticSessionFixture b;
    auto isFailed = std::make_shared<std::atomic<bool>>(false);
    b.plugged.log->onRead = [isFailed](ScriptedDevice::Log& log) {
      log.state.status = isFailed->load() ? DeviceStatus::Failed : DeviceStatus::Ready;
    };
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    isFailed->store(true);
    QTRY_COMPARE(b.session->status(), DeviceStatus::Failed);
    QVERIFY(b.session->isOpen());
    isFailed->store(false);
    QTRY_COMPARE(b.session->status(), DeviceStatus::Ready);
    const double recovered = b.session->latest()->tip.time;
    QTRY_VERIFY(b.session->latest()->tip.time > recovered + 3.0);
    isFailed->store(true);
    QTRY_VERIFY(!b.session->isOpen());
    QCOMPARE(b.session->status(), DeviceStatus::Failed);
    QVERIFY(!b.services.haptics().isRunning());
  }

  void theForceTestIsGentleAndEnds() {
    HapticSessionFixture b;
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    Vec3 most = Vec3::Zero();
    connect(b.session.get(), &HapticSession::sampled, b.session.get(), [&] {
      const Vec3 sent = b.session->latest()->sent.force.cwiseAbs();
      most = most.cwiseMax(sent);
    });
    QSignalSpy wanted(b.session.get(), &HapticSession::sceneRequested);
    b.session->startForceTest();
    QVERIFY(b.session->isTesting());
    // Dropped: it would push with 5 N.
    b.session->setScene(sceneOf([](const TipState&, ForceOut& out) { out.force = Vec3(5.0, 0.0, 0.0); }));
    QTRY_VERIFY_WITH_TIMEOUT(!b.session->isTesting(), 20000);
    QCOMPARE(wanted.count(), 1);
    QVERIFY(most.maxCoeff() <= HapticSession::kTestForce + 1e-9);
    QVERIFY(most.maxCoeff() > 0.0);
    QTRY_VERIFY(b.session->latest()->sent.isZero());
  }

  // Else its forces would be compared with the scene before, when the recording is felt again.
  void aRecordingTellsTheForceTestFromScenes() {
    HapticSessionFixture b;
    b.session->choose("fake", "well");
    QVERIFY(b.waitForOpen());
    Recording recording;
    connect(b.session.get(), &HapticSession::recorded, b.session.get(), [&](const Recording& all) { recording = all; });
    b.session->startRecording();
    b.session->setScene(std::make_unique<HapticScene>(), R"({"surface":{}})");
    QTRY_VERIFY(b.session->recorder()->ticks() > 50);
    b.session->startForceTest();
    QTRY_VERIFY_WITH_TIMEOUT(!b.session->isTesting(), 20000);
    const std::size_t atEnd = b.session->recorder()->ticks();
    QTRY_VERIFY(b.session->recorder()->ticks() > atEnd + 50);
    b.session->stopRecording();
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
