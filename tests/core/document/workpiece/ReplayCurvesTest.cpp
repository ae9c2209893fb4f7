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

Q_DECLARE_METATYPE(handwheel::ProfilePoint)

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

  // A move of a program is one stretch of its pass, however long it is. A cylinder of 40 mm turned to 36 mm with 0.2 mm
  // a turn: Fc = 1500 · 2 · 0.2^0.78 = 854.8 N, with 0.7 Fc across it 1043 N; at 600 r/min and a tip at ⌀36, 67.9
  // m/min, that is 1.2085 kW at a motor of 80 %. A face of 1 mm needs half of the force; the chip grows in its first
  // half millimetre, and at ⌀39 it takes 0.6546 kW. A blade of 3 mm in 0.08 mm a turn: 1500 · 3 · 0.08^0.78 = 627.5 N,
  // with 0.7 of it across 766 N, all along its plunge from ⌀40 to ⌀20.
  void theLoadIsSteady_data() {
    QTest::addColumn<QString>("tool");
    QTest::addColumn<double>("feed");
    QTest::addColumn<ProfilePoint>("from");
    QTest::addColumn<ProfilePoint>("to");
    QTest::addColumn<double>("force");
    QTest::addColumn<double>("power");
    QTest::addColumn<double>("within");  // samples of 0.013 mm across 1 mm of a face: one more or less
    QTest::newRow("cylinder") << "" << 0.2 << ProfilePoint(18.8, 101.0) << ProfilePoint(18.8, 20.0) << 1043.4 << 1.2085
                              << 0.005;
    QTest::newRow("face") << "" << 0.2 << ProfilePoint(21.8, 99.8) << ProfilePoint(2.0, 99.8) << 521.7 << 0.6546
                          << 0.015;
    QTest::newRow("plunge") << "parting-3" << 0.08 << ProfilePoint(20.5, 50.0) << ProfilePoint(10.0, 50.0) << 766.0
                            << 0.9857 << 0.015;
  }
  void theLoadIsSteady() {
    QFETCH(QString, tool);
    QFETCH(double, feed);
    QFETCH(ProfilePoint, from);
    QFETCH(ProfilePoint, to);
    QFETCH(double, force);
    QFETCH(double, power);
    QFETCH(double, within);
    TurningPass pass;
    pass.noseRadius = kNose;
    pass.isExact = pass.isOfProgram = true;
    if (!tool.isEmpty()) pass.tool = toolNamed(shippedLatheTools(), tool.toStdString());
    if (pass.tool) pass.noseRadius = pass.tool->noseRadius;
    pass.path = {from, to};
    pass.times = {0.0, (to - from).norm() / (feed * kSpindle / 60.0)};
    pass.speeds = {kSpindle, kSpindle};
    WorkpieceSnapshot work;
    work.stock = {40.0, 100.0, 0.0};
    work.part = withPasses(work, {pass}, 0.013);
    const auto track = replayCurves(work);
    QVERIFY(track && track->loads.size() >= 20);
    double largest = 0.0, strongest = 0.0;
    int steady = 0;
    for (const CutLoad& load : track->loads) {
      largest = std::max(largest, load.force);
      strongest = std::max(strongest, load.power);
      steady += std::abs(load.force / force - 1.0) < 0.03 ? 1 : 0;
    }
    QVERIFY2(std::abs(largest / force - 1.0) < within, qPrintable(QString::number(largest)));
    QVERIFY2(std::abs(strongest / power - 1.0) < within, qPrintable(QString::number(strongest)));
    // All but the begin and the end.
    QVERIFY2(steady + 5 >= static_cast<int>(track->loads.size()), qPrintable(QString::number(steady)));
    QVERIFY(track->loads.front().time < 0.2 * track->replay->duration());
    const auto peaks = loadPeaks(work, nullptr, WorkMaterials::standard().called(work.material), {});
    QVERIFY(peaks && peaks->force == largest && peaks->power == strongest);
  }

  // A groove of 60° that is 0.5 mm deep, with a nose of 0.05 mm: its sides meet 0.05 mm below it, so that the chip has
  // 0.55² tan 30° - 0.05² (√3 - π/3) = 0.1729 mm² along 2 · (0.55 / cos 30° - 0.05 √3) + 0.05 · 2π/3 = 1.202 mm of the
  // edge. Fc = 1500 · 1.202 · (0.1729 / 1.202)^0.78 = 397 N, with 0.7 Fc across it 485 N.
  void aThreadHasAForce() {
    TurningPass pass;
    pass.noseRadius = 0.05;
    pass.isExact = pass.isOfProgram = true;
    pass.path = {{19.55, 103.0}, {19.55, 70.0}};
    pass.times = {0.0, 2.2};  // 1.5 mm a turn at 600 r/min
    pass.speeds = {kSpindle, kSpindle};
    pass.thread = ThreadCut();
    pass.thread->pitch = 1.5;
    WorkpieceSnapshot work;
    work.stock = {40.0, 100.0, 0.0};
    work.part = withPasses(work, {pass}, 0.013);
    const auto track = replayCurves(work);
    QVERIFY(track && track->loads.size() >= 18);
    for (std::size_t i = 1; i + 1 < track->loads.size(); ++i) {
      QVERIFY2(std::abs(track->loads[i].force / 485.0 - 1.0) < 0.03,
               qPrintable(QString::number(track->loads[i].force)));
      QVERIFY(track->loads[i].time > 0.1 && track->loads[i].time <= 2.2);
    }
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
