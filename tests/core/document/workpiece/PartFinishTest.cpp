// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurnedParts.h"
#include "document/container/Blobs.h"
#include "document/workpiece/FinishReport.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceKind.h"
#include "machining/lathe/LatheJson.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr std::size_t kFine = 300, kCoarse = 800;  // samples of a tenth of a mm

// At 600 r/min: 0.1 mm in a revolution along 20 to 60 mm, 0.4 up to 90 mm, both with a nose of 1 mm.
WorkpieceSnapshot finished() {
  WorkpieceSnapshot workpiece;
  TurningPass pass;
  pass.path = {{21.0, 20.0}, {21.0, 60.0}};
  pass.times = {0.0, 40.0};
  pass.speeds = {600.0, 600.0};
  workpiece.part = withPass(workpiece, pass, 0.1);
  pass.path = {{22.0, 60.0}, {22.0, 90.0}};
  pass.times = {0.0, 7.5};
  workpiece.part = withPass(workpiece, pass, 0.1);
  return workpiece;
}

FinishMark markAt(const WorkpieceSnapshot& workpiece, std::size_t i) {
  return workpiece.part->finish.at(TurningSide::Outside, i);
}

bool isRa(float ra, double expected) {
  return std::abs(ra - expected) < 1e-3 * expected;
}

}  // namespace

// The finish of a turned part in documents and in the view.
class PartFinishTest : public QObject {
  Q_OBJECT

 private slots:
  // f²/(32 R).
  void isKeptWithThePass() {
    const WorkpieceSnapshot workpiece = finished();
    QVERIFY(isRa(markAt(workpiece, kFine).roughness, 1e3 * 0.01 / 32.0));
    QVERIFY(isRa(markAt(workpiece, kCoarse).roughness, 1e3 * 0.16 / 32.0));
    QVERIFY(markAt(workpiece, kFine).pass == 0 && markAt(workpiece, kCoarse).pass == 1);
    QVERIFY(!markAt(workpiece, 100).isKnown());
  }

  void isUndoneWithThePass() {
    OpenedFile opened;
    opened.kind = &m_kind;
    opened.content = std::make_shared<const WorkpieceSnapshot>(finished());
    WorkpieceDocument document(std::move(opened));
    TurningPass pass;
    pass.path = {{20.0, 25.0}, {20.0, 40.0}};
    pass.times = {0.0, 3.0};
    pass.speeds = {600.0, 600.0};
    const FinishMark before = markAt(document.workpiece(), kFine);
    document.commit("cut", std::make_unique<TurnedPartEdit>(withPass(document.workpiece(), pass, 0.1)));
    const FinishMark after = markAt(document.workpiece(), kFine);
    QVERIFY(isRa(after.roughness, 1e3 * 0.25 / 32.0) && after.pass == 2);
    document.history()->undo();
    QCOMPARE(markAt(document.workpiece(), kFine), before);
    document.history()->redo();
    QCOMPARE(markAt(document.workpiece(), kFine), after);
  }

  void isKeptInTheFile() {
    const WorkpieceSnapshot workpiece = finished();
    const WorkpieceSnapshot back = loaded(savedOf(workpiece));
    QVERIFY(isSame(back, workpiece));
    QVERIFY(back.part->finish == workpiece.part->finish);
    WorkpieceSnapshot bored = workpiece;
    TurningPass bore;
    bore.side = TurningSide::Bore;
    bore.path = {{4.0, 102.0}, {4.0, 70.0}};
    bore.times = {0.0, 10.0};
    bore.speeds = {300.0, 900.0};
    bored.part = withPass(bored, bore, 0.1);
    QVERIFY(bored.part->finish.at(TurningSide::Bore, 900).isKnown());
    QVERIFY(loaded(savedOf(bored)).part->finish == bored.part->finish);
  }

  // The set speed of an overloaded motor is read back with its pass; other passes have none.
  void askedSpeedsAreKeptInTheFile() {
    WorkpieceSnapshot workpiece = finished();
    TurningPass pass;
    pass.path = {{20.0, 25.0}, {20.0, 40.0}};
    pass.times = {0.0, 15.0};
    for (const double asked : {600.0, 800.0}) {
      pass.path[0].x() = pass.path[1].x() = pass.path[0].x() - 1.0;
      pass.speeds = {asked, 0.5 * asked};
      pass.askedSpeeds = {asked, asked + 1.0};
      workpiece.part = withPass(workpiece, pass, 0.1);
    }
    const WorkpieceSnapshot back = loaded(savedOf(workpiece));
    QCOMPARE(back.part->passes.size(), std::size_t{4});
    QVERIFY(back.part->passes[0]->askedSpeeds.empty() && back.part->passes[1]->askedSpeeds.empty());
    QVERIFY((back.part->passes[2]->askedSpeeds == std::vector<double>{600.0, 601.0}));
    QVERIFY((back.part->passes[3]->askedSpeeds == std::vector<double>{800.0, 801.0}));
    QVERIFY((back.part->passes[3]->speeds == std::vector<double>{800.0, 400.0}));
  }

  // A file without it, as older programs wrote: the part is the same, and the finish of new cuts is known.
  void filesWithoutIt() {
    Container container = savedOf(finished());
    (*container.manifest)["document"]["turned"].erase("finish");
    container.blobs.erase("workpiece/finish/0000");
    WorkpieceSnapshot old = loaded(container);
    QVERIFY(isSame(old, finished()) && !markAt(old, kFine).isKnown());
    QCOMPARE(m_kind.display(old).parts[0].gloss, DisplayPart().gloss);
    TurningPass pass;
    pass.path = {{20.0, 25.0}, {20.0, 40.0}};
    pass.times = {0.0, 15.0};
    pass.speeds = {600.0, 600.0};
    old.part = withPass(old, pass, 0.1);
    QVERIFY(isRa(markAt(old, kFine).roughness, 1e3 * 0.01 / 32.0) && markAt(old, kFine).pass == 2);
    QVERIFY(!markAt(old, kCoarse).isKnown());
    QVERIFY(loaded(savedOf(old)).part->finish == old.part->finish);
  }

