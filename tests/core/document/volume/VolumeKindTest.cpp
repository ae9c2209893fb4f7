// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeKind.h"

#include "../../volume/image/MadeImages.h"
#include "ClosedSurface.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "document/AtomicFile.h"
#include "document/formats/MeshFormat.h"
#include "document/volume/SegmentEdit.h"
#include "document/volume/VolumeBlobs.h"
#include "document/volume/VolumeDocument.h"
#include "mesh/structure/Weld.h"
#include "volume/SurfaceToVolume.h"
#include "volume/clay/ClayDab.h"
#include "volume/drilling/DrillBits.h"
#include "volume/image/NrrdWriter.h"
#include "volume/surface/VolumeToSurface.h"

#include <rapidcheck.h>

#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;
using nlohmann::json;

namespace {

std::shared_ptr<VolumeSnapshot> snapshotOf(const TriangleSoup& soup, double voxel) {
  auto snapshot = std::make_shared<VolumeSnapshot>();
  snapshot->volume = volumeOfSurface(soup, voxel)->volume;
  snapshot->surface = VolumeSurface(snapshot->volume);
  snapshot->source = "ball.stl";
  return snapshot;
}

// Returns true if both volumes have the same samples at the same positions.
bool same(const SparseVolume& a, const SparseVolume& b) {
  if (a.origin() != b.origin() || a.voxel() != b.voxel() || a.material() != b.material()) return false;
  bool isSame = true;
  std::size_t count = 0;
  a.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
    const SparseVolume::Content other = b.content(at);
    isSame = isSame && content.isFull == other.isFull && !content.block == !other.block &&
             (!content.block || content.block->depths == other.block->depths);
    ++count;
  });
  b.forEach([&](const VoxelIndex&, const SparseVolume::Content&) { --count; });
  return isSame && count == 0;
}

}  // namespace

class VolumeKindTest : public QObject {
  Q_OBJECT

 private slots:
  void savedIsLoaded() {
    QVERIFY(rc::check([this] {
      const auto part = [](int low, int high) { return *rc::gen::inRange(low, high) / 10.0; };
      const double x = part(-5000, 5000), size = part(10, 60), voxel = size / part(30, 200);
      const auto value = snapshotOf(moved(cube(size), Vec3(x, -x, 0.3)), voxel);
      Container container;
      m_kind.save(*value, container);
      std::vector<Error> damage;
      const auto loaded = m_kind.load(container, damage, {});
      RC_ASSERT(loaded.hasValue() && damage.empty());
      const auto& read = static_cast<const VolumeSnapshot&>(**loaded);
      RC_ASSERT(same(read.volume, value->volume));
      RC_ASSERT(read.source == value->source);
      RC_ASSERT(read.surface.triangleCount() == value->surface.triangleCount());
    }));
  }

  // The surface of what is opened and made is divided as it was chosen last; the triangles are the same.
  void piecesAsChosen() {
    const auto value = snapshotOf(moved(cube(4.0), Vec3::Zero()), 0.05);
    VolumeKind kind;
    Container container;
    kind.save(*value, container);
    for (const int cells : {32, 128, 32}) {
      kind.setPieceCells(cells);
      std::vector<Error> damage;
      const auto loaded = kind.load(container, damage, {});
      QVERIFY(loaded.hasValue());
      const VolumeSurface& surface = static_cast<const VolumeSnapshot&>(**loaded).surface;
      QCOMPARE(surface.pieceCells(), cells);
      QCOMPARE(surface.triangleCount(), value->surface.triangleCount());
      const SnapshotPointer blank = kind.blank();
      QCOMPARE(static_cast<const VolumeSnapshot&>(*blank).surface.pieceCells(), cells);
      QCOMPARE(kind.blank(), blank);
      const auto made = kind.ofSurface(cube(4.0), {}, {});
      QVERIFY(made.hasValue());
      QCOMPARE(static_cast<const VolumeSnapshot&>(**made).surface.pieceCells(), cells);
    }
  }

