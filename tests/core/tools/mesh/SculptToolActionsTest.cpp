// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ScriptReplay.h"
#include "SculptFixture.h"
#include "TestClass.h"
#include "WaitingServices.h"
#include "mesh/sculpt/PatchRemeshing.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

class SculptToolActionsTest : public QObject {
  Q_OBJECT

 private slots:
  void levels();
  void aCoarseLevelTakesTheDetailAlong();
  void undoFindsTheLevels();
  void anEditElsewhereKeepsTheLevels();
  void rememberedForTheNextTime();
  void theWholeSurfaceStaysWhole();
  void rememberedInTheFile();
  void refinesToTheSurroundings();
  void warnsOfSlimTriangles();
  void smoothsNoise();
  void tellsWhyNot();
  void jobsThatComeTooLate();
  void radiusByKey();
  void oddSettings();
};

void SculptToolActionsTest::levels() {
  SculptFixture fixture(middle());
  QVERIFY(!isEnabled(*fixture.tool, "back") && !isEnabled(*fixture.tool, "coarser"));
  QCOMPARE(fixture.runner.perform("subdivide"), ToolReply::Used);
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(1));
  QCOMPARE(fixture.tool->level(), std::size_t(1));
  const std::size_t inside = (128 * 3 - 32) / 2;
  QCOMPARE(fixture.document->mesh().liveFaceCount(), 800 + 2 * inside);
  QCOMPARE(fixture.tool->levels().patch().count(), 128 + 2 * inside);
  fixture.runner.perform("subdivide");
  QCOMPARE(fixture.steps(), 2);
  QCOMPARE(fixture.check(), std::string());
  QCOMPARE(propertyNamed(fixture.tool->settings(), "level")->choices.size(), std::size_t(3));
  fixture.runner.perform("coarser");
  QCOMPARE(fixture.tool->level(), std::size_t(1));
  fixture.runner.setSetting("level", 0.0);
  QCOMPARE(fixture.tool->level(), std::size_t(0));
  fixture.runner.perform("back");
  fixture.runner.perform("back");
  QCOMPARE(fixture.document->mesh().liveFaceCount(), std::size_t(800));
  QCOMPARE(fixture.steps(), 4);
  QCOMPARE(fixture.check(), std::string());
}

// A small bump at the finest level rides on a hill raised at the coarsest one.
void SculptToolActionsTest::aCoarseLevelTakesTheDetailAlong() {
  SculptFixture fixture(middle());
  fixture.runner.perform("subdivide");
  fixture.runner.perform("subdivide");
  fixture.runner.setSetting("radius", 0.8);
  fixture.lift(0.3);
  const double bump = fixture.height();
  QVERIFY(std::abs(bump - 0.3) < 1e-6);
  fixture.runner.setSetting("level", 0.0);
  fixture.runner.setSetting("radius", 4.0);
  fixture.lift(1.0);
  QVERIFY(fixture.tool->levels().mesh(0).position(at(10, 10)).z() > 0.99);
  // The hill at the finest level, as it would be without the bump.
  SculptFixture plain(middle());
  plain.runner.perform("subdivide");
  plain.runner.perform("subdivide");
  plain.runner.setSetting("level", 0.0);
  plain.runner.setSetting("radius", 4.0);
  plain.lift(1.0);
  QVERIFY(std::abs(fixture.height() - plain.height() - bump) < 0.02);
  QCOMPARE(fixture.check(), std::string());
  QCOMPARE(fixture.steps(), 4);
  for (Vertex v = 0; v < 441; ++v) {
    const Vec3& p = fixture.document->mesh().position(v);
    const bool isInside = p.x() > 6 && p.x() < 14 && p.y() > 6 && p.y() < 14;
    QVERIFY(isInside || p.z() == 0.0);
  }
}

void SculptToolActionsTest::undoFindsTheLevels() {
  SculptFixture fixture(middle());
  fixture.runner.perform("subdivide");
  fixture.runner.setSetting("level", 0.0);
  fixture.lift(1.0);
  QVERIFY(fixture.tool->levels().mesh(0).position(at(10, 10)).z() > 0.9);
  fixture.document->history()->undo();
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(1));
  QCOMPARE(fixture.tool->levels().mesh(0).position(at(10, 10)).z(), 0.0);
  fixture.document->history()->undo();
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(0));
  QCOMPARE(fixture.tool->levels().patch().count(), std::size_t(128));
  fixture.document->history()->redo();
  fixture.document->history()->redo();
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(1));
  QVERIFY(fixture.tool->levels().mesh(0).position(at(10, 10)).z() > 0.9);
}

