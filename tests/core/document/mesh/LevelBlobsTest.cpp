// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "document/mesh/LevelBlobs.h"

#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>
#include <QFile>
#include <QTest>
#include <nlohmann/json.hpp>

using namespace handwheel;

class LevelBlobsTest : public QObject {
  Q_OBJECT

 private slots:
  void loadingIsTheInverseOfSaving();
  void afterEditsElsewhere();
  void whatComesBackCanBeSculpted();
  void onlyThoseOfThePresentMesh();
  void noLevelsAreNone();
  void damagedOnesAreDroppedAndSaid();
  void anOlderProgramDropsThem();
  void hostileNumbers();
  void whateverIsChangedIsRefusedOrALevel();
  void cancelledWorkSaysSo();
  void theFixtureIsRead();
};

namespace {

const MeshKind kLevelKind;

// Moves the vertices of a level by up to so much, but those outside its patch.
void shake(PatchLevels& levels, std::size_t level, double most) {
  HalfEdgeMesh mesh = levels.mesh(level);
  std::vector<bool> isHeld(mesh.vertexSlots(), false);
  for (Face f = 0; f < mesh.faceSlots(); ++f)
    for (std::size_t k = 0; k < 3 && mesh.isLive(f) && !levels.patch(level).contains(f); ++k)
      isHeld[mesh.triangle(f)[k]] = true;
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v)
    if (!isHeld[v]) mesh.setPosition(v, mesh.position(v) * (1.0 + most * std::sin(17.0 * v)));
  levels.replace(level, std::move(mesh));
}

PatchLevels levelsOf(std::uint32_t part, int count, int moves) {
  const HalfEdgeMesh sphere = buildMesh(test::bumpySphere(2)).mesh;
  const FaceSelection patch =
      FaceSelection::where(sphere.faceSlots(), [&](Face f) { return f * 7919u % 100u < part || f < 12; });
  PatchLevels levels(sphere, patch);
  for (int i = 0; i < count; ++i) levels.refine();
  for (int i = 0; i < moves; ++i) shake(levels, *rc::gen::inRange<std::size_t>(0, levels.finest() + 1), 0.01);
  return levels;
}

// Adds a face by itself, with vertices of its own.
HalfEdgeMesh withFaceAdded(HalfEdgeMesh mesh) {
  const auto v = static_cast<Vertex>(mesh.vertexSlots());
  for (const Vec3& p : {Vec3(5, 0, 0), Vec3(6, 0, 0), Vec3(5, 1, 0)}) mesh.addVertex(p);
  mesh.addFace({v, v + 1, v + 2});
  return mesh;
}

PatchLevels someLevels(int count = 2) {
  const HalfEdgeMesh sphere = buildMesh(test::icosphere(1)).mesh;
  PatchLevels levels(sphere, FaceSelection::where(40, [](Face) { return true; }));
  for (int i = 0; i < count; ++i) levels.refine();
  shake(levels, 0, 0.02);
  return levels;
}

std::unique_ptr<MeshDocument> documentWith(const PatchLevels& levels) {
  auto document = test::meshDocument(test::icosphere(0));
  document->commit("Levels", inspected(levels.mesh()));
  document->keepLevels(levels);
  return document;
}

Container saved(const PatchLevels& levels) {
  Container container;
  kLevelKind.save(*documentWith(levels)->snapshot(), container);
  return container;
}

struct Loaded {
  std::shared_ptr<const MeshSnapshot> content;
  std::vector<Error> damage;
};
Loaded loaded(const Container& container) {
  Loaded result;
  const auto content = kLevelKind.load(container, result.damage, {});
  if (content) result.content = std::static_pointer_cast<const MeshSnapshot>(*content);
  return result;
}

// Returns true if the contents of the levels are equal. The positions of dead vertices are not saved.
bool same(const PatchLevels& a, const PatchLevels& b) {
  if (a.finest() != b.finest()) return false;
  for (std::size_t i = 0; i <= a.finest(); ++i) {
    const HalfEdgeMesh &m = a.mesh(i), &n = b.mesh(i);
    if (m.faceSlots() != n.faceSlots() || m.vertexSlots() != n.vertexSlots() || a.patch(i) != b.patch(i)) return false;
    for (Face f = 0; f < m.faceSlots(); ++f) {
      if (m.triangle(f) != n.triangle(f)) return false;
      for (HalfEdge h = 3 * f; h < 3 * f + 3 && m.isLive(f); ++h)
        if (m.opposite(h) != n.opposite(h) || !test::sameBits(m.position(m.from(h)), n.position(n.from(h))))
          return false;
    }
  }
  return true;
}

bool isSaid(const Loaded& loaded) {
  return loaded.damage.size() == 1 && loaded.damage[0].code == ErrorCode::ElementMalformed &&
         loaded.damage[0].arguments[0] == "levels";
}

}  // namespace

