// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/NoseCompensation.h"
#include "machining/program/ProgramSetup.h"

#include <array>

namespace handwheel {

// The lathe that a program drives: its modal state, offsets and tool position. It writes the tool path.
//
// Lengths are mm, and radii instead of diameters, whatever the program uses. Points are (r, z) in the coordinates of
// the program: those of the active system (G54...), shifted by G92 and the offset of the tool.
//
// The program's numbers and the offset in effect position the post; the tip follows from the entry of the mounted tool
// in the table of tools. So a tip cuts at another position than programmed with the offset of another tool, or without
// one. A tool that is not in the table has the offset in effect.
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
    bool isDrillPlane = false;   // G17: only straight moves and drilling
    bool returnsToStart = true;  // G98 of LinuxCNC: a drilling cycle ends at its initial height
    FeedMode feedMode = FeedMode::PerMinute;
    double feed = 0.0;  // mm/min, mm per revolution or 1/min
    int motion = -1;    // the G code of motion times 10; -1 none
    bool isSurfaceSpeed = false;
    double spindle = 0.0;      // r/min or m/min
    double mostSpindle = 0.0;  // r/min; 0: none
    int spin = 0;              // 1 M3, -1 M4
    int tool = 0, selectedTool = 0;
    bool hasFlood = false, hasMist = false;
  };

  ProgramMachine(const ProgramSetup& setup, ToolPath& path);

  Modal modal;

  // mm in one unit of the program.
  double unit() const { return modal.isInch ? kInch : 1.0; }
  double radius(double x) const { return unit() * (modal.isDiameter ? 0.5 * x : x); }

  const ProfilePoint& at() const { return m_at; }  // programmed position, without compensation
  bool isCompensated() const { return m_compensation.isOn(); }

  // Moves. A feed without speed or feed rate is refused (ProgramRefusal).
  void rapid(const ProfilePoint& to, const SourceLocation& location) { straight(ToolMove::Kind::Rapid, to, location); }
  void feed(const ProfilePoint& to, const SourceLocation& location) { straight(ToolMove::Kind::Feed, to, location); }
  void arc(int turn, const ProfilePoint& to, const ProfilePoint& centre, const SourceLocation& location);
  // A pass of a thread. pitch: mm along the move for each revolution.
  void thread(const ProfilePoint& to, double pitch, const SourceLocation& location);
  void dwell(double seconds, const SourceLocation& location);

  // side: 1 left, -1 right of the contour. radius: mm; 0 switches nothing on.
  void compensate(int side, double radius, const ProfilePoint& tip, const SourceLocation& location);
  void endCompensation();
  // Sets the centre of the nose for the next corner.
  void placeNose(const ProfilePoint& centre) { m_compensation.placeNose(planePoint(centre)); }

  // Converts a point of the machine's own system, whose zero is the reference, to the coordinates of the program.
  ProfilePoint fromMachine(const ProfilePoint& p) const { return p - m_systems[m_system] - m_shift - m_toolOffset; }
  ProfilePoint toMachine(const ProfilePoint& p) const { return p + m_systems[m_system] + m_shift + m_toolOffset; }
  std::array<ProfilePoint, 2> home{ProfilePoint(0, 0), ProfilePoint(0, 0)};  // G28 and G30, in machine coordinates

  void selectSystem(int index);
  int system() const { return m_system; }
  const ProfilePoint& systemOffset(int index) const { return m_systems[index]; }
  void setSystem(int index, const ProfilePoint& offset);
  const ProfilePoint& shift() const { return m_shift; }
  void setShift(const ProfilePoint& shift);  // G92, G52; the tool stays where it is
  void changeTool(int number);
  const ProfilePoint& toolOffset() const { return m_toolOffset; }
  // number: entry of the tool table that the offset is from; -1: none.
  void setToolOffset(const ProfilePoint& offset, int number);
  void addTime(double seconds) { m_path.time += seconds; }

 private:
  void straight(ToolMove::Kind kind, const ProfilePoint& to, const SourceLocation& location);
  ToolMove moveOf(ToolMove::Kind kind, double length, const SourceLocation& location) const;
  void go(const NoseCompensation::Step& step);        // through compensation
  void emitStep(const NoseCompensation::Step& step);  // the path of the tip
  ProfilePoint partPoint(const ProfilePoint& p) const {
    return p + m_systems[m_system] + m_shift + m_setup.reference + (m_toolOffset - tipOffset());
  }
  ProfilePoint tipOffset() const;  // from the post to the tip of the mounted tool
  int mounted() const;             // entry of the mounted tool in the table

  const ProgramSetup& m_setup;
  ToolPath& m_path;
  NoseCompensation m_compensation;
  std::array<ProfilePoint, kSystems> m_systems;
  int m_system = 0;
  ProfilePoint m_shift{0, 0}, m_toolOffset{0, 0};
  int m_offsetNumber = -1;       // entry of m_toolOffset in the table
  ProfilePoint m_at{0, 0};       // programmed
  ProfilePoint m_tip{0, 0};      // position of the tip, in the same coordinates
  bool m_needsStraight = false;  // the move after compensation must be straight
};

}  // namespace handwheel
