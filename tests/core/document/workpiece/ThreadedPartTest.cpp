// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurnedParts.h"
#include "document/formats/MeshFormat.h"
#include "document/workpiece/ThreadReport.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceKind.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "document/workpiece/WorkpieceShape.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

TurningPass threadingPass() {
  TurningPass pass;
  pass.noseRadius = 0.1;
  pass.path = {{23.1, 110.0}, {23.1, 70.0}};
  pass.times = {0.0, 4.0};
  pass.thread = ThreadCut{2.5, 2, true, 1.0, 0.2, 0.6};
  return pass;
}

WorkpieceSnapshot threadedBar() {
  WorkpieceSnapshot workpiece;
  workpiece.stock = {50.0, 100.0, 0.0};
  workpiece.part = withPass(workpiece, threadingPass(), 0.1);
  return workpiece;
}

}  // namespace

class ThreadedPartTest : public QObject {
  Q_OBJECT

 private slots:
  void savedIsLoaded() {
    const WorkpieceSnapshot workpiece = threadedBar();
    Container container;
    m_kind.save(workpiece, container);
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded && damage.empty());
    const TurnedPart& part = *static_cast<const WorkpieceSnapshot&>(**loaded).part;
    QVERIFY(isSame(static_cast<const WorkpieceSnapshot&>(**loaded), workpiece));
    QVERIFY(part.passes.back()->thread == threadingPass().thread);
    QVERIFY(part.threads() && part.volume() == workpiece.part->volume());
    QVERIFY(part.volume() < part.profile.volume() - 100.0);
  }

  // An impossible thread costs the pass, and is reported.
  // Drawing and dimensions in the view name it: crest at ⌀50, 1.5 mm deep for a pitch of 2.5 mm, from 70 mm to the end.
  void itsDimensionIsItsDesignation() {
    WorkpieceSnapshot workpiece;
    workpiece.stock = {50.0, 100.0, 5.0};
    TurningPass pass = threadingPass();
    pass.path = {{23.6, 110.0}, {23.6, 70.0}};
    pass.thread = ThreadCut();
    pass.thread->pitch = 2.5;
    workpiece.part = withPass(workpiece, pass, 0.1);
    const std::vector<DrawnThread> threads = threadsToDraw(workpiece);
    QCOMPARE(threads.size(), std::size_t{1});
    QCOMPARE(threads.front().designation, std::string("M50×2.5"));
    QVERIFY(std::abs(threads.front().minor - 47.0) < 1e-9 && std::abs(threads.front().low - 75.0) < 0.2);
    QVERIFY(threadsToDraw(WorkpieceSnapshot()).empty());
  }

  void impossibleThreadsAreDamage() {
    for (const auto& [key, value] : std::vector<std::pair<const char*, nlohmann::json>>{
             {"pitch", 0.0}, {"pitch", -1.0}, {"starts", 0}, {"starts", 1e9}, {"hand", "up"}, {"angle", 4.0}}) {
      Container container;
      m_kind.save(threadedBar(), container);
      (*container.manifest)["document"]["turned"]["passes"][0]["thread"][key] = value;
      std::vector<Error> damage;
      QVERIFY(m_kind.load(container, damage, {}));
      QVERIFY2(!damage.empty(), key);
    }
  }

  void undoTakesItBack() {
    auto document = m_kind.make({&m_kind, {}, m_kind.blank()});
    auto& owner = static_cast<WorkpieceDocument&>(*document);
    owner.commit("Thread", std::make_unique<TurnedPartEdit>(withPass(owner.workpiece(), threadingPass(), 0.1)));
    QVERIFY(owner.workpiece().part->threads());
    owner.history()->undo();
    QVERIFY(!owner.workpiece().part);
    owner.history()->redo();
    QVERIFY(owner.workpiece().part->threads());
  }

  // In a bar whose thread is behind the cut, the end piece has all of it, wherever its volume is shown.
  void piecesHaveTheirThreads() {
    WorkpieceSnapshot workpiece = threadedBar();
    const auto whole = workpiece.part;
    TurnedProfile profile = whole->profile;
    for (std::size_t i = 0; i < profile.size(); ++i)
      if (std::abs(profile.z(i) - 50.0) < 1.0) profile.limitOuter(i, 0.0);
    const double ofThread = whole->profile.volume() - whole->volume();
    QVERIFY(ofThread > 100.0);
    workpiece.part = std::make_shared<const TurnedPart>(TurnedPart::of(profile, whole->passes, 0.1));
    const TurnedPart& part = *workpiece.part;
    const auto pieces = part.section().pieces();
    QCOMPARE(pieces.size(), std::size_t(2));
    const TurnedSection &first = pieces[0], &last = pieces[1];
    QVERIFY(std::abs(part.volumeOf(first) - first.volume()) < 1e-9 * ofThread);
    QVERIFY(std::abs(last.volume() - part.volumeOf(last) - ofThread) < 1e-3 * ofThread);
    QVERIFY(std::abs(part.volumeOf(first) + part.volumeOf(last) - part.volume()) < 1e-3 * ofThread);
    const double volume = last.volume() - ofThread;
    const nlohmann::json described = m_kind.describe(workpiece);
    QVERIFY(std::abs(described["end_piece"]["volume"].get<double>() - volume) < 1e-3 * ofThread);
    const auto properties = workpieceProperties(workpiece);
    const auto parted = std::find_if(properties.begin(), properties.end(),
                                     [](const Property& each) { return each.id == "parted_volume"; });
    QVERIFY(parted != properties.end());
    QVERIFY(std::abs(std::get<double>(parted->value) - volume) < 1e-3 * ofThread);
  }

  // A closed mesh, as a file has it, with the volume of the part; STEP has the envelope and says so.
  void exported() {
    const WorkpieceSnapshot workpiece = threadedBar();
    const Result<TriangleSoup> soup = placedTriangles(workpiece, {});
    QVERIFY(soup);
    const HalfEdgeMesh mesh = buildMesh(*soup).mesh;
    QVERIFY(validate(mesh).empty());
    QVERIFY(findBoundaryLoops(mesh).empty());
    double volume = 0.0;
    for (const Triangle& t : soup->triangles)
      volume += soup->points[t[0]].dot(soup->points[t[1]].cross(soup->points[t[2]])) / 6.0;
    QVERIFY2(std::abs(volume / workpiece.part->volume() - 1.0) < 1e-3, QByteArray::number(volume));
    QTemporaryDir folder;
    const Result<WrittenFile> written = m_kind.exportTo(workpiece, folder.filePath("part.step").toStdString(), {});
    QVERIFY(written);
    QCOMPARE(written->notes.size(), std::size_t(2));
    QVERIFY(written->notes[1].text.find("envelope") != std::string::npos);
    // The tool begins 10 mm before the bar of 100 mm, which is no thread.
    const std::string range = written->notes[1].arguments.at(0);
    QVERIFY2(range.ends_with(" to 100"), range.c_str());
    QVERIFY(m_kind.exportTo(workpiece, folder.filePath("part.stl").toStdString(), {}));
  }

 private:
  WorkpieceKind m_kind;
};

HANDWHEEL_TEST(ThreadedPartTest)
#include "ThreadedPartTest.moc"
