// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"
#include "base/Units.h"
#include "robot/posts/PostProcessor.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Formats a number with this number of decimal digits, in the C locale. The result is never "-0".
std::string fixedText(double value, int digits);
// Formats numbers as fixedText() does, with commas between them.
std::string fixedList(std::span<const double> values, int digits);

// Returns an identifier made from a name: letters, digits and underscores, with a letter first, at most `longest`
// characters. If the name is cut, the number at its end is kept, or a number is added that makes collisions unlikely:
// "Process 2" becomes "Proces_2" if 8 characters are allowed.
std::string identifierOf(const std::string& name, std::size_t longest);

// Returns the identifier of a name with an added number that makes collisions unlikely.
std::string identifierWithDigits(const std::string& name, std::size_t longest);

// Returns the identifier of a name. It gets the suffix "_path" if it is one of these words of the language. words: in
// lower case.
std::string identifierBeside(std::span<const char* const> words, const std::string& name, std::size_t longest);
std::string lowerCase(std::string text);  // ASCII only

// Returns the identifier of the program's frame. A number is added if the identifier is a word of the language, or if
// another frame of the cell would have the same one, regardless of case.
std::string frameIdentifier(const RobotProgram& program, std::span<const char* const> words, std::size_t longest);

// Returns the name of a frame or a waypoint in a program. A name that is longer than any language allows is shortened,
// as each motion stores the name.
std::string readName(std::string_view name);

// Converts between a rotation and its angles about z, y and x, in this order about moving axes (KUKA's A, B, C; Fanuc's
// R, P, W); rad. If two axes are in line the last angle is 0.
Vec3 zyxAngles(const Eigen::Matrix3d& turn);
Eigen::Matrix3d fromZyx(const Vec3& angles);

// Returns true if a program has straight lines of the tool. Only these depend on the frame: joint motions are written
// as joint values.
bool hasLines(const RobotProgram& program);
// Returns sentences for a program: the clearance that its motions are proven to keep, and that the way to its first
// waypoint is not checked. The result is empty if nothing was proven.
std::vector<std::string> proofRemarks(const RobotProgram& program);
// Returns the clearance, mm, that a remark of proofRemarks() states in a program in any language; nothing if the text
// has no such remark. O(text).
std::optional<double> keptClearance(std::string_view text);
// The last of the comments of headRemarks(), by which readers recognise programs that this program wrote.
inline constexpr const char* kWrittenByUs = "Written by Handwheel.";
// Returns the comments at the head of a program: the robot, assumptions, proofs and limitations.
std::vector<std::string> headRemarks(const RobotProgram& program);

// Returns true if the program has lines to poses and its base may differ from that of the controller.
bool needsControllersBase(const RobotProgram& program);

// Convert joint values of a program's arm between radians and degrees.
std::vector<double> degreesOf(const ArmValues& values);
ArmValues radiansOf(std::span<const double> degrees);

// Transforms a pose of a program into the frame and tool of `program`. tool: the tool's centre point of the pose, in
// the flange; frame: the frame of the pose, in the base.
Pose poseInProgram(const RobotProgram& program, const Pose& frame, const Pose& pose, const Pose& tool);

// Returns the error of a statement that is not read and may move the robot: StatementUnread {beginning of the
// statement}.
Error unread(std::string_view statement, std::size_t line);

// Returns a line of a program that goes with a waypoint, without space at its ends.
ProgramLine keptLine(ProgramLine::Kind kind, std::string_view text, std::size_t line, bool mayGrip = false);
// Returns the text of such a line: a comment after the sign of the language.
std::string keptText(const ProgramLine& line, const char* commentSign);
// Returns the lines of a program, each with this indentation and ending; comments after the sign of the language. Lines
// without a text are omitted.
std::string keptTexts(const std::vector<ProgramLine>& lines, const char* indent, const char* commentSign,
                      const char* ending);

// Returns the names in a text outside quotes, in lower case, with a "$" that stands before them. Components (".x") and
// the names of arguments ("\MaxTime") are omitted.
std::vector<std::string> namesIn(std::string_view text);
// Returns the text with other names in the same places. renamed: gets such a name, and returns the new one; empty: it
// remains.
std::string withNames(std::string_view text, const std::function<std::string(const std::string& name)>& renamed);
// Returns the names in the lines of a program that has them in this language, in lower case.
std::set<std::string> keptNames(const RobotProgram& program, std::string_view language);

// Returns the name of a waypoint in a comment as UrScriptPost and KrlPost write it, "; NAME": the sign, a space and one
// word. Empty: it is another comment.
std::string nameInComment(std::string_view comment);

// Returns true if the text calls a function, NAME(…) outside quotes, that is not harmless. harmless: functions that
// only compute, and words of the language that precede brackets, in lower case.
bool callsOther(std::string_view text, std::span<const char* const> harmless);

// Splits a text at the commas outside brackets.
std::vector<std::string_view> argumentsOf(std::string_view text);

// Returns the number that a text consists of; nothing if the text is no number, or more than a number, such as "2*n".
std::optional<double> numberAlone(std::string_view text);

// Parses a line of a program. Words are compared regardless of case.
class LineReader {
 public:
  LineReader(std::string_view text, std::size_t line) : m_rest(text), m_line(line) {}

  void skipSpace();
  void skip(std::size_t characters) { m_rest.remove_prefix(std::min(characters, m_rest.size())); }
  bool take(std::string_view word);      // skips the word if it comes next, perhaps as part of a longer word
  bool takeWord(std::string_view word);  // skips the word if it comes next and no letter or digit follows it
  std::optional<double> number();        // finite; nothing: no number comes next
  std::string_view name();               // letters, digits and underscores; empty: no name comes next
  std::string_view rest() const { return m_rest; }
  // Reads at most `most` numbers in brackets: "[1,2,3]"; nested brackets are ignored.
  std::optional<std::vector<double>> numbersWithin(char open, char close, std::size_t most);
  Error malformed(const char* element, const char* reason) const;
  // Returns the error of a place that is written as it should be.
  Error refused(const ErrorDescription& code, std::vector<std::string> arguments = {}) const;

 private:
  std::string_view m_rest;
  std::size_t m_line;
};

// Returns the text of a program in UTF-8, with "\n" between lines. A byte-order mark is omitted, and control characters
// but for tabs become blanks. Text that is no UTF-8 is taken as Latin-1. Errors: FileTooLarge.
Result<std::string> programText(std::string_view bytes);
// Returns the error FileTooLarge if the text is larger than PostProcessor::kLargestText.
Status checkTextSize(std::string_view text);
// Returns the lines of a text without comments. comment: the sign outside quotes at which a comment begins; empty: the
// language has none. Errors: FileTooLarge.
Result<std::vector<std::string_view>> programLines(std::string_view text, std::string_view comment);

}  // namespace handwheel
