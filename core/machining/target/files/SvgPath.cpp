// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/files/SvgPath.h"

#include "base/NumberText.h"
#include "machining/target/CurveFit.h"
#include "machining/target/files/Drawing.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::string_view kSeparators = " \t\r\n\f,";

Error malformedPath(const char* what) {
  return {ErrorCode::ElementMalformed, {"path", what}, {}, {}};
}

// Returns the number of arguments of a command; -1 if it is no command.
int numbersOf(char command) {
  switch (command | 0x20) {
    case 'm':
    case 'l':
    case 't':
      return 2;
    case 'h':
    case 'v':
      return 1;
    case 'c':
      return 6;
    case 's':
    case 'q':
      return 4;
    case 'a':
      return 7;
    case 'z':
      return 0;
    default:
      return -1;
  }
}

// Interprets the commands of a path.
class PathPen {
 public:
  explicit PathPen(SvgCurves& curves) : m_curves(curves) {}

  void draw(char command, const std::array<double, 7>& v) {
    const bool isRelative = command >= 'a';
    const ProfilePoint base = isRelative ? m_at : ProfilePoint(0, 0);
    const auto point = [&](std::size_t i) { return ProfilePoint(base + ProfilePoint(v[i], v[i + 1])); };
    const char lower = static_cast<char>(command | 0x20);
    switch (lower) {
      case 'm':
        m_at = m_start = point(0);
        break;
      case 'l':
        lineTo(point(0));
        break;
      case 'h':
        lineTo({base.x() + v[0], m_at.y()});
        break;
      case 'v':
        lineTo({m_at.x(), base.y() + v[0]});
        break;
      case 'c':
        cubicTo(point(0), point(2), point(4));
        break;
      case 's':
        cubicTo(m_last == 'c' ? ProfilePoint(2.0 * m_at - m_control) : m_at, point(0), point(2));
        break;
      case 'q':
        quadraticTo(point(0), point(2));
        break;
      case 't':
        quadraticTo(m_last == 'q' ? ProfilePoint(2.0 * m_at - m_control) : m_at, point(0));
        break;
      case 'a':
        arcTo(v, point(5));
        break;
      default:
        lineTo(m_start);
    }
    m_last = lower == 's' ? 'c' : lower == 't' ? 'q' : lower;
  }

 private:
  void lineTo(const ProfilePoint& to) {
    m_curves.line(m_at, to);
    m_at = to;
  }
  void cubicTo(const ProfilePoint& b, const ProfilePoint& c, const ProfilePoint& d) {
    m_curves.cubic(m_at, b, c, d);
    m_control = c;
    m_at = d;
  }
  void quadraticTo(const ProfilePoint& control, const ProfilePoint& to) {
    m_curves.cubic(m_at, m_at + 2.0 / 3.0 * (control - m_at), to + 2.0 / 3.0 * (control - to), to);
    m_control = control;
    m_at = to;
  }
  // Converts from the ends to the centre: SVG 1.1, F.6.5 and F.6.6.
  void arcTo(const std::array<double, 7>& v, const ProfilePoint& to) {
    double rx = std::abs(v[0]), ry = std::abs(v[1]);
    const ProfilePoint from = m_at;
    if (from == to) return;
    if (!(rx > 0.0) || !(ry > 0.0)) return lineTo(to);
    const double rotation = v[2] * M_PI / 180.0;
    const Eigen::Rotation2Dd turn(rotation);
    const ProfilePoint half = turn.inverse() * ProfilePoint(0.5 * (from - to));
    const double far = std::hypot(half.x() / rx, half.y() / ry);
    if (far > 1.0) {
      rx *= far;
      ry *= far;
    }
    const ProfilePoint unit(half.x() / rx, half.y() / ry);
    const double square = std::min(unit.squaredNorm(), 1.0);
    double away = square > 0.0 ? std::sqrt(std::max(0.0, 1.0 / square - 1.0)) : 0.0;
    const bool isLarge = v[3] != 0.0, isPositive = v[4] != 0.0;
    if (isLarge == isPositive) away = -away;
    const ProfilePoint centreUnit = away * ProfilePoint(unit.y(), -unit.x());
    const ProfilePoint centre = turn * ProfilePoint(rx * centreUnit.x(), ry * centreUnit.y()) + 0.5 * (from + to);
    const ProfilePoint a = unit - centreUnit, b = -unit - centreUnit;
    const double start = std::atan2(a.y(), a.x());
    double sweep = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    if (isPositive && sweep < 0.0) sweep += 2.0 * M_PI;
    if (!isPositive && sweep > 0.0) sweep -= 2.0 * M_PI;
    m_curves.arc(centre, rx, ry, rotation, start, sweep);
    m_at = to;
  }

