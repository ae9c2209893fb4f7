// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramRun.h"

namespace handwheel {

// A run of a program for a lathe with a Fanuc control. G-code system A (X and Z absolute, U and W relative to the tool,
// G90, G92 and G94 are cycles), Macro B as far as docs/programs.md describes. X and U are diameters; I, K and R are
// not.
class FanucRun : public ProgramRun {
 public:
  FanucRun(std::string_view text, const ProgramSetup& setup, Progress progress);

  // The groups of G codes: a line has at most one of each, except for the codes for this line alone.
  enum Group { Once, Motion, Spindle, FeedMode, Units, Nose, Drilling, System, Other, kGroups };
  struct Code {
    int number;
    Group group;
  };

 protected:
  void readLine(std::uint32_t i, ProgramScanner& scanner) override;
  std::optional<ProgramValue> systemVariable(int number) const override;

 private:
  // The values that the first of two lines of a cycle sets, in mm.
  struct CycleSettings {
    double depth = 1.0, retract = 0.5;        // G71, G72
    ProfilePoint relief{0, 0};                // G73: (r, z)
    int passes = 1;                           // G73
    double peckRetract = 0.5;                 // G74, G75
    int threadPasses = 1, threadChamfer = 0;  // G76: passes at the last depth; tenths of the lead
    double threadAngle = 60.0, threadLeast = 0.0, threadLast = 0.0;
  };

  // The values of G81 to G83, in mm and s.
  struct DrillSettings {
    std::optional<double> depth;  // z
    double retract = 0.0;         // relative to the tool
    double peck = 0.0, dwell = 0.0;
  };

  // Macro B.
  void beginProgram(const SourceLocation& location);
  bool runMacro(std::uint32_t i, ProgramScanner& scanner);
  void runLoop(const ProgramOutline::Statement& statement, std::uint32_t i);
  void goTo(std::uint32_t i, ProgramScanner& scanner);
  void callMacro(const ProgramBlock& block, const ProgramWord& g);

  // Words.
  void execute(const ProgramBlock& block);
  void sortCodes(const ProgramBlock& block);
  const ProgramWord* code(int group) const { return m_codes[static_cast<std::size_t>(group)]; }
  int codeOf(int group) const;  // -1: none
  void runModes();
  void setTool();
  void setSpindleMode();
  void compensation(int number, const ProgramWord& g);
  void runM(const ProgramBlock& block, bool isAfterMotion);
  void runOnce(const ProgramBlock& block, int number, const ProgramWord& g);
  void home(int number, const ProgramWord& g);
  void setCoordinates(const ProgramWord& g);
  void moveInMachine(const ProgramWord& g);
  void runMotion(const ProgramBlock& block);
  void arc(int turn, const SourceLocation& location);
  double lead(const ProgramWord& code);                       // mm; F of a thread
  static double alongPath(const ProfilePoint& displacement);  // mm along the path for one mm along its longer axis
  void boxCycle(int number, const SourceLocation& location);
  void drill(int number, const SourceLocation& location);
  bool hasAxis() const { return has('X') || has('U') || has('Z') || has('W'); }
  ProfilePoint target();  // in mm, from X or U, Z or W
  // Returns a length; without a decimal point it is in the least increment: 0.001 mm or 0.0001 inch.
  double increment(const ProgramWord& w) const;

  // A cycle over a contour between two line numbers.
  struct Contour {
    std::uint32_t begin = 0, end = 0;  // lines
    std::vector<ContourSegment> segments;
  };
  Contour contourOf(const ProgramWord& g);
  void collect(const ProgramBlock& block);
  void finish(const ProgramWord& g);
  void rough(int number, const ProgramWord& g);
  void repeatPattern(const ProgramWord& g);
  void peck(int number, const ProgramWord& g);
  void threadCycle(const ProgramWord& g);
  void goBehind(const Contour& contour);

  std::array<const ProgramWord*, kGroups> m_codes{};
  CycleSettings m_cycle;
  DrillSettings m_drilling;
  std::optional<double> m_surfaceSpeed;  // S of the last G96
  ProfilePoint m_boxTarget{0, 0};        // modal, for G90, G92, G94
  double m_boxTaper = 0.0;
  std::size_t m_contourCuts = 0;  // segments of m_contour up to the last that is not rapid
  bool m_hasProgram = false;      // its number was read
};

}  // namespace handwheel
