// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/PostText.h"
#include "robot/posts/RapidStatements.h"

#include <map>

namespace handwheel {

// Returns true if a text of RAPID calls a function. It may be a routine that moves the robot.
bool callsRapidRoutine(std::string_view text);

// The data that a RAPID module declares. Names are not case-sensitive.
class RapidTables {
 public:
  explicit RapidTables(const RobotProgram& program);

  // Reads a declaration. Others than those of targets, speeds, zones, tools and frames are kept as lines.
  Status readData(const RapidData& data);

 protected:
  using Numbers = std::vector<double>;
  using Table = std::map<std::string, Numbers>;  // by names in lower case

  bool isData(const std::string& name) const;  // name: in lower case

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
  Table m_jointTargets, m_robTargets, m_speeds;
  std::map<std::string, std::optional<Pose>> m_tools, m_frames;  // none: unusable
  std::map<std::string, std::optional<double>> m_zones;          // likewise; mm
  std::map<std::string, std::optional<double>> m_numbers;        // constants; likewise
  std::vector<ProgramLine> m_before;                             // lines before the first motion

 private:
  // Adds the frames of the cell, under the names in modules of its paths. Those of the file take precedence.
  void addKnownFrames();
  // Reads "num height:=50". Routines may have different numbers of one name: then the number is not known.
  void readNumber(LineReader line);
  // Reads a zone: [FALSE,10,…] in mm, [TRUE,…], which is an exact stop, as 0; none: it is not understood.
  static std::optional<double> zoneFrom(LineReader& line);
  // Reads a zone. Routines may have different zones of one name: then the zone is not known.
  Status readZone(LineReader& line);
  // Reads the pose of a tool [TRUE,[pose],[load]] in the flange; none, if the robot does not hold it.
  Status readTool(LineReader& line);
  // Reads the pose of a frame [FALSE,TRUE,"",[pose],[pose]] in the base; none, if it moves.
  Status readFrame(LineReader& line);
};

}  // namespace handwheel
