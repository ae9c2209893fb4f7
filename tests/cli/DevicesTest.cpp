// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "Program.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

// With the plugins that the tests have, not those of the program.
class DevicesTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() {
    qunsetenv("HANDWHEEL_PLUGINS");
    qunsetenv("HANDWHEEL_EXAMPLE_DEVICE");
  }

  void listsDriversDevicesAndPlugins() {
    const Fixture fixture;
    fixture.put("socket", "x");
    qputenv("HANDWHEEL_PLUGINS", test::buildPath("tests/plugins").toUtf8());
    qputenv("HANDWHEEL_EXAMPLE_DEVICE", (fixture.path() + "/socket").toUtf8());
    const Ran ran = fixture.run({"devices", "--json"}, "de_DE.UTF-8");
    QCOMPARE(ran.code, 0);
    QVERIFY2(ran.err.isEmpty(), ran.err);
    const nlohmann::json json = nlohmann::json::parse(ran.out.toStdString());
    QCOMPARE(json["plugins"].size(), std::size_t(1));
    QCOMPARE(json["plugins"][0]["name"].get<std::string>(), std::string("Example"));
    QVERIFY(json["plugins"][0]["error"].is_null());
    const auto drivers = json["drivers"].get<std::vector<std::string>>();
    QVERIFY(std::find(drivers.begin(), drivers.end(), "example") != drivers.end());
    const nlohmann::json& device = json["devices"].back();  // the program's own come first
    QCOMPARE(device["driver"].get<std::string>(), std::string("example"));
    QCOMPARE(device["name"].get<std::string>(), std::string("Example device"));
    QCOMPARE(device["capabilities"]["outputs"].get<int>(), 3);
    QCOMPARE(device["capabilities"]["max_force_n"].get<double>(), 5.0);

    // Every limit of the data sheet, also those that this device has not.
    for (const char* key : {"max_torque_nmm", "max_gripper_force_n", "max_stiffness_n_per_mm",
                            "max_angular_stiffness_nmm_per_rad", "max_damping_ns_per_mm"})
      QVERIFY2(device["capabilities"].contains(key), key);

    const Ran readable = fixture.run({"devices"});
    QCOMPARE(readable.code, 0);
    QVERIFY2(readable.out.contains("Example device (example, "), readable.out);
    QVERIFY2(readable.out.contains("3 axes in, 3 driven, up to 5 N, 0 buttons"), readable.out);
  }

  void aPluginOfAnotherVersionIsReportedAndTheRestGoesOn() {
    const Fixture fixture;
    qputenv("HANDWHEEL_PLUGINS",
            test::buildPath("tests/old-plugins:").toUtf8() + test::buildPath("tests/plugins").toUtf8());
    const Ran ran = fixture.run({"devices", "--json"});
    QCOMPARE(ran.code, 0);
    QVERIFY2(ran.err.contains("another version of Handwheel (handwheel.device/0, here "), ran.err);
    const nlohmann::json json = nlohmann::json::parse(ran.out.toStdString());
    QCOMPARE(json["plugins"].size(), std::size_t(2));
    QVERIFY(json["plugins"][0]["error"].is_string());
    QCOMPARE(json["plugins"][0]["driver"].get<std::string>(), std::string());
    QCOMPARE(json["plugins"][1]["driver"].get<std::string>(), std::string("example"));
  }

  void withoutPluginsItSaysSo() {
    const Fixture fixture;
    qputenv("HANDWHEEL_PLUGINS", "/nowhere");
    const Ran ran = fixture.run({"devices", "--json"});
    QCOMPARE(ran.code, 0);
    const nlohmann::json json = nlohmann::json::parse(ran.out.toStdString());
    QVERIFY(json["plugins"].empty());
    // Those that need neither plugin nor hardware.
    QCOMPARE(json["devices"].size(), std::size_t(2));
    QCOMPARE(json["devices"][0]["driver"].get<std::string>(), std::string("simulated"));
    QCOMPARE(json["devices"][0]["capabilities"]["outputs"].get<int>(), 3);
    QVERIFY(json["devices"][0]["capabilities"]["max_force_n"].get<double>() > 0.0);
    QCOMPARE(json["devices"][1]["driver"].get<std::string>(), std::string("mouse"));
  }
};

HANDWHEEL_TEST(DevicesTest)
#include "DevicesTest.moc"
