// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/PartDrawing.h"

#include "../target/AnyProfile.h"
#include "TestClass.h"
#include "machining/drawing/Dimensions.h"

#include <QRegularExpression>
#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;

namespace {

TargetProfile along(const std::vector<ProfilePoint>& points) {
  std::vector<ProfileSegment> all;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) all.push_back({points[i], points[i + 1], 0.0});
  return TargetProfile::make(std::move(all)).value();
}

// With a fillet, a chamfer, a taper and a blind bore.
TargetProfile part() {
  return TargetProfile::make({{{0, 0}, {20, 0}, 0.0},
                              {{20, 0}, {20, 30}, 0.0},
                              {{20, 30}, {15, 30}, 0.0},
                              arcAround({15, 33}, 3, -M_PI / 2, -M_PI),
                              {{12, 33}, {12, 60}, 0.0},
                              {{12, 60}, {10, 80}, 0.0},
                              {{10, 80}, {10, 88}, 0.0},
                              {{10, 88}, {8, 90}, 0.0},
                              {{8, 90}, {5, 90}, 0.0},
                              {{5, 90}, {5, 65}, 0.0},
                              {{5, 65}, {0, 65}, 0.0}})
      .value();
}

bool hasText(const Sheet& sheet, const std::string& wanted) {
  return std::any_of(sheet.texts.begin(), sheet.texts.end(), [&](const auto& t) { return t.text == wanted; });
}

// A part turned by hand: a shaft with two shoulders whose surface goes in and out by up to `waviness`, every 0.3 mm.
TargetProfile byHand(double waviness) {
  std::vector<ProfilePoint> points{{12, 0}};
  for (int i = 1; i <= 300; ++i) {
    const double z = 0.3 * i, size = i < 100 ? 12.0 : i < 200 ? 10.0 : 7.0;
    if (i == 100 || i == 200) points.emplace_back(size, points.back().y());
    points.emplace_back(size + waviness * std::sin(7.0 * i) * std::cos(3.1 * i), z);
  }
  return along(points);
}

// Pairs of texts that are on one another.
QStringList overlaps(const Sheet& sheet) {
  QStringList found;
  for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
    for (std::size_t k = i + 1; k < sheet.texts.size(); ++k) {
      const ProfileBox common = sheet.texts[i].box().intersection(sheet.texts[k].box());
      if (common.sizes().minCoeff() > 1e-9)
        found << QString::fromStdString(sheet.texts[i].text + " on " + sheet.texts[k].text);
    }
  }
  return found;
}

// All texts of the dimensions of a part, in order.
QStringList dimensionTexts(std::vector<ProfileSegment> segments) {
  const TargetProfile drawn = TargetProfile::make(std::move(segments)).value();
  QStringList texts;
  for (const Sheet::Text& text : dimensionSheet(drawn, {}, {}).texts) texts << QString::fromStdString(text.text);
  texts.sort();
  return texts;
}

QStringList inOrder(QStringList texts) {
  texts.sort();
  return texts;
}

std::size_t countOf(const Sheet& sheet, const std::string& start) {
  return static_cast<std::size_t>(
      std::count_if(sheet.texts.begin(), sheet.texts.end(), [&](const auto& t) { return t.text.starts_with(start); }));
}

}  // namespace

class PartDrawingTest : public QObject {
  Q_OBJECT

 private slots:
  // Without the part there are the same dimensions, where the part is shown otherwise: none within its outline at the
  // bottom, all texts apart.
  void dimensionsAlone() {
    const DrawingTitle title{"Bolt", "C45", {}, 1e-3, {}, {}};
    DrawingLayout layout;
    layout.scale = 1.6;
    const Sheet whole = drawingSheet(part(), title), alone = dimensionSheet(part(), title, layout);
    for (const char* const text : {"Ø40", "Ø24", "Ø20", "Ø10", "R3", "90", "30"})
      QVERIFY2(hasText(alone, text) && hasText(whole, text), text);
    QVERIFY(!hasText(alone, "Bolt") && overlaps(alone).isEmpty());
    QVERIFY(alone.box().min().y() < -1.6 * 20.0 && alone.box().min().x() <= 0.0);
    QVERIFY(std::none_of(alone.strokes.begin(), alone.strokes.end(),
                         [](const auto& each) { return each.line == Sheet::Line::Wide; }));
  }