// Another hole is filled while the patch of one has levels; and so it is when the steps are done once more.
void SculptToolActionsTest::anEditElsewhereKeepsTheLevels() {
  TriangleSoup soup = sheet();
  const auto square = soup.triangles.begin() + 2 * (20 * 17 + 17);
  soup.triangles.erase(square, square + 2);
  SculptFixture fixture(middle(), soup);
  fixture.runner.perform("subdivide");
  fixture.runner.perform("subdivide");
  fixture.lift(0.3);
  const auto& loops = fixture.document->defects().loops;
  const auto hole = std::find_if(loops.begin(), loops.end(), [](const auto& l) { return l.halfEdges.size() == 4; });
  QVERIFY(hole != loops.end());
  QVERIFY(applyScriptLine(*fixture.document,
                          "fill v" + std::to_string(keyOf(fixture.document->mesh(), *hole)) + " --fill ear"));
  QCOMPARE(fixture.document->defects().loops.size(), std::size_t(1));
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(2));
  fixture.runner.setSetting("level", 0.0);
  fixture.lift(1.0);
  QVERIFY(fixture.tool->levels().mesh(0).position(at(10, 10)).z() > 0.99);
  QCOMPARE(fixture.check(), std::string());
  QCOMPARE(replayed(soup, *fixture.document), std::string());
  fixture.document->history()->undo();
  fixture.document->history()->undo();
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(2));
  QCOMPARE(fixture.document->defects().loops.size(), std::size_t(2));
  fixture.document->history()->redo();
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(2));
  fixture.start();  // the tool was left
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(2));
  fixture.runner.perform("back");
  fixture.runner.perform("back");
  QCOMPARE(fixture.document->mesh().liveFaceCount(), std::size_t(800));
  QCOMPARE(fixture.document->defects().loops.size(), std::size_t(1));
  QCOMPARE(fixture.check(), std::string());
}

// Sculpting the whole surface continues regardless of patches with levels.
void SculptToolActionsTest::theWholeSurfaceStaysWhole() {
  SculptFixture fixture(middle());
  fixture.runner.perform("subdivide");
  fixture.runner.perform("whole");
  fixture.lift(0.5, 2.0);
  fixture.document->history()->undo();
  QVERIFY(fixture.tool->levels().patch().empty());
  fixture.start();
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(1));
}

void SculptToolActionsTest::rememberedForTheNextTime() {
  SculptFixture fixture(middle());
  fixture.runner.perform("subdivide");
  fixture.start();
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(1));
  fixture.start({2 * (20 * 10 + 10)});  // a face of the patch
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(1));
  QVERIFY(fixture.tool->levels().patch().count() > 128);
  fixture.start({3});
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(0));
  QCOMPARE(fixture.tool->levels().patch().count(), std::size_t(1));
}

// A quadrilateral of two triangles of 8 mm in a plate of 1 mm.
void SculptToolActionsTest::rememberedInTheFile() {
  SculptFixture fixture(middle());
  fixture.runner.perform("subdivide");
  fixture.runner.perform("subdivide");
  fixture.lift(0.3);
  Container file;
  fixture.document->kind().save(*fixture.document->snapshot(), file);
  std::vector<Error> damage;
  OpenedFile opened;
  opened.kind = &fixture.document->kind();
  opened.content = *opened.kind->load(file, damage, {});
  fixture.runner.stop();
  fixture.document = std::make_unique<MeshDocument>(std::move(opened));
  fixture.start();
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(2));
  QCOMPARE(fixture.tool->levels().patch(0).count(), middle().count());
  fixture.runner.perform("back");
  fixture.runner.perform("back");
  QCOMPARE(fixture.document->mesh().liveFaceCount(), std::size_t(800));
  QCOMPARE(fixture.height(), 0.0);  // the height before the subdivision
  QCOMPARE(fixture.check(), std::string());
}

void SculptToolActionsTest::refinesToTheSurroundings() {
  TriangleSoup soup = annulus(24, 8, 4.0, 12.0);
  const auto centre = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back(Vec3::Zero());
  FaceSelection patch;
  for (std::uint32_t j = 0; j < 24; ++j) {
    patch.add(static_cast<Face>(soup.triangles.size()));
    soup.triangles.push_back({centre, j, (j + 1) % 24});
  }
  SculptFixture fixture(patch, soup);
  fixture.runner.perform("refine");
  QCOMPARE(fixture.tool->levels().finest(), std::size_t(0));  // even triangles are no level of the fan
  QVERIFY(fixture.tool->levels().patch().count() > 3 * patch.count());
  QVERIFY(isEven(fixture.document->mesh(), fixture.tool->levels().patch()));
  QCOMPARE(fixture.steps(), 1);
  QCOMPARE(fixture.check(), std::string());
  fixture.runner.perform("refine");
  QCOMPARE(fixture.steps(), 1);
  QVERIFY(!propertyNamed(fixture.tool->settings(), "patch")->problem.empty());
}

