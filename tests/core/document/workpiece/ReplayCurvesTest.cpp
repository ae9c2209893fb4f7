// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/ReplayCurves.h"

#include "TestClass.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/target/DeviationDisplay.h"
#include "machining/lathe/LatheJson.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;

namespace {

constexpr double kNose = 0.8, kFeed = 0.2, kSpindle = 600.0;  // mm, mm in a turn, r/min
constexpr double kLower = 5.0;                                // mm, where the passes end

// Along the bar at a radius, point by point each millimetre.
TurningPass passAt(double radius) {
  TurningPass pass;
  pass.noseRadius = kNose;
  for (int i = 0; 102.0 - i >= kLower; ++i) {
    pass.path.emplace_back(radius + kNose, 102.0 - i);
    pass.times.push_back(i / (kFeed * kSpindle / 60.0));
    pass.speeds.push_back(kSpindle);
  }
  return pass;
}

// A bar of 40 mm that becomes one of 36 mm in two passes, as far as it is out of the chuck.
WorkpieceSnapshot turnedDown() {
  WorkpieceSnapshot work;
  work.stock = {40.0, 100.0, 7.0};
  work.part = withPasses(work, {passAt(19.0), passAt(18.0)}, 0.05);
  auto target = TargetProfile::make({{{18.0, 7.0}, {18.0, 107.0}}});
  work.target = std::make_shared<const WorkpieceTarget>(WorkpieceTarget{std::move(target.value()), "cylinder"});
  return work;
}

}  // namespace

// The curves on the time line of a replay.
class ReplayCurvesTest : public QObject {
  Q_OBJECT

 private slots:
  // 1 mm deep, 0.2 mm in a turn, at the surface speed of the bar. By Kienzle's law that is Fc = 1500 · 1 · 0.2^0.78 N
  // and 0.7 Fc across it. A tool of 95° with a rake of -6° needs 6 % more, and 1 / sin(95°)^0.22. It is the resultant
  // that the panel shows.
  void theForceIsThatOfTheCut_data() {
    QTest::addColumn<bool>("hasTool");
    QTest::newRow("of a nose") << false;
    QTest::newRow("of a known tool") << true;
  }
  void theForceIsThatOfTheCut() {
    QFETCH(bool, hasTool);
    WorkpieceSnapshot work = turnedDown();
    if (hasTool) {
      std::vector<TurningPass> passes{passAt(19.0), passAt(18.0)};
      for (TurningPass& pass : passes) {
        pass.tool = toolNamed(shippedLatheTools(), "right-roughing");
        for (ProfilePoint& p : pass.path) p -= pass.tool->noseCentre();
      }
      work.part = nullptr;
      work.part = withPasses(work, passes, 0.05);
    }
    const auto track = replayCurves(work);
    QVERIFY(track);
    const double edge = hasTool ? 1.06 * std::pow(std::sin(95.0 * M_PI / 180.0), -0.22) : 1.0;
    const double cutting = 1500.0 * std::pow(kFeed, 0.78) * edge, wanted = std::sqrt(1.49) * cutting;
    const auto middle =
        std::find_if(track->loads.begin(), track->loads.end(), [](const CutLoad& load) { return load.time > 20.0; });
    QVERIFY(middle != track->loads.end());
    QVERIFY2(std::abs(middle->force / wanted - 1.0) < 0.02, qPrintable(QString::number(middle->force / wanted)));
    // v = π d n, and 80 % of the motor's power come to the cut.
    QVERIFY(std::abs(0.8 * middle->power - cutting * M_PI * 0.040 * kSpindle / 60.0 / 1000.0) < 0.02 * middle->power);
    QVERIFY(track->loads.back().time <= track->replay->duration());
  }

