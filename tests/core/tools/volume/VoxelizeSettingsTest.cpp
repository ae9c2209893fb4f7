// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/VoxelizeSettings.h"

#include "MeshShapes.h"
#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

class VoxelizeSettingsTest : public QObject {
  Q_OBJECT

 private slots:
  // By (3-20) 255 levels · 1 mm/s / 1 kHz; of a part that is far smaller or larger the 256th of its extent; four to a
  // wall that is thin.
  void proposals() {
    using Reason = VoxelizeSettings::Reason;
    using Purpose = VoxelizeSettings::Purpose;
    const auto check = [](const VoxelizeSettings& settings, double voxel, Reason reason) {
      QVERIFY2(std::abs(settings.voxel() / voxel - 1.0) < 1e-12, qPrintable(QString::number(settings.voxel())));
      QCOMPARE(static_cast<int>(settings.reason()), static_cast<int>(reason));
    };
    check(VoxelizeSettings(test::cube(90.0), Purpose::Drilling), 0.255, Reason::Drilling);
    check(VoxelizeSettings(test::cube(10.0), Purpose::Drilling), 10.0 / 256.0, Reason::Extent);
    check(VoxelizeSettings(test::cube(2560.0), Purpose::Drilling), 10.0, Reason::Extent);
    // Parts that are not to be drilled have the voxels of the repair by volume, for any size.
    for (const double size : {10.0, 19.0, 90.0, 2560.0})
      check(VoxelizeSettings(test::cube(size)), size / 256.0, Reason::Extent);
    VoxelizeSettings settings(test::cube(90.0), Purpose::Drilling);
    settings.change("wall", 0.4);
    check(settings, 0.1, Reason::Wall);
    settings.change("wall", 4.0);
    check(settings, 0.255, Reason::Drilling);
    settings.change("wall", 0.0);
    QVERIFY(!settings.wall());
    settings.change("voxel", 0.1);
    check(settings, 0.1, Reason::Chosen);
    QVERIFY(std::abs(settings.across() - 900.0) < 1e-9);
  }

  void whatItTakes() {
    VoxelizeSettings settings(test::cube(90.0));
    settings.change("voxel", 0.2);
    const double bytes = settings.bytes(), seconds = settings.seconds();
    QVERIFY(std::abs(bytes / predictedMakingBytes(6.0 * 8100.0, Vec3::Constant(90.0), 0.2) - 1.0) < 1e-9);
    settings.change("voxel", 0.1);
    QVERIFY(settings.bytes() > 3.9 * bytes && settings.seconds() > 2.0 * seconds);
    const double solid = settings.bytes();
    settings.change("wall", 1.0);  // a wall has two sides
    QVERIFY(settings.bytes() > 1.9 * solid);
  }

  void whatIsNoValue() {
    VoxelizeSettings settings(test::cube(90.0), VoxelizeSettings::Purpose::Drilling);
    settings.change("voxel", std::nan(""));
    settings.change("voxel", std::string("fine"));
    settings.change("wall", HUGE_VAL);
    settings.change("method", 7.0);
    QCOMPARE(settings.voxel(), 0.255);
    QVERIFY(!settings.wall());
    QCOMPARE(static_cast<int>(settings.method()), static_cast<int>(VoxelMethod::Sign));
    settings.change("method", 1.0);
    QCOMPARE(static_cast<int>(settings.method()), static_cast<int>(VoxelMethod::Density));
    // An empty surface has a valid voxel, too.
    QVERIFY(VoxelizeSettings(TriangleSoup()).voxel() > 0.0);
  }
};

HANDWHEEL_TEST(VoxelizeSettingsTest)
#include "VoxelizeSettingsTest.moc"
