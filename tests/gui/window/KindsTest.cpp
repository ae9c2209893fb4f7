// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GlobeCommand.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "cli/commands/ConvertCommand.h"
#include "cli/commands/SetCommand.h"
#include "controls/PropertyList.h"
#include "document/Document.h"
#include "viewport/surface/PartsLayer.h"
#include "window/documents/FileFilters.h"

#include <QDockWidget>
#include <QProcess>
#include <QUndoStack>

using namespace handwheel;
using namespace handwheel::test;

// Workpieces and robot cells in the window: opened, changed by field and slider, undone, saved and opened again.
class KindsTest : public QObject {
  Q_OBJECT

 private slots:
  void aWorkpieceFromStartPageToFile() {
    const QTemporaryDir folder;
    WindowDriver driver;
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    QCOMPARE(driver.tabs(), 1);
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Stock"));
    const QString before = driver.text("figures");

    driver.edit("diameter", "2in");
    QVERIFY(driver.text("figures") != before);
    driver.edit("length", "50*2.5");
    driver.click("quickActions/undo");
    driver.click("quickActions/undo");
    QCOMPARE(driver.text("figures"), before);
    driver.click("quickActions/redo");
    driver.click("quickActions/redo");

    const QString path = folder.filePath("bar.handwheel");
    driver.click("quickActions/saveFile");
    QVERIFY(driver.enterFileName("saveDialog", path));
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());
    const QString saved = driver.text("figures");

