// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StepFiles.h"
#include "TestClass.h"
#include "document/formats/step/StepReader.h"

#include <sys/wait.h>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <random>
#include <thread>

using namespace handwheel;

namespace {

// A sound mesh, or an error about this file. What it is differs with the version of the library.
bool isSoundAnswer(const Result<MeshFile>& read) {
  if (!read) {
    const ErrorCode code = read.error().code;
    return code == ErrorCode::LibraryFailed || code == ErrorCode::CountMismatch || code == ErrorCode::OutOfMemory ||
           code == ErrorCode::FileEmpty;
  }
  const TriangleSoup& soup = read->soup;
  return !soup.triangles.empty() &&
         std::all_of(soup.points.begin(), soup.points.end(), [](const Vec3& p) { return p.allFinite(); }) &&
         std::all_of(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
           return std::all_of(t.begin(), t.end(), [&](std::uint32_t corner) { return corner < soup.points.size(); });
         });
}

Result<MeshFile> readStepText(const std::string& bytes) {
  return readMesh(bytes, "part.step", {.partial = true, .stepChord = 1e-2});
}

std::string withData(const std::string& lines) {
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
         "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n" +
         lines + "ENDSEC;\nEND-ISO-10303-21;\n";
}

std::string nested(int depth) {
  return withData("#1=DIRECTION(''," + std::string(depth, '(') + "1." + std::string(depth, ')') + ");\n");
}

// Returns one of the files with up to seven bytes changed as a fuzzer does.
std::string mutated(std::mt19937& random) {
  const auto below = [&random](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  std::string bytes = test::stepFile(test::kStepFiles[below(std::size(test::kStepFiles))]);
  for (std::size_t i = 1 + below(7); i > 0; --i) {
    const std::size_t at = below(bytes.size());
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes.erase(at, 1 + below(16));
        break;
      case 2:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(64)));
        break;
      case 3:  // another number, or another reference
        if (const std::size_t digit = bytes.find_first_of("0123456789", at); digit != std::string::npos)
          bytes[digit] = static_cast<char>('0' + below(10));
        break;
      default:
        bytes.insert(at, std::string(1 + below(9), '9'));
    }
  }
  return bytes;
}

}  // namespace

