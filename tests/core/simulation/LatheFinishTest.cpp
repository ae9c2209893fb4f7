// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LatheFixture.h"
#include "TestClass.h"
#include "machining/finish/FinishMeter.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// The finish that the manual lathe leaves equals that of its repeated passes, as marking does.
class LatheFinishTest : public QObject {
  Q_OBJECT

 private slots:
  // The feed of the lever and the nose of the tool in the post, then paper on a part of it; the repeated passes give
  // the same, bit for bit.
  void theFinishIsKept() {
    LatheFixture fixture;
    LatheSetup setup = fixture.setup;
    for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
    setup.stations[0].tool = "right-finishing";
    setup.stations[1].tool = "paper-240";
    const auto paper = toolNamed(fixture.tools, "paper-240");
    fixture.loop.replace(std::make_unique<LatheSimulation>(
        LatheRun(setup, fixture.tools, fixture.rod, LatheMachine::initialState(setup, kRod), fixture.material),
        TurnedSurface(fixture.rod, 0.05), kLower, fixture.channel, SurfaceFinish(fixture.rod.size()), kPassesBefore));
    const auto at = [&](double z) {
      return fixture.moment().finish.at(TurningSide::Outside, static_cast<std::size_t>(std::lround(z / 0.05)));
    };
    fixture.send(LatheDo::Spindle, 1.0);
    fixture.send(LatheDo::MoveTip, 19.8, 102.0);
    fixture.run(2.0);
    fixture.send(LatheDo::Feed, -0.2);
    fixture.run(20.0);  // to 62 mm
    const double turned = 1e3 * 0.04 / (32.0 * 0.4);
    QVERIFY2(std::abs(at(90.0).roughness / turned - 1.0) < 0.02, qPrintable(QString::number(at(90.0).roughness)));
    QVERIFY(at(90.0).pass == kPassesBefore && std::abs(at(90.0).feed - 0.2) < 0.002);
    QVERIFY(!at(50.0).isKnown());
    fixture.send(LatheDo::Feed, 0.0);
    fixture.send(LatheDo::MoveTip, 40.0, 130.0);
    fixture.run(2.0);
    fixture.send(LatheDo::Tool, 1.0);
    fixture.send(LatheDo::MoveTip, 20.5, 80.0);
    fixture.run(2.0);
    fixture.send(LatheDo::MoveTip, 19.0, 80.0);
    fixture.run(1.0);
    const double rubbed = at(80.0).roughness;
    QVERIFY(rubbed < turned && rubbed > paper->leastRoughness);
    fixture.run(10.0);
    QVERIFY(std::abs(at(80.0).roughness - paper->leastRoughness) < 1e-6);
    QVERIFY(std::abs(at(95.0).roughness / turned - 1.0) < 0.02);  // beside it

    const auto taken = fixture.loop.take();
    auto& lathe = static_cast<LatheSimulation&>(*taken);
    lathe.finish();
    const auto& last = static_cast<const LatheMoment&>(*lathe.state());
    QVERIFY(last.collisions->empty());
    TurnedProfile part = fixture.rod;
    FinishMeter again(part, SurfaceFinish(part.size()));
    for (std::size_t i = 0; i < lathe.passes().size(); ++i)
      cut(part, std::make_shared<const TurningPass>(lathe.passes()[i]), static_cast<std::uint32_t>(kPassesBefore + i),
          again);
    QVERIFY(part == last.profile);
    QVERIFY(again.finish() == last.finish);
  }

  // Slender work springs back into a tool that stops. When the cut so far is put into the part, the retraction begins
  // in the material: a pass whose first move cuts what its first point would. The repeated passes give the same.
  void aPassThatBeginsInTheWork() {
    constexpr StockCylinder kSlender{14.0, 100.0, 0.0};
    LatheFixture fixture;
    fixture.setup = defaultLatheSetup(kSlender);
    for (LatheSlot& slot : fixture.setup.stations) slot.position = slot.offset = {0.0, 0.0};
    const TurnedProfile rod(kSlender, 0.05);
    const auto begin = [&](const TurnedProfile& profile, const LatheState& state, SurfaceFinish finish,
                           std::size_t before) {
      fixture.loop.replace(
          std::make_unique<LatheSimulation>(LatheRun(fixture.setup, fixture.tools, profile, state, fixture.material),
                                            TurnedSurface(profile, 0.05), kLower, fixture.channel, finish, before));
    };
    begin(rod, LatheMachine::initialState(fixture.setup, kSlender), SurfaceFinish(rod.size()), 0);
    fixture.send(LatheDo::Spindle, 1.0);
    fixture.send(LatheDo::MoveTip, 6.0, 102.0);
    fixture.run(2.0);
    fixture.send(LatheDo::Feed, -0.3);
    fixture.run(8.0);
    fixture.send(LatheDo::Feed, 0.0);
    fixture.run(2.0);
    const auto first = fixture.loop.take();
    auto& there = static_cast<LatheSimulation&>(*first);
    there.finish();
    begin(there.run().profile(), there.run().machine().state(), static_cast<const LatheMoment&>(*there.state()).finish,
          1);
    fixture.send(LatheDo::Feed, 0.1);
    fixture.run(4.0);
    const auto second = fixture.loop.take();
    auto& back = static_cast<LatheSimulation&>(*second);
    back.finish();
    const auto& last = static_cast<const LatheMoment&>(*back.state());
    QVERIFY(last.collisions->empty());
    QVERIFY(there.passes().size() == 1 && back.passes().size() == 1);
    TurnedProfile part = rod;
    FinishMeter again(part, SurfaceFinish(part.size()));
    cut(part, std::make_shared<const TurningPass>(there.passes().front()), 0, again);
    TurnedProfile atFirstPoint = part;
    const TurningPass& home = back.passes().front();
    QVERIFY(!cut(atFirstPoint, home, home.path[0], home.path[0]).isEmpty());
    cut(part, std::make_shared<const TurningPass>(home), 1, again);
    QVERIFY(part == last.profile);
    QVERIFY(again.finish() == last.finish);
  }
};

HANDWHEEL_TEST(LatheFinishTest)
#include "LatheFinishTest.moc"
