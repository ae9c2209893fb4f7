// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/SegmentEdit.h"

#include "TestClass.h"
#include "document/volume/VolumeDocument.h"
#include "document/volume/VolumeKind.h"
#include "volume/segment/SegmentBrush.h"
#include "volume/segment/SegmentParts.h"
#include "volume/segment/SegmentSmoothing.h"

#include <QtTest>
#include <algorithm>
#include <random>

using namespace handwheel;

namespace {

constexpr std::array<int, 3> kSize{40, 33, 27};

// A document of an image of noise, opened with the range from 50 on.
std::unique_ptr<VolumeDocument> noiseDocument(const VolumeKind& kind, unsigned seed) {
  std::mt19937 random(seed);
  const ImageGrid grid{kSize, Vec3::Zero(), Vec3(0.5, 0.8, 1.5).asDiagonal().toDenseMatrix()};
  std::vector<std::int16_t> samples(grid.count());
  std::generate(samples.begin(), samples.end(), [&] { return static_cast<std::int16_t>(random() % 100); });
  ImageVolume image(grid, std::move(samples));
  ImageHistogram histogram = histogramOf(image);
  auto content = std::make_shared<VolumeSnapshot>();
  content->scan = std::make_shared<Scan>(Scan{std::move(image), std::move(histogram)});
  content->segment = Segment({50.0, 99.0});
  return std::make_unique<VolumeDocument>(OpenedFile{&kind, {}, std::move(content)});
}

std::vector<bool> flagsOf(const VolumeDocument& document) {
  std::vector<bool> flags;
  for (int z = 0; z < kSize[2]; ++z)
    for (int y = 0; y < kSize[1]; ++y)
      for (int x = 0; x < kSize[0]; ++x)
        flags.push_back(document.segment().contains(document.scan()->image, {x, y, z}));
  return flags;
}

Segment changed(const VolumeDocument& document, std::mt19937& random) {
  const auto below = [&](double most) { return std::uniform_real_distribution(0.0, most)(random); };
  const ImageVolume& image = document.scan()->image;
  Segment segment = document.segment();
  switch (random() % 8) {
    case 0:
      return Segment({below(60.0), 60.0 + below(39.0)});
    case 1:
      return smoothed(image, segment);
    case 2:
      return SegmentParts(image, segment).only(0, 1 + random() % 5);
    default:
      break;
  }
  SegmentBrush brush{0.5 + below(6.0), random() % 2 == 0, {}};
  if (random() % 2 == 0) brush.plane = static_cast<int>(random() % 3);
  Vec3 from(below(kSize[0]), below(kSize[1]), below(kSize[2]));
  for (int i = 0; i < 4; ++i) {
    const Vec3 to = from + Vec3(below(20.0) - 10.0, below(20.0) - 10.0, below(20.0) - 10.0);
    applyBrush(segment, image, brush, from, to);
    from = to;
  }
  return segment;
}

}  // namespace

class SegmentEditTest : public QObject {
  Q_OBJECT

 private slots:
  // For any sequence of strokes, ranges, parts and smoothings, undo and redo restore each state, and the volume is
  // unchanged.
  void undoRedo() {
    const VolumeKind kind;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const auto document = noiseDocument(kind, seed);
      const auto volume = document->volume();
      std::mt19937 random(seed);
      std::vector<std::vector<bool>> states{flagsOf(*document)};
      for (int i = 0; i < 12; ++i) {
        const Segment& before = document->segment();
        document->commit("step", std::make_unique<SegmentEdit>(changed(*document, random), before));
        states.push_back(flagsOf(*document));
      }
      for (int round = 0; round < 2; ++round) {
        for (std::size_t i = states.size() - 1; i > 0; --i) {
          QVERIFY(flagsOf(*document) == states[i]);
          document->history()->undo();
        }
        QVERIFY(flagsOf(*document) == states.front());
        for (std::size_t i = 1; i < states.size(); ++i) {
          document->history()->redo();
          QVERIFY(flagsOf(*document) == states[i]);
        }
      }
      QCOMPARE(document->volume(), volume);
    }
  }

  // A stroke takes the memory of its bricks, not that of the image.
  void size() {
    const VolumeKind kind;
    const auto document = noiseDocument(kind, 1);
    Segment painted = document->segment();
    applyBrush(painted, document->scan()->image, {1.0, false, {}}, Vec3(8, 8, 8), Vec3(8, 8, 8));
    const SegmentEdit edit(painted, document->segment());
    QVERIFY(edit.bytes() < 2 * sizeof(SegmentBrick) + 1000);
  }
};

HANDWHEEL_TEST(SegmentEditTest)
#include "SegmentEditTest.moc"