  void hasItsDimensions() {
    const Sheet sheet = drawingSheet(part(), {"Bolt", "C45", {}, 1e-3, {}, {}});
    for (const char* text : {"Ø40", "Ø24", "Ø20", "Ø10", "R3", "2×45°", "Bolt", "C45", "A4", "mm"})
      QVERIFY2(hasText(sheet, text), text);
    // The scale is that of the axis, which is drawn 5 mm beyond both ends.
    for (const Sheet::Stroke& s : sheet.strokes) {
      const bool isAxis = s.line == Sheet::Line::Centre && s.curve.length() > 20.0;
      if (isAxis) QVERIFY(hasText(sheet, scaleText((s.curve.length() - 10.0) / 90.0)));
    }
    // The angle between the sides of the taper, 2 atan(2 / 20).
    QVERIFY(hasText(sheet, "∠11.42°"));
    // From the upper end: the shoulder at 30, the tapers, the whole; and the bore.
    for (const char* text : {"10", "30", "60", "90", "25"}) QVERIFY2(hasText(sheet, text), text);
  }

  // Each size stands once (ISO 129-1), and none that follows from others. The expectations are the sizes that a person
  // needs to draw the part again.
  void eachSizeOnce() {
    // Fillets of 5 mm, as of a cutter: the shoulders say where they are.
    QCOMPARE(dimensionTexts({{{0, 0}, {20, 0}, 0.0},
                             {{20, 0}, {20, 40}, 0.0},
                             arcAround({20, 45}, 5, -M_PI / 2, -M_PI),
                             {{15, 45}, {15, 56}, 0.0},
                             arcAround({15, 61}, 5, -M_PI / 2, -M_PI),
                             {{10, 61}, {10, 100}, 0.0}}),
             inOrder({"Ø40", "Ø30", "Ø20", "2×R5", "44", "60", "100"}));
    // A chamfer between two cylinders: its height at the larger one. At an edge of a face it needs none.
    QCOMPARE(dimensionTexts({{{0, 0}, {18, 0}, 0.0},
                             {{18, 0}, {18, 20}, 0.0},
                             {{18, 20}, {15, 23}, 0.0},
                             {{15, 23}, {15, 47}, 0.0},
                             {{15, 47}, {12, 50}, 0.0}}),
             inOrder({"Ø36", "Ø30", "2× 3×45°", "30", "50"}));
    // A groove interrupts a cylinder. Behind a collar there is another cylinder.
    QCOMPARE(dimensionTexts({{{0, 0}, {10, 0}, 0.0},
                             {{10, 0}, {10, 20}, 0.0},
                             {{10, 20}, {8, 20}, 0.0},
                             {{8, 20}, {8, 24}, 0.0},
                             {{8, 24}, {10, 24}, 0.0},
                             {{10, 24}, {10, 40}, 0.0}}),
             inOrder({"Ø20", "Ø16", "16", "20", "40"}));
    QCOMPARE(dimensionTexts({{{0, 0}, {10, 0}, 0.0},
                             {{10, 0}, {10, 20}, 0.0},
                             {{10, 20}, {12, 20}, 0.0},
                             {{12, 20}, {12, 24}, 0.0},
                             {{12, 24}, {10, 24}, 0.0},
                             {{10, 24}, {10, 40}, 0.0}}),
             inOrder({"Ø20", "Ø20", "Ø24", "16", "20", "40"}));
    // A ball of 10 mm between two necks: the height of its centre, and no other.
    const double half = std::atan2(8.0, 6.0);
    QCOMPARE(dimensionTexts({{{0, 0}, {6, 0}, 0.0},
                             {{6, 0}, {6, 22}, 0.0},
                             arcAround({0, 30}, 10, -half, half),
                             {{6, 38}, {6, 50}, 0.0}}),
             inOrder({"Ø12", "Ø12", "SR10", "20", "50"}));
    // An arc that touches nothing: the heights and diameters of its ends, but for the cylinder's.
    QCOMPARE(dimensionTexts({{{0, 0}, {10, 0}, 0.0},
                             {{10, 0}, {10, 20}, 0.0},
                             *arcThrough({10, 20}, {12.2, 29.5}, {14, 40}),
                             {{14, 40}, {8, 40}, 0.0},
                             {{8, 40}, {8, 50}, 0.0}})
                 .filter(QRegularExpression("^[Ø0-9]")),
             inOrder({"Ø20", "Ø28", "Ø16", "10", "30", "50"}));
    // A bulge: its radius, its largest diameter and the height of that.
    QCOMPARE(dimensionTexts({arcAround({-30, 20}, 50, -std::asin(0.4), std::asin(0.4))}),
             inOrder({"20", "40", "R50", "Ø40"}));
  }

