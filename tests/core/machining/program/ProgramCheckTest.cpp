// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramCheck.h"

#include "TestClass.h"
#include "machining/program/ProgramErrors.h"
#include "machining/program/ProgramTimeline.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

QStringList positionsOf(const std::vector<Error>& problems) {
  QStringList positions;
  for (const Error& each : problems)
    positions << QStringLiteral("%1:%2 %3")
                     .arg(each.position.value)
                     .arg(QString::fromStdString(each.arguments.at(0)), QString::fromStdString(each.arguments.at(1)));
  return positions;
}

ToolMove moveTo(const ProfilePoint& from, const ProfilePoint& to, std::uint32_t line, double time) {
  ToolMove move;
  move.kind = ToolMove::Kind::Feed;
  move.from = from;
  move.to = to;
  move.line = line;
  move.time = time;
  return move;
}

}  // namespace

// The information about a program for an editor: all errors, its dialect, its steps.
class ProgramCheckTest : public QObject {
  Q_OBJECT

 private slots:
  void listsEveryRefusedWord() {
    const char* const text =
        "G21 G0 X20 Z2\n"
        "G68 X1 Z1 R30\n"
        "G1 Z-10 F100 M77\n"
        "G1 Y5\n"
        "G1 Z-20\n"
        "M2\n";
    // Columns counted by hand. The words of G68 are its own and not reported again.
    const QStringList expected{"2:1 G68", "3:14 M77", "4:4 Y5"};
    QCOMPARE(positionsOf(programProblems(text, {})), expected);
    QVERIFY(programProblems("G0 X20 Z2\nG1 Z-10 F100\nM2\n", {}).empty());
  }

  // One error that ends all, and no others.
  void anEndlessLoopIsOneProblem() {
    ProgramSetup setup;
    setup.mostBlocks = 1000;
    const auto problems = programProblems("#1=1\no1 while [#1 GT 0]\no1 endwhile\nM2\n", setup);
    QCOMPARE(problems.size(), std::size_t(1));
    QVERIFY(problems.front().code == ProgramError::Endless);
  }

  void theNumberOfProblemsIsBounded() {
    std::string text;
    for (int i = 0; i < 500; ++i) text += "M77\n";
    QCOMPARE(programProblems(text, {}).size(), kMostProblems);
  }

  void recognisesTheDialect_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("dialect");  // -1: either
    const int linuxCnc = static_cast<int>(ProgramDialect::LinuxCnc), fanuc = static_cast<int>(ProgramDialect::Fanuc);
    QTest::newRow("tools of four figures") << QByteArray("%\nO1234\nT0101\nG0 X40 Z2\nM30\n%\n") << fanuc;
    QTest::newRow("increments") << QByteArray("G1 U-2. F.2\nW-10.\n") << fanuc;
    QTest::newRow("speed limit") << QByteArray("g50 s2000\ng96 s150 m3\n") << fanuc;
    QTest::newRow("change of tool") << QByteArray("T1 M6 G43\nG7\nG0 X40 Z2\nM2\n") << linuxCnc;
    QTest::newRow("O words") << QByteArray("o<turn> sub\n#<depth> = 1\no<turn> endsub\n") << linuxCnc;
    QTest::newRow("in a comment only") << QByteArray("(T0101 as on a Fanuc)\nG0 X1 ; #<a>\n") << -1;
    QTest::newRow("either") << QByteArray("G21\nG0 X20 Z2\nG1 Z-10 F100\n") << -1;
    QTest::newRow("G70 is no G7") << QByteArray("G70 P10 Q20\n") << -1;
  }
  void recognisesTheDialect() {
    QFETCH(QByteArray, text);
    QFETCH(int, dialect);
    const auto found = recognisedDialect(text.toStdString());
    QCOMPARE(found ? static_cast<int>(*found) : -1, dialect);
  }

  void stepsAreLines() {
    ToolPath path;
    path.moves = {moveTo({10, 0}, {10, -4}, 3, 2.0), moveTo({10, -4}, {10, -4}, 3, 0.0),
                  moveTo({10, -4}, {8, -4}, 5, 1.0), moveTo({8, -4}, {8, -8}, 3, 4.0)};
    const ProgramTimeline steps(path);
    QCOMPARE(steps.duration(), 7.0);
    const ProgramPosition begin;
    QCOMPARE(steps.next(begin), (ProgramPosition{2, 0.0}));
    QCOMPARE(steps.next({2, 0.5}), (ProgramPosition{3, 0.0}));
    QCOMPARE(steps.next({3, 0.0}), steps.end());
    QCOMPARE(steps.next(steps.end()), steps.end());
    QCOMPARE(steps.previous(steps.end()), (ProgramPosition{3, 0.0}));
    QCOMPARE(steps.previous({3, 0.25}), (ProgramPosition{3, 0.0}));
    QCOMPARE(steps.previous({2, 0.0}), begin);
    QCOMPARE(steps.previous(begin), begin);
    QCOMPARE(steps.lineAt({1, 0.0}), 3u);
    QCOMPARE(steps.lineAt({2, 0.0}), 5u);
    QCOMPARE(steps.lineAt(steps.end()), 3u);
    QCOMPARE(steps.afterLine(3), (ProgramPosition{2, 0.0}));  // the first time that it runs
    QCOMPARE(steps.afterLine(4), (ProgramPosition{3, 0.0}));  // line 5 is the next that moves
    QCOMPARE(steps.afterLine(6), steps.end());
    QCOMPARE(steps.at(1.0), (ProgramPosition{0, 0.5}));
    QCOMPARE(steps.at(2.0), (ProgramPosition{2, 0.0}));  // the move of no time is done, too
    QCOMPARE(steps.at(7.0), steps.end());
    for (const double time : {0.0, 0.3, 2.0, 2.9, 3.0, 6.5}) QCOMPARE(steps.timeAt(steps.at(time)), time);
    QVERIFY((steps.tipAt(steps.at(5.0)) - ProfilePoint(8, -6)).norm() < 1e-12);
    QVERIFY((steps.tipAt(steps.end()) - ProfilePoint(8, -8)).norm() < 1e-12);
    const ToolPath none;
    QCOMPARE(ProgramTimeline(none).next({}), ProgramPosition{});
    QCOMPARE(ProgramTimeline(none).at(1.0), ProgramPosition{});
  }
};

HANDWHEEL_TEST(ProgramCheckTest)
#include "ProgramCheckTest.moc"
