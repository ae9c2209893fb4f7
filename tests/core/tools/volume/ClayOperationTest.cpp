// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/ClayOperation.h"

#include "TestClass.h"
#include "base/NumberText.h"
#include "document/volume/LayerSteps.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

using Part = std::shared_ptr<const VolumeSnapshot>;

constexpr double kBall = 10.0, kFine = 0.25;  // mm, of the clay and its voxels

Part clayBall(double radius = kBall, double voxel = kFine) {
  auto part = std::make_shared<VolumeSnapshot>();
  part->volume = ballOfVoxels(radius, voxel);
  part->surface = VolumeSurface(part->volume);
  return part;
}

ClayBrush ballBrush(ClayAction action, double radius) {
  ClayBrush brush;
  brush.action = action;
  brush.radius = radius;
  return brush;
}

// Returns a stroke through the positions, with a second for each segment.
HandStroke strokeOver(const std::vector<Vec3>& positions) {
  HandStroke stroke;
  for (const Vec3& position : positions) stroke.push_back({static_cast<double>(stroke.size()), position});
  return stroke;
}

// Returns the volume of a ball swept along a segment of this length; mm³.
double sweptVolume(double radius, double length) {
  return M_PI * radius * radius * (4.0 / 3.0 * radius + length);
}

// Returns the volume of the intersection of two balls whose centres are so far apart (a lens); mm³.
double commonVolume(double a, double b, double apart) {
  const double both = a + b - apart;
  return M_PI * both * both * (apart * apart + 2.0 * apart * (a + b) - 3.0 * (a - b) * (a - b)) / (12.0 * apart);
}

bool isWithinShare(double value, double expected, double share) {
  return std::abs(value - expected) <= share * std::abs(expected);
}

}  // namespace

class ClayOperationTest : public QObject {
  Q_OBJECT

 private slots:
  // A twentieth of the extent, but a voxel and a half at least; the planes of symmetry go through the middle.
  void toolAsItBegins() {
    const Part part = clayBall();
    QVERIFY(isWithinShare(usualClayBrush(*part).radius, 0.05 * 2.0 * kBall, 0.01));
    QVERIFY(usualClayBrush(*part).mirror.norm() < kFine);
    QCOMPARE(usualClayBrush(*clayBall(3.0, 0.5)).radius, 0.75);
    const Limits limits = clayRadii(part->volume);
    QCOMPARE(limits.least, 1.5 * kFine);
    QCOMPARE(limits.largest, ClayDab::kMostVoxels * kFine);
    VolumeSnapshot nothing;
    QCOMPARE(usualClayBrush(nothing).radius, 1.5);  // for voxels of 1 mm
    QCOMPARE(usualClayBrush(nothing).mirror, Vec3(Vec3::Zero()));
  }

  // The words of the command line are in the order of the actions, as are their names.
  void wordsOfActions() {
    const Parameter& tool = *clayOperation().find("tool");
    const auto numberOf = [&](const char* word) {
      return std::find(tool.words.begin(), tool.words.end(), word) - tool.words.begin();
    };
    QCOMPARE(numberOf("add"), static_cast<long>(ClayAction::Add));
    QCOMPARE(numberOf("smooth"), static_cast<long>(ClayAction::Smooth));
    QCOMPARE(numberOf("tug"), static_cast<long>(ClayAction::Move));
    QCOMPARE(numberOf("mask"), static_cast<long>(ClayAction::Mask));
    QCOMPARE(tool.words.size(), clayActionNames().size());
    QCOMPARE(clayActionNames()[static_cast<std::size_t>(ClayAction::Pinch)], "Pinch");
  }

  // Parameters that are not given have the defaults of the tool; the others count.
  void toolOfParameters() {
    const Part part = clayBall();
    OperationValues values(clayOperation());
    const Result<ClayBrush> usual = clayBrushOf(values, *part);
    QVERIFY(usual && *usual == usualClayBrush(*part));
    values.setValid("tool", static_cast<double>(ClayAction::Flatten));
    values.setValid("radius", 2.5);
    values.setValid("strength", -0.25);
    values.setValid("falloff", 0.5);
    values.setValid("mirror-y", true);
    const Result<ClayBrush> brush = clayBrushOf(values, *part);
    QVERIFY(brush.hasValue());
    QVERIFY(brush->action == ClayAction::Flatten && brush->radius == 2.5);
    QVERIFY(brush->strength == -0.25 && brush->falloff == 0.5);
    QCOMPARE(brush->isMirrored, (std::array<bool, 3>{false, true, false}));
  }

