// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/drawing/DrawingScale.h"
#include "machining/drawing/PartDrawing.h"
#include "machining/target/ProfileFeatures.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace handwheel {

// The dimensions of a part that a drawing shows. They are found from its features; their texts include the tolerances.
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
    double from, to;  // z of its ends
    std::string text;
  };
  std::vector<Diameter> diameters;
  std::vector<double> outerHeights,
      innerHeights;           // z of corners and faces, in ascending order; the outer heights include the two ends
  std::vector<Length> spans;  // lengths with a tolerance, between two faces below the upper end
  std::vector<Note> notes;

  std::size_t count() const { return diameters.size() + outerHeights.size() + innerHeights.size() + notes.size(); }
};

// Returns the dimensions of the features that are not smaller than `least` (mm). tolerance: the tolerance of the
// features, mm. isSmoothed: true if the part comes from withoutSmall(). Then a face that is flat within `least` counts
// as flat.
PartDimensions dimensionsOf(const TargetProfile& part, const DrawingTitle& title, double tolerance, double least,
                            bool isSmoothed);

// Returns the part without details smaller than `least` (mm). The lines and arcs of the result deviate from the part by
// about half of `least` at most. Returns nothing if they do not enclose a part, or enclose a different part.
std::optional<TargetProfile> withoutSmall(const TargetProfile& part, double least);

// Draws the dimensions of a part on a sheet, below and above the part. Texts do not overlap at any scale.
class DimensionLines {
 public:
  DimensionLines(Sheet& sheet, const DrawingLayout& layout, const TargetProfile& part, const DrawingTitle& title)
      : m_sheet(sheet), m_layout(layout), m_part(part), m_title(title) {}

  void add(const PartDimensions& dimensions);

 private:
  using Notes = std::vector<PartDimensions::Note>;
  struct Leader {
    ProfilePoint tip, elbow;     // on the sheet; the elbow is above the tip
    double at(double y) const {  // x at this height
      const double share = elbow.y() > tip.y() ? (y - tip.y()) / (elbow.y() - tip.y()) : 1.0;
      return tip.x() + std::clamp(share, 0.0, 1.0) * (elbow.x() - tip.x());
    }
  };
  struct LengthText {
    std::size_t index;  // in the texts of the sheet
    double low, high;   // x of the ends of its line
  };

  // Adds the diameters. Diameters without room in the view become notes.
  void addDiameters(const PartDimensions& dimensions, Notes& notes);
  void addDiameter(const PartDimensions::Diameter& diameter, double x);
  // Adds lengths from the upper end, the shortest nearest to the part. If there are many, they become running
  // dimensions. Returns the y at which the lengths end.
  double addLengths(std::vector<double> heights, const std::vector<PartDimensions::Length>& spans, bool isAbove,
                    double start);
  void addLength(const PartDimensions::Length& length, double y, bool isAbove);
  double addRunning(const std::vector<double>& heights, bool isAbove, double start);
  void extend(double z, double y, bool isAbove);
  void addNotes(Notes notes, double first);
  void clearLengthTexts();
  void addNote(const PartDimensions::Note& note, const ProfilePoint& elbow, double width);

  Sheet& m_sheet;
  const DrawingLayout& m_layout;
  const TargetProfile& m_part;
  const DrawingTitle& m_title;
  std::vector<Leader> m_leaders;
  std::vector<LengthText> m_lengthTexts;  // above the part
};

// Returns the text of a size, with its tolerance if the title has one for this size and height. low, high: the z of its
// ends, mm. prefix: "Ø", "R" or empty.
std::string toleratedText(const DrawingTitle& title, DrawnTolerance::Of of, double value, double low, double high,
                          const std::string& prefix);

// Returns the positions nearest to the wanted ones, in the sense of least squares, that are at least `gap` apart. The
// wanted positions must be in ascending order. The method is isotonic regression by pooling adjacent violators.
std::vector<double> spread(const std::vector<double>& wanted, double gap);

}  // namespace handwheel
