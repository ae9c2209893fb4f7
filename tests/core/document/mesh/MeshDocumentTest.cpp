// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/MeshDocument.h"

#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "document/UndoCommand.h"
#include "mesh/measure/MeshFidelity.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>
#include <QSignalSpy>
#include <QTest>
#include <memory>

using namespace handwheel;

namespace {

// A flat sheet of n × n squares with corners on whole numbers, two triangles each.
TriangleSoup sheet(std::uint32_t n) {
  TriangleSoup soup;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) soup.points.emplace_back(x, y, 0.0);
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      const std::uint32_t b = a + n + 1;
      soup.triangles.push_back({a, a + 1, b + 1});
      soup.triangles.push_back({a, b + 1, b});
    }
  }
  return soup;
}

std::unique_ptr<MeshDocument> documentOf(const TriangleSoup& soup) {
  return test::meshDocument(soup);
}

// Every slot that there is, dead ones included.
bool sameSlots(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  if (a.vertexSlots() != b.vertexSlots() || a.faceSlots() != b.faceSlots()) return false;
  for (Vertex v = 0; v < a.vertexSlots(); ++v) {
    if (a.position(v) != b.position(v)) return false;
  }
  for (Face f = 0; f < a.faceSlots(); ++f) {
    if (a.triangle(f) != b.triangle(f)) return false;
  }
  for (HalfEdge h = 0; h < a.halfEdgeSlots(); ++h) {
    if (a.opposite(h) != b.opposite(h)) return false;
  }
  return true;
}

Face liveFace(const HalfEdgeMesh& mesh) {
  const auto live = mesh.compact().faceOf;
  return live.empty() ? kNone : live[*rc::gen::inRange<std::size_t>(0, live.size())];
}

Vertex anyVertex(const HalfEdgeMesh& mesh) {
  return static_cast<Vertex>(*rc::gen::inRange<std::size_t>(0, mesh.vertexSlots()));
}

Vec3 anyPoint() {
  const auto coordinate = [] { return *rc::gen::inRange(-40, 40) / 4.0; };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

// A few low-level changes, then everything paired anew, as an operation leaves a mesh.
HalfEdgeMesh randomlyChanged(HalfEdgeMesh mesh) {
  const int changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < changes; ++i) {
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        if (const Face f = liveFace(mesh); f != kNone) mesh.removeFace(f);
        break;
      case 1:
        mesh.setPosition(anyVertex(mesh), anyPoint());
        break;
      case 2:
        mesh.addFace({anyVertex(mesh), anyVertex(mesh), anyVertex(mesh)});
        break;
      default:
        mesh.addFace({mesh.addVertex(anyPoint()), mesh.addVertex(anyPoint()), anyVertex(mesh)});
    }
  }
  relink(mesh);
  return mesh;
}

FidelityValues withGranularity(double runSlots) {
  FidelityValues values;
  if (!values.set(undoGranularitySetting(), runSlots)) qFatal("the value is out of range");
  return values;
}

// Bytes of the step that moves one vertex, kept in runs of so many.
std::size_t bytesOfAStep(double runSlots) {
  const auto document = documentOf(sheet(40));
  document->setFidelity(withGranularity(runSlots));
  HalfEdgeMesh mesh = document->mesh();
  mesh.setPosition(0, Vec3(0, 0, 1));
  document->commit("Move", inspected(mesh));
  return static_cast<const UndoCommand*>(document->history()->command(0))->edit().bytes();
}

HalfEdgeMesh without(HalfEdgeMesh mesh, Face face) {
  mesh.removeFace(face);
  relink(mesh);
  return mesh;
}

}  // namespace

class MeshDocumentTest : public QObject {
  Q_OBJECT

