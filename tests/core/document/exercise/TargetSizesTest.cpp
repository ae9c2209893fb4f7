// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/TargetSizes.h"

#include "TestClass.h"
#include "document/workpiece/exercise/TurningSubject.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

// A bar of 40 × 103 mm, held up to 25 mm, and a target in it along these points (r, z).
TurningTask taskWith(const std::vector<ProfilePoint>& points) {
  std::vector<ProfileSegment> segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) segments.push_back({points[i], points[i + 1], 0.0});
  TurningTask task;
  task.stock = {40.0, 103.0, 0.0};
  task.target = *TargetProfile::make(std::move(segments));
  return task;
}

const MarkingCriterion* sizeOf(const std::vector<MarkingCriterion>& sizes, const std::string& figure, double nominal) {
  for (const MarkingCriterion& c : sizes)
    if (c.figure == figure && std::abs(*c.nominal - nominal) < 1e-9) return &c;
  return nullptr;
}

std::ptrdiff_t countOf(const std::vector<MarkingCriterion>& sizes, const char* figure) {
  return std::count_if(sizes.begin(), sizes.end(), [&](const MarkingCriterion& c) { return c.figure == figure; });
}

}  // namespace

// The sizes that are proposed for a target of known sizes.
class TargetSizesTest : public QObject {
  Q_OBJECT

 private slots:
  // 30 mm over 40 mm with a chamfer of 1 × 45°; the diameter of the bar is not turned.
  void aShoulder() {
    const auto sizes = sizesOfTarget(taskWith({{0, 0}, {20, 0}, {20, 60}, {15, 60}, {15, 99}, {14, 100}, {0, 100}}));
    QCOMPARE(sizes.size(), std::size_t(3));
    const MarkingCriterion* diameter = sizeOf(sizes, "diameter", 30.0);
    QVERIFY(diameter);
    QCOMPARE(diameter->name, std::string("⌀30"));
    QCOMPARE(diameter->arguments, std::vector<double>({61.0, 98.0}));
    QVERIFY(std::abs(*diameter->lower - 29.8) < 1e-9 && std::abs(*diameter->upper - 30.2) < 1e-9);  // 6 to 30: ±0.2
    const MarkingCriterion* length = sizeOf(sizes, "length", 40.0);
    QVERIFY(length);
    QCOMPARE(length->arguments, std::vector<double>({17.5, 60.0, 7.0, 100.0}));
    QVERIFY(std::abs(*length->upper - 40.3) < 1e-9);  // 30 to 120: ±0.3
    const MarkingCriterion* taper = sizeOf(sizes, "taper", 45.0);
    QVERIFY(taper);
    QVERIFY(std::abs(*taper->lower - 44.0) < 1e-9);  // up to 10 mm: ±1°
  }

  // A taper has the diameters of its ends and its length, except those of an adjacent cylinder: 24 to 32 mm over 20 mm.
  // A part that is made by a nose of 0.8 mm that goes along its normals has these sizes.
  void aTaper() {
    const std::vector<ProfilePoint> alone = {{0, 0}, {20, 0}, {20, 80}, {16, 80}, {12, 100}, {0, 100}};
    const auto sizes = sizesOfTarget(taskWith(alone));
    QCOMPARE(countOf(sizes, "taper_diameter"), std::ptrdiff_t(2));
    const MarkingCriterion *thin = sizeOf(sizes, "taper_diameter", 24.0),
                           *thick = sizeOf(sizes, "taper_diameter", 32.0);
    const MarkingCriterion* length = sizeOf(sizes, "taper_length", 20.0);
    QVERIFY(thin && thick && length);
    QCOMPARE(thin->arguments, std::vector<double>({81.0, 99.0, 100.0}));
    QCOMPARE(thick->arguments, std::vector<double>({81.0, 99.0, 80.0}));
    QVERIFY(std::abs(*thin->lower - 23.8) < 1e-9 && std::abs(*thick->upper - 32.3) < 1e-9);
    QCOMPARE(length->arguments, std::vector<double>({78.0, 100.0}));
    QVERIFY(std::abs(*length->upper - 20.2) < 1e-9);

    const std::vector<ProfilePoint> onCylinder = {{0, 0}, {20, 0}, {20, 60}, {16, 60}, {16, 80}, {12, 100}, {0, 100}};
    const auto besides = sizesOfTarget(taskWith(onCylinder));
    QVERIFY(sizeOf(besides, "diameter", 32.0) && !sizeOf(besides, "taper_diameter", 32.0));
    QVERIFY(sizeOf(besides, "taper_diameter", 24.0) && sizeOf(besides, "taper_length", 20.0));

    const TurningSubject subject{};
    const auto task = std::make_shared<TurningTask>(taskWith(onCylinder));
    task->stock.length = 100.0;
    const double angle = std::atan(0.2), r = 0.8 * std::cos(angle), z = 0.8 * std::sin(angle);
    nlohmann::json pass = {{"nose_radius", 0.8}, {"feed", 0.2}}, passes;
    pass["points"] = {{11.4 + r, 103.0 + z}, {16.0 + r, 80.0 + z}, {16.8, 80.0}, {16.8, 60.8}, {22.0, 60.8}};
    passes["passes"].push_back(pass);
    const auto work = subject.makeWork(*task, passes, {});
    QVERIFY(work.hasValue());
    Exercise exercise;
    exercise.criteria = {*thin, *sizeOf(besides, "taper_length", 20.0), *thick};
    const std::vector<Measurement> figures = subject.measure(exercise, *task, **work, {});
    QCOMPARE(figures.size(), std::size_t(3));
    const double wanted[] = {24.0, 20.0, 32.0}, within[] = {0.01, 0.2, 0.01};
    for (std::size_t i = 0; i < 3; ++i) {
      QVERIFY(figures[i].value.has_value());
      QVERIFY2(std::abs(*figures[i].value - wanted[i]) < within[i], std::to_string(*figures[i].value).c_str());
    }
    // Each of them can be measured there.
    for (const MarkingCriterion& c : besides) QVERIFY2(subject.positionProblem(c, *task).empty(), c.figure.c_str());
  }

