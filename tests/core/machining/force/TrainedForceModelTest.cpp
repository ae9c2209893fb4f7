// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/TrainedForceModel.h"

#include "CancelPoints.h"
#include "TestClass.h"
#include "machining/force/ForceCsv.h"
#include "machining/force/training/ForceTraining.h"

#include <rapidcheck.h>

#include <QFile>
#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

// The law that the shipped model was trained on, from the handbook's constants.
double handbookForce(const CutConditions& cut) {
  return 3000.0 * std::pow(650.0 / 750.0, 0.75) * cut.depth * std::pow(cut.feed, 0.75) * std::pow(cut.speed, -0.15);
}

double within(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

CutConditions anyTaught() {
  return {within(0.2, 3.0), within(0.05, 0.4), within(30.0, 200.0)};
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == text.npos ? std::string() : text.replace(at, from.size(), to);
}

}  // namespace

// A trained network as a law of forces: its range, its file, its cost.
class TrainedForceModelTest : public QObject {
  Q_OBJECT

 private slots:
  void shippedModelIsLabelled() {
    const TrainedForceModel model = shippedForceModel();
    QVERIFY(model.origin().isSynthetic);
    QCOMPARE(model.origin().material, std::string("medium-carbon-steel"));
    QVERIFY(model.origin().data.find("Calculated") == 0);
    QVERIFY(model.origin().cuts >= 240);
  }

  // Within the range as the handbook's law, within 3 %; on the average, within 0.5 %.
  void shippedModelIsTheLawItWasTaught() {
    const TrainedForceModel model = shippedForceModel();
    double sum = 0.0;
    int count = 0;
    rc::check([&] {
      const CutConditions cut = anyTaught();
      const double error = std::abs(model.at(cut).cutting / handbookForce(cut) - 1.0);
      RC_ASSERT(model.covers(cut) && error < 0.03);
      sum += error;
      ++count;
    });
    QVERIFY(sum / count < 0.005);
  }

  // Rising with feed and depth, falling with speed, and linear in the depth from 0.6 to 1.3 mm.
  void surfaceHasItsShape() {
    const TrainedForceModel model = shippedForceModel();
    const auto force = [&](double d, double f, double v) { return model.at({d, f, v}).cutting; };
    for (double d = 0.4; d <= 2.8; d += 0.2) {
      for (double f = 0.06; f < 0.3; f += 0.02) {
        for (double v = 40.0; v <= 180.0; v += 20.0) {
          QVERIFY(force(d, f + 0.01, v) > force(d, f, v));
          QVERIFY(force(d + 0.1, f, v) > force(d, f, v));
          QVERIFY(force(d, f, v + 10.0) < force(d, f, v));
        }
      }
    }
    // Steep, by ratio, where it is shallow.
    QVERIFY(force(0.6, 0.2, 100) / force(0.4, 0.2, 100) > 1.4);
    for (double d = 0.6; d <= 1.3; d += 0.05) {
      const double chord = force(0.6, 0.2, 100) + (d - 0.6) / 0.7 * (force(1.3, 0.2, 100) - force(0.6, 0.2, 100));
      QVERIFY(std::abs(force(d, 0.2, 100) / chord - 1.0) < 0.02);
    }
  }

  // Beyond the rim the force is that of the power law, to the bit, and it says so.
  void fallsBackToThePowerLaw() {
    const TrainedForceModel model = shippedForceModel();
    rc::check([&] {
      CutConditions cut = anyTaught();
      const int side = *rc::gen::inRange(0, 4);
      if (side == 0) cut.depth = within(3.2, 50.0);
      if (side == 1) cut.depth = within(1e-9, 0.05);
      if (side == 2) cut.feed = within(0.45, 5.0);
      if (side == 3) cut.speed = within(210.0, 5000.0);
      RC_ASSERT(!model.covers(cut));
      RC_ASSERT(model.at(cut).cutting == model.powerLaw().at(cut));
    });
  }

  // No step anywhere, not at the border either: the hand would feel it.
  void forceIsContinuous() {
    const TrainedForceModel model = shippedForceModel();
    for (const double speed : {31.0, 100.0, 199.0}) {
      double before = model.at({0.001, 0.2, speed}).cutting;
      for (double depth = 0.001; depth < 4.0; depth += 0.001) {
        const double now = model.at({depth, 0.2, speed}).cutting;
        QVERIFY(std::abs(now - before) < 3.0);  // 3 N in a micrometre: four times the mean slope
        before = now;
      }
    }
  }

