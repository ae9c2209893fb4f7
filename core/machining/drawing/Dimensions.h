// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/drawing/DrawingScale.h"
#include "machining/drawing/PartDrawing.h"
#include "machining/target/ProfileFeatures.h"

#include <optional>
#include <vector>

namespace handwheel {

// The dimensions of a part that a drawing shows, found from its features. Their texts include the tolerances.
struct PartDimensions {
  struct Diameter {
    double value, low, high;  // mm; low and high are the z of its ends
    bool isInner;
    std::string text;  // "Ø40 h7"
  };
  struct Note {
    ProfilePoint at;   // point on the surface, (r, z)
    std::string text;  // "R2", "1×45°", "∠30°"
    bool isRoughness = false;
  };
  struct Length {
    double from, to;  // z
    std::string text;
  };
  std::vector<Diameter> diameters;
  std::vector<double> outerHeights,
      innerHeights;           // z of corners and faces, rising; the outer ones include the two ends
  std::vector<Length> spans;  // with a tolerance, between two faces below the upper end
  std::vector<Note> notes;

  std::size_t count() const { return diameters.size() + outerHeights.size() + innerHeights.size() + notes.size(); }
};

// Returns the dimensions of the features that are not smaller than `least` (mm). tolerance: tolerance of the features.
// isSmoothed: the part comes from withoutSmall(), so a face that is flat within `least` is flat.
PartDimensions dimensionsOf(const TargetProfile& part, const DrawingTitle& title, double tolerance, double least,
                            bool isSmoothed);

// Returns the part without details smaller than `least` (mm): lines and arcs within about half of it. Returns nothing
// if they do not enclose a part, or enclose another one.
std::optional<TargetProfile> withoutSmall(const TargetProfile& part, double least);

// Draws the dimensions of a part on a sheet, below it and above it. Texts do not overlap at any scale.
class DimensionLines {
 public:
  DimensionLines(Sheet& sheet, const DrawingLayout& layout, const TargetProfile& part, const DrawingTitle& title)
      : m_sheet(sheet), m_layout(layout), m_part(part), m_title(title) {}

  void add(const PartDimensions& dimensions);

 private:
  using Notes = std::vector<PartDimensions::Note>;

  // Diameters without room in the view become notes.
  void addDiameters(const PartDimensions& dimensions, Notes& notes);
  void addDiameter(const PartDimensions::Diameter& diameter, double x);
  // Adds lengths from the upper end, the shortest nearest to the part; many become running dimensions. Returns the y at
  // which they end.
  double addLengths(std::vector<double> heights, const std::vector<PartDimensions::Length>& spans, bool isAbove,
                    double start);
  void addLength(const PartDimensions::Length& length, double y, bool isAbove);
  double addRunning(const std::vector<double>& heights, bool isAbove, double start);
  void extend(double z, double y, bool isAbove);
  void addNotes(Notes notes, double first);
  void addNote(const PartDimensions::Note& note, const ProfilePoint& elbow, double width);

  Sheet& m_sheet;
  const DrawingLayout& m_layout;
  const TargetProfile& m_part;
  const DrawingTitle& m_title;
};

// Returns the text of a size with its tolerance, if one is asked for there. prefix: "Ø", "R" or empty.
std::string toleratedText(const DrawingTitle& title, DrawnTolerance::Of of, double value, double low, double high,
                          const std::string& prefix);

// Returns the positions nearest to the wanted ones, which rise, that are at least `gap` apart (least squares; isotonic
// regression by pooling adjacent violators).
std::vector<double> spread(const std::vector<double>& wanted, double gap);

}  // namespace handwheel
