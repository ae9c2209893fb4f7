// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace handwheel {

// The grid of an image in space: an origin and three steps, in mm. The first sample is at the origin. The steps may be
// oblique (slices of a tilted scanner are sheared) or left-handed.
//
// Coordinates are those of a patient lying on the back, as in DICOM: x to the left, y to the back, z to the head.
struct ImageGrid {
  std::array<int, 3> size{0, 0, 0};  // samples along each axis; the first axis is stored fastest
  Vec3 origin = Vec3::Zero();
  Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();  // one column for each axis

  static constexpr int kMostAlong = 1 << 16;  // largest number of samples along an axis
  static constexpr std::size_t kMostSamples = std::size_t{1} << 31;

  std::size_t count() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }
  Vec3 spacing() const { return steps.colwise().norm(); }
  Vec3 position(const Vec3& index) const { return origin + steps * index; }
};

// Checks that an image with this grid can be stored and used. Errors: ElementMalformed (invalid size, coordinates that
// are not finite, coplanar steps), FileTooLarge.
Status checkGrid(const ImageGrid& grid);

// A label of a region: a value of its samples, with a name that may be empty.
struct ImageLabel {
  double value = 0.0;
  std::string name = {};

  bool operator==(const ImageLabel&) const = default;
};

// Scalar values on a regular grid, such as a CT. Images are not modified after they were read; copies copy the samples.
class ImageVolume {
 public:
  // Constructs an image. checkGrid() must accept the grid, and there must be one sample for each of its positions.
  ImageVolume(const ImageGrid& grid, std::vector<std::int16_t> samples) : m_grid(grid), m_samples(std::move(samples)) {}
  ImageVolume(const ImageGrid& grid, std::vector<float> samples) : m_grid(grid), m_samples(std::move(samples)) {}

  const ImageGrid& grid() const { return m_grid; }
  // Labels in the order of their values; empty: the image is no label map. The values of a label map name regions, so
  // there is no value between those of two samples.
  const std::vector<ImageLabel>& labels() const { return m_labels; }
  void setLabels(std::vector<ImageLabel> labels) { m_labels = std::move(labels); }
  // Calls visit with the samples: a span of int16_t, or of float whose values are all finite.
  template <class Visit>
  auto visitSamples(Visit visit) const {
    return std::visit([&](const auto& samples) { return visit(std::span(samples)); }, m_samples);
  }
  std::size_t bytes() const {
    return visitSamples([](auto samples) { return samples.size_bytes(); });
  }
  bool isWhole() const { return std::holds_alternative<std::vector<std::int16_t>>(m_samples); }
  double value(std::size_t index) const {
    return visitSamples([index](auto samples) { return static_cast<double>(samples[index]); });
  }

 private:
  ImageGrid m_grid;
  std::vector<ImageLabel> m_labels;
  std::variant<std::vector<std::int16_t>, std::vector<float>> m_samples;
};

// A closed range of values; either end may be infinite.
struct ValueRange {
  double least;
  double largest;
};

// Returns the least and the largest value of an image. O(samples).
ValueRange valuesOf(const ImageVolume& image);

}  // namespace handwheel
