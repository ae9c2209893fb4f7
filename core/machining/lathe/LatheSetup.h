// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheTool.h"

#include <array>

namespace handwheel {

// Slides of a lathe that a handwheel moves.
enum class LatheAxis { Carriage, Cross, Compound, Quill };
inline constexpr std::size_t kLatheAxes = 4;

// A dial at a handwheel, and the screw behind it.
struct LatheDial {
  int divisions = 100;                     // divisions of a turn
  double perDivision = 0.02;               // mm that the slide travels
  double backlash = 0.0;                   // mm of slide travel lost when the direction changes
  double least = -500.0, largest = 500.0;  // mm; ends of the travel, where the slide stops

  double perTurn() const { return divisions * perDivision; }  // mm
  bool operator==(const LatheDial&) const = default;
};

// A three-jaw chuck. The part turns about z; its lower end, at z = 0, is in the chuck.
struct LatheChuck {
  double diameter = 125.0;   // mm, diameter of the body
  double length = 60.0;      // mm, length of the body
  double jawLength = 30.0;   // mm along z, in front of the body
  double jawHeight = 20.0;   // mm, in r
  double jawWidth = 18.0;    // mm around the axis; for display
  double grip = 20.0;        // mm of the part that the jaws hold, from z = 0 on
  bool gripsInside = false;  // the jaws press outward in a bore

  bool operator==(const LatheChuck&) const = default;
};

// The fitting in the quill of the tailstock.
enum class LatheFitting { None, Centre, Drill };

// The tailstock, on the far side of the part.
struct LatheTailstock {
  LatheFitting fitting = LatheFitting::None;
  std::string drill;            // id of a tool; for LatheFitting::Drill
  double position = 250.0;      // mm; z of the tip of the fitting with the quill retracted
  double quillDiameter = 40.0;  // mm
  double bodyRadius = 60.0;     // mm

  bool isUsed() const { return fitting != LatheFitting::None; }
  bool operator==(const LatheTailstock&) const = default;
};

// Spindle and motor.
struct LatheSpindle {
  double leastSpeed = 30.0;      // r/min
  double largestSpeed = 2500.0;  // r/min
  double speed = 600.0;          // r/min, initial speed
  double acceleration = 1500.0;  // r/min in a second
  double power = 3.0;            // kW; 0: no limit
  double torque = 100.0;         // N·m at the spindle; 0: no limit

  bool operator==(const LatheSpindle&) const = default;
};

// One side of the tool post with its tool.
struct LatheSlot {
  std::string tool;                 // id
  ProfilePoint position{0.0, 0.0};  // mm; position of the tip relative to the reference of the post, (r, z)
  // mm; offset added to the travel of the slides for the read-out, (r, z), as set by touching off. If it equals
  // `position`, the read-out shows the true radius, and z from the lower end of the part.
  ProfilePoint offset{0.0, 0.0};
  bool hasOffset[2] = {false, false};  // it was set, in r and in z

  bool operator==(const LatheSlot&) const = default;
};

// The setup of a manual lathe for a part. A value; positions are in mm, z from the lower end of the part.
struct LatheSetup {
  static constexpr std::size_t kMostSlots = 12;
  static constexpr std::size_t kMostAllowed = 50;
  static constexpr double kLargest = 1e5;  // mm, r/min, kW; limit of every number

  LatheChuck chuck;
  LatheTailstock tailstock;
  LatheSpindle spindle;
  std::array<LatheDial, kLatheAxes> dials{LatheDial{100, 0.2}, LatheDial{100, 0.02}, LatheDial{50, 0.02},
                                          LatheDial{50, 0.1, 0.0, 0.0, 120.0}};
  std::vector<LatheSlot> stations;   // at least one
  double compoundAngle = 0.0;        // degrees between the compound slide and the axis; positive: r grows with z
  double leadScrewPitch = 6.0;       // mm
  double rapidSpeed = 60.0;          // mm/s
  double handSpeed = 80.0;           // mm/s, largest slide speed by a hand wheel
  double handFeed = 0.5;             // mm in a turn of the spindle, largest feed by hand into material
  double depthLimit = 0.0;           // mm in r; a deeper cut is not made; 0: none
  double wear = 0.0;                 // mm, flank wear of the tools (VB)
  bool showsDiameter = true;         // the read-out shows the diameter
  std::vector<std::string> allowed;  // ids of the tools that may be mounted; empty: any

  bool isSound() const;  // finite, within limits, no size negative, at least one slot
  bool operator==(const LatheSetup&) const = default;
};

// Returns a lathe for a bar of this size with the common tools in its post, not touched off.
LatheSetup defaultLatheSetup(const StockCylinder& stock);

// Returns the true position of the tip for this travel of the slides: (r, z).
ProfilePoint tipAt(const LatheSetup& setup, const LatheSlot& slot, const std::array<double, kLatheAxes>& slides);

// Returns the read-out in r and z, mm; r as a radius.
ProfilePoint readoutAt(const LatheSetup& setup, const LatheSlot& slot, const std::array<double, kLatheAxes>& slides);

// Returns the slot after touching off: at these slide positions the read-out shows the value (mm; for r the radius).
LatheSlot touchedOff(const LatheSetup& setup, LatheSlot slot, const std::array<double, kLatheAxes>& slides,
                     bool isRadius, double value);

}  // namespace handwheel