  // A material with a long name goes on in a second line; only what has no room there either is cut.
  void longTextsOfTheTitle() {
    const auto textsOf = [](const std::string& material) {
      return drawingSheet(along({{20, 0}, {20, 50}}), {"Bolt", material, {}, 1e-3, {}, {}});
    };
    const Sheet two = textsOf("Unalloyed steel from 0.25 % carbon, annealed");
    QVERIFY(hasText(two, "Unalloyed steel from 0.25 % carbon,") || hasText(two, "Unalloyed steel from 0.25 %"));
    QVERIFY(hasText(two, "annealed") || hasText(two, "carbon, annealed"));
    QVERIFY(overlaps(two).isEmpty() && countOf(two, "…") == 0);
    QVERIFY(overlaps(textsOf(std::string(500, 'x'))).isEmpty());
  }

  void tolerances() {
    const Sheet sheet = drawingSheet(part(), {"Bolt",
                                              "C45",
                                              {{DrawnTolerance::Of::Diameter, 40.0, "h7", 0.0, 0.0},
                                               {DrawnTolerance::Of::Length, 90.0, "±0.1", 0.0, 0.0},
                                               {DrawnTolerance::Of::Length, 40.0, "±9", 0.0, 0.0}},
                                              1e-3,
                                              {},
                                              {}});
    QVERIFY(hasText(sheet, "Ø40 h7") && hasText(sheet, "90 ±0.1") && !hasText(sheet, "Ø40 ±9"));
  }

  void hatchesBoredParts() {
    const auto areas = [](const Sheet& sheet) {
      return std::count_if(sheet.areas.begin(), sheet.areas.end(), [](const auto& a) { return a.isHatched; });
    };
    QCOMPARE(areas(drawingSheet(part(), {})), 1);
    QCOMPARE(areas(drawingSheet(along({{20, 0}, {20, 50}}), {})), 0);
    // A ball whose centre is 0.3 µm off the axis has a dimple at its pole, which is no bore, nor a detail left out.
    const ProfilePoint centre(3e-4, 28);
    const ProfileSegment side = arcAround(centre, 14, -1.2, 0.5 * M_PI);
    const ProfileSegment dimple = arcAround(centre, 14, 0.5 * M_PI, 0.5 * M_PI + std::asin(3e-4 / 14));
    const TargetProfile handle = TargetProfile::make({{{side.from.x(), 0}, side.from, 0.0}, side, dimple}).value();
    const Sheet ball = drawingSheet(handle, {});
    QCOMPARE(areas(ball), 0);
    QVERIFY(hasText(ball, "SR14") && countOf(ball, "Without") == 0);
  }

  // A part of any size is within the frame, at a scale of ISO 5455.
  void anySize() {
    for (const double size : {1e-3, 0.1, 1.0, 30.0, 1000.0, 1e4}) {
      for (const double slender : {0.05, 1.0, 20.0}) {
        const TargetProfile bar = along(
            {{size, 0}, {size, slender * size}, {0.6 * size, slender * size}, {0.6 * size, 1.5 * slender * size}});
        const Sheet sheet = drawingSheet(bar, {std::string(500, 'x'), std::string(500, 'y'), {}, 1e-6 * size, {}, {}});
        const ProfileBox box = sheet.box();
        QVERIFY(box.min().x() >= kFrame - 5.0 && box.min().y() >= kFrame - 1e-9);
        QVERIFY(box.max().x() <= sheet.width - kFrame + 5.0 && box.max().y() <= sheet.height - kFrame + 5.0);
      }
    }
  }

