// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/files/SvgReader.h"

#include "../AnyProfile.h"
#include "TestClass.h"
#include "machining/target/TargetErrors.h"
#include "machining/target/files/SvgPath.h"

#include <QtTest>
#include <random>

using namespace handwheel;
using test::isAt;

namespace {

constexpr const char* kAxis = "<line id=\"axis\" x1=\"0\" y1=\"0\" x2=\"9\" y2=\"0\"/>";

std::string svg(const std::string& content, const std::string& attributes = "width=\"100mm\" viewBox=\"0 0 100 50\"") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">" + kAxis + content + "</svg>";
}

std::vector<ProfileSegment> curves(const std::string& content,
                                   const std::string& attributes = "width=\"100mm\" viewBox=\"0 0 100 50\"") {
  const auto read = readSvg(svg(content, attributes));
  return read ? read->curves : std::vector<ProfileSegment>();
}

std::vector<ProfileSegment> path(const std::string& d) {
  return curves("<path d=\"" + d + "\"/>");
}

}  // namespace

class SvgReaderTest : public QObject {
  Q_OBJECT

 private slots:
  void paths() {
    const auto all = path("M1,2 L 3 4H5V6h-1v-1l1 1 2-2z");
    QCOMPARE(all.size(), std::size_t{8});
    QVERIFY(isAt(all[0].from, 1, -2) && isAt(all[0].to, 3, -4));  // y is turned up
    QVERIFY(isAt(all[2].to, 5, -6) && isAt(all[4].to, 4, -5) && isAt(all[6].to, 7, -4) && isAt(all[7].to, 1, -2));
    QCOMPARE(path("M.5.5-1-2 3e0,1e1").size(), std::size_t{2});
    QVERIFY(isAt(path("m 1 1 2 2 m 5 5 1 0")[1].to, 9, -8));
  }

  void circularArcs() {
    // A quarter around (0, 10): to the right and down as SVG sees it.
    const auto all = path("M 0 0 A 10 10 0 0 1 10 10");
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY(isAt(all[0].centre(), 0, -10) && std::abs(all[0].radius() - 10) < 1e-9);
    const auto large = path("M0 0a10 10 0 11 10 10");  // flags without separators
    QCOMPARE(large.size(), std::size_t{2});
    QVERIFY(isAt(large[0].centre(), 10, 0));
    QVERIFY(std::abs(large[0].angle() + large[1].angle() - (-1.5 * M_PI)) < 1e-9);
    // Too small a radius grows until it reaches.
    QVERIFY(std::abs(path("M0 0 A 1 1 0 0 1 10 0")[0].radius() - 5.0) < 1e-6);
    QVERIFY(!path("M0 0 A 0 5 0 0 1 10 0")[0].isArc());
  }

  void otherCurves() {
    // A circle as Bézier curves draw it, off by up to 0.027 % of its radius.
    const double k = 0.5522847498;
    const auto round = path("M 10 0 C 10 " + std::to_string(10 * k) + " " + std::to_string(10 * k) + " 10 0 10");
    QVERIFY(!round.empty() && round.size() < 10);
    for (const ProfileSegment& s : round) QVERIFY(std::abs(s.at(0.5).norm() - 10.0) < 0.003);
    for (const char* d : {"M0 0 Q 5 10 10 0 T 20 0", "M0 0 C 0 5 10 5 10 0 S 20 -5 20 0"}) {
      const auto all = path(d);
      QVERIFY(isAt(all.front().from, 0, 0) && isAt(all.back().to, 20, 0));
      for (std::size_t i = 0; i + 1 < all.size(); ++i) QVERIFY(all[i].to == all[i + 1].from);
    }
    const auto parabola = path("M0 0 Q 5 10 10 0");  // y = 2 x (1 - x / 10), down
    for (const ProfileSegment& s : parabola) {
      const ProfilePoint p = s.at(0.5);
      QVERIFY(std::abs(-p.y() - 2.0 * p.x() * (1.0 - p.x() / 10.0)) < 1e-3);
    }
  }

  void shapes() {
    QCOMPARE(curves("<rect x=\"1\" y=\"2\" width=\"3\" height=\"4\"/>").size(), std::size_t{4});
    QCOMPARE(curves("<polyline points=\"0,0 1,1 2,0\"/>").size(), std::size_t{2});
    QCOMPARE(curves("<polygon points=\"0,0 1,1 2,0\"/>").size(), std::size_t{3});
    const auto circle = curves("<circle cx=\"5\" cy=\"6\" r=\"2\"/>");
    QCOMPARE(circle.size(), std::size_t{2});
    QVERIFY(isAt(circle[0].centre(), 5, -6));
    QVERIFY(curves("<ellipse cx=\"5\" cy=\"6\" rx=\"2\" ry=\"1\"/>").size() > 4);
  }

