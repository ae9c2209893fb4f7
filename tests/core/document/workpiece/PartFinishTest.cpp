// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "TurnedParts.h"
#include "document/container/Blobs.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/WorkpieceKind.h"

#include <QtTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr std::size_t kSmooth = 400, kRough = 800;  // samples

// A part of which two samples of the outside have a finish.
WorkpieceSnapshot finished() {
  WorkpieceSnapshot workpiece = cutTwice();
  TurnedPart part = *workpiece.part;
  SurfaceFinish finish(part.profile.size());
  finish.set(TurningSide::Outside, kSmooth, part.profile.radius(kSmooth), 0.4);
  finish.set(TurningSide::Outside, kRough, part.profile.radius(kRough), 6.3);
  part.finish = std::make_shared<const SurfaceFinish>(std::move(finish));
  workpiece.part = std::make_shared<const TurnedPart>(std::move(part));
  return workpiece;
}

std::optional<double> finishAt(const WorkpieceSnapshot& workpiece, std::size_t i) {
  const TurnedPart& part = *workpiece.part;
  return part.finish ? part.finish->at(TurningSide::Outside, i, part.profile.radius(i)) : std::nullopt;
}

}  // namespace

// The finish of a turned part in documents and in the view.
class PartFinishTest : public QObject {
  Q_OBJECT

 private slots:
  void isKeptInTheFile() {
    Container container;
    m_kind.save(finished(), container);
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded && damage.empty());
    const auto& back = static_cast<const WorkpieceSnapshot&>(**loaded);
    QVERIFY(isSame(back, finished()));
    QVERIFY(std::abs(*finishAt(back, kSmooth) - 0.4) < 1e-6 && std::abs(*finishAt(back, kRough) - 6.3) < 1e-6);
    QVERIFY(!finishAt(back, kRough + 1));
  }

  // A file without, with a lost or an impossible one: the part is whole, and its finish is not known.
  void whatIsLostIsNotKnown() {
    Container container;
    m_kind.save(cutTwice(), container);
    std::vector<Error> damage;
    QVERIFY(!static_cast<const WorkpieceSnapshot&>(**m_kind.load(container, damage, {})).part->finish);
    m_kind.save(finished(), container);
    const auto blob = container.blobs.find("workpiece/finish/0000");
    QVERIFY(blob != container.blobs.end());
    std::vector<float> values = fromBlob<float>(blob->second);
    values[kSmooth] = std::nanf(""), values[kRough] = 1e30f;
    blob->second = toBlob(values);
    const auto odd = m_kind.load(container, damage, {});
    QVERIFY(odd && damage.empty());
    QVERIFY(!finishAt(static_cast<const WorkpieceSnapshot&>(**odd), kSmooth));
    QCOMPARE(*finishAt(static_cast<const WorkpieceSnapshot&>(**odd), kRough), SurfaceFinish::kRoughest);
    container.blobs.erase("workpiece/finish/0000");
    const auto lost = m_kind.load(container, damage, {});
    QVERIFY(lost && damage.empty());
    QVERIFY(isSame(static_cast<const WorkpieceSnapshot&>(**lost), finished()));
    QVERIFY(!finishAt(static_cast<const WorkpieceSnapshot&>(**lost), kSmooth));
  }

  // What another tool cuts afterwards has no finish; the rest keeps its own.
  void aLaterPassForgetsWhereItCuts() {
    WorkpieceSnapshot workpiece = finished();
    const double z = workpiece.part->profile.z(kSmooth), r = workpiece.part->profile.radius(kSmooth);
    TurningPass pass;
    pass.path = {{r + 0.5, z - 2.0}, {r + 0.5, z + 2.0}};  // a nose of 1 mm
    pass.times = {0.0, 1.0};
    workpiece.part = withPass(workpiece, pass, 0.1);
    QVERIFY(!finishAt(workpiece, kSmooth));
    QVERIFY(finishAt(workpiece, kRough));
  }

  void polishedIsLight() {
    const WorkpieceSnapshot workpiece = finished();
    const DisplayModel model = m_kind.display(workpiece);
    const auto blockOf = [](std::size_t sample) { return sample / TurnedSurface::kBlockSamples; };
    const auto light = [&](std::size_t sample) { return model.parts[blockOf(sample)].colour[0]; };
    QVERIFY(blockOf(kSmooth) != blockOf(kRough));
    QVERIFY(light(kSmooth) > light(kRough) + 0.1f);
    QCOMPARE(model.parts[0].colour, DisplayPart().colour);
  }

 private:
  WorkpieceKind m_kind;
};

HANDWHEEL_TEST(PartFinishTest)
#include "PartFinishTest.moc"