 private slots:
  // Any walk through history ends where it says, slot for slot; however coarse the steps were kept, and whatever the
  // setting is when they are undone.
  void historyIsExact() {
    const bool holds = rc::check("undo and redo restore every slot", [] {
      TriangleSoup soup = sheet(4);
      for (Triangle& t : soup.triangles)
        if (*rc::gen::inRange(0, 6) == 0) std::swap(t[1], t[2]);
      const auto document = documentOf(soup);
      std::vector<HalfEdgeMesh> states{document->mesh()};
      std::size_t present = 0;
      if (document->openingSteps() == 1) {  // the history begins with the turn
        document->history()->undo();
        states.insert(states.begin(), document->mesh());
        document->history()->redo();
        present = 1;
      }
      const int steps = *rc::gen::inRange(1, 20);
      for (int i = 0; i < steps; ++i) {
        const std::uint64_t revision = document->revision();
        document->setFidelity(withGranularity(*rc::gen::element(1.0, 2.0, 3.0, 64.0, 4096.0)));
        switch (*rc::gen::inRange(0, 4)) {
          case 0:
            if (present == 0) continue;
            document->history()->undo();
            --present;
            break;
          case 1:
            if (present + 1 == states.size()) continue;
            document->history()->redo();
            ++present;
            break;
          default: {
            const HalfEdgeMesh after = randomlyChanged(document->mesh());
            if (!document->commit("Edit", inspected(after))) {
              RC_ASSERT(sameSlots(document->mesh(), after));
              continue;
            }
            states.resize(++present);
            states.push_back(after);
          }
        }
        RC_ASSERT(sameSlots(document->mesh(), states[present]));
        RC_ASSERT(document->revision() > revision);
        RC_ASSERT(document->history()->count() == static_cast<int>(states.size()) - 1);
      }
    });
    QVERIFY(holds);
  }

  // One vertex is 24 bytes; a run of 64 keeps 63 more.
  void stepsAreKeptAsChosen() {
    QCOMPARE(bytesOfAStep(64.0) - bytesOfAStep(1.0), std::size_t(63 * 24));
    QCOMPARE(documentOf(sheet(2))->fidelity(), FidelityValues());
  }

  // Whoever redraws only the faces that the signal names shows the right mesh.
  void touchedFacesAreEnough() {
    const bool holds = rc::check("faces not named look the same", [] {
      const auto document = documentOf(sheet(4));
      HalfEdgeMesh shown = document->mesh();
      std::vector<Face> touched;
      QObject::connect(document.get(), &MeshDocument::meshChanged, [&](const std::vector<Face>& t) { touched = t; });
      const auto check = [&] {
        const HalfEdgeMesh& now = document->mesh();
        for (Face f = 0; f < std::max(shown.faceSlots(), now.faceSlots()); ++f) {
          if (std::find(touched.begin(), touched.end(), f) != touched.end()) continue;
          RC_ASSERT(f < shown.faceSlots() && f < now.faceSlots());
          RC_ASSERT(shown.isLive(f) == now.isLive(f));
          if (now.isLive(f)) RC_ASSERT(shown.points(f) == now.points(f));
        }
        shown = now;
      };
      if (!document->commit("Edit", inspected(randomlyChanged(document->mesh())))) return;
      check();
      document->history()->undo();
      check();
      document->history()->redo();
      check();
    });
    QVERIFY(holds);
  }

  void changingNothingIsNoStep() {
    const auto document = documentOf(sheet(2));
    QVERIFY(document->commit("Remove face", inspected(without(document->mesh(), 0))));
    document->history()->undo();
    QVERIFY(!document->commit("Nothing", inspected(document->mesh())));
    QVERIFY(document->history()->canRedo());
    QCOMPARE(document->history()->count(), 1);
  }

  void defectsFollowTheMesh() {
    const auto document = documentOf(sheet(4));
    QCOMPARE(document->defects().loops.size(), std::size_t(1));
    // Square (1, 1) lies inside: without one of its triangles the sheet has a second loop.
    document->commit("Remove face", inspected(without(document->mesh(), 2 * (4 + 1))));
    QCOMPARE(document->defects().loops.size(), std::size_t(2));
    document->history()->undo();
    QCOMPARE(document->defects().loops.size(), std::size_t(1));
  }

