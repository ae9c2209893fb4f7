// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/ScanBlobs.h"

#include "TestClass.h"
#include "document/container/UnknownPart.h"
#include "document/volume/SegmentEdit.h"
#include "document/volume/VolumeDocument.h"
#include "document/volume/VolumeKind.h"
#include "volume/VolumeShapes.h"
#include "volume/image/ImageLabels.h"
#include "volume/segment/SegmentBrush.h"

#include <rapidcheck.h>

#include <QTemporaryDir>
#include <QtTest>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

using namespace handwheel;
using nlohmann::json;

namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

template <class Sample>
ImageVolume noise(const std::array<int, 3>& size, std::mt19937& random) {
  ImageGrid grid{size, Vec3(1e3 / 3.0, -7.25, 1e-3), Eigen::Matrix3d::Identity()};
  grid.steps << 0.3, 0.02, 0.0, 0.0, 1.0 / 3.0, 0.1, 0.01, 0.0, -2.0;  // sheared, and left-handed
  std::vector<Sample> samples(grid.count());
  for (Sample& sample : samples) sample = static_cast<Sample>(static_cast<int>(random() % 65536) - 32768);
  return {grid, std::move(samples)};
}

std::vector<double> samplesOf(const ImageVolume& image) {
  return image.visitSamples([](auto samples) { return std::vector<double>(samples.begin(), samples.end()); });
}

std::vector<bool> flagsOf(const ImageVolume& image, const Segment& segment) {
  const std::array<int, 3>& size = image.grid().size;
  std::vector<bool> flags;
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x) flags.push_back(segment.contains(image, {x, y, z}));
  return flags;
}

Segment painted(const ImageVolume& image, const ValueRange& range, int strokes, std::mt19937& random) {
  Segment segment(range);
  const std::array<int, 3>& size = image.grid().size;
  const auto position = [&] {
    Vec3 at;
    for (std::size_t k = 0; k < 3; ++k)
      at[static_cast<Eigen::Index>(k)] = static_cast<double>(random() % static_cast<unsigned>(size[k]));
    return at;
  };
  for (int i = 0; i < strokes; ++i) {
    const Vec3 from = position();
    applyBrush(segment, image, {2.0, random() % 2 == 0, {}}, from, from + Vec3(3, 1, 0));
  }
  return segment;
}

// A document of a ball, its image with a painted segment.
std::shared_ptr<VolumeSnapshot> paintedContent(int strokes) {
  std::mt19937 random(7);
  auto content = std::make_shared<VolumeSnapshot>();
  content->volume = ballOfVoxels(5.0, 0.5);
  ImageVolume image = noise<std::int16_t>({90, 70, 40}, random);
  content->segment = painted(image, {100.0, kNoEnd}, strokes, random);
  ImageHistogram histogram = histogramOf(image);
  content->scan = std::make_shared<const Scan>(Scan{std::move(image), std::move(histogram)});
  return content;
}

}  // namespace

class ScanBlobsTest : public QObject {
  Q_OBJECT

