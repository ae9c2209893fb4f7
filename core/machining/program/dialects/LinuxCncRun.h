// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramRun.h"

namespace handwheel {

// A run of a program for LinuxCNC 2.9. The words of a line are executed in the order of the section "Order of
// Execution" of the LinuxCNC documentation.
class LinuxCncRun : public ProgramRun {
 public:
  using ProgramRun::ProgramRun;

  // The modal groups of G codes. A line has at most one code of each group.
  enum Group {
    NonModal,
    Motion,
    Plane,
    Distance,
    ArcDistance,
    Feed,
    Units,
    Nose,
    ToolLength,
    Return,
    System,
    Path,
    Spindle,
    Lathe,
    InMachine,
    kGroups
  };
  struct Code {
    int tenths;  // number of the code in tenths, 921 for G92.1
    Group group;
  };

 protected:
  void readLine(std::uint32_t i, ProgramScanner& scanner) override;
  void obeyComment(std::uint32_t i, const ProgramScanner& scanner) override;
  std::optional<ProgramValue> systemVariable(int number, const SourceLocation& location) const override;
  std::optional<double> systemVariable(const std::string& name) const override;

 private:
  using Keyword = ProgramOutline::Keyword;
  struct Drilling {
    double depth = 0.0, retract = 0.0, peck = 0.0, dwell = 0.0;  // mm, s
  };

  // Functions for the flow of control
  void runStatement(std::uint32_t i, const ProgramOutline::Statement& statement);
  void runBranch(std::uint32_t i, const ProgramOutline::Statement& statement);
  void runLoop(std::uint32_t i, const ProgramOutline::Statement& statement);
  void leaveLoop(std::uint32_t i, const ProgramOutline::Statement& statement, bool isAgain);
  void beginCall(const ProgramOutline::Statement& statement, ProgramScanner& scanner, const SourceLocation& location);
  void takeReturned(ProgramScanner& scanner);
  double condition(std::uint32_t i, const ProgramOutline::Statement& statement);

  // Functions for words
  void execute(const ProgramBlock& block);
  void sortCodes(const ProgramBlock& block);
  const ProgramWord* code(int group) const { return m_codes[static_cast<std::size_t>(group)]; }
  int codeOf(int group) const;  // number of the code in tenths; -1: none
  void setFeedAndSpeed(const ProgramBlock& block);
  void runToolAndSpindle(const ProgramBlock& block);
  void runModes();
  void runModes2();
  void compensation(int tenths, const ProgramWord& g);
  void toolLength(int tenths, const ProgramWord& g);
  void runNonModal(int tenths, const ProgramWord& g);
  void home(int tenths, const ProgramWord& g);
  void setOffsets(int tenths, const ProgramWord& g);
  void setCoordinates(const ProgramWord& g);
  void runMotion(const ProgramBlock& block);
  void move(int tenths, const SourceLocation& location);
  void straightInMachine(int tenths, const ProgramWord& g);
  void runStops(const ProgramBlock& block);
  ProfilePoint target();

  // Functions for cycles
  void contourCycle(int tenths, const ProgramWord& g);
  void collect(const ProgramBlock& block);
  void threadCycle(const ProgramWord& g);
  void drill(int tenths, const SourceLocation& location);

  std::array<const ProgramWord*, kGroups> m_codes{};
  Drilling m_drilling;
  double m_returned = 0.0;          // value returned by the last subprogram
  ProfilePoint m_savedShift{0, 0};  // shift of G92 that G92.2 saved
};

}  // namespace handwheel