  // A radius that the voxels cannot show is refused, with the limits.
  void radiusOutOfLimits() {
    const Part part = clayBall();
    for (const double radius : {0.3, 126.0}) {
      OperationValues values(clayOperation());
      values.setValid("radius", radius);
      const Result<ClayBrush> brush = clayBrushOf(values, *part);
      QVERIFY(!brush && brush.error().code == VolumeErrors::ClayRadius);
      QCOMPARE(brush.error().arguments, (std::vector<std::string>{roundedText(radius), "0.25", "0.375", "125"}));
    }
    OperationValues least(clayOperation());
    least.setValid("radius", 0.375);
    QVERIFY(clayBrushOf(least, *part).hasValue());
  }

  // A touch on the surface takes what its ball has in common with the clay, or adds the rest of it.
  void oneTouch() {
    const Part part = clayBall();
    const double common = commonVolume(kBall, 3.0, kBall);
    const std::vector<HandStroke> touch{strokeOver({{kBall, 0.0, 0.0}})};
    const auto carved = sculptAlong(part, ballBrush(ClayAction::Carve, 3.0), touch, 1000.0, {});
    QVERIFY(carved.hasValue());
    QVERIFY2(isWithinShare(carved->removed, common, 0.01), QByteArray::number(carved->removed / common));
    QCOMPARE(carved->added, 0.0);
    QCOMPARE(carved->seconds, 0.0);
    const double less = part->volume.enclosed() - carved->part->volume.enclosed();
    QVERIFY(isWithinShare(less, carved->removed, 1e-6));
    QCOMPARE(carved->part->surface.triangleCount(), VolumeSurface(carved->part->volume).triangleCount());
    const auto added = sculptAlong(part, ballBrush(ClayAction::Add, 3.0), touch, 1000.0, {});
    QVERIFY(added.hasValue());
    QVERIFY(isWithinShare(added->added, sweptVolume(3.0, 0.0) - common, 0.01));
    QCOMPARE(added->removed, 0.0);
  }

  // Strokes carve a channel of their length, even with few positions of the hand; they follow one another, and the time
  // between them does not count.
  void strokesWithinTheClay() {
    const Part part = clayBall();
    for (const double rate : {1.0, 500.0}) {
      HandStroke second = strokeOver({{-4.0, 5.0, 0.0}, {4.0, 5.0, 0.0}, {4.0, 5.0, 0.0}});
      for (HandPose& pose : second) pose.time += 60.0;
      const std::vector<HandStroke> strokes{strokeOver({{-4.0, -4.0, 0.0}, {4.0, -4.0, 0.0}}), {}, second};
      const auto carved = sculptAlong(part, ballBrush(ClayAction::Carve, 2.0), strokes, rate, {});
      QVERIFY(carved.hasValue());
      const double exact = 2.0 * sweptVolume(2.0, 8.0);
      QVERIFY2(isWithinShare(carved->removed, exact, 0.01), QByteArray::number(carved->removed / exact));
      QCOMPARE(carved->seconds, 3.0);
      const VolumeSampler sampler(carved->part->volume);
      QVERIFY(sampler.depthAt({0.0, -4.0, 1.8}).depth < 0.0 && sampler.depthAt({0.0, 5.0, 0.0}).depth < 0.0);
      QVERIFY(sampler.depthAt({0.0, -4.0, 2.2}).depth > 0.0 && sampler.depthAt({-7.0, 0.0, 0.0}).depth > 0.0);
    }
  }

