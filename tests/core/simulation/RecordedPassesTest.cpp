// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/RecordedPasses.h"

#include "TestClass.h"
#include "haptics/recording/RecordingCsv.h"
#include "haptics/scene/SceneForces.h"
#include "simulation/SimulationLoop.h"
#include "simulation/turning/TurningSimulation.h"

#include <QtTest>
#include <sstream>

using namespace handwheel;

namespace {

constexpr StockCylinder kHandBar{40.0, 100.0, 0.0};
constexpr double kHandBase = 7.0;  // mm, z of the lower end

TurningPass cuttingBy(double nose, TurningSide side = TurningSide::Outside) {
  TurningPass blank;
  blank.noseRadius = nose;
  blank.side = side;
  return blank;
}

// A hand that is led at a bar, recorded tick by tick, and the part that it makes.
struct HandAtWork {
  std::shared_ptr<TurningChannel> channel = std::make_shared<TurningChannel>();
  VirtualClock clock;
  Service service{"simulation"};
  TurnedProfile part{kHandBar, 0.1};
  std::vector<TurningPass> passes;
  Recording recording;
  std::uint64_t ticks = 0;
  std::uint32_t gesture = 0;

  // Leads the hand straight from position to position, 600 ms each, with the button held after the first tick and
  // before the last.
  void lead(const TurningPass& blank, const std::vector<Vec3>& positions) {
    constexpr int kBetween = 600;
    SimulationLoop loop(std::make_unique<TurningSimulation>(part, TurnedSurface(part, 0.05), blank, kHandBase, channel),
                        250.0, channel->inputs, clock, service);
    channel->patch.write(patchAround(part, positions.front().z() - kHandBase, blank.noseRadius, blank.side));
    ForceSources sources;
    TurningTool tool;
    tool.noseRadius = blank.noseRadius;
    tool.side = blank.side;
    sources.push_back(std::make_unique<TurningForce>(channel, tool, kHandBase));
    SceneForces forces(std::move(sources));
    recording.addEvent({ticks, "no tool"});  // the window ends a tool before it starts another
    recording.addEvent({ticks, "tool " + recordedTurning(blank)});
    loop.setGesture(++gesture);
    channel->inputs->setDeviceGesture(gesture);
    TipState tip;
    const int count = kBetween * static_cast<int>(positions.size() - 1);
    for (int i = 0; i <= count; ++i) {
      const auto from = static_cast<std::size_t>(std::min(i / kBetween, static_cast<int>(positions.size()) - 2));
      const double share = static_cast<double>(i - static_cast<int>(from) * kBetween) / kBetween;
      const Vec3 position = positions[from] + share * (positions[from + 1] - positions[from]);
      tip.isRestart = i == 0;
      tip.velocity = i == 0 ? Vec3(Vec3::Zero()) : Vec3((position - tip.position) / tip.period);
      tip.position = position;
      tip.time = 0.001 * static_cast<double>(ticks);
      tip.buttons = i > 0 && i < count ? 1u : 0u;
      RecordedTick tick;
      tick.tick = ++ticks;
      tick.tip = tip;
      tick.felt.proxy = position;
      tick.hasSource = true;
      forces.tick(tip, tick.felt);
      recording.add(tick);
      if (ticks % 4 == 0) loop.runSteps(1);
    }
    const std::unique_ptr<Simulation> ended = loop.take();
    passes.push_back(static_cast<const TurningSimulation&>(*ended).pass());
    part = static_cast<const TurningState&>(*ended->state()).profile;
  }
};

// Returns the recording after export by the window and reading by the command line.
Recording writtenAndRead(const Recording& recording) {
  std::stringstream text;
  if (!writeCsv(recording, text)) qFatal("it is not written");
  const Result<Recording> read = recordingFromCsv(text.str());
  if (!read) qFatal("it is not read");
  return *read;
}

}  // namespace

class RecordedPassesTest : public QObject {
  Q_OBJECT