  SvgCurves& m_curves;
  ProfilePoint m_at{0, 0}, m_start{0, 0}, m_control{0, 0};
  char m_last = 'm';
};

// A flag of an arc needs no separator after it.
bool takeFlag(std::string_view& text, double& flag) {
  text.remove_prefix(std::min(text.find_first_not_of(kSeparators), text.size()));
  if (text.empty() || (text[0] != '0' && text[0] != '1')) return false;
  flag = text[0] - '0';
  text.remove_prefix(1);
  return true;
}

bool takeArguments(std::string_view& text, char command, std::array<double, 7>& values) {
  const int count = numbersOf(command);
  for (int i = 0; i < count; ++i) {
    const bool isFlag = (command | 0x20) == 'a' && (i == 3 || i == 4);
    double& value = values[static_cast<std::size_t>(i)];
    if (!(isFlag ? takeFlag(text, value) : takeSvgNumber(text, value))) return false;
  }
  return true;
}

bool isSimilarity(const Eigen::Matrix2d& m) {
  const double scale = m.norm();
  const bool turns = std::abs(m(0, 0) - m(1, 1)) + std::abs(m(0, 1) + m(1, 0)) <= 1e-12 * scale;
  const bool mirrors = std::abs(m(0, 0) + m(1, 1)) + std::abs(m(0, 1) - m(1, 0)) <= 1e-12 * scale;
  return turns || mirrors;
}

}  // namespace

bool takeSvgNumber(std::string_view& text, double& number) {
  text.remove_prefix(std::min(text.find_first_not_of(kSeparators), text.size()));
  // The longest prefix that is a number: "1.5.5" is two, "1-2" too.
  std::size_t end = 0;
  const auto digits = [&] {
    const std::size_t first = end;
    while (end < text.size() && isDigit(text[end])) ++end;
    return end - first;
  };
  if (end < text.size() && (text[end] == '+' || text[end] == '-')) ++end;
  std::size_t count = digits();
  if (end < text.size() && text[end] == '.') {
    ++end;
    count += digits();
  }
  if (count == 0) return false;
  const std::size_t mantissa = end;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    ++end;
    if (end < text.size() && (text[end] == '+' || text[end] == '-')) ++end;
    if (digits() == 0) end = mantissa;
  }
  ErrorCode why = ErrorCode::NumberMalformed;
  const bool isRead = parseDecimal(text.substr(0, end), number, why) && std::isfinite(number);
  text.remove_prefix(end);
  return isRead;
}

void SvgCurves::line(const ProfilePoint& a, const ProfilePoint& b) {
  const ProfilePoint from = m_to * a, to = m_to * b;
  if (from != to) m_found.push_back({from, to, 0.0});
}

void SvgCurves::arc(const ProfilePoint& centre, double rx, double ry, double rotation, double from, double sweep) {
  const Eigen::Rotation2Dd turn(rotation);
  const auto point = [&](double angle) {
    return ProfilePoint(m_to * ProfilePoint(centre + turn * ProfilePoint(rx * std::cos(angle), ry * std::sin(angle))));
  };
  if (std::abs(rx - ry) <= 1e-9 * rx && isSimilarity(m_to.linear())) {
    const double turned = m_to.linear().determinant() < 0.0 ? -sweep : sweep;
    const int pieces = std::abs(sweep) > M_PI ? 2 : 1;
    for (int k = 0; k < pieces; ++k) {
      m_found.push_back(
          {point(from + k * sweep / pieces), point(from + (k + 1) * sweep / pieces), std::tan(0.25 * turned / pieces)});
    }
    return;
  }
  const auto all = fitSegments([&](double t) { return point(from + t * sweep); }, Drawing::kCurveTolerance);
  m_found.insert(m_found.end(), all.begin(), all.end());
}

