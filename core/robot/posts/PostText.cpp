// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/PostText.h"

#include "base/NumberText.h"
#include "base/Utf8.h"
#include "robot/posts/PostErrors.h"
#include "robot/program/RobotPath.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::string_view kClearanceKept = "Clearance kept: ";

bool isNameCharacter(char c) {
  return isLetter(c) || isDigit(c) || c == '_';
}

// Returns so many decimal digits of the FNV-1a hash of a text.
std::string hashDigits(const std::string& text, std::size_t count) {
  std::uint32_t hash = 2166136261u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  std::string digits(count, '0');
  for (char& digit : digits) {
    digit = static_cast<char>('0' + hash % 10);
    hash /= 10;
  }
  return digits;
}

char lowered(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::string fixedText(double value, int digits) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits);
  std::string text(buffer, error == std::errc() ? end : buffer);
  if (text.find_first_not_of("-0.") == text.npos && !text.empty() && text[0] == '-') text.erase(0, 1);
  return text;
}

std::string fixedList(std::span<const double> values, int digits) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ",") + fixedText(value, digits);
  return text;
}

std::string identifierOf(const std::string& name, std::size_t longest) {
  std::string made;
  for (const char c : name) made += isNameCharacter(c) ? c : '_';
  if (made.empty() || !isLetter(made[0])) made = "P" + made;
  if (made.size() <= longest) return made;
  std::string number = made.substr(made.find_last_not_of("0123456789") + 1);
  constexpr std::size_t kShortestHead = 3;
  if (number.empty() || number.size() + kShortestHead >= longest) number = hashDigits(name, longest > 12 ? 4 : 2);
  std::string head = made.substr(0, longest - number.size() - 1);
  while (head.ends_with('_')) head.pop_back();
  return head + "_" + number;
}

std::string identifierWithDigits(const std::string& name, std::size_t longest) {
  constexpr std::size_t kDigits = 4;
  return identifierOf(name, longest - kDigits - 1) + "_" + hashDigits(name, kDigits);
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), lowered);
  return text;
}

std::string identifierBeside(std::span<const char* const> words, const std::string& name, std::size_t longest) {
  const auto isWord = [&](const std::string& made) {
    return std::ranges::any_of(words, [lower = lowerCase(made)](const char* word) { return lower == word; });
  };
  const std::string made = identifierOf(name, longest), other = identifierOf(made + "_path", longest);
  if (!isWord(made)) return made;
  return isWord(other) ? identifierWithDigits(name, longest) : other;
}

std::string frameIdentifier(const RobotProgram& program, std::span<const char* const> words, std::size_t longest) {
  const std::string& name = program.frameName;
  const std::string made = identifierOf(name, longest), lower = lowerCase(made);
  const auto isSame = [&](const std::string& other) {
    return other != name && lowerCase(identifierOf(other, longest)) == lower;
  };
  const bool isWord = std::any_of(words.begin(), words.end(), [&](const char* word) { return lower == word; });
  if (!isWord && std::ranges::none_of(program.otherFrames, isSame)) return made;
  return identifierWithDigits(name, longest);
}

std::string readName(std::string_view name) {
  constexpr std::size_t kLongestRead = 200, kShortened = 60;
  return name.size() <= kLongestRead ? std::string(name) : identifierOf(std::string(name), kShortened);
}

std::vector<std::string> proofRemarks(const RobotProgram& program) {
  if (!program.clearance) return {};
  return {std::string(kClearanceKept) + roundedText(*program.clearance, 6) + " mm.",
          "The way to the first place is not checked."};
}

std::optional<double> keptClearance(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t at = line.find(kClearanceKept);
    if (at == line.npos) continue;
    // Before it there is only the comment sign, in some languages after the line number.
    const std::string_view before = line.substr(0, at), rest = line.substr(at + kClearanceKept.size());
    const bool isRemark =
        before.find_first_of("!;#/") != before.npos && before.find_first_not_of(" \t!;#/:0123456789") == before.npos;
    double kept = 0.0;
    ErrorCode why = ErrorCode::NumberMalformed;
    const bool isNumber = parseDecimal(rest.substr(0, rest.find_first_of(" ;\r")), kept, why);
    if (isRemark && isNumber && kept >= 0.0 && kept <= RobotPath::kLargestClearance) return kept;
  }
  return std::nullopt;
}

std::vector<std::string> headRemarks(const RobotProgram& program) {
  std::vector<std::string> remarks{identifierOf(program.robot, 60)};
  if (!program.frameName.empty() && hasLines(program))
    remarks.push_back("Places are in the frame " + identifierOf(program.frameName, 60) + ".");
  if (program.hasPlainShapes) remarks.emplace_back("Collisions were checked with simplified shapes of the robot.");
  for (std::string& remark : proofRemarks(program)) remarks.push_back(std::move(remark));
  remarks.insert(remarks.end(), program.remarks.begin(), program.remarks.end());
  remarks.emplace_back(kWrittenByUs);
  return remarks;
}