void LevelBlobsTest::loadingIsTheInverseOfSaving() {
  const bool held = rc::check([] {
    const PatchLevels levels = levelsOf(*rc::gen::inRange(0u, 101u), *rc::gen::inRange(1, 4), *rc::gen::inRange(0, 4));
    const Loaded back = loaded(saved(levels));
    RC_ASSERT(back.content && back.damage.empty());
    RC_ASSERT(back.content->levels && same(*back.content->levels, levels));
  });
  QVERIFY(held);
}

// Levels of which some were made before faces were added elsewhere, and some after.
void LevelBlobsTest::afterEditsElsewhere() {
  const bool held = rc::check([] {
    PatchLevels levels = levelsOf(*rc::gen::inRange(0u, 101u), *rc::gen::inRange(1, 3), 1);
    for (int i = *rc::gen::inRange(1, 5); i > 0; --i) {
      if (*rc::gen::arbitrary<bool>()) {
        RC_ASSERT(levels.follow(withFaceAdded(levels.mesh())));
      } else if (levels.finest() < 3) {
        levels.refine();
      }
      if (*rc::gen::arbitrary<bool>()) shake(levels, *rc::gen::inRange<std::size_t>(0, levels.finest() + 1), 0.01);
    }
    const Loaded back = loaded(saved(levels));
    RC_ASSERT(back.content && back.damage.empty() && back.content->levels);
    PatchLevels read = *back.content->levels;
    RC_ASSERT(same(read, levels));
    shake(levels, 0, 0.01);
    shake(read, 0, 0.01);
    RC_ASSERT(same(read, levels));
    for (Face f = 0; f < levels.mesh().faceSlots(); ++f) RC_ASSERT(levels.faceAt(0, f) == read.faceAt(0, f));
  });
  QVERIFY(held);
}

// The stencils are made anew: a coarse level that is moved takes the finer ones along as it did.
void LevelBlobsTest::whatComesBackCanBeSculpted() {
  const bool held = rc::check([] {
    PatchLevels levels = levelsOf(60, 2, 2);
    PatchLevels back = *loaded(saved(levels)).content->levels;
    const std::size_t level = *rc::gen::inRange<std::size_t>(0, 3);
    shake(levels, level, 0.03);
    shake(back, level, 0.03);
    RC_ASSERT(same(levels, back));
    levels.coarsen();
    back.coarsen();
    RC_ASSERT(levels.refine() == SubdivisionFailure::None && back.refine() == SubdivisionFailure::None);
    RC_ASSERT(same(levels, back));
    const auto n = static_cast<Face>(levels.mesh().faceSlots());
    for (Face f = 0; f < n; ++f) RC_ASSERT(levels.faceAt(0, f) == back.faceAt(0, f));
  });
  QVERIFY(held);
}

void LevelBlobsTest::onlyThoseOfThePresentMesh() {
  const auto document = documentWith(someLevels());
  HalfEdgeMesh mesh = document->mesh();
  mesh.setPosition(3, mesh.position(3) * 1.01);
  document->commit("Move", inspected(mesh));
  Container without, with;
  kLevelKind.save(*document->snapshot(), without);
  QVERIFY(!loaded(without).content->levels);
  document->history()->undo();
  kLevelKind.save(*document->snapshot(), with);
  QVERIFY(loaded(with).content->levels);
  MeshSnapshot mixed = static_cast<const MeshSnapshot&>(*document->snapshot());
  mixed.mesh.mesh = mesh;
  Container neither;
  kLevelKind.save(mixed, neither);
  QVERIFY(neither.blobs == without.blobs && *neither.manifest == *without.manifest);
}

void LevelBlobsTest::noLevelsAreNone() {
  const Container container = saved(someLevels(0));
  QVERIFY((*container.manifest)["document"]["levels"] == nlohmann::json::array());
  const Loaded back = loaded(container);
  QVERIFY(back.content && !back.content->levels && back.damage.empty());
}

void LevelBlobsTest::damagedOnesAreDroppedAndSaid() {
  const PatchLevels levels = someLevels();
  const Container whole = saved(levels);
  int tried = 0;
  for (const auto& [name, bytes] : whole.blobs) {
    if (!name.starts_with("mesh/levels/")) continue;
    Container container = whole;
    container.blobs.erase(name);
    const Loaded back = loaded(container);
    QVERIFY(back.content && !back.content->levels && isSaid(back));
    QVERIFY(test::sameMesh(back.content->mesh.mesh, levels.mesh()));
    ++tried;
  }
  QCOMPARE(tried, 4);
  Container renumbered = whole;  // a mesh built anew has other numbers
  std::string& faces = renumbered.blobs.at("mesh/faces/0000");
  std::swap_ranges(faces.begin() + 12, faces.begin() + 16, faces.begin() + 24 + 12);
  const Loaded back = loaded(renumbered);
  QVERIFY(back.content && !back.content->levels);
  QCOMPARE(back.damage.size(), std::size_t(2));
  QCOMPARE(back.damage[1].arguments[0], std::string("levels"));
}

