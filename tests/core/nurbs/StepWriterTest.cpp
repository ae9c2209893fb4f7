// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/StepWriter.h"

#include "Profiles.h"
#include "TestClass.h"
#include "nurbs/StockCylinder.h"

#include <unistd.h>
#include <QRegularExpression>
#include <QTemporaryFile>
#include <QTest>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <thread>

using namespace handwheel;

class StepWriterTest : public QObject {
  Q_OBJECT

 private slots:
  void cylinder_data();
  void cylinder();
  void holdsTheNinePoleSurface();
  void cone();
  void sphere();
  void shoulders();
  void tube();
  void anyShaft();
  void saysNothing();
  void refuses();
  void stopsWhenCancelled();
  void onTwoThreads();
};

namespace {

StepFileReport reportOn(const ProfileCurve& profile) {
  const auto bytes = writeStep(profile);
  if (!bytes) qFatal("%s", bytes.error().arguments.back().c_str());
  const auto report = inspectStep(*bytes);
  if (!report) qFatal("%s", report.error().arguments.back().c_str());
  return *report;
}

bool near(double found, double expected) {
  return std::abs(found / expected - 1.0) < 1e-7;
}

}  // namespace

void StepWriterTest::cylinder_data() {
  QTest::addColumn<double>("diameter");
  QTest::addColumn<double>("length");
  QTest::addColumn<double>("position");
  QTest::newRow("a bar") << 50.0 << 100.0 << 0.0;
  QTest::newRow("tiny") << 1e-6 << 1e-6 << 0.0;
  QTest::newRow("small") << 1e-3 << 1e-3 << 0.0;
  QTest::newRow("huge") << 1e6 << 1e6 << 0.0;
  QTest::newRow("a wire") << 1.0 << 1e6 << -5e5;
  QTest::newRow("a sheet") << 1e6 << 1.0 << 0.0;
  QTest::newRow("far away") << 50.0 << 100.0 << 1e7;
  QTest::newRow("small and far away") << 0.125 << 0.25 << -1e7;
}

void StepWriterTest::cylinder() {
  QFETCH(double, diameter);
  QFETCH(double, length);
  QFETCH(double, position);
  const StockCylinder stock{diameter, length, position};
  const StepFileReport report = reportOn(stock.profile());
  QVERIFY(report.isValid);
  QCOMPARE(report.solids, std::size_t{1});
  QVERIFY(near(report.volume, M_PI / 4 * diameter * diameter * length));
  QVERIFY(near(report.area, M_PI * diameter * length + M_PI / 2 * diameter * diameter));
  constexpr double kGap = 3e-7;  // the library's tolerance
  for (int axis = 0; axis < 3; ++axis) {
    QVERIFY(std::abs(report.bounds.min()[axis] - stock.bounds().min()[axis]) < kGap);
    QVERIFY(std::abs(report.bounds.max()[axis] - stock.bounds().max()[axis]) < kGap);
  }
}

void StepWriterTest::holdsTheNinePoleSurface() {
  const auto bytes = writeStep(StockCylinder{50, 100, 0}.profile());
  QVERIFY(bytes.hasValue());
  QString text = QString::fromStdString(*bytes);
  QVERIFY(text.startsWith("ISO-10303-21;"));
  QVERIFY(text.contains("AUTOMOTIVE_DESIGN"));
  text.remove(QRegularExpression("\\s"));
  QVERIFY(text.contains("SI_UNIT(.MILLI.,.METRE.)"));
  QVERIFY(text.contains("MANIFOLD_SOLID_BREP"));
  QVERIFY(text.contains("B_SPLINE_SURFACE_WITH_KNOTS((3,2,2,2,3),(2,2),"));
  // Nine columns of two poles.
  const auto nurbs = QRegularExpression("B_SPLINE_SURFACE\\(2,1,\\(((?:\\(#\\d+,#\\d+\\),?)+)\\)").match(text);
  QVERIFY(nurbs.hasMatch());
  QCOMPARE(nurbs.captured(1).count('('), 9);
  // Reals have a point, as the standard demands, and all their digits.
  QVERIFY(!text.contains(QRegularExpression("CARTESIAN_POINT\\('',\\([^)]*[(,]-?\\d+[,)]")));
  QVERIFY(text.contains("7.0710678118654757E-01"));
}

void StepWriterTest::cone() {
  for (const auto& points :
       {std::vector<ProfilePoint>{{10, 0}, {0, 20}}, std::vector<ProfilePoint>{{0, 0}, {10, 20}}}) {
    const StepFileReport report = reportOn(ProfileCurve::polyline(points).value());
    QVERIFY(report.isValid);
    QVERIFY(near(report.volume, M_PI * 100 * 20 / 3));
    QVERIFY(near(report.area, M_PI * 100 + M_PI * 10 * std::sqrt(500.0)));
  }
}

void StepWriterTest::sphere() {
  const StepFileReport report = reportOn(ProfileCurve::make(test::sphere(5, 2)).value());
  QVERIFY(report.isValid);
  QVERIFY(near(report.volume, 4 * M_PI / 3 * 125));
  QVERIFY(near(report.area, 4 * M_PI * 25));
  QVERIFY((report.bounds.min() - Vec3(-5, -5, -3)).norm() < 1e-6);
}

void StepWriterTest::shoulders() {
  const auto profile = ProfileCurve::polyline({{10, 0}, {10, 10}, {4, 10}, {4, 10}, {4, 30}, {8, 30}, {8, 35}}).value();
  const StepFileReport report = reportOn(profile);
  QVERIFY(report.isValid);
  QCOMPARE(report.solids, std::size_t{1});
  QVERIFY(near(report.volume, M_PI * (1000 + 320 + 320)));
  QVERIFY(near(report.area, M_PI * (100 + 200 + 84 + 160 + 48 + 80 + 64)));
}