 private slots:
  // Along the bar from any side, through the axis, and in a bore, each with a nose of its own: the recording cuts the
  // same part, bit for bit.
  void workByHandIsTheSameAgain() {
    HandAtWork hand;
    const Vec3 up = kHandBase * Vec3::UnitZ();
    hand.lead(cuttingBy(2.0),
              {up + Vec3(20, 12, 20), up + Vec3(14, 8, 30), up + Vec3(13, 11, 60), up + Vec3(25, 9, 70)});
    hand.lead(cuttingBy(0.4), {up + Vec3(21, 3, 96), up + Vec3(-4, -1, 97), up + Vec3(-5, -1, 112)});
    hand.lead(cuttingBy(1.0, TurningSide::Bore), {up + Vec3(0.3, 5, 108), up + Vec3(0.1, 5, 80), up + Vec3(0, 3, 108)});
    QCOMPARE(hand.passes.size(), std::size_t{3});
    const double whole = TurnedProfile(kHandBar, 0.1).volume();
    QVERIFY(hand.part.volume() < whole - 100.0 && hand.part.isBored());

    const auto passes = passesOf(writtenAndRead(hand.recording), kHandBase);
    QVERIFY(passes.has_value());
    QCOMPARE(passes->size(), hand.passes.size());
    TurnedProfile again(kHandBar, 0.1);
    for (std::size_t i = 0; i < passes->size(); ++i) {
      const TurningPass &made = (*passes)[i], &wanted = hand.passes[i];
      QVERIFY(made.noseRadius == wanted.noseRadius && made.side == wanted.side && made.method == wanted.method);
      QVERIFY(made.path == wanted.path && made.times == wanted.times);
      cut(again, made);
    }
    QVERIFY(again == hand.part);
  }

  // The settings of the tool are in its name, and are read back.
  void namesSayWhatCuts() {
    TurningPass blank = cuttingBy(0.8, TurningSide::Bore);
    blank.method = TurningMethod::Poles;
    blank.resolution = 0.25;
    QCOMPARE(recordedTurning(blank), std::string("turn bore nose 0.8 poles 0.25"));
    QCOMPARE(recordedTurning(cuttingBy(1.0)), std::string("turn nose 1"));
    const auto read = [](const std::string& name) {
      Recording recording;
      recording.addEvent({0, name});
      for (std::uint64_t i = 1; i < 4; ++i) {
        RecordedTick tick;
        tick.tick = i;
        tick.tip.isRestart = false;
        tick.tip.buttons = i > 1 ? 1u : 0u;
        tick.hasSource = true;
        recording.add(tick);
      }
      return passesOf(recording, 0.0);
    };
    const auto poles = read("tool " + recordedTurning(blank));
    QVERIFY(poles && poles->size() == 1);
    QVERIFY(poles->front().noseRadius == 0.8 && poles->front().side == TurningSide::Bore);
    QVERIFY(poles->front().method == TurningMethod::Poles && poles->front().resolution == 0.25);
    // Names of older programs, and impossible tools.
    for (const char* const name : {"tool turn", "tool turn nose", "tool turn nose x", "tool turn nose nan",
                                   "tool turn nose -1", "tool turn nose 1e9", "tool turn else"}) {
      const auto usual = read(name);
      QVERIFY2(usual && usual->size() == 1 && usual->front().noseRadius == 1.0, name);
      QVERIFY2(usual->front().side == TurningSide::Outside, name);
    }
    QVERIFY(read("tool measure")->empty() && read("no tool")->empty());
    QVERIFY(!read("tool lathe"));
    // A table has all events of a tick in one field.
    const auto changed = read("no tool; tool turn bore nose 0.8");
    QVERIFY(changed && changed->size() == 1 && changed->front().noseRadius == 0.8);
    QVERIFY(changed->front().side == TurningSide::Bore);
    const auto mapped = read("tool turn nose 0.4; mapping");
    QVERIFY(mapped && mapped->size() == 1 && mapped->front().noseRadius == 0.4);
    QVERIFY(read("tool turn; no tool")->empty() && !read("no tool; tool lathe"));
  }

  // Another nose while the button is held drops the pass, as in the window.
  void anotherNoseDropsThePass() {
    Recording recording;
    for (std::uint64_t i = 0; i < 10; ++i) {
      RecordedTick tick;
      tick.tick = i;
      tick.tip.isRestart = false;
      tick.tip.buttons = i > 1 && i < 8 ? 1u : 0u;
      tick.hasSource = true;
      recording.add(tick);
    }
    recording.addEvent({4, "tool turn nose 2"});
    const auto passes = passesOf(recording, 0.0);
    QVERIFY(passes && passes->empty());
  }
};

HANDWHEEL_TEST(RecordedPassesTest)
#include "RecordedPassesTest.moc"
