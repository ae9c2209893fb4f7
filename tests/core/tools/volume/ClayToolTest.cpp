// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/ClayTool.h"

#include "ClayFixture.h"
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
    ClayFixture fixture;
    const auto before = fixture.document.volume();
    fixture.choose(ClayAction::Carve);
    fixture.set("radius", PropertyValue(4.0));
    fixture.set("strength", PropertyValue(0.25));
    fixture.stroke(-5.0, 5.0);
    QCOMPARE(fixture.steps(), 1);
    QVERIFY(fixture.document.history()->undoText().startsWith(QStringLiteral("Carve clay: −")));
    QVERIFY(fixture.depthAt({0.0, 0.0, 19.2}) < 0.0);  // a quarter of 4 mm deep
    QVERIFY(fixture.depthAt({0.0, 0.0, 18.8}) > 0.0);
    QVERIFY(fixture.depthAt({0.0, 10.0, 17.0}) > 0.0);
    const auto after = fixture.document.volume();
    fixture.document.history()->undo();
    QCOMPARE(fixture.document.volume(), before);
    fixture.document.history()->redo();
    QCOMPARE(fixture.document.volume(), after);
    QCOMPARE(VolumeSurface(after->volume).triangleCount(), after->surface.triangleCount());
  }

  // Ctrl does the opposite of what is set, Shift smooths; what is set stays.
  void modifiers() {
    ClayFixture fixture;
    fixture.choose(ClayAction::Carve);
    fixture.set("radius", PropertyValue(3.0));
    fixture.stroke(-3.0, 3.0, 0.0, {false, true, false});
    QVERIFY(fixture.depthAt({0.0, 0.0, 20.5}) > 0.0);
    const double ridge = fixture.document.volume()->volume.material();
    fixture.stroke(-3.0, 3.0, 0.0, {true, false, false});
    QVERIFY(fixture.document.history()->undoText().startsWith(QStringLiteral("Smooth clay")));
    QVERIFY(fixture.document.volume()->volume.material() < ridge);
    QCOMPARE(std::get<double>(fixture.tool->settings().front().value), static_cast<double>(ClayAction::Carve));
  }

  // Material at the centre of the brush follows the mouse.
  void moving() {
    ClayFixture fixture;
    fixture.choose(ClayAction::Move);
    fixture.set("radius", PropertyValue(8.0));
    QVERIFY(fixture.depthAt({21.0, 0.0, 0.0}) < 0.0);
    fixture.stroke(19.0, 23.0);  // beside the middle, in the plane of the view through where it was pressed
    QVERIFY(fixture.document.volume()->volume.material() > 0.0);
    bool isPulled = false;
    for (double z = 0.0; z < 12.0; z += 0.5) isPulled = isPulled || fixture.depthAt({21.5, 0.0, z}) > 0.0;
    QVERIFY(isPulled);
  }

  // Beside the clay the camera has the mouse; a stroke that is discarded leaves nothing.
  void nothingIsDone() {
    ClayFixture fixture;
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 30.0, 0.0), ToolReply::Ignored);
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    fixture.event(PointerEvent::Kind::Drag, 5.0, 0.0);
    QVERIFY(fixture.tool->isLive());
    QVERIFY(fixture.tool->preview().ofKind != nullptr);
    QCOMPARE(fixture.runner.perform("revert"), ToolReply::Used);
    QVERIFY(!fixture.tool->isLive());
    QCOMPARE(fixture.steps(), 0);
    QVERIFY(fixture.tool->preview().ofKind == nullptr);
  }

  // The simulation applies the rest of a stroke after its release: the next press waits for it, and nothing is lost.
  void nobodyWaits() {
    ClayFixture fixture;
    fixture.choose(ClayAction::Inflate);
    fixture.set("radius", PropertyValue(6.0));
    for (const double y : {-6.0, 6.0}) {
      QCOMPARE(fixture.event(PointerEvent::Kind::Press, -8.0, y), ToolReply::Used);
      for (int i = 1; i <= 40; ++i) fixture.event(PointerEvent::Kind::Drag, -8.0 + 0.4 * i, y);
      QCOMPARE(fixture.event(PointerEvent::Kind::Release, 8.0, y), ToolReply::Used);
      QCOMPARE(fixture.steps(), 0);
    }
    QVERIFY(fixture.tool->isLive());
    fixture.complete();
    QCOMPARE(fixture.steps(), 2);
    for (const double y : {-6.0, 6.0})
      for (const double x : {-8.0, 0.0, 8.0})
        QVERIFY(fixture.depthAt({x, y, std::sqrt(400.0 - x * x - y * y) + 0.1}) > 0.0);
  }

  // A tool that is left has its stroke done, and one that undo meets is taken back.
  void endsAtOnce() {
    ClayFixture fixture;
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QCOMPARE(fixture.runner.undo(), ToolReply::Used);
    QCOMPARE(fixture.steps(), 0);
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    fixture.runner.stop();
    QCOMPARE(fixture.steps(), 1);
  }

  // The other side is worked on at once.
  void mirrored() {
    ClayFixture fixture;
    fixture.choose(ClayAction::Carve);
    fixture.set("radius", PropertyValue(2.0));
    fixture.set("mirror_x", PropertyValue(true));
    fixture.stroke(6.0, 9.0, 3.0);
    const VolumeSampler sampler(fixture.document.volume()->volume);
    for (const double x : {-8.0, -7.0, 7.0, 8.0}) {
      const double z = std::sqrt(400.0 - 9.0 - x * x) - 0.3;
      QVERIFY(sampler.depthAt({x, 3.0, z}).depth < 0.0);
    }
  }

  // Masked clay does not change; the mask is one undo step, and so is each change of it.
  void masked() {
    ClayFixture fixture;
    fixture.choose(ClayAction::Mask);
    fixture.set("radius", PropertyValue(4.0));
    fixture.set("falloff", PropertyValue(0.0));
    const double before = fixture.document.volume()->volume.material();
    fixture.stroke(-6.0, 0.0);
    QCOMPARE(fixture.steps(), 1);
    QCOMPARE(fixture.document.history()->undoText(), QStringLiteral("Mask clay"));
    QCOMPARE(fixture.document.volume()->volume.material(), before);
    const auto share = [&](double x) {
      const auto& mask = fixture.document.volume()->mask;
      return mask ? mask->shareAt({x, 0.0, std::sqrt(400.0 - x * x)}) : 0.0;
    };
    QCOMPARE(share(-3.0), 1.0);
    QCOMPARE(share(6.0), 0.0);
    fixture.choose(ClayAction::Carve);
    fixture.set("radius", PropertyValue(2.0));
    fixture.stroke(-6.0, 10.0);
    QVERIFY(fixture.depthAt({-3.0, 0.0, 19.6}) > 0.0);
    QVERIFY(fixture.depthAt({8.0, 0.0, std::sqrt(400.0 - 64.0) - 0.3}) < 0.0);
    // Ctrl frees it.
    fixture.choose(ClayAction::Mask);
    fixture.set("radius", PropertyValue(4.0));
    fixture.stroke(-3.0, 0.0, 0.0, {false, true, false});
    QCOMPARE(fixture.document.history()->undoText(), QStringLiteral("Unmask clay"));
    QCOMPARE(share(-2.0), 0.0);
    fixture.document.history()->undo();
    QCOMPARE(share(-2.0), 1.0);
    QCOMPARE(fixture.runner.perform("invertMask"), ToolReply::Used);
    QCOMPARE(share(-3.0), 0.0);
    QCOMPARE(share(6.0), 1.0);
    QCOMPARE(fixture.runner.perform("clearMask"), ToolReply::Used);
    QVERIFY(!fixture.document.volume()->mask);
    QCOMPARE(fixture.runner.perform("clearMask"), ToolReply::Ignored);
    fixture.document.history()->undo();
    fixture.document.history()->undo();
    QCOMPARE(share(-3.0), 1.0);
    QCOMPARE(share(6.0), 0.0);
    // Nothing inverted is everything; twice it is nothing.
    fixture.runner.perform("clearMask");
    fixture.runner.perform("invertMask");
    QCOMPARE(share(6.0), 1.0);
    fixture.runner.perform("invertMask");
    QVERIFY(!fixture.document.volume()->mask);
  }

  // A mask is not changed in the middle of a stroke.
  void noMaskActionsInAStroke() {
    ClayFixture fixture;
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    QCOMPARE(fixture.runner.perform("invertMask"), ToolReply::Ignored);
    QVERIFY(fixture.tool->isLive());
    QCOMPARE(fixture.steps(), 0);
  }

  // By a pen that is pressed half, a groove is half as deep or half as wide, as is chosen; by a mouse it is as set.
  void pressureOfAPen() {
    const auto carved = [](int changed, std::optional<double> pressure) {
      auto fixture = std::make_unique<ClayFixture>();
      fixture->choose(ClayAction::Carve);
      fixture->set("radius", PropertyValue(4.0));
      fixture->set("strength", PropertyValue(0.5));
      fixture->set("pressure", PropertyValue(static_cast<double>(changed)));
      fixture->pressure = pressure;
      fixture->stroke(-5.0, 5.0);
      return fixture;
    };
    const auto depth = [](const ClayFixture& fixture) {
      return 20.0 - firstHit(fixture.document.volume()->volume, {0.0, 0.0, 40.0}, -Vec3::UnitZ())->point.z();
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
    ClayFixture fixture;
    int asked = 0;
    auto stamps = std::make_shared<ClayStamps>();
    fixture.runner.stop();
    auto started = std::make_unique<ClayTool>(fixture.document, SimulationServices{fixture.clock, fixture.simulation},
                                              ClayTool::StampServices{stamps, [&] { ++asked; }});
    fixture.tool = started.get();
    fixture.runner.start(std::move(started), fixture.document);
    QCOMPARE(fixture.runner.perform("loadStamp"), ToolReply::Used);
    QCOMPARE(asked, 1);
    const std::size_t number =
        stamps->add("white.png", std::make_shared<const ClayStamp>(1, 1, std::vector<float>{1.0f}));
    QCOMPARE(stamps->names().at(number), std::string("white.png"));
    QCOMPARE(stamps->add("white.png", stamps->at(number)), number);
    fixture.choose(ClayAction::Add);
    fixture.set("radius", PropertyValue(6.0));
    fixture.set("strength", PropertyValue(0.5));
    fixture.set("stamp", PropertyValue(static_cast<double>(number)));
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    for (int i = 0; i < 10; ++i) fixture.event(PointerEvent::Kind::Drag, 0.1 * i, 0.0);  // less than its side
    fixture.event(PointerEvent::Kind::Release, 1.0, 0.0);
    fixture.complete();
    QCOMPARE(fixture.steps(), 1);
    const double height = firstHit(fixture.document.volume()->volume, {0.0, 0.0, 40.0}, -Vec3::UnitZ())->point.z();
    QVERIFY2(std::abs(height - 20.75) < 0.03, qPrintable(QString::number(height)));
    QVERIFY(fixture.depthAt({0.0, 6.0, std::sqrt(400.0 - 36.0) + 0.1}) < 0.0);
    // Ctrl takes away as much.
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0, {false, true, false}), ToolReply::Used);
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    fixture.complete();
    const double back = firstHit(fixture.document.volume()->volume, {0.0, 0.0, 40.0}, -Vec3::UnitZ())->point.z();
    QVERIFY2(std::abs(back - 20.0) < 0.05, qPrintable(QString::number(back)));
    fixture.set("stamp", PropertyValue(99.0));  // there is none
    fixture.set("stamp", PropertyValue(0.0));
    QVERIFY(!fixture.tool->feelAtDevice().isCutting);
  }

  // A volume that is work on a drilling exercise takes no stroke, and who tries gets a reason. Only a mask goes on it.
  void refusedInAnExercise() {
    ClayFixture fixture;
    const nlohmann::json exercise = {{"subject", "drilling"}, {"task", nlohmann::json::object()}};
    fixture.document.assign({std::make_shared<const nlohmann::json>(exercise),
                             std::make_shared<const nlohmann::json>(nlohmann::json::object())},
                            false);
    auto started = std::make_unique<ClayTool>(fixture.document, SimulationServices{fixture.clock, fixture.simulation});
    int refusals = 0;
    started->whenRefused([&] { ++refusals; });
    fixture.tool = started.get();
    fixture.runner.start(std::move(started), fixture.document);
    const auto before = fixture.document.volume();
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    QVERIFY(!fixture.tool->isLive());
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QCOMPARE(refusals, 1);
    QCOMPARE(fixture.document.volume(), before);
    QVERIFY(!fixture.tool->actions().front().enabled);
    QCOMPARE(fixture.tool->actions().front().reason, std::string("this volume is to be drilled, not shaped"));
    fixture.choose(ClayAction::Mask);
    QVERIFY(fixture.tool->actions()[0].enabled && !fixture.tool->actions()[1].enabled &&
            fixture.tool->actions()[2].enabled);
    fixture.stroke(-5.0, 5.0);
    QVERIFY(fixture.document.volume()->mask);
    QCOMPARE(fixture.document.volume()->volume.enclosed(), before->volume.enclosed());
    QCOMPARE(refusals, 1);
    const auto masked = fixture.document.volume();
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0, {.shift = true}), ToolReply::Used);  // it would smooth
    QVERIFY(!fixture.tool->isLive());
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QCOMPARE(refusals, 2);
    QCOMPARE(fixture.document.volume(), masked);
  }

  // Strokes go on the layer and off with it; while it is weak they are refused, but those of a mask.
  void layers() {
    ClayFixture fixture;
    int refusals = 0;
    fixture.tool->whenRefused([&] { ++refusals; });
    const auto change = [&](const LayerStep& step) { fixture.document.commit("layer", step.edit()); };
    const double before = fixture.document.volume()->volume.material();
    change(withNewLayer(*fixture.document.volume(), "first"));
    fixture.choose(ClayAction::Carve);
    fixture.set("radius", PropertyValue(4.0));
    fixture.stroke(-5.0, 5.0);
    QCOMPARE(fixture.steps(), 2);
    const auto carved = fixture.document.volume();
    QVERIFY(carved->volume.material() < before);
    QVERIFY(!carved->layers->all()[0].change->blocks().empty());
    change(withLayerShare(*carved, 0, 1.0, false));
    QCOMPARE(fixture.document.volume()->volume.material(), before);
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    QVERIFY(!fixture.tool->isLive());
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QCOMPARE(refusals, 1);
    QCOMPARE(fixture.steps(), 3);
    fixture.choose(ClayAction::Mask);
    fixture.stroke(-5.0, 5.0);
    QCOMPARE(fixture.steps(), 4);
    QVERIFY(fixture.document.volume()->mask);
    QCOMPARE(refusals, 1);
    fixture.document.history()->undo();
    fixture.document.history()->undo();
    QCOMPARE(fixture.document.volume()->volume.material(), carved->volume.material());
    fixture.document.history()->undo();
    QCOMPARE(fixture.document.volume()->volume.material(), before);
    QVERIFY(fixture.document.volume()->layers->all()[0].change->blocks().empty());
  }

  // A device carves where its tip is: outside of the clay as through air.
  void byADevice() {
    ClayFixture fixture;
    fixture.choose(ClayAction::Carve);
    fixture.set("radius", PropertyValue(2.0));
    PointerEvent event;
    event.device = Pose::Identity();
    event.kind = PointerEvent::Kind::Press;
    event.button = PointerButton::First;
    QCOMPARE(fixture.runner.pointer(event), ToolReply::Used);
    SimulationInputs& inputs = *fixture.tool->channel()->inputs;
    for (int i = 0; i < 50; ++i) {
      TipState tip;
      tip.position = Vec3(0.1 * i, 0.0, 19.5);
      tip.buttons = 1u;
      tip.isRestart = false;
      tip.time = 0.001 * i;
      inputs.push({tip, tip.position, inputs.gestureAt(tip)});
    }
    event.kind = PointerEvent::Kind::Release;
    QCOMPARE(fixture.runner.pointer(event), ToolReply::Used);
    fixture.complete();
    QCOMPARE(fixture.steps(), 1);
    QVERIFY(fixture.depthAt({2.0, 0.0, 18.0}) < 0.0);
  }
};

HANDWHEEL_TEST(ClayToolTest)
#include "ClayToolTest.moc"
