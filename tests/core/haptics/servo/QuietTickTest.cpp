// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A tick allocates nothing, takes no lock, and makes no system call but the wait: counted by functions of this program
// that replace those of the C library, and by the kernel's filter of system calls on the ticking thread.
#include "QuietThread.h"

#include <QtTest>
#include <thread>

#include "HapticDevices.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "haptics/device/MouseDevice.h"
#include "haptics/device/SimulatedDevice.h"
#include "haptics/scene/MeshHaptics.h"
#include "haptics/scene/SceneForces.h"
#include "haptics/servo/ServoLoop.h"
#include "io/ThreadedDevice.h"

using namespace handwheel;
using namespace handwheel::test;

class QuietTickTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    if (HANDWHEEL_SANITIZED) QSKIP("a sanitizer stands in the same place");
  }

  // Checks that the counters count.
  void theCountersCount() {
    isCounting = true;
    std::vector<int> some(1000);
    static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&mutex);
    pthread_mutex_unlock(&mutex);
    isCounting = false;
    QVERIFY(some.size() == 1000 && allocations > 0);
    QVERIFY(locks > 0);
    bool isForbidden = false;
    std::thread([&] {
      isForbidden = forbidSystemCalls();
      if (isForbidden) syscall(SYS_getppid);
    }).join();
    if (!isForbidden) QSKIP("this kernel filters no system calls");
    QVERIFY(systemCalls > 0);
  }

  // In contact, through the ramp, with the hand's dynamics, while scenes are exchanged by another thread.
  void aTickIsQuiet() {
    MonotonicClock clock;
    auto device = std::make_unique<SimulatedDevice>(
        simulatedDevice(), PoseTrajectory({{0.0, {-1, 0, 0}}, {0.2, {2, 0, 0}}, {0.6, {2, 0, 0}}}), clock);
    QVERIFY(device->open(Progress()).hasValue());
    Service service("servo");
    ServoLoop loop(std::move(device), {}, clock, service);
    loop.setScene(sceneOf(wall(0.5)));
    isSilentFor(loop, [&] { loop.setScene(sceneOf(wall(0.5), false)); });
  }

  // The released set-up: the hand slides over a ball of 20,480 triangles, with points that draw it and a spring that
  // comes and goes, by either method, while each scene has another edit of the ball, and the view is another.
  void aMeshSceneIsQuiet() {
    for (const SnapMethod method : {SnapMethod::Proxy, SnapMethod::Sum}) {
      MonotonicClock clock;
      std::vector<HandPose> poses{{0.0, {0, 0, kBall + 1.0}}};
      for (int i = 5; i <= 100; ++i) poses.push_back({0.01 * i, slideAt(0.01 * i)});
      auto device = std::make_unique<SimulatedDevice>(simulatedDevice(), PoseTrajectory(poses), clock);
      QVERIFY(device->open(Progress()).hasValue());
      Service service("servo");
      ServoLoop loop(std::move(device), {}, clock, service);
      const TriangleSoup soup = moved(icosphere(5), Vec3::Zero(), kBall);
      ContactSurface surface(soup.points, soup.triangles);
      SnapFeatures features;
      for (std::uint32_t i = 0; i < soup.points.size(); i += 7) features.addPoint(i, soup.points[i]);
      const SnapField field(features);
      const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.3, Vec3::UnitX()));
      std::uint32_t round = 0;
      const auto publish = [&] {
        const std::uint32_t id = round++ % static_cast<std::uint32_t>(soup.triangles.size());
        const Triangle& t = soup.triangles[id];
        const Vec3 out = 0.01 * (round % 7) * soup.points[t[0]].normalized();
        const ContactTriangle lifted{{soup.points[t[0]] + out, soup.points[t[1]], soup.points[t[2]]}, id};
        surface.update({&id, 1}, {&lifted, 1});
        MeshHaptics feel;
        feel.surface = TouchedSurface{surface, 0.5, 0.0005, {}};
        feel.snap = SnapAttraction{field, SnapProfile(SnapShape::Quadratic, 0.3, 2.0), method};
        if (round % 2 == 0) feel.springs = {{Vec3(0, 0, kBall), 0.1, 0.0005, turned, 50.0}};
        auto scene = std::make_unique<HapticScene>();
        scene->renderer = std::make_unique<SceneForces>(forceSources(std::move(feel)));
        scene->isDiscontinuous = false;
        WorkspaceMapping mapping;
        mapping.scale = round % 2 == 0 ? 1.0 : 1.01;
        loop.setMapping(mapping, std::move(scene));
      };
      publish();
      isSilentFor(loop, publish);
      QVERIFY(loop.latest().hasSource);
      QVERIFY(m_contacts > 100);
    }
  }

  // A device whose session allocates and sleeps on a thread of its own.
  void aDeviceWithAThreadIsQuiet() {
    struct RestlessSession final : Session {
      DeviceCapabilities capabilities() const override { return forceDevice(); }
      Status open(Progress) override { return Done{}; }
      DeviceState exchange(const DeviceForce&) noexcept override {
        const std::vector<int> rubbish(1000, 1);
        std::this_thread::sleep_for(std::chrono::microseconds(rubbish.size()));
        DeviceState state;
        state.status = DeviceStatus::Ready;
        state.position.x() = 1.0;
        state.reading = ++m_reading;
        return state;
      }
      void close() noexcept override {}

     private:
      std::uint32_t m_reading = 0;
    };
    MonotonicClock clock;
    auto device = std::make_unique<ThreadedDevice>(std::make_unique<RestlessSession>());
    QVERIFY(device->open(Progress()).hasValue());
    QTRY_COMPARE(device->read().status, DeviceStatus::Ready);
    Service service("servo");
    ServoLoop loop(std::move(device), {}, clock, service);
    loop.setScene(sceneOf(wall(0.5)));
    isSilentFor(loop, [&] { loop.setScene(sceneOf(wall(0.5), false)); });
    QVERIFY(m_contacts > 100);
  }

  // A device that is gone, and one that reports NaN.
  void faultsAreQuietToo() {
    auto log = std::make_shared<ScriptedDevice::Log>();
    log->onRead = [](ScriptedDevice::Log& l) {
      l.state.status = l.reads % 7 == 0 ? DeviceStatus::Absent : DeviceStatus::Ready;
      l.state.position.x() = l.reads % 11 == 0 ? std::numeric_limits<double>::quiet_NaN() : 1.0;
    };
    MonotonicClock clock;
    Service service("servo");
    ServoLoop loop(std::make_unique<ScriptedDevice>(log), {}, clock, service);
    loop.setScene(sceneOf(wall(0.5)));
    isSilentFor(loop, [&] { loop.announceDiscontinuity(); });
  }

 private:
  static constexpr double kBall = 30.0;  // mm
  // Returns a position on a path over the ball, a millimetre deep.
  static Vec3 slideAt(double time) { return (kBall - 1.0) * Vec3(std::sin(2.0 * time), 0, std::cos(2.0 * time)); }
  int m_contacts = 0;  // ticks

  // Runs 500 ticks under the counters, and `meanwhile` on this thread again and again.
  template <class Meanwhile>
  void isSilentFor(ServoLoop& loop, Meanwhile meanwhile) {
    allocations = locks = systemCalls = 0;
    std::atomic<bool> isDone{false};
    std::thread servo([&] {
      loop.runTicks(10);  // for symbols that are resolved in the first call
      forbidSystemCalls();
      isCounting = true;
      loop.runTicks(500);
      isCounting = false;
      isDone = true;
    });
    while (!isDone) {
      meanwhile();
      QThread::msleep(5);
    }
    servo.join();
    m_contacts = 0;
    for (ServoSample sample; loop.nextSample(sample);) m_contacts += sample.felt.isContact ? 1 : 0;
    QCOMPARE(allocations.load(), 0);
    QCOMPARE(locks.load(), 0);
    QVERIFY2(systemCalls == 0, qPrintable(QString("system call %1").arg(lastSystemCall.load())));
    QCOMPARE(loop.latest().tick, std::uint64_t{509});
  }
};

HANDWHEEL_TEST(QuietTickTest)
#include "QuietTickTest.moc"
