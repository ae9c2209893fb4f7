// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceKind.h"

#include "TestClass.h"
#include "document/DocumentErrors.h"
#include "document/formats/MeshFormat.h"
#include "document/workpiece/ProgramToolsEdit.h"
#include "document/workpiece/ProgramTrial.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "machining/lathe/LatheJson.h"
#include "mesh/structure/Weld.h"
#include "nurbs/StepWriter.h"
#include "scene/RevolvedGeometry.h"

#include <MeshChecks.h>
#include <rapidcheck.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>
#include <thread>

using namespace handwheel;
using nlohmann::json;

class WorkpieceKindTest : public QObject {
  Q_OBJECT

 private slots:
  void savedIsLoaded();
  void containerOnDisk();
  void crashesAreKept();
  void programToolsAreKept();
  void hostileManifest_data();
  void hostileManifest();
  void stepIsAValidSolid();
  void meshesAreClosed_data();
  void meshesAreClosed();
  void refusesUnknownEndings();
  void cancelledWritesNothing();
  void foreignFilesAreNotRead();
  void describes();
  void aBarAsABody();
  void anyBarHasTriangles();
  void trianglesForManyThreads();

 private:
  std::filesystem::path at(const char* name) const { return m_folder.filePath(name).toStdString(); }
  QTemporaryDir m_folder;
  WorkpieceKind m_kind;
};