// It keeps the key, which it does not know, and replaces the blobs below "mesh/". Nothing was lost that it had changed.
void LevelBlobsTest::anOlderProgramDropsThem() {
  Container container = saved(someLevels());
  std::erase_if(container.blobs, [](const auto& blob) { return blob.first.starts_with("mesh/levels/"); });
  const Loaded back = loaded(container);
  QVERIFY(back.content && !back.content->levels && back.damage.empty());
}

void LevelBlobsTest::hostileNumbers() {
  const Container whole = saved(someLevels());
  const nlohmann::json odd[] = {
      nullptr, -1, 0.5, "1", 0, 1, 4'294'967'295u, ~std::uint64_t{0}, nlohmann::json::array()};
  PatchLevels edited = someLevels();
  QVERIFY(edited.follow(withFaceAdded(edited.mesh())));
  for (const Container& sound : {whole, saved(edited)}) {
    for (const char* key : {"vertices", "faces", "patch", "points", "next_vertex", "next_face"}) {
      for (const nlohmann::json& value : odd) {
        Container container = sound;
        (*container.manifest)["document"]["levels"][0][key] = value;
        const Loaded back = loaded(container);
        QVERIFY(back.content && !back.content->levels && isSaid(back));
      }
    }
  }
  for (const nlohmann::json& value : odd) {
    Container container = whole;
    (*container.manifest)["document"]["levels"] = value;
    QVERIFY(loaded(container).content && !loaded(container).content->levels);
    (*container.manifest)["document"]["levels"] = nlohmann::json::array({value});
    QVERIFY(loaded(container).content && !loaded(container).content->levels);
  }
  Container many = whole;  // the same level a thousand times
  for (int i = 0; i < 1000; ++i) (*many.manifest)["document"]["levels"].push_back({{"patch", 40}});
  QVERIFY(loaded(many).content && isSaid(loaded(many)));
}

void LevelBlobsTest::whateverIsChangedIsRefusedOrALevel() {
  PatchLevels levels = someLevels();
  QVERIFY(levels.follow(withFaceAdded(levels.mesh())));
  QVERIFY(levels.refine() == SubdivisionFailure::None);  // one of its levels has dead slots, one has none
  const Container whole = saved(levels);
  std::vector<std::string> names;
  for (const auto& [name, bytes] : whole.blobs)
    if (name.starts_with("mesh/levels/")) names.push_back(name);
  const bool held = rc::check([&] {
    Container container = whole;
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
      std::string& bytes = container.blobs.at(*rc::gen::elementOf(names));
      const std::size_t at = *rc::gen::inRange<std::size_t>(0, bytes.size());
      bytes[at] = static_cast<char>(*rc::gen::oneOf(rc::gen::inRange(0, 256), rc::gen::just((bytes[at] + 1) % 256)));
    }
    const Loaded back = loaded(container);
    RC_ASSERT(back.content && test::sameMesh(back.content->mesh.mesh, levels.mesh()));
    if (!back.content->levels) return RC_ASSERT(isSaid(back));
    for (std::size_t i = 0; i <= levels.finest(); ++i) {
      RC_ASSERT(validate(back.content->levels->mesh(i)) == std::string());
      RC_ASSERT(back.content->levels->patch(i) == levels.patch(i));
    }
  });
  QVERIFY(held);
}

void LevelBlobsTest::cancelledWorkSaysSo() {
  const Container container = saved(someLevels());
  std::vector<Error> damage;
  const HalfEdgeMesh mesh = someLevels().mesh();
  JobState state;
  state.cancelled = true;
  QVERIFY(!readLevelBlobs((*container.manifest)["document"], container, &mesh, damage, Progress(state)));
  QVERIFY(damage.empty());
}

// Written once, when levels were new. An octahedron, subdivided twice; vertex 0 of the first level was moved to x = 2.
void LevelBlobsTest::theFixtureIsRead() {
  QFile file(test::sourcePath("tests/core/document/fixtures/levels-1.handwheel"));
  QVERIFY(file.open(QIODevice::ReadOnly));
  const auto read = readContainer(file.readAll().toStdString());
  QVERIFY(read && read->damage.empty());
  const Loaded back = loaded(read->container);
  QVERIFY(back.content && back.damage.empty() && back.content->levels);
  const PatchLevels& levels = *back.content->levels;
  QCOMPARE(levels.finest(), std::size_t{2});
  for (std::size_t i = 0; i <= 2; ++i) {  // Euler: V - F / 2 = 2
    QCOMPARE(levels.patch(i).count(), std::size_t{8} << (2 * i));
    QCOMPARE(levels.mesh(i).vertexSlots(), (std::size_t{4} << (2 * i)) + 2);
  }
  QVERIFY(levels.mesh(0).position(0) == Vec3(2, 0, 0));
  for (Vertex v = 1; v < 6; ++v) QCOMPARE(levels.mesh(0).position(v).norm(), 1.0);
}

HANDWHEEL_TEST(LevelBlobsTest)
#include "LevelBlobsTest.moc"
