// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/ScanBlobs.h"

#include "base/JsonFields.h"
#include "base/JsonText.h"
#include "document/container/Blobs.h"
#include "process/SystemMemory.h"
#include "volume/image/ImageLabels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

using Json = nlohmann::json;

constexpr const char *kScan = "scan", *kSize = "size", *kOrigin = "origin", *kSteps = "steps", *kType = "type",
                     *kRange = "range", *kPainted = "painted", *kLabels = "labels";
constexpr const char *kWhole = "int16", *kReal = "float32";
const std::string kSamples = "scan/samples", kSegment = "scan/segment/";

// Number of bricks per blob. A stroke changes few blobs, so an autosave after it has little to write.
constexpr std::size_t kGroup = 1024;
constexpr std::size_t kBrickNumbers = 1 + SegmentBrick::kSide * SegmentBrick::kSide;
// Largest ratio of the image's samples to the stored ones, as in other arrays.
constexpr std::size_t kMostLost = 64;

std::string groupName(std::size_t group) {
  std::string digits = std::to_string(group);
  digits.insert(0, 4 - std::min<std::size_t>(4, digits.size()), '0');
  return kSegment + digits;
}

Error malformedScan(const char* what, std::string why) {
  return {ErrorCode::ElementMalformed, {what, std::move(why)}, {}, {}};
}

Json endOf(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

std::size_t writeBricks(const Segment& segment, Container& container) {
  std::size_t painted = 0;
  const std::span<const Segment::Brick> bricks = segment.bricks();
  for (std::size_t first = 0; first < bricks.size(); first += kGroup) {
    std::vector<std::uint16_t> numbers;
    for (std::size_t i = first; i < std::min(first + kGroup, bricks.size()); ++i) {
      if (!bricks[i]) continue;
      numbers.push_back(static_cast<std::uint16_t>(i - first));
      numbers.insert(numbers.end(), bricks[i]->rows.begin(), bricks[i]->rows.end());
      ++painted;
    }
    if (!numbers.empty()) container.blobs[groupName(first / kGroup)] = toBlob(numbers);
  }
  return painted;
}

// Clears the samples of a brick outside the image.
void cutOff(SegmentBrick& brick, std::size_t index, const std::array<int, 3>& size) {
  const std::array<int, 3> count = Segment::bricksOf(size);
  const auto along = [&](std::size_t axis, std::size_t number) {
    return std::min(SegmentBrick::kSide, size[axis] - SegmentBrick::kSide * static_cast<int>(number));
  };
  const auto nx = static_cast<std::size_t>(count[0]), ny = static_cast<std::size_t>(count[1]);
  const int x = along(0, index % nx), y = along(1, index / nx % ny), z = along(2, index / nx / ny);
  const auto mask = static_cast<std::uint16_t>((1u << x) - 1u);
  for (int k = 0; k < SegmentBrick::kSide; ++k)
    for (int j = 0; j < SegmentBrick::kSide; ++j) {
      std::uint16_t& row = brick.rows[SegmentBrick::rowOf(j, k)];
      row = j < y && k < z ? static_cast<std::uint16_t>(row & mask) : std::uint16_t{0};
    }
}

std::vector<Segment::Brick> readBricks(const Container& container, const std::array<int, 3>& size,
                                       std::uint64_t painted, std::vector<Error>& damage) {
  std::vector<Segment::Brick> bricks;
  if (painted == 0) return bricks;
  std::size_t count = 1;
  for (const int n : Segment::bricksOf(size)) count *= static_cast<std::size_t>(n);
  bricks.resize(count);
  std::uint64_t found = 0;
  for (std::size_t group = 0; group * kGroup < count; ++group) {
    const auto blob = container.blobs.find(groupName(group));
    if (blob == container.blobs.end()) continue;
    const auto numbers = fromBlob<std::uint16_t>(blob->second);
    for (std::size_t at = 0; at + kBrickNumbers <= numbers.size(); at += kBrickNumbers) {
      const std::size_t index = group * kGroup + numbers[at];
      if (numbers[at] >= kGroup || index >= count || bricks[index]) continue;
      auto brick = std::make_shared<SegmentBrick>();
      std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(at) + 1, brick->rows.size(), brick->rows.begin());
      cutOff(*brick, index, size);
      bricks[index] = std::move(brick);
      ++found;
    }
  }
  if (found != painted) damage.push_back(malformedScan("document.scan", "part of what was painted is lost"));
  if (found == 0) bricks.clear();
  return bricks;
}

bool readPosition(const Json& from, Vec3& position) {
  if (!from.is_array() || from.size() != 3) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!from[k].is_number()) return false;
    position[static_cast<Eigen::Index>(k)] = from[k].get<double>();
  }
  return true;
}

std::optional<ImageGrid> gridIn(const Json& scan, std::vector<Error>& damage) {
  ImageGrid grid;
  const JsonFieldReader read(scan);
  const Json &size = read.member(kSize), &steps = read.member(kSteps);
  bool isSound = size.is_array() && size.size() == 3 && steps.is_array() && steps.size() == 3 &&
                 readPosition(read.member(kOrigin), grid.origin);
  for (std::size_t k = 0; k < 3 && isSound; ++k) {
    Vec3 step;
    const double along = size[k].is_number_integer() ? size[k].get<double>() : -1.0;
    isSound = along >= 0.0 && along <= ImageGrid::kMostAlong && readPosition(steps[k], step);
    if (!isSound) break;
    grid.size[k] = size[k].get<int>();
    grid.steps.col(static_cast<Eigen::Index>(k)) = step;
  }
  const Status status = isSound ? checkGrid(grid) : Status(malformedScan("document.scan", "it is no grid of samples"));
  if (status) return grid;
  damage.push_back(status.error());
  return {};
}