// Any file is read or refused, and its process is gone.
class StepHostileTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { QVERIFY(waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD); }

  void nothing() {
    for (const char* bytes : {"ISO-10303-21", "ISO-10303-21;", "ISO-10303-21;\nHEADER;", "x", "\n"}) {
      const auto read = readMesh(bytes, "part.step", {});
      QVERIFY2(!read && read.error().code == ErrorCode::LibraryFailed, bytes);
    }
    QCOMPARE(readMesh("", "part.step", {}).error().code, ErrorCode::FileEmpty);
    QVERIFY(!readMesh(withData(""), "part.step", {}));
  }

  void truncated_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : test::kStepFiles) QTest::newRow(name) << name;
  }
  void truncated() {
    QFETCH(QString, name);
    const std::string whole = test::stepFile(name.toStdString());
    for (std::size_t eighth = 0; eighth < 8; ++eighth)
      QVERIFY(isSoundAnswer(readStepText(whole.substr(0, whole.size() * eighth / 8 + eighth % 3))));
  }

  void nestedDeeply() {
    for (int depth : {1000, 100'000, 10'000'000}) QVERIFY(isSoundAnswer(readStepText(nested(depth))));
  }

  // Each entity is its own part, or that of the next.
  void endlessReferences() {
    std::string chain;
    constexpr int kLinks = 200'000;
    for (int i = 1; i <= kLinks; ++i)
      chain += "#" + std::to_string(i) + "=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#" +
               std::to_string(i % kLinks + 1) + ");\n";
    QVERIFY(isSoundAnswer(readStepText(withData(chain))));
    const std::string box = test::stepFile("box-inch.step");
    QVERIFY(
        isSoundAnswer(readStepText(test::replaced(box, "MANIFOLD_SOLID_BREP('',#16)", "MANIFOLD_SOLID_BREP('',#15)"))));
    const std::string parts = test::stepFile("two-drilled.step");
    const std::size_t link = parts.find("NEXT_ASSEMBLY_USAGE_OCCURRENCE(");
    QVERIFY(link != std::string::npos);
    const std::size_t first = parts.find(",#", link), second = parts.find(",#", first + 1),
                      end = parts.find(',', second + 1);
    std::string within = parts;  // an assembly within itself
    within.replace(second, end - second, parts.substr(first, second - first));
    QVERIFY(isSoundAnswer(readStepText(within)));
  }

  void hugeNumbers() {
    const std::string sphere = test::stepFile("sphere.step");
    for (const char* radius : {"1.E308", "1.E-308", "-10.", "0.", "1.E999", "9999999999999999999999", "NAN"})
      QVERIFY2(isSoundAnswer(readStepText(test::replaced(sphere, ",10.)", std::string(",") + radius + ")"))), radius);
    for (const char* number : {"#99999999999999999999", "#-1", "#0", "#2147483648"})
      QVERIFY2(isSoundAnswer(readStepText(withData(std::string(number) + "=DIRECTION('',(1.,0.,0.));\n"))), number);
    std::string curve = "#1=B_SPLINE_CURVE_WITH_KNOTS('',2147483647,(";
    curve += "#2,#2),.UNSPECIFIED.,.F.,.F.,(2147483647,2147483647),(0.,1.),.UNSPECIFIED.);\n";
    QVERIFY(isSoundAnswer(readStepText(withData(curve + "#2=CARTESIAN_POINT('',(0.,0.,0.));\n"))));
  }

  void anyBytesChanged() {
    constexpr int kFiles = 240;
    std::atomic<int> next{0}, unsound{0}, readable{0};
    const auto work = [&] {
      for (int i = next++; i < kFiles; i = next++) {
        std::mt19937 random(static_cast<std::uint32_t>(i));
        const std::string bytes = mutated(random);
        const auto read = readStepText(bytes);
        if (read) ++readable;
        if (isSoundAnswer(read)) continue;
        ++unsound;
        qWarning("the file made from the number %d", i);
      }
    };
    std::thread other(work);
    work();
    other.join();
    QCOMPARE(unsound.load(), 0);
    QVERIFY(readable > kFiles / 20);  // not all are refused at once
  }

  // Readers with unexpected answers: shell scripts instead of the reader.
  void answersAreJudged_data() {
    QTest::addColumn<QByteArray>("answer");
    const QByteArray points =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
        "property double z\nelement face 1\nproperty list uchar uint vertex_indices\nend_header\n";
    const QByteArray corners = "0 0 0\n1 0 0\n0 1 0\n";
    QTest::newRow("no line") << QByteArray("ply");
    QTest::newRow("too few words") << "1 1 1 0 1 0 mm\n" + points + corners + "3 0 1 2\n";
    QTest::newRow("negative") << "1 1 -1 0 1 0 0.1 mm\n" + points + corners + "3 0 1 2\n";
    QTest::newRow("more than all") << "1 2 1 0 1 0 0.1 mm\n" + points + corners + "3 0 1 2\n";
    QTest::newRow("below zero") << "1 1 1 0 1 0 -0.1 mm\n" + points + corners + "3 0 1 2\n";
    QTest::newRow("not finite") << "1 1 1 0 1 0 nan mm\n" + points + corners + "3 0 1 2\n";
    QTest::newRow("control characters") << "1 1 1 0 1 0 0.1 \x1b[2J\n" + points + corners + "3 0 1 2\n";
    QTest::newRow("a corner that is not there") << "1 1 1 0 1 0 0.1 mm\n" + points + corners + "3 0 1 3\n";
    QTest::newRow("a point that is none") << "1 1 1 0 1 0 0.1 mm\n" + points + "nan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    QTest::newRow("too few triangles") << "1 1 1 0 1 0 0.1 mm\n" + points + corners;
    QTest::newRow("no triangles") << QByteArray("1 1 1 0 1 0 0.1 mm\n");
  }
  void answersAreJudged() {
    QFETCH(QByteArray, answer);
    const auto read = readFrom(answer);
    QVERIFY(!read);
    QCOMPARE(read.error().arguments, std::vector<std::string>({"Open CASCADE", "its answer is not valid"}));
  }

  // Unread parts are damage, which users may accept.
  void partsAndFacesThatAreLost() {
    const QByteArray answer =
        "3 2 1 0 5 4 0.1 millimetre\nply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
        "property double z\nelement face 1\nproperty list uchar uint vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    const auto strict = readFrom(answer);
    QVERIFY(!strict);
    QCOMPARE(strict.error().code, ErrorCode::CountMismatch);
    const auto partial = readFrom(answer, {.partial = true});
    QVERIFY(partial);
    QCOMPARE(partial->damage.size(), std::size_t{2});
    QCOMPARE(partial->damage[0].arguments, std::vector<std::string>({"parts that can be read", "3", "2"}));
    QCOMPARE(partial->damage[1].arguments, std::vector<std::string>({"faces that can be triangulated", "5", "1"}));
    QCOMPARE(partial->soup.triangles.size(), std::size_t{1});
  }

 private:
  // Reads a file with a reader that gives this answer.
  static Result<MeshFile> readFrom(const QByteArray& answer, const ReadOptions& options = {}) {
    const QTemporaryDir folder;
    QFile content(folder.filePath("answer"));
    if (!content.open(QIODevice::WriteOnly) || content.write(answer + "c") < 0) qFatal("cannot write");
    content.close();
    QFile program(folder.filePath("step"));
    if (!program.open(QIODevice::WriteOnly)) qFatal("cannot write");
    program.write("#!/bin/sh\nexec cat '" + content.fileName().toUtf8() + "'\n");
    program.close();
    program.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    qputenv("HANDWHEEL_READERS", folder.path().toUtf8());
    auto read = readMesh("ISO-10303-21;", "part.step", options);
    qunsetenv("HANDWHEEL_READERS");
    return read;
  }
};

HANDWHEEL_TEST(StepHostileTest)
#include "StepHostileTest.moc"
