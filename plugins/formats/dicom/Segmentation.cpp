// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicom/Segmentation.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace handwheel {
namespace {

Error segmentationError(const char* reason) {
  return {ErrorCode::LibraryFailed, {reason}, {}, {}};
}

// The even slices of a label map, and the index of the slice of each frame.
struct Slices {
  double step = 1.0;  // mm
  std::size_t count = 1;
  std::vector<std::size_t> indices;
};

// Returns true if all heights are multiples of the step above the first, so that they are slices of a grid.
bool areMultiples(const std::vector<double>& heights, double step) {
  constexpr double kShare = 0.05;  // tolerance of a multiple, as a share of the step
  return std::all_of(heights.begin(), heights.end(), [&](double height) {
    const double steps = (height - heights.front()) / step;
    return std::abs(steps - std::round(steps)) <= kShare;
  });
}

// The stated distance of slices counts, as frames without any sample of a segment may be left out. The smallest
// distance of frames does if the stated one is not theirs.
Result<Slices> slicesAt(const std::vector<DicomSlice>& frames) {
  constexpr double kSamePosition = 1e-3;  // mm
  constexpr double kMostAlong = 1 << 16;
  std::vector<double> all;
  for (const DicomSlice& frame : frames) all.push_back(frame.height());
  std::sort(all.begin(), all.end());
  std::vector<double> heights;
  for (const double height : all)
    if (heights.empty() || height - heights.back() > kSamePosition) heights.push_back(height);
  double least = heights.back() - heights.front();
  for (std::size_t i = 1; i < heights.size(); ++i) least = std::min(least, heights[i] - heights[i - 1]);
  // Slices may be thinner than their distance.
  const double stated = heights.size() > 1 ? frames.front().stated : std::abs(frames.front().apart);
  Slices slices;
  if (stated > 0.0 && areMultiples(heights, stated))
    slices.step = stated;
  else if (least > 0.0 && areMultiples(heights, least))
    slices.step = least;
  else if (heights.size() > 1)
    return segmentationError("its segments have slices with uneven distances");
  const double extent = heights.back() - heights.front();
  if (extent / slices.step >= kMostAlong) return segmentationError("its slices are too far apart");
  const double steps = std::round(extent / slices.step);
  if (steps > 0.0) slices.step = extent / steps;
  slices.count = static_cast<std::size_t>(steps) + 1;
  for (const DicomSlice& frame : frames)
    slices.indices.push_back(static_cast<std::size_t>(std::round((frame.height() - heights.front()) / slices.step)));
  return slices;
}

// The grid of frames whose positions lie along one line; the first frame is the lowest.
Result<ImageGrid> gridOf(const std::vector<DicomSlice>& frames, const Slices& slices) {
  const DicomSlice& first = frames.front();
  ImageGrid grid;
  grid.size = {first.size[0], first.size[1], static_cast<int>(slices.count)};
  grid.origin = first.origin;
  grid.steps.col(0) = first.spacing[0] * first.across;
  grid.steps.col(1) = first.spacing[1] * first.down;
  grid.steps.col(2) = slices.step * first.normal();
  if (slices.count > 1)
    grid.steps.col(2) = (frames.back().origin - first.origin) / static_cast<double>(slices.count - 1);
  for (std::size_t i = 0; i < frames.size(); ++i)
    if ((frames[i].origin - grid.position(Vec3(0, 0, static_cast<double>(slices.indices[i])))).norm() > 0.5)  // mm
      return segmentationError("its slices do not lie along one line");
  if (!checkGrid(grid)) return segmentationError("it is not a grid of samples");
  return grid;
}

// Returns the number of the segment that a pixel belongs to; 0: none.
double numberOf(double pixel, const DicomSlice& frame) {
  if (frame.labels->kind != DicomLabels::Kind::Values) return pixel >= frame.labels->least ? frame.segment : 0.0;
  return pixel == frame.labels->background ? 0.0 : pixel;
}

}  // namespace

Result<SegmentationImage> imageOfSegmentation(const std::vector<DicomSlice>& frames, Progress progress) {
  const DicomSlice& any = frames.front();
  if (std::any_of(frames.begin(), frames.end(), [](const DicomSlice& frame) { return !frame.hasPosition; }))
    return segmentationError("its segments have no positions");
  std::vector<DicomSlice> sorted = frames;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const DicomSlice& a, const DicomSlice& b) { return a.height() < b.height(); });
  const Result<Slices> slices = slicesAt(sorted);
  if (!slices) return slices.error();
  const Result<ImageGrid> grid = gridOf(sorted, *slices);
  if (!grid) return grid.error();
  // Later segments lie over those before.
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < sorted.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sorted[a].segment < sorted[b].segment; });
  SegmentationImage made{{ImageVolume(*grid, std::vector<float>()), {}, {}, true, any.labels->labels}};
  std::vector<float> values(grid->count());
  std::set<std::pair<double, std::size_t>> seen;
  SlicePixels pixels;
  for (std::size_t done = 0; done < order.size(); ++done) {
    const DicomSlice& frame = sorted[order[done]];
    const std::size_t slice = slices->indices[order[done]];
    progress.set(static_cast<double>(done) / static_cast<double>(order.size()));
    if (!seen.emplace(frame.segment, slice).second) {
      ++made.samePosition;
      continue;
    }
    const std::optional<std::vector<float>> own = pixels.valuesOf(frame);
    if (!own) return segmentationError("the pixels of a slice cannot be unpacked");
    for (std::size_t i = 0; i < own->size(); ++i) {
      const auto number = static_cast<float>(numberOf((*own)[i], frame));
      float& sample = values[slice * own->size() + i];
      if (number == 0.0f) continue;
      if (sample != 0.0f) ++made.overlaps;
      sample = number;
    }
  }
  ImageFile file = imageOfValues(*grid, std::move(values));
  made.file.image = std::move(file.image);
  return made;
}

}  // namespace handwheel