  // Running dimensions from the upper end (ISO 129-1): each height has its text.
  void manyShoulders() {
    std::vector<ProfilePoint> points{{5, 0}};
    for (int i = 0; i < 14; ++i) {
      points.emplace_back(points.back().x(), 10.0 * (i + 1));
      points.emplace_back(5.0 + 0.5 * (i + 1), 10.0 * (i + 1));
    }
    points.pop_back();  // the upper end face goes from there to the axis
    const Sheet sheet = drawingSheet(along(points), {});
    QCOMPARE(sheet.width, 420.0);
    for (const char* text : {"0", "10", "70", "130", "140"}) QVERIFY2(hasText(sheet, text), text);
    QVERIFY2(overlaps(sheet).isEmpty(), qPrintable(overlaps(sheet).join(", ")));
  }

  // Steps of a hand below 0.05 mm are no features: the three diameters and lengths remain.
  void tinyStepsHaveNoDimensions() {
    const Sheet sheet = drawingSheet(byHand(0.015), {"By hand", "", {}, 0.01, {}, {}});
    QCOMPARE(countOf(sheet, "Ø"), std::size_t{3});
    for (const double size : {24.0, 20.0, 14.0}) {
      const auto isNear = [&](const Sheet::Text& t) {
        return t.text.starts_with("Ø") && std::abs(std::stod(t.text.substr(2)) - size) <= 0.05;
      };
      QVERIFY(std::any_of(sheet.texts.begin(), sheet.texts.end(), isNear));
    }
    QVERIFY(hasText(sheet, "90") && countOf(sheet, "Without features below 0.") == 1);
    QVERIFY2(overlaps(sheet).isEmpty(), qPrintable(overlaps(sheet).join(", ")));
  }

  // Beside steps that are left out: a face between two samples is not quite flat, and a groove that two passes made not
  // quite a cylinder. A taper of 2° over the same depth is one.
  void whatIsNearlyFlatIsFlat() {
    const auto shaft = [](double lean, double rise) {
      return drawingSheet(along({{0, 0},
                                 {20, 0},
                                 {20, 10},
                                 {19.99, 10},
                                 {19.99, 30},
                                 {15, 30 + lean},
                                 {15, 50},
                                 {12, 50},
                                 {12 + rise, 60},
                                 {0, 60}}),
                          {});
    };
    QCOMPARE(countOf(shaft(0.08, 0.04), "∠"), std::size_t{0});
    QCOMPARE(countOf(shaft(0.4, 0.35), "∠"), std::size_t{2});
  }

  // For any part, no text is on another one, and all are on the sheet.
  void noTextIsOnAnother() {
    for (const double waviness : {0.02, 0.08, 0.3, 1.0}) {
      const Sheet sheet = drawingSheet(byHand(waviness), {"By hand", "C45", {}, 0.01, {}, {}});
      QVERIFY2(overlaps(sheet).isEmpty(), qPrintable(overlaps(sheet).join(", ")));
      // Steps of 2 and 3 mm are seen beside waves of a quarter of that, not beside waves of half of it.
      if (waviness < 0.5) QVERIFY(countOf(sheet, "Ø") >= 3);
    }
    QVERIFY(rc::check("texts do not overlap", [] {
      const auto target = TargetProfile::make(test::anyShaft());
      RC_PRE(target.hasValue());
      DrawingTitle title{"Any", "C45", {}, 1e-3, {}, {}};
      title.tolerances.push_back({DrawnTolerance::Of::Length, target->length(), "+0.05 -0.1", 0.0, 0.0});
      title.roughness.push_back({1.6, target->lowerEnd(), target->upperEnd(), false});
      const Sheet sheet = drawingSheet(*target, title);
      RC_ASSERT(overlaps(sheet).isEmpty());
      RC_ASSERT(ProfileBox(ProfilePoint(0, 0), ProfilePoint(sheet.width, sheet.height)).contains(sheet.box()));
    }));
  }

