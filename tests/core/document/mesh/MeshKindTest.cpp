// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/MeshKind.h"

#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "document/container/ArchiveErrors.h"
#include "document/mesh/MeshBlobs.h"
#include "mesh/repair/Repair.h"
#include "mesh/structure/MeshErrors.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

const MeshKind kKind;

DocumentKinds kinds() {
  std::vector<std::unique_ptr<DocumentKind>> all;
  all.push_back(std::make_unique<MeshKind>());
  return DocumentKinds(std::move(all));
}

bool hasSameSlots(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  if (a.vertexSlots() != b.vertexSlots() || a.faceSlots() != b.faceSlots()) return false;
  for (Vertex v = 0; v < a.vertexSlots(); ++v) {
    if (a.position(v) != b.position(v)) return false;
  }
  for (Face f = 0; f < a.faceSlots(); ++f) {
    if (a.triangle(f) != b.triangle(f)) return false;
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      if (a.opposite(h) != b.opposite(h)) return false;
    }
  }
  return true;
}

// A grid with a vertex raised here and there.
TriangleSoup grid(std::uint32_t n) {
  TriangleSoup soup;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) soup.points.emplace_back(x, y, (x * y) % 3 * 0.25);
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x, b = a + n + 1;
      soup.triangles.push_back({a, a + 1, b + 1});
      soup.triangles.push_back({a, b + 1, b});
    }
  }
  return soup;
}

Result<SnapshotPointer> reloaded(const Document& document, std::vector<Error>& damage) {
  Container container;
  kKind.save(*document.snapshot(), container);
  return kKind.load(container, damage, {});
}

const MeshSnapshot& meshOf(const SnapshotPointer& content) {
  return static_cast<const MeshSnapshot&>(*content);
}

}  // namespace

class MeshKindTest : public QObject {
  Q_OBJECT

 private slots:
  // A file that no other kind accepts is a mesh; its formats are those of mesh files.
  void whatItReads() {
    QVERIFY(kKind.recognises("anything", "of.any.name"));
    const std::vector<std::string> endings = kinds().readEndings();
    for (const char* const each : {".stl", ".obj", ".ply", ".off", ".3mf", ".step", ".handwheel"})
      QVERIFY2(std::count(endings.begin(), endings.end(), each) == 1, each);
    const std::vector<std::string> written = writtenEndings(kKind.formats());
    QVERIFY(std::count(written.begin(), written.end(), ".stl") == 1);
    QVERIFY(std::count(written.begin(), written.end(), ".step") == 0);  // triangles are no surfaces
  }

  // A flat grid of 3 × 3 squares has 18 triangles and one boundary; two triangles at its corner beside it have another.
  void surfacesOfOtherDocuments() {
    TriangleSoup soup = grid(3);
    const auto mesh = kKind.ofSurface(soup, "of a volume", {});
    QVERIFY(mesh.hasValue());
    nlohmann::json described = kKind.describe(**mesh);
    QVERIFY(described ==
            nlohmann::json({{"triangles", 18}, {"boundary_loops", 1}, {"non_manifold_edges", 0}, {"parts", 1}}));
    QVERIFY(meshOf(*mesh).numbers == NumberType::Float64);
    const auto at = static_cast<std::uint32_t>(soup.points.size());
    for (const Vec3& p : {Vec3(9, 0, 0), Vec3(10, 0, 0), Vec3(9, 1, 0), Vec3(10, 1, 0)}) soup.points.push_back(p);
    soup.triangles.push_back({at, at + 1, at + 2});
    soup.triangles.push_back({at + 1, at + 3, at + 2});
    described = kKind.describe(**kKind.ofSurface(soup, {}, {}));
    QVERIFY(described ==
            nlohmann::json({{"triangles", 20}, {"boundary_loops", 2}, {"non_manifold_edges", 0}, {"parts", 2}}));
    QCOMPARE(kKind.ofSurface({}, {}, {}).error().code, MeshError::NoTriangles);
    JobState state;
    state.cancelled = true;
    QCOMPARE(kKind.ofSurface(soup, {}, Progress(state)).error().code, ErrorCode::Cancelled);
  }