  // A mask is restored, inverted or not; a lost chunk of it counts as not painted, and is reported.
  void mask() {
    for (const bool isInverted : {false, true}) {
      const auto value = snapshotOf(moved(cube(4.0), Vec3::Zero()), 0.25);
      ClayMask mask(value->volume);
      ClayDab dab;
      dab.action = ClayAction::Mask;
      dab.centre = Vec3(2.0, 2.0, 4.0);
      dab.radius = 3.0;
      mask.paint(dab);
      if (isInverted) mask.invert();
      value->mask = std::make_shared<const ClayMask>(mask);
      Container container;
      m_kind.save(*value, container);
      std::vector<Error> damage;
      const auto read = m_kind.load(container, damage, {});
      QVERIFY(read.hasValue() && damage.empty());
      const std::shared_ptr<const ClayMask> loaded = static_cast<const VolumeSnapshot&>(**read).mask;
      QVERIFY(loaded && loaded->fits(static_cast<const VolumeSnapshot&>(**read).volume));
      QVERIFY(same(loaded->values(), mask.values()));
      QCOMPARE(loaded->isInverted(), isInverted);
      container.blobs.erase("mask/0000");
      const auto lost = m_kind.load(container, damage, {});
      QVERIFY(lost.hasValue());
      QCOMPARE(damage.size(), std::size_t{1});
      QCOMPARE(static_cast<const VolumeSnapshot&>(**lost).mask != nullptr, isInverted);
      json& stored = (*container.manifest)["document"]["mask"];
      json negative = stored, elsewhere = stored;
      negative["chunks"] = -1;
      for (const json& nonsense : {json(7), json::object(), negative}) {
        stored = nonsense;
        damage.clear();
        QVERIFY(m_kind.load(container, damage, {}).hasValue());
        QVERIFY(!damage.empty());
      }
      elsewhere["origin"][0] = elsewhere["origin"][0].get<double>() + 0.25;
      stored = elsewhere;
      damage.clear();
      const auto other = m_kind.load(container, damage, {});
      QVERIFY(other.hasValue() && damage.empty());
      QVERIFY(!static_cast<const VolumeSnapshot&>(**other).mask);
    }
    // Nothing is written where nothing is protected.
    Container container;
    m_kind.save(*snapshotOf(moved(cube(4.0), Vec3::Zero()), 0.25), container);
    QVERIFY(!(*container.manifest)["document"].contains("mask"));
  }