bool hasLines(const RobotProgram& program) {
  return std::any_of(program.motions.begin(), program.motions.end(),
                     [](const ProgramMotion& motion) { return motion.kind == ProgramMotion::Kind::Linear; });
}

bool needsControllersBase(const RobotProgram& program) {
  return !program.isBaseOfController && hasLines(program);
}

Vec3 zyxAngles(const Eigen::Matrix3d& turn) {
  const double across = std::hypot(turn(0, 0), turn(1, 0));
  const double pitch = std::atan2(-turn(2, 0), across);
  constexpr double kInLine = 1e-9;
  if (across < kInLine) return {std::atan2(-turn(0, 1), turn(1, 1)), pitch, 0.0};
  return {std::atan2(turn(1, 0), turn(0, 0)), pitch, std::atan2(turn(2, 1), turn(2, 2))};
}

Eigen::Matrix3d fromZyx(const Vec3& angles) {
  return (Eigen::AngleAxisd(angles.x(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
          Eigen::AngleAxisd(angles.z(), Vec3::UnitX()))
      .toRotationMatrix();
}

std::vector<double> degreesOf(const ArmValues& values) {
  std::vector<double> degrees(values.begin(), values.end());
  for (double& value : degrees) value /= kRadiansPerDegree;
  return degrees;
}

ArmValues radiansOf(std::span<const double> degrees) {
  ArmValues values(static_cast<Eigen::Index>(degrees.size()));
  for (std::size_t i = 0; i < degrees.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = degrees[i] * kRadiansPerDegree;
  return values;
}

Pose poseInProgram(const RobotProgram& program, const Pose& frame, const Pose& pose, const Pose& tool) {
  return program.frame.inverse(Eigen::Isometry) * frame * pose * tool.inverse(Eigen::Isometry) * program.tool;
}

Error unread(std::string_view statement, std::size_t line) {
  constexpr std::size_t kMostShown = 40;
  const std::size_t begin = std::min(statement.find_first_not_of(" \t\r"), statement.size());
  const std::size_t end = std::min(statement.find_first_of("\t\r(;", begin + 1), begin + kMostShown);
  return {
      PostError::StatementUnread, {std::string(statement.substr(begin, end - begin))}, InputPosition::line(line), {}};
}

ProgramLine keptLine(ProgramLine::Kind kind, std::string_view text, std::size_t line, bool mayGrip) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t begin = std::min(text.find_first_not_of(kSpace), text.size());
  const std::size_t end = text.find_last_not_of(kSpace);
  return {kind, std::string(end == text.npos ? std::string_view() : text.substr(begin, end + 1 - begin)), line,
          mayGrip};
}

std::string keptText(const ProgramLine& line, const char* commentSign) {
  return line.kind == ProgramLine::Kind::Comment ? commentSign + line.text : line.text;
}

std::string keptTexts(const std::vector<ProgramLine>& lines, const char* indent, const char* commentSign,
                      const char* ending) {
  std::string text;
  for (const ProgramLine& each : lines) {
    const bool isComment = each.kind == ProgramLine::Kind::Comment;
    if (each.kind == ProgramLine::Kind::Axes) continue;
    if (!each.text.empty()) text += indent + keptText(each, commentSign) + (isComment ? "" : ending) + "\n";
  }
  return text;
}

std::string withNames(std::string_view text, const std::function<std::string(const std::string& name)>& renamed) {
  std::string made;
  bool isQuoted = false;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '"') isQuoted = !isQuoted;
    const bool isName = !isQuoted && (isLetter(text[i]) || text[i] == '_' || text[i] == '$');
    std::size_t end = i + 1;
    while ((isName || (!isQuoted && isDigit(text[i]))) && end < text.size() && isNameCharacter(text[end])) ++end;
    const std::string_view word = text.substr(i, end - i);
    const bool isComponent = i > 0 && (text[i - 1] == '.' || text[i - 1] == '\\');  // ".x", "\MaxTime"
    const std::string other = isName && !isComponent ? renamed(lowerCase(std::string(word))) : std::string();
    made += other.empty() ? word : std::string_view(other);
    i = end;
  }
  return made;
}

std::vector<std::string> namesIn(std::string_view text) {
  std::vector<std::string> names;
  withNames(text, [&](const std::string& name) {
    names.push_back(name);
    return std::string();
  });
  return names;
}

std::set<std::string> keptNames(const RobotProgram& program, std::string_view language) {
  std::set<std::string> names;
  if (program.language != language) return names;
  const auto add = [&](const std::vector<ProgramLine>& lines) {
    for (const ProgramLine& line : lines) {
      if (line.kind == ProgramLine::Kind::Comment) continue;
      for (std::string& name : namesIn(line.text)) names.insert(std::move(name));
    }
  };
  add(program.head);
  for (const ProgramMotion& motion : program.motions) add(motion.lines);
  return names;
}