  // A hand that jumps 80 radii between two positions leaves no gap.
  void aJump() {
    HandStroke stroke = strokeOver({{20.0, 0.0, 0.0}, {140.0, 0.0, 0.0}});
    stroke.back().time = 1e-3;
    const auto added = sculptAlong(clayBall(5.0, 0.5), ballBrush(ClayAction::Add, 1.5), {stroke}, 1.0, {});
    QVERIFY(added.hasValue());
    const double exact = sweptVolume(1.5, 120.0);
    QVERIFY2(isWithinShare(added->added, exact, 0.02), QByteArray::number(added->added / exact));
    const VolumeSampler sampler(added->part->volume);
    for (double x = 19.0; x < 141.0; x += 0.5) QVERIFY(sampler.depthAt({x, 0.0, 0.0}).depth > 0.0);
  }

  // With a mirror the other side is done, too; with two of them four.
  void mirrored() {
    const Part part = clayBall();
    ClayBrush brush = usualClayBrush(*part);
    brush.radius = 1.5;
    double one = 0.0;
    for (const auto& [isMirrored, sides] : {std::pair(std::array<bool, 3>{false, false, false}, 1.0),
                                            std::pair(std::array<bool, 3>{true, false, false}, 2.0),
                                            std::pair(std::array<bool, 3>{true, false, true}, 4.0)}) {
      brush.isMirrored = isMirrored;
      const auto carved = sculptAlong(part, brush, {strokeOver({{4.0, 2.0, 5.0}})}, 1000.0, {});
      QVERIFY(carved.hasValue());
      if (sides == 1.0) one = carved->removed;
      QVERIFY2(isWithinShare(carved->removed, sides * one, 0.01), QByteArray::number(carved->removed / one));
    }
  }

  // Masked clay is protected from later strokes, and masking changes no clay.
  void masked() {
    const Part part = clayBall();
    const std::vector<HandStroke> touch{strokeOver({{kBall, 0.0, 0.0}})};
    ClayBrush mask = ballBrush(ClayAction::Mask, 5.0);
    mask.falloff = 0.0;
    const auto masked = sculptAlong(part, mask, touch, 1000.0, {});
    QVERIFY(masked.hasValue());
    QVERIFY(masked->added == 0.0 && masked->removed == 0.0 && masked->changedBlocks > 0);
    QCOMPARE(masked->part->mask->shareAt({kBall, 0.0, 0.0}), 1.0);
    QCOMPARE(masked->part->mask->shareAt({-kBall, 0.0, 0.0}), 0.0);
    const auto kept = sculptAlong(masked->part, ballBrush(ClayAction::Carve, 3.0), touch, 1000.0, {});
    QVERIFY(kept && kept->removed == 0.0);
    QCOMPARE(kept->part->volume.enclosed(), part->volume.enclosed());
    const auto other =
        sculptAlong(masked->part, ballBrush(ClayAction::Carve, 3.0), {strokeOver({{-kBall, 0.0, 0.0}})}, 1000.0, {});
    QVERIFY(other && isWithinShare(other->removed, commonVolume(kBall, 3.0, kBall), 0.01));
  }

  // Strokes go on the topmost layer, from which they can be taken off again.
  void onALayer() {
    const Part part = clayBall();
    const auto layered = withLayerOnTop(part, "ears");
    QVERIFY(layered.hasValue());
    const auto carved =
        sculptAlong(*layered, ballBrush(ClayAction::Carve, 3.0), {strokeOver({{kBall, 0.0, 0.0}})}, 1000.0, {});
    QVERIFY(carved && carved->removed > 0.0);
    const Part without = withLayerShare(*carved->part, 0, 1.0, false).volume;
    QCOMPARE(without->volume.enclosed(), part->volume.enclosed());
    // While it is off, only a mask can be painted.
    const auto refused = sculptAlong(without, ballBrush(ClayAction::Carve, 3.0), {}, 1000.0, {});
    QVERIFY(!refused && refused.error().code == VolumeErrors::LayerTakesNone);
    QCOMPARE(refused.error().arguments, std::vector<std::string>{"ears"});
    QVERIFY(sculptAlong(without, ballBrush(ClayAction::Mask, 3.0), {}, 1000.0, {}).hasValue());
    // Asked for by its name, it is on again.
    const auto again = withLayerOnTop(without, "ears");
    QVERIFY(again && (*again)->layers->all().size() == 1);
    QCOMPARE((*again)->volume.enclosed(), carved->part->volume.enclosed());
  }

