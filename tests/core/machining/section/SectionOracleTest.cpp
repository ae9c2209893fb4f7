// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactSection.h"
#include "SectionChecks.h"
#include "TestClass.h"
#include "machining/section/ToolSweep.h"

#include <rapidcheck.h>

#include <QtTest>

using namespace handwheel;

namespace {

struct Cut {
  SweptShape shape;
  ProfileSegment move;
};

// Shapes of tools: discs, inserts with and without a nose radius, blades, form tools, a drill, and a knife without
// area.
const std::vector<SweptShape> kShapes{
    {{{0.0, 0.0}}, 0.4},
    {{{0.0, 0.0}}, 0.8},
    {{{0.0, 0.0}}, 4.0},
    {{{0.8, 0.8}, {12.0324, 1.7827}, {13.0151, 13.0151}, {1.7827, 12.0324}}, 0.8},
    {{{0.4, 0.4}, {15.5844, 1.1958}, {27.5663, 10.5571}, {12.3819, 9.7613}}, 0.4},
    {{{-0.4, 0.4}, {-6.0162, 0.8914}, {-6.5076, 6.5076}, {-0.8914, 6.0162}}, 0.4},
    {{{0.2, 0.2}, {0.2, 2.8}, {30.0, 2.7}, {30.0, 0.3}}, 0.2},
    {{{0.2, 2.8}, {30.0, 2.7}, {30.0, 0.3}, {0.2, 0.2}}, 0.0},
    {{{0.0, 0.0}, {0.0, 4.0}, {4.0, 4.0}, {4.0, 0.0}}, 0.5},
    {{{0.0, 0.0}, {0.0, 2.0}, {30.0, 2.0}, {30.0, 0.0}}, 0.0},
    {{{4.0, 0.0}, {14.0, 0.0}}, 4.0},
    {{{0.0, 0.0}, {2.0, 2.0}, {2.0, -2.0}}, 0.0},
    {{{0.0, 0.0}, {3.0, 1.8026}, {3.0, 60.0}, {-3.0, 60.0}, {-3.0, 1.8026}}, 0.0},
};

// A bar that is cut twice: by TurnedSection, and exactly.
class TwiceCutBar {
 public:
  explicit TwiceCutBar(const StockCylinder& stock) : m_section(stock), m_exact(0.5 * stock.diameter, stock.length) {}

  bool isOver() const { return m_isOver; }
  const TurnedSection& section() const { return m_section; }

  // Cuts both. Returns how they differ, or an empty text. After chips have fallen, the bars are not compared any more:
  // pieces that touch in a point are one piece for CGAL.
  std::string cut(const Cut& cut, std::uint32_t pass) {
    const double before = m_section.area(), exactBefore = m_exact.area();
    SectionRemoval removal;
    const std::vector<SectionCutter> cutters = cuttersOf(cut.shape, cut.move);
    for (const SectionCutter& cutter : cutters) {
      const std::optional<SectionRemoval> one = m_section.subtract(cutter, pass);
      if (!one) return "not subtracted";
      removal.add(*one);
    }
    if (std::string fault = test::faultOf(m_section); !fault.empty()) return fault;
    m_exact.cut(cut.shape, cut.move);
    m_isOver = before - removal.area - m_section.area() > 1e-7;
    if (!m_isOver) return difference();
    // An arc is several cutters: the later ones miss the chips of the earlier ones.
    const bool isRight = cutters.size() > 1 || std::abs(removal.area - exactBefore + m_exact.area()) < 1e-4;
    return isRight ? std::string() : "removed " + std::to_string(removal.area) + " mm²";
  }

 private:
  std::string difference() const {
    double length = 0.0;
    for (const SharedLoop& loop : m_section.loops())
      for (const SectionSegment& segment : loop.segments()) length += segment.length();
    const double area = m_exact.area(), volume = m_exact.volume();
    char text[120] = "";
    if (std::abs(m_section.area() - area) > 1e-6 * length)
      std::snprintf(text, sizeof text, "area %.9f instead of %.9f mm²", m_section.area(), area);
    else if (std::abs(m_section.volume() - volume) > 1e-6 * std::max(volume, 1.0))
      std::snprintf(text, sizeof text, "volume %.9f instead of %.9f mm³", m_section.volume(), volume);
    return text[0] != '\0' ? text : sides();
  }

