// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/refit/Refit.h"

#include "TestClass.h"
#include "machining/refit/ArcNurbs.h"
#include "nurbs/StepWriter.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr StockCylinder kRefitBlank{40.0, 100.0, 0.0};

double anyLength(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

std::vector<ProfileSegment> outsideOf(const TurnedProfile& part, double chord) {
  return refitted(outlinesOf(part).at(0).sides.at(0), chord, part.spacing());
}

ProfileCurve solidOf(const TurnedProfile& part, double chord) {
  const auto curves = curvesOf(outlinesOf(part).at(0), chord, part.spacing(), 0.0);
  if (!curves) qFatal("no curve");
  return curves->outside;
}

bool isPlacedAt(const ProfilePoint& a, double r, double z) {
  return (a - ProfilePoint(r, z)).norm() < 1e-6;
}

// Returns the distance of a point from a chain of segments, by points all along them.
double gapTo(const std::vector<ProfileSegment>& segments, const ProfilePoint& p) {
  double least = 1e9;
  for (const ProfileSegment& s : segments) least = std::min(least, (s.nearest(p) - p).norm());
  return least;
}

}  // namespace

class RefitTest : public QObject {
  Q_OBJECT

 private slots:
  // Exact surfaces of the tools are found to the last digits, corners between two samples included: a shoulder with the
  // fillet of a nose of radius 1 at z = 60.0037, and a plunge of radius 3 with its walls.
  void exactGeometry() {
    TurnedProfile part(kRefitBlank, 0.013);
    part.cut({18.0, 120.0}, {18.0, 60.0037}, 1.0);
    part.cut({25.0, 30.0041}, {15.0, 30.0041}, 3.0);
    const auto found = outsideOf(part, 0.005);
    QCOMPARE(found.size(), std::size_t{8});
    QVERIFY(isPlacedAt(found[0].from, 20.0, 0.0) && isPlacedAt(found[0].to, 20.0, 27.0041) && !found[0].isArc());
    QVERIFY(isPlacedAt(found[1].to, 15.0, 27.0041));
    QVERIFY(isPlacedAt(found[2].to, 15.0, 33.0041) && std::abs(found[2].radius() - 3.0) < 1e-6);
    QVERIFY(isPlacedAt(found[3].to, 20.0, 33.0041));
    QVERIFY(isPlacedAt(found[4].to, 20.0, 59.0037));
    QVERIFY(isPlacedAt(found[5].to, 18.0, 59.0037));
    QVERIFY(isPlacedAt(found[6].to, 17.0, 60.0037) && std::abs(found[6].radius() - 1.0) < 1e-5);
    QVERIFY(isPlacedAt(found[7].to, 17.0, 100.0) && !found[7].isArc());
  }