  // A groove has two faces, and the bar beside it none of its sizes. A blind bore has a diameter and a depth.
  void aGrooveAndABore() {
    const auto sizes = sizesOfTarget(
        taskWith({{0, 0}, {20, 0}, {20, 60}, {12, 60}, {12, 65}, {20, 65}, {20, 100}, {8, 100}, {8, 80}, {0, 80}}));
    QCOMPARE(sizes.size(), std::size_t(5));
    QVERIFY(sizeOf(sizes, "diameter", 24.0) && sizeOf(sizes, "bore", 16.0) && sizeOf(sizes, "depth", 20.0));
    QVERIFY(sizeOf(sizes, "length", 40.0) && sizeOf(sizes, "length", 35.0));
    QCOMPARE(sizeOf(sizes, "depth", 20.0)->arguments, std::vector<double>({4.0, 80.0, 14.0, 100.0}));
  }

  // A stem of 8 mm with a bowl of 100 lines on it, half a wave to ⌀38, that is then bored along another one.
  void aCurveIsOneForm() {
    const auto waveTo = [](double low, double high, int i) {
      const double t = i / 100.0;
      return ProfilePoint(low + (high - low) * 0.5 * (1.0 - std::cos(M_PI * t)), 60.0 + 40.0 * t);
    };
    std::vector<ProfilePoint> points = {{0, 0}, {20, 0}, {20, 30}, {4, 30}};
    for (int i = 0; i <= 100; ++i) points.push_back(waveTo(4.0, 19.0, i));
    points.emplace_back(0.0, 100.0);
    const auto sizes = sizesOfTarget(taskWith(points));
    points.pop_back();
    QVERIFY(sizeOf(sizes, "diameter", 8.0));
    QVERIFY(sizeOf(sizes, "length", 70.0));
    QCOMPARE(sizes.size(), std::size_t(3));
    QCOMPARE(sizes.back().figure, std::string("profile"));
    QVERIFY(std::abs(sizes.back().arguments[0] - 61.0) < 1.0 && std::abs(sizes.back().arguments[1] - 99.0) < 1.0);
    QVERIFY(!sizes.back().nominal && *sizes.back().lower == 0.0);
    QVERIFY(std::abs(*sizes.back().upper - 0.15) < 1e-9);  // ⌀30 to 120: ±0.3, which is 0.15 of the radius

    // The form is measured outside and inside: the curve of a bore over the other one is in it.
    for (int i = 100; i >= 20; --i) points.push_back(waveTo(0.0, 16.0, i));
    points.emplace_back(0.0, waveTo(0.0, 16.0, 20).y());
    const auto hollow = sizesOfTarget(taskWith(points));
    QVERIFY(countOf(hollow, "profile") == 1);
    QVERIFY(countOf(hollow, "taper") == 0);
  }

  // A cylinder of 9 mm in a curve is as real as one between faces.
  void aStemInACurve() {
    const auto bent = [](double z) { return 4.0 + 0.05 * z * z; };  // mm, z from the end of the stem
    std::vector<ProfilePoint> points = {{0, 0}, {20, 0}, {20, 50}};
    for (int i = 40; i >= 0; --i) points.emplace_back(bent(0.25 * i), 60.0 - 0.25 * i);
    for (int i = 0; i <= 40; ++i) points.emplace_back(bent(0.25 * i), 69.0 + 0.25 * i);
    points.emplace_back(0.0, 79.0);
    const auto sizes = sizesOfTarget(taskWith(points));
    QVERIFY(sizeOf(sizes, "diameter", 8.0));
    QCOMPARE(sizeOf(sizes, "diameter", 8.0)->arguments.size(), std::size_t(2));
    QVERIFY(countOf(sizes, "profile") == 1);
    QVERIFY(countOf(sizes, "taper") == 0);
    QVERIFY(sizes.back().arguments[0] < 52.0 && sizes.back().arguments[1] > 77.0);
  }

  // A fillet of many lines is not marked.
  void aFilletOfLines() {
    std::vector<ProfilePoint> points = {{0, 0}, {20, 0}, {20, 60}};
    for (int i = 0; i <= 20; ++i)
      points.emplace_back(16.2 - 1.2 * std::sin(M_PI * i / 40.0), 61.2 - 1.2 * std::cos(M_PI * i / 40.0));
    points.emplace_back(15.0, 100.0);
    points.emplace_back(0.0, 100.0);
    const auto sizes = sizesOfTarget(taskWith(points));
    QVERIFY(sizeOf(sizes, "diameter", 30.0));
    for (const MarkingCriterion& c : sizes) QVERIFY2(c.figure == "diameter" || c.figure == "length", c.figure.c_str());
  }

  // Held in the chuck: not measured there.
  void whatTheChuckHolds() {
    const auto sizes = sizesOfTarget(taskWith({{0, 0}, {15, 0}, {15, 20}, {18, 20}, {18, 100}, {0, 100}}));
    QCOMPARE(sizes.size(), std::size_t(1));
    QCOMPARE(sizes[0].arguments, std::vector<double>({26.0, 99.0}));  // from the chuck on, a millimetre in
    QVERIFY(sizesOfTarget(TurningTask()).empty());
  }
};

HANDWHEEL_TEST(TargetSizesTest)
#include "TargetSizesTest.moc"
