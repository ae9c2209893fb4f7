// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramRun.h"
#include "machining/program/cycles/CornerPiece.h"

#include <ctime>

namespace handwheel {

// A run of a program for a lathe with a Fanuc control. It supports G-code system A, in which X and Z are absolute, U
// and W are relative to the tool, and G90, G92 and G94 are cycles, and the part of Macro B that docs/programs.md
// describes. X and U are diameters; I, K and R are not.
class FanucRun : public ProgramRun {
 public:
  FanucRun(std::string_view text, const ProgramSetup& setup, Progress progress);

  // The groups of G codes. A line has at most one code of each group, except for `Once`, the codes that apply to one
  // line only.
  enum Group { Once, Motion, Spindle, FeedMode, Units, Nose, Drilling, System, Other, kGroups };
  struct Code {
    int number;
    Group group;
  };

 protected:
  void readLine(std::uint32_t i, ProgramScanner& scanner) override;
  std::optional<ProgramValue> systemVariable(int number, const SourceLocation& location) const override;
  bool setSystemVariable(const ProgramAssignment& set) override;

 private:
  // The values that the first line of a cycle of two lines sets. Lengths are in mm.
  struct CycleSettings {
    double depth = 1.0, retract = 0.5;        // for G71 and G72
    ProfilePoint relief{0, 0};                // for G73, (r, z)
    int passes = 1;                           // for G73
    double peckRetract = 0.5;                 // for G74 and G75
    int threadPasses = 1, threadChamfer = 0;  // for G76; number of passes at the last depth, and tenths of the lead
    double threadAngle = 60.0, threadLeast = 0.0, threadLast = 0.0;
    // True if a line has set the values, or a note has told them.
    bool isDepthKnown = false, isRetractKnown = false, isPatternKnown = false, isPeckKnown = false,
         isThreadKnown = false;
  };

  // The values of G81 to G83. Lengths are in mm, times in s.
  struct DrillSettings {
    std::optional<double> depth;  // z of the bottom
    double retract = 0.0;         // relative to the tool
    double peck = 0.0, dwell = 0.0;
  };

  // The state of the control that variables of the machine show, besides that of ProgramMachine.
  struct Control {
    std::time_t begin = 0;  // time at the beginning of the run
    double jumps = 0.0;     // count of jumps back; each takes a millisecond of #3001, so that loops that wait end
    double timerZero = 0.0, hoursZero = 0.0;  // values of the clocks at which #3001 and #3002 were 0
    double singleBlock = 0.0, feedHold = 0.0;
    double parts = 0.0, partsWanted = 0.0;
    double speed = 0.0, tool = 0.0, lastM = 0.0, sequence = 0.0;  // last S, T, M and N
    int nose = 40, path = 64;                                     // last G code of these groups
    int program = 0;                                              // O number of the main program
  };

  // Functions for variables of the machine
  std::optional<ProgramValue> offsetVariable(int number) const;
  std::optional<ProgramValue> controlVariable(int number) const;
  std::optional<ProgramValue> modalVariable(int number) const;
  std::optional<ProgramValue> positionVariable(int number) const;
  ProgramValue lengthValue(const ProfilePoint& p, int axis) const;
  double timer() const;  // ms
  double programNumber() const;
  bool setZeroPoint(const ProgramAssignment& set);

  // Functions for Macro B
  void beginProgram(const ProgramOutline::Statement& head, const SourceLocation& location);
  bool runMacro(std::uint32_t i, ProgramScanner& scanner);
  void runLoop(const ProgramOutline::Statement& statement, std::uint32_t i);
  void goTo(std::uint32_t i, ProgramScanner& scanner);
  void callMacro(const ProgramBlock& block, const ProgramWord& g);

  // Functions for words
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
  void threadPass(const ProfilePoint& to, double measured, const ProfilePoint& start, const SourceLocation& location);
  double lead(const ProgramWord& code);                       // mm, the lead that F gives for a thread
  static double alongPath(const ProfilePoint& displacement);  // mm of path for 1 mm along its longer axis
  void boxCycle(int number, const SourceLocation& location);
  void drill(int number, const SourceLocation& location);
  bool hasAxis() const { return has('X') || has('U') || has('Z') || has('W'); }
  ProfilePoint target();  // mm, the point that X or U and Z or W give
  // Returns the length (mm) that a word gives. A number without a decimal point is a multiple of the least increment,
  // 0.001 mm or 0.0001 inch.
  double increment(const ProgramWord& w) const;
  void scaleIncrements(ProgramBlock& block) const;
  void require(bool isRight, const ProgramWord& w, const char* what) const;

  // A chamfer or rounding at the end of a cut.
  static constexpr int kAnyAxis = -1;
  struct Corner {
    const ProgramWord* word = nullptr;
    CornerSize size;      // mm
    int axis = kAnyAxis;  // axis of the next cut, in the direction of the word's sign; 0: X, 1: Z
  };
  struct ContourCorner {
    std::size_t segment;  // index of the segment before the corner
    Corner corner;
    ProgramWord word;
  };
  std::optional<Corner> cornerOf(int motion);
  ContourSegment pieceOf(const Corner& corner, ContourSegment& before, ContourSegment& after) const;
  ContourSegment moveAfter(const PlanePoint& corner, const ProgramWord& w);
  [[noreturn]] static void refuseLonely(const ProgramWord& w);
  void cut(int motion, const SourceLocation& location);
  static bool isUsedUp(const ContourSegment& segment);
  void finishCorners(std::vector<ContourSegment>& segments);

  // The contour of a cycle, which the lines between two line numbers give.
  struct Contour {
    std::uint32_t begin = 0, end = 0;  // first and last line
    std::vector<ContourSegment> segments;
    bool namesBoth = false;  // the first line names X and Z, so roughing is of type II
  };
  Contour contourOf(const ProgramWord& g);
  void collect(const ProgramBlock& block);
  void finish(const ProgramWord& g);
  void rough(int number, const ProgramWord& g);
  void repeatPattern(const ProgramWord& g);
  void peck(int number, const ProgramWord& g);
  void threadCycle(const ProgramWord& g);
  void goBehind(const Contour& contour);
  void tellUnset(bool& isKnown, const ProgramWord& g, const std::string& values);

  std::array<const ProgramWord*, kGroups> m_codes{};
  Control m_control;
  std::optional<ProfilePoint> m_corner;       // corner from which the next cut counts; the tool is beside it
  const ProgramWord* m_cornerWord = nullptr;  // corner whose next cut is looked for; null: none
  std::vector<ContourCorner> m_corners;       // corners of the contour that is collected
  std::optional<bool> m_namesBoth;            // the first line of the contour that is collected names X and Z
  std::optional<bool> m_chamfersThreads;      // M23 or M24
  CycleSettings m_cycle;
  DrillSettings m_drilling;
  std::optional<double> m_surfaceSpeed;  // S of the last G96
  ProfilePoint m_boxTarget{0, 0};        // modal target of G90, G92 and G94
  double m_boxTaper = 0.0;
  std::size_t m_contourCuts = 0;  // number of segments of m_contour up to the last one that is not rapid
  bool m_hasProgram = false;      // the number of the program was read
};

}  // namespace handwheel
