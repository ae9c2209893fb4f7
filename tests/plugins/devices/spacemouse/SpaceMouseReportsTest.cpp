// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "spacemouse/Buttons.h"
#include "spacemouse/Models.h"
#include "spacemouse/Reports.h"

#include <rapidcheck.h>
#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::spacemouse;

namespace {

using Report = std::vector<std::uint8_t>;

// Ids of the reports that mean something, and of one that means nothing here.
const Report kNumbers = {1, 2, 3, 4, 0x17, 0x1c, 0x1d};

Report report(std::uint8_t id, const std::vector<int>& numbers) {
  Report bytes = {id};
  for (const int number : numbers) {
    bytes.push_back(static_cast<std::uint8_t>(number & 0xff));
    bytes.push_back(static_cast<std::uint8_t>(number >> 8 & 0xff));
  }
  return bytes;
}

spacemouse::Counts after(const std::vector<Report>& all) {
  Reports reports;
  for (const Report& each : all) reports.take(each);
  return reports.counts();
}

std::uint32_t buttonsAfter(const Report& bytes) {
  Reports reports;
  reports.take(bytes);
  return reports.buttons();
}

}  // namespace

class SpaceMouseReportsTest : public QObject {
  Q_OBJECT

 private slots:
  // Captured from a SpaceMouse Compact.
  void realReports() {
    QCOMPARE(after({{0x02, 0x20, 0, 0, 0, 0x17, 0}}), (spacemouse::Counts{{}, {32, 0, 23}}));
    QCOMPARE(after({{0x01, 0x12, 0, 0, 0, 0xf8, 0}}), (spacemouse::Counts{{18, 0, 248}, {}}));
    QCOMPARE(after({{0x02, 0x20, 0, 0, 0, 0x19, 0}, {0x01, 0x12, 0, 0, 0, 0x12, 0x01}}),
             (spacemouse::Counts{{18, 0, 274}, {32, 0, 25}}));
    QCOMPARE(after({{0x02, 0x1d, 0, 0, 0, 0x1b, 0}, {0x01, 0x0d, 0, 0, 0, 0x25, 0x01}}),
             (spacemouse::Counts{{13, 0, 293}, {29, 0, 27}}));
  }