  // Lost or impossible values are unknown; the part is whole, and there is no damage.
  void whatIsLostIsNotKnown() {
    Container container = savedOf(finished());
    std::string& blob = container.blobs.at("workpiece/finish/0000");
    std::vector<float> numbers = fromBlob<float>(blob);
    numbers[3 * 300] = std::nanf("");
    numbers[3 * 301] = -7.0f;
    numbers[3 * 302 + 1] = -1.0f;
    numbers[3 * 303 + 2] = 2.0f;  // there are two passes
    numbers[3 * 304 + 2] = 0.5f;
    numbers[3 * 305 + 2] = 1e30f;
    numbers[3 * 306] = std::numeric_limits<float>::infinity();  // an ideal point
    blob = toBlob(numbers);
    const WorkpieceSnapshot odd = loaded(container);
    for (std::size_t i = 300; i < 306; ++i) QVERIFY(!markAt(odd, i).isKnown());
    QVERIFY(markAt(odd, 306).isKnown() && std::isinf(markAt(odd, 306).roughness));
    QVERIFY(markAt(odd, 307) == markAt(finished(), 307));
    container.blobs.erase("workpiece/finish/0000");
    const WorkpieceSnapshot lost = loaded(container);
    QVERIFY(isSame(lost, finished()) && !markAt(lost, kFine).isKnown());
  }

  void isReported() {
    const nlohmann::json described = m_kind.describe(finished());
    const nlohmann::json& outside = described["finish"]["outside"];
    QCOMPARE(outside.size(), std::size_t{2});
    QCOMPARE(outside[0]["grade"].get<std::string>(), std::string("N5"));  // 0.3125 µm
    QCOMPARE(outside[1]["grade"].get<std::string>(), std::string("N9"));  // 5 µm
    QVERIFY(std::abs(outside[1]["roughness_um"].get<double>() - 5.0) < 1e-3);
    QVERIFY(std::abs(outside[0]["feed"].get<double>() - 0.1) < 1e-6 && outside[0]["nose_radius"] == 1.0);
    QVERIFY(outside[1]["pass"] == 2 && outside[1]["tool"].is_null());
    QVERIFY(described["finish"]["bore"].empty());
  }

  // A polished block is lighter and gleams more than a rough one; one of which nothing is known looks like a bar.
  void polishedIsLight() {
    const DisplayModel model = m_kind.display(finished());
    const DisplayPart& bar = model.parts[0];  // up to sample 255, most of it cut
    const DisplayPart& fine = model.parts[1];
    const DisplayPart& coarse = model.parts[kCoarse / TurnedSurface::kBlockSamples];
    QVERIFY(fine.gloss > coarse.gloss + 0.2f && fine.colour[0] > coarse.colour[0] + 0.1f);
    QVERIFY(bar.gloss > 0.0f);
    const DisplayModel raw = m_kind.display(WorkpieceSnapshot());
    QCOMPARE(raw.parts[0].gloss, DisplayPart().gloss);
  }

 private:
  Container savedOf(const WorkpieceSnapshot& workpiece) const {
    Container container;
    m_kind.save(workpiece, container);
    return container;
  }
  // Turned, bored, ground and threaded: the passes cut again in the bar, all at once, give the part and its finish to
  // the last bit. The command line does so with work by hand.
  void allPassesAgain() {
    WorkpieceSnapshot workpiece = finished();
    const auto addPass = [&](TurningPass pass) {
      pass.times = {0.0, 20.0};
      pass.speeds = {600.0, 600.0};
      const std::size_t before = workpiece.part->passes.size();
      workpiece.part = withPass(workpiece, pass, 0.1);
      return workpiece.part->passes.size() == before + 1;
    };
    TurningPass bore;
    bore.side = TurningSide::Bore;
    bore.path = {{6.0, 105.0}, {6.0, 60.0}};
    QVERIFY(addPass(bore));
    TurningPass ground;
    for (const auto& tool : shippedLatheTools())
      if (tool->id == "disk-100") ground.tool = tool;
    QVERIFY(ground.tool && ground.tool->isAbrasive());
    ground.noseRadius = ground.tool->noseRadius;
    ground.path = {{20.0, 25.0}, {19.99, 55.0}};
    QVERIFY(addPass(ground));
    TurningPass thread;
    thread.noseRadius = 0.2;
    thread.thread = ThreadCut{};
    thread.path = {{20.6, 85.0}, {20.6, 65.0}};
    QVERIFY(addPass(thread));

    std::vector<TurningPass> passes;
    for (const auto& pass : workpiece.part->passes) passes.push_back(*pass);
    const auto again = withPasses(WorkpieceSnapshot(), passes, 0.1);
    QVERIFY(again && again->passes.size() == passes.size());
    QVERIFY(again->profile == workpiece.part->profile);
    QVERIFY(again->finish == workpiece.part->finish);
    QVERIFY(again->threads() != nullptr);
    QCOMPARE(again->volume(), workpiece.part->volume());
  }

  WorkpieceSnapshot loaded(const Container& container) const {
    std::vector<Error> damage;
    const auto read = m_kind.load(container, damage, {});
    if (!read || !damage.empty()) qFatal("the file does not load");
    return static_cast<const WorkpieceSnapshot&>(**read);
  }

  WorkpieceKind m_kind;
};

HANDWHEEL_TEST(PartFinishTest)
#include "PartFinishTest.moc"
