// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/PartDrawing.h"

#include "TestClass.h"
#include "machining/drawing/Dimensions.h"

#include <QtTest>
#include <algorithm>

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

ProfileBox boxOf(const Sheet& sheet) {
  ProfileBox box;
  for (const Sheet::Stroke& s : sheet.strokes) box.extend(s.curve.box());
  for (const Sheet::Text& t : sheet.texts) {
    const double width = widthOf(t.text, t.height);
    const ProfilePoint along = t.isUpwards ? ProfilePoint(0, width) : ProfilePoint(width, 0);
    const double before = t.align == Sheet::Align::Left ? 0.0 : t.align == Sheet::Align::Centre ? 0.5 : 1.0;
    box.extend(ProfilePoint(t.at - before * along));
    box.extend(ProfilePoint(t.at + (1.0 - before) * along));
  }
  return box;
}

}  // namespace

class PartDrawingTest : public QObject {
  Q_OBJECT

 private slots:
  void hasItsDimensions() {
    const Sheet sheet = drawingSheet(part(), {"Bolt", "C45", {}, 1e-3});
    for (const char* text : {"Ø40", "Ø24", "Ø20", "Ø10", "R3", "2×45°", "Bolt", "C45", "1:1", "A4", "mm"})
      QVERIFY2(hasText(sheet, text), text);
    // The angle between the sides of the taper, 2 atan(2 / 20).
    QVERIFY(hasText(sheet, "∠11.42°"));
    // From the upper end: the shoulder at 30, the tapers, the whole; and the bore.
    for (const char* text : {"10", "30", "60", "90", "25"}) QVERIFY2(hasText(sheet, text), text);
  }

  void tolerances() {
    const Sheet sheet = drawingSheet(part(), {"Bolt",
                                              "C45",
                                              {{DrawnTolerance::Of::Diameter, 40.0, "h7"},
                                               {DrawnTolerance::Of::Length, 90.0, "±0.1"},
                                               {DrawnTolerance::Of::Length, 40.0, "±9"}},
                                              1e-3});
    QVERIFY(hasText(sheet, "Ø40 h7") && hasText(sheet, "90 ±0.1") && !hasText(sheet, "Ø40 ±9"));
  }

  void hatchesBoredParts() {
    const auto areas = [](const Sheet& sheet) {
      return std::count_if(sheet.areas.begin(), sheet.areas.end(), [](const auto& a) { return a.isHatched; });
    };
    QCOMPARE(areas(drawingSheet(part(), {})), 1);
    QCOMPARE(areas(drawingSheet(along({{20, 0}, {20, 50}}), {})), 0);
  }

  // Whatever its size, the part is within the frame, at a scale of ISO 5455.
  void anySize() {
    for (const double size : {1e-3, 0.1, 1.0, 30.0, 1000.0, 1e4}) {
      for (const double slender : {0.05, 1.0, 20.0}) {
        const TargetProfile bar = along(
            {{size, 0}, {size, slender * size}, {0.6 * size, slender * size}, {0.6 * size, 1.5 * slender * size}});
        const Sheet sheet = drawingSheet(bar, {std::string(500, 'x'), std::string(500, 'y'), {}, 1e-6 * size});
        const ProfileBox box = boxOf(sheet);
        QVERIFY(box.min().x() >= kFrame - 5.0 && box.min().y() >= kFrame - 1e-9);
        QVERIFY(box.max().x() <= sheet.width - kFrame + 5.0 && box.max().y() <= sheet.height - kFrame + 5.0);
      }
    }
  }

  void manyShoulders() {
    std::vector<ProfilePoint> points{{5, 0}};
    for (int i = 0; i < 30; ++i) {
      points.emplace_back(points.back().x(), 5.0 * (i + 1));
      points.emplace_back(5.0 + 0.5 * (i + 1), 5.0 * (i + 1));
    }
    points.pop_back();  // the upper end face goes from there to the axis
    const Sheet sheet = drawingSheet(along(points), {});
    QCOMPARE(sheet.width, 420.0);
    QVERIFY(hasText(sheet, "150"));  // the whole, below the chain
  }

  void scales() {
    QCOMPARE(standardScale(100.0, 200.0), 2.0);
    QCOMPARE(standardScale(100.0, 199.0), 1.0);
    QCOMPARE(standardScale(100.0, 99.0), 0.5);
    QCOMPARE(scaleText(5.0), std::string("5:1"));
    QCOMPARE(scaleText(0.05), std::string("1:20"));
    QCOMPARE(sizeText(12.5000004), std::string("12.5"));
    QCOMPARE(sizeText(29.996), std::string("30"));
  }
};

HANDWHEEL_TEST(PartDrawingTest)
#include "PartDrawingTest.moc"
