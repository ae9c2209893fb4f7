// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/segment/Segment.h"

#include <array>

namespace handwheel {

// The anatomical planes in which images of patients are viewed. A slice is shown as radiologists have it: as if the
// patient were seen from the feet (axial), from the front (coronal) and from the left (sagittal).
enum class SlicePlane { Axial, Coronal, Sagittal };
inline constexpr std::array<SlicePlane, 3> kSlicePlanes{SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal};

// The display of the slices of an image that are perpendicular to one of its axes. Each anatomical axis uses the
// nearest axis of the image: rotated or sheared slices are shown as they are stored, not resampled.
struct SliceView {
  int right, down, through;              // image axes to the right and down on the screen, and from slice to slice
  bool isRightReversed, isDownReversed;  // true: the index increases in the opposite direction
  // Letters at the edges. R and L are the right and left of the patient, A and P front and back, H and F head and feet.
  char atLeft, atRight, atTop, atBottom;
  int width, height, slices;         // numbers of samples
  double rightSpacing, downSpacing;  // mm

  // Returns the index in the image of a position in the picture, in samples from the centre of the first sample.
  Vec3 indexAt(double x, double y, double slice) const;
  // Returns the position in the picture of an index in the image; the inverse of indexAt().
  std::array<double, 2> pictureAt(const Vec3& index) const;
};
// isMirrored: true for the patient's left at the left, as if seen from the head (axial) and from the back (coronal).
SliceView sliceView(const ImageGrid& grid, SlicePlane plane, bool isMirrored = false);

// The range of values shown from black to white.
struct GreyWindow {
  double level = 0.0;  // the value shown as middle grey
  double width = 1.0;  // range of values from black to white, above 0
};

// A slice as a picture of limited size. It has at most kMostPixels pixels per side: a picture of a larger slice shows
// only every second or third sample, and so on.
struct SlicePicture {
  static constexpr int kMostPixels = 2048;
  int width = 0, height = 0, step = 1;
  std::vector<std::uint32_t> pixels;  // 0xffRRGGBB, row by row from the top
};

// Draws a slice of an image with its segment. overlay: the colour 0xAARRGGBB that is blended over the samples in the
// segment. O(pixels).
SlicePicture pictureOf(const ImageVolume& image, const Segment& segment, const SliceView& view, int slice,
                       const GreyWindow& window, std::uint32_t overlay);

}  // namespace handwheel