  // Returns a long piece of the exact boundary beside which a piece of material is lost or left over.
  std::string sides() const {
    constexpr double kBeside = 1e-5, kNear = 3e-5, kLong = 1e-3;  // mm
    const std::vector<SectionSegment> all = m_exact.boundary();
    for (const SectionSegment& s : all) {
      if (s.length() < kLong) continue;
      const ProfilePoint middle = s.at(0.5 * s.length()), along = s.carrier.direction(middle);
      const bool isAlone = std::all_of(all.begin(), all.end(), [&](const SectionSegment& other) {
        return &other == &s || (other.nearest(middle) - middle).norm() > kNear;
      });
      const ProfilePoint left = kBeside * ProfilePoint(-along.y(), along.x());
      if (isAlone && !m_section.contains(middle + left)) return "lost material at " + test::textOf(s);
      if (isAlone && m_section.contains(middle - left)) return "left over material at " + test::textOf(s);
    }
    return {};
  }

  TurnedSection m_section;
  test::ExactSection m_exact;
  bool m_isOver = false;
};

constexpr StockCylinder kBar{40.0, 60.0, 0.0};

std::string differenceAfter(const std::vector<Cut>& cuts, const StockCylinder& stock = kBar) {
  TwiceCutBar bar(stock);
  for (std::size_t i = 0; i < cuts.size() && !bar.isOver(); ++i)
    if (std::string text = bar.cut(cuts[i], static_cast<std::uint32_t>(i)); !text.empty())
      return "cut " + std::to_string(i) + ": " + text;
  return {};
}

int whole(int low, int high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}
double number(double low, double high) {
  return low + (high - low) * whole(0, 1'000'000) / 1e6;
}

// A move on a grid, from the end of the last one or from elsewhere: along z, along r, sloped, or a quarter of a circle.
ProfileSegment gridMove(const ProfilePoint& last, double grid, bool isArc) {
  ProfilePoint from = last;
  if (whole(0, 2) > 0) from = {grid * whole(-4, 22), grid * whole(-3, 40)};
  const double by = grid * (whole(0, 1) == 0 ? whole(1, 10) : -whole(1, 10));
  if (isArc) {
    const double radius = std::abs(by), turn = whole(0, 1) == 0 ? 1.0 : -1.0;
    const std::array<ProfilePoint, 4> out{ProfilePoint(1, 0), ProfilePoint(0, 1), ProfilePoint(-1, 0),
                                          ProfilePoint(0, -1)};
    const int start = whole(0, 3), end = (start + (turn > 0.0 ? 1 : 3)) % 4;
    const ProfilePoint to =
        from - radius * out[static_cast<std::size_t>(start)] + radius * out[static_cast<std::size_t>(end)];
    return {from, to, turn * std::tan(M_PI / 8.0)};
  }
  switch (whole(0, 4)) {
    case 0:
      return {from, from + ProfilePoint(by, 0.0), 0.0};
    case 1:
      return {from, from + ProfilePoint(by, by), 0.0};
    case 2:
      return {from, from + ProfilePoint(by, grid * whole(-10, 10)), 0.0};
    case 3:
      return {from, from, 0.0};
    default:
      return {from, from + ProfilePoint(0.0, by), 0.0};
  }
}

// Cuts by few shapes, some of them again, so that walls and ends coincide.
std::vector<Cut> gridCuts(int most, int arcsOfTen) {
  const std::array<double, 4> grids{0.1, 0.5, 1.0, 2.0};
  const double grid = grids[static_cast<std::size_t>(whole(0, 3))];
  const std::array<int, 2> shapes{whole(0, static_cast<int>(kShapes.size()) - 1),
                                  whole(0, static_cast<int>(kShapes.size()) - 1)};
  std::vector<Cut> cuts;
  ProfilePoint last(0, 0);
  for (int count = whole(1, most); count > 0; --count) {
    if (!cuts.empty() && whole(0, 9) == 0) {
      cuts.push_back(cuts[static_cast<std::size_t>(whole(0, static_cast<int>(cuts.size()) - 1))]);
    } else {
      const SweptShape& shape = kShapes[static_cast<std::size_t>(shapes[whole(0, 3) == 0 ? 1 : 0])];
      ProfileSegment move = gridMove(last, grid, whole(1, 10) <= arcsOfTen);
      // The nose itself touches the lines of the grid in every third move.
      if (whole(0, 2) == 0) {
        move.from.x() += shape.radius;
        move.to.x() += shape.radius;
      }
      cuts.push_back({shape, move});
    }
    last = cuts.back().move.to;
  }
  return cuts;
}

}  // namespace

class SectionOracleTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { qputenv("RC_PARAMS", qgetenv("RC_PARAMS") + " max_success=40"); }

  void straightMovesOnAGrid() {
    QVERIFY(rc::check("as CGAL", [] {
      const std::string text = differenceAfter(gridCuts(30, 0));
      if (!text.empty()) RC_FAIL(text);
    }));
  }

  void arcsOnAGrid() {
    QVERIFY(rc::check("as CGAL", [] {
      const std::string text = differenceAfter(gridCuts(4, 5));
      if (!text.empty()) RC_FAIL(text);
    }));
  }

  void anyMoves() {
    QVERIFY(rc::check("as CGAL", [] {
      std::vector<Cut> cuts;
      for (int count = whole(1, 8); count > 0; --count) {
        const ProfilePoint from(number(-5.0, 22.0), number(-3.0, 63.0)), to(number(-5.0, 22.0), number(-3.0, 63.0));
        const double bulge = whole(0, 3) == 0 && from != to ? number(-1.0, 1.0) : 0.0;
        cuts.push_back(
            {kShapes[static_cast<std::size_t>(whole(0, static_cast<int>(kShapes.size()) - 1))], {from, to, bulge}});
      }
      const std::string text = differenceAfter(cuts);
      if (!text.empty()) RC_FAIL(text);
    }));
  }

  // Positions in which curves touch, coincide, or miss each other by rounding.
  void degeneratePositions_data() {
    QTest::addColumn<std::vector<Cut>>("cuts");
    const SweptShape disc{{{0.0, 0.0}}, 4.0}, nose{{{0.0, 0.0}}, 0.8}, square = kShapes[9], wedge = kShapes[11];
    const SweptShape blade = kShapes[7], stadium = kShapes[10], knife{{{0.0, 0.0}, {5.0, 0.0}}, 0.0};
    const auto row = [](const char* name, const std::vector<Cut>& cuts) { QTest::newRow(name) << cuts; };
    const auto line = [](double r, double z, double toR, double toZ) {
      return ProfileSegment{{r, z}, {toR, toZ}, 0.0};
    };
    const double quarter = std::tan(M_PI / 8.0);
    row("again and again", std::vector<Cut>(5, {nose, line(18.8, 62.0, 18.8, 30.0)}));
    row("along existing walls", {{square, line(15.0, 20.0, 15.0, 30.0)},
                                 {square, line(15.0, 22.0, 15.0, 28.0)},
                                 {square, line(15.0, 30.0, 20.0, 30.0)},
                                 {square, line(15.0, 32.0, 15.0, 32.0)}});
    row("a cutter that only touches", {{nose, line(20.8, 62.0, 20.8, -2.0)}, {nose, line(10.0, 60.8, 22.0, 60.8)}});
    row("arcs tangent to lines", {{disc, line(20.0, 64.0, 20.0, 40.0)},
                                  {disc, {{20.0, 40.0}, {24.0, 36.0}, quarter}},
                                  {disc, {{20.0, 40.0}, {16.0, 36.0}, -quarter}}});
    row("beyond the axis", {{square, line(-5.0, 58.0, -5.0, 58.0)}, {nose, line(20.0, 50.0, -20.0, 50.0)}});
    row("exactly to the axis", {{square, line(0.0, 58.0, 0.0, 58.0)}, {nose, line(20.0, 50.0, 0.8, 50.0)}});
    row("an end just below the axis", {{square, line(-1.86e-8, 1.5, -1.86e-8, 1.5)}});
    // Radii that differ by rounding: a corner of the hull was lost.
    row("radii that differ in the last digits", {{blade, line(11.999999999891383, 6.0, 11.999999999902073, -2.0)}});
    row("a wall that differs in the last digit", {{blade, line(12.0, 6.0, 12.000000000000002, -2.0)}});
    row("two noses along their own line", {{stadium, line(14.000000000729239, 2.0000000000523235, 15.0, 2.0)}});
    // Tangential: rounding decides on the length of the chord.
    row("a knife along an arc", {{knife, {{11.25, 47.25}, {10.75, 47.0}, 0.79084472023667307}}});
    row("a knife past its tangent", {{knife, {{8.5000002000000006, 29.4999996}, {6.0000003, 26.9999998}, -quarter}}});
    row("the end of a knife near its tangent", {{knife, {{12.99999, 22.00001}, {13.75, 22.75}, -quarter}}});
    row("a nose of the radius of its arc", {{nose, {{5.7000002, 11.6999999}, {5.7, 13.3}, -0.99999999999999989}}});
    row("a corner near a wall",
        {{wedge, line(18.000000016634313, 34.000000024588445, 18.000000016634313, 34.000000024588445)}});
    row("a sliver", {{knife, line(10.0, 0.0, 13.99999998, 3e-8)}});
  }
  void degeneratePositions() {
    QFETCH(std::vector<Cut>, cuts);
    QCOMPARE(QString::fromStdString(differenceAfter(cuts)), QString());
  }
};

HANDWHEEL_TEST(SectionOracleTest)
#include "SectionOracleTest.moc"