void SculptToolActionsTest::warnsOfSlimTriangles() {
  SculptFixture fixture({2 * (20 * 10 + 10), 2 * (20 * 10 + 10) + 1});
  for (int level = 1; level <= 4; ++level) {
    fixture.runner.perform("subdivide");
    const std::vector<Property> settings = fixture.tool->settings();
    const Property* aspect = propertyNamed(settings, "aspect");
    QVERIFY(aspect);
    QCOMPARE(aspect->problem.empty(), level <= 3);
  }
  QVERIFY(std::get<double>(propertyNamed(fixture.tool->settings(), "aspect")->value) > 8.0);
}

void SculptToolActionsTest::smoothsNoise() {
  TriangleSoup soup = sheet();
  for (std::size_t i = 0; i < soup.points.size(); ++i) soup.points[i].z() = 0.05 * ((i * 7919) % 13 - 6.0) / 6.0;
  const auto roughness = [](const HalfEdgeMesh& mesh) {
    double sum = 0.0;
    for (Vertex v = 0; v < 441; ++v) {
      const Vec3& p = mesh.position(v);
      if (p.x() > 6 && p.x() < 14 && p.y() > 6 && p.y() < 14) sum += p.z() * p.z();
    }
    return std::sqrt(sum);
  };
  SculptFixture fixture(middle(), soup);
  const double before = roughness(fixture.document->mesh());
  fixture.runner.perform("noise");
  QCOMPARE(fixture.steps(), 1);
  QVERIFY(roughness(fixture.document->mesh()) < 0.5 * before);
  QVERIFY(vertexAt(fixture.document->mesh(), soup.points[0]) != kNone);
  fixture.runner.perform("whole");
  fixture.runner.perform("noise");  // along the border of the plate
  QCOMPARE(fixture.steps(), 2);
  QCOMPARE(fixture.check(), std::string());
}

void SculptToolActionsTest::tellsWhyNot() {
  SculptFixture fixture({7});
  fixture.runner.perform("subdivide");
  QCOMPARE(fixture.steps(), 0);
  QVERIFY(!propertyNamed(fixture.tool->settings(), "patch")->problem.empty());
  SculptFixture whole;
  QVERIFY(!isEnabled(*whole.tool, "subdivide") && !isEnabled(*whole.tool, "refine") && isEnabled(*whole.tool, "noise"));
}

void SculptToolActionsTest::jobsThatComeTooLate() {
  const auto document = meshDocument(sheet());
  WaitingServices waiting;
  waiting.faces = std::make_shared<FaceHierarchy>(document->mesh());
  ToolRunner runner;
  runner.start(std::make_unique<SculptTool>(*document, waiting.services(), middle()), *document);
  runner.perform("subdivide");
  QVERIFY(!isEnabled(*runner.tool(), "subdivide"));
  runner.deliver(waiting.work());
  QCOMPARE(waiting.changes.size(), std::size_t(1));
  runner.perform("subdivide");
  runner.pointer(above(Kind::Press, 10, 10));  // a stroke goes before
  QCOMPARE(waiting.cancelled, 1);
  runner.deliver(waiting.work());
  QCOMPARE(static_cast<const SculptTool*>(runner.tool())->levels().finest(), std::size_t(1));
}

void SculptToolActionsTest::radiusByKey() {
  SculptFixture fixture;
  fixture.runner.perform("larger");
  QCOMPARE(std::get<double>(propertyNamed(fixture.tool->settings(), "radius")->value), 3.75);
  fixture.runner.perform("smaller");
  QCOMPARE(std::get<double>(propertyNamed(fixture.tool->settings(), "radius")->value), 3.0);
  // The first one follows from the size of the part, and can be read.
  for (const double size : {1.0, 2.2, 3.7, 56.0}) {
    const auto document = test::meshDocument(test::cube(size));
    const SculptTool tool(*document, immediateServices(*document), {});
    const double radius = std::get<double>(propertyNamed(tool.settings(), "radius")->value);
    QVERIFY(QStringList({"1", "2", "5"}).contains(QString::number(radius, 'e', 6).remove('0').section('.', 0, 0)));
    QVERIFY(radius < size);
  }
}

void SculptToolActionsTest::oddSettings() {
  SculptFixture fixture(middle());
  for (const PropertyValue& value : {PropertyValue(std::numeric_limits<double>::quiet_NaN()), PropertyValue(-7.0),
                                     PropertyValue(1e300), PropertyValue(true), PropertyValue(std::string("?"))}) {
    for (const char* id : {"brush", "radius", "strength", "moves_border", "noise_angle", "level", "patch", "nothing"})
      fixture.runner.setSetting(id, value);
    fixture.stroke({{10, 10}, {12, 11}});
    QCOMPARE(fixture.check(), std::string());
  }
}

HANDWHEEL_TEST(SculptToolActionsTest)
#include "SculptToolActionsTest.moc"
