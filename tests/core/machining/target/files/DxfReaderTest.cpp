// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/files/DxfReader.h"

#include "../AnyProfile.h"
#include "TestClass.h"
#include "machining/target/TargetErrors.h"

#include <QtTest>
#include <random>

using namespace handwheel;
using test::isAt;

namespace {

// Groups written as words: "0 LINE 8 0 10 1.5 …"; a value without blanks.
std::string groups(const std::string& words) {
  std::string text = words;
  std::replace(text.begin(), text.end(), ' ', '\n');
  return text + "\n";
}

std::string fileOf(const std::string& entities, const std::string& header = "") {
  return groups("0 SECTION 2 HEADER" + header + " 0 ENDSEC 0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF");
}

std::vector<ProfileSegment> curvesIn(const std::string& entities, const std::string& header = "") {
  const auto read = readDxf(fileOf(entities, header));
  return read ? read->curves : std::vector<ProfileSegment>();
}

}  // namespace

class DxfReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void lines() {
    const auto all = curvesIn("0 LINE 8 0 10 1 20 2 30 0 11 3 21 4 31 0");
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY(isAt(all[0].from, 1, 2) && isAt(all[0].to, 3, 4) && !all[0].isArc());
  }

  void units() {
    for (const auto& [code, factor] : {std::pair{1, 25.4}, {2, 304.8}, {4, 1.0}, {5, 10.0}, {6, 1000.0}, {0, 1.0}}) {
      const auto read = readDxf(fileOf("0 LINE 10 1 20 2 11 3 21 4", " 9 $INSUNITS 70 " + std::to_string(code)));
      QVERIFY(read.hasValue());
      QCOMPARE(read->hasUnit, code != 0);
      QVERIFY(isAt(read->curves[0].to, 3 * factor, 4 * factor));
    }
  }

  // AutoCAD's codes: microinches, mils, yards, micrometres, decimetres; 3, miles, is none for a part.
  void rareUnits() {
    for (const auto& [code, factor] :
         {std::pair{8, 25.4e-6}, {9, 0.0254}, {10, 914.4}, {13, 1e-3}, {14, 100.0}, {3, 1.0}}) {
      const auto read = readDxf(fileOf("0 LINE 10 1 20 2 11 3 21 4", " 9 $INSUNITS 70 " + std::to_string(code)));
      QVERIFY(read.hasValue());
      QCOMPARE(read->hasUnit, code != 3);
      QVERIFY(std::abs(read->curves[0].to.x() / factor - 3.0) < 1e-12);
    }
  }

  void arcs() {
    const auto all = curvesIn("0 ARC 10 5 20 6 40 2 50 270 51 90");
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY(isAt(all[0].from, 5, 4) && isAt(all[0].to, 5, 8) && isAt(all[0].at(0.5), 7, 6));
    const auto large = curvesIn("0 ARC 10 0 20 0 40 1 50 0 51 270");  // in two pieces
    QCOMPARE(large.size(), std::size_t{2});
    QVERIFY(isAt(large[0].at(0.0), 1, 0) && isAt(large[1].to, 0, -1) && isAt(large[0].centre(), 0, 0));
    const auto circle = curvesIn("0 CIRCLE 10 0 20 0 40 3");
    QCOMPARE(circle.size(), std::size_t{2});
    QVERIFY(circle[0].from == circle[1].to);
    // Seen from behind: mirrored.
    const auto behind = curvesIn("0 ARC 10 5 20 6 40 2 50 270 51 90 210 0 220 0 230 -1");
    QVERIFY(isAt(behind[0].at(0.5), -7, 6));
  }

  void polylines() {
    const auto light = curvesIn("0 LWPOLYLINE 90 3 70 1 10 0 20 0 42 1 10 10 20 0 10 10 20 5");
    QCOMPARE(light.size(), std::size_t{3});
    // A bulge of 1 is half a circle, to the right of the chord.
    QVERIFY(isAt(light[0].at(0.5), 5, -5) && !light[1].isArc() && isAt(light[2].to, 0, 0));
    const auto old = curvesIn(
        "0 POLYLINE 8 0 66 1 10 0 20 0 70 0 0 VERTEX 8 0 10 0 20 0 42 -1 0 VERTEX 10 10 20 0 0 VERTEX 10 10 20 5 0 "
        "SEQEND 0 LINE 10 1 20 1 11 2 21 2");
    QCOMPARE(old.size(), std::size_t{3});
    QVERIFY(isAt(old[0].at(0.5), 5, 5) && isAt(old[1].to, 10, 5) && isAt(old[2].to, 2, 2));
  }

  void ellipses() {
    const auto all = curvesIn("0 ELLIPSE 10 0 20 0 11 10 21 0 40 0.5 41 0 42 3.14159265358979");
    QVERIFY(all.size() > 3);
    for (const ProfileSegment& s : all) {
      const ProfilePoint p = s.at(0.5);
      QVERIFY(std::abs(std::hypot(p.x() / 10, p.y() / 5) - 1.0) < 1e-4);
    }
  }

  // A quarter with the half axes 10 along x and 5 about the normal: up with +z, down with -z.
  void ellipsesSeenFromBehind() {
    const auto front = curvesIn("0 ELLIPSE 10 1 20 2 11 10 21 0 40 0.5 41 0 42 1.5707963267948966 210 0 220 0 230 1");
    QVERIFY(isAt(front.front().from, 11, 2) && isAt(front.back().to, 1, 7));
    const auto behind = curvesIn("0 ELLIPSE 10 1 20 2 11 10 21 0 40 0.5 41 0 42 1.5707963267948966 210 0 220 0 230 -1");
    QVERIFY(isAt(behind.front().from, 11, 2) && isAt(behind.back().to, 1, -3));
  }

  void theAxis() {
    const auto read = readDxf(fileOf("0 LINE 8 0 10 0 20 9 11 5 21 9 0 LINE 8 AXIS 10 0 20 7 11 5 21 7"));
    QVERIFY(read.hasValue() && read->axis.has_value());
    QCOMPARE(*read->axis, 7.0);
    QCOMPARE(read->curves.size(), std::size_t{1});
    const auto byType = readDxf(fileOf("0 LINE 8 0 10 0 20 9 11 5 21 9 0 LINE 8 0 6 CENTER2 10 0 20 3 11 5 21 3"));
    QCOMPARE(*byType->axis, 3.0);
  }

  void leavesOut() {
    const auto read = readDxf(
        fileOf("0 TEXT 10 1 20 1 40 3 1 hello 0 TEXT 10 1 20 1 0 LINE 60 1 10 1 20 2 11 3 21 4 0 LINE 67 1 10 1 20 2 "
               "11 3 21 4 0 ARC 210 1 220 0 230 0 40 1 0 LINE 10 0 20 1 11 5 21 1"));
    QVERIFY(read.hasValue());
    QCOMPARE(read->curves.size(), std::size_t{1});
    QCOMPARE(read->others.at("TEXT"), std::size_t{2});
    QCOMPARE(read->others.at("ARC"), std::size_t{1});  // in another plane
    // A vertex of no polyline.
    const auto stray = readDxf(fileOf("0 VERTEX 70 16 10 1 20 2 42 1 0 LINE 10 0 20 1 11 5 21 1"));
    QVERIFY(stray.hasValue());
    QCOMPARE(stray->curves.size(), std::size_t{1});
  }

  void refuses() {
    const auto code = [](const std::string& bytes) {
      const auto read = readDxf(bytes);
      return read ? ErrorCode() : read.error().code;
    };
    QCOMPARE(code("AutoCAD Binary DXF\r\n\x1a"), ErrorCode(TargetError::BinaryDrawing));
    QCOMPARE(code(""), ErrorCode(TargetError::NoProfile));
    QCOMPARE(code(fileOf("0 TEXT 10 1 20 1")), ErrorCode(TargetError::NoProfile));
    QCOMPARE(code(fileOf("0 LINE 10 x 20 1")), ErrorCode(ErrorCode::NumberMalformed));
    QCOMPARE(code(fileOf("0 LINE 10 nan 20 1")), ErrorCode(ErrorCode::NumberNotFinite));
    QCOMPARE(code(fileOf("0 LINE 10 1e999 20 1")), ErrorCode(ErrorCode::NumberNotFinite));
    QCOMPARE(code(fileOf("0 CIRCLE 10 0 20 0 40 -3")), ErrorCode(ErrorCode::ElementMalformed));
    QCOMPARE(code("0\nSECTION\nxyz\n1\n"), ErrorCode(ErrorCode::ElementMalformed));
    QCOMPARE(readDxf(fileOf("0 LINE 10 x 20 1")).error().position.value, std::uint64_t{14});
    JobState state;
    state.cancelled = true;
    QCOMPARE(readDxf(fileOf("0 LINE 10 1 20 1"), Progress(state)).error().code, ErrorCode(ErrorCode::Cancelled));
  }

  void limits() {
    std::string many;
    for (std::size_t i = 0; i <= TargetProfile::kMostSegments; ++i) many += " 0 LINE 10 1 20 2 11 3 21 4";
    const Error segments = readDxf(fileOf(many.substr(1))).error();
    QCOMPARE(segments.code, ErrorCode(ErrorCode::FileTooLarge));
    QCOMPARE(segments.arguments.at(0), std::string("segments"));
    const Error bytes = readDxf(std::string((std::size_t{64} << 20) + 1, '\n')).error();
    QCOMPARE(bytes.code, ErrorCode(ErrorCode::FileTooLarge));
    QCOMPARE(bytes.arguments.at(0), std::string("bytes"));
  }

  void recognised() {
    QVERIFY(looksLikeDxf(fileOf("0 LINE 10 1 20 2 11 3 21 4")));
    QVERIFY(looksLikeDxf("999\nmade by hand\r\n  0\r\nSECTION\r\n"));
    QVERIFY(looksLikeDxf("AutoCAD Binary DXF\r\n"));
    for (const char* other : {"", "solid a\n", "ISO-10303-21;", "<svg/>", "0\n1\n2\n3\n", "12"})
      QVERIFY(!looksLikeDxf(other));
  }

  // Bytes changed at random are refused or read, and end.
  void mutations() {
    const std::string sound = fileOf(
        "0 LWPOLYLINE 90 3 70 1 10 0 20 0 42 1 10 10 20 0 10 10 20 5 0 ELLIPSE 10 0 20 0 11 10 21 0 40 0.5 41 0 42 3 0 "
        "POLYLINE 66 1 0 VERTEX 10 0 20 0 42 -1 0 VERTEX 10 9 20 9 0 SEQEND 0 ARC 10 5 20 6 40 2 50 270 51 90");
    std::mt19937 random(7);
    for (int i = 0; i < 3000; ++i) {
      std::string bytes = sound;
      for (int k = 0; k < 4; ++k) bytes[random() % bytes.size()] = "0123456789-.e\nAE"[random() % 16];
      const auto read = readDxf(bytes);
      if (read) (void)targetIn(*read);
    }
  }
};

HANDWHEEL_TEST(DxfReaderTest)
#include "DxfReaderTest.moc"
