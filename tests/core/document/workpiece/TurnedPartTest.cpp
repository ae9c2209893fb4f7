// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurnedParts.h"
#include "document/container/Blobs.h"
#include "document/formats/MeshFormat.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceKind.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/MeshBuilder.h"
#include "nurbs/StepWriter.h"

#include <rapidcheck.h>

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

namespace {

double anyBetween(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

TurningPass anyPass() {
  TurningPass pass;
  pass.noseRadius = anyBetween(0.1, 5.0);
  pass.side = *rc::gen::inRange(0, 3) == 0 ? TurningSide::Bore : TurningSide::Outside;
  if (*rc::gen::inRange(0, 3) == 0) {
    pass.method = TurningMethod::Poles;
    pass.resolution = anyBetween(0.5, 5.0);
    pass.isInParts = *rc::gen::inRange(0, 2) == 1;
  }
  const int count = *rc::gen::inRange(1, 20);
  for (int i = 0; i < count; ++i) {
    pass.path.emplace_back(anyBetween(-1.0, 40.0), anyBetween(-5.0, 105.0));
    pass.times.push_back(0.004 * i);
  }
  return pass;
}

}  // namespace

class TurnedPartTest : public QObject {
  Q_OBJECT

 private slots:
  void savedIsLoaded() {
    QVERIFY(rc::check("load(save(x)) == x", [this] {
      WorkpieceSnapshot workpiece;
      const int passes = *rc::gen::inRange(0, 4);
      for (int i = 0; i < passes; ++i) workpiece.part = withPass(workpiece, anyPass(), 0.5);
      Container container;
      m_kind.save(workpiece, container);
      std::vector<Error> damage;
      const auto loaded = m_kind.load(container, damage, {});
      RC_ASSERT(loaded.hasValue() && damage.empty());
      RC_ASSERT(isSame(static_cast<const WorkpieceSnapshot&>(**loaded), workpiece));
    }));
  }

