// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The ticks of a lathe, with the network that ships, and of clay allocate nothing, take no lock and call no system,
// while the simulation runs on another thread: as QuietTickTest counts it.
#include "QuietThread.h"

#include <QtTest>
#include <functional>
#include <thread>

#include "TestClass.h"
#include "machining/force/TrainedForceModel.h"
#include "machining/lathe/LatheJson.h"
#include "simulation/SimulationLoop.h"
#include "simulation/clay/ClayForce.h"
#include "simulation/turning/LatheForce.h"
#include "volume/VolumeShapes.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr StockCylinder kQuietBar{40.0, 100.0, 0.0};

struct QuietLathe {
  std::shared_ptr<LatheChannel> channel = std::make_shared<LatheChannel>();
  LatheTools tools = shippedLatheTools();
  std::shared_ptr<const LatheMaterial> material;
  LatheSetup setup = defaultLatheSetup(kQuietBar);
  MonotonicClock clock;
  Service service{"simulation"};
  std::unique_ptr<SimulationLoop> loop;

  explicit QuietLathe(const char* tool) {
    const WorkMaterials materials = WorkMaterials::standard();
    const WorkMaterial& work = *materials.find(shippedForceModel().origin().material);
    material = std::make_shared<const LatheMaterial>(latheMaterial(work, ForceLaw::Network, tools));
    for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
    setup.stations[0].tool = tool;
    const TurnedProfile bar(kQuietBar, 0.05);
    loop = std::make_unique<SimulationLoop>(
        std::make_unique<LatheSimulation>(
            LatheRun(setup, tools, bar, LatheMachine::initialState(setup, kQuietBar), material),
            TurnedSurface(bar, 0.05), 0.0, channel, SurfaceFinish(bar.size())),
        1000.0, channel->inputs, clock, service);
    using Kind = LatheCommand::Kind;
    channel->commands.push({Kind::Spindle, LatheAxis::Carriage, 1.0});
    channel->commands.push({Kind::MoveTip, LatheAxis::Carriage, 20.5, 80.0});
    loop->runSteps(3000);
    channel->commands.push({Kind::MoveTip, LatheAxis::Carriage, 19.0, 80.0});
    loop->runSteps(200);
  }
};

// Ticks of a force, 1 ms from one to the next. position(i): position of the hand in tick i.
void tickQuietly(ForceSource& force, const std::function<Vec3(int)>& position) {
  if (HANDWHEEL_SANITIZED) QSKIP("a sanitizer stands in the same place");
  allocations = locks = systemCalls = 0;
  int contacts = 0;
  std::thread([&] {
    MonotonicClock clock;
    const auto tick = [&](int i) {
      clock.waitUntil(clock.now() + 1'000'000);
      TipState tip;
      tip.isRestart = i == 0;
      tip.position = position(i);
      tip.buttons = 1u;
      ForceOut out;
      force.advance(tip, out);
      contacts += out.isContact && force.force(tip, 1.0, 1.0).allFinite() ? 1 : 0;
    };
    for (int i = 0; i < 50; ++i) tick(i);  // the first calls look things up
    forbidSystemCalls();
    isCounting = true;
    for (int i = 50; i < 500; ++i) tick(i);
    isCounting = false;
  }).join();
  QCOMPARE(allocations.load(), 0);
  QCOMPARE(locks.load(), 0);
  QVERIFY2(systemCalls == 0, qPrintable(QString("system call %1").arg(lastSystemCall.load())));
  QVERIFY2(contacts > 100, qPrintable(QString::number(contacts)));
}

}  // namespace

class QuietForcesTest : public QObject {
  Q_OBJECT

 private slots:
  void aTickWhileCutting_data() {
    QTest::addColumn<QString>("tool");
    for (const char* const tool : {"right-roughing", "paper-240", "disk-100"}) QTest::addRow("%s", tool) << tool;
  }
  void aTickWhileCutting() {
    QFETCH(QString, tool);
    QuietLathe lathe(qPrintable(tool));
    LatheForce force(lathe.channel, lathe.material, {}, 0.0);
    lathe.loop->setGesture(1);
    lathe.channel->inputs->setDeviceGesture(1);
    lathe.loop->start();
    tickQuietly(force, [](int i) { return Vec3(18.0 - 1e-4 * i, 0.1, 80.0); });
    lathe.loop->stop();
  }

  // Felt, and carved.
  void aTickOnClay_data() {
    QTest::addColumn<bool>("isCutting");
    QTest::newRow("felt") << false;
    QTest::newRow("carved") << true;
  }
  void aTickOnClay() {
    QFETCH(bool, isCutting);
    const auto channel = std::make_shared<ClayChannel>();
    auto begin = std::make_shared<ClayState>();
    begin->volume = ballOfVoxels(10.0, 0.1);
    begin->surface = VolumeSurface(begin->volume);
    ClayBrush brush;
    brush.radius = 0.5;
    MonotonicClock clock;
    Service service{"simulation"};
    SimulationLoop loop(std::make_unique<ClaySimulation>(begin, brush, channel), 60.0, channel->inputs, clock, service);
    loop.runSteps(1);
    ClayFeel feel;
    feel.isCutting = isCutting;
    ClayForce force(channel, feel);
    if (isCutting) {
      loop.setGesture(1);
      channel->inputs->setDeviceGesture(1);
    }
    loop.start();
    tickQuietly(force, [](int i) { return Vec3(1e-2 * i, 0.1, i < 10 ? 10.5 : 9.0); });
    loop.stop();
  }
};

HANDWHEEL_TEST(QuietForcesTest)
#include "QuietForcesTest.moc"
