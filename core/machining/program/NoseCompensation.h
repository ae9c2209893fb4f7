// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramErrors.h"
#include "machining/program/ProgramSetup.h"

#include <complex>
#include <functional>
#include <optional>
#include <vector>

namespace handwheel {

// A point in the plane of a lathe as a complex number, z + i·r.
using PlanePoint = std::complex<double>;

inline PlanePoint planePoint(const ProfilePoint& p) {
  return {p.y(), p.x()};
}
inline ProfilePoint profilePoint(const PlanePoint& p) {
  return {p.imag(), p.real()};
}

// Tool nose radius compensation (G41, G42). It converts the programmed contour into the path of the tool tip.
//
// A move is held back until the next one is known. In a concave corner the move ends at the point in which the two
// offset moves meet; at a convex corner an arc around the corner is inserted. A corner that the nose cannot enter is
// refused (ProgramRefusal). The rules, including the tolerance for a corner, are the rules of LinuxCNC 2.9
// (interp_convert.cc, with the queue of moves by Chris Radek), so that the path is the same as on a machine with
// LinuxCNC. On a Fanuc the entry move ends at the nose position perpendicular to the start of the contour, not
// perpendicular to the entry move. Such an entry is possible even if the first move of the contour is shorter than the
// radius of the nose.
//
// A corner flatter than 0.05 rad is left as it is: the next move begins at the end of the last one. An arc that begins
// so may become longer than the programmed one by a few hundredths of a radian. LinuxCNC refuses more than 0.0254 rad,
// or 0.001 rad in a program in inches; a Fanuc has no such limit.
class NoseCompensation {
 public:
  // A move, with its modal state and its points.
  struct Step {
    ToolMove modal;
    PlanePoint to, centre;  // end and centre of the tip
    SourceLocation location;
  };
  using Emit = std::function<void(const Step&)>;

  NoseCompensation(ProgramDialect dialect, Emit handler)
      : m_isFanuc(dialect == ProgramDialect::Fanuc), m_emit(std::move(handler)) {}

  bool isOn() const { return m_side != 0; }

  // Switches the compensation on. side: 1 if the tool is left of the contour (G41), -1 if it is right (G42). radius:
  // the radius of the nose, mm, > 0. tip: the vector from the centre of the nose to the tip, in radii. at: the position
  // of the tip. isInch: the program is in inches.
  void begin(int side, double radius, const ProfilePoint& tip, const PlanePoint& at, bool isInch = false);
  // Adds a line or an arc, depending on modal.turn. It begins at the end of the contour; the first one begins at the
  // tip.
  void move(const Step& programmed);
  void placeNose(const PlanePoint& centre) { m_centre = centre; }
  // Emits the moves that are held back and switches the compensation off. Returns the end of the contour.
  PlanePoint end();

 private:
  struct Held {
    Step step;               // move of the centre of the nose
    PlanePoint direction{};  // programmed direction of a straight move, which a corner must not reverse; 0: it may
    double sweep = 0.0;      // programmed sweep of an arc, which a corner must not lengthen; 0: it may
    double growth = 0.0;     // rad, by which the sweep may be longer all the same
  };

  bool isInside(int turn) const { return m_side * turn > 0; }
  void hold(Held held) { m_held.push_back(std::move(held)); }
  void flush();
  void endHeldAt(const PlanePoint& corner, const SourceLocation& location);
  void enter(const Step& programmed);
  void endEntryAt(const PlanePoint& offset);
  void enterByArc(const Step& programmed);
  void line(const Step& programmed);
  void arc(const Step& programmed);
  void roundCorner(const Step& programmed, const PlanePoint& to);
  PlanePoint cornerOfLines(const PlanePoint& direction, double beta, const SourceLocation& location) const;
  PlanePoint cornerFromArc(const PlanePoint& to, const SourceLocation& location) const;
  PlanePoint cornerToArc(const Step& programmed, double theta, double beta) const;
  PlanePoint cornerOfArcs(const Step& programmed) const;

  bool m_isFanuc;
  bool m_isEntry = false;  // the held move is a straight entry move of Fanuc
  Emit m_emit;
  int m_side = 0;
  double m_radius = 0.0;
  double m_growth = 0.0;  // rad, tolerance of the growth of an arc
  PlanePoint m_tip;       // vector from the centre of the nose to the tip
  bool m_isFirst = false;
  PlanePoint m_contour;  // programmed position, the end of the contour
  PlanePoint m_centre;   // centre of the nose if no move followed
  std::vector<Held> m_held;
  std::optional<PlanePoint> m_heldFrom;  // start of the held moves
};

}  // namespace handwheel
