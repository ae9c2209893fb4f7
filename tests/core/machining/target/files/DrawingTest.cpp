// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/files/Drawing.h"

#include "../AnyProfile.h"
#include "TestClass.h"
#include "machining/target/TargetErrors.h"
#include "machining/target/files/DrawingWriter.h"
#include "machining/target/files/DxfReader.h"
#include "machining/target/files/SvgReader.h"

#include <QtTest>
#include <algorithm>

using namespace handwheel;
using test::anyShaft;
using test::evenly;

namespace {

Drawing drawn(std::vector<ProfileSegment> curves) {
  Drawing drawing;
  drawing.curves = std::move(curves);
  return drawing;
}

ErrorCode refusalOf(const Drawing& drawing) {
  const auto made = targetIn(drawing);
  return made ? ErrorCode() : made.error().code;
}

}  // namespace

class DrawingTest : public QObject {
  Q_OBJECT

 private slots:
  void anyOrderAndDirection() {
    QVERIFY(rc::check("shuffled, reversed and doubled curves give the profile", [] {
      const auto target = TargetProfile::make(anyShaft());
      RC_PRE(target.hasValue());
      Drawing drawing = drawingOf(*target);
      auto& curves = drawing.curves;
      for (std::size_t i = curves.size(); i-- > 1;)
        std::swap(curves[i], curves[*rc::gen::inRange<std::size_t>(0, i + 1)]);
      for (ProfileSegment& s : curves)
        if (*rc::gen::arbitrary<bool>()) s = s.reversed();
      curves.push_back(curves.front());
      curves.push_back({{-20.0, 0.0}, {200.0, 0.0}, 0.0});  // the axis, drawn as a line
      const auto back = targetIn(drawing);
      RC_ASSERT(back.hasValue());
      RC_ASSERT(distanceBetween(*target, *back) < 1e-9);
    }));
  }

  // Two curves between two points are an outline; of as many as a file has room for, the third is refused.
  void manyArcsBetweenTwoPoints() {
    std::vector<ProfileSegment> arcs;
    for (int i = 0; i < 100'000; ++i) arcs.push_back({{10.0, 0.0}, {10.0, 50.0}, 1e-5 * i});
    const auto target = targetIn(drawn(arcs));
    QVERIFY(!target && target.error().code == TargetError::CrossesItself);
  }

  void belowTheAxis() {
    Drawing drawing = drawn({{{0, 3}, {50, 3}, 0.0}, {{0, 3}, {0, 10}, 0.0}, {{50, 3}, {50, 10}, 0.0}});
    drawing.axis = 10.0;
    const auto target = targetIn(drawing);
    QVERIFY(target.hasValue());
    QVERIFY(std::abs(target->volume() - M_PI * 49.0 * 50.0) < 1e-9);
    QCOMPARE(target->lowerEnd(), 0.0);
  }

  void outsideAndBore() {
    const auto tube = targetIn(drawn({{{0, 10}, {50, 10}, 0.0}, {{0, 4}, {50, 4}, 0.0}}));
    QVERIFY(tube.hasValue() && tube->isClosed());
    QVERIFY(std::abs(tube->volume() - M_PI * (100.0 - 16.0) * 50.0) < 1e-9);
  }

  void smallGaps() {
    QVERIFY(targetIn(drawn({{{0, 10}, {50, 10}, 0.0}, {{50.0005, 10}, {50.0005, 0}, 0.0}})).hasValue());
    QCOMPARE(refusalOf(drawn({{{0, 10}, {50, 10}, 0.0}, {{50.1, 10}, {50.1, 0}, 0.0}})),
             ErrorCode(TargetError::SeveralProfiles));
  }

  void refuses() {
    QCOMPARE(refusalOf({}), ErrorCode(TargetError::NoProfile));
    QCOMPARE(refusalOf(drawn({{{0, 0}, {50, 0}, 0.0}})), ErrorCode(TargetError::NoProfile));
    // Three lines from one point.
    QCOMPARE(refusalOf(drawn({{{0, 10}, {50, 10}, 0.0}, {{50, 10}, {50, 0}, 0.0}, {{50, 10}, {70, 20}, 0.0}})),
             ErrorCode(TargetError::CrossesItself));
    // A frame around it.
    QCOMPARE(refusalOf(drawn({{{0, 10}, {50, 10}, 0.0}, {{-9, 99}, {99, 99}, 0.0}})),
             ErrorCode(TargetError::SeveralProfiles));
    QCOMPARE(refusalOf(drawn({{{0, 10}, {50, -10}, 0.0}})), ErrorCode(TargetError::CrossesAxis));
  }

  void writtenIsRead() {
    QVERIFY(rc::check("DXF and SVG give back the profile within 1e-6 mm", [] {
      const auto target = TargetProfile::make(anyShaft());
      RC_PRE(target.hasValue());
      const TargetProfile placed = target->moved(evenly(-500.0, 500.0));
      for (const auto& read : {readDxf(dxfOf(placed)), readSvg(svgOf(placed))}) {
        RC_ASSERT(read.hasValue());
        RC_ASSERT(read->hasUnit);
        RC_ASSERT(read->axis.has_value());
        RC_ASSERT(std::abs(*read->axis) < 1e-9);
        const auto back = targetIn(*read);
        RC_ASSERT(back.hasValue());
        RC_ASSERT(distanceBetween(placed, *back) < 1e-6);
      }
    }));
  }

  void writtenTubeAndBall() {
    const auto tube = TargetProfile::make(
        {{{8, 0}, {20, 0}, 0.0}, {{20, 0}, {20, 40}, 0.0}, {{20, 40}, {8, 40}, 0.0}, {{8, 40}, {8, 0}, -0.1}});
    const auto ball = TargetProfile::make({arcAround({0, 7}, 5.0, -M_PI / 2, M_PI / 2)});
    const auto most = TargetProfile::make({arcAround({3, 0}, 5.0, -2.2, 2.2)});
    for (const auto* target : {&tube, &ball, &most}) {
      QVERIFY(target->hasValue());
      const auto dxf = targetIn(readDxf(dxfOf(**target)).value()), svg = targetIn(readSvg(svgOf(**target)).value());
      QVERIFY(dxf.hasValue() && svg.hasValue());
      QVERIFY(std::abs(dxf->volume() / (*target)->volume() - 1.0) < 1e-9);
      QVERIFY(distanceBetween(**target, *svg) < 1e-6);
    }
  }
};

HANDWHEEL_TEST(DrawingTest)
#include "DrawingTest.moc"