namespace {

WorkpieceSnapshot workpiece(const StockCylinder& stock, double chord = 0.01, std::string material = {}) {
  WorkpieceSnapshot value;
  value.stock = stock;
  value.chord = chord;
  value.material = std::move(material);
  value.mesh = std::make_shared<const StockMesh>(stock, chord);
  return value;
}

const WorkpieceSnapshot& valueOf(const SnapshotPointer& content) {
  return static_cast<const WorkpieceSnapshot&>(*content);
}

double between(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

WorkpieceSnapshot anyWorkpiece() {
  const StockCylinder stock{std::pow(10.0, between(-6, 6)), std::pow(10.0, between(-6, 6)), between(-1e7, 1e7)};
  return workpiece(
      stock, std::pow(10.0, between(-4, 3)),
      *rc::gen::elementOf(std::vector<std::string>{"", "C45", "\"\\\n\t", "Øl 铝 🜛", std::string(1, '\0')}));
}

bool same(const WorkpieceSnapshot& a, const WorkpieceSnapshot& b) {
  return a.stock == b.stock && a.chord == b.chord && a.material == b.material;
}

std::string bytesOf(const std::filesystem::path& path) {
  QFile file(QString::fromStdString(path.string()));
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

}  // namespace

void WorkpieceKindTest::savedIsLoaded() {
  QVERIFY(rc::check("to the last digit, through text", [this] {
    const WorkpieceSnapshot value = anyWorkpiece();
    Container container;
    m_kind.save(value, container);
    *container.manifest = json::parse(container.manifest->dump());
    std::vector<Error> damage;
    const auto back = m_kind.load(container, damage, {});
    RC_ASSERT(back.hasValue());
    RC_ASSERT(damage.empty());
    RC_ASSERT(same(valueOf(*back), value));
    RC_ASSERT(valueOf(*back).mesh->isOf(value.stock, value.chord));
  }));
}

void WorkpieceKindTest::containerOnDisk() {
  std::vector<std::unique_ptr<DocumentKind>> list;
  list.push_back(std::make_unique<WorkpieceKind>());
  const DocumentKinds kinds(std::move(list));
  const DocumentKind& kind = *kinds.all()[0];
  const auto document = kind.make(DocumentKinds::blank(kind));
  QVERIFY(document->setProperty("diameter", 12.5));
  QVERIFY(document->setProperty("material", std::string("S235")));
  const auto path = at("bar.handwheel");
  QVERIFY(saveDocument(kind, document->file(), *document->snapshot(), path).hasValue());
  const auto opened = kinds.open(path, {});
  QVERIFY(opened.hasValue());
  QVERIFY(opened->file.damage.empty());
  QCOMPARE(opened->file.id, document->file().id);
  QVERIFY(same(valueOf(opened->content), valueOf(document->snapshot())));
}

// Also for an uncut bar, and from the key where an older program kept them; with their bodies, and undone as one step.
// Impossible tools are left out and reported.
void WorkpieceKindTest::programToolsAreKept() {
  const LatheTools shipped = shippedLatheTools();
  ProgramTools tools;
  tools[1] = programToolOf(toolNamed(shipped, "right-roughing"), ProgramDialect::LinuxCnc);
  tools[7] = {0.4, 3, {1.25, -20.5}};
  WorkpieceDocument document({&m_kind, {}, std::make_shared<const WorkpieceSnapshot>(workpiece({40.0, 100.0, 0.0}))});
  document.commit(QStringLiteral("Tools"),
                  std::make_unique<ProgramToolsEdit>(std::make_shared<const ProgramTools>(tools)));
  Container container;
  m_kind.save(document.workpiece(), container);
  *container.manifest = json::parse(container.manifest->dump());
  std::vector<Error> damage;
  const auto loaded = m_kind.load(container, damage, {});
  QVERIFY(loaded && damage.empty() && valueOf(*loaded).programTools);
  const ProgramTools& back = *valueOf(*loaded).programTools;
  QCOMPARE(toolTableText(back), toolTableText(tools));
  QVERIFY(back.at(1).body && back.at(1).body->id == "right-roughing" && !back.at(7).body);
  // A program runs with them; a Fanuc has other numbers for the same side of the nose.
  const ProgramSetup fanuc = programSetupFor(valueOf(*loaded), shipped, ProgramDialect::Fanuc, 0.8);
  for (const auto& [number, tool] : tools)
    QCOMPARE(tipDirection(ProgramDialect::Fanuc, fanuc.tools.at(number).orientation),
             tipDirection(ProgramDialect::LinuxCnc, tool.orientation));
  QCOMPARE(fanuc.tools.at(7).offset, ProfilePoint(1.25, -20.5));
  document.history()->undo();
  QVERIFY(!document.workpiece().programTools);
  document.history()->redo();
  QVERIFY(document.workpiece().programTools);

  json& listed = (*container.manifest)["document"]["program_tools"];
  listed.push_back({{"number", 2}, {"tool", "spoon"}, {"nose_radius", 0.4}, {"orientation", 2}, {"offset", {0, 0}}});
  listed.push_back({{"number", 3}, {"nose_radius", -1}, {"orientation", 2}, {"offset", {0, 0}}});
  listed.push_back({{"number", 4}, {"nose_radius", 1}, {"orientation", 12}, {"offset", {0, 0}}});
  listed.push_back({{"number", -1}, {"nose_radius", 1}, {"orientation", 1}, {"offset", {0, 0}}});
  listed.push_back({{"number", 5}, {"nose_radius", 1}, {"orientation", 1}, {"offset", {0, 1e9}}});
  listed.push_back(3);
  const auto partly = m_kind.load(container, damage, {});
  QVERIFY(partly && valueOf(*partly).programTools->size() == 2);
  QCOMPARE(damage.size(), std::size_t(6));
}

void WorkpieceKindTest::crashesAreKept() {
  WorkpieceSnapshot value = workpiece({40.0, 100.0, 0.0});
  LatheCollision crash;
  crash.cause = CrashCause::SpindleAtRest;
  crash.position = {20.0, 80.0};
  crash.tool = "facing";
  value.crashes = std::make_shared<const std::vector<LatheCollision>>(std::vector{crash, crash});
  Container container;
  m_kind.save(value, container);
  std::vector<Error> damage;
  const Result<SnapshotPointer> loaded = m_kind.load(container, damage, {});
  QVERIFY(loaded.hasValue() && damage.empty());
  QVERIFY(valueOf(*loaded).crashes && *valueOf(*loaded).crashes == *value.crashes);
  QVERIFY(!valueOf(*loaded).part);
  (*container.manifest)["document"]["turned"] = {{"crashes", (*container.manifest)["document"]["crashes"]}};
  const Result<SnapshotPointer> older = m_kind.load(container, damage, {});
  QVERIFY(older.hasValue() && valueOf(*older).crashes->size() == 4);
  (*container.manifest)["document"].erase("turned");
  (*container.manifest)["document"]["crashes"] = json::array({3, {{"cause", "bad luck"}}});
  const Result<SnapshotPointer> hostile = m_kind.load(container, damage, {});
  QVERIFY(hostile.hasValue() && !valueOf(*hostile).crashes);
}

void WorkpieceKindTest::hostileManifest_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<int>("damaged");
  const auto row = [](const char* text, int damaged) { QTest::newRow(text) << text << damaged; };
  row(R"({})", 5);
  row(R"({"diameter": "50"})", 5);
  row(R"({"diameter": null, "length": [], "position": {}, "chord": true, "material": 7})", 5);
  row(R"({"diameter": -50, "length": 0, "position": 1e300, "chord": -1e-300, "material": ""})", 4);
  row(R"({"diameter": 1e308, "length": 1e-300, "position": -1e308, "chord": 0, "material": []})", 5);
  row(R"({"diameter": 18446744073709551615, "length": -9223372036854775808, "position": 0, "chord": 1, "material": ""})",
      2);
  row(R"({"diameter": 20, "length": 30, "position": 1, "chord": 1, "material": "x", "unknown": {"a": [1, 2]}})", 0);
}

void WorkpieceKindTest::hostileManifest() {
  QFETCH(QString, text);
  QFETCH(int, damaged);
  Container container;
  (*container.manifest)["document"] = json::parse(text.toStdString());
  std::vector<Error> damage;
  const auto loaded = m_kind.load(container, damage, {});
  QVERIFY(loaded.hasValue());
  QCOMPARE(static_cast<int>(damage.size()), damaged);
  QVERIFY(valueOf(*loaded).stock.isSound());
  QVERIFY(valueOf(*loaded).chord >= WorkpieceSnapshot::kLeastChord);
  if (damaged == 5) QVERIFY(same(valueOf(*loaded), WorkpieceSnapshot()));

  const double nan = std::numeric_limits<double>::quiet_NaN();
  (*container.manifest)["document"] = {{"diameter", nan}, {"length", -HUGE_VAL}, {"material", std::string(2000, 'x')}};
  damage.clear();
  QVERIFY(same(valueOf(*m_kind.load(container, damage, {})), WorkpieceSnapshot()));
  QCOMPARE(damage.size(), std::size_t{5});
  for (const json& document : {json(), json(5), json::array(), json("document")}) {
    (*container.manifest)["document"] = document;
    QVERIFY(!m_kind.load(container, damage, {}));
  }
  container.manifest->erase("document");
  QVERIFY(!m_kind.load(container, damage, {}));
}

void WorkpieceKindTest::stepIsAValidSolid() {
  for (const StockCylinder& stock : {StockCylinder{50, 100, 0}, {1e-3, 1e3, 7}, {1e6, 1, -1e7}, {3, 4, 1e7}}) {
    const auto path = at("bar.STEP");
    const auto written = m_kind.exportTo(workpiece(stock), path, {});
    QVERIFY(written.hasValue());
    QVERIFY(written->isExport);
    const std::string bytes = bytesOf(path);
    QCOMPARE(bytes.size(), written->bytes);
    const auto report = inspectStep(bytes);
    QVERIFY(report.hasValue());
    QVERIFY(report->isValid);
    QCOMPARE(report->solids, std::size_t{1});
    const double r = stock.diameter / 2;
    QVERIFY(std::abs(report->volume / (M_PI * r * r * stock.length) - 1) < 1e-7);
    QVERIFY((report->bounds.min() - Vec3(-r, -r, stock.position)).norm() < 1e-6);
    QVERIFY((report->bounds.max() - Vec3(r, r, stock.position + stock.length)).norm() < 1e-6);
  }
}

void WorkpieceKindTest::meshesAreClosed_data() {
  QTest::addColumn<QString>("ending");
  QTest::addColumn<bool>("isSingle");
  for (const FileFormat& format : WorkpieceKind().formats()) {
    QVERIFY(format.writes);
    QCOMPARE(format.reads, format.name == "DXF" || format.name == "SVG");  // drawings open as targets
    if (format.name == "STEP") continue;
    for (const std::string& ending : format.endings) {
      if (ending == ".dxf" || ending == ".svg" || ending == ".pdf") continue;  // drawings
      QTest::newRow(ending.c_str()) << QString::fromStdString(ending) << (ending == ".stl" || ending == ".3mf");
    }
  }
}

void WorkpieceKindTest::meshesAreClosed() {
  QFETCH(QString, ending);
  QFETCH(bool, isSingle);
  const auto path = at(("bar" + ending.toStdString()).c_str());
  const auto written = m_kind.exportTo(workpiece({50, 100, 20}), path, {});
  QVERIFY(written.hasValue());
  const auto file = readMeshFile(path, {});
  QVERIFY(file.hasValue());
  const TriangleSoup soup = weld(file->soup);
  QVERIFY(test::countEdges(soup).sound());
  const double exact = M_PI * 625 * 100, rounding = isSingle ? 1e-6 : 1e-12;
  QVERIFY(test::volume(soup) < exact * (1 + rounding));
  QVERIFY(test::volume(soup) > exact * (1 - 4 * 0.01 / 50 - rounding));
}

void WorkpieceKindTest::refusesUnknownEndings() {
  for (const char* name : {"bar.xyz", "bar", "bar.stepp"}) {
    const auto written = m_kind.exportTo(WorkpieceSnapshot(), at(name), {});
    QVERIFY(!written);
    QCOMPARE(written.error().code, DocumentError::ExtensionUnknown);
    QVERIFY(!std::filesystem::exists(at(name)));
  }
  const auto nowhere = m_kind.exportTo(WorkpieceSnapshot(), at("no/such/folder/bar.step"), {});
  QVERIFY(!nowhere);
  QCOMPARE(nowhere.error().code, ErrorCode::WriteFailed);
}

void WorkpieceKindTest::cancelledWritesNothing() {
  JobState state;
  state.cancelled = true;
  for (const char* name : {"cancelled.step", "cancelled.stl"}) {
    const auto written = m_kind.exportTo(WorkpieceSnapshot(), at(name), Progress(state));
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::Cancelled);
    QVERIFY(!std::filesystem::exists(at(name)));
  }
}