  // A saved document is restored slot for slot, including dead slots and marks, after any edits.
  void loadingIsTheInverseOfSaving() {
    const bool held = rc::check([] {
      const auto document = test::meshDocument(grid(*rc::gen::inRange<std::uint32_t>(1, 6)));
      const auto edits = *rc::gen::inRange(0, 6);
      for (int i = 0; i < edits; ++i) {
        HalfEdgeMesh mesh = document->mesh();
        const auto f = static_cast<Face>(*rc::gen::inRange<std::size_t>(0, mesh.faceSlots()));
        if (mesh.isLive(f)) mesh.removeFace(f);
        relink(mesh);
        document->commit("Remove", inspected(mesh));
      }
      if (!document->defects().loops.empty()) document->setKeptOpen(document->defects().loops[0], true);
      FidelityValues choice;
      if (*rc::gen::arbitrary<bool>()) RC_ASSERT(choice.set(fillMethodSetting(), *rc::gen::inRange(0, 8)));
      if (*rc::gen::arbitrary<bool>()) RC_ASSERT(choice.set(fillContinuitySetting(), *rc::gen::inRange(0, 3)));
      document->setFillChoice(choice);
      std::vector<Error> damage;
      const auto back = reloaded(*document, damage);
      if (document->mesh().liveFaceCount() == 0) return;
      RC_ASSERT(back.hasValue());
      RC_ASSERT(damage.empty());
      RC_ASSERT(hasSameSlots(meshOf(*back).mesh.mesh, document->mesh()));
      RC_ASSERT(meshOf(*back).keptOpen == static_cast<const MeshSnapshot&>(*document->snapshot()).keptOpen);
      RC_ASSERT(meshOf(*back).numbers == NumberType::Float32);
      RC_ASSERT(meshOf(*back).fillChoice == choice);
    });
    QVERIFY(held);
  }

  void aLostBlobCostsOnlyItsFaces() {
    const auto document = test::meshDocument(grid(300));  // 180,000 faces in three blobs
    Container container;
    kKind.save(*document->snapshot(), container);
    std::string middle;
    int facesBlobs = 0;
    for (const auto& [name, bytes] : container.blobs) {
      if (name.find("faces") != std::string::npos && ++facesBlobs == 2) middle = name;
    }
    QVERIFY(facesBlobs == 3);
    container.blobs.erase(middle);
    std::vector<Error> damage;
    const auto back = kKind.load(container, damage, {});
    QVERIFY(back.hasValue());
    QCOMPARE(meshOf(*back).mesh.mesh.liveFaceCount(), std::size_t(180'000 - 65'536));
    QCOMPARE(damage.size(), std::size_t(1));
    QCOMPARE(damage[0].code, ErrorCode::DataTruncated);
    QCOMPARE(QString::fromStdString(validate(meshOf(*back).mesh.mesh)), QString());
  }