  // 2 mm are over the target at first, 1 mm after the first pass, none at the end, and nothing was cut too deep.
  void theDeviationFalls() {
    const auto track = replayCurves(turnedDown());
    QVERIFY(track && track->deviation);
    const auto& left = track->deviation->left;
    QVERIFY(left.front().first == 0.0 && std::abs(left.front().second - 2.0) < 1e-6);
    QVERIFY(std::abs(left.back().first - track->replay->duration()) < 1e-9 && left.back().second < 1e-6);
    const auto second =
        std::find_if(left.begin(), left.end(), [&](const auto& at) { return at.first > track->replay->begin(1); });
    QVERIFY(std::abs(second->second - 1.0) < 1e-6);
    QVERIFY(std::is_sorted(left.rbegin(), left.rend(),
                           [](const auto& a, const auto& b) { return a.second < b.second - 1e-9; }));
    for (const auto& [seconds, mm] : track->deviation->deep) QVERIFY(mm < 1e-6);
    WorkpieceSnapshot aimless = turnedDown();
    aimless.target = nullptr;
    QVERIFY(!replayCurves(aimless)->deviation);
  }

  // The passes begin with the samples of the part: 50 mm at 0.013 mm are 3847 steps, at the spacing of these 3848.
  void theEndIsThePart() {
    WorkpieceSnapshot work;
    work.stock = {40.0, 50.0, 0.0};
    work.part = withPasses(work, {passAt(19.0)}, 0.013);
    QVERIFY(std::ceil(50.0 / work.part->profile.spacing()) > static_cast<double>(work.part->profile.size() - 1));
    const auto track = replayCurves(work);
    QVERIFY(track && track->replay->at(track->replay->duration()).profile == work.part->profile);
  }

  // A crash of the lathe ended its pass; that of a program is at a point of its path; files of older programs have no
  // times.
  void crashesAreMarked() {
    WorkpieceSnapshot work = turnedDown();
    LatheCollision older, lathe, program;
    lathe.passes = 1.0;
    program.passes = 2.0;
    program.position = passAt(18.0).path[10];
    addCrashes(work, std::vector{older, program, lathe});
    const auto track = replayCurves(work);
    QVERIFY(track && track->crashes.size() == 3);
    QCOMPARE(track->crashes[0].seconds, track->replay->begin(1));
    QVERIFY(std::abs(track->crashes[1].seconds - (track->replay->begin(1) + 10.0 / (kFeed * kSpindle / 60.0))) < 1e-9);
    QCOMPARE(track->crashes[2].seconds, track->replay->duration());
    QVERIFY(track->crashes[2].collision == older);
  }

  // Ra = f²/(32 R) where the part was cut, and not known where it is bar.
  void theFinishInColours() {
    const WorkpieceSnapshot work = turnedDown();
    const float wanted = static_cast<float>(1000.0 * kFeed * kFeed / (32.0 * kNose));  // µm
    int known = 0, unknown = 0;
    const DisplayModel model = finishDisplay(work, [&](std::optional<double> roughness) {
      (roughness ? known : unknown) += 1;
      return std::array<float, 3>{roughness ? static_cast<float>(*roughness) : -1.0f, 0.0f, 0.0f};
    });
    QVERIFY(known > 0 && unknown > 0);
    // Neighbours of one colour are one part.
    QVERIFY(static_cast<int>(model.parts.size()) < (known + unknown) / 2);
    double fine = 0.0, bare = 0.0;  // mm along the axis
    for (const DisplayPart& part : model.parts) {
      Box box;
      for (const Vec3& p : part.soup->points) box.extend(part.pose * p);
      const double length = box.sizes().z();
      if (part.colour[0] < 0.0f) bare += length;
      if (std::abs(part.colour[0] - wanted) < 0.05f * wanted) fine += length;
    }
    QVERIFY2(fine > 90.0 && fine < 97.0, qPrintable(QString::number(fine)));
    QVERIFY2(bare > 3.0 && bare < 6.0, qPrintable(QString::number(bare)));
  }
};

HANDWHEEL_TEST(ReplayCurvesTest)
#include "ReplayCurvesTest.moc"