// Returns true if a sample is valid; types of integers have only valid ones.
bool isSound(float sample) {
  return std::isfinite(sample);
}
bool isSound(std::int16_t) {
  return true;
}

template <class Sample>
std::optional<ImageVolume> samplesIn(const Container& container, const ImageGrid& grid, std::vector<Error>& damage) {
  ReadArray<Sample> read = readArray<Sample>(container, kSamples, grid.count());
  std::size_t there = read.values.size();
  for (const IndexRange& gap : read.lost)
    if (gap.begin < read.values.size()) there -= std::min(gap.end, read.values.size()) - gap.begin;
  if (there == 0 || grid.count() / kMostLost > there) {
    damage.push_back(malformedScan("document.scan", "its samples are lost"));
    return {};
  }
  if (!read.lost.empty() && grid.count() > systemMemory() / sizeof(Sample)) {
    damage.push_back(malformedScan("document.scan", "its samples need more memory than there is"));
    return {};
  }
  std::vector<Sample>& samples = read.values;
  if (read.lost.empty() && std::all_of(samples.begin(), samples.end(), [](Sample s) { return isSound(s); }))
    return ImageVolume(grid, std::move(samples));
  // The zeros of lost samples are not values of the image.
  std::size_t lost = 0, next = 0;
  Sample least = std::numeric_limits<Sample>::max();
  read.lost.push_back({samples.size(), samples.size()});
  for (const IndexRange& gap : read.lost) {
    for (; next < std::min(gap.begin, samples.size()); ++next)
      if (isSound(samples[next])) least = std::min(least, samples[next]);
    next = std::max(next, gap.end);
    lost += gap.end - gap.begin;
  }
  if (least == std::numeric_limits<Sample>::max()) least = 0;
  samples.resize(grid.count(), least);
  for (const IndexRange& gap : read.lost)
    for (std::size_t i = gap.begin; i < std::min(gap.end, samples.size()); ++i) samples[i] = least;
  for (Sample& sample : samples) {
    if (isSound(sample)) continue;
    sample = least;
    ++lost;
  }
  damage.push_back(malformedScan("document.scan", std::to_string(lost) + " of its samples are lost"));
  return ImageVolume(grid, std::move(samples));
}

// The labels are those of the samples; only their names are taken from the file.
void readLabels(const Json& scan, ImageVolume& image) {
  const Json& stored = JsonFieldReader(scan).member(kLabels);
  if (!stored.is_array() || stored.size() > kMostLabels) return;
  std::vector<ImageLabel> labels;
  for (const Json& label : stored)
    if (label.is_array() && label.size() == 2 && label[0].is_number() && label[1].is_string())
      labels.push_back({label[0].get<double>(), label[1].get<std::string>()});
  if (!labels.empty()) markLabels(image, labels);
}

}  // namespace

void writeScan(const ImageVolume& image, const Segment& segment, Container& container) {
  const ImageGrid& grid = image.grid();
  Json scan = {{kSize, grid.size},
               {kOrigin, {grid.origin.x(), grid.origin.y(), grid.origin.z()}},
               {kSteps, Json::array()},
               {kType, image.isWhole() ? kWhole : kReal},
               {kRange, {endOf(segment.range().least), endOf(segment.range().largest)}}};
  for (Eigen::Index k = 0; k < 3; ++k) scan[kSteps].push_back({grid.steps(0, k), grid.steps(1, k), grid.steps(2, k)});
  for (const ImageLabel& label : image.labels()) scan[kLabels].push_back({label.value, label.name});
  image.visitSamples(
      [&]<class Sample>(std::span<const Sample> samples) { writeArray<Sample>(container, kSamples, samples); });
  scan[kPainted] = writeBricks(segment, container);
  (*container.manifest)["document"][kScan] = std::move(scan);
}

std::optional<StoredScan> readScan(const Container& container, std::vector<Error>& damage, Progress progress) {
  const Json& scan = JsonFieldReader(JsonFieldReader(*container.manifest).member("document")).member(kScan);
  if (scan.is_null()) return {};
  const std::optional<ImageGrid> grid = gridIn(scan, damage);
  if (!grid) return {};
  const std::string type = stringAt(scan, kType);
  if (type != kWhole && type != kReal) {
    damage.push_back(malformedScan("document.scan.type", "it is not known"));
    return {};
  }
  std::optional<ImageVolume> image =
      type == kWhole ? samplesIn<std::int16_t>(container, *grid, damage) : samplesIn<float>(container, *grid, damage);
  if (!image) return {};
  progress.set(0.5);
  readLabels(scan, *image);
  StoredScan stored{std::move(*image), {}};
  const Json& ends = JsonFieldReader(scan).member(kRange);
  const auto isEnd = [](const Json& end) { return end.is_null() || end.is_number(); };
  constexpr double kNoEnd = std::numeric_limits<double>::infinity();
  ValueRange range{-kNoEnd, kNoEnd};
  bool isRange = ends.is_array() && ends.size() == 2 && isEnd(ends[0]) && isEnd(ends[1]);
  if (isRange && ends[0].is_number()) range.least = ends[0].get<double>();
  if (isRange && ends[1].is_number()) range.largest = ends[1].get<double>();
  isRange = isRange && range.least <= range.largest;
  if (!isRange) {
    damage.push_back(malformedScan("document.scan.range", "it is no range of values"));
    return stored;
  }
  stored.segment = Segment(range, grid->size, readBricks(container, grid->size, countAt(scan, kPainted), damage));
  return stored;
}

}  // namespace handwheel