  // 100,000 samples of a shaft become a handful of segments, and the marks of 3000 plunges few enough.
  void fewSegments() {
    TurnedProfile shaft(kRefitBlank, 0.001);
    QCOMPARE(outsideOf(shaft, 0.005).size(), std::size_t{1});
    shaft.cut({18.0, 120.0}, {18.0, 60.0037}, 1.0);
    QCOMPARE(shaft.size(), std::size_t{100'001});
    QCOMPARE(outsideOf(shaft, 0.005).size(), std::size_t{4});
    for (int i = 0; i < 3000; ++i) {
      const double z = 5.0 + 0.03 * i, r = 17.0 + 2.0 * std::sin(0.2 * z);
      shaft.cut({25.0, z}, {r, z}, 1.0);
    }
    const auto marked = outsideOf(shaft, 0.005);
    QVERIFY2(marked.size() < 60, qPrintable(QString::number(marked.size())));
  }

  void withinTheTolerance() {
    QVERIFY(rc::check("each sample is within the chord of the curve, and nothing is across the axis", [] {
      TurnedProfile part(kRefitBlank, 0.1);
      const int cuts = *rc::gen::inRange(0, 25);
      for (int i = 0; i < cuts; ++i) {
        const ProfilePoint a(anyLength(-2.0, 25.0), anyLength(-5.0, 105.0)),
            b(a + ProfilePoint(anyLength(-3, 3), anyLength(-9, 9)));
        part.cut(a, b, anyLength(0.2, 5.0));
      }
      const double chord = anyLength(1e-4, 0.2);
      for (const TurnedOutline& outline : outlinesOf(part)) {
        const auto& side = outline.sides.at(0);
        const auto segments = refitted(side, chord, part.spacing());
        RC_ASSERT(segments.front().from == side.front() && segments.back().to == side.back());
        for (std::size_t i = 1; i < segments.size(); ++i) RC_ASSERT(segments[i].from == segments[i - 1].to);
        for (const ProfilePoint& p : side) RC_ASSERT(gapTo(segments, p) <= chord + 1e-6);
        for (const ProfileSegment& s : segments) RC_ASSERT(s.box().min().x() >= -1e-9);
        RC_ASSERT(ProfileCurve::make(nurbsOf(segments)).hasValue());
      }
    }));
  }

  // The curve of degree 2 is the very lines and arcs.
  void theNetIsExact() {
    QVERIFY(rc::check("points of the curve are on the segments, and those of the segments on the curve", [] {
      std::vector<ProfileSegment> segments;
      ProfilePoint at(anyLength(5.0, 20.0), 0.0);
      for (int i = 0; i < 6; ++i) {
        const ProfilePoint to(anyLength(5.0, 20.0), at.y() + anyLength(0.5, 8.0));
        const bool isArc = *rc::gen::inRange(0, 2) == 1;
        segments.push_back({at, to, isArc ? anyLength(-0.4, 0.4) : 0.0});
        at = to;
      }
      const ProfileCurve curve = ProfileCurve::make(nurbsOf(segments)).value();
      RC_ASSERT(curve.nurbs().degree == 2);
      for (int i = 0; i <= 500; ++i) {
        const double u = curve.from() + (curve.to() - curve.from()) * i / 500.0;
        RC_ASSERT(gapTo(segments, curve.point(u)) < 1e-9);
      }
      double moment = 0.0;
      for (const ProfileSegment& s : segments) moment += s.squareMoment();
      RC_ASSERT(std::abs(curve.volume() / (M_PI * moment) - 1.0) < 1e-9);
    }));
  }

  // A wine glass of a kind: valid for Open CASCADE, its volume that of the profile.
  void solids_data() {
    QTest::addColumn<int>("shape");
    QTest::newRow("a shaft with a shoulder") << 0;
    QTest::newRow("marks of 500 plunges") << 1;
    QTest::newRow("a bush, bored through") << 2;
    QTest::newRow("a cup") << 3;
    QTest::newRow("a ball that is parted off") << 4;
  }
  void solids() {
    QFETCH(int, shape);
    TurnedProfile part(kRefitBlank, 0.013);
    if (shape == 0) part.cut({18.0, 120.0}, {18.0, 60.0037}, 1.0);
    for (int i = 0; shape == 1 && i < 500; ++i) {
      const double z = 10.0 + 0.15 * i;
      part.cut({25.0, z}, {17.0 + 2.0 * std::sin(0.2 * z), z}, 1.0);
    }
    for (std::size_t i = 0; shape == 2 && i < part.size(); ++i) part.limitInner(i, 8.0);
    if (shape == 2) part.cutBore({11.0, 120.0}, {11.0, 40.0051}, 1.0);
    for (std::size_t i = 0; shape == 3 && i < part.size(); ++i) {
      const double z = part.z(i);
      part.limitOuter(i, z > 40.0 ? 19.0 + std::sin(0.1 * z) : 4.0 + 14.0 * std::exp(-0.3 * z));
      if (z > 44.0) part.limitInner(i, std::min(16.0, 4.0 * std::sqrt(z - 44.0)));
    }
    for (std::size_t i = 0; shape == 4 && i < part.size(); ++i) {
      const double z = part.z(i) - 50.0;
      part.limitOuter(i, std::sqrt(std::max(0.0, 400.0 - z * z)));
    }
    const ProfileCurve curve = solidOf(part, 0.005);
    // The marks of feed are crests, over which the tolerance is all on one side.
    const double most = shape == 1 ? 6e-4 : 1e-4;
    QVERIFY2(std::abs(curve.volume() / part.volume() - 1.0) < most, qPrintable(QString::number(curve.volume())));
    const auto bytes = writeStep(curve);
    QVERIFY(bytes);
    const auto report = inspectStep(*bytes);
    QVERIFY(report && report->isValid);
    QCOMPARE(report->solids, std::size_t{1});
    QVERIFY(std::abs(report->volume / curve.volume() - 1.0) < 1e-6);
  }
};

HANDWHEEL_TEST(RefitTest)
#include "RefitTest.moc"
