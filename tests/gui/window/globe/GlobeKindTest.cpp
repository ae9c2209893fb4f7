// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "GlobeWindow.h"
#include "cli/commands/ConvertCommand.h"
#include "cli/commands/SetCommand.h"
#include "theme/Icons.h"
#include "window/documents/FileFilters.h"

#include <QDockWidget>
#include <QProcess>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

// A kind of document that the program does not have is everywhere by one entry in the list of kinds.
class GlobeKindTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  QString write(const char* name, const QByteArray& bytes) {
    QFile file(m_folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("cannot write %s", name);
    return file.fileName();
  }
  static QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

 private slots:
  void startsOpensAndSaves() {
    const QString sample = write("sample.globe", "globe 25\n"), path = m_folder.filePath("my.handwheel");
    WindowDriver driver(kindsWithGlobe(sample));
    driver.click("globeTile");
    QVERIFY(driver.settle());
    QCOMPARE(driver.text("figures"), QStringLiteral("25"));
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Shape of the globe"));
    QVERIFY(driver.find<QMenu>("kindMenu/globe")->menuAction()->isVisible());
    driver.choose("newGlobe");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 2);
    QCOMPARE(driver.text("figures"), QStringLiteral("10"));
    QVERIFY(!driver.find<Viewport>("viewport")->bounds().isEmpty());
    driver.edit("radius", "12.5*2");
    QCOMPARE(driver.text("figures"), QStringLiteral("25"));
    driver.click("quickActions/undo");
    QCOMPARE(driver.text("figures"), QStringLiteral("10"));
    driver.click("quickActions/redo");
    driver.click("quickActions/saveFile");
    QVERIFY(driver.enterFileName("saveDialog", path));
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());

    WindowDriver second(kindsWithGlobe());
    QVERIFY(second.open(path));
    QCOMPARE(second.text("figures"), QStringLiteral("25"));
    second.choose("saveFileAs");
    QVERIFY(second.enterFileName("saveDialog", m_folder.filePath("other.globe")));
    QVERIFY(second.settle());
    QCOMPARE(bytesOf(m_folder.filePath("other.globe")), QByteArray("globe 25\n"));

    WindowDriver without;  // says so, and keeps its hands off
    QVERIFY(without.open(path));
    QCOMPARE(without.tabs(), 0);
  }

  // Errors of its files are described in its own words.
  void hasItsOwnErrors() {
    WindowDriver driver(kindsWithGlobe());
    QVERIFY(driver.open(write("flat.globe", "globe 0\n")));
    QVERIFY2(driver.text("messageText").contains("What is in flat.globe is flat.<br>Blow it up."),
             qPrintable(driver.text("messageText")));
  }

  // A drawing of its files comes with the kind.
  void bringsItsIcon() {
    const BuiltInKinds registered(kindsWithGlobe());
    const QString name = iconNameFor(registered.set.documents, "a.globe");
    QCOMPARE(name, QStringLiteral("kind-globe"));
    const QImage drawn = icon(name).pixmap(24, 24).toImage();
    int covered = 0;
    for (int y = 0; y < drawn.height(); ++y)
      for (int x = 0; x < drawn.width(); ++x) covered += qAlpha(drawn.pixel(x, y)) > 128;
    QVERIFY2(covered > 40, "a circle of 17 pixels has a circumference of 53");
  }

  // A tool shows what it makes in terms that only its own window understands.
  void hasItsOwnPreviews() {
    GlobeWindow globe;
    QVERIFY(globe.begin("growTool", StandardView::Front));
    const auto shown = [&] { return globe.layer().points().front().norm(); };
    QVERIFY(std::abs(shown() - 10.0) < 1e-12);
    const QPoint middle = globe.view->rect().center();
    QTest::mousePress(globe.view, Qt::LeftButton, {}, middle);
    QVERIFY(std::abs(shown() - 20.0) < 1e-12);
    QCOMPARE(globe.driver.text("figures"), QStringLiteral("10"));
    QTest::keyClick(globe.view, Qt::Key_Escape);
    QVERIFY(std::abs(shown() - 10.0) < 1e-12);
    QTest::mouseRelease(globe.view, Qt::LeftButton, {}, middle);
    QTest::mousePress(globe.view, Qt::LeftButton, {}, middle);
    const Vec3 highest = globe.layer().points().front();
    QVERIFY((globe.view->pickAt(globe.pixelOf(highest)).point - highest).norm() < 1e-9);
    QTest::mouseRelease(globe.view, Qt::LeftButton, {}, middle);
    QVERIFY(std::abs(shown() - 20.0) < 1e-12);
    QCOMPARE(globe.driver.text("figures"), QStringLiteral("20"));
    globe.driver.click("quickActions/undo");
    QVERIFY(std::abs(shown() - 10.0) < 1e-12);
    globe.driver.find<QAction>("measureTool")->trigger();
    QVERIFY(globe.driver.find<QAction>("measureTool")->isChecked());
  }

  // 'new', 'convert' and their help know what is registered.
  void isKnownToCommands() {
    QVERIFY(newDetails(BuiltInKinds(builtInKinds()).set.documents).find("globe") == std::string::npos);
    const BuiltInKinds registered(kindsWithGlobe());
    const DocumentKinds& kinds = registered.set.documents;
    QVERIFY(newDetails(kinds).find("globe") != std::string::npos);
    QVERIFY(convertDetails(kinds).find("  globe: .globe .handwheel") != std::string::npos);
    const auto made = m_folder.filePath("a.handwheel").toStdString(),
               exported = m_folder.filePath("a.globe").toStdString();
    Arguments arguments;
    arguments.operands = {"globe", "radius=2in"};
    arguments.options.emplace("output", made);
    QCOMPARE(runNew(arguments, kinds), 0);
    Arguments conversion;
    conversion.operands = {made, exported};
    QCOMPARE(runConvert(conversion, kinds), 0);
    QCOMPARE(bytesOf(QString::fromStdString(exported)), QByteArray("globe 50.8\n"));
  }

  // Its own command has a line in the overview, a help page, options with ranges, and figures as JSON.
  void hasItsOwnCommand() {
    const QTemporaryDir folder;
    struct Said {
      int code;
      QByteArray out, err;
    };
    const auto run = [&folder](const QStringList& words) {
      QProcess process;
      process.setWorkingDirectory(folder.path());
      process.start(test::buildPath("tests/GlobeProgram"), words);
      process.waitForFinished();
      return Said{process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
    };
    QVERIFY(
        QString(run({"help"}).out).simplified().contains(QLatin1String(" inflate Makes a globe larger, or smaller. ")));
    const QByteArray page = run({"help", "inflate"}).out;
    QVERIFY2(page.startsWith("Usage: handwheel inflate IN [--by N] [--at-most MM] -o OUT [--json]\n"), page);
    QVERIFY2(page.simplified().contains("--by N Factor of the radius (0.1 to 10, default 2)"), page);
    QVERIFY2(page.simplified().contains("--at-most MM No larger than this radius (1 to 1000)"), page);
    QCOMPARE(run({"new", "globe", "radius=25", "-o", "a.handwheel"}).code, 0);
    const Said ran = run({"inflate", "a.handwheel", "--by", "1.5", "-o", "b.globe"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.out, QByteArray("Radius: 37.5 mm\n"));
    const auto json =
        nlohmann::json::parse(run({"inflate", "b.globe", "-o", "c.globe", "--at-most=50", "--json"}).out.toStdString());
    const nlohmann::json expected = {{"options", {{"by", 2.0}, {"at_most_mm", 50.0}}}, {"radius_mm", 50.0}};
    QVERIFY2(json == expected, json.dump().c_str());
    const Said wrong = run({"inflate", "a.handwheel", "--by", "11", "-o", "d.globe"});
    QCOMPARE(wrong.code, 1);
    QCOMPARE(wrong.err, QByteArray("handwheel: --by takes a number from 0.1 to 10, not '11'.\n"
                                   "Try 'handwheel help inflate'.\n"));
    QCOMPARE(run({"new", "workpiece", "-o", "w.handwheel"}).code, 0);
    QCOMPARE(run({"inflate", "w.handwheel", "-o", "d.globe"}).err, QByteArray("handwheel: w.handwheel is no globe.\n"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files),
             (QStringList{"a.handwheel", "b.globe", "c.globe", "w.handwheel"}));
  }
};

HANDWHEEL_WINDOW_TEST(GlobeKindTest)
#include "GlobeKindTest.moc"