  void extremesGiveFiniteForces() {
    const TrainedForceModel model = shippedForceModel();
    constexpr double kOdd[] = {0.0,
                               -1.0,
                               1e-300,
                               1e-9,
                               1.0,
                               1e9,
                               1e300,
                               std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()};
    for (const double d : kOdd)
      for (const double f : kOdd)
        for (const double v : kOdd) {
          const CutForces forces = model.at({d, f, v});
          QVERIFY(std::isfinite(forces.norm()) && forces.cutting >= 0 && forces.feed >= 0 && forces.radial >= 0);
          if (!(d > 0.0) || !(f > 0.0) || !(v >= 0.0)) QCOMPARE(forces.norm(), 0.0);
        }
  }

  // The servo loop calls it.
  void allocatesNothing() {
    const TrainedForceModel model = shippedForceModel();
    double sum = 0.0;
    std::size_t allocations = 0;
    {
      const test::CancelPoint count;
      for (int i = 1; i < 1000; ++i) sum += model.at({0.005 * i, 0.2, 100.0}).norm();
      allocations = count.allocations();
    }
    QVERIFY(sum > 0.0);
    QCOMPARE(allocations, std::size_t(0));
  }

  void fileGivesTheSameModel() {
    const TrainedForceModel model = shippedForceModel();
    const std::string text = toJson(model);
    const auto read = forceModelFromJson(text);
    QVERIFY(read);
    QCOMPARE(toJson(*read), text);
    QCOMPARE(read->network().weights, model.network().weights);
    QVERIFY(read->origin() == model.origin());
    QCOMPARE(read->at({1.0, 0.2, 100.0}), model.at({1.0, 0.2, 100.0}));
  }

  void refusesHostileFiles_data() {
    const std::string good = toJson(shippedForceModel());
    QTest::addColumn<QByteArray>("text");
    const auto row = [](const char* name, const std::string& text) {
      QVERIFY2(!text.empty(), name);
      QTest::newRow(name) << QByteArray::fromStdString(text);
    };
    row("not JSON", "{");
    row("deep", std::string(100'000, '['));
    row("no object", "[1]");
    row("another format", "{\"format\": \"mesh\"}");
    row("long", good + std::string(kMostModelBytes, ' '));
    row("newer", changed(good, "\"version\": 1", "\"version\": 2"));
    row("older", changed(good, "\"version\": 1", "\"version\": 0"));
    row("law beyond its range",
        changed(good, "\"power_law_lnC_x_y_n\": [\n", "\"power_law_lnC_x_y_n\": [101,1,1,1],\"a\":[\n"));
    row("many neurons", changed(good, "\"hidden\": 10", "\"hidden\": 4000000000"));
    row("no neurons", changed(good, "\"hidden\": 10", "\"hidden\": 0"));
    row("wrong count", changed(good, "\"hidden\": 10", "\"hidden\": 9"));
    row("word for a weight", changed(good, "\"weights\": [", "\"weights\": [\"a\","));
    row("huge weight", changed(good, "\"weights\": [", "\"weights\": [1e300,"));
    row("negative range", changed(good, "\"input_least\": [", "\"input_least\": [-1,"));
    row("range turned round", changed(good, "\"input_largest\": [\n  3", "\"input_largest\": [\n  0.1"));
    row("no law", changed(good, "power_law_lnC_x_y_n", "law"));
    row("steep law", changed(good, "\"power_law_lnC_x_y_n\": [\n", "\"power_law_lnC_x_y_n\": [1,99,1,1],\"a\":[\n"));
  }
  void refusesHostileFiles() {
    QFETCH(QByteArray, text);
    const auto read = forceModelFromJson(text.toStdString());
    QVERIFY(!read);
    QVERIFY(read.error().code->id != nullptr && !read.error().arguments.empty());
  }

  // Trained without one of the three depths, its cuts are outside: never worse than the power law.
  void leftOutDepthsAreNotWorse() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
    if (data.isEmpty()) QSKIP("HANDWHEEL_DATA is not set: no measured cuts");
    QFile file(data + "/lathe/turning-roughness-forces/Exp1.csv");
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto table = forceSamplesFromCsv(file.readAll().toStdString());
    QVERIFY(table);
    for (const double depth : {0.25, 0.8}) {
      ForceSamples others;
      std::vector<ForceSample> left;
      for (const ForceSample& sample : table->samples)
        (sample.cut.depth == depth ? left : others.samples).push_back(sample);
      QCOMPARE(left.size(), std::size_t(18));
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        TrainingOptions options;
        options.seed = seed;
        const auto training = trainForceModel(others, options, {});
        QVERIFY(training);
        const PowerLaw law = fittedPowerLaw(others.samples);
        for (const ForceSample& sample : left) {
          const double ours = std::abs(training->model.at(sample.cut).cutting - sample.force);
          QVERIFY(!training->model.covers(sample.cut));
          QVERIFY(ours <= std::abs(law.at(sample.cut) - sample.force) + 1e-9);
        }
      }
    }
  }
};

HANDWHEEL_TEST(TrainedForceModelTest)
#include "TrainedForceModelTest.moc"
