// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/thread/ThreadTolerance.h"

#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

bool isSame(const std::optional<double>& value, double expected) {
  return value && std::abs(*value - expected) < 5e-5;
}

}  // namespace

// The limits of metric threads, against the published tables of ISO 965-2 and of handbooks.
class ThreadToleranceTest : public QObject {
  Q_OBJECT

 private slots:
  void publishedLimits_data() {
    QTest::addColumn<QString>("thread");
    QTest::addColumn<double>("crestLower");  // major diameter, or the minor one of a nut
    QTest::addColumn<double>("crestUpper");
    QTest::addColumn<double>("pitchLower");
    QTest::addColumn<double>("pitchUpper");
    const auto row = [](const char* thread, double a, double b, double c, double d) {
      QTest::newRow(thread) << QString::fromUtf8(thread) << a << b << c << d;
    };
    row("M3-6g", 2.874, 2.980, 2.580, 2.655);
    row("M6x1-6g", 5.794, 5.974, 5.212, 5.324);
    row("M8-6g", 7.760, 7.972, 7.042, 7.160);
    row("M10x1.5-6g", 9.732, 9.968, 8.862, 8.994);
    row("M12-6g", 11.701, 11.966, 10.679, 10.829);
    row("M16-6g", 15.682, 15.962, 14.503, 14.663);
    row("M20x2.5-6g", 19.623, 19.958, 18.164, 18.334);
    row("M24-6g", 23.577, 23.952, 21.803, 22.003);
    row("M30-6g", 29.522, 29.947, 27.462, 27.674);
    row("M36-6g", 35.465, 35.940, 33.118, 33.342);
    row("M10-6H", 8.376, 8.676, 9.026, 9.206);
    row("M6-6H", 4.917, 5.153, 5.350, 5.500);
    row("M8-6H", 6.647, 6.912, 7.188, 7.348);
    row("M12-6H", 10.106, 10.441, 10.863, 11.063);
    row("M16-6H", 13.835, 14.210, 14.701, 14.913);
    row("M20-6H", 17.294, 17.744, 18.376, 18.600);
    row("M24-6H", 20.752, 21.252, 22.051, 22.316);
    // Other grades: for M10, 4H has tolerances of 112 and 190 µm, 5g6g of 106 µm on the flanks, 8g of 375 and 212.
    row("M10-4H", 8.376, 8.566, 9.026, 9.138);
    row("M10-5g6g", 9.732, 9.968, 8.888, 8.994);
    row("M10-8g", 9.593, 9.968, 8.782, 8.994);
    row("M10-6h", 9.764, 10.0, 8.894, 9.026);
    row("M10-6G", 8.408, 8.708, 9.058, 9.238);
  }
  void publishedLimits() {
    QFETCH(QString, thread);
    QFETCH(double, crestLower);
    QFETCH(double, crestUpper);
    QFETCH(double, pitchLower);
    QFETCH(double, pitchUpper);
    const auto found = threadTolerance(thread.toStdString());
    QVERIFY(found.has_value());
    const ToleratedSize& crest = found->isInner ? found->minor : found->major;
    QVERIFY2(isSame(crest.lower, crestLower) && isSame(crest.upper, crestUpper),
             qPrintable(QString("%1 %2").arg(*crest.lower).arg(*crest.upper)));
    QVERIFY2(isSame(found->pitchDiameter.lower, pitchLower) && isSame(found->pitchDiameter.upper, pitchUpper),
             qPrintable(QString("%1 %2").arg(*found->pitchDiameter.lower).arg(*found->pitchDiameter.upper)));
  }

  // M20 × 2.5 - 6g: the root between a radius of H/6, 16.891, and of P/8, 18.164 - 0.75 · 2.1651 = 16.540. The roots of
  // a nut are free above its nominal diameter. Half of a tolerance of 0.170 mm is an error of the pitch of 0.049 mm.
  void rootAndPitch() {
    const auto bolt = threadTolerance("M20x2.5-6g"), nut = threadTolerance("M20-6H");
    QVERIFY(bolt && isSame(bolt->minor.lower, 16.540) && isSame(bolt->minor.upper, 16.891));
    QVERIFY(nut && isSame(nut->major.lower, 20.0) && !nut->major.upper);
    QVERIFY(isSame(bolt->pitch.lower, 2.451) && isSame(bolt->pitch.upper, 2.549));
  }

  void spellings() {
    const char* const same[] = {"M10x1.5-6g",     "M10×1.5-6g",     "M10X1.5 - 6g", "M10-6g",
                                "M10 × 1.5 – 6g", "M10x1.50-6g-LH", "M10*1.5-6g6g"};
    for (const char* const text : same) {
      const auto thread = threadTolerance(text);
      QVERIFY2(thread, text);
      QVERIFY(isSame(thread->major.lower, 9.732));
    }
    QCOMPARE(threadTolerance("M10-6g")->designation, std::string("M10×1.5-6g"));
    for (const char* const text : {"", "M10", "6g", "M10x1.5", "M10x0-6g", "M10x1.5-6k", "M10x1.5-2g", "M10x1.5-7g",
                                   "M10x1.5-5g6h", "M13-6g", "M10x1.4-6g", "Mx1-6g", "M1e9-6g", "h7", "M10x1.5-6g6"})
      QVERIFY2(!threadTolerance(text), text);
    QCOMPARE(threadClassIn("6g major diameter"), std::string_view("6g"));
    QVERIFY(threadClassIn("h7").empty() && threadClassIn("").empty());
  }

  // A class alone is that of the coarse thread of the nominal size.
  void coarseThreads() {
    for (const auto& [which, nominal] :
         {std::pair(ThreadDiameter::Major, 20.0), std::pair(ThreadDiameter::Pitch, 18.376),
          std::pair(ThreadDiameter::Minor, 16.933)})
      QCOMPARE(coarseThreadWith(which, nominal, "6g")->designation, std::string("M20×2.5-6g"));
    QVERIFY(!coarseThreadWith(ThreadDiameter::Major, 21.0, "6g"));
  }
};

HANDWHEEL_TEST(ThreadToleranceTest)
#include "ThreadToleranceTest.moc"
