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

// The plane of a lathe as complex numbers: z + i·r.
using PlanePoint = std::complex<double>;

inline PlanePoint planePoint(const ProfilePoint& p) {
  return {p.y(), p.x()};
}
inline ProfilePoint profilePoint(const PlanePoint& p) {
  return {p.imag(), p.real()};
}

// Tool nose radius compensation (G41, G42). It converts the programmed contour to the path of the tool tip.
//
// A move is held back until the next one is known: in a concave corner it ends where the two offset moves meet; at a
// convex corner an arc around it is inserted. A corner that the nose cannot enter is refused (ProgramRefusal). The
// rules, with the tolerance for a corner, are those of LinuxCNC 2.9 (interp_convert.cc, Chris Radek's queue), so that a
// path is the same as on such a machine. On a Fanuc the entry move ends perpendicular to the contour at its begin, not
// perpendicular to itself; so it is possible if the contour begins with less than the radius of the nose.
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
      : m_entersSquare(dialect == ProgramDialect::Fanuc), m_emit(std::move(handler)) {}

  bool isOn() const { return m_side != 0; }

  // side: 1 the tool is left of the contour (G41), -1 right (G42). radius: mm, > 0. tip: from the centre of the nose to
  // the tip, in radii. at: position of the tip.
  void begin(int side, double radius, const ProfilePoint& tip, const PlanePoint& at);
  // Adds a line, or an arc that begins at the end of the contour (the first one: at the tip). modal.turn selects the
  // kind.
  void move(const Step& programmed);
  void placeNose(const PlanePoint& centre) { m_centre = centre; }
  // Emits the moves that are held back. Returns the end of the contour.
  PlanePoint end();

 private:
  struct Held {
    Step step;               // move of the centre of the nose
    PlanePoint direction{};  // direction of a straight move as programmed; 0: may change
    double sweep = 0.0;      // sweep of an arc as programmed; 0: may change
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

  bool m_entersSquare;
  bool m_isEntry = false;  // the held move is a straight entry move of Fanuc
  Emit m_emit;
  int m_side = 0;
  double m_radius = 0.0;
  PlanePoint m_tip;  // from the centre of the nose to the tip
  bool m_isFirst = false;
  PlanePoint m_contour;  // programmed
  PlanePoint m_centre;   // centre of the nose, as if nothing followed
  std::vector<Held> m_held;
  std::optional<PlanePoint> m_heldFrom;  // begin of the held moves
};

}  // namespace handwheel