  // No more than is lost: neither the mark of a loop that was closed, nor the levels of a mesh that is no more.
  void whatAForeignFileLacksIsNoted() {
    QTemporaryDir folder;
    const auto losses = [&folder](const MeshDocument& document) {
      const auto written = kKind.exportTo(*document.snapshot(), folder.filePath("part.stl").toStdString(), {});
      std::vector<Note> all = written.hasValue() ? written->notes : std::vector<Note>(9, {"", {}, true});
      std::erase_if(all, [](const Note& note) { return !note.isLoss; });
      return all;
    };
    const auto document = test::meshDocument(grid(4));
    const HalfEdgeMesh whole = document->mesh();
    HalfEdgeMesh open = whole;
    open.removeFace(11);  // the face touches no edge of the grid
    relink(open);
    document->commit("Remove", inspected(open));
    QCOMPARE(losses(*document).size(), std::size_t(0));
    for (const BoundaryLoop& loop : document->defects().loops) document->setKeptOpen(loop, loop.halfEdges.size() == 3);
    QCOMPARE(losses(*document).size(), std::size_t(1));
    QCOMPARE(losses(*document)[0].arguments, std::vector<std::string>{"1"});
    document->commit("Fill", inspected(whole));
    QCOMPARE(losses(*document).size(), std::size_t(0));

    PatchLevels levels(buildMesh(test::icosphere(1)).mesh, FaceSelection::where(40, [](Face) { return true; }));
    levels.refine();
    document->commit("Subdivide", inspected(levels.mesh()));
    QCOMPARE(losses(*document).size(), std::size_t(0));
    document->keepLevels(levels);
    QCOMPARE(losses(*document).size(), std::size_t(1));
    document->commit("Go on", inspected(whole));
    QCOMPARE(losses(*document).size(), std::size_t(0));
  }

  // A file may turn very many faces: they are no part of the manifest, whose size is bounded.
  void turnedFacesComeBack() {
    TriangleSoup soup = grid(4);
    for (std::size_t f = 0; f < 8; ++f) std::swap(soup.triangles[f][1], soup.triangles[f][2]);
    const auto document = test::meshDocument(soup);
    QCOMPARE(document->reversedFaces().size(), std::size_t(8));
    std::vector<Error> damage;
    const auto back = reloaded(*document, damage);
    QVERIFY(back.hasValue());
    QCOMPARE(meshOf(*back).build->reversedFaces, document->reversedFaces());
    Container container;
    kKind.save(*document->snapshot(), container);
    QVERIFY((*container.manifest)["document"]["turned_faces"] == 8);
  }

  // After undo of the reversal, the container has the orientations of the file, and no reversed faces.
  void directionsOfTheFileComeBack() {
    TriangleSoup soup = grid(4);
    for (std::size_t f = 0; f < 8; ++f) std::swap(soup.triangles[f][1], soup.triangles[f][2]);
    const auto document = test::meshDocument(soup);
    document->history()->undo();
    std::vector<Error> damage;
    const auto back = reloaded(*document, damage);
    QVERIFY(back.hasValue());
    QVERIFY(damage.empty());
    const MeshSnapshot& mesh = meshOf(*back);
    QVERIFY(mesh.build->reversedFaces.empty());
    QCOMPARE(mesh.mesh.defects->inconsistentFaces.size(), std::size_t(8));
    for (Face f = 0; f < soup.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) QVERIFY(mesh.mesh.mesh.points(f)[k] == soup.points[soup.triangles[f][k]]);
  }

  // Two halves of a sheet, torn apart by 1e-4 of the diagonal: whether that is one vertex is a matter of the setting.
  void filesAreInspectedWithTheNearWeldChosen() {
    TriangleSoup soup = grid(4);
    const std::size_t half = soup.points.size();
    for (std::size_t i = 0; i < half; ++i) soup.points.push_back(soup.points[i] + Vec3(4.0 + 1e-3, 0, 0));
    for (std::size_t i = 0; i < half; ++i) soup.points[i].z() = soup.points[half + i].z() = 0.0;
    for (std::size_t f = 0; f < 32; ++f) {
      const auto shift = static_cast<std::uint32_t>(half);
      const Triangle t = soup.triangles[f];
      soup.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    }
    const QTemporaryDir folder;
    const auto document = test::meshDocument(soup, "/scans/torn.ply", NumberType::Float64);
    auto kind = std::make_unique<MeshKind>();
    MeshKind& chosen = *kind;
    std::vector<std::unique_ptr<DocumentKind>> one;
    one.push_back(std::move(kind));
    const DocumentKinds all(std::move(one));
    for (const char* name : {"a.handwheel", "a.ply"}) {
      const auto path = folder.filePath(name).toStdString();
      QVERIFY(saveDocument(kKind, document->file(), *document->snapshot(), path).hasValue());
      for (const auto& [nearWeld, pairs] : {std::pair(1e-5, 0), std::pair(1e-3, 5)}) {
        chosen.setNearWeld(nearWeld);
        const auto opened = all.open(path, {});
        QVERIFY(opened.hasValue());
        QCOMPARE(meshOf(opened->content).mesh.defects->nearVertices.size(), std::size_t(pairs));
      }
    }
  }

