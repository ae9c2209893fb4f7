// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillExperiments.h"

#include "TestClass.h"
#include "volume/drilling/SteppedErosion.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace handwheel;

namespace {

struct EvenSteps {
  double mean = 0.0, ripple = 0.0;
};

// While the front half of the ball is in the plate.
EvenSteps evenSteps(const SteppedHole& hole) {
  const std::vector<double> removed = removedBySteps(hole);
  const double travel = hole.feed / hole.rate;
  const auto first = static_cast<std::size_t>((0.5 * hole.diameter + 0.6) / travel),
             last = static_cast<std::size_t>((hole.thickness - 0.6) / travel);
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (std::size_t i = first; i < last; ++i, ++count) {
    sum += removed[i];
    squares += removed[i] * removed[i];
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean};
}

DrillExperimentHole madeHole(double value, double thrust, double torque) {
  DrillExperimentHole hole;
  hole.value = value;
  hole.ours.mean = {thrust, torque};
  hole.stepped.mean = {thrust, torque};
  return hole;
}

}  // namespace

// The runs of He (2008, 3.3): what he states of them, by his own erosion and by ours.
class DrillExperimentsTest : public QObject {
  Q_OBJECT

 private slots:
  // Voxels of which the centre comes into the ball lose all they have, where the ball is long enough around them.
  void allIsRemoved() {
    SteppedHole hole;
    hole.thickness = 6.0 * hole.voxel;
    hole.step = 255.0;
    const std::vector<double> removed = removedBySteps(hole);
    std::size_t centres = 0;
    for (int j = -20; j < 20; ++j)
      for (int i = -20; i < 20; ++i) centres += std::hypot(i + 0.5, j + 0.5) * hole.voxel < 0.5 * hole.diameter;
    const double all = 6.0 * static_cast<double>(centres) * std::pow(hole.voxel, 3.0);
    QVERIFY(std::abs(std::accumulate(removed.begin(), removed.end(), 0.0) / all - 1.0) < 1e-9);
  }

  // With the voxel of the rule each column always has one voxel that is being removed: as much as the ball's section
  // takes, without a ripple. With any other it has more or less.
  void ruleOfResolution() {
    SteppedHole hole;
    const EvenSteps even = evenSteps(hole);
    QVERIFY(even.ripple < 1e-6);
    const double exact = M_PI * 9.0 * hole.feed / hole.rate;
    QVERIFY(std::abs(even.mean / exact - 1.0) < 0.02);
    hole.voxel = 0.51;
    const double coarse = evenSteps(hole).ripple;
    hole.voxel = 1.02;
    QVERIFY(coarse > 0.1 && evenSteps(hole).ripple > coarse);
  }

  // "As large as 10 %" at 4/255, and larger with larger steps.
  void erosionRipples() {
    double before = 0.0;
    for (const double step : {1.0, 2.0, 4.0, 8.0}) {
      SteppedHole hole;
      hole.step = step;
      const double ripple = evenSteps(hole).ripple;
      QVERIFY(step == 1.0 || ripple > before);
      if (step == 4.0) QVERIFY(ripple > 0.1 && ripple < 0.3);
      before = ripple;
    }
  }

  // Linear below 6 mm/s. Faster, voxels leave the ball before all of them is gone.
  void feedOfSteps() {
    const auto share = [](double feed) {
      SteppedHole hole;
      hole.feed = feed;
      return evenSteps(hole).mean / (M_PI * 9.0 * feed / hole.rate);
    };
    for (const double feed : {1.0, 2.0, 4.0, 6.0}) QVERIFY(std::abs(share(feed) - 1.0) < 0.03);
    QVERIFY(share(10.0) < 0.95);
  }

  void whatIsNoHole() {
    const double bad[] = {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e300, 1e-300};
    for (const double number : bad) {
      for (double SteppedHole::*const member :
           {&SteppedHole::voxel, &SteppedHole::feed, &SteppedHole::diameter, &SteppedHole::thickness}) {
        SteppedHole hole;
        hole.*member = number;
        if (!isDrillable(hole)) QVERIFY(removedBySteps(hole).empty());
      }
    }
    SteppedHole hole;
    hole.step = 256.0;
    QVERIFY(!isDrillable(hole));
    hole.step = std::nan("");
    QVERIFY(!isDrillable(hole));
  }

