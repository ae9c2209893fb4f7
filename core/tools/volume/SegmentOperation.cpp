// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/SegmentOperation.h"

#include "base/NumberText.h"
#include "volume/image/ImageHistogram.h"
#include "volume/image/ImageLabels.h"
#include "volume/image/ImageToVolume.h"
#include "volume/segment/SegmentParts.h"
#include "volume/segment/SegmentToVolume.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

// An end of a range; open where the word is empty.
std::optional<double> endIn(std::string_view word, double open) {
  if (word.empty()) return open;
  double value = 0.0;
  ErrorCode why;
  if (!parseDecimal(word, value, why) || !std::isfinite(value)) return {};
  return value;
}

}  // namespace

const Operation& segmentOperation() {
  static const Operation operation = [] {
    Parameter range = {.property = {.id = "range",
                                    .group = {},
                                    .label = QT_TRANSLATE_NOOP("Property", "Values"),
                                    .value = std::string()},
                       .meaning =
                           "Values taken as material, from A to B, such as 300: for bone in a CT, or 2:2 for a label; "
                           "default: from Otsu's threshold upwards, or all labels",
                       .word = "A:B"};
    Parameter largest = {.property = {.id = "largest",
                                      .group = {},
                                      .label = QT_TRANSLATE_NOOP("Property", "Largest parts"),
                                      .value = 0.0,
                                      .least = 0.0,
                                      .largest = 1e9},
                         .meaning = "Keep only this many of the largest parts; 0: all",
                         .word = "N",
                         .isWhole = true};
    Parameter voxel = {.property = {.id = "voxel",
                                    .group = {},
                                    .label = QT_TRANSLATE_NOOP("Property", "Voxel"),
                                    .value = 0.0,
                                    .quantity = Quantity::Length,
                                    .least = 1e-9,
                                    .largest = 1e9},
                       .meaning = "Edge of a voxel; default: the smallest distance of samples",
                       .word = "MM",
                       .hasDefault = false};
    Parameter smoothing = {
        .property = {.id = "smooth", .group = {}, .label = QT_TRANSLATE_NOOP("Property", "Smooth"), .value = false},
        .meaning = "Smooth the voxel steps of the surface"};
    return Operation{.id = "segment",
                     .title = QT_TRANSLATE_NOOP("Tool", "Segment image"),
                     .meaning = "Creates a volume from the samples of an image with values in a range",
                     .parameters = {std::move(range), std::move(largest), std::move(voxel), std::move(smoothing)}};
  }();
  return operation;
}

std::optional<ValueRange> rangeIn(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || text.size() == 1) return {};
  const auto least = endIn(text.substr(0, colon), -kNoEnd), largest = endIn(text.substr(colon + 1), kNoEnd);
  if (!least || !largest || *least > *largest) return {};
  return ValueRange{*least, *largest};
}

Result<Segmented> segment(const ImageVolume& image, const OperationValues& values, Progress progress,
                          const BeginMaking& begin) {
  Segmented done;
  done.range = rangeIn(values.text("range")).value_or(ValueRange{0.0, kNoEnd});
  if (values.text("range").empty())
    done.range = image.labels().empty() ? ValueRange{otsuThreshold(histogramOf(image)), kNoEnd} : rangeOfLabels(image);
  Segment segment(done.range);
  const SegmentParts parts(image, segment, progress.part(0.0, 0.2));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  done.parts = done.kept = parts.samples().size();
  if (const std::size_t largest = values.whole("largest"); largest > 0 && largest < done.parts) {
    segment = parts.only(0, largest);
    done.kept = largest;
  }
  const double voxel = values.given("voxel").value_or(usualVoxel(image.grid()));
  if (begin) {
    const double faces = facesOf(image, segment, progress.part(0.2, 0.3));
    if (const Status begun = begin(voxel, predictedBytes(image, segment, faces, voxel)); !begun) return begun.error();
  }
  Result<SparseVolume> made = volumeOfSmoothed(image, segment, voxel, values.flag("smooth"), progress.part(0.3, 1.0));
  if (!made) return made.error();
  done.volume = std::move(*made);
  return done;
}

}  // namespace handwheel
