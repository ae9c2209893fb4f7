// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/NoseCompensation.h"
#include "machining/program/ProgramSetup.h"

#include <array>

namespace handwheel {

// The lathe that a program drives: its modal state, offsets and tool position. It writes the tool path.
//
// Lengths are in mm, and radii replace diameters, regardless of the units of the program. Points are (r, z) in the
// coordinates of the program: the coordinates of the active system (G54...), shifted by G92 and by the offset of the
// tool.
//
// The numbers of the program and the offset in effect determine the position of the tool post. The position of the tip
// follows from the entry of the mounted tool in the tool table. Therefore, with the offset of another tool or without
// an offset, the tip does not cut at the programmed position. For a tool that is not in the table, the offset in effect
// is used.
class ProgramMachine {
 public:
  static constexpr double kInch = 25.4;
  static constexpr int kSystems = 9;  // G54 to G59, G59.1 to G59.3
  enum class FeedMode { PerMinute, PerRevolution, InverseTime };

  struct Modal {
    bool isInch = false;
    bool isDiameter = false;
    bool isIncremental = false;  // G91 of LinuxCNC
    bool isArcAbsolute = false;  // G90.1
    bool isDrillPlane = false;   // G17: only straight moves and drilling are allowed
    bool returnsToStart = true;  // G98 of LinuxCNC: a drilling cycle ends at its initial height
    FeedMode feedMode = FeedMode::PerMinute;
    double feed = 0.0;  // mm/min, mm per revolution or 1/min
    int motion = -1;    // G code of the motion, times 10; -1: none
    bool isSurfaceSpeed = false;
    double spindle = 0.0;            // r/min or m/min
    double mostSpindle = 0.0;        // r/min, largest speed at a constant surface speed; 0: no limit
    int spin = 0;                    // 1: M3; -1: M4; 0: stopped
    bool isStoppedByChange = false;  // a change of tool has stopped the spindle
    int tool = 0, selectedTool = 0;
    bool hasFlood = false, hasMist = false;
  };

  ProgramMachine(const ProgramSetup& setup, ToolPath& path);

  Modal modal;

  // Returns the length of one unit of the program, mm.
  double unit() const { return modal.isInch ? kInch : 1.0; }
  double radius(double x) const { return unit() * (modal.isDiameter ? 0.5 * x : x); }

  const ProfilePoint& at() const { return m_at; }  // programmed position, without compensation
  bool isCompensated() const { return m_compensation.isOn(); }

  // Move the tool. A feed without a spindle speed or feed rate is refused (ProgramRefusal).
  void rapid(const ProfilePoint& to, const SourceLocation& location) { straight(ToolMove::Kind::Rapid, to, location); }
  void feed(const ProfilePoint& to, const SourceLocation& location) { straight(ToolMove::Kind::Feed, to, location); }
  void arc(int turn, const ProfilePoint& to, const ProfilePoint& centre, const SourceLocation& location);
  // Makes a pass of a thread. pitch: the length of the move for each revolution, mm.
  void thread(const ProfilePoint& to, double pitch, const SourceLocation& location);
  void dwell(double seconds, const SourceLocation& location);

  // Switches the nose compensation on. side: 1 if the tool is left of the contour, -1 if it is right. radius: the
  // radius of the nose, mm; with 0 the compensation stays off.
  void compensate(int side, double radius, const ProfilePoint& tip, const SourceLocation& location);
  void endCompensation();
  // Sets the position of the nose's centre from which the compensation continues.
  void placeNose(const ProfilePoint& centre) { m_compensation.placeNose(planePoint(centre)); }

  // Convert between the machine's own coordinates, whose zero is the reference, and the coordinates of the program.
  ProfilePoint fromMachine(const ProfilePoint& p) const { return p - m_systems[m_system] - m_shift - m_toolOffset; }
  ProfilePoint toMachine(const ProfilePoint& p) const { return p + m_systems[m_system] + m_shift + m_toolOffset; }
  // The positions of G28 and G30, in machine coordinates
  std::array<ProfilePoint, 2> home{ProfilePoint(0, 0), ProfilePoint(0, 0)};

  void selectSystem(int index);
  int system() const { return m_system; }
  const ProfilePoint& systemOffset(int index) const { return m_systems[index]; }
  void setSystem(int index, const ProfilePoint& offset);
  const ProfilePoint& shift() const { return m_shift; }
  void setShift(const ProfilePoint& shift);  // G92, G52; the tool stays where it is
  void changeTool(int number);
  const ProfilePoint& toolOffset() const { return m_toolOffset; }
  // Sets the tool offset. number: the entry of the tool table that the offset is from; -1: none.
  void setToolOffset(const ProfilePoint& offset, int number);
  void addTime(double seconds) { m_path.time += seconds; }

 private:
  void straight(ToolMove::Kind kind, const ProfilePoint& to, const SourceLocation& location);
  ToolMove moveOf(ToolMove::Kind kind, double length, const SourceLocation& location) const;
  void go(const NoseCompensation::Step& step);        // passes a move through the compensation
  void emitStep(const NoseCompensation::Step& step);  // adds a move of the tip to the path
  ProfilePoint partPoint(const ProfilePoint& p) const {
    return p + m_systems[m_system] + m_shift + m_setup.reference + (m_toolOffset - tipOffset());
  }
  ProfilePoint tipOffset() const;  // vector from the post to the tip of the mounted tool
  int mounted() const;             // entry of the mounted tool in the table

  const ProgramSetup& m_setup;
  ToolPath& m_path;
  NoseCompensation m_compensation;
  std::array<ProfilePoint, kSystems> m_systems;
  int m_system = 0;
  ProfilePoint m_shift{0, 0}, m_toolOffset{0, 0};
  int m_offsetNumber = -1;       // entry of m_toolOffset in the table
  ProfilePoint m_at{0, 0};       // programmed position
  ProfilePoint m_tip{0, 0};      // position of the tip, in the same coordinates
  bool m_needsStraight = false;  // the move after compensation must be straight
};

}  // namespace handwheel
