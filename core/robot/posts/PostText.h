// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"
#include "base/Units.h"
#include "robot/posts/PostProcessor.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Formats a number with so many decimal digits, in the C locale; never "-0".
std::string fixedText(double value, int digits);
// Formats numbers in this format, with commas between them.
std::string fixedList(std::span<const double> values, int digits);

// Returns a name that the language accepts: letters, digits and underscores, a letter first, at most `longest`. If it
// is cut, the number at its end stays, or one is added that makes collisions unlikely ("Process 2" within 8:
// "Proces_2").
std::string identifierOf(const std::string& name, std::size_t longest);

// Returns the same with a number that makes collisions unlikely.
std::string identifierWithDigits(const std::string& name, std::size_t longest);

// Returns an identifier that is none of the words of the language, in lower case: such a name gets the suffix "_path".
std::string identifierBeside(std::span<const char* const> words, const std::string& name, std::size_t longest);
std::string lowerCase(std::string text);  // ASCII only

// Returns the identifier of the program's frame. Different frames of the cell have different ones, ignoring the case of
// letters: a number is added if they would be the same.
std::string frameIdentifier(const RobotProgram& program, std::span<const char* const> words, std::size_t longest);

// Returns the name of a frame or a waypoint in a program. Shortened if it is longer than any language allows, as each
// motion stores it.
std::string readName(std::string_view name);

// Returns the rotations about z, y and x, in this order about moving axes (KUKA's A, B, C; Fanuc's R, P, W); rad. If
// two axes are in line the last is 0.
Vec3 zyxAngles(const Eigen::Matrix3d& turn);
Eigen::Matrix3d fromZyx(const Vec3& angles);

// Returns true if a program has straight lines of the tool. Joint motions are written as joint values, which no frame
// moves.
bool hasLines(const RobotProgram& program);
// Returns sentences on the proof of a program, and its first waypoint. Empty: nothing was proven.
std::vector<std::string> proofRemarks(const RobotProgram& program);
// Returns the clearance in such a remark of a program in any language, mm; none if there is no remark. O(text).
std::optional<double> keptClearance(std::string_view text);
// Returns the comments at the head of a program: the robot, assumptions, proofs and limitations.
std::vector<std::string> headRemarks(const RobotProgram& program);

// Returns true if there are lines by poses, and the base may not be that of the controller.
bool needsControllersBase(const RobotProgram& program);

// Returns the joints of a program's arm in degrees.
std::vector<double> degreesOf(const ArmValues& values);
ArmValues radiansOf(std::span<const double> degrees);

// Transforms a pose of a program into the frame and tool of `program`. tool: the tool's centre point of the pose, in
// the flange; frame: its frame, in the base.
Pose poseInProgram(const RobotProgram& program, const Pose& frame, const Pose& pose, const Pose& tool);

// Returns the error for a statement that is not read and may move the robot: StatementUnread {its beginning}.
Error unread(std::string_view statement, std::size_t line);

// Returns true if NAME( outside quotes calls anything but these functions, which only compute, or words of the language
// before brackets; these in lower case.
bool callsOther(std::string_view text, std::span<const char* const> harmless);

// Splits a text at the commas that are in no brackets.
std::vector<std::string_view> argumentsOf(std::string_view text);

// Returns the number that a text consists of; none: it is more than a number, as "2*n", or none.
std::optional<double> numberAlone(std::string_view text);

// Parses a line of a program. Words are compared without case.
class LineReader {
 public:
  LineReader(std::string_view text, std::size_t line) : m_rest(text), m_line(line) {}

  void skipSpace();
  void skip(std::size_t characters) { m_rest.remove_prefix(std::min(characters, m_rest.size())); }
  bool take(std::string_view word);      // if it comes next
  bool takeWord(std::string_view word);  // likewise, and no letter or digit follows
  std::optional<double> number();        // finite
  std::string_view name();               // letters, digits, underscores; empty: none
  std::string_view rest() const { return m_rest; }
  // Reads numbers in brackets, at most `most`: "[1,2,3]"; nested brackets are ignored.
  std::optional<std::vector<double>> numbersWithin(char open, char close, std::size_t most);
  Error malformed(const char* element, const char* reason) const;

 private:
  std::string_view m_rest;
  std::size_t m_line;
};

// Errors: FileTooLarge, beyond PostProcessor::kLargestText.
Status checkTextSize(std::string_view text);
// Returns the lines of a text without comments, which begin with a sign outside quotes; empty: there is no such sign.
// Errors: FileTooLarge.
Result<std::vector<std::string_view>> programLines(std::string_view text, std::string_view comment);

}  // namespace handwheel
