// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/ClayTool.h"

#include "ClayBench.h"
#include "TestClass.h"
#include "document/volume/LayerSteps.h"

#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

class ClayToolTest : public QObject {
  Q_OBJECT

 private slots:
  // A groove as deep as it is set, in one undo step; undone the ball is what it was, redone the groove.
  void aGroove() {
    ClayBench bench;
    const auto before = bench.document.volume();
    bench.choose(ClayAction::Carve);
    bench.set("radius", PropertyValue(4.0));
    bench.set("strength", PropertyValue(0.25));
    bench.stroke(-5.0, 5.0);
    QCOMPARE(bench.steps(), 1);
    QVERIFY(bench.document.history()->undoText().startsWith(QStringLiteral("Carve clay: −")));
    QVERIFY(bench.depthAt({0.0, 0.0, 19.2}) < 0.0);  // a quarter of 4 mm deep
    QVERIFY(bench.depthAt({0.0, 0.0, 18.8}) > 0.0);
    QVERIFY(bench.depthAt({0.0, 10.0, 17.0}) > 0.0);
    const auto after = bench.document.volume();
    bench.document.history()->undo();
    QCOMPARE(bench.document.volume(), before);
    bench.document.history()->redo();
    QCOMPARE(bench.document.volume(), after);
    QCOMPARE(VolumeSurface(after->volume).triangleCount(), after->surface.triangleCount());
  }

  // Ctrl does the opposite of what is set, Shift smooths; what is set stays.
  void modifiers() {
    ClayBench bench;
    bench.choose(ClayAction::Carve);
    bench.set("radius", PropertyValue(3.0));
    bench.stroke(-3.0, 3.0, 0.0, {false, true, false});
    QVERIFY(bench.depthAt({0.0, 0.0, 20.5}) > 0.0);
    const double ridge = bench.document.volume()->volume.material();
    bench.stroke(-3.0, 3.0, 0.0, {true, false, false});
    QVERIFY(bench.document.history()->undoText().startsWith(QStringLiteral("Smooth clay")));
    QVERIFY(bench.document.volume()->volume.material() < ridge);
    QCOMPARE(std::get<double>(bench.tool->settings().front().value), static_cast<double>(ClayAction::Carve));
  }

  // What is in the middle of the brush goes with the mouse.
  void moving() {
    ClayBench bench;
    bench.choose(ClayAction::Move);
    bench.set("radius", PropertyValue(8.0));
    QVERIFY(bench.depthAt({21.0, 0.0, 0.0}) < 0.0);
    bench.stroke(19.0, 23.0);  // beside the middle, in the plane of the view through where it was pressed
    QVERIFY(bench.document.volume()->volume.material() > 0.0);
    bool isPulled = false;
    for (double z = 0.0; z < 12.0; z += 0.5) isPulled = isPulled || bench.depthAt({21.5, 0.0, z}) > 0.0;
    QVERIFY(isPulled);
  }

