// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramTrial.h"
#include "TestClass.h"

#include <QtTest>
#include <algorithm>

using namespace handwheel;
using test::ProgramTrial;

namespace {

const ProgramTrial kRoughingTrial(ProgramDialect::Fanuc);
const std::string kRoughingBegin = "G21 G99\nG97 S500 M3\nG0 X40. Z2.\n";

// A move that is expected: its kind, its turn, and its end (r, z).
struct Expected {
  bool isFeed;
  int turn;
  double r, z;
};

// Returns a sentence about the first difference, or nothing. The first move of the program, to the start, is left out.
QString roughingDifference(const std::string& text, const std::vector<Expected>& expected) {
  std::vector<ToolMove> moves = kRoughingTrial.movesOf(kRoughingBegin + text);
  if (moves.empty()) return "no moves";
  moves.erase(moves.begin());
  for (std::size_t i = 0; i < std::min(moves.size(), expected.size()); ++i) {
    const bool isFeed = moves[i].kind == ToolMove::Kind::Feed;
    const bool isThere = (moves[i].to - ProfilePoint(expected[i].r, expected[i].z)).norm() < 1e-6;
    if (isFeed != expected[i].isFeed || moves[i].turn != expected[i].turn || !isThere)
      return QString("move %1: feed %2, turn %3, r %4, z %5")
          .arg(i)
          .arg(isFeed)
          .arg(moves[i].turn)
          .arg(moves[i].to.x())
          .arg(moves[i].to.y());
  }
  if (moves.size() != expected.size()) return QString("%1 moves, not %2").arg(moves.size()).arg(expected.size());
  return {};
}

std::string roughingRefusal(const std::string& text) {
  return kRoughingTrial.refusalOf(kRoughingBegin + text);
}

constexpr bool kRapid = false, kFeed = true;

}  // namespace

// G71 and G72 of a Fanuc, types I and II, move by move as the manual draws them. Moves are (r, z); X is a diameter.
class FanucRoughingTest : public QObject {
  Q_OBJECT

 private slots:
  // From r 20, two levels of 3 mm, at r 17 and 14, to a shoulder at z -10; each is left at 45 degrees over 1 mm. Then
  // along the contour at r 12, whose shoulder goes out to the end of the bar.
  void typeOne() {
    const QString difference =
        roughingDifference("G71 U3. R1.\nG71 P10 Q20 F0.2\nN10 G0 X24.\nG1 Z-10.\nN20 X40.\n", {{kRapid, 0, 17, 2},
                                                                                                {kFeed, 0, 17, -10},
                                                                                                {kRapid, 0, 18, -9},
                                                                                                {kRapid, 0, 18, 1},
                                                                                                {kRapid, 0, 17, 2},
                                                                                                {kRapid, 0, 14, 2},
                                                                                                {kFeed, 0, 14, -10},
                                                                                                {kRapid, 0, 15, -9},
                                                                                                {kRapid, 0, 15, 1},
                                                                                                {kRapid, 0, 14, 2},
                                                                                                {kRapid, 0, 12, 2},
                                                                                                {kFeed, 0, 12, -10},
                                                                                                {kFeed, 0, 20, -10},
                                                                                                {kRapid, 0, 20, 2}});
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
  }

  // The first line names X and Z: the same contour, of type II. Each level ends along the shoulder, up to the level
  // before.
  void typeTwo() {
    const QString difference =
        roughingDifference("G71 U3. R1.\nG71 P10 Q20 F0.2\nN10 G0 X24. W0\nG1 Z-10.\nN20 X40.\n", {{kRapid, 0, 17, 2},
                                                                                                   {kFeed, 0, 17, -10},
                                                                                                   {kFeed, 0, 20, -10},
                                                                                                   {kRapid, 0, 21, -9},
                                                                                                   {kRapid, 0, 18, 1},
                                                                                                   {kRapid, 0, 17, 2},
                                                                                                   {kRapid, 0, 14, 2},
                                                                                                   {kFeed, 0, 14, -10},
                                                                                                   {kFeed, 0, 17, -10},
                                                                                                   {kRapid, 0, 18, -9},
                                                                                                   {kRapid, 0, 15, 1},
                                                                                                   {kRapid, 0, 14, 2},
                                                                                                   {kRapid, 0, 12, 2},
                                                                                                   {kFeed, 0, 12, -10},
                                                                                                   {kFeed, 0, 20, -10},
                                                                                                   {kRapid, 0, 20, 2}});
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
  }

  // A level that ends on a cone of 45 degrees and an arc: at r 16 the cone from (12, -8) is met at z -12, and followed
  // to (17, -13), where an arc around (17, -16) begins; it has a radius of 3 and is met at r 20, its top, at z -16.
  void followsConeAndArc() {
    const QString difference = roughingDifference(
        "G71 U4. R1.\nG71 P10 Q20 F0.2\nN10 G0 X24. Z2.\nG1 Z-8.\nX34. Z-13.\nN20 G3 X40. Z-16. R3.\n",
        {{kRapid, 0, 16, 2},
         {kFeed, 0, 16, -12},
         {kFeed, 0, 17, -13},
         {kFeed, 1, 20, -16},
         {kRapid, 0, 21, -15},
         {kRapid, 0, 17, 1},
         {kRapid, 0, 16, 2},
         {kRapid, 0, 12, 2},
         {kFeed, 0, 12, -8},
         {kFeed, 0, 17, -13},
         {kFeed, 1, 20, -16},
         {kRapid, 0, 20, 2}});
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
  }

