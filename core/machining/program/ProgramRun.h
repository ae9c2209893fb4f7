// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/program/ProgramBlock.h"
#include "machining/program/ProgramMachine.h"
#include "machining/program/ProgramOutline.h"
#include "machining/program/cycles/ContourCycle.h"

namespace handwheel {

// A run of a program, the base class of the runs of both dialects. Its functions throw ProgramRefusal.
class ProgramRun {
 public:
  ProgramRun(std::string_view text, const ProgramSetup& setup, Progress progress);
  virtual ~ProgramRun() = default;
  ProgramRun(const ProgramRun&) = delete;
  ProgramRun& operator=(const ProgramRun&) = delete;

  ToolPath run();

 protected:
  static constexpr std::size_t kDeepest = 100;  // limit of nested calls
  static constexpr std::uint32_t kNone = ProgramOutline::kNone;

  // The modes that M70 saves.
  struct SavedModes {
    ProgramMachine::Modal modal;
    int system = 0;
  };

  struct Frame {
    std::uint32_t returnTo = 0;
    std::uint32_t begin = 0;  // first line of the subprogram
    int repeats = 0;          // remaining repeats of the whole subprogram
    bool hasOwnVariables = true;
    std::map<std::uint32_t, int> loops;  // remaining runs of each repeat loop
    std::optional<SavedModes> saved;
    bool restores = false;  // restores the saved modes on return
  };

  // Executes one line that is not empty and not skipped.
  virtual void readLine(std::uint32_t i, ProgramScanner& scanner) = 0;
  // Does what a comment of a line tells, before the line is executed.
  virtual void obeyComment(std::uint32_t, const ProgramScanner&) {}
  // Return the value of a variable of the machine, or nothing if it is none of the machine's.
  virtual std::optional<ProgramValue> systemVariable(int, const SourceLocation&) const { return {}; }
  virtual std::optional<double> systemVariable(const std::string&) const { return {}; }
  // Sets a variable of the machine. Returns false if the machine does not take it.
  virtual bool setSystemVariable(const ProgramAssignment&) { return false; }

  void runTo(std::uint32_t end);
  // Runs a subprogram to its end while a block is executed. The block then continues.
  void runInside(std::uint32_t begin, const SourceLocation& location);
  void runLines(std::uint32_t begin, std::uint32_t end);
  // Runs the next lines, at most a number of them, until there is enough, while a block is executed. The block then
  // continues. The caller restores what the lines have changed.
  void runAhead(int most, const std::function<bool()>& isEnough);
  void call(std::uint32_t begin, const std::vector<ProgramValue>& arguments, int repeats, bool hasOwnVariables,
            const SourceLocation& location);
  void returnFromCall();
  // Restores all modes but the motion, the tool, the selected tool, and the coordinate system.
  void restoreModes(const SavedModes& saved);
  [[noreturn]] static void refuseMissingReturn(const SourceLocation& location);
  ProgramValue valueIn(ProgramScanner& scanner) {
    return ProgramExpression(scanner, m_variables, m_setup.dialect).value();
  }

  // Begins a block. A word of the block counts as understood once it is read.
  void begin(const ProgramBlock& block);
  const ProgramWord* word(char letter);
  bool has(char letter) const { return m_block->has(letter); }
  double number(char letter, double otherwise);
  double needed(char letter, const ProgramWord& code, const char* meaning);
  int whole(const ProgramWord& word, int least, int most) const;
  void refuseUnread() const;

  // Reads the centre of an arc from I, K or R.
  PlanePoint arcCentre(const PlanePoint& from, const PlanePoint& to, int turn, bool isAbsolute,
                       const SourceLocation& location);
  // Returns the position from which the next words count, mm: that of the tool, or in a contour the contour's end.
  ProfilePoint position() const { return m_contour ? profilePoint(m_machine.unit() * m_contourEnd) : m_machine.at(); }
  void setSpindle(double speed);
  bool runCommonM(int code, const ProgramWord& m);
  void note(const SourceLocation& location, std::string text);
  CycleOutput cycleOutput(const SourceLocation& location, double unit);

  const ProgramSetup& m_setup;
  Progress m_progress;
  ToolPath m_path;
  ProgramOutline m_outline;
  ProgramVariables m_variables;
  ProgramMachine m_machine;
  CycleBudget m_cycleBudget;
  std::vector<Frame> m_frames;
  std::uint32_t m_next = 0;  // next line to be executed
  bool m_isDone = false;
  std::vector<ContourSegment>* m_contour = nullptr;  // if not null, moves are collected in this contour and not made
  PlanePoint m_contourEnd;

 private:
  void step();
  const ProgramBlock* m_block = nullptr;
  std::uint32_t m_read = 0;  // letters of the block that were read, as bits
};

}  // namespace handwheel