  // A slot of 20 × 10 mm whose ends are half circles, a rectangle with corners of 2 mm, and one of half axes 3 and 1:
  // the area that the corners leave out is (4 - π) rx ry, and the outline is closed.
  void roundedRectangles_data() {
    QTest::addColumn<QString>("corners");
    QTest::addColumn<double>("rx");
    QTest::addColumn<double>("ry");
    QTest::newRow("slot") << "rx=\"8\" ry=\"5\"" << 8.0 << 5.0;
    QTest::newRow("one for both") << "rx=\"2\"" << 2.0 << 2.0;
    QTest::newRow("the other for both") << "ry=\"2\"" << 2.0 << 2.0;
    QTest::newRow("elliptic") << "rx=\"3\" ry=\"1\"" << 3.0 << 1.0;
    QTest::newRow("more than half a side") << "rx=\"50\" ry=\"50\"" << 10.0 << 5.0;
    QTest::newRow("sharp") << "rx=\"0\" ry=\"4\"" << 0.0 << 0.0;
    QTest::newRow("impossible") << "rx=\"-1\"" << 0.0 << 0.0;
    QTest::newRow("one is impossible") << "rx=\"auto\" ry=\"2\"" << 2.0 << 2.0;
  }
  void roundedRectangles() {
    QFETCH(QString, corners);
    QFETCH(double, rx);
    QFETCH(double, ry);
    const auto all = curves(("<rect x=\"1\" y=\"2\" width=\"20\" height=\"10\" " + corners + "/>").toStdString());
    double twice = 0.0, lengths = 0.0;  // twice the area, by the shoelace formula
    for (std::size_t i = 0; i < all.size(); ++i) {
      QVERIFY((all[i].to - all[(i + 1) % all.size()].from).norm() < 1e-6);
      constexpr int kPieces = 200;
      for (int k = 0; k < kPieces; ++k) {
        const ProfilePoint a = all[i].at(double(k) / kPieces), b = all[i].at(double(k + 1) / kPieces);
        twice += a.x() * b.y() - a.y() * b.x();
        lengths += (b - a).norm();
        QVERIFY(a.x() > 1.0 - 1e-3 && a.x() < 21.0 + 1e-3 && a.y() < -2.0 + 1e-3 && a.y() > -12.0 - 1e-3);
      }
    }
    QVERIFY(std::abs(0.5 * std::abs(twice) - (200.0 - (4.0 - M_PI) * rx * ry)) < 0.01);
    if (rx == ry) QVERIFY(std::abs(lengths - (60.0 - (8.0 - 2.0 * M_PI) * rx)) < 0.01);
  }

  void transformations() {
    const auto all = curves(
        "<g transform=\"translate(10, 5) rotate(90)\"><g transform=\"scale(2)\"><line x1=\"1\" y1=\"0\" x2=\"2\" "
        "y2=\"0\"/></g></g>");
    QVERIFY(isAt(all[0].from, 10, -7) && isAt(all[0].to, 10, -9));
    const auto mirrored = curves("<path transform=\"matrix(-1 0 0 1 0 0)\" d=\"M 0 0 A 10 10 0 0 1 10 10\"/>");
    QVERIFY(isAt(mirrored[0].to, -10, -10) && isAt(mirrored[0].centre(), 0, -10));
    QVERIFY(curves("<path transform=\"scale(1 2)\" d=\"M 0 0 A 10 10 0 0 1 10 10\"/>").size() > 1);
    QVERIFY(!readSvgTransform("turn(3)").hasValue() && !readSvgTransform("scale(").hasValue());
  }

  // By 45° x and y are added: (1, 2) becomes (3, 2), or (1, 3).
  void skewing() {
    const auto x = readSvgTransform("skewX(45)"), y = readSvgTransform("skewY(45)");
    QVERIFY(x && ((*x) * Eigen::Vector2d(1, 2) - Eigen::Vector2d(3, 2)).norm() < 1e-12);
    QVERIFY(y && ((*y) * Eigen::Vector2d(1, 2) - Eigen::Vector2d(1, 3)).norm() < 1e-12);
    QVERIFY(!readSvgTransform("skewX(45 3)").hasValue());
  }

  void units() {
    const std::string line = "<line x1=\"0\" y1=\"0\" x2=\"1\" y2=\"1\"/>";
    const auto x = [&](const char* attributes) { return curves(line, attributes)[0].to.x(); };
    QVERIFY(std::abs(x("") - 25.4 / 96) < 1e-12);
    QVERIFY(std::abs(x("width=\"100\" viewBox=\"0 0 100 50\"") - 25.4 / 96) < 1e-12);
    QVERIFY(std::abs(x("width=\"10cm\" viewBox=\"0 0 50 50\"") - 2.0) < 1e-12);
    QVERIFY(std::abs(x("width=\"2in\" viewBox=\"0 0 1 1\"") - 50.8) < 1e-12);
    QVERIFY(!readSvg(svg(line, ""))->hasUnit && readSvg(svg(line, "width=\"9mm\" viewBox=\"0 0 9 9\""))->hasUnit);
  }