// Solids are read as meshes; of foreign files only drawings are workpieces.
void WorkpieceKindTest::foreignFilesAreNotRead() {
  QVERIFY(!m_kind.recognises("ISO-10303-21;\nHEADER;", "bar.step"));
  QVERIFY(!m_kind.recognises("solid bar\nfacet normal 0 0 1\n", "bar.stl"));
  QVERIFY(m_kind.recognises("0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n", "bar.dxf"));
  QVERIFY(m_kind.recognises("<svg xmlns='http://www.w3.org/2000/svg'/>", "bar.svg"));
  const auto opened = m_kind.import(at("bar.dxf"), {}, {});
  QVERIFY(!opened);
  QCOMPARE(opened.error().code, ErrorCode::FileMissing);
  const std::vector<FileFormat> formats = m_kind.formats();
  QCOMPARE(std::count_if(formats.begin(), formats.end(), [](const FileFormat& f) { return f.name == "STEP"; }), 1);
}

void WorkpieceKindTest::describes() {
  const json described = m_kind.describe(workpiece({20, 30, 1e7}, 0.1, "C45"));
  QCOMPARE(described["diameter"].get<double>(), 20.0);
  QCOMPARE(described["length"].get<double>(), 30.0);
  QCOMPARE(described["position"].get<double>(), 1e7);
  QCOMPARE(described["material"].get<std::string>(), std::string("C45"));
  QCOMPARE(described["volume"].get<double>(), M_PI * 100 * 30);
  QCOMPARE(described["area"].get<double>(), M_PI * 20 * 30 + 2 * M_PI * 100);
  QVERIFY(described["deviation"].get<double>() <= 0.1);
  QVERIFY(described["deviation"].get<double>() > 0.07);
  QVERIFY(described["triangles"].get<int>() > 100);
}

