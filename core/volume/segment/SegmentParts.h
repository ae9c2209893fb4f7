// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/segment/Segment.h"

#include <optional>

namespace handwheel {

// The connected parts of a segment (samples connected by faces), the largest first. Parts of equal size are in the
// order of their first samples in the image.
class SegmentParts {
 public:
  // O(samples of the image). The object must not be used if the construction was cancelled.
  SegmentParts(const ImageVolume& image, const Segment& segment, const Progress& progress = {});

  // Returns the number of samples of each part.
  const std::vector<std::size_t>& samples() const { return m_samples; }
  std::size_t total() const;
  // Returns the number of parts with at least this number of samples. These are the first parts.
  std::size_t countFrom(std::size_t samples) const;
  // Returns the index of the part that contains a sample, or nothing if the sample is not in the segment. O(log row).
  std::optional<std::size_t> partAt(const VoxelIndex& sample) const;
  // Returns the segment of the parts [first, end). O(samples of the segment).
  Segment only(std::size_t first, std::size_t end) const;

 private:
  // A run of consecutive samples along x.
  struct Run {
    int begin, end;
  };
  std::size_t rowOf(int y, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(m_size[1]) + static_cast<std::size_t>(y);
  }
  void findRuns(const ImageVolume& image, const Segment& segment, const Progress& progress);

  std::array<int, 3> m_size;
  ValueRange m_range;
  std::vector<Run> m_runs;             // the runs, row by row
  std::vector<std::size_t> m_begins;   // index of the first run of each row, then the number of runs
  std::vector<std::uint32_t> m_parts;  // index of the part of each run
  std::vector<std::size_t> m_samples;
};

}  // namespace handwheel