  void theAxis() {
    const char* const half = "<svg><path d=\"M0 10 V 0 H 50 V 10 Z\"/></svg>";
    const auto read = readSvg(half);
    QVERIFY(read.hasValue());
    QVERIFY(std::abs(*read->axis + 10.0 * 25.4 / 96) < 1e-9);  // its lowest line
    QCOMPARE(readSvg("<svg><path d=\"M0 10 L 5 12 L 50 10\"/></svg>").error().code,
             ErrorCode(TargetError::AxisUnknown));
    const auto labelled =
        readSvg("<svg xmlns:i=\"i\"><path d=\"M0 0 H 9\"/><g i:label=\"axis\"><path d=\"M0 96 H 9\"/></g></svg>");
    QVERIFY(std::abs(*labelled->axis + 25.4) < 1e-9);
    QCOMPARE(labelled->curves.size(), std::size_t{1});
  }

  void leavesOut() {
    const auto read =
        readSvg(svg("<defs><path d=\"M0 0 H 9\"/></defs><g style=\"display:none\"><path d=\"M0 0 H 9\"/></g>"
                    "<text>x</text><image/><path d=\"M0 5 H 9\"/>"));
    QVERIFY(read.hasValue());
    QCOMPARE(read->curves.size(), std::size_t{1});
    QCOMPARE(read->others.at("image"), std::size_t{1});
  }

  void refuses() {
    const auto code = [](const std::string& bytes) {
      const auto read = readSvg(bytes);
      return read ? ErrorCode() : read.error().code;
    };
    QCOMPARE(code("<svg/>"), ErrorCode(TargetError::NoProfile));
    QCOMPARE(code("<html/>"), ErrorCode(ErrorCode::ElementMalformed));
    QCOMPARE(code("<svg>"), ErrorCode(ErrorCode::ElementMalformed));
    for (const char* d : {"1 2", "M", "M 1", "M 0 0 L x", "M0 0 A 1 1 0 2 0 5 5", "M0 0 z 5 5", "M 1e999 0 L 1 1"})
      QCOMPARE(code(svg(std::string("<path d=\"") + d + "\"/>")), ErrorCode(ErrorCode::ElementMalformed));
    QCOMPARE(code("<!DOCTYPE svg [<!ENTITY a \"b\">]><svg/>"), ErrorCode(ErrorCode::Unsupported));
    JobState state;
    state.cancelled = true;
    QCOMPARE(readSvg(svg("<path d=\"M0 0 H 9\"/>"), Progress(state)).error().code, ErrorCode(ErrorCode::Cancelled));
  }

  void limits() {
    const auto refusal = [](const std::string& content) {
      const auto read = readSvg(svg(content));
      return read ? Error{} : read.error();
    };
    const Error far = refusal("<path transform=\"scale(1e200)\" d=\"M 0 0 L 1e200 1\"/>");
    QCOMPARE(far.code, ErrorCode(ErrorCode::ElementMalformed));
    QCOMPARE(far.arguments.at(1), std::string("a coordinate is too large"));
    std::string path = "M 0 0 H 1", lines;
    for (std::size_t i = 0; i <= TargetProfile::kMostSegments; ++i) path += i % 2 ? "h1" : "v1";
    QCOMPARE(refusal("<path d=\"" + path + "\"/>").code, ErrorCode(ErrorCode::FileTooLarge));
    for (std::size_t i = 0; i <= TargetProfile::kMostSegments / 1000; ++i)
      lines += "<polyline points=\"" + [] {
        std::string points;
        for (int k = 0; k <= 1000; ++k) points += std::to_string(k) + "," + std::to_string(k % 2) + " ";
        return points;
      }() + "\"/>";
    QCOMPARE(refusal(lines).arguments.at(0), std::string("segments"));
  }

  void recognised() {
    QVERIFY(looksLikeSvg("\xef\xbb\xbf<?xml version=\"1.0\"?>\n<svg:svg>") && looksLikeSvg(" <svg/>"));
    for (const char* const other : {"", "<html><body/>", "svg", "solid <svg"}) QVERIFY(!looksLikeSvg(other));
  }

  void mutations() {
    const std::string sound =
        svg("<g transform=\"scale(2 1)\"><path d=\"M1,2 L 3 4H5V6h-1v-1l1 1 2-2A10 5 0 0 1 10 10 C 0 5 10 5 10 0 S 20 "
            "-5 20 0Q5 5 6 7z\"/><circle cx=\"5\" cy=\"6\" r=\"2\"/></g>");
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i) {
      std::string bytes = sound;
      for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = "0123456789-.e MLHVCSQTAZz<>\""[random() % 28];
      const auto read = readSvg(bytes);
      if (read) (void)targetIn(*read);
    }
  }
};

HANDWHEEL_TEST(SvgReaderTest)
#include "SvgReaderTest.moc"