  // Drilled by ours: the thrust of the balance, in any voxels, and less ripple in smaller ones. He's erosion ripples as
  // much as its mean in those that are four times as large as his rule has them.
  void ours() {
    const auto coarse = drillExperimentHole(DrillExperiment::Resolution, 1.02, {}),
               fine = drillExperimentHole(DrillExperiment::Feed, 10.0, {});
    QVERIFY(coarse.hasValue() && fine.hasValue());
    QVERIFY(fine->ours.ripple < coarse->ours.ripple);
    QVERIFY(fine->ours.ripple < 0.05 && coarse->ours.ripple < 0.1);
    QVERIFY(coarse->stepped.ripple > 0.5);
    for (const auto* const hole : {&*coarse, &*fine}) {
      QVERIFY(std::abs(hole->ours.mean.thrust / hole->balance.thrust - 1.0) < 0.02);
      QVERIFY(std::abs(hole->ours.mean.torque / hole->balance.torque - 1.0) < 0.02);
    }
    // kp π r² f / (f + ktc r ω), of cortical bone at 1000 r/min.
    const double tangential = 1.64 * 3.0 * 2.0 * M_PI * 1000.0 / 60.0;
    QVERIFY(std::abs(coarse->balance.thrust - 250.0 * M_PI * 9.0 / (1.0 + tangential)) < 1e-6);
    // The laws of Allotta with Ks = kp / (2 ktc) and Ru = kp / 5; 0.06 mm to a turn.
    QVERIFY(std::abs(coarse->reference.thrust - 250.0 / (2.0 * 1.64) * 0.06 * 3.0) < 1e-6);
    QVERIFY(std::abs(coarse->reference.torque - 5.0 * 50.0 * 0.06 * 36.0 / 8.0) < 1e-6);
    // While the ball goes in, 0.01 mm in a cycle, thrust is that of the section in the plate: 2 x - x² of all, of which
    // the correlation with x is √(15/16).
    DrillExperimentResult rule{DrillExperiment::Resolution, 1000.0, {*fine}};
    rule.holes[0].value = SteppedHole().voxel;
    std::vector<float> slow;  // thrust as if drilled at 1 mm/s
    for (const float thrust : fine->ourThrust) slow.insert(slow.end(), 10, thrust);
    rule.holes[0].ourThrust = slow;
    const auto checks = shapeChecksOf(rule);
    const auto buildUp = std::find_if(checks.begin(), checks.end(), [](const DrillShapeCheck& check) {
      return check.kind == DrillShapeCheck::Kind::BuildUp;
    });
    QVERIFY(buildUp != checks.end() && buildUp->holds());
    QVERIFY(std::abs(buildUp->found - std::sqrt(15.0 / 16.0)) < 0.01);
  }

  void checksTellShapes() {
    DrillExperimentResult radius{DrillExperiment::Radius, 1000.0, {}};
    for (const double r : {1.0, 2.0, 4.0}) radius.holes.push_back(madeHole(r, 3.0 * r, 2.0 * r * r));
    for (const DrillShapeCheck& check : shapeChecksOf(radius)) QVERIFY(check.holds());
    radius.holes.back().ours.mean = {100.0, 100.0};
    for (const DrillShapeCheck& check : shapeChecksOf(radius)) QVERIFY(!check.holds());
    radius.holes.resize(1);
    QVERIFY(shapeChecksOf(radius).empty());
    radius.holes.clear();
    QVERIFY(shapeChecksOf(radius).empty());
  }

  // Statements about certain values are only checked for these.
  void checksOfOtherValues() {
    DrillExperimentResult feed{DrillExperiment::Feed, 1000.0, {madeHole(7.0, 7.0, 7.0), madeHole(10.0, 10.0, 10.0)}};
    QVERIFY(shapeChecksOf(feed).empty());
    feed.holes.front() = madeHole(6.0, 6.0, 6.0);
    QCOMPARE(shapeChecksOf(feed).size(), std::size_t{1});
    QVERIFY(!shapeChecksOf(feed).front().holds());  // all of the line
    DrillExperimentResult fine{DrillExperiment::Resolution, 1000.0, {madeHole(0.1, 1.0, 1.0), madeHole(0.2, 1.0, 1.0)}};
    QCOMPARE(shapeChecksOf(fine).size(), std::size_t{1});
    QVERIFY(shapeChecksOf(fine).front().kind == DrillShapeCheck::Kind::OurRippleByVoxel);
  }

  void drillableValues() {
    for (const DrillExperiment experiment : kDrillExperiments) {
      for (const double value : valuesOf(experiment)) QVERIFY(isDrillable(experiment, value));
      for (const double value : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e300})
        QVERIFY(!isDrillable(experiment, value));
    }
    QVERIFY(!isDrillable(DrillExperiment::Erosion, 256.0));
    QVERIFY(!isDrillable(DrillExperiment::Resolution, 1e-3));  // too many voxels
    QVERIFY(!isDrillable(DrillExperiment::Feed, 1e-9));        // and cycles
    QVERIFY(!isDrillable(DrillExperiment::Resolution, 3.1));   // larger than the radius
    QVERIFY(!isDrillable(DrillExperiment::Feed, 1000.0));      // through in a few cycles
  }

  void names() {
    for (const DrillExperiment experiment : kDrillExperiments) {
      QVERIFY(drillExperimentOf(idOf(experiment)) == experiment);
      const std::vector<double> values = valuesOf(experiment);
      QVERIFY(values.size() > 2 && std::is_sorted(values.begin(), values.end()));
    }
    QVERIFY(!drillExperimentOf("speed"));
  }

  void cancelled() {
    JobState state;
    state.cancelled = true;
    const auto result = runDrillExperiment(DrillExperiment::Feed, {1.0}, Progress(state));
    QVERIFY(!result && result.error().code == ErrorCode::Cancelled);
  }
};

HANDWHEEL_TEST(DrillExperimentsTest)
#include "DrillExperimentsTest.moc"
