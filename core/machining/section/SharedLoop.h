// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/section/SectionSegment.h"

#include <memory>

namespace handwheel {

// Consecutive segments of a boundary loop, which never change. Loops share them.
struct SectionRun {
  using Pointer = std::shared_ptr<const SectionRun>;

  SectionLoop segments;  // at least one
  ProfileBox box;        // mm
  double area = 0.0;     // mm², as of areaOf()
  double volume = 0.0;   // mm³, as of volumeOf()

  static Pointer of(SectionLoop segments);
};

// A closed boundary loop that is stored in runs. A cut replaces the runs that it meets; a section of before the cut and
// one of after it share the others. A cut and a copy therefore cost time and memory by runs, not by segments.
class SharedLoop {
 public:
  explicit SharedLoop(std::vector<SectionRun::Pointer> runs);
  // Joins neighbours that are of one pass and lie on one line or circle.
  static SharedLoop of(const SectionLoop& loop);

  const std::vector<SectionRun::Pointer>& runs() const { return m_runs; }
  std::size_t size() const { return m_size; }  // number of segments
  SectionLoop segments() const;                // O(segments)
  ProfilePoint pointOnBoundary() const;        // a point inside of a segment
  double area() const { return m_area; }       // mm²; positive for a counter-clockwise loop
  double volume() const { return m_volume; }   // mm³, volume of revolution with the sign of the area
  const ProfileBox& box() const { return m_box; }

 private:
  std::vector<SectionRun::Pointer> m_runs;
  ProfileBox m_box;
  std::size_t m_size = 0;
  double m_area = 0.0, m_volume = 0.0;
};

// Some consecutive segments of a run.
struct RunPart {
  SectionRun::Pointer run;
  std::size_t first = 0, last = 0;  // [first, last)

  const SectionSegment& front() const { return run->segments[first]; }
  const SectionSegment& back() const { return run->segments[last - 1]; }
};

// Makes a loop of segments and of parts of the runs of other loops. Neighbours that are of one pass and lie on one line
// or circle are joined, except within a part.
class SharedLoopBuilder {
 public:
  void add(const SectionSegment& segment);
  void add(const RunPart& part);
  SharedLoop finish();

 private:
  bool joinToLast(const SectionSegment& segment);
  void append(const SectionSegment& segment);
  void flush();
  void reopenLast();

  std::vector<SectionRun::Pointer> m_runs;
  SectionLoop m_open;  // segments after the last run
};

}  // namespace handwheel