 private slots:
  // Grid, values, range and strokes are restored to the last bit.
  void savedIsLoaded() {
    QVERIFY(rc::check([] {
      std::mt19937 random(*rc::gen::arbitrary<unsigned>());
      std::array<int, 3> size;
      for (int& n : size) n = *rc::gen::inRange(1, 50);
      const bool isWhole = *rc::gen::arbitrary<bool>();
      const ImageVolume image = isWhole ? noise<std::int16_t>(size, random) : noise<float>(size, random);
      ValueRange range{-kNoEnd, kNoEnd};
      if (*rc::gen::arbitrary<bool>()) range.least = *rc::gen::inRange(-30000, 0) / 3.0;
      if (*rc::gen::arbitrary<bool>()) range.largest = *rc::gen::inRange(0, 30000) / 7.0;
      const Segment segment = painted(image, range, *rc::gen::inRange(0, 6), random);
      Container container;
      writeScan(image, segment, container);
      const auto archive = writeContainer(container, Compression::Fast);
      RC_ASSERT(archive.hasValue());
      const auto unpacked = readContainer(*archive);
      RC_ASSERT(unpacked.hasValue() && unpacked->damage.empty());
      std::vector<Error> damage;
      const auto read = readScan(unpacked->container, damage, {});
      RC_ASSERT(read.has_value() && damage.empty());
      RC_ASSERT(read->image.isWhole() == isWhole);
      RC_ASSERT(samplesOf(read->image) == samplesOf(image));
      RC_ASSERT(read->image.grid().steps == image.grid().steps);
      RC_ASSERT(read->image.grid().origin == image.grid().origin);
      RC_ASSERT(read->segment->range().least == range.least && read->segment->range().largest == range.largest);
      RC_ASSERT(read->segment->isByRangeAlone() == segment.isByRangeAlone());
      RC_ASSERT(flagsOf(read->image, *read->segment) == flagsOf(image, segment));
    }));
  }

  // A label map stays one, with the names of its labels; malformed labels are not taken.
  void labels() {
    const ImageGrid grid{{3, 2, 2}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    ImageVolume image(grid, std::vector<std::int16_t>{0, 1, 1, 2, 2, 0, 0, 7, 7, 0, 0, 1});
    markLabels(image, {{1.0, "Schädel"}, {7.0, "tooth"}});
    Container container;
    writeScan(image, Segment({7.0, 7.0}), container);
    std::vector<Error> damage;
    const auto read = readScan(container, damage, {});
    QVERIFY(read && damage.empty());
    QCOMPARE(read->image.labels(), (std::vector<ImageLabel>{{1.0, "Schädel"}, {2.0, ""}, {7.0, "tooth"}}));
    for (const char* patch : {R"({"labels": 7})", R"({"labels": [[1], ["a", 2], 5]})", R"({"labels": null})"}) {
      Container other = container;
      (*other.manifest)["document"]["scan"].merge_patch(json::parse(patch));
      const auto without = readScan(other, damage, {});
      QVERIFY(without && damage.empty() && without->image.labels().empty());
    }
  }

  // A document that was painted on, saved and opened again shows the same segment; undo and volume go on as before.
  void documentOpenedAgain() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("head.handwheel").toStdString();
    VolumeDocument document(OpenedFile{&m_kind, {}, paintedContent(0)});
    Segment segment = document.segment();
    applyBrush(segment, document.scan()->image, {3.0, false, {}}, Vec3(20, 20, 20), Vec3(50, 20, 20));
    document.commit("paint", std::make_unique<SegmentEdit>(segment, document.segment()));
    QVERIFY(saveDocument(m_kind, document.file(), *document.snapshot(), path).hasValue());

    std::vector<std::unique_ptr<DocumentKind>> kinds;
    kinds.push_back(std::make_unique<VolumeKind>());
    const DocumentKinds known(std::move(kinds));
    const auto opened = known.open(path, {});
    QVERIFY(opened.hasValue() && opened->file.damage.empty());
    const VolumeDocument again(*opened);
    QVERIFY(again.scan() != nullptr);
    QCOMPARE(samplesOf(again.scan()->image), samplesOf(document.scan()->image));
    QCOMPARE(flagsOf(again.scan()->image, again.segment()), flagsOf(document.scan()->image, document.segment()));
    QCOMPARE(again.volume()->volume.material(), document.volume()->volume.material());
    document.history()->undo();
    QVERIFY(flagsOf(again.scan()->image, again.segment()) != flagsOf(document.scan()->image, document.segment()));
  }