std::string nameInComment(std::string_view comment) {
  if (comment.size() < 3 || comment[1] != ' ' || !isNameCharacter(comment[2])) return {};
  LineReader line(comment.substr(1), 0);
  const std::string_view name = line.name();
  line.skipSpace();
  return line.rest().empty() ? readName(name) : std::string();
}

bool callsOther(std::string_view text, std::span<const char* const> harmless) {
  bool isQuoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') isQuoted = !isQuoted;
    if (isQuoted || !isNameCharacter(text[i])) continue;
    LineReader line(text.substr(i), 0);
    const std::string name = lowerCase(std::string(line.name()));
    i += name.size() - 1;
    if (line.take("(") &&
        std::none_of(harmless.begin(), harmless.end(), [&](const char* known) { return name == known; }))
      return true;
  }
  return false;
}

std::vector<std::string_view> argumentsOf(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i == text.size() || (text[i] == ',' && depth == 0)) {
      parts.push_back(text.substr(begin, i - begin));
      begin = i + 1;
    } else if (text[i] == '[' || text[i] == '(') {
      ++depth;
    } else if (text[i] == ']' || text[i] == ')') {
      --depth;
    }
  }
  return parts;
}

std::optional<double> numberAlone(std::string_view text) {
  LineReader line(text, 0);
  const auto value = line.number();
  line.skipSpace();
  return line.rest().empty() ? value : std::nullopt;
}

void LineReader::skipSpace() {
  const std::size_t begin = m_rest.find_first_not_of(" \t\r");
  m_rest.remove_prefix(std::min(begin, m_rest.size()));
}

bool LineReader::take(std::string_view word) {
  skipSpace();
  if (m_rest.size() < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (lowered(m_rest[i]) != lowered(word[i])) return false;
  }
  m_rest.remove_prefix(word.size());
  return true;
}

bool LineReader::takeWord(std::string_view word) {
  const std::string_view before = m_rest;
  if (take(word) && (m_rest.empty() || !isNameCharacter(m_rest[0]))) return true;
  m_rest = before;
  return false;
}

std::optional<double> LineReader::number() {
  skipSpace();
  std::string_view text = m_rest;
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  m_rest = text.substr(static_cast<std::size_t>(end - text.data()));
  return value;
}

std::string_view LineReader::name() {
  skipSpace();
  std::size_t length = 0;
  while (length < m_rest.size() && isNameCharacter(m_rest[length])) ++length;
  const std::string_view found = m_rest.substr(0, length);
  m_rest.remove_prefix(length);
  return found;
}

std::optional<std::vector<double>> LineReader::numbersWithin(char open, char close, std::size_t most) {
  skipSpace();
  if (m_rest.empty() || m_rest[0] != open) return std::nullopt;
  m_rest.remove_prefix(1);
  std::vector<double> numbers;
  for (int depth = 1; depth > 0;) {
    skipSpace();
    if (m_rest.empty()) return std::nullopt;
    const char c = m_rest[0];
    if (c == open || c == close || c == ',') {
      depth += c == open ? 1 : c == close ? -1 : 0;
      m_rest.remove_prefix(1);
      continue;
    }
    const auto value = number();
    if (!value || numbers.size() >= most) return std::nullopt;
    numbers.push_back(*value);
  }
  return numbers;
}

Error LineReader::malformed(const char* element, const char* reason) const {
  return {ErrorCode::ElementMalformed, {element, reason}, InputPosition::line(m_line), {}};
}

Error LineReader::refused(const ErrorDescription& code, std::vector<std::string> arguments) const {
  return {code, std::move(arguments), InputPosition::line(m_line), {}};
}

Result<std::string> programText(std::string_view bytes) {
  if (const Status fits = checkTextSize(bytes); !fits) return fits.error();
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  const bool isLatin = !isUtf8(bytes);
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    if (byte == '\r') {
      if (i + 1 == bytes.size() || bytes[i + 1] != '\n') text += '\n';
    } else if (isLatin && byte >= 0x80) {
      text += {static_cast<char>(0xc0 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3f))};
    } else {
      text += byte != '\n' && byte != '\t' && isControl(bytes[i]) ? ' ' : bytes[i];
    }
  }
  return text;
}

Status checkTextSize(std::string_view text) {
  if (text.size() <= PostProcessor::kLargestText) return Done{};
  return Error{ErrorCode::FileTooLarge,
               {"bytes", std::to_string(text.size()), std::to_string(PostProcessor::kLargestText)},
               {},
               {}};
}

Result<std::vector<std::string_view>> programLines(std::string_view text, std::string_view comment) {
  if (const Status fits = checkTextSize(text); !fits) return fits.error();
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    bool isQuoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"') isQuoted = !isQuoted;
      if (!isQuoted && !comment.empty() && line.substr(i).starts_with(comment)) line = line.substr(0, i);
    }
    lines.push_back(line);
    begin = end + 1;
  }
  return lines;
}

}  // namespace handwheel
