// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/LabelLayers.h"

#include "volume/image/ImageLabels.h"

#include <algorithm>
#include <map>
#include <set>

namespace handwheel {

std::optional<ImageFile> imageOfLayers(const ImageGrid& grid, const ImageVolume& all, std::size_t layers,
                                       bool isInterleaved, std::vector<LayerSegment> segments) {
  const std::size_t count = grid.count();
  const auto sampleOf = [&](std::size_t layer, std::size_t i) {
    return all.value(isInterleaved ? i * layers + layer : layer * count + i);
  };
  std::erase_if(segments, [&](const LayerSegment& segment) { return segment.layer >= layers; });
  using Key = std::pair<std::size_t, double>;  // layer and value
  std::map<Key, std::size_t> known;
  for (std::size_t i = 0; i < segments.size(); ++i) known.emplace(Key(segments[i].layer, segments[i].value), i);
  for (std::size_t layer = 0; layer < layers; ++layer)
    for (std::size_t i = 0; i < count; ++i)
      if (const double value = sampleOf(layer, i); value != 0.0 && !known.contains(Key(layer, value))) {
        if (segments.size() >= kMostLabels) return std::nullopt;
        known.emplace(Key(layer, value), segments.size());
        segments.push_back({value, layer});
      }
  std::set<double> values;
  for (const LayerSegment& segment : segments) values.insert(segment.value);
  const bool keepValues = values.size() == segments.size();
  const auto numberOf = [&](std::size_t segment) {
    return keepValues ? segments[segment].value : static_cast<double>(segment + 1);
  };
  std::vector<float> numbers(count);
  std::size_t overlaps = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t found = 0, last = 0;
    for (std::size_t layer = 0; layer < layers; ++layer)
      if (const double value = sampleOf(layer, i); value != 0.0) {
        last = std::max(last, known.at(Key(layer, value)));
        ++found;
      }
    if (found > 0) numbers[i] = static_cast<float>(numberOf(last));
    if (found > 1) ++overlaps;
  }
  ImageFile file = imageOfValues(grid, std::move(numbers));
  file.hasLabels = true;
  for (std::size_t i = 0; i < segments.size(); ++i) file.labels.push_back({numberOf(i), segments[i].name});
  if (overlaps > 0) file.remarks.push_back({ImageRemark::Kind::Overlap, {static_cast<double>(overlaps)}});
  return file;
}

}  // namespace handwheel
