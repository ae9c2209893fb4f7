// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "TestClass.h"
#include "devices/DeviceCatalogue.h"
#include "haptics/device/DeviceErrors.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace handwheel;

namespace {

class ShelfDriver final : public DeviceDriver {
 public:
  explicit ShelfDriver(std::vector<DeviceInfo>& shelf, std::string id = "shelf")
      : m_shelf(shelf), m_id(std::move(id)) {}
  std::string id() const override { return m_id; }
  std::vector<DeviceInfo> find() override { return m_shelf; }
  std::unique_ptr<Device> make(const std::string&) override { return nullptr; }

 private:
  std::vector<DeviceInfo>& m_shelf;
  std::string m_id;
};

}  // namespace

class DeviceCatalogueTest : public QObject {
  Q_OBJECT

 private:
  static std::vector<std::string> addresses(const std::vector<DeviceInfo>& listings) {
    std::vector<std::string> all;
    for (const DeviceInfo& listing : listings) all.push_back(listing.address);
    return all;
  }

 private slots:
  void pollTellsWhatCameAndWent() {
    std::vector<DeviceInfo> shelf = {{"shelf", "a", "A"}, {"shelf", "b", "B"}};
    DeviceCatalogue catalogue;
    catalogue.add(std::make_unique<ShelfDriver>(shelf));
    using Names = std::vector<std::string>;
    QCOMPARE(addresses(catalogue.poll().came), (Names{"a", "b"}));
    QVERIFY(catalogue.poll().came.empty() && catalogue.poll().gone.empty());
    shelf = {{"shelf", "b", "B"}, {"shelf", "c", "C"}};
    const DeviceChange change = catalogue.poll();
    QCOMPARE(addresses(change.came), Names{"c"});
    QCOMPARE(addresses(change.gone), Names{"a"});
    QCOMPARE(catalogue.find().size(), std::size_t(2));
  }

  void aPluginBringsItsDriver() {
    DeviceCatalogue catalogue;
    catalogue.load({test::buildPath("tests/plugins").toStdString()});
    QCOMPARE(catalogue.plugins().size(), std::size_t(1));
    const PluginInfo& plugin = catalogue.plugins()[0];
    QVERIFY(!plugin.error);
    QCOMPARE(plugin.name, std::string("Example"));
    QCOMPARE(plugin.version, std::string("1.0"));
    QCOMPARE(plugin.driver, std::string("example"));
    QCOMPARE(catalogue.drivers(), std::vector<std::string>{"example"});

    QTemporaryDir folder;
    const QString socket = folder.filePath("device");
    qputenv("HANDWHEEL_EXAMPLE_DEVICE", socket.toUtf8());
    QVERIFY(catalogue.poll().came.empty());
    QFile file(socket);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(addresses(catalogue.poll().came), std::vector<std::string>{socket.toStdString()});
    QVERIFY(catalogue.make("example", socket.toStdString()) != nullptr);
    QVERIFY(catalogue.make("example", "") == nullptr);
    QVERIFY(catalogue.make("nobody", "x") == nullptr);
    QVERIFY(file.remove());
    QCOMPARE(catalogue.poll().gone.size(), std::size_t(1));
  }

  // OldPlugin ends the program when any of its code runs.
  void theVersionIsReadBeforeTheCode() {
    DeviceCatalogue catalogue;
    catalogue.load({test::buildPath("tests/old-plugins").toStdString()});
    QCOMPARE(catalogue.plugins().size(), std::size_t(1));
    const PluginInfo& plugin = catalogue.plugins()[0];
    QVERIFY(plugin.error.has_value());
    QCOMPARE(plugin.error->code, DeviceError::PluginVersion);
    QCOMPARE(plugin.error->arguments, (std::vector<std::string>{"handwheel.device/0", HANDWHEEL_DEVICE_PLUGIN}));
    QCOMPARE(plugin.name, std::string("Old"));
    QVERIFY(plugin.driver.empty() && catalogue.drivers().empty());
  }

  void oneBrokenPluginHindersNoOther() {
    QTemporaryDir folder;
    for (const char* name : {"a.so", "z.so"}) {
      QFile file(folder.filePath(name));
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no library") > 0);
    }
    QFile none(folder.filePath("readme.txt"));
    QVERIFY(none.open(QIODevice::WriteOnly));
    QVERIFY(QFile::copy(test::buildPath("tests/plugins/example.so"), folder.filePath("m.so")));
    DeviceCatalogue catalogue;
    catalogue.load({folder.path().toStdString(), "/nowhere/at/all"});
    QCOMPARE(catalogue.plugins().size(), std::size_t(3));
    QCOMPARE(catalogue.plugins()[0].error->code, DeviceError::PluginBroken);
    QVERIFY(!catalogue.plugins()[0].error->arguments[0].empty());
    QVERIFY(!catalogue.plugins()[1].error);
    QCOMPARE(catalogue.plugins()[2].error->code, DeviceError::PluginBroken);
    QCOMPARE(catalogue.drivers(), std::vector<std::string>{"example"});
  }

  void aSecondDriverOfTheSameNameIsRefused() {
    std::vector<DeviceInfo> shelf;
    DeviceCatalogue catalogue;
    catalogue.add(std::make_unique<ShelfDriver>(shelf, "example"));
    catalogue.load({test::buildPath("tests/plugins").toStdString()});
    QCOMPARE(catalogue.drivers().size(), std::size_t(1));
    QCOMPARE(catalogue.plugins()[0].error->code, DeviceError::PluginBroken);
    QVERIFY(catalogue.plugins()[0].driver.empty());
  }

  void foldersAreNamedOrTheProgramsOwn() {
    qputenv("HANDWHEEL_PLUGINS", "/a:/b c::");
    QCOMPARE(pluginFolders(), (std::vector<std::string>{"/a", "/b c"}));
    qunsetenv("HANDWHEEL_PLUGINS");
    QCOMPARE(pluginFolders().size(), std::size_t(1));
    QVERIFY(pluginFolders()[0].ends_with("/handwheel/plugins"));
  }
};

HANDWHEEL_TEST(DeviceCatalogueTest)
#include "DeviceCatalogueTest.moc"