  // A lost blob of samples is cut once more from the passes; without all of these the bar is uncut, and says so.
  void whatIsLostIsCutOnceMore() {
    const WorkpieceSnapshot workpiece = cutTwice();
    Container container;
    m_kind.save(workpiece, container);
    container.blobs.erase("workpiece/radii/0000");
    std::vector<Error> damage;
    auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded && !damage.empty());
    QVERIFY(isSame(static_cast<const WorkpieceSnapshot&>(**loaded), workpiece));
    container.blobs.erase("workpiece/path/0000");
    damage.clear();
    loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded && damage.size() >= 2);
    QVERIFY(!static_cast<const WorkpieceSnapshot&>(**loaded).part);
  }

  // A section that is that of another part is not believed: it is made again from the passes.
  void aForeignSectionIsMadeAgain() {
    const WorkpieceSnapshot workpiece = cutTwice();
    WorkpieceSnapshot other;
    TurningPass pass;
    pass.path = {{21.0, 23.0}, {21.0, 60.0}};
    pass.times = {0.0, 1.0};
    other.part = withPass(other, pass, 0.1);
    Container container, foreign;
    m_kind.save(workpiece, container);
    m_kind.save(other, foreign);
    container.blobs["workpiece/section/0000"] = foreign.blobs.at("workpiece/section/0000");
    (*container.manifest)["document"]["turned"]["section"] = (*foreign.manifest)["document"]["turned"]["section"];
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded && damage.empty());
    const auto& part = static_cast<const WorkpieceSnapshot&>(**loaded).part;
    QVERIFY(std::abs(part->volume() - workpiece.part->volume()) < 1e-6);
    QVERIFY(std::abs(part->volume() - other.part->volume()) > 100.0);
  }

  // Programs that took a depth whole did not say how they did: their passes are cut so again.
  void aPassThatDoesNotTellItsPartsIsCutWhole() {
    WorkpieceSnapshot workpiece;
    TurningPass pass;
    pass.noseRadius = 4.0;
    pass.method = TurningMethod::Poles;
    pass.resolution = 0.5;
    pass.path = {{27.0, 37.13}};  // 2 mm deep in the bar of 25 mm
    pass.times = {0.0};
    workpiece.part = withPass(workpiece, pass, 0.1);
    pass.isInParts = false;
    WorkpieceSnapshot older;
    older.part = withPass(older, pass, 0.1);
    QVERIFY(!(workpiece.part->profile == older.part->profile));
    Container container;
    m_kind.save(workpiece, container);
    nlohmann::json& listed = (*container.manifest)["document"]["turned"]["passes"][0];
    QCOMPARE(listed.at("parts").get<bool>(), true);
    listed.erase("parts");
    container.blobs.erase("workpiece/radii/0000");  // so that it is cut once more
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded && damage.size() == 1);
    QVERIFY(isSame(static_cast<const WorkpieceSnapshot&>(**loaded), older));
  }

  // 100,000 samples in two chunks, the second of which is lost.
  void countsWhatIsLost() {
    WorkpieceSnapshot workpiece;
    TurningPass pass;
    pass.path = {{21.0, 20.0}};
    pass.times = {0.0};
    workpiece.part = withPass(workpiece, pass, 100.0 / 99'998.5);
    QCOMPARE(workpiece.part->profile.size(), std::size_t{100'000});
    Container container;
    m_kind.save(workpiece, container);
    container.blobs.erase("workpiece/radii/0001");
    std::vector<Error> damage;
    QVERIFY(m_kind.load(container, damage, {}));
    QCOMPARE(damage.size(), std::size_t{1});
    QCOMPARE(damage[0].arguments.at(1), std::string("100000"));
    QCOMPARE(damage[0].arguments.at(2), std::to_string(kChunkElements));
    // And of two with wrong numbers, two.
    m_kind.save(workpiece, container);
    std::vector<double> radii = fromBlob<double>(container.blobs.at("workpiece/radii/0001"));
    radii[3] = radii[7] = -1.0;
    container.blobs["workpiece/radii/0001"] = toBlob(radii);
    damage.clear();
    QVERIFY(m_kind.load(container, damage, {}));
    QCOMPARE(damage[0].arguments.at(2), std::string("99998"));
  }

  // A small file that would be cut for hours, 20,000 points of a nose over 200,000 samples: the damage is reported at
  // once.
  void hostilePassesAreNotCutOnceMore() {
    WorkpieceSnapshot workpiece;
    TurningPass pass;
    pass.noseRadius = 1000.0;
    pass.path.assign(20'000, {2000.0, 50.0});  // beside the bar
    pass.times.assign(pass.path.size(), 0.0);
    workpiece.part = withPass(workpiece, {1.0, {{2000.0, 50.0}}, {0.0}}, 1e-9);
    auto part = std::make_shared<TurnedPart>(*workpiece.part);
    part->passes = {std::make_shared<const TurningPass>(pass)};
    workpiece.part = part;
    Container container;
    m_kind.save(workpiece, container);
    container.blobs.erase("workpiece/radii/0000");
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded && !static_cast<const WorkpieceSnapshot&>(**loaded).part);
    QCOMPARE(damage.size(), std::size_t{2});
    QVERIFY(damage[1].code == ErrorCode::ElementMalformed);
  }

  // Around a ball of 20 mm the chords of the arc and those of the circle are off to the same side: together they are
  // within the tolerance.
  void theBodyIsWithinTheTolerance() {
    WorkpieceSnapshot workpiece;
    workpiece.chord = 0.1;
    TurningPass pass;
    for (double angle = -1.2; angle <= 1.2; angle += 0.01) {
      pass.path.emplace_back(21.0 * std::cos(angle), 50.0 + 21.0 * std::sin(angle));
      pass.times.push_back(0.0);
    }
    workpiece.part = withPass(workpiece, pass, 0.01);
    std::vector<Note> notes;
    const GeometryPointer body = m_kind.bodyGeometry(workpiece, notes);
    const TriangleSoup& surface = *body->surface();
    double worst = 0.0;
    for (const Triangle& t : surface.triangles) {
      for (double u = 0.0; u <= 1.0; u += 0.125) {
        for (double v = 0.0; u + v <= 1.0; v += 0.125) {
          const Vec3 p = u * surface.points[t[0]] + v * surface.points[t[1]] + (1.0 - u - v) * surface.points[t[2]];
          const double off = 20.0 - (p - Vec3(0, 0, 50)).norm();
          if (std::abs(p.z() - 50.0) < 15.0) worst = std::max(worst, std::abs(off));
        }
      }
    }
    QVERIFY(worst > 0.02 && worst <= 0.1 + 0.002);  // the material between the points of the path is 0.0003
  }

  void hostileManifests_data() {
    QTest::addColumn<QByteArray>("turned");
    for (const char* turned :
         {"3", "[]", "{}", "{\"samples\": 1}", "{\"samples\": 4000000000}", "{\"samples\": -2}",
          "{\"samples\": 100000, \"passes\": 7}", "{\"samples\": 100000, \"passes\": [1, {}, null]}",
          "{\"samples\": 5, \"passes\": [{\"nose_radius\": 1e999, \"points\": 1}]}",
          "{\"samples\": 5, \"passes\": [{\"nose_radius\": 1, \"points\": 18446744073709551615}]}"}) {
      QTest::addRow("%s", turned) << QByteArray(turned);
    }
  }
  void hostileManifests() {
    QFETCH(QByteArray, turned);
    Container container;
    m_kind.save(WorkpieceSnapshot(), container);
    (*container.manifest)["document"]["turned"] = nlohmann::json::parse(turned.toStdString(), nullptr, false);
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded && !damage.empty());
  }

  // Wrong numbers in the blobs: no radius larger than the bar, none below zero, none that is no number.
  void hostileRadii() {
    for (const double bad : {-1e-9, 26.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
      Container container;
      m_kind.save(cutTwice(), container);
      std::vector<double> radii = fromBlob<double>(container.blobs.at("workpiece/radii/0000"));
      radii[7] = bad;
      container.blobs["workpiece/radii/0000"] = toBlob(radii);
      std::vector<Error> damage;
      const auto loaded = m_kind.load(container, damage, {});
      QVERIFY(loaded && !damage.empty());
      QVERIFY(isSame(static_cast<const WorkpieceSnapshot&>(**loaded), cutTwice()));
    }
  }

  // A valid solid and a closed mesh of the same volume as the profile.
  void exportsWhatWasCut() {
    const QTemporaryDir folder;
    WorkpieceSnapshot workpiece = cutTwice();
    workpiece.stock.position = 12.0;
    const std::filesystem::path step = folder.filePath("a.step").toStdString();
    const auto asStep = m_kind.exportTo(workpiece, step, {});
    QVERIFY(asStep);
    QFile file(QString::fromStdString(step));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto report = inspectStep(file.readAll().toStdString());
    QVERIFY(report && report->solids == 1 && report->isValid);
    QVERIFY(std::abs(report->volume / workpiece.part->profile.volume() - 1.0) < 1e-3);
    const std::filesystem::path stl = folder.filePath("a.stl").toStdString();
    QVERIFY(m_kind.exportTo(workpiece, stl, {}));
    const auto read = readMeshFile(stl, {});
    QVERIFY(read);
    const HalfEdgeMesh mesh = buildMesh(read->soup).mesh;
    QVERIFY(findBoundaryLoops(mesh).empty());
    double volume = 0.0, lowest = 1e9;
    for (const Triangle& t : read->soup.triangles) {
      const Vec3 a = read->soup.points[t[0]], b = read->soup.points[t[1]], c = read->soup.points[t[2]];
      volume += a.dot(b.cross(c)) / 6.0;
      lowest = std::min({lowest, a.z(), b.z(), c.z()});
    }
    QVERIFY(std::abs(volume / workpiece.part->profile.volume() - 1.0) < 2e-3);
    QCOMPARE(lowest, 12.0);
  }

  // One file holds one solid: of a bar of 50 mm that a nose of 1 mm has parted in its middle, that is the piece at the
  // free end, from Z 51 to Z 100, and it is reported. The volumes of both pieces are listed separately.
  void thePartedPieceIsAStepFile() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a.step").toStdString();
    WorkpieceSnapshot workpiece;
    TurningPass pass;
    pass.path = {{0.0, 50.0}};
    pass.times = {0.0};
    workpiece.part = withPass(workpiece, pass, 0.1);
    const double r = 0.5 * workpiece.stock.diameter, length = workpiece.stock.length;
    const auto pieces = workpiece.part->section().pieces();
    QCOMPARE(pieces.size(), std::size_t{2});
    QVERIFY(std::abs(pieces.back().box().sizes().y() - (length - 51.0)) < 1e-9);
    const auto written = m_kind.exportTo(workpiece, path, {});
    QVERIFY(written.hasValue());
    QVERIFY(std::any_of(written->notes.begin(), written->notes.end(), [](const Note& note) { return note.isLoss; }));
    QVERIFY(std::filesystem::exists(path));
    double kept = 0.0, parted = 0.0;
    for (const Property& each : workpieceProperties(workpiece)) {
      if (each.id == "volume") kept = std::get<double>(each.value);
      if (each.id == "parted_volume") parted = std::get<double>(each.value);
    }
    QVERIFY(std::abs(parted - M_PI * r * r * (length - 51.0)) < 1e-6);
    QVERIFY(std::abs(kept + parted - workpiece.part->volume()) < 1e-6);
    QVERIFY(std::abs(kept - M_PI * r * r * 49.0) < 1e-6);
  }

  // A piece that has come off is shown by itself: a gap of 2 mm in the middle of a bar of 100 mm. Shown again, the
  // block of the gap is the same; each triangle is on one side.
  void thePartedPieceIsShownByItself() {
    WorkpieceSnapshot workpiece;
    TurningPass pass;
    pass.path = {{0.0, 50.0}};
    pass.times = {0.0};
    workpiece.part = withPass(workpiece, pass, 0.1);
    const auto zOf = [](const TriangleSoup& soup) {
      std::pair<double, double> range{1e9, -1e9};
      for (const Triangle& t : soup.triangles)
        for (const std::uint32_t corner : t)
          range = {std::min(range.first, soup.points[corner].z()), std::max(range.second, soup.points[corner].z())};
      return range;
    };
    const DisplayModel model = m_kind.display(workpiece);
    std::size_t held = 0, parted = 0, whole = 0;
    std::set<std::string> names;
    for (const DisplayPart& part : model.parts) {
      const bool isParted = part.group == kPartedGroup;
      (isParted ? parted : held) += part.soup->triangles.size();
      const auto [lowest, highest] = zOf(*part.soup);
      QVERIFY(isParted ? lowest > 50.5 : highest < 49.5);
      names.insert(part.name);
    }
    for (const auto& block : workpiece.part->surface.blocks()) whole += block->triangles.size();
    QVERIFY(held > 0 && parted > 0);
    QCOMPARE(held + parted, whole);
    QCOMPARE(names.size(), model.parts.size());

    DisplayModel first = displayOf(workpiece.part->surface, 0.0), second = first;
    const PartedBlock cut = showPartedOff(first, workpiece.part->profile);
    QVERIFY(cut.whole && cut.held && cut.parted);
    QVERIFY(showPartedOff(second, workpiece.part->profile, cut).parted == cut.parted);
    DisplayModel bar = displayOf(TurnedSurface(TurnedProfile(workpiece.stock, 0.1), 0.05), 0.0);
    showPartedOff(bar, TurnedProfile(workpiece.stock, 0.1));
    for (const DisplayPart& part : bar.parts) QCOMPARE(part.group, std::string(kStockGroup));
  }

  // Two pieces parted off one after the other: the volumes of the pieces are those of their lengths.
  void piecesAreDistinguished() {
    WorkpieceSnapshot workpiece;
    workpiece.stock = {40.0, 100.0, 0.0};
    for (const double z : {70.0, 30.0}) workpiece.part = withPass(workpiece, {1.0, {{0.0, z}}, {0.0}}, 0.1);
    const std::vector<TurnedSection> pieces = workpiece.part->section().pieces();
    QCOMPARE(pieces.size(), std::size_t{3});
    QCOMPARE(workpiece.part->profile.pieces().size(), std::size_t{3});
    const double lengths[] = {29.0, 38.0, 29.0};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      QVERIFY(std::abs(pieces[i].box().sizes().y() - lengths[i]) < 1e-9);
      QVERIFY(std::abs(pieces[i].volume() - M_PI * 400.0 * lengths[i]) < 1e-6);
    }
  }

  // A copy of a document shares the blocks of triangles that a pass did not touch.
  void onlyTheBlocksOfAPassAreNew() {
    const WorkpieceSnapshot before = cutTwice();
    WorkpieceSnapshot after = before;
    TurningPass pass;
    pass.path = {{20.0, 5.0}};
    pass.times = {0.0};
    after.part = withPass(before, pass, 0.1);
    const DisplayModel was = m_kind.display(before), is = m_kind.display(after);
    QCOMPARE(is.parts.size(), was.parts.size());
    std::size_t built = 0;
    for (std::size_t i = 0; i < is.parts.size(); ++i) built += is.parts[i].soup != was.parts[i].soup ? 1 : 0;
    QCOMPARE(built, std::size_t{1});
  }

 private:
  WorkpieceKind m_kind;
};

HANDWHEEL_TEST(TurnedPartTest)
#include "TurnedPartTest.moc"
