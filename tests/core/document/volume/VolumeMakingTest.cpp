// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeMaking.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "document/volume/LayerSteps.h"
#include "document/volume/VolumeKind.h"
#include "mesh/structure/MeshErrors.h"
#include "volume/VolumeShapes.h"
#include "volume/surface/VolumeToSurface.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

std::shared_ptr<VolumeSnapshot> madeBall() {
  auto ball = std::make_shared<VolumeSnapshot>();
  ball->volume = ballOfVoxels(5.0, 0.5);
  ball->surface = VolumeSurface(ball->volume);
  ball->source = "ball.stl";
  return ball;
}

}  // namespace

// Contents of documents made of surfaces and files, and what is said of them.
class VolumeMakingTest : public QObject {
  Q_OBJECT

 private slots:
  // A volume written as a file of distances is the same when it is opened, and no image is kept of it.
  void distancesComeBack_data() {
    QTest::addColumn<QString>("name");
    for (const char* const name : {"ball.nrrd", "BALL.NRRD", "ball.vdb"}) QTest::newRow(name) << QString(name);
  }
  void distancesComeBack() {
    QFETCH(QString, name);
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath(name).toStdString();
    const auto ball = madeBall();
    const Result<WrittenFile> written = m_kind.exportTo(*ball, path, {});
    QVERIFY(written.hasValue());
    QCOMPARE(written->bytes, std::filesystem::file_size(path));
    std::vector<Note> notes;
    const auto read = importVolume(path, notes, {});
    QVERIFY(read.hasValue());
    QCOMPARE((*read)->volume.material(), ball->volume.material());
    QCOMPARE((*read)->volume.voxel(), 0.5);
    // The name of an image may be that of a patient.
    QCOMPARE((*read)->source, name.endsWith(".vdb") ? name.toStdString() : std::string("NRRD"));
    QVERIFY(notes.empty() && !(*read)->scan);
  }

  // Voxels are all of a ball: work goes on from their file. A mask and records of holes are more, and a mesh is less.
  void filesOfVoxelsAreExportsOfMore() {
    const QTemporaryDir folder;
    const std::filesystem::path root = folder.path().toStdString();
    const auto isExport = [&](const VolumeSnapshot& volume, const char* name, std::size_t losses) {
      const Result<WrittenFile> written = m_kind.exportTo(volume, root / name, {});
      if (!written) qFatal("%s is not written", name);
      const auto lost =
          std::count_if(written->notes.begin(), written->notes.end(), [](const Note& note) { return note.isLoss; });
      if (static_cast<std::size_t>(lost) != losses) qFatal("%s loses %d", name, static_cast<int>(lost));
      return written->isExport;
    };
    VolumeSnapshot more = *madeBall();
    more.mask = std::make_shared<const ClayMask>(more.volume);
    more.tried = std::make_shared<const TriedHoles>();
    for (const char* const name : {"ball.nrrd", "ball.vdb"}) {
      QVERIFY2(!isExport(*madeBall(), name, 0), name);
      QVERIFY2(isExport(more, name, 2), name);
    }
    QVERIFY(isExport(*madeBall(), "ball.stl", 0));
  }

  // Volumes that cannot be written are errors, and nothing is written if cancelled.
  void whatIsNotWritten() {
    const QTemporaryDir folder;
    const std::filesystem::path root = folder.path().toStdString();
    for (const char* const name : {"ball.nrrd", "ball.vdb", "ball.stl"}) {
      const Result<WrittenFile> nowhere = m_kind.exportTo(*madeBall(), root / "nowhere" / name, {});
      QVERIFY2(!nowhere && nowhere.error().code == ErrorCode::WriteFailed, name);
      JobState job;
      job.cancelled = true;
      const Result<WrittenFile> cancelled = m_kind.exportTo(*madeBall(), root / name, Progress(job));
      QVERIFY2(!cancelled && cancelled.error().code == ErrorCode::Cancelled, name);
      QVERIFY(!std::filesystem::exists(root / name));
    }
  }

  // The default is 256 voxels along the largest extent.
  void ofASurface() {
    const TriangleSoup block = test::box({0.0, 0.0, 0.0}, {16.0, 4.0, 2.0});
    const Result<MadeVolume> usual = makeVolume(block, std::nullopt, "block.stl", {});
    QVERIFY(usual.hasValue());
    QCOMPARE(usual->volume->volume.voxel(), 16.0 / 256.0);
    QCOMPARE(usual->volume->source, std::string("block.stl"));
    const Result<MadeVolume> chosen = makeVolume(block, 0.5, "block.stl", {});
    QVERIFY(chosen && chosen->volume->volume.voxel() == 0.5);
    QVERIFY(std::abs(chosen->volume->volume.enclosed() - 128.0) < 1e-6);
    QVERIFY(makeVolume({}, 0.5, {}, {}).error().code == MeshError::NoTriangles);
    QVERIFY(!m_kind.ofSurface({}, {}, {}));
    JobState job;
    job.cancelled = true;
    QVERIFY(makeVolume(block, 0.5, {}, Progress(job)).error().code == ErrorCode::Cancelled);
  }

  // Lost walls are reported from a thousandth of the surface on, with their share in percent.
  void lostWalls() {
    SurfaceVolume made;
    made.volume = SparseVolume(Vec3::Zero(), 0.25);
    made.nearShare = 0.9995;
    QVERIFY(notesOn(made).empty());
    made.nearShare = 0.875;
    const std::vector<Note> notes = notesOn(made);
    QCOMPARE(notes.size(), std::size_t{1});
    QVERIFY(notes.front().text.find("Walls thinner than a voxel") == 0);
    QCOMPARE(notes.front().arguments.front(), std::string("0.25"));
    QVERIFY(std::abs(std::stod(notes.front().arguments.back()) - 12.5) < 0.6);  // to two digits
  }

  // A description for scripts has the volume by what its surface encloses, and each layer.
  void described() {
    const auto ball = madeBall();
    const nlohmann::json plain = m_kind.describe(*ball);
    QCOMPARE(plain["voxel"], nlohmann::json(0.5));
    QVERIFY(std::abs(plain["volume"].get<double>() / (4.0 / 3.0 * M_PI * 125.0) - 1.0) < 0.01);
    QCOMPARE(plain["source"], nlohmann::json("ball.stl"));
    QCOMPARE(plain["triangles"].get<std::size_t>(), surfaceOf(ball->volume).triangles.size());
    QCOMPARE(plain["blocks"].get<std::size_t>(), ball->volume.blocks().size());
    QVERIFY(plain["holes"] == 0 && plain["layers"].empty());
    const auto layered = withLayerShare(*withNewLayer(*ball, "ears").volume, 0, 0.25, false).volume;
    const nlohmann::json layers = m_kind.describe(*layered)["layers"];
    QCOMPARE(layers, nlohmann::json::parse(R"([{"name": "ears", "strength": 0.25, "on": false, "blocks": 0}])"));
  }

  // It is shown by the triangles of its surface.
  void shown() {
    const DisplayModel model = m_kind.display(*madeBall());
    QCOMPARE(model.parts.size(), std::size_t{1});
    const TriangleSoup& soup = *model.parts.front().soup;
    QVERIFY(!soup.triangles.empty());
    for (const Vec3& p : soup.points) QVERIFY(std::abs(p.norm() - 5.0) < 0.05);
  }

 private:
  VolumeKind m_kind;
};

HANDWHEEL_TEST(VolumeMakingTest)
#include "VolumeMakingTest.moc"