  // The records of holes are restored to the last bit; without one of their arrays there are no holes, and that is
  // reported.
  void drilledHoles() {
    const auto value = snapshotOf(moved(cube(4.0), Vec3::Zero()), 0.5);
    for (const char* const tool : {"twist:2", "burr:1.5", "saw:3:0.7"}) {
      auto hole = std::make_shared<DrillRecord>();
      hole->setup.tool = *drillBitOf(tool);
      hole->setup.material = *drillMaterial("beech");
      hole->setup.spindle = 77.5;
      if (tool[0] == 'b') hole->setup.erosion = 2.5;
      for (int i = 0; i < 5000; ++i)
        hole->poses.push_back(DrillPose::of(Vec3(0.1, -0.2, 0.003 * i), Vec3(0.1, 0.0, 1.0), 0.001 * i));
      value->holes.push_back(hole);
    }
    Container container;
    m_kind.save(*value, container);
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded.hasValue() && damage.empty());
    const DrilledHoles& holes = static_cast<const VolumeSnapshot&>(**loaded).holes;
    QCOMPARE(holes.size(), std::size_t{3});
    for (std::size_t k = 0; k < 3; ++k) {
      const DrillSetup &read = holes[k]->setup, &written = value->holes[k]->setup;
      QVERIFY(read.tool.shape == written.tool.shape && read.tool.length == written.tool.length);
      QCOMPARE(read.tool.width, written.tool.width);
      QVERIFY(read.material.id == "beech" && read.material.energy == written.material.energy);
      QVERIFY(read.spindle == written.spindle && read.erosion == written.erosion);
      QCOMPARE(holes[k]->poses.size(), std::size_t{5000});
      for (std::size_t i = 0; i < 5000; ++i) QVERIFY(holes[k]->poses[i] == value->holes[k]->poses[i]);
    }
    container.blobs.erase("volume/holes/places/0000");
    const auto damaged = m_kind.load(container, damage, {});
    QVERIFY(damaged.hasValue() && !damage.empty());
    QVERIFY(static_cast<const VolumeSnapshot&>(**damaged).holes.empty());
  }

  // Tries are restored; an impossible one, such as one before the last, ends the list and is reported.
  void triedHoles() {
    const auto value = snapshotOf(moved(cube(4.0), Vec3::Zero()), 0.5);
    const TriedHoles tried = {{~std::uint64_t{0}, 0.25, 1}, {7, 0.0, 1}, {8, 1e-3, 3}};
    value->tried = std::make_shared<const TriedHoles>(tried);
    Container container;
    m_kind.save(*value, container);
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded.hasValue() && damage.empty());
    QVERIFY(*static_cast<const VolumeSnapshot&>(**loaded).tried == tried);
    const auto hostile = [&](const nlohmann::json& list) {
      (*container.manifest)["document"]["tried"] = list;
      damage.clear();
      const auto read = m_kind.load(container, damage, {});
      if (!read || damage.empty()) return std::size_t{999};
      const auto& known = static_cast<const VolumeSnapshot&>(**read).tried;
      return known ? known->size() : 0;
    };
    const auto row = [](const nlohmann::json& mark, const nlohmann::json& forbidden, const nlohmann::json& number) {
      return nlohmann::json::array({mark, forbidden, number});
    };
    QCOMPARE(hostile(nlohmann::json::array({row(1u, 0.5, 2u), row(2u, 0.0, 1u)})), std::size_t{1});
    QCOMPARE(hostile(nlohmann::json::array({row(1u, -0.5, 1u)})), std::size_t{0});
    QCOMPARE(hostile(nlohmann::json::array({row(1u, 0.5, 0u)})), std::size_t{0});
    QCOMPARE(hostile(nlohmann::json::array({row("a", 0.5, 1u)})), std::size_t{0});
    QCOMPARE(hostile(nlohmann::json::array({3})), std::size_t{0});
    QCOMPARE(hostile("all"), std::size_t{0});
  }

  // A chunk that is lost is missing, is said, and the rest is closed off: also where the loss is beside what is full.
  void aLostChunk() {
    const auto value = snapshotOf(moved(icosphere(3), Vec3::Zero(), 10.0), 0.06);
    Container container;
    m_kind.save(*value, container);
    const std::size_t chunks = container.blobs.size();
    QVERIFY(chunks > 4);
    const auto blob = std::next(container.blobs.begin(), static_cast<std::ptrdiff_t>(chunks / 2));
    container.blobs.erase(blob);
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded.hasValue());
    QCOMPARE(damage.size(), std::size_t{1});
    const auto& read = static_cast<const VolumeSnapshot&>(**loaded);
    QVERIFY(read.volume.material() < value->volume.material());
    QVERIFY(read.volume.material() > 0.5 * value->volume.material());
    QVERIFY(isClosedManifold(surfaceOf(read.volume)));
  }

  void hostile_data() {
    QTest::addColumn<QByteArray>("document");
    QTest::addColumn<bool>("isRead");
    QTest::newRow("nothing") << QByteArray("{}") << false;
    QTest::newRow("no object") << QByteArray("7") << false;
    QTest::newRow("voxel of 0") << QByteArray(R"({"voxel": 0, "origin": [0, 0, 0], "chunks": 0})") << false;
    QTest::newRow("voxel of text") << QByteArray(R"({"voxel": "1", "origin": [0, 0, 0], "chunks": 0})") << false;
    QTest::newRow("far away") << QByteArray(R"({"voxel": 1, "origin": [0, 1e300, 0], "chunks": 0})") << false;
    QTest::newRow("two coordinates") << QByteArray(R"({"voxel": 1, "origin": [0, 0], "chunks": 0})") << false;
    QTest::newRow("negative count") << QByteArray(R"({"voxel": 1, "origin": [0, 0, 0], "chunks": -1})") << true;
    QTest::newRow("huge count") << QByteArray(R"({"voxel": 1, "origin": [0, 0, 0], "chunks": 1e18})") << true;
    QTest::newRow("no source") << QByteArray(R"({"voxel": 1, "origin": [0, 0, 0], "chunks": 0, "source": 3})") << true;
  }
  void hostile() {
    QFETCH(QByteArray, document);
    QFETCH(bool, isRead);
    Container container;
    (*container.manifest)["document"] = json::parse(document.toStdString());
    std::vector<Error> damage;
    QCOMPARE(m_kind.load(container, damage, {}).hasValue(), isRead);
  }

  // Random bytes as a chunk result in a volume or in damage, and in a closed surface.
  void anyChunk() {
    const auto value = snapshotOf(cube(5.0), 1.0);
    Container container;
    m_kind.save(*value, container);
    QVERIFY(rc::check([&] {
      Container damaged = container;
      std::string& bytes = damaged.blobs.begin()->second;
      const int changes = *rc::gen::inRange(1, 20);
      for (int i = 0; i < changes; ++i) {
        const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(bytes.size())));
        bytes[at] = static_cast<char>(*rc::gen::inRange(-128, 128));
      }
      if (*rc::gen::arbitrary<bool>())
        bytes.resize(static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(bytes.size()))));
      std::vector<Error> damage;
      const auto loaded = m_kind.load(damaged, damage, {});
      if (!loaded) return;  // full and empty blocks with nothing between them
      RC_ASSERT(isClosedManifold(surfaceOf(static_cast<const VolumeSnapshot&>(**loaded).volume)));
    }));
  }

  // A few bytes that say that a thousand regions are full fill no memory.
  void fullRegionsAlone() {
    std::vector<std::int16_t> numbers;
    for (std::int16_t i = 0; i < 1000; ++i) {
      numbers.insert(numbers.end(), {static_cast<std::int16_t>(2 * i), 0, 0, 0, 0, 0});
      numbers.insert(numbers.end(), 32, std::int16_t{-1});
      numbers.insert(numbers.end(), 32, std::int16_t{0});
    }
    Container container;
    (*container.manifest)["document"] = {{"voxel", 1.0}, {"origin", {0, 0, 0}}, {"chunks", 1}};
    container.blobs["volume/chunks/0000"] = toBlob(numbers);
    std::vector<Error> damage;
    QVERIFY(!m_kind.load(container, damage, {}).hasValue());
  }

  // Blocks at either end of what a volume can hold are read as they were written, and their surface is closed.
  void farthestBlocks() {
    constexpr int kEnd = SparseVolume::kMostVoxels / 8;
    auto value = std::make_shared<VolumeSnapshot>();
    value->volume = SparseVolume(Vec3::Zero(), 1.0);
    for (const int at : {-kEnd + 1, kEnd - 2}) {
      auto block = std::make_shared<VolumeBlock>();
      block->depths.fill(VolumeBlock::kEmpty);
      block->depths[VolumeBlock::at(4, 4, 4)] = VolumeBlock::kFull;
      value->volume.setContent(VoxelIndex(at, at, at), {block, false});
    }
    Container container;
    m_kind.save(*value, container);
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded.hasValue() && damage.empty());
    const SparseVolume& volume = static_cast<const VolumeSnapshot&>(**loaded).volume;
    QVERIFY(same(volume, value->volume));
    const TriangleSoup surface = surfaceOf(volume);
    QCOMPARE(surface.triangles.size(), std::size_t{16});
    QVERIFY(isClosedManifold(surface));
  }

  void exportedIsTheSurface() {
    QTemporaryDir folder;
    const auto value = snapshotOf(moved(icosphere(3), Vec3::Zero(), 10.0), 0.5);
    const std::filesystem::path path = folder.filePath("ball.stl").toStdString();
    QVERIFY(m_kind.exportTo(*value, path, {}).hasValue());
    const auto read = readMeshFile(path, {});
    QVERIFY(read.hasValue());
    QCOMPARE(read->soup.triangles.size(), value->surface.triangleCount());
    QVERIFY(isClosedManifold(weld(read->soup)));
    QVERIFY(!m_kind.exportTo(*value, folder.filePath("ball.txt").toStdString(), {}).hasValue());
  }

  // A file of the surface says that another label was chosen after it was made, also in another session.
  void olderThanTheSegment() {
    QTemporaryDir folder;
    const ImageGrid grid{{12, 12, 12}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    const auto image = test::imageOf<std::int16_t>(grid, [](const Vec3& p) {
      const bool isIn = p.minCoeff() > 2 && p.maxCoeff() < 9;
      return !isIn ? 0.0 : p.x() < 6 ? 1.0 : 2.0;
    });
    const std::filesystem::path path = folder.filePath("labels.nrrd").toStdString();
    QVERIFY(writeFileAtomically(path, nrrdOf(image, {})).hasValue());
    auto opened = m_kind.import(path, {}, {});
    QVERIFY(opened.hasValue());
    VolumeDocument document(std::move(*opened));
    const auto isWarned = [&](const SnapshotPointer& content, const char* name) {
      const auto written = m_kind.exportTo(*content, folder.filePath(name).toStdString(), {});
      return written.hasValue() && std::any_of(written->notes.begin(), written->notes.end(), [](const Note& note) {
               return note.isLoss && note.text.find("earlier segment") != std::string::npos;
             });
    };
    for (const char* const name : {"a.stl", "a.vdb", "a.nrrd"}) {
      QVERIFY(!isWarned(document.snapshot(), name));
      document.commit({}, std::make_unique<SegmentEdit>(Segment({2.0, 2.0}), document.segment()));
      QVERIFY(isWarned(document.snapshot(), name));
      Container container;
      m_kind.save(*document.snapshot(), container);
      std::vector<Error> damage;
      auto loaded = m_kind.load(container, damage, {});
      QVERIFY(loaded.hasValue() && damage.empty());
      QVERIFY(isWarned(*loaded, name));
      document.history()->undo();
      m_kind.save(*document.snapshot(), container);
      loaded = m_kind.load(container, damage, {});
      QVERIFY(loaded.hasValue() && damage.empty());
      QVERIFY(!isWarned(*loaded, name));
    }
  }

  void documentAndItsProperties() {
    OpenedFile opened;
    opened.kind = &m_kind;
    opened.content = snapshotOf(cube(5.0), 0.5);
    const VolumeDocument document(std::move(opened));
    QCOMPARE(std::get<double>(document.property("voxel")->value), 0.5);
    QVERIFY(std::abs(std::get<double>(document.property("material")->value) - 125.0) < 10.0);
    QCOMPARE(std::get<std::string>(document.property("source")->value), std::string("ball.stl"));
  }

 private:
  VolumeKind m_kind;
};

HANDWHEEL_TEST(VolumeKindTest)
#include "VolumeKindTest.moc"