void WorkpieceKindTest::aBarAsABody() {
  std::vector<Note> notes;
  const GeometryPointer bar = m_kind.bodyGeometry(workpiece({20, 30, 7}, 0.1), notes);
  QVERIFY(bar && notes.empty());
  QCOMPARE(bar->kind(), RevolvedGeometry::kKind);
  const Box& box = bar->bounds();
  QVERIFY(box.min().z() == 7.0 && box.max().z() == 37.0);
  QVERIFY(std::abs(box.max().x() - 10.0) < 1e-12);
}

void WorkpieceKindTest::anyBarHasTriangles() {
  // The corner of the limits that asks for most.
  const WorkpieceSnapshot largest = workpiece({1e6, 1e6, 0}, WorkpieceSnapshot::kLeastChord);
  QVERIFY(largest.mesh->soup()->triangles.size() > 500'000);
  QVERIFY(rc::check("anywhere within the limits", [this] {
    const WorkpieceSnapshot value = anyWorkpiece();
    const DisplayModel model = m_kind.display(value);
    RC_ASSERT(model.parts.size() == 1u);
    const double r = value.stock.diameter / 2;
    const Box box = model.bounds();
    // The first corner of every ring is on +x.
    RC_ASSERT(std::abs(box.max().x() / r - 1) < 1e-12);
    RC_ASSERT(box.min().z() == value.stock.position);
    RC_ASSERT(std::abs(box.max().z() - value.stock.position - value.stock.length) < 1e-8);
  }));
}

void WorkpieceKindTest::trianglesForManyThreads() {
  const StockMesh mesh({50, 100, 0}, 0.01);
  std::array<const TriangleSoup*, 4> found{};
  std::vector<std::thread> threads;
  for (auto& soup : found) threads.emplace_back([&soup, &mesh] { soup = mesh.soup().get(); });
  for (std::thread& thread : threads) thread.join();
  for (const TriangleSoup* soup : found) QCOMPARE(soup, found[0]);
}

HANDWHEEL_TEST(WorkpieceKindTest)
#include "WorkpieceKindTest.moc"