  // Losses of a mesh that cannot be accepted as it is are reported.
  void aMeshThatContradictsItselfIsJoinedAnew() {
    const auto document = test::meshDocument(grid(3));
    document->setKeptOpen(document->defects().loops[0], true);
    Container container;
    kKind.save(*document->snapshot(), container);
    std::string& faces = container.blobs.at("mesh/faces/0000");
    std::swap_ranges(faces.begin() + 12, faces.begin() + 16, faces.begin() + 24 + 12);  // opposites of two faces
    std::vector<Error> damage;
    const auto back = kKind.load(container, damage, {});
    QVERIFY(back.hasValue());
    QVERIFY(hasSameSlots(meshOf(*back).mesh.mesh, document->mesh()));
    QVERIFY(meshOf(*back).keptOpen.empty());
    QCOMPARE(damage.size(), std::size_t(2));
    QCOMPARE(damage[0].arguments[0], std::string("mesh"));
    QCOMPARE(damage[1].arguments[0], std::string("kept_open"));
  }

  // A mesh without triangles that can be read is damaged, not empty: its file is the right one.
  void aMeshOfWhichNothingIsReadableIsDamaged() {
    const auto document = test::meshDocument(grid(3));
    Container container;
    kKind.save(*document->snapshot(), container);
    container.blobs.erase("mesh/faces/0000");
    const Error ofFaces{ArchiveError::EntryDamaged, {"mesh/faces/0000"}, {}, {}};
    const Error ofOther{ArchiveError::EntryDamaged, {"recordings/0/ticks"}, {}, {}};
    const auto refusal = [&](std::vector<Error> damage) { return kKind.load(container, damage, {}).error(); };
    QCOMPARE(refusal({ofOther, ofFaces}).arguments, ofFaces.arguments);
    QCOMPARE(refusal({ofOther}).code, ErrorCode::DataTruncated);
    QCOMPARE(refusal({}).arguments, (std::vector<std::string>{"triangles", "18", "0"}));
  }

  // A position that is no number differs from itself: every edit would seem to change it.
  void aVertexThatIsNoNumberIsDropped() {
    const auto document = test::meshDocument(grid(2));
    HalfEdgeMesh mesh = document->mesh();
    mesh.addVertex(Vec3(std::nan(""), 0, 0));
    MeshSnapshot odd = static_cast<const MeshSnapshot&>(*document->snapshot());
    odd.mesh.mesh = mesh;
    Container container;
    kKind.save(odd, container);
    std::vector<Error> damage;
    const auto back = kKind.load(container, damage, {});
    QVERIFY(back.hasValue());
    QVERIFY(hasSameSlots(meshOf(*back).mesh.mesh, document->mesh()));
    QCOMPARE(damage.size(), std::size_t(1));
  }