// A tube with a fillet of radius 3 in its bore: closed, of degree 2, straight lines as such.
void StepWriterTest::tube() {
  const double w = std::sqrt(0.5);
  ProfileNurbs nurbs;
  nurbs.degree = 2;
  nurbs.knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 6};
  nurbs.poles = {{20, 0},  {20, 20}, {20, 40}, {15, 40}, {10, 40},  {10, 31.5}, {10, 23},
                 {10, 20}, {7, 20},  {7, 10},  {7, 0},   {13.5, 0}, {20, 0}};
  nurbs.weights = {1, 1, 1, 1, 1, 1, 1, w, 1, 1, 1, 1, 1};
  const ProfileCurve profile = ProfileCurve::make(nurbs).value();
  QVERIFY(profile.isClosed());
  // The bore: two cylinders and the solid of a quarter circle around (7, 23).
  const double quarter = 49.0 * 3.0 + 14.0 * M_PI * 9.0 / 4.0 + 2.0 * 27.0 / 3.0;
  const double volume = M_PI * (400.0 * 40.0 - 100.0 * 17.0 - quarter - 49.0 * 20.0);
  QVERIFY(near(profile.volume(), volume));
  const auto bytes = writeStep(profile);
  QVERIFY(bytes.hasValue());
  QString text = QString::fromStdString(*bytes);
  text.remove(QRegularExpression("\\s"));
  QCOMPARE(text.count("B_SPLINE_SURFACE(2,1,"), 5);
  QCOMPARE(text.count("B_SPLINE_SURFACE(2,2,"), 1);
  const StepFileReport report = reportOn(profile);
  QVERIFY(report.isValid);
  QCOMPARE(report.solids, std::size_t{1});
  QVERIFY2(near(report.volume, volume), qPrintable(QString::number(report.volume, 'g', 12)));
}

void StepWriterTest::anyShaft() {
  QVERIFY(rc::check("a spline of rising height", [] {
    ProfileNurbs nurbs = test::randomNurbs();
    for (std::size_t i = 0; i < nurbs.poles.size(); ++i) nurbs.poles[i] = {1.0 + nurbs.poles[i].x(), 3.0 * double(i)};
    const ProfileCurve profile = ProfileCurve::make(nurbs).value();
    double volume = 0.0;  // π ∫ r² z' du
    for (std::size_t k = 0; k + 1 < nurbs.knots.size(); ++k) {
      const auto ring = [&](double u) { return std::pow(profile.point(u).x(), 2) * profile.derivative(u).y(); };
      if (nurbs.knots[k] == nurbs.knots[k + 1]) continue;
      volume += M_PI * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(ring, nurbs.knots[k],
                                                                                     nurbs.knots[k + 1], 20, 1e-12);
    }
    RC_ASSERT(std::abs(profile.volume() / volume - 1) < 1e-10);
    const StepFileReport report = reportOn(profile);
    RC_ASSERT(report.isValid);
    RC_ASSERT(report.solids == 1u);
    RC_ASSERT(std::abs(report.volume / volume - 1) < 1e-5);
  }));
}

void StepWriterTest::saysNothing() {
  QTemporaryFile file;
  QVERIFY(file.open());
  std::fflush(stdout);
  const int before = dup(STDOUT_FILENO);
  dup2(file.handle(), STDOUT_FILENO);
  const auto bytes = writeStep(StockCylinder{}.profile());
  const auto report = inspectStep(*bytes);
  std::fflush(stdout);
  dup2(before, STDOUT_FILENO);
  close(before);
  QVERIFY(report.hasValue());
  QCOMPARE(file.size(), 0);
}

void StepWriterTest::refuses() {
  const auto onAxis = writeStep(ProfileCurve::polyline({{0, 0}, {0, 9}}).value());
  QVERIFY(!onAxis);
  QCOMPARE(onAxis.error().code, ErrorCode::ElementMalformed);
  std::vector<ProfilePoint> thread;
  for (int i = 0; i <= 10'001; ++i) thread.emplace_back(10 + i % 2, i);
  const auto tooMany = writeStep(ProfileCurve::polyline(thread).value());
  QVERIFY(!tooMany);
  QCOMPARE(tooMany.error().code, ErrorCode::FileTooLarge);
  for (const char* bytes : {"", "not STEP", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n"}) {
    const auto report = inspectStep(bytes);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::LibraryFailed);
  }
}

void StepWriterTest::stopsWhenCancelled() {
  JobState state;
  state.cancelled = true;
  const auto bytes = writeStep(StockCylinder{}.profile(), Progress(state));
  QVERIFY(!bytes);
  QCOMPARE(bytes.error().code, ErrorCode::Cancelled);
  const auto report = inspectStep(*writeStep(StockCylinder{}.profile()), Progress(state));
  QVERIFY(!report);
  QCOMPARE(report.error().code, ErrorCode::Cancelled);
}

void StepWriterTest::onTwoThreads() {
  std::array<double, 2> volumes{};
  const auto work = [&volumes](std::size_t i) {
    for (int n = 0; n < 10; ++n) volumes[i] = reportOn(StockCylinder{10.0 * double(i + 1), 10, 0}.profile()).volume;
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  QVERIFY(near(volumes[0], M_PI * 250));
  QVERIFY(near(volumes[1], M_PI * 1000));
}

HANDWHEEL_TEST(StepWriterTest)
#include "StepWriterTest.moc"