  void theLengthTellsTheFormat() {
    const bool ok = rc::check([](const std::array<std::int16_t, 6>& n) {
      const std::vector<int> first(n.begin(), n.begin() + 3), last(n.begin() + 3, n.end()), all(n.begin(), n.end());
      const spacemouse::Counts expected{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
      RC_ASSERT(after({report(1, first), report(2, last)}) == expected);
      RC_ASSERT(after({report(1, all)}) == expected);
    });
    QVERIFY(ok);
  }

  // For any bytes of every length: a reading is finite and within full scale, and short motion reports move nothing.
  void anyBytesAreSafe() {
    for (std::size_t length = 0; length <= 64; ++length) {
      const bool ok = rc::check([length] {
        Report bytes = *rc::gen::container<Report>(length, rc::gen::arbitrary<std::uint8_t>());
        if (length > 0 && *rc::gen::inRange(0, 8) > 0) bytes[0] = *rc::gen::elementOf(kNumbers);
        Reports reports;
        const bool moved = reports.take(bytes);
        RC_ASSERT(moved == (length >= 7 && (bytes[0] == 1 || bytes[0] == 2)));
        if (!moved) RC_ASSERT(reports.counts().isZero());
        DeviceState state;
        setPose(reports.counts(), state);
        RC_ASSERT(state.position.cwiseAbs().maxCoeff() <= kTravel);
        RC_ASSERT(std::abs(state.orientation.norm() - 1.0) < 1e-12);
        const double angle = Eigen::AngleAxisd(state.orientation).angle();
        RC_ASSERT(angle <= kFullTilt * std::sqrt(3.0) + 1e-9);
        RC_ASSERT(reports.batteryPercent().value_or(0) <= 100);
      });
      QVERIFY(ok);
    }
  }

  // Right, towards the user, down become x right, y up, z towards the user; turning follows the same frame.
  void axesAreTurnedAsOneFrame() {
    DeviceState state;
    setPose({{350, 0, 0}, {}}, state);
    QVERIFY((state.position - kTravel * Vec3::UnitX()).norm() < 1e-12);
    setPose({{0, 350, 0}, {}}, state);
    QVERIFY((state.position - kTravel * Vec3::UnitZ()).norm() < 1e-12);
    setPose({{0, 0, 350}, {}}, state);
    QVERIFY((state.position + kTravel * Vec3::UnitY()).norm() < 1e-12);
    // Turned about "down" by half of full scale: about -y.
    setPose({{}, {0, 0, 175}}, state);
    const Eigen::Quaterniond expected(Eigen::AngleAxisd(0.5 * kFullTilt, -Vec3::UnitY()));
    QVERIFY(state.orientation.isApprox(expected, 1e-12));
    QVERIFY((state.orientation * Vec3::UnitZ() - Vec3(-std::sin(0.5), 0.0, std::cos(0.5))).norm() < 1e-12);
  }

  void overshootIsClamped() {
    DeviceState state;
    setPose({{360, -32768, 32767}, {32767, 0, 0}}, state);
    QVERIFY((state.position - kTravel * Vec3(1, -1, -1)).norm() < 1e-12);
    QVERIFY(std::abs(Eigen::AngleAxisd(state.orientation).angle() - kFullTilt) < 1e-12);
  }

  void bitmapsOfEveryLength() {
    QCOMPARE(buttonsAfter({3, 0x01, 0x00}), 1u);
    QCOMPARE(buttonsAfter({3, 0x03, 0x00}), 3u);
    QCOMPARE(buttonsAfter({3, 0x80}), 0x80u);  // the high bits of a short report are not lost
    QCOMPARE(buttonsAfter({3, 0, 0, 0x10}), 1u << 20);
    QCOMPARE(buttonsAfter({3, 0, 0, 0x40, 0x80, 0xff, 0xff}), 1u << 22 | 1u << 31);
    QCOMPARE(buttonsAfter({3}), 0u);
  }

  void listsOfNumbers() {
    QCOMPARE(buttonsAfter(report(0x1c, {1, 22})), 1u << 1 | 1u << 22);
    QCOMPARE(buttonsAfter(report(0x1c, {12, 0, 0, 175})), 1u << 12 | 1u << 31);
    QCOMPARE(buttonsAfter(report(0x1c, {0, 0})), 0u);
    QCOMPARE(buttonsAfter(report(0x1c, {999})), 0u);
    Reports reports;
    reports.take(report(0x1c, {13}));
    reports.take(report(0x1d, {13}));  // held for long: still held
    QCOMPARE(reports.buttons(), 1u << 13);
    reports.take(Report{0x1c});
    QCOMPARE(reports.buttons(), 0u);
  }

  // No two buttons of the Enterprise share a bit.
  void highButtonsHaveBitsOfTheirOwn() {
    std::uint32_t taken = 0;
    for (const int number : {0,  1,  2,  4,  5,  8,  10, 12, 13, 14, 15,  16,  17,  18,  19, 20,
                             21, 22, 23, 24, 25, 26, 35, 36, 76, 77, 102, 103, 104, 174, 175}) {
      const int bit = bitOf(static_cast<std::uint16_t>(number));
      QVERIFY(bit >= 0 && bit < 32);
      QVERIFY2(!(taken & 1u << bit), qPrintable(QString::number(number)));
      taken |= 1u << bit;
    }
  }

  void battery() {
    Reports reports;
    QVERIFY(!reports.batteryPercent());
    reports.take(Report{0x17, 83, 0});
    QCOMPARE(*reports.batteryPercent(), 83);
    reports.take(Report{0x17, 255, 0});
    QCOMPARE(*reports.batteryPercent(), 83);
  }

  void whoIsOurs() {
    QVERIFY(isSixAxis(0x256f, 0xc635, 1, 8));
    QVERIFY(isSixAxis(0x046d, 0xc626, 1, 8));
    QVERIFY(isSixAxis(0x256f, 0xc7ff, 1, 8));   // a later product
    QVERIFY(!isSixAxis(0x256f, 0xc635, 1, 2));  // its mouse interface
    QVERIFY(!isSixAxis(0x256f, 0xc650, 1, 8));  // a CadMouse
    QVERIFY(!isSixAxis(0x046d, 0xc52b, 1, 8));  // any other Logitech device
    QVERIFY(!isSixAxis(0x046d, 0xc640, 1, 8));  // the NuLOOQ
    QVERIFY(!isSixAxis(0x1234, 0xc635, 1, 8));
    QCOMPARE(modelOf(0x256f, 0xc62e)->buttons, 2);
  }
};

HANDWHEEL_TEST(SpaceMouseReportsTest)
#include "SpaceMouseReportsTest.moc"