    WindowDriver second;
    QVERIFY(second.open(path));
    QCOMPARE(second.text("figures"), saved);
    QVERIFY(!second.window().isWindowModified());
  }

  // Files have the drawing of the kind that reads them; what none reads, of the one that writes it.
  void filesAreDrawnByTheirEndings() {
    const RegisteredKinds registered(registeredKinds());
    const DocumentKinds& kinds = registered.set.documents;
    for (const auto& [name, drawing] : {std::pair{"a.STL", "kind-mesh"},
                                        {"a.3mf", "kind-mesh"},
                                        {"a.urdf", "kind-cell"},
                                        {"a.step", "kind-workpiece"},
                                        {"a.handwheel", "handwheel"},
                                        {"a.txt", "file"}}) {
      QCOMPARE(iconNameFor(kinds, name), QString::fromLatin1(drawing));
    }
  }

  // Each tile of the start page opens a document that was shipped, which is not written over.
  void everyTileOpensASample() {
    for (const auto& [tile, name] : {std::pair{"sampleTile", "scan-with-holes.stl"},
                                     {"latheTile", "shaft-stock.handwheel"},
                                     {"cellTile", "robot-arm.urdf"}}) {
      WindowDriver driver;
      driver.click(tile);
      QVERIFY(driver.settle());
      QCOMPARE(driver.tabs(), 1);
      QCOMPARE(driver.find<QTabBar>("documentTabBar")->tabText(0), QString::fromLatin1(name));
      driver.click("quickActions/saveFile");
      QTRY_VERIFY(driver.window().findChild<QFileDialog*>("saveDialog"));
      driver.window().findChild<QFileDialog*>("saveDialog")->reject();
    }
  }

  // One entry in the list of kinds is all it takes.
  void aKindThatIsRegisteredIsEverywhere() {
    const QTemporaryDir folder;
    const QString sample = folder.filePath("sample.globe");
    QFile file(sample);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("globe 25\n") > 0);
    file.close();
    const auto kinds = [&] {
      std::vector<KindRegistration> entries = registeredKinds();
      entries.insert(entries.begin(), globeRegistration(sample));
      return entries;
    };
    const QString path = folder.filePath("my.handwheel");
    WindowDriver driver(kinds());
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
    driver.find<QAction>("measureTool")->trigger();
    QVERIFY(driver.find<QAction>("measureTool")->isChecked());
    driver.click("quickActions/saveFile");
    QVERIFY(driver.enterFileName("saveDialog", path));
    QVERIFY(driver.settle());
    QVERIFY(!driver.window().isWindowModified());

    WindowDriver second(kinds());
    QVERIFY(second.open(path));
    QCOMPARE(second.text("figures"), QStringLiteral("25"));
    second.choose("saveFileAs");
    QVERIFY(second.enterFileName("saveDialog", folder.filePath("other.globe")));
    QVERIFY(second.settle());
    QFile written(folder.filePath("other.globe"));
    QVERIFY(written.open(QIODevice::ReadOnly));
    QCOMPARE(written.readAll(), QByteArray("globe 25\n"));
    written.close();

    QVERIFY(written.open(QIODevice::WriteOnly) && written.write("globe -1\n") > 0);
    written.close();
    QVERIFY(second.open(written.fileName()));
    QVERIFY2(second.text("messageText").contains("A globe of radius -1 is flat.<br>Blow it up."),
             qPrintable(second.text("messageText")));

    WindowDriver without;  // says so, and keeps its hands off
    QVERIFY(without.open(path));
    QCOMPARE(without.tabs(), 0);
  }

  // A tool of such a kind shows what it makes in place of the document, and what only its own window understands.
  void aKindThatIsRegisteredHasItsOwnPreviews() {
    std::vector<KindRegistration> entries = registeredKinds();
    entries.insert(entries.begin(), globeRegistration({}));
    WindowDriver driver(std::move(entries));
    driver.choose("newGlobe");
    QVERIFY(driver.settle());
    auto* view = driver.find<Viewport>("viewport");
    QTRY_VERIFY(view->isPickingReady());
    const GlobeUi* ui = nullptr;
    for (const KindUi* each : driver.window().findChildren<KindUi*>()) {
      if (const auto* own = dynamic_cast<const GlobeUi*>(each)) ui = own;
    }
    QVERIFY(ui);
    const auto reach = [view] { return view->bounds().max().x(); };
    driver.find<QAction>("growTool")->trigger();
    QVERIFY(reach() == 10.0 && !ui->previewed);
    const QPoint middle = view->rect().center();
    QTest::mousePress(view, Qt::LeftButton, {}, middle);
    QCOMPARE(reach(), 20.0);
    QCOMPARE(ui->previewed, std::optional(20.0));
    QCOMPARE(driver.text("figures"), QStringLiteral("10"));
    QTest::keyClick(view, Qt::Key_Escape);
    QVERIFY(reach() == 10.0 && !ui->previewed);
    QTest::mouseRelease(view, Qt::LeftButton, {}, middle);
    QTest::mousePress(view, Qt::LeftButton, {}, middle);
    QTRY_VERIFY(view->isPickingReady());
    const Pick seen = view->pickAt(middle);
    QCOMPARE(partOf(seen), std::string("globe"));
    QVERIFY(std::abs(seen.point.cwiseAbs().sum() - 20.0) < 1e-9);  // on the octahedron of this radius
    QTest::mouseRelease(view, Qt::LeftButton, {}, middle);
    QVERIFY(reach() == 20.0 && !ui->previewed);
    QCOMPARE(driver.text("figures"), QStringLiteral("20"));
    driver.click("quickActions/undo");
    QCOMPARE(reach(), 10.0);
  }

  // The same on the command line: 'new', 'convert' and their help know what is registered.
  void aKindThatIsRegisteredHasCommands() {
    const QTemporaryDir folder;
    std::vector<KindRegistration> entries = registeredKinds();
    QVERIFY(!QByteArray(newDetails(RegisteredKinds(std::move(entries)).set.documents).c_str()).contains("globe"));
    entries = registeredKinds();
    entries.insert(entries.begin(), globeRegistration({}));
    const RegisteredKinds registered(std::move(entries));
    const KindSet& set = registered.set;
    QVERIFY(newDetails(set.documents).find("globe") != std::string::npos);
    QVERIFY(convertDetails(set.documents).find("of a globe: .globe .handwheel") != std::string::npos);
    const auto made = folder.filePath("a.handwheel").toStdString(), exported = folder.filePath("a.globe").toStdString();
    Arguments arguments;
    arguments.operands = {"globe", "radius=2in"};
    arguments.options.emplace("output", made);
    QCOMPARE(runNew(arguments, set.documents), 0);
    Arguments conversion;
    conversion.operands = {made, exported};
    QCOMPARE(runConvert(conversion, set.documents), 0);
    QFile written(QString::fromStdString(exported));
    QVERIFY(written.open(QIODevice::ReadOnly));
    QCOMPARE(written.readAll(), QByteArray("globe 50.8\n"));
  }

  // Its own command has a line in the overview, a help page, options with ranges, and figures as JSON.
  void aKindThatIsRegisteredHasItsOwnCommand() {
    const QTemporaryDir folder;
    struct Said {
      int code;
      QByteArray out, err;
    };
    const auto run = [&folder](const QStringList& words) {
      QProcess process;
      process.setWorkingDirectory(folder.path());
      process.start(QStringLiteral(GLOBE_PROGRAM), words);
      process.waitForFinished();
      return Said{process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
    };
    QVERIFY(run({"help"}).out.contains("\n  inflate    Makes a globe larger, or smaller.\n"));
    const QByteArray page = run({"help", "inflate"}).out;
    QVERIFY2(page.startsWith("Usage: handwheel inflate IN [--by N] [--at-most MM] -o OUT [--json]\n"), page);
    QVERIFY2(page.simplified().contains("--by N Factor of the radius (0.1 to 10, default 2)"), page);
    QVERIFY2(page.simplified().contains("--at-most MM No larger than this radius (1 to 1000)"), page);
    QCOMPARE(run({"new", "globe", "radius=25", "-o", "a.handwheel"}).code, 0);
    const Said told = run({"inflate", "a.handwheel", "--by", "1.5", "-o", "b.globe"});
    QCOMPARE(told.err, QByteArray());
    QCOMPARE(told.out, QByteArray("Radius: 37.5 mm\n"));
    const auto json =
        nlohmann::json::parse(run({"inflate", "b.globe", "-o", "c.globe", "--at-most=50", "--json"}).out.toStdString());
    const nlohmann::json expected = {{"options", {{"by", 2.0}, {"at_most_mm", 50.0}}}, {"radius_mm", 50.0}};
    QVERIFY2(json == expected, json.dump().c_str());
    const Said wrong = run({"inflate", "a.handwheel", "--by", "11", "-o", "d.globe"});
    QCOMPARE(wrong.code, 1);
    QCOMPARE(wrong.err, QByteArray("handwheel: --by takes a number from 0.1 to 10, not '11'.\n"
                                   "Try 'handwheel help inflate'.\n"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), (QStringList{"a.handwheel", "b.globe", "c.globe"}));
  }

  void aRobotMovesByItsSliders() {
    WindowDriver driver;
    driver.choose("openRobotSample");
    QVERIFY(driver.settle());
    QCOMPARE(driver.find<QDockWidget>("kindDock")->windowTitle(), QStringLiteral("Joints"));
    const QImage before = driver.find<Viewport>("viewport")->grabImage();
    driver.edit("joint.joint_2", "45");
    QVERIFY(driver.window().isWindowModified());
    QVERIFY(driver.find<Viewport>("viewport")->grabImage() != before);
    driver.click("quickActions/undo");
    QVERIFY(!driver.window().isWindowModified());
  }

  // While a link is dragged its joint, value and limits stand beside the cursor; they go with the release.
  void aDraggedJointTellsItsValue() {
    WindowDriver driver;
    driver.choose("openRobotSample");
    QVERIFY(driver.settle());
    auto* view = driver.find<Viewport>("viewport");
    QTRY_VERIFY(view->isPickingReady());
    const auto* readout = driver.find<QLabel>("toolReadout");
    // The hand of the arm is what sees most of its joints below it; anything that is no part of the foot will do.
    QPoint grip;
    for (int y = 20; y < view->height() && grip.isNull(); y += 10) {
      for (int x = 20; x < view->width() && grip.isNull(); x += 10) {
        const ViewRay ray = view->rayAt(QPointF(x, y));
        if (!partOf(view->pickAlong(ray.origin, ray.direction)).empty()) grip = {x, y};
      }
    }
    QVERIFY(!grip.isNull());
    QTest::mousePress(view, Qt::LeftButton, {}, grip);
    QVERIFY(!readout->isVisible());
    const QPoint to = grip + QPoint(40, 25);
    QMouseEvent move(QEvent::MouseMove, to, view->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view, &move);
    QVERIFY(readout->isVisible());
    QVERIFY2(readout->text().contains("joint_") && readout->text().contains(QStringLiteral("°")),
             qPrintable(readout->text()));
    QVERIFY2(readout->text().contains(" to "), qPrintable(readout->text()));
    QVERIFY(view->rect().contains(readout->geometry()));
    QTest::mouseRelease(view, Qt::LeftButton, {}, to);
    QVERIFY(!readout->isVisible());
    QVERIFY(driver.settle());
  }
};

HANDWHEEL_WINDOW_TEST(KindsTest)
#include "KindsTest.moc"