  // ISO 6410-1: a narrow line at the minor diameter along the thread, on both sides of the axis, and the designation
  // instead of the diameter.
  void threads() {
    DrawingTitle title{"Bolt", "C45", {}, 1e-3, {{"M20×2.5", 60.0, 80.0, 20.0, 16.93, false}}, {}};
    const Sheet sheet = drawingSheet(along({{15, 0}, {15, 50}, {10, 50}, {10, 80}}), title);
    QVERIFY(hasText(sheet, "M20×2.5") && hasText(sheet, "Ø30") && !hasText(sheet, "Ø20"));
    std::vector<double> heights;
    for (const Sheet::Stroke& s : sheet.strokes) {
      const bool isLevel = s.curve.from.y() == s.curve.to.y() && s.line == Sheet::Line::Narrow;
      const double length = s.curve.length(), scale = length / 20.0;  // the thread is 20 mm long
      if (isLevel && (scale == 1.0 || scale == 2.0)) heights.push_back(s.curve.from.y());
    }
    std::sort(heights.begin(), heights.end());
    const bool isThere = std::any_of(heights.begin(), heights.end(), [&](double low) {
      return std::any_of(heights.begin(), heights.end(), [&](double high) {
        return std::abs(high - low - 16.93) < 1e-9 || std::abs(high - low - 2.0 * 16.93) < 1e-9;
      });
    });
    QVERIFY(isThere);
  }

  // A tolerance is for the surface where it was asked, not for another one of that size.
  void tolerancesHaveTheirPlace() {
    DrawingTitle title{"Bolt",
                       "C45",
                       {{DrawnTolerance::Of::Diameter, 20.0, "h10", 42.0, 58.0},
                        {DrawnTolerance::Of::Length, 20.0, "±0.1", 20.0, 40.0}},
                       1e-3,
                       {},
                       {{3.2, 42.0, 58.0, false}}};
    const Sheet sheet =
        drawingSheet(along({{9.975, 0}, {9.975, 20}, {15, 20}, {15, 40}, {9.975, 40}, {9.975, 60}}), title);
    QVERIFY(hasText(sheet, "Ø20 h10") && hasText(sheet, "Ø19.95") && hasText(sheet, "20 ±0.1"));
    QVERIFY(hasText(sheet, "Ra 3.2"));
  }

  // The faces of a length are those of the outside: between other heights nothing is toleranced.
  void lengthsBetweenNoFacesAreLeftOut() {
    const DrawingTitle title{"Bolt", "C45", {{DrawnTolerance::Of::Length, 17.0, "±0.1", 23.0, 40.0}}, 1e-3, {}, {}};
    const Sheet sheet = drawingSheet(along({{10, 0}, {10, 20}, {15, 20}, {15, 40}, {10, 40}, {10, 60}}), title);
    QVERIFY(hasText(sheet, "Ø30") && countOf(sheet, "17") == 0);
  }

  // The nearest positions with a gap: the middle of a crowd stays, and so do single ones.
  void spreading() {
    QCOMPARE(spread({0.0, 10.0, 20.0}, 5.0), (std::vector<double>{0.0, 10.0, 20.0}));
    QCOMPARE(spread({10.0, 10.0, 10.0}, 5.0), (std::vector<double>{5.0, 10.0, 15.0}));
    QCOMPARE(spread({0.0, 1.0, 30.0}, 5.0), (std::vector<double>{-2.0, 3.0, 30.0}));
    QVERIFY(spread({}, 5.0).empty());
  }

  void scales() {
    QCOMPARE(standardScale(100.0, 200.0), 2.0);
    QCOMPARE(standardScale(100.0, 199.0), 1.0);
    QCOMPARE(standardScale(100.0, 99.0), 0.5);
    QCOMPARE(scaleText(5.0), std::string("5:1"));
    QCOMPARE(scaleText(0.05), std::string("1:20"));
    QCOMPARE(sizeText(12.5000004), std::string("12.5"));
    QCOMPARE(sizeText(29.996), std::string("30"));
    QCOMPARE(sizeText(1.425), std::string("1.43"));
    QCOMPARE(sizeText(0.5 * (22.85 - 20.0)), std::string("1.43"));
    QCOMPARE(sizeText(1.4249), std::string("1.42"));
  }
};

HANDWHEEL_TEST(PartDrawingTest)
#include "PartDrawingTest.moc"