  void cancelledWorkSaysSo() {
    const auto document = test::meshDocument(grid(3));
    Container container;
    kKind.save(*document->snapshot(), container);
    JobState state;
    state.cancelled = true;
    std::vector<Error> damage;
    const auto back = kKind.load(container, damage, Progress(state));
    QVERIFY(!back.hasValue());
    QCOMPARE(back.error().code, ErrorCode::Cancelled);
    const QTemporaryDir folder;
    for (const char* name : {"a.handwheel", "a.stl", "a.3mf"}) {
      const auto path = folder.filePath(name).toStdString();
      const auto saved = saveDocument(kKind, document->file(), *document->snapshot(), path, Progress(state));
      QVERIFY(!saved.hasValue());
      QCOMPARE(saved.error().code, ErrorCode::Cancelled);
      QVERIFY(!QFile::exists(folder.filePath(name)));
      QVERIFY(saveDocument(kKind, document->file(), *document->snapshot(), path).hasValue());
      const auto opened = kinds().open(path, {}, Progress(state));
      QVERIFY(!opened.hasValue());
      QCOMPARE(opened.error().code, ErrorCode::Cancelled);
    }
  }

  // A file that contradicts itself is rebuilt from its triangles or refused, and never believed.
  void hostileNumbersAreNotBelieved() {
    const auto document = test::meshDocument(grid(4));
    Container whole;
    kKind.save(*document->snapshot(), whole);
    const bool held = rc::check([&] {
      Container hostile = whole;
      for (auto& [name, bytes] : hostile.blobs) {
        const auto hits = *rc::gen::inRange(0, 4);
        for (int i = 0; i < hits && !bytes.empty(); ++i) {
          bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = static_cast<char>(*rc::gen::inRange(0, 256));
        }
        if (*rc::gen::inRange(0, 8) == 0) bytes.resize(*rc::gen::inRange<std::size_t>(0, bytes.size() + 1));
      }
      nlohmann::json& described = (*hostile.manifest)["document"];
      switch (*rc::gen::inRange(0, 7)) {
        case 0:
          described["faces"] = 0xffffffffffffull;
          break;
        case 1:
          described["vertices"] = "many";
          break;
        case 2:
          described["kept_open"] = {-1, 1e300, "x", 4'000'000'000u};
          break;
        case 3:
          described = nullptr;
          break;
        case 4:
          described["fill"] = {{"mesh.fill_method", "best"}, {"mesh.fill_continuity", 1e300}};
          break;
        default:
          break;
      }
      std::vector<Error> damage;
      const auto back = kKind.load(hostile, damage, {});
      if (back) RC_ASSERT(validate(meshOf(*back).mesh.mesh) == std::string());
    });
    QVERIFY(held);
  }

  // Through the file system, with what this program does not know.
  void unknownKeysSurviveOpeningAndSaving() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("part.handwheel").toStdString();
    const auto document = test::meshDocument(grid(3));
    DocumentFile file = document->file();
    auto unknown = std::make_shared<Container>();
    (*unknown->manifest)["from_the_future"] = {{"answer", 42}};
    (*unknown->manifest)["document"]["colour_of_the_wind"] = "blue";
    unknown->blobs["future/data"] = "kept";
    file.unknown = unknown;
    QVERIFY(saveDocument(kKind, file, *document->snapshot(), path).hasValue());

    const DocumentKinds all = kinds();
    auto opened = all.open(path, {});
    QVERIFY(opened.hasValue());
    QCOMPARE(opened->file.id, std::string("test"));
    QVERIFY(opened->file.isContainer);
    const auto again = kKind.make(std::move(*opened));
    QVERIFY(again->setProperty("display_unit", 3.0).hasValue());
    const std::filesystem::path second = folder.filePath("again.handwheel").toStdString();
    QVERIFY(saveDocument(kKind, again->file(), *again->snapshot(), second).hasValue());
    const auto last = all.open(second, {});
    QVERIFY(last.hasValue());
    QCOMPARE(last->file.displayUnit, LengthUnit::Inch);
    QVERIFY((*last->file.unknown->manifest)["from_the_future"]["answer"] == 42);
    QVERIFY((*last->file.unknown->manifest)["document"]["colour_of_the_wind"] == "blue");
    QCOMPARE(last->file.unknown->blobs.at("future/data"), std::string("kept"));
  }
};

HANDWHEEL_TEST(MeshKindTest)
#include "MeshKindTest.moc"