  void keepingOpenIsUndoable() {
    const auto document = documentOf(sheet(2));
    QSignalSpy changed(document.get(), &MeshDocument::keptOpenChanged);
    const BoundaryLoop loop = document->defects().loops.front();
    document->setKeptOpen(loop, true);
    QVERIFY(document->isKeptOpen(loop));
    document->setKeptOpen(loop, true);
    QCOMPARE(document->history()->count(), 1);
    document->history()->undo();
    QVERIFY(!document->isKeptOpen(loop));
    document->history()->redo();
    QVERIFY(document->isKeptOpen(loop));
    document->setKeptOpen(loop, false);
    QVERIFY(!document->isKeptOpen(loop));
    QCOMPARE(changed.count(), 4);
  }

  // The mark belongs to the loop, whatever number it gets after an edit elsewhere.
  void keptOpenOutlivesEditsElsewhere() {
    const auto document = documentOf(sheet(4));
    document->setKeptOpen(document->defects().loops.front(), true);
    document->commit("Remove face", inspected(without(document->mesh(), 2 * (4 + 1))));
    QCOMPARE(document->defects().loops.size(), std::size_t{2});
    for (const BoundaryLoop& loop : document->defects().loops) {
      QCOMPARE(document->isKeptOpen(loop), loop.halfEdges.size() == 16);  // the outline, not the new hole
    }
  }

  void turnedFacesThatAreGoneAreNotListed() {
    TriangleSoup soup = sheet(2);
    std::swap(soup.triangles[5][1], soup.triangles[5][2]);
    const auto document = documentOf(soup);
    QCOMPARE(document->reversedFaces(), std::vector<Face>{5});
    document->commit("Remove face", inspected(without(document->mesh(), 5)));
    QCOMPARE(document->reversedFaces(), std::vector<Face>{});
    document->history()->undo();
    QCOMPARE(document->reversedFaces(), std::vector<Face>{5});
  }

  // The reversal is the first step of the history: after undo, every triangle is as in the file, corner for corner.
  void reversalOnOpeningIsAStep() {
    TriangleSoup soup = test::sphereWithHoles(2, 2, 0.4);
    for (std::size_t f = 0; f < soup.triangles.size(); f += 5) std::swap(soup.triangles[f][1], soup.triangles[f][2]);
    const auto document = documentOf(soup);
    const HalfEdgeMesh opened = document->mesh();
    const auto turned = document->reversedFaces();
    QVERIFY(turned.size() > 10);
    QCOMPARE(document->history()->count(), 1);
    QCOMPARE(document->history()->undoText(), QString("Triangles reversed on opening: %1").arg(turned.size()));
    QVERIFY(!document->isModified() && document->defects().inconsistentFaces.empty());
    QVERIFY(document->facesAsInFile().empty());

    document->history()->undo();
    QVERIFY(!document->isModified());  // the file has it so
    QCOMPARE(validate(document->mesh()), std::string());
    for (Face f = 0; f < document->mesh().faceSlots(); ++f)
      for (std::size_t k = 0; k < 3; ++k) QVERIFY(document->mesh().points(f)[k] == soup.points[soup.triangles[f][k]]);
    QCOMPARE(document->defects().inconsistentFaces, turned);
    QVERIFY(!document->defects().state(0).oriented);
    QVERIFY(document->reversedFaces().empty());
    QCOMPARE(document->facesAsInFile(), turned);

    document->history()->redo();
    QVERIFY(!document->isModified());
    QVERIFY(sameSlots(document->mesh(), opened));
    QCOMPARE(document->reversedFaces(), turned);
    QVERIFY(documentOf(test::sphereWithHoles(2, 2, 0.4))->history()->count() == 0);  // nothing to turn, no step
  }

  // Before and after that step it is as its file; on other branches, and once another state is saved, it is not.
  void reversalOnOpeningIsNoModification() {
    TriangleSoup soup = sheet(3);
    std::swap(soup.triangles[5][1], soup.triangles[5][2]);
    const auto document = documentOf(soup);
    QSignalSpy changed(document.get(), &MeshDocument::fileChanged);
    document->history()->undo();
    QVERIFY(changed.count() >= 1);
    QVERIFY(document->commit("Remove face", inspected(without(document->mesh(), 0))));
    QVERIFY(document->isModified());
    changed.clear();
    document->history()->undo();
    QVERIFY(!document->isModified());
    QVERIFY(changed.count() >= 1);
    document->history()->redo();
    document->markSaved("/scans/mended.stl", false);
    QVERIFY(!document->isModified());
    document->history()->undo();
    QVERIFY(document->isModified());
  }

