// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"

#include <string>
#include <vector>

namespace handwheel {

// A sheet of a technical drawing as lines, areas and texts. Lengths are millimetres on the paper. The origin is the
// lower left corner; y is up.
struct Sheet {
  enum class Line { Wide, Narrow, Centre };  // visible edges, dimensions, and axes (long dash, dot); ISO 128-2
  enum class Align { Left, Centre, Right };

  struct Stroke {
    ProfileSegment curve;  // (x, y)
    Line line = Line::Narrow;
  };
  struct Text {
    ProfilePoint at{0, 0};  // position of its base line
    std::string text;       // UTF-8
    double height = 3.5;    // mm, height of capitals
    Align align = Align::Centre;
    bool isUpwards = false;  // the text runs upwards, to be read from the right

    ProfileBox box() const;  // the area that the text covers, including descenders
  };
  // A closed outline that is filled (arrow heads) or hatched (cut material).
  struct Area {
    std::vector<ProfileSegment> outline;
    bool isHatched = false;
  };

  double width = 297.0, height = 210.0;
  std::vector<Stroke> strokes;
  std::vector<Area> areas;
  std::vector<Text> texts;

  void line(const ProfilePoint& a, const ProfilePoint& b, Line kind = Line::Narrow) {
    strokes.push_back({{a, b, 0.0}, kind});
  }
  void text(const ProfilePoint& at, std::string words, Align align = Align::Centre, double size = 3.5) {
    texts.push_back({at, std::move(words), size, align, false});
  }
  void move(const ProfilePoint& by);  // moves everything on the sheet
  ProfileBox box() const;             // bounds of everything on the sheet; empty if the sheet is empty
  // Adds a slender arrow head with its tip at a point, pointing along a direction (ISO 129-1).
  void arrow(const ProfilePoint& tip, const ProfilePoint& towards);
};

// Returns the printed width of a text (mm), or a little more. height: the height of capitals, mm.
double widthOf(const std::string& text, double height);

}  // namespace handwheel