  // A layer that is below another takes no strokes, and there are only so many.
  void layersThatAreNotOnTop() {
    Part part = *withLayerOnTop(*withLayerOnTop(clayBall(4.0, 0.5), "first"), "second");
    QCOMPARE(part->layers->all().back().name, std::string("second"));
    const auto below = withLayerOnTop(part, "first");
    QVERIFY(!below && below.error().code == VolumeErrors::LayerBelow);
    QCOMPARE(below.error().arguments, (std::vector<std::string>{"first", "second"}));
    while (part->layers->all().size() < ClayLayers::kMostLayers)
      part = *withLayerOnTop(part, std::to_string(part->layers->all().size()));
    const auto many = withLayerOnTop(part, "one more");
    QVERIFY(!many && many.error().code == VolumeErrors::TooManyLayers);
    QCOMPARE(many.error().arguments, std::vector<std::string>{std::to_string(ClayLayers::kMostLayers)});
    QVERIFY(withLayerOnTop(part, part->layers->all().back().name).hasValue());
  }

  // More positions of the hand than in some hours at 1 kHz, or a path of more than a million radii, are refused.
  void strokesThatAreTooLong() {
    const Part part = clayBall(4.0, 0.5);
    HandStroke days = strokeOver({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
    days.back().time = 1e5;
    const auto slow = sculptAlong(part, ballBrush(ClayAction::Carve, 1.0), {days}, 1000.0, {});
    QVERIFY(!slow && slow.error().code == VolumeErrors::PathTooLong);
    QCOMPARE(slow.error().arguments, (std::vector<std::string>{"100000", "10000"}));
    days.back().time = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(sculptAlong(part, ballBrush(ClayAction::Carve, 1.0), {days}, 1000.0, {}).error().code ==
            VolumeErrors::PathTooLong);
    const HandStroke far = strokeOver({{0.0, 0.0, 0.0}, {4.1e5, 0.0, 0.0}, {0.0, 0.0, 0.0}, {4.1e5, 0.0, 0.0}});
    const auto wide = sculptAlong(part, ballBrush(ClayAction::Carve, 1.0), {far}, 1.0, {});
    QVERIFY(!wide && wide.error().code == VolumeErrors::StrokesTooLong);
    QCOMPARE(wide.error().arguments, (std::vector<std::string>{roundedText(1.23e6), "1", roundedText(1e6)}));
  }

  // Clay that is carved away entirely is no part; one that nobody touches stays as it is.
  void nothingLeftAndNothingDone() {
    const Part part = clayBall(2.0, 0.5);
    const auto gone = sculptAlong(part, ballBrush(ClayAction::Carve, 3.0), {strokeOver({Vec3::Zero()})}, 1000.0, {});
    QVERIFY(!gone && gone.error().code == VolumeErrors::NothingLeft);
    const auto same = sculptAlong(part, ballBrush(ClayAction::Carve, 3.0), {HandStroke()}, 1000.0, {});
    QVERIFY(same && same->changedBlocks == 0 && same->removed == 0.0 && same->seconds == 0.0);
    QCOMPARE(same->part->volume.enclosed(), part->volume.enclosed());
  }

  void cancelledAndFollowed() {
    const Part part = clayBall(4.0, 0.5);
    const std::vector<HandStroke> strokes{strokeOver({{4.0, 0.0, 0.0}, {4.0, 1.0, 0.0}})};
    JobState job;
    QVERIFY(sculptAlong(part, ballBrush(ClayAction::Carve, 1.0), strokes, 50.0, Progress(job)).hasValue());
    QCOMPARE(job.fraction.load(), 1.0);
    job.cancelled = true;
    const auto cancelled = sculptAlong(part, ballBrush(ClayAction::Carve, 1.0), strokes, 50.0, Progress(job));
    QVERIFY(!cancelled && cancelled.error().code == ErrorCode::Cancelled);
  }
};

HANDWHEEL_TEST(ClayOperationTest)
#include "ClayOperationTest.moc"