  // G72, levels along X at z -1 and -4 from z 2, to a shoulder at r 10.
  void faces() {
    const QString difference =
        roughingDifference("G72 W3. R1.\nG72 P10 Q20 F0.2\nN10 G0 Z-6.\nG1 X20.\nN20 Z2.\n", {{kRapid, 0, 20, -1},
                                                                                              {kFeed, 0, 10, -1},
                                                                                              {kRapid, 0, 11, 0},
                                                                                              {kRapid, 0, 19, 0},
                                                                                              {kRapid, 0, 20, -1},
                                                                                              {kRapid, 0, 20, -4},
                                                                                              {kFeed, 0, 10, -4},
                                                                                              {kRapid, 0, 11, -3},
                                                                                              {kRapid, 0, 19, -3},
                                                                                              {kRapid, 0, 20, -4},
                                                                                              {kRapid, 0, 20, -6},
                                                                                              {kFeed, 0, 10, -6},
                                                                                              {kFeed, 0, 10, 2},
                                                                                              {kRapid, 0, 20, 2}});
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
  }

  // A cut that is deeper than all there is: along the contour only.
  void oneCut() {
    const QString difference =
        roughingDifference("G71 U9. R1.\nG71 P10 Q20 F0.2\nN10 G0 X24.\nG1 Z-10.\nN20 X40.\n",
                           {{kRapid, 0, 12, 2}, {kFeed, 0, 12, -10}, {kFeed, 0, 20, -10}, {kRapid, 0, 20, 2}});
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
  }

  // Pockets need type II, in X for G71 and in Z for G72, of lines and of arcs.
  void pockets_data() {
    QTest::addColumn<QString>("cycle");
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("rest");
    QTest::newRow("groove") << "G71 U1. R1."
                            << "G0 X30."
                            << "G1 Z-5. F.2\nX24. Z-8.\nZ-12.\nX30. Z-15.\nN20 X40.\n";
    QTest::newRow("concave arc") << "G71 U1. R1."
                                 << "G0 X30."
                                 << "G1 Z-5. F.2\nG2 X30. Z-15. R8.\nN20 G1 X40.\n";
    QTest::newRow("convex arc") << "G71 U1. R1."
                                << "G0 X24."
                                << "G1 Z-5. F.2\nG3 X24. Z-15. R8.\nN20 G1 X40.\n";
    QTest::newRow("face") << "G72 W1. R1."
                          << "G0 Z-6."
                          << "G1 X30. F.2\nX26. Z-9.\nX20.\nN20 Z2.\n";
    QTest::newRow("bore") << "G71 U1. R1."
                          << "G0 X56."
                          << "G1 Z-5. F.2\nX60. Z-8.\nX50. Z-15.\nN20 X40.\n";
  }
  void pockets() {
    QFETCH(QString, cycle);
    QFETCH(QString, first);
    QFETCH(QString, rest);
    const auto program = [&](const char* more) {
      return (cycle + "\n" + cycle.left(3) + " P10 Q20 F.2\nN10 " + first + more + "\n" + rest).toStdString();
    };
    QCOMPARE(QString::fromStdString(roughingRefusal(program(""))),
             QString("5: contour: it has a pocket, which type I of the cycle does not cut. Name X and Z in its first "
                     "line, with W0 if Z stays, which makes it type II."));
    QCOMPARE(roughingRefusal(program(cycle.startsWith("G71") ? " W0" : " U0")), std::string());
  }

  // Neither type cuts a contour that goes back along Z.
  void refusesUndercuts() {
    for (const char* const first : {"N10 G0 X24.\n", "N10 G0 X24. W0\n"}) {
      const std::string refusal =
          roughingRefusal(std::string("G71 U1. R1.\nG71 P10 Q20 F.2\n") + first + "G1 Z-10.\nX30. Z-8.\nN20 X40.\n");
      QVERIFY2(refusal.starts_with("5: contour: it goes back"), refusal.c_str());
    }
  }

  // The whole of a pocket is cut: all levels of 1 mm down to its bottom, and nothing below the contour.
  void cutsThePocket() {
    const auto moves = kRoughingTrial.movesOf(
        kRoughingBegin +
        "G71 U1. R.5\nG71 P10 Q20 F.2\nN10 G0 X30. W0\nG1 Z-5.\nX24. Z-8.\nZ-12.\nX30. Z-15.\nN20 X40.\n");
    QVERIFY(!moves.empty());
    std::vector<double> levels;
    for (std::size_t k = 1; k < moves.size(); ++k) {
      const ToolMove& m = moves[k];
      if (m.kind == ToolMove::Kind::Feed && m.from.x() == m.to.x() && m.to.x() < 14.9) levels.push_back(m.to.x());
      for (int i = 0; i <= 20; ++i) {
        const ProfilePoint p = pointOn(m, i / 20.0);
        const double wall = p.y() > -5.0 || p.y() < -15.0 ? 15.0
                            : p.y() > -8.0                ? 20.0 + p.y()
                            : p.y() > -12.0               ? 12.0
                                                          : -p.y();
        QVERIFY2(p.x() > wall - 1e-6, qPrintable(QString("r %1 z %2").arg(p.x()).arg(p.y())));
      }
    }
    for (const double level : {14.0, 13.0, 12.0})
      QVERIFY(std::any_of(levels.begin(), levels.end(), [&](double l) { return std::abs(l - level) < 1e-6; }));
  }
};

HANDWHEEL_TEST(FanucRoughingTest)
#include "FanucRoughingTest.moc"