  void savingMakesItClean() {
    const auto document = documentOf(sheet(2));
    QCOMPARE(document->name(), QString("part.stl"));
    QVERIFY(!document->isModified());
    document->commit("Remove face", inspected(without(document->mesh(), 0)));
    QVERIFY(document->isModified());
    QSignalSpy changed(document.get(), &MeshDocument::fileChanged);
    document->markSaved("/scans/mended.ply", false);
    QVERIFY(!document->isModified());
    QVERIFY(changed.count() >= 1);
    QCOMPARE(document->name(), QString("mended.ply"));
    QCOMPARE(document->fileNumbers(), NumberType::Float32);  // number type of the scan; PLY could store more
    document->history()->undo();
    QVERIFY(document->isModified());
  }

  // Until it has a file of its own.
  void aCopyIsNamedAfterItsSource() {
    static const MeshKind kind;
    MeshFile file;
    file.soup = sheet(2);
    OpenedFile opened;
    opened.kind = &kind;
    opened.content = meshSnapshotOf(file);
    MeshDocument nameless(opened);
    QCOMPARE(nameless.name(), QString("Untitled"));
    opened.file.copyOf = "/scans/part.v2.stl";
    MeshDocument copy(opened);
    QCOMPARE(copy.name(), QString("part.v2"));
    copy.markSaved("/scans/other.handwheel", true);
    QCOMPARE(copy.name(), QString("other.handwheel"));
  }

  // A cube with a hollow; a volume belongs to a closed surface only. Both follow edits and undo.
  void areaAndVolume() {
    const auto value = [](const MeshDocument& document, const std::string& id) -> std::optional<double> {
      for (const Property& each : document.properties())
        if (each.id == id) return std::get<double>(each.value);
      return {};
    };
    TriangleSoup soup = test::cube(2.0, {1000, 0, 0});
    test::append(soup, test::turnedOver(test::cube(1.0, {1000.5, 0.5, 0.5})));
    const auto document = documentOf(soup);
    QCOMPARE(value(*document, "area"), std::optional(30.0));
    QVERIFY(std::abs(value(*document, "volume").value_or(0.0) - 7.0) < 1e-12);
    document->commit("Remove face", inspected(without(document->mesh(), 0)));
    QCOMPARE(value(*document, "area"), std::optional(28.0));
    QVERIFY(!value(*document, "volume"));
    document->history()->undo();
    QCOMPARE(value(*document, "area"), std::optional(30.0));
    QVERIFY(std::abs(value(*document, "volume").value_or(0.0) - 7.0) < 1e-12);
    // A body inside another is no cavity: both volumes are added, under a name that says so.
    const auto labelOf = [](const MeshDocument& of) {
      for (const Property& each : of.properties())
        if (each.id == "volume") return std::string(each.label);
      return std::string();
    };
    QCOMPARE(labelOf(*document), std::string("Volume (mm³)"));
    TriangleSoup solid = test::cube(2.0);
    test::append(solid, test::cube(1.0, {0.5, 0.5, 0.5}));
    const auto nested = documentOf(solid);
    QVERIFY(std::abs(value(*nested, "volume").value_or(0.0) - 9.0) < 1e-12);
    QCOMPARE(labelOf(*nested), std::string("Volume of all bodies added up (mm³)"));
    QVERIFY(!value(*documentOf(sheet(2)), "volume"));
    QVERIFY(!value(*documentOf({}), "volume"));
  }

  // The history tells that it is clean when it dies; a half-destroyed document must not pass that on.
  void dyingModifiedSaysNothing() {
    auto document = documentOf(sheet(2));
    document->commit("Remove face", inspected(without(document->mesh(), 0)));
    int heard = 0;
    connect(document.get(), &MeshDocument::fileChanged, this, [&] { ++heard; });
    document.reset();
    QCOMPARE(heard, 0);
  }
};

HANDWHEEL_TEST(MeshDocumentTest)
#include "MeshDocumentTest.moc"
