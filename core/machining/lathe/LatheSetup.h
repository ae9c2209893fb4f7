// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheTool.h"

#include <array>

namespace handwheel {

// The slides of a lathe that are moved by handwheels.
enum class LatheAxis { Carriage, Cross, Compound, Quill };
inline constexpr std::size_t kLatheAxes = 4;

// The dial of a handwheel and the screw that the wheel turns.
struct LatheDial {
  int divisions = 100;                     // number of divisions in a turn
  double perDivision = 0.02;               // mm, travel of the slide for one division
  double backlash = 0.0;                   // mm, travel of the slide that is lost when the direction changes
  double least = -500.0, largest = 500.0;  // mm; ends of the travel, where the slide stops

  double perTurn() const { return divisions * perDivision; }  // mm
  bool operator==(const LatheDial&) const = default;
};

// A three-jaw chuck. The part turns about z. The lower end of the part, at z = 0, is in the chuck.
struct LatheChuck {
  double diameter = 125.0;   // mm, diameter of the body
  double length = 60.0;      // mm, length of the body
  double jawLength = 30.0;   // mm along z, length of the jaws in front of the body
  double jawHeight = 20.0;   // mm, height of the jaws along r
  double jawWidth = 18.0;    // mm, width of the jaws around the axis; used for display only
  double grip = 20.0;        // mm, length of the part that the jaws hold, from z = 0
  bool gripsInside = false;  // the jaws press outward in a bore

  bool operator==(const LatheChuck&) const = default;
};

// The fitting in the quill of the tailstock.
enum class LatheFitting { None, Centre, Drill };

// The tailstock, which is opposite the chuck.
struct LatheTailstock {
  LatheFitting fitting = LatheFitting::None;
  std::string drill;            // id of the tool, for LatheFitting::Drill
  double position = 250.0;      // mm, z of the tip of the fitting when the quill is retracted
  double quillDiameter = 40.0;  // mm
  double bodyRadius = 60.0;     // mm

  bool isUsed() const { return fitting != LatheFitting::None; }
  bool operator==(const LatheTailstock&) const = default;
};

// The spindle and its motor.
struct LatheSpindle {
  double leastSpeed = 30.0;      // r/min
  double largestSpeed = 2500.0;  // r/min
  double speed = 600.0;          // r/min, initial speed
  double acceleration = 1500.0;  // r/min per second
  double power = 3.0;            // kW; 0: no limit
  double torque = 100.0;         // N·m at the spindle; 0: no limit

  bool operator==(const LatheSpindle&) const = default;
};

// One side of the tool post with its tool.
struct LatheSlot {
  std::string tool;                 // id of the tool
  ProfilePoint position{0.0, 0.0};  // mm; position of the tip relative to the reference of the post, (r, z)
  // Offset that is added to the travel of the slides for the read-out, (r, z), mm. Touching off sets it. If it equals
  // `position`, the read-out shows the true radius, and z from the lower end of the part.
  ProfilePoint offset{0.0, 0.0};
  bool hasOffset[2] = {false, false};  // true if the offset was set in r, and in z

  bool operator==(const LatheSlot&) const = default;
};

// The setup of a manual lathe for a part. Positions are in mm; z counts from the lower end of the part.
struct LatheSetup {
  static constexpr std::size_t kMostSlots = 12;
  static constexpr std::size_t kMostAllowed = 50;
  static constexpr double kLargest = 1e5;  // mm, r/min, kW; limit of every number

  LatheChuck chuck;
  LatheTailstock tailstock;
  LatheSpindle spindle;
  std::array<LatheDial, kLatheAxes> dials{LatheDial{100, 0.2}, LatheDial{100, 0.02}, LatheDial{50, 0.02},
                                          LatheDial{50, 0.1, 0.0, 0.0, 120.0}};
  std::vector<LatheSlot> stations;   // at least one slot
  double compoundAngle = 0.0;        // degrees, angle between the compound slide and the axis; positive: r grows with z
  double leadScrewPitch = 6.0;       // mm
  double rapidSpeed = 60.0;          // mm/s, speed of the power traverse
  double handSpeed = 80.0;           // mm/s, largest speed of a slide by its handwheel
  double handFeed = 0.5;             // mm per turn of the spindle, largest feed by hand into material
  double depthLimit = 0.0;           // mm along r; a deeper cut is not made; 0: no limit
  double wear = 0.0;                 // mm, flank wear of the tools (VB)
  bool showsDiameter = true;         // the read-out shows the diameter
  std::vector<std::string> allowed;  // ids of the tools that may be mounted; empty: any tool may be

  bool isSound() const;  // true if all numbers are finite and within limits, no size is negative, and there is a slot
  bool operator==(const LatheSetup&) const = default;
};

// Returns a lathe for a bar of this size. The common tools are in its post and have not been touched off.
LatheSetup defaultLatheSetup(const StockCylinder& stock);

// Returns the true position of the tip, (r, z), for this travel of the slides.
ProfilePoint tipAt(const LatheSetup& setup, const LatheSlot& slot, const std::array<double, kLatheAxes>& slides);

// Returns the read-out for this travel of the slides, (r, z), mm; r is a radius.
ProfilePoint readoutAt(const LatheSetup& setup, const LatheSlot& slot, const std::array<double, kLatheAxes>& slides);

// Returns the slot after touching off. At these slide positions the read-out then shows the value (mm). isRadius: true
// if the value is a radius, false if it is z.
LatheSlot touchedOff(const LatheSetup& setup, LatheSlot slot, const std::array<double, kLatheAxes>& slides,
                     bool isRadius, double value);

}  // namespace handwheel
