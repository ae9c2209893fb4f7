// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/NoseCompensation.h"
#include "machining/program/ProgramInterpreter.h"

#include "BushPasses.h"
#include "TestClass.h"

#include <QDirIterator>
#include <QProcess>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <complex>

using namespace handwheel;

namespace {

constexpr double kTolerance = 1.05e-4;  // units of the program: 1e-4 and the last digit that rs274 prints

struct OracleMove {
  bool isRapid = false;
  int turn = 0;
  ProfilePoint to{0, 0}, centre{0, 0};
  double unit = 1.0;  // mm
};

struct Oracle {
  bool isRefused = false;
  std::vector<OracleMove> moves;
};

// The tools of all programs here: for rs274 in inches, as it has no machine; for us in mm.
constexpr int kContours = 100;  // contours with random joints

const char* const kInchTools =
    "T1 P1 D0 X0 Z0 Q2\nT2 P2 D0.03 X0 Z0 Q2\nT3 P3 D0.03 X0 Z0 Q3\nT4 P4 D0 X0 Z0 Q2\nT5 P5 D0.03 X0.1 Z0.2 Q2\n"
    "T6 P6 D0.03 X0 Z0 Q2\nT7 P7 D0.03 X0 Z0 Q6\nT8 P8 D0 X0 Z0 Q2\nT9 P9 D0 X0 Z0 Q7\nT10 P10 D0.03 X0 Z0 Q2\n";
const char* const kTools =
    "T1 P1 D0 X0 Z0 Q2\nT2 P2 D0.762 X0 Z0 Q2\nT3 P3 D0.762 X0 Z0 Q3\nT4 P4 D0 X0 Z0 Q2\nT5 P5 D0.762 X2.54 Z5.08 "
    "Q2\nT6 P6 D0.762 X0 Z0 Q2\nT7 P7 D0.762 X0 Z0 Q6\nT8 P8 D0 X0 Z0 Q2\nT9 P9 D0 X0 Z0 Q7\nT10 P10 D0.762 X0 Z0 Q2\n";

bool isOracleThere() {
  return !QStandardPaths::findExecutable("rs274").isEmpty();
}

// The offsets of the tools above, (r, z) in mm.
ProfilePoint offsetOf(int tool) {
  return tool == 5 ? ProfilePoint(2.54, 5.08) : ProfilePoint(0, 0);
}

// Runs a program in LinuxCNC's interpreter: it gives the path of the mounted tool's tip. It runs in a folder of its
// own: it keeps variables there.
Oracle askOracle(const QByteArray& program) {
  const QTemporaryDir folder;
  const auto put = [&](const char* name, const QByteArray& bytes) {
    QFile file(folder.filePath(name));
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
  };
  Oracle oracle;
  if (!put("p.ngc", program) || !put("t.tbl", kInchTools)) return oracle;
  QProcess process;
  process.setWorkingDirectory(folder.path());
  process.start("rs274", {"-g", "-t", "t.tbl", "p.ngc"});
  oracle.isRefused = !process.waitForFinished(60'000) || process.exitCode() != 0;
  double unit = 1.0;
  ProfilePoint system(0, 0), shift(0, 0), at(0, 0), offset(0, 0), mounted(0, 0);
  static const QRegularExpression call("([A-Z_0-9]+)\\((.*)\\)");
  for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
    const QRegularExpressionMatch match = call.match(line);
    const QString name = match.captured(1);
    const QStringList a = match.captured(2).split(QRegularExpression("[ ,]+"), Qt::SkipEmptyParts);
    const auto number = [&](int i) { return unit * a.value(i).toDouble(); };
    const ProfilePoint origin = system + shift + offset - mounted;
    if (name == "USE_LENGTH_UNITS") unit = a.value(0).contains("INCH") ? 25.4 : 1.0;
    if (name == "SET_G5X_OFFSET") system = {number(1), number(3)};
    if (name == "USE_TOOL_LENGTH_OFFSET") offset = {number(0), number(2)};
    if (name == "CHANGE_TOOL") mounted = offsetOf(a.value(0).toInt());
    if (name == "SET_G92_OFFSET") shift = {number(0), number(2)};
    OracleMove move;
    move.unit = unit;
    if (name == "STRAIGHT_TRAVERSE" || name == "STRAIGHT_FEED") {
      move.isRapid = name == "STRAIGHT_TRAVERSE";
      move.to = ProfilePoint(number(0), number(2)) + origin;
    } else if (name == "ARC_FEED") {
      move.turn = a.value(4).toInt() > 0 ? 1 : -1;
      move.to = ProfilePoint(number(1), number(0)) + origin;
      move.centre = ProfilePoint(number(3), number(2)) + origin;
    } else {
      continue;
    }
    if (move.turn != 0 || (move.to - at).lpNorm<1>() > 2.5e-4 * unit) oracle.moves.push_back(move);
    at = move.to;
  }
  return oracle;
}

// Returns our moves that are longer than the resolution of rs274's output.
std::vector<ToolMove> longMoves(const ToolPath& path, double unit) {
  std::vector<ToolMove> moves;
  for (const ToolMove& m : path.moves)
    if (m.kind != ToolMove::Kind::Dwell && (m.turn != 0 || (m.to - m.from).lpNorm<1>() > 2.5e-4 * unit))
      moves.push_back(m);
  return moves;
}

ProgramSetup toolsOf(ProgramDialect dialect) {
  ProgramSetup setup;
  setup.dialect = dialect;
  setup.tools = inDialect(readToolTable(kTools).value(), ProgramDialect::LinuxCnc, dialect);
  return setup;
}

bool isSamePath(const ToolPath& a, const ToolPath& b) {
  return std::ranges::equal(longMoves(a, 1.0), longMoves(b, 1.0), [](const ToolMove& p, const ToolMove& q) {
    return p.turn == q.turn && (p.to - q.to).norm() < 1e-4 && (p.turn == 0 || (p.centre - q.centre).norm() < 1e-4);
  });
}

// Returns the difference, or nothing.
QString difference(const QByteArray& program) {
  const ProgramSetup setup = toolsOf(ProgramDialect::LinuxCnc);
  const Result<ToolPath> path = runProgram(std::string_view(program.data(), program.size()), setup);
  const Oracle oracle = askOracle(program);
  if (!path) {
    return oracle.isRefused ? QString() : "refused only here: " + QString::fromStdString(path.error().arguments.at(2));
  }
  if (oracle.isRefused) return "refused only by rs274";
  const double unit = oracle.moves.empty() ? 1.0 : oracle.moves.front().unit;
  const std::vector<ToolMove> ours = longMoves(*path, unit);
  if (ours.size() != oracle.moves.size()) return QString("%1 moves, not %2").arg(ours.size()).arg(oracle.moves.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const OracleMove& theirs = oracle.moves[i];
    double off = (ours[i].to - theirs.to).lpNorm<Eigen::Infinity>();
    if (theirs.turn != 0) off = std::max(off, (ours[i].centre - theirs.centre).lpNorm<Eigen::Infinity>());
    const bool isSame = ours[i].turn == theirs.turn && (ours[i].kind == ToolMove::Kind::Rapid) == theirs.isRapid;
    if (!isSame || off > kTolerance * theirs.unit)
      return QString("move %1 of line %2 is off by %3").arg(i).arg(ours[i].line).arg(off);
  }
  return {};
}

QByteArray fileContent(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// A contour for the cycles, with a pocket that is met in the middle of a level.
const QByteArray kContour =
    "O1 sub\nG0 X4 Z0\nG1 X8 Z-4 A0.3\nZ-8\nX5.5 Z-11\nG2 X5.5 Z-14 R4\nG1 X9 Z-16\nG3 X12 Z-19 R3\nG1 Z-24 C0.4\nX15 "
    "Z-25\nO1 endsub\n";

// A contour of lines and arcs with joints that are nearly tangent, as a program for either dialect. Fanuc's X is a
// diameter.
class JointedContour {
 public:
  // seed: the number of the contour. isRound: lengths and angles of a drawing, not random ones.
  JointedContour(int seed, bool isRound) : m_random(seed), m_isRound(isRound) {
    m_side = m_random.bounded(2) == 0 ? 42 : 41;
    m_heading = m_isRound ? 90.0 * m_random.bounded(4) * M_PI / 180.0 : m_random.bounded(2.0 * M_PI);
    m_entry = m_at - std::polar(12.0, m_heading);
    const int count = 2 + m_random.bounded(5);
    for (int i = 0; i < count; ++i) {
      if (i > 0) m_heading += joint();
      m_random.bounded(5) < 3 ? addLine() : addArc();
    }
  }

  QByteArray linuxCnc(const QByteArray& units = "G21") const {
    return "G18 G8 " + units + " F100 S200 M3\nT2 M6 G43\nG0" + words(m_entry, 1.0) + "\nG" + number(m_side) + " G1" +
           text(1.0) + "G40 G1" + words(m_at + std::polar(5.0, m_heading), 1.0) + "\nM2\n";
  }
  QByteArray fanuc() const {
    return "G98 F100 G97 S200 M3\nT0202\nG0" + words(m_entry, 2.0) + "\nG" + number(m_side) + " G1" + text(2.0) +
           "G40 G1" + words(m_at + std::polar(5.0, m_heading), 2.0) + "\nM30\n";
  }

 private:
  struct Move {
    int turn = 0;
    PlanePoint to, centre;  // centre: from the start of the arc
  };

  static QByteArray number(double value) { return QByteArray::number(value, 'f', value == std::round(value) ? 0 : 5); }
  static QByteArray words(const PlanePoint& p, double scale) {
    return " X" + number(scale * p.imag()) + " Z" + number(p.real());
  }
  QByteArray text(double scale) const {
    QByteArray all = words(m_begin, scale) + "\n";
    for (const Move& move : m_moves) {
      all += move.turn == 0 ? "G1" : move.turn > 0 ? "G3" : "G2";
      all += words(move.to, scale);
      if (move.turn != 0) all += " I" + number(move.centre.imag()) + " K" + number(move.centre.real());
      all += "\n";
    }
    return all;
  }

  double joint() {
    constexpr double kJoints[] = {0.0, 0.002, 0.0095, 0.02, 0.049, 0.051, 0.7};
    const double angle = m_random.bounded(3) == 0 ? m_random.bounded(0.1) : kJoints[m_random.bounded(7)];
    return m_random.bounded(2) == 0 ? angle : -angle;
  }
  double length() { return m_isRound ? 0.5 * (2 + m_random.bounded(12)) : 0.2 + m_random.bounded(6.0); }
  void addLine() {
    m_at += std::polar(length(), m_heading);
    m_moves.push_back({0, m_at, {}});
  }
  void addArc() {
    const int turn = m_random.bounded(2) == 0 ? 1 : -1;
    const double radius = 0.4 + length();
    const double sweep = m_isRound ? M_PI_2 * (1 + m_random.bounded(2)) : 0.05 + m_random.bounded(3.0);
    const PlanePoint centre = std::polar(radius, m_heading + turn * M_PI_2);
    m_at += centre - centre * std::polar(1.0, turn * sweep);
    m_heading += turn * sweep;
    m_moves.push_back({turn, m_at, centre});
  }

  QRandomGenerator m_random;
  bool m_isRound;
  int m_side = 0;
  double m_heading = 0.0;
  PlanePoint m_begin{-50.0, 100.0}, m_at = m_begin, m_entry;
  std::vector<Move> m_moves;
};

}  // namespace

// Tool paths against those of LinuxCNC's own interpreter, rs274 of the Debian package linuxcnc-uspace.
class ProgramOracleTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    if (!isOracleThere()) QSKIP("rs274 is not installed (package linuxcnc-uspace): nothing is compared");
  }

  void ownPrograms_data() {
    QTest::addColumn<QByteArray>("program");
    const QByteArray begin = "G18 G21 G8 F100 S200 M3\n";
    QTest::newRow("lines and arcs")
        << begin +
               "G0 X10 Z2\nG1 Z-5\nG2 X12 Z-7 R2\nG3 X15 Z-10 I0 K-3\nG91\nG1 X2 Z-1\nG2 X2 "
               "Z-2 I2\nG90 G90.1\nG3 X22 Z-16 I19 K-16\n";
    QTest::newRow("inches and diameters")
        << QByteArray("G18 G20 G7 F5\nG0 X2 Z.1\nG1 X1.5\nZ-1\nG2 X2 Z-1.25 R.25\nG21\nG0 X60\n");
    QTest::newRow("negative radius") << begin + "G0 X10 Z0\nG3 X10 Z-3 R-2\n";
    QTest::newRow("offsets")
        << begin +
               "T5 M6 G43\nG0 X10 Z5\nG92 X3 Z1\nG1 X4\nG92.1\nG1 X6 Z0\nG10 L2 P2 X5 Z-3\nG55\nG0 "
               "X1 Z1\nG52 Z4\nG1 Z2\nG54\nG53 G0 X50\nG28 X20\nG30\nG49\nG0 X1\n";
    QTest::newRow("kept offsets")
        << begin +
               "G0 X1 Z1\nG92 X3 Z1\nG0 X4\nG92.2\nG0 X5\nG92.3\nG0 X6\nG92.1\nG0 X7\nG92.3\nG0 X8\nG52 X2\nG0 "
               "X9\nG92.2\nG0 X10\nG92.3\nG0 X11\n";
    QTest::newRow("saved modes")
        << begin +
               "G10 L2 P2 X5 Z3\nG0 X1\nG1 F100 X2\nM70\nT2 M6 G55\nG91 F7\nG0 X3\nS300 M3\nM72\nX2\nT5 M6 G43\n"
               "M73\nG0 X4 Z9\nG59 G91\nX5\n";
    QTest::newRow("modes of a subprogram")
        << begin + "G10 L2 P2 X5 Z3\no1 sub\nM73\nG55 G91\nG0 X3\no1 endsub\nG0 X1\no1 call\nX2\n";
    QTest::newRow("tool without offset") << begin + "T5 M6\nG0 X10 Z5\nG43 H2\nG0 X11\nG43\nG0 X12\nT2 M6\nG0 X13\n";
    QTest::newRow("feeds") << begin +
                                  "G0 X10 Z0\nG95 F0.2\nG1 Z-5\nG93\nG1 X12 F2\nG94 F80\nG1 X13\nG96 D1500 S100\nG1 "
                                  "X5\nG97 S300\nG4 P0.5\nG33 Z-20 K1.5\n";
    QTest::newRow("drilling") << begin +
                                     "G0 X0 Z3\nG17 G98\nG83 Z-10 R1 Q3\nG99\nG73 Z-12 R1 Q4\nG81 Z-5 R0\nG82 Z-6 R0.5 "
                                     "P1\nG80\nG18\nG0 X9\n";
    QTest::newRow("roughing") << begin + kContour + "G0 X20 Z5\nG71 Q1 X16 Z2 D0.25 I1.3 R0.4\nG0 X30\n";
    QTest::newRow("no pockets") << begin + kContour + "G0 X20 Z5\nG71.1 Q1 X16 Z2 D0.25 I0.7 R0.4\nG0 X30\n";
    QTest::newRow("only pockets") << begin + kContour + "G0 X20 Z5\nG71.2 Q1 X16 Z2 D0.2 I0.5 R0.2\nG0 X30\n";
    QTest::newRow("facing") << begin +
                                   "O1 sub\nG0 Z-12 X14\nG1 X12 Z-10\nZ-8\nG3 X9 Z-5 R3\nG1 X5 Z-3\nZ0\nO1 endsub\nG0 "
                                   "X20 Z5\nG72 Q1 X16 Z2 D0.2 I0.8 R0.3\n";
    QTest::newRow("boring")
        << begin +
               "O1 sub\nG0 X12 Z0\nG1 Z-5\nX9 Z-9\nZ-15\nX6\nO1 endsub\nG0 X4 Z5\nG71 Q1 X4 Z2 D0.2 "
               "I0.8 R0.3\n";
    QTest::newRow("finishing") << begin + kContour + "G0 X20 Z5\nG70 Q1 X16 Z2 D0.6 E0.1 P3\nG0 X30\n";
    QTest::newRow("diameter roughing") << "G18 G21 G7 F100\n" + kContour + "G0 X40 Z5\nG71 Q1 X34 Z2 D0.3 I1 R0.4\n";
    // In the contour of a cycle the position is that of the contour, before and after it that of the tool.
    QTest::newRow("contour by its position") << QByteArray(
        "G18 G21 G8 G90 G94 F100 S500 M3\no5 sub\nG0 X5 Z0\nG1 Z[#<_z>-6]\nG1 X[#<_x>+4]\nG1 Z[#<_z>-6]\nG1 "
        "X[#<_x>+4]\no5 endsub\nG0 X18 Z3\nG71 Q5 X16 Z1 D0.2 I1 R0.4\n");
    QTest::newRow("contour by its position, diameters") << QByteArray(
        "G18 G21 G7 F100\nT5 M6 G43\nG10 L2 P1 X3 Z-2\no5 sub\nG0 X[#5420*2-22] Z[#5422-1+#5421+#<_y>]\nG1 "
        "Z[#<_z>-6]\nX[2*#<_x>+8] Z[#5422-3]\nG3 X[2*#<_x>+4] Z[#<_z>-2] R2\no5 endsub\nG0 X36 Z3\nG71 Q5 X32 "
        "Z1 D0.2 I1 R0.4\nG0 X[2*#<_x>+4] Z[#5422+5]\nG70 Q5 X32 Z1\nG0 X[2*#5420+4] Z[#<_z>+5]\n");
    QTest::newRow("face by its position, inches") << QByteArray(
        "G18 G20 G8 F5\nG92 X1 Z1\no5 sub\nG0 Z-.5 X[#<_x>]\nG1 X[#5420-.2]\nZ[#<_z>+.2]\nX[#<_x>-.2] "
        "Z[#5422+.1]\no5 endsub\nG0 X.8 Z.1\nG72 Q5 X.7 Z.05 D0.01 I.04 R.02\nG0 X[#<_x>+.1]\n");
    QTest::newRow("compensation")
        << begin +
               "T2 M6 G43\nG0 X20 Z10\nG42 G0 X8 Z3\nG1 Z-2\nX10 Z-4\nZ-8\nG2 X12 Z-10 R2\nG1 "
               "X14\nG3 X16 Z-12 R2\nG1 Z-15\nX20\nG40 G0 X30\n";
    QTest::newRow("left") << begin +
                                 "T7 M6 G43\nG0 X20 Z-30\nG41 G1 X15 Z-20\nG1 X12 Z-15\nG3 X10 Z-13 R2\nG1 Z-5\nX8 "
                                 "Z-2\nG40 G0 Z20\n";
    QTest::newRow("thread") << begin + "G0 X20 Z5\nG76 P1.5 Z-20 I-1 J0.2 K0.92 R2 Q29.5 H2 E1 L3\n";
    QTest::newRow("inside thread") << begin + "G7\nG0 X20 Z5\nG76 P1 Z-20 I2 J0.2 K1 R1.4 Q15\n";
    QTest::newRow("comment before another") << begin + "G1 X5 (abort, not the last one)(of this line)\nG1 X9\n";
    QTest::newRow("comment behind a semicolon")
        << begin + "G1 X5 ; (abort, no)\no1 if [0]\n(abort, no)\no1 endif\nG1 X9\n";
    QTest::newRow("loops") << begin +
                                  "o<r> sub\n#1=[#1+0]\no1 repeat [3]\nG0 X#1\n#1=[#1-1]\no2 if [#1 lt 18.5]\nG1 "
                                  "Z[-#1]\no2 else\nG1 Z#2\no2 endif\no1 endrepeat\no<r> endsub\no<r> call [20] [-4]\n";
  }
  void ownPrograms() {
    QFETCH(QByteArray, program);
    const QString problem = difference(program + "M2\n");
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
  }

  // Contours with joints from tangent to 0.1 rad, some sharp, convex and concave. Where the nose does not fit for
  // rs274, it does not for us. A Fanuc takes the same path, as these entries are square to the contour, too.
  void nearlyTangentJoints() {
    std::size_t accepted = 0;
    for (int seed = 0; seed < kContours; ++seed) {
      const JointedContour contour(seed, seed % 2 == 0);
      const QByteArray program = contour.linuxCnc(seed % 5 == 0 ? "G20" : "G21");
      const QString problem = difference(program);
      QVERIFY2(problem.isEmpty(), qPrintable(problem + "\n" + program));
      const auto path = runProgram(contour.linuxCnc("G21").toStdString(), toolsOf(ProgramDialect::LinuxCnc));
      const auto fanuc = runProgram(contour.fanuc().toStdString(), toolsOf(ProgramDialect::Fanuc));
      if (!path) continue;
      ++accepted;
      QVERIFY2(fanuc && isSamePath(*path, *fanuc), contour.fanuc().constData());
    }
    QVERIFY(accepted > kContours * 9 / 10);
  }

  // Written programs of recorded passes, of bores, too.
  void writtenPasses() {
    const std::string text =
        programText(movesOf(test::bushPasses(), test::kBushBar, 100.0, {}), ProgramDialect::LinuxCnc, "bush");
    const QString problem = difference(QByteArray::fromStdString(text));
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
  }

  // Programs that both LinuxCNC and we refuse.
  void bothRefuse_data() {
    QTest::addColumn<QByteArray>("program");
    QTest::newRow("narrow corner") << QByteArray("T2 M6\nG0 X20 Z10\nG42 G1 X8 Z3 F9\nG1 Z2\nX8.2 Z2.1\nX20 Z2\nM2\n");
    QTest::newRow("short entry") << QByteArray("G18 T2 M6\nG0 X20 Z10\nG42 G1 X20.1 F9\nM2\n");
    QTest::newRow("arc after G40") << QByteArray("G18 T2 M6\nG0 X9\nG42 G1 X5 F9\nG1 Z-5\nG40\nG2 X9 Z-9 R4\nM2\n");
    QTest::newRow("words behind if") << QByteArray("o1 if [1 EQ 1] G0 X77\no1 endif\nM2\n");
    QTest::newRow("words behind repeat") << QByteArray("o1 repeat [2] G0 X5\nG0 X3\no1 endrepeat\nM2\n");
    QTest::newRow("words behind endwhile")
        << QByteArray("#1=0\no1 while [#1 lt 2]\n#1=[#1+1]\no1 endwhile G0 X3\nM2\n");
    QTest::newRow("backwards contour") << QByteArray(
        "G18 F9\nO1 sub\nG0 X5\nG1 Z-5\nX7 Z-2\nX9\nO1 endsub\nG71 Q1 X10 Z2\nM2\n");
    QTest::newRow("abort") << QByteArray("G18 F9\nG1 X5\n(Abort, too large)\nG1 X9\nM2\n");
    QTest::newRow("abort behind words") << QByteArray("G18 F9\nG1 X5 (first) ( abort,too large)\nG1 X9\nM2\n");
  }
  void bothRefuse() {
    QFETCH(QByteArray, program);
    QVERIFY(askOracle(program).isRefused);
    QVERIFY(!runProgram(program.toStdString(), toolsOf(ProgramDialect::LinuxCnc)));
  }

  void realPrograms_data() {
    QTest::addColumn<QString>("path");
    const QString folder = qEnvironmentVariable("HANDWHEEL_DATA");
    if (folder.isEmpty()) QSKIP("HANDWHEEL_DATA is not set");
    QDirIterator files(folder + "/lathe/linuxcnc", {"*.ngc"}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) QTest::newRow(qPrintable(files.next())) << files.filePath();
  }
  void realPrograms() {
    QFETCH(QString, path);
    const QByteArray program = fileContent(path) + "\nM2\n";  // rs274 wants an end
    const QString problem = difference(program);
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
  }
};

HANDWHEEL_TEST(ProgramOracleTest)
#include "ProgramOracleTest.moc"
