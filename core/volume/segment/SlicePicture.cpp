// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/SlicePicture.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

// Returns the axis of the image for each axis of the patient: the assignment with the largest sum of cosines.
std::array<int, 3> nearestAxes(const ImageGrid& grid) {
  const Eigen::Matrix3d cosines = grid.steps.colwise().normalized().cwiseAbs();
  std::array<int, 3> axes{0, 1, 2}, best = axes;
  double most = -1.0;
  do {
    const double sum = cosines(0, axes[0]) + cosines(1, axes[1]) + cosines(2, axes[2]);
    if (sum > most + 1e-9) {
      most = sum;
      best = axes;
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return best;
}

struct Colour {
  std::uint32_t red, green, blue, alpha;

  explicit Colour(std::uint32_t argb)
      : red(argb >> 16 & 255), green(argb >> 8 & 255), blue(argb & 255), alpha(argb >> 24) {}
  std::uint32_t over(std::uint32_t grey) const {
    const auto mixed = [&](std::uint32_t own) { return (own * alpha + grey * (255 - alpha)) / 255; };
    return 0xff000000u | mixed(red) << 16 | mixed(green) << 8 | mixed(blue);
  }
};

}  // namespace

SliceView sliceView(const ImageGrid& grid, SlicePlane plane, bool isMirrored) {
  const std::array<int, 3> axes = nearestAxes(grid);
  // Axes of the patient, and their directions on the screen: +x is the left, +y the back, +z the head.
  const int right = plane == SlicePlane::Sagittal ? 1 : 0, down = plane == SlicePlane::Axial ? 1 : 2;
  const bool isDownAlong = plane == SlicePlane::Axial;
  SliceView view{};
  view.right = axes[static_cast<std::size_t>(right)];
  view.down = axes[static_cast<std::size_t>(down)];
  view.through = axes[static_cast<std::size_t>(3 - right - down)];
  const bool isTurned = isMirrored && right == 0;
  view.isRightReversed = (grid.steps(right, view.right) < 0.0) != isTurned;
  view.isDownReversed = (grid.steps(down, view.down) < 0.0) == isDownAlong;
  view.atLeft = right != 0 ? 'A' : isTurned ? 'L' : 'R';
  view.atRight = right != 0 ? 'P' : isTurned ? 'R' : 'L';
  view.atTop = isDownAlong ? 'A' : 'H';
  view.atBottom = isDownAlong ? 'P' : 'F';
  view.width = grid.size[static_cast<std::size_t>(view.right)];
  view.height = grid.size[static_cast<std::size_t>(view.down)];
  view.slices = grid.size[static_cast<std::size_t>(view.through)];
  view.rightSpacing = grid.spacing()[view.right];
  view.downSpacing = grid.spacing()[view.down];
  return view;
}

Vec3 SliceView::indexAt(double x, double y, double slice) const {
  Vec3 index;
  index[right] = isRightReversed ? width - 1 - x : x;
  index[down] = isDownReversed ? height - 1 - y : y;
  index[through] = slice;
  return index;
}

std::array<double, 2> SliceView::pictureAt(const Vec3& index) const {
  return {isRightReversed ? width - 1 - index[right] : index[right],
          isDownReversed ? height - 1 - index[down] : index[down]};
}

SlicePicture pictureOf(const ImageVolume& image, const Segment& segment, const SliceView& view, int slice,
                       const GreyWindow& window, std::uint32_t overlay) {
  SlicePicture picture;
  picture.step =
      std::max(1, (std::max(view.width, view.height) + SlicePicture::kMostPixels - 1) / SlicePicture::kMostPixels);
  picture.width = (view.width + picture.step - 1) / picture.step;
  picture.height = (view.height + picture.step - 1) / picture.step;
  picture.pixels.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  std::array<std::uint32_t, 256> plain, covered;
  for (std::uint32_t grey = 0; grey < 256; ++grey) {
    plain[grey] = Colour(0).over(grey);
    covered[grey] = Colour(overlay).over(grey);
  }
  const double black = window.level - 0.5 * window.width, scale = 255.0 / window.width;
  image.visitSamples([&]<class Sample>(std::span<const Sample> samples) {
    const SegmentReader<Sample> reader(image, samples, segment);
    std::size_t pixel = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x, ++pixel) {
        const VoxelIndex at = view.indexAt(x * picture.step, y * picture.step, slice).template cast<int>();
        const auto value = static_cast<double>(samples[reader.indexOf(at.x(), at.y(), at.z())]);
        const auto grey = static_cast<std::size_t>(std::clamp((value - black) * scale, 0.0, 255.0));
        picture.pixels[pixel] = reader.at(at.x(), at.y(), at.z()) ? covered[grey] : plain[grey];
      }
  });
  return picture;
}

}  // namespace handwheel