  // Beside the clay the camera has the mouse; a stroke that is discarded leaves nothing.
  void nothingIsDone() {
    ClayBench bench;
    QCOMPARE(bench.event(PointerEvent::Kind::Press, 30.0, 0.0), ToolReply::Ignored);
    QCOMPARE(bench.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    bench.event(PointerEvent::Kind::Drag, 5.0, 0.0);
    QVERIFY(bench.tool->isLive());
    QVERIFY(bench.tool->preview().ofKind != nullptr);
    QCOMPARE(bench.runner.perform("revert"), ToolReply::Used);
    QVERIFY(!bench.tool->isLive());
    QCOMPARE(bench.steps(), 0);
    QVERIFY(bench.tool->preview().ofKind == nullptr);
  }

  // The simulation applies the rest of a stroke after its release: the next press waits for it, and nothing is lost.
  void nobodyWaits() {
    ClayBench bench;
    bench.choose(ClayAction::Inflate);
    bench.set("radius", PropertyValue(6.0));
    for (const double y : {-6.0, 6.0}) {
      QCOMPARE(bench.event(PointerEvent::Kind::Press, -8.0, y), ToolReply::Used);
      for (int i = 1; i <= 40; ++i) bench.event(PointerEvent::Kind::Drag, -8.0 + 0.4 * i, y);
      QCOMPARE(bench.event(PointerEvent::Kind::Release, 8.0, y), ToolReply::Used);
      QCOMPARE(bench.steps(), 0);
    }
    QVERIFY(bench.tool->isLive());
    bench.complete();
    QCOMPARE(bench.steps(), 2);
    for (const double y : {-6.0, 6.0})
      for (const double x : {-8.0, 0.0, 8.0})
        QVERIFY(bench.depthAt({x, y, std::sqrt(400.0 - x * x - y * y) + 0.1}) > 0.0);
  }

  // A tool that is left has its stroke done, and one that undo meets is taken back.
  void endsAtOnce() {
    ClayBench bench;
    QCOMPARE(bench.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    bench.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QCOMPARE(bench.runner.undo(), ToolReply::Used);
    QCOMPARE(bench.steps(), 0);
    QCOMPARE(bench.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    bench.event(PointerEvent::Kind::Release, 0.0, 0.0);
    bench.runner.stop();
    QCOMPARE(bench.steps(), 1);
  }

  // The other side is worked on at once.
  void mirrored() {
    ClayBench bench;
    bench.choose(ClayAction::Carve);
    bench.set("radius", PropertyValue(2.0));
    bench.set("mirror_x", PropertyValue(true));
    bench.stroke(6.0, 9.0, 3.0);
    const VolumeSampler reader(bench.document.volume()->volume);
    for (const double x : {-8.0, -7.0, 7.0, 8.0}) {
      const double z = std::sqrt(400.0 - 9.0 - x * x) - 0.3;
      QVERIFY(reader.depthAt({x, 3.0, z}).depth < 0.0);
    }
  }

  // What is masked stays as it is; the mask is one undo step, and so is each change of it.
  void masked() {
    ClayBench bench;
    bench.choose(ClayAction::Mask);
    bench.set("radius", PropertyValue(4.0));
    bench.set("falloff", PropertyValue(0.0));
    const double before = bench.document.volume()->volume.material();
    bench.stroke(-6.0, 0.0);
    QCOMPARE(bench.steps(), 1);
    QCOMPARE(bench.document.history()->undoText(), QStringLiteral("Mask clay"));
    QCOMPARE(bench.document.volume()->volume.material(), before);
    const auto share = [&](double x) {
      const auto& mask = bench.document.volume()->mask;
      return mask ? mask->shareAt({x, 0.0, std::sqrt(400.0 - x * x)}) : 0.0;
    };
    QCOMPARE(share(-3.0), 1.0);
    QCOMPARE(share(6.0), 0.0);
    bench.choose(ClayAction::Carve);
    bench.set("radius", PropertyValue(2.0));
    bench.stroke(-6.0, 10.0);
    QVERIFY(bench.depthAt({-3.0, 0.0, 19.6}) > 0.0);
    QVERIFY(bench.depthAt({8.0, 0.0, std::sqrt(400.0 - 64.0) - 0.3}) < 0.0);
    // Ctrl frees it.
    bench.choose(ClayAction::Mask);
    bench.set("radius", PropertyValue(4.0));
    bench.stroke(-3.0, 0.0, 0.0, {false, true, false});
    QCOMPARE(bench.document.history()->undoText(), QStringLiteral("Unmask clay"));
    QCOMPARE(share(-2.0), 0.0);
    bench.document.history()->undo();
    QCOMPARE(share(-2.0), 1.0);
    QCOMPARE(bench.runner.perform("invertMask"), ToolReply::Used);
    QCOMPARE(share(-3.0), 0.0);
    QCOMPARE(share(6.0), 1.0);
    QCOMPARE(bench.runner.perform("clearMask"), ToolReply::Used);
    QVERIFY(!bench.document.volume()->mask);
    QCOMPARE(bench.runner.perform("clearMask"), ToolReply::Ignored);
    bench.document.history()->undo();
    bench.document.history()->undo();
    QCOMPARE(share(-3.0), 1.0);
    QCOMPARE(share(6.0), 0.0);
    // Nothing inverted is everything; twice it is nothing.
    bench.runner.perform("clearMask");
    bench.runner.perform("invertMask");
    QCOMPARE(share(6.0), 1.0);
    bench.runner.perform("invertMask");
    QVERIFY(!bench.document.volume()->mask);
  }

  // A mask is not changed in the middle of a stroke.
  void noMaskActionsInAStroke() {
    ClayBench bench;
    QCOMPARE(bench.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    QCOMPARE(bench.runner.perform("invertMask"), ToolReply::Ignored);
    QVERIFY(bench.tool->isLive());
    QCOMPARE(bench.steps(), 0);
  }

  // By a pen that is pressed half, a groove is half as deep or half as wide, as is chosen; by a mouse it is as set.
  void pressureOfAPen() {
    const auto carved = [](int changed, std::optional<double> pressure) {
      auto bench = std::make_unique<ClayBench>();
      bench->choose(ClayAction::Carve);
      bench->set("radius", PropertyValue(4.0));
      bench->set("strength", PropertyValue(0.5));
      bench->set("pressure", PropertyValue(static_cast<double>(changed)));
      bench->pressure = pressure;
      bench->stroke(-5.0, 5.0);
      return bench;
    };
    const auto depth = [](const ClayBench& bench) {
      return 20.0 - firstHit(bench.document.volume()->volume, {0.0, 0.0, 40.0}, -Vec3::UnitZ())->point.z();
    };
    QVERIFY(std::abs(depth(*carved(1, 0.5)) - 1.0) < 0.05);  // strength
    QVERIFY(std::abs(depth(*carved(2, 0.5)) - 1.0) < 0.05);  // radius: half of 2 mm
    QVERIFY(std::abs(depth(*carved(3, 0.5)) - 0.5) < 0.05);  // both
    QVERIFY(std::abs(depth(*carved(0, 0.5)) - 2.0) < 0.05);  // nothing
    QVERIFY(std::abs(depth(*carved(3, std::nullopt)) - 2.0) < 0.05);
    // A groove r·(1 - s) below its ball's middle is 2 sqrt(r² - (r - depth)²) wide: 3.46 mm by both halves of 4 mm.
    QVERIFY(carved(2, 0.5)->depthAt({0.0, 2.2, std::sqrt(400.0 - 4.84) - 0.1}) > 0.0);
    QVERIFY(carved(1, 0.5)->depthAt({0.0, 2.2, std::sqrt(400.0 - 4.84) - 0.1}) < 0.0);
  }

  // A stamp is pressed once, as deep as a quarter of the radius by the strength; what is loaded is one of the choices.
  void stamped() {
    ClayBench bench;
    int asked = 0;
    auto stamps = std::make_shared<ClayStamps>();
    bench.runner.stop();
    auto started = std::make_unique<ClayTool>(bench.document, SimulationServices{bench.clock, bench.simulation},
                                              ClayTool::StampServices{stamps, [&] { ++asked; }});
    bench.tool = started.get();
    bench.runner.start(std::move(started), bench.document);
    QCOMPARE(bench.runner.perform("loadStamp"), ToolReply::Used);
    QCOMPARE(asked, 1);
    const std::size_t number =
        stamps->add("white.png", std::make_shared<const ClayStamp>(1, 1, std::vector<float>{1.0f}));
    QCOMPARE(stamps->names().at(number), std::string("white.png"));
    QCOMPARE(stamps->add("white.png", stamps->at(number)), number);
    bench.choose(ClayAction::Add);
    bench.set("radius", PropertyValue(6.0));
    bench.set("strength", PropertyValue(0.5));
    bench.set("stamp", PropertyValue(static_cast<double>(number)));
    QCOMPARE(bench.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    for (int i = 0; i < 10; ++i) bench.event(PointerEvent::Kind::Drag, 0.1 * i, 0.0);  // less than its side
    bench.event(PointerEvent::Kind::Release, 1.0, 0.0);
    bench.complete();
    QCOMPARE(bench.steps(), 1);
    const double height = firstHit(bench.document.volume()->volume, {0.0, 0.0, 40.0}, -Vec3::UnitZ())->point.z();
    QVERIFY2(std::abs(height - 20.75) < 0.03, qPrintable(QString::number(height)));
    QVERIFY(bench.depthAt({0.0, 6.0, std::sqrt(400.0 - 36.0) + 0.1}) < 0.0);
    // Ctrl takes away as much.
    QCOMPARE(bench.event(PointerEvent::Kind::Press, 0.0, 0.0, {false, true, false}), ToolReply::Used);
    bench.event(PointerEvent::Kind::Release, 0.0, 0.0);
    bench.complete();
    const double back = firstHit(bench.document.volume()->volume, {0.0, 0.0, 40.0}, -Vec3::UnitZ())->point.z();
    QVERIFY2(std::abs(back - 20.0) < 0.05, qPrintable(QString::number(back)));
    bench.set("stamp", PropertyValue(99.0));  // there is none
    bench.set("stamp", PropertyValue(0.0));
    QVERIFY(!bench.tool->feelAtDevice().isCutting);
  }

  // A volume that is work on a drilling exercise takes no stroke, and who tries gets a reason. Only a mask goes on it.
  void refusedInAnExercise() {
    ClayBench bench;
    const nlohmann::json exercise = {{"subject", "drilling"}, {"task", nlohmann::json::object()}};
    bench.document.assign({std::make_shared<const nlohmann::json>(exercise),
                           std::make_shared<const nlohmann::json>(nlohmann::json::object())},
                          false);
    auto started = std::make_unique<ClayTool>(bench.document, SimulationServices{bench.clock, bench.simulation});
    int refusals = 0;
    started->whenRefused([&] { ++refusals; });
    bench.tool = started.get();
    bench.runner.start(std::move(started), bench.document);
    const auto before = bench.document.volume();
    QCOMPARE(bench.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    QVERIFY(!bench.tool->isLive());
    bench.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QCOMPARE(refusals, 1);
    QCOMPARE(bench.document.volume(), before);
    QVERIFY(!bench.tool->actions().front().enabled);
    QCOMPARE(bench.tool->actions().front().reason, std::string("this volume is to be drilled, not shaped"));
    bench.choose(ClayAction::Mask);
    QVERIFY(bench.tool->actions()[0].enabled && !bench.tool->actions()[1].enabled && bench.tool->actions()[2].enabled);
    bench.stroke(-5.0, 5.0);
    QVERIFY(bench.document.volume()->mask);
    QCOMPARE(bench.document.volume()->volume.enclosed(), before->volume.enclosed());
    QCOMPARE(refusals, 1);
    const auto masked = bench.document.volume();
    QCOMPARE(bench.event(PointerEvent::Kind::Press, 0.0, 0.0, {.shift = true}), ToolReply::Used);  // it would smooth
    QVERIFY(!bench.tool->isLive());
    bench.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QCOMPARE(refusals, 2);
    QCOMPARE(bench.document.volume(), masked);
  }

  // Strokes go on the layer and off with it; while it is weak they are refused, but those of a mask.
  void layers() {
    ClayBench bench;
    int refusals = 0;
    bench.tool->whenRefused([&] { ++refusals; });
    const auto change = [&](const LayerStep& step) { bench.document.commit("layer", step.edit()); };
    const double before = bench.document.volume()->volume.material();
    change(withNewLayer(*bench.document.volume(), "first"));
    bench.choose(ClayAction::Carve);
    bench.set("radius", PropertyValue(4.0));
    bench.stroke(-5.0, 5.0);
    QCOMPARE(bench.steps(), 2);
    const auto carved = bench.document.volume();
    QVERIFY(carved->volume.material() < before);
    QVERIFY(!carved->layers->all()[0].change->blocks().empty());
    change(withLayerShare(*carved, 0, 1.0, false));
    QCOMPARE(bench.document.volume()->volume.material(), before);
    QCOMPARE(bench.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    QVERIFY(!bench.tool->isLive());
    bench.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QCOMPARE(refusals, 1);
    QCOMPARE(bench.steps(), 3);
    bench.choose(ClayAction::Mask);
    bench.stroke(-5.0, 5.0);
    QCOMPARE(bench.steps(), 4);
    QVERIFY(bench.document.volume()->mask);
    QCOMPARE(refusals, 1);
    bench.document.history()->undo();
    bench.document.history()->undo();
    QCOMPARE(bench.document.volume()->volume.material(), carved->volume.material());
    bench.document.history()->undo();
    QCOMPARE(bench.document.volume()->volume.material(), before);
    QVERIFY(bench.document.volume()->layers->all()[0].change->blocks().empty());
  }

  // A device carves where its tip is: outside of the clay as through air.
  void byADevice() {
    ClayBench bench;
    bench.choose(ClayAction::Carve);
    bench.set("radius", PropertyValue(2.0));
    PointerEvent event;
    event.device = Pose::Identity();
    event.kind = PointerEvent::Kind::Press;
    event.button = PointerButton::First;
    QCOMPARE(bench.runner.pointer(event), ToolReply::Used);
    SimulationInputs& inputs = *bench.tool->channel()->inputs;
    for (int i = 0; i < 50; ++i) {
      TipState tip;
      tip.position = Vec3(0.1 * i, 0.0, 19.5);
      tip.buttons = 1u;
      tip.isRestart = false;
      tip.time = 0.001 * i;
      inputs.push({tip, tip.position, inputs.gestureAt(tip)});
    }
    event.kind = PointerEvent::Kind::Release;
    QCOMPARE(bench.runner.pointer(event), ToolReply::Used);
    bench.complete();
    QCOMPARE(bench.steps(), 1);
    QVERIFY(bench.depthAt({2.0, 0.0, 18.0}) < 0.0);
  }
};

HANDWHEEL_TEST(ClayToolTest)
#include "ClayToolTest.moc"
