// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/drawing/DrawingScale.h"
#include "machining/drawing/PartDrawing.h"
#include "machining/target/ProfileFeatures.h"

#include <optional>
#include <vector>

namespace handwheel {

// The dimensions of a part that a drawing shows, found from its features. Texts have their tolerances.
struct PartDimensions {
  struct Diameter {
    double value, low, high;  // mm; between these heights
    bool isInner;
    std::string text;  // "Ø40 h7"
  };
  struct Note {
    ProfilePoint at;   // on the surface, (r, z)
    std::string text;  // "R2", "1×45°", "∠30°"
    bool isRoughness = false;
  };
  struct Length {
    double from, to;  // z
    std::string text;
  };
  std::vector<Diameter> diameters;
  std::vector<double> outerHeights, innerHeights;  // z of corners and faces, rising; the two ends are among the first
  std::vector<Length> spans;                       // with a tolerance, between faces of which none is the upper end
  std::vector<Note> notes;

  std::size_t count() const { return diameters.size() + outerHeights.size() + innerHeights.size() + notes.size(); }
};

// Of what is not smaller than `least` (mm). tolerance: of the features. isSmoothed: the part comes from withoutSmall(),
// so what is flat to this is flat.
PartDimensions dimensionsOf(const TargetProfile& part, const DrawingTitle& title, double tolerance, double least,
                            bool isSmoothed);

// The part without what is smaller than `least` (mm): lines and arcs within about half of it. None where they enclose
// no part, or another one.
std::optional<TargetProfile> withoutSmall(const TargetProfile& part, double least);

// Draws the dimensions of a part on a sheet, below it and above it. Texts do not overlap, whatever the scale is.
class DimensionLines {
 public:
  DimensionLines(Sheet& sheet, const DrawingPlace& place, const TargetProfile& part, const DrawingTitle& title)
      : m_sheet(sheet), m_place(place), m_part(part), m_title(title) {}

  void add(const PartDimensions& dimensions);

 private:
  using Notes = std::vector<PartDimensions::Note>;

  // Those without room in the view become notes.
  void addDiameters(const PartDimensions& dimensions, Notes& notes);
  void addDiameter(const PartDimensions::Diameter& diameter, double x);
  // From the upper end, the shortest nearest to the part; many as running dimensions. Returns where they end.
  double addLengths(std::vector<double> heights, const std::vector<PartDimensions::Length>& spans, bool isAbove,
                    double start);
  void addLength(const PartDimensions::Length& length, double y, bool isAbove);
  double addRunning(const std::vector<double>& heights, bool isAbove, double start);
  void extend(double z, double y, bool isAbove);
  void addNotes(Notes notes, double first);
  void addNote(const PartDimensions::Note& note, const ProfilePoint& elbow, double width);

  Sheet& m_sheet;
  const DrawingPlace& m_place;
  const TargetProfile& m_part;
  const DrawingTitle& m_title;
};

// The text of a size with the tolerance that is asked there, or without. prefix: "Ø", "R" or none.
std::string toleratedText(const DrawingTitle& title, DrawnTolerance::Of of, double value, double low, double high,
                          const std::string& prefix);

// Places nearest to the wanted ones, which rise, that are at least `gap` apart (least squares; isotonic regression by
// pooling adjacent violators).
std::vector<double> spread(const std::vector<double>& wanted, double gap);

}  // namespace handwheel
