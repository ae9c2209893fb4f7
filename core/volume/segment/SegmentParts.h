// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/segment/Segment.h"

#include <optional>

namespace handwheel {

// The parts of a segment: samples that hang together over their faces. The largest is the first; of equal ones that
// whose first sample comes first in the image.
class SegmentParts {
 public:
  // O(samples of the image). After a cancel it is not to be used.
  SegmentParts(const ImageVolume& image, const Segment& segment, const Progress& progress = {});

  // The samples of each part.
  const std::vector<std::size_t>& samples() const { return m_samples; }
  std::size_t total() const;
  // How many parts have at least so many samples; these are the first.
  std::size_t countFrom(std::size_t samples) const;
  // The part that a sample is in; none: it is not in the segment. O(log row).
  std::optional<std::size_t> partAt(const VoxelIndex& sample) const;
  // The segment of the parts from first on, before end. O(samples of the segment).
  Segment only(std::size_t first, std::size_t end) const;

 private:
  // Samples of a row along x that follow one another.
  struct Run {
    int begin, end;
  };
  std::size_t rowOf(int y, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(m_size[1]) + static_cast<std::size_t>(y);
  }
  void findRuns(const ImageVolume& image, const Segment& segment, const Progress& progress);

  std::array<int, 3> m_size;
  ValueRange m_range;
  std::vector<Run> m_runs;             // row by row
  std::vector<std::size_t> m_begins;   // of the runs of each row; and the end of the last
  std::vector<std::uint32_t> m_parts;  // of each run
  std::vector<std::size_t> m_samples;
};

}  // namespace handwheel
