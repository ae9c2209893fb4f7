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
  int divisions = 100;                     // of a turn
  double perDivision = 0.02;               // mm that the slide travels
  double backlash = 0.0;                   // mm of the slide, which a change of direction loses
  double least = -500.0, largest = 500.0;  // mm, ends of the travel: there the slide stops

  double perTurn() const { return divisions * perDivision; }  // mm
  bool operator==(const LatheDial&) const = default;
};

// A three-jaw chuck. The part turns about z; its lower end, at z = 0, is in the chuck.
struct LatheChuck {
  double diameter = 125.0;   // mm, of the body
  double length = 60.0;      // mm, of the body
  double jawLength = 30.0;   // mm, along z, in front of the body
  double jawHeight = 20.0;   // mm, in r
  double jawWidth = 18.0;    // mm, around the axis; for the picture
  double grip = 20.0;        // mm of the part that the jaws hold, from z = 0 on
  bool gripsInside = false;  // the jaws press outward in a bore

  bool operator==(const LatheChuck&) const = default;
};

// What is in the quill of the tailstock.
enum class LatheFitting { None, Centre, Drill };

// The tailstock, on the far side of the part.
struct LatheTailstock {
  LatheFitting fitting = LatheFitting::None;
  std::string drill;            // id of a tool; for LatheFitting::Drill
  double place = 250.0;         // mm: z of the tip of the fitting with the quill drawn in
  double quillDiameter = 40.0;  // mm
  double bodyRadius = 60.0;     // mm

  bool isUsed() const { return fitting != LatheFitting::None; }
  bool operator==(const LatheTailstock&) const = default;
};

// Spindle and motor.
struct LatheSpindle {
  double leastSpeed = 30.0;      // r/min
  double largestSpeed = 2500.0;  // r/min
  double speed = 600.0;          // r/min that it is set to at first
  double acceleration = 1500.0;  // r/min in a second
  double power = 3.0;            // kW; 0: no limit
  double torque = 100.0;         // N·m at the spindle; 0: no limit

  bool operator==(const LatheSpindle&) const = default;
};

// One side of the tool post with its tool.
struct LatheSlot {
  std::string tool;              // id
  ProfilePoint place{0.0, 0.0};  // mm: where the tip truly is from the reference of the post, (r, z)
  // mm: what is added to the travel of the slides for the read-out, (r, z), as touching off has set it. Where it is
  // `place`, the read-out shows the true radius, and z from the lower end of the part.
  ProfilePoint offset{0.0, 0.0};
  bool hasOffset[2] = {false, false};  // it was set, in r and in z

  bool operator==(const LatheSlot&) const = default;
};

// A manual lathe as it was set up for a part. A value; positions are in mm, z from the lower end of the part.
struct LatheSetup {
  static constexpr std::size_t kMostSlots = 12;
  static constexpr std::size_t kMostAllowed = 50;
  static constexpr double kLargest = 1e5;  // mm, r/min, kW: of every number

  LatheChuck chuck;
  LatheTailstock tailstock;
  LatheSpindle spindle;
  std::array<LatheDial, kLatheAxes> dials{LatheDial{100, 0.2}, LatheDial{100, 0.02}, LatheDial{50, 0.02},
                                          LatheDial{50, 0.1, 0.0, 0.0, 120.0}};
  std::vector<LatheSlot> stations;   // at least one
  double compoundAngle = 0.0;        // degrees between the compound slide and the axis; positive: r grows with z
  double leadScrewPitch = 6.0;       // mm
  double rapidSpeed = 60.0;          // mm/s
  double handSpeed = 80.0;           // mm/s, the fastest that a hand turns a wheel
  double handFeed = 0.5;             // mm in a turn of the spindle, the most that a hand pushes into material
  double depthLimit = 0.0;           // mm in r: a cut that would be deeper is not made; 0: none
  double wear = 0.0;                 // mm, of the flanks of the tools (VB)
  bool showsDiameter = true;         // the read-out
  std::vector<std::string> allowed;  // ids of the tools that may be mounted; empty: any

  bool isSound() const;  // finite, within limits, no size negative, at least one slot
  bool operator==(const LatheSetup&) const = default;
};

// A lathe for a bar of this size with the common tools in its post, not touched off.
LatheSetup defaultLatheSetup(const StockCylinder& stock);

// The true place of the tip for this travel of the slides: (r, z).
ProfilePoint tipAt(const LatheSetup& setup, const LatheSlot& slot, const std::array<double, kLatheAxes>& slides);

// What the read-out shows in r and z, mm; r as a radius.
ProfilePoint readoutAt(const LatheSetup& setup, const LatheSlot& slot, const std::array<double, kLatheAxes>& slides);

// The slot after touching off: with these slides the read-out shows the value (mm; of r the radius).
LatheSlot touchedOff(const LatheSetup& setup, LatheSlot slot, const std::array<double, kLatheAxes>& slides,
                     bool isRadius, double value);

}  // namespace handwheel
