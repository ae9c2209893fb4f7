// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/drawing/DrawingScale.h"
#include "machining/drawing/PartDrawing.h"
#include "machining/target/ProfileFeatures.h"

#include <vector>

namespace handwheel {

// The dimensions of a part that a drawing shows, found from its features.
struct PartDimensions {
  struct Diameter {
    double value, low, high;  // mm; between these heights
    bool isInner;
  };
  struct Note {
    ProfilePoint at;   // on the surface, (r, z)
    std::string text;  // "R2", "1×45°", "∠30°"
    bool isInner;
  };
  std::vector<Diameter> diameters;
  std::vector<double> outerHeights, innerHeights;  // z of corners and faces, rising; the two ends are among the first
  std::vector<Note> notes;
};

PartDimensions dimensionsOf(const TargetProfile& part, double tolerance);

// Draws the dimensions on a sheet. Each returns how far (mm) it needs the paper beyond the part.
class DimensionLines {
 public:
  DimensionLines(Sheet& sheet, const DrawingPlace& place, const TargetProfile& part, const DrawingTitle& title)
      : m_sheet(sheet), m_place(place), m_part(part), m_title(title) {}

  static constexpr double kFirstRow = 12.0, kRow = 8.0;  // mm, from the part and between rows
  static constexpr std::size_t kMostRows = 7;            // more lengths become a chain

  void addDiameters(const PartDimensions& dimensions);
  void addLengths(const std::vector<double>& heights, bool isAbove);
  void addNotes(const PartDimensions& dimensions);
  // How far lengths reach beyond the part.
  static double roomFor(std::size_t heights);

 private:
  std::string withTolerance(DrawnTolerance::Of of, double value) const;
  void addLength(double from, double to, double y, bool isAbove);

  Sheet& m_sheet;
  const DrawingPlace& m_place;
  const TargetProfile& m_part;
  const DrawingTitle& m_title;
};

}  // namespace handwheel