  // One stroke changes few blobs: those of the bricks around it, and none of the image or the volume.
  void aStrokeChangesItsBlobs() {
    const auto content = paintedContent(0);
    Container before, after;
    m_kind.save(*content, before);
    Segment segment = content->segment;
    applyBrush(segment, content->scan->image, {1.0, false, {}}, Vec3(20, 20, 20), Vec3(21, 20, 20));
    content->segment = segment;
    m_kind.save(*content, after);
    std::size_t changed = 0;
    for (const auto& [name, bytes] : after.blobs) {
      const auto found = before.blobs.find(name);
      if (found != before.blobs.end() && found->second == bytes) continue;
      QVERIFY2(name.starts_with("scan/segment/"), name.c_str());
      changed += bytes.size();
    }
    QVERIFY(changed > 0 && changed < 30'000);
  }

  // A blob that is lost costs its part: samples become the least value, bricks are by the range; and it is said.
  void lostBlobs() {
    const auto content = paintedContent(40);
    Container whole;
    m_kind.save(*content, whole);
    QVERIFY(whole.blobs.contains("scan/samples/0003"));
    Container lost = whole;
    lost.blobs.erase("scan/samples/0001");
    std::vector<Error> damage;
    auto read = readScan(lost, damage, {});
    QVERIFY(read.has_value());
    QCOMPARE(damage.size(), std::size_t{1});
    const std::vector<double> before = samplesOf(content->scan->image), after = samplesOf(read->image);
    const double least = *std::min_element(before.begin(), before.end());
    for (std::size_t i = 0; i < before.size(); ++i) QCOMPARE(after[i], i / 65536 == 1 ? least : before[i]);
    QVERIFY(flagsOf(content->scan->image, *read->segment) == flagsOf(content->scan->image, content->segment));

    lost = whole;
    lost.blobs.erase("scan/segment/0000");
    damage.clear();
    read = readScan(lost, damage, {});
    QVERIFY(read.has_value());
    QCOMPARE(damage.size(), std::size_t{1});
    QVERIFY(flagsOf(content->scan->image, *read->segment) ==
            flagsOf(content->scan->image, Segment(content->segment.range())));
    // The last samples: the image ends early otherwise.
    lost = whole;
    lost.blobs.erase("scan/samples/0003");
    read = readScan(lost, damage, {});
    QCOMPARE(samplesOf(read->image).size(), before.size());
  }

  void samplesThatAreNoNumbers() {
    std::mt19937 random(3);
    const ImageVolume image = noise<float>({5, 5, 5}, random);
    Container container;
    writeScan(image, Segment({0.0, kNoEnd}), container);
    std::vector<float> samples = fromBlob<float>(container.blobs.at("scan/samples/0000"));
    samples[7] = std::numeric_limits<float>::quiet_NaN();
    samples[9] = -std::numeric_limits<float>::infinity();
    container.blobs["scan/samples/0000"] = toBlob(samples);
    std::vector<Error> damage;
    const auto read = readScan(container, damage, {});
    QVERIFY(read.has_value());
    QCOMPARE(damage.size(), std::size_t{1});
    std::vector<double> expected = samplesOf(image);
    expected[7] = expected[9] = 0.0;
    expected[7] = expected[9] = *std::min_element(expected.begin(), expected.end());
    QCOMPARE(samplesOf(read->image), expected);
  }

  // Malformed data cost the image, but neither the volume nor memory.
  void hostile_data() {
    QTest::addColumn<QByteArray>("patch");
    const auto row = [](const char* name, const char* patch) { QTest::newRow(name) << QByteArray(patch); };
    row("no object", R"({"scan": 7})");
    row("a list", R"({"scan": [1, 2]})");
    row("no size", R"({"scan": {"size": null}})");
    row("no samples", R"({"scan": {"size": [0, 70, 40]}})");
    row("negative", R"({"scan": {"size": [-1, 70, 40]}})");
    row("too long", R"({"scan": {"size": [65537, 1, 1]}})");
    row("far more than is there", R"({"scan": {"size": [65536, 32768, 1]}})");
    row("more than there may be", R"({"scan": {"size": [65536, 65536, 65536]}})");
    row("two steps", R"({"scan": {"steps": [[1, 0, 0], [0, 1, 0]]}})");
    row("in one plane", R"({"scan": {"steps": [[1, 0, 0], [0, 1, 0], [1, 1, 0]]}})");
    row("far away", R"({"scan": {"origin": [1e30, 0, 0]}})");
    row("of no type", R"({"scan": {"type": "int64"}})");
  }
  void hostile() {
    QFETCH(QByteArray, patch);
    static const auto content = paintedContent(3);
    Container container;
    m_kind.save(*content, container);
    (*container.manifest)["document"].merge_patch(json::parse(patch.toStdString()));
    std::vector<Error> damage;
    const auto loaded = m_kind.load(container, damage, {});
    QVERIFY(loaded.hasValue() && !damage.empty());
    const auto& read = static_cast<const VolumeSnapshot&>(**loaded);
    QVERIFY(!read.scan);
    QCOMPARE(read.volume.material(), content->volume.material());
  }

  // Chunks far apart stand for no more of the image than they hold.
  void fewSamplesOfMany() {
    const auto content = paintedContent(0);
    Container container;
    m_kind.save(*content, container);
    container.blobs["scan/samples/0100"] = container.blobs.at("scan/samples/0000");
    (*container.manifest)["document"]["scan"]["size"] = {4096, 4096, 16};  // 4096 chunks, of which 4 are there
    std::vector<Error> damage;
    QVERIFY(!readScan(container, damage, {}));
    QCOMPARE(damage.size(), std::size_t{1});
  }

  // The image is there, but not what was chosen: another range is taken, and that is said.
  void lostRange() {
    const auto content = paintedContent(3);
    for (const char* const range : {"null", "[1]", R"(["a", 2])", "[5, 1]", "{}"}) {
      Container container;
      m_kind.save(*content, container);
      (*container.manifest)["document"]["scan"]["range"] = json::parse(range);
      std::vector<Error> damage;
      const auto loaded = m_kind.load(container, damage, {});
      QVERIFY(loaded.hasValue() && !damage.empty());
      const auto& read = static_cast<const VolumeSnapshot&>(**loaded);
      QVERIFY(read.scan && read.segment.isByRangeAlone());
    }
  }

  // Random bytes as bricks result in a segment of the image, or in damage: nothing lies outside the image.
  void anyBricks() {
    const auto content = paintedContent(20);
    Container container;
    m_kind.save(*content, container);
    QVERIFY(rc::check([&] {
      Container damaged = container;
      std::string& bytes = damaged.blobs.at("scan/segment/0000");
      const int changes = *rc::gen::inRange(1, 200);
      for (int i = 0; i < changes; ++i)
        bytes[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(bytes.size())))] =
            static_cast<char>(*rc::gen::inRange(-128, 128));
      std::vector<Error> damage;
      const auto read = readScan(damaged, damage, {});
      RC_ASSERT(read.has_value());
      const std::array<int, 3>& size = read->image.grid().size;
      const auto bricks = read->segment->bricks();
      const auto count = Segment::bricksOf(size);
      for (std::size_t i = 0; i < bricks.size(); ++i) {
        if (!bricks[i]) continue;
        const int first = 16 * (static_cast<int>(i) % count[0]);
        const int inside = std::min(size[0] - first, 16);
        for (const std::uint16_t row : bricks[i]->rows) RC_ASSERT(row >> inside == 0);
      }
    }));
  }

  // A program that knows of no images keeps them: key and blobs go back into the file as they were.
  void olderProgramsKeepIt() {
    const auto content = paintedContent(5);
    Container read, known;
    m_kind.save(*content, read);
    VolumeSnapshot plain = *content;
    plain.scan.reset();
    m_kind.save(plain, known);
    const std::string folders[] = {"volume/", "recordings/"};
    const Container back = merged(unknownPart(read, known, folders), known, known);
    QVERIFY(*back.manifest == *read.manifest);
    QVERIFY(back.blobs == read.blobs);
  }

 private:
  VolumeKind m_kind;
};

HANDWHEEL_TEST(ScanBlobsTest)
#include "ScanBlobsTest.moc"
