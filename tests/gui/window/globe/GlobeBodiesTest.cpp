// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "GlobeWindow.h"
#include "document/scene/BodyBlobs.h"

#include <QProcess>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

// The two bodies of a globe, with a shape that the program does not have: moved and renamed, undone, saved.
class GlobeBodiesTest : public QObject {
  Q_OBJECT

  struct Said {
    int code;
    QByteArray out, err;
  };
  static Said run(const QString& folder, const QStringList& words) {
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(test::buildPath("tests/GlobeProgram"), words);
    process.waitForFinished();
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
  }
  static Vec3 positionOf(GlobeWindow& globe, BodyId id) {
    return globe.document().bodies().withId(id)->pose.translation();
  }
  // The mean of the points of a body that are shown.
  static Vec3 middleShown(GlobeWindow& globe, std::size_t body) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < kGlobePoints; ++i) sum += globe.layer().points()[body * kGlobePoints + i];
    return sum / static_cast<double>(kGlobePoints);
  }

 private slots:
  void areMovedAndRenamedByThePanel() {
    GlobeWindow globe;
    QVERIFY(globe.begin());
    const auto& bodies = globe.document().bodies();
    const GeometryPointer shape = bodies.withId(kMoonBody)->geometry;
    QVERIFY((middleShown(globe, 1) - Vec3(0, 15, 0)).norm() < 0.01);
    globe.driver.edit("body.2.x", "1in");
    globe.driver.edit("body.1.z", "-3");
    globe.driver.edit("body.2.name", "Luna");
    QCOMPARE(positionOf(globe, kMoonBody), Vec3(25.4, 15, 0));
    QVERIFY((middleShown(globe, 1) - Vec3(25.4, 15, 0)).norm() < 0.01);
    QVERIFY((middleShown(globe, 0) - Vec3(0, 0, -3)).norm() < 0.04);
    QVERIFY(bodies.withName("Luna") && bodies.withName("Luna")->geometry == shape);
    QCOMPARE(globe.document().history()->count(), 3);
    globe.driver.edit("body.2.name", "globe");  // the other has this name
    QCOMPARE(bodies.withId(kMoonBody)->name, std::string("Luna"));
    for (int i = 0; i < 3; ++i) globe.driver.click("quickActions/undo");
    QCOMPARE(bodies.withId(kMoonBody)->name, std::string("moon"));
    QCOMPARE(positionOf(globe, kMoonBody), Vec3(0, 15, 0));
    QCOMPARE(positionOf(globe, kGlobeBody), Vec3(0, 0, 0));
    QVERIFY(!globe.driver.window().isWindowModified());
    for (int i = 0; i < 3; ++i) globe.driver.click("quickActions/redo");
    QCOMPARE(positionOf(globe, kMoonBody), Vec3(25.4, 15, 0));
    QVERIFY(bodies.withName("Luna"));
  }

  // A gesture on a moved globe acts at its present pose; the poses are unchanged when saved and opened again.
  void aMovedGlobeIsDentedAndSaved() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("moved.handwheel");
    GlobeWindow globe;
    QVERIFY(globe.begin("dentTool", StandardView::Top));
    globe.driver.edit("body.1.x", "-30");
    globe.driver.edit("body.2.name", "Luna");
    QVERIFY(globe.look(StandardView::Top));
    const QPoint pole = globe.pixelOf({-30, 0, 10}).toPoint();
    QTest::mousePress(globe.view, Qt::LeftButton, {}, pole);
    QTRY_VERIFY(globe.lowestShown() < 9.8);
    QTest::mouseRelease(globe.view, Qt::LeftButton, {}, pole);
    QVERIFY(globe.document().surface().heightTowards({0, 0, 1}) < 9.9);
    QCOMPARE(globe.document().surface().heightTowards({1, 0, 0}), 10.0);
    globe.driver.click("quickActions/saveFile");
    QVERIFY(globe.driver.enterFileName("saveDialog", path) && globe.driver.settle());
    GlobeWindow second;
    QVERIFY(second.driver.open(path));
    QVERIFY(second.document().surface() == globe.document().surface());
    QCOMPARE(positionOf(second, kGlobeBody), Vec3(-30, 0, 0));
    QVERIFY(second.document().bodies().withName("Luna"));
    const auto bytes = [](GlobeWindow& window) {
      const GlobeDocument& document = window.document();
      return containerBytes(document.kind(), document.file(), *document.snapshot(), {}, Compression::None).value();
    };
    QVERIFY(bytes(second) == bytes(globe));
  }

  void aBodyIsHidden() {
    GlobeWindow globe;
    QVERIFY(globe.begin());
    QVERIFY(globe.view->bounds().max().y() > 16.0);
    QVERIFY(globe.document().setProperty("body.2.visible", false));
    QCOMPARE(globe.layer().points().size(), kGlobePoints);
    QVERIFY(globe.view->bounds().max().y() < 10.1);
    globe.driver.click("quickActions/undo");
    QVERIFY(globe.view->bounds().max().y() > 16.0);
  }

  // The same by 'handwheel set'; the foreign format says what it cannot hold.
  void areSetOnTheCommandLine() {
    const QTemporaryDir folder;
    QCOMPARE(run(folder.path(), {"new", "globe", "-o", "a.handwheel"}).code, 0);
    const Said done = run(
        folder.path(), {"set", "a.handwheel", "body.1.x=3", "body.2.y=1in", "body.2.name=Luna", "-o", "b.handwheel"});
    QCOMPARE(done.err, QByteArray());
    const auto printed =
        nlohmann::json::parse(run(folder.path(), {"inspect", "--json", "b.handwheel"}).out.toStdString());
    std::map<std::string, nlohmann::json> bodiesByName;
    for (const nlohmann::json& body : printed["document"]["bodies"]) bodiesByName[body["name"]] = body;
    QVERIFY2(bodiesByName.contains("Luna") && bodiesByName.contains("globe"), printed.dump().c_str());
    QVERIFY(bodiesByName["Luna"]["position"] == nlohmann::json({0.0, 25.4, 0.0}));
    QVERIFY(bodiesByName["globe"]["position"] == nlohmann::json({3.0, 0.0, 0.0}) &&
            bodiesByName["globe"]["shape"] == "globe");
    const Said taken = run(folder.path(), {"set", "a.handwheel", "body.2.name=globe", "-o", "c.handwheel"});
    QVERIFY(taken.code != 0 && taken.err.contains("globe"));
    const Said exported = run(folder.path(), {"convert", "b.handwheel", "d.globe"});
    QVERIFY2(exported.err.contains("The name and the place of Luna are not in the file."), exported.err);
    QVERIFY(!QFile::exists(folder.filePath("c.handwheel")) && QFile::exists(folder.filePath("d.globe")));
  }

  // A program that does not know the shape keeps it, and writes it back.
  void aStrangersShapeIsKept() {
    GlobeSurface points(20.0);
    points.setDent(7, 0.25);
    Container first, second;
    writeBodies(globeBodies(points), "globe", first, {&kGlobeFormat, 1});
    std::vector<Error> damage;
    const BodySet unknown = readBodies(first, "globe", damage, {}).value();
    QVERIFY(damage.empty() && unknown.size() == 2 && !unknown.withId(kGlobeBody)->geometry->isKnown());
    writeBodies(unknown, "globe", second);
    QVERIFY(second.blobs == first.blobs && *second.manifest == *first.manifest);
    damage.clear();
    const BodySet again = readBodies(second, "globe", damage, {}, {&kGlobeFormat, 1}).value();
    QVERIFY(damage.empty() && pointsOf(*again.withId(kGlobeBody)) == points);
    Container without;  // written as what is seen of it
    writeBodies(again, "globe", without);
    const BodySet seen = readBodies(without, "globe", damage, {}).value();
    QVERIFY(damage.empty() && seen.withId(kGlobeBody)->geometry->isKnown());
    QCOMPARE(seen.withId(kGlobeBody)->geometry->surface()->triangles.size(), std::size_t{8});
  }
};

HANDWHEEL_WINDOW_TEST(GlobeBodiesTest)
#include "GlobeBodiesTest.moc"
