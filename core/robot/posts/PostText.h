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

// A number with so many digits behind the point, in the C locale; never "-0".
std::string fixedText(double value, int digits);
// Numbers like this, with commas between them.
std::string fixedList(std::span<const double> values, int digits);

// A name that the language takes: letters, digits and underscores, a letter first, at most so long. Where it is cut,
// the number at its end stays, or one is added that other names hardly have ("Process 2" within 8: "Proces_2").
std::string identifierOf(const std::string& name, std::size_t longest);

// The same with a number that other names hardly have.
std::string identifierWithDigits(const std::string& name, std::size_t longest);

// The same, beside words that the language has itself, in lower case: such a name gets "_path" behind it.
std::string identifierBeside(std::span<const char* const> words, const std::string& name, std::size_t longest);
std::string lowerCase(std::string text);  // of ASCII

// The same of the program's frame. Different frames of the cell have different ones, whatever the case of letters: with
// a number that other names hardly have, where they would be the same.
std::string frameIdentifier(const RobotProgram& program, std::span<const char* const> words, std::size_t longest);

// What a program that is read calls a frame or a place. Shortened where it is longer than any language allows, as each
// motion keeps it.
std::string readName(std::string_view name);

// Turns about z, y and x, in this order about axes that move along (KUKA's A, B, C; Fanuc's R, P, W); rad. Where two
// axes are in line the last is 0.
Vec3 zyxAngles(const Eigen::Matrix3d& turn);
Eigen::Matrix3d fromZyx(const Vec3& angles);

// Whether a program has straight lines of the tool. Joint motions are written as joint values, which no frame moves.
bool hasLines(const RobotProgram& program);
// What was proven of a program, and where that begins: sentences. Empty: nothing was.
std::vector<std::string> proofRemarks(const RobotProgram& program);
// The clearance that a program of any language says in such a remark to keep, mm; none where it does not. O(text).
std::optional<double> keptClearance(std::string_view text);
// What is said of a program in comments at its head: the robot, what was assumed, what was proven, and what was not.
std::vector<std::string> headRemarks(const RobotProgram& program);

// Whether there are lines by poses, and the base may not be the one that the controller counts from.
bool needsControllersBase(const RobotProgram& program);

// The joints of a program's arm in degrees.
std::vector<double> degreesOf(const ArmValues& values);
ArmValues radiansOf(std::span<const double> degrees);

// Where a pose of a program leads, in the frame of `program` and of its tool: the pose of the tool's centre point of
// another tool (in the flange), in another frame (in the base).
Pose placeIn(const RobotProgram& program, const Pose& frame, const Pose& place, const Pose& tool);

// That a statement is not read, which may move the robot: StatementUnread {its beginning}.
Error unread(std::string_view statement, std::size_t line);

// Whether NAME( outside of quotes calls anything but these functions, which do nothing but compute, or words of the
// language before brackets; these in lower case.
bool callsOther(std::string_view text, std::span<const char* const> harmless);

// The parts between the commas that are in no brackets.
std::vector<std::string_view> argumentsOf(std::string_view text);

// The number that a text is; none: it is more than a number, as "2*n", or none.
std::optional<double> numberAlone(std::string_view text);

// Takes apart a line of a program. Words are compared without case.
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
  // Numbers in brackets, at most so many: "[1,2,3]"; brackets within are passed over.
  std::optional<std::vector<double>> numbersWithin(char open, char close, std::size_t most);
  Error malformed(const char* element, const char* reason) const;

 private:
  std::string_view m_rest;
  std::size_t m_line;
};

// Error: FileTooLarge, beyond PostProcessor::kLargestText.
Status checkTextSize(std::string_view text);
// The lines of a text without what follows a comment sign outside of quotes; empty: there is no such sign. Error:
// FileTooLarge.
Result<std::vector<std::string_view>> programLines(std::string_view text, std::string_view comment);

}  // namespace handwheel