void SvgCurves::cubic(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c, const ProfilePoint& d) {
  const ProfilePoint p = m_to * a, q = m_to * b, r = m_to * c, s = m_to * d;
  const auto curve = [&](double t) {
    const double u = 1.0 - t;
    return ProfilePoint(u * u * u * p + 3.0 * u * u * t * q + 3.0 * u * t * t * r + t * t * t * s);
  };
  if (!p.allFinite() || !q.allFinite() || !r.allFinite() || !s.allFinite()) return;
  const auto all = fitSegments(curve, Drawing::kCurveTolerance);
  for (const ProfileSegment& segment : all)
    if (segment.from != segment.to) m_found.push_back(segment);
}

Status readSvgPath(std::string_view d, std::size_t most, SvgCurves& curves, Progress progress) {
  PathPen pen(curves);
  char command = 0;
  while (true) {
    d.remove_prefix(std::min(d.find_first_not_of(kSeparators), d.size()));
    if (d.empty()) return Done{};
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    const bool isCommand = numbersOf(d[0]) >= 0 && std::isalpha(static_cast<unsigned char>(d[0])) != 0;
    if (isCommand) {
      command = d[0];
      d.remove_prefix(1);
    } else if (command == 0 || numbersOf(command) == 0) {
      return malformedPath("a command was expected");
    }
    std::array<double, 7> values{};
    if (!takeArguments(d, command, values)) return malformedPath("a number was expected");
    pen.draw(command, values);
    // More points after a move are lines.
    if (command == 'm') command = 'l';
    if (command == 'M') command = 'L';
    if (curves.found().size() > most)
      return Error{ErrorCode::FileTooLarge, {"segments", "", std::to_string(most)}, {}, {}};
  }
}

Result<Eigen::Affine2d> readSvgTransform(std::string_view text) {
  const Error problem{ErrorCode::ElementMalformed, {"transform", "it is not one that SVG has"}, {}, {}};
  Eigen::Affine2d all = Eigen::Affine2d::Identity();
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kSeparators), text.size()));
    if (text.empty()) return all;
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == text.npos || close == text.npos || close < open) return problem;
    std::string_view name = text.substr(0, open), inside = text.substr(open + 1, close - open - 1);
    name = name.substr(0, name.find_first_of(kSeparators));
    text.remove_prefix(close + 1);
    std::array<double, 6> v{};
    std::size_t count = 0;
    for (double value = 0.0; count < v.size() && takeSvgNumber(inside, value); ++count) v[count] = value;
    Eigen::Affine2d one = Eigen::Affine2d::Identity();
    const double angle = v[0] * M_PI / 180.0;
    if (name == "matrix" && count == 6) {
      one.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0, 0, 1;
    } else if (name == "translate" && count >= 1) {
      one.translate(Eigen::Vector2d(v[0], v[1]));
    } else if (name == "scale" && count >= 1) {
      one.scale(Eigen::Vector2d(v[0], count > 1 ? v[1] : v[0]));
    } else if (name == "rotate" && count >= 1) {
      one.translate(Eigen::Vector2d(v[1], v[2])).rotate(angle).translate(Eigen::Vector2d(-v[1], -v[2]));
    } else if (name == "skewX" && count == 1) {
      one.matrix()(0, 1) = std::tan(angle);
    } else if (name == "skewY" && count == 1) {
      one.matrix()(1, 0) = std::tan(angle);
    } else {
      return problem;
    }
    all = all * one;
  }
}

}  // namespace handwheel
