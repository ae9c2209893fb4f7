// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/KeptLines.h"
#include "robot/posts/PostText.h"
#include "robot/posts/RapidDeclarations.h"

namespace handwheel {

// Returns true if a text of RAPID calls a function. It may be a routine that moves the robot.
bool callsRapidRoutine(std::string_view text);

// The data that RAPID modules declare. Names are not case-sensitive, and mean what they mean in the scope of the
// present statement.
class RapidTables {
 public:
  RapidTables(const RobotProgram& program, std::vector<RapidScope> scopes);

  // Reads a declaration. Those of targets, speeds, zones, tools, frames and records are kept if a kept line names them,
  // others always.
  Status readData(const RapidData& data);

 protected:
  using Numbers = std::vector<double>;

  void setScope(std::size_t scope) { m_scope = scope; }
  RapidName named(std::string_view name) const { return m_declarations.resolved(m_scope, folded(name)); }
  bool isData(std::string_view name) const;

  // Returns the value of "50", "-height": a number, or a constant of the module.
  std::optional<double> numberIn(std::string_view text) const;
  // Returns the frame of "tool" or "tool\WObj:=frame"; none: it is not known.
  std::optional<Pose> frameIn(std::string_view text) const;
  // Returns the name of the frame in the text; empty: the base.
  static std::string frameNameIn(std::string_view text);
  static std::optional<Pose> poseFrom(const Numbers& numbers);
  // Reads a blend: "z10", "[FALSE,10,…]", a name of the file; "z10\Z:=8". 0 for fine.
  Result<double> blendFrom(std::string_view text, std::size_t number) const;

  const RobotProgram& m_program;
  RapidTable<Numbers> m_jointTargets, m_robTargets, m_speeds;
  RapidTable<Pose> m_tools, m_frames;
  RapidTable<double> m_zones;    // mm
  RapidTable<double> m_numbers;  // constants
  RapidDeclarations m_declarations;

 private:
  // Adds the frames of the cell, under the names in modules of its paths. Those of the file take precedence.
  void addKnownFrames();
  // Reads a zone: [FALSE,10,…] in mm, [TRUE,…], which is an exact stop, as 0; none: it is not understood.
  static std::optional<double> zoneFrom(LineReader& line);
  // Reads the pose of a tool [TRUE,[pose],[load]] in the flange; none, if the robot does not hold it.
  static std::optional<Pose> toolFrom(LineReader& line);
  // Reads the pose of a frame [FALSE,TRUE,"",[pose],[pose]] in the base; none, if it moves.
  static std::optional<Pose> frameFrom(LineReader& line);

  std::size_t m_scope = RapidStatements::kShared;  // scope of the present statement
};

}  // namespace handwheel
