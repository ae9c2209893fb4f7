// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshWriter.h"

#include "document/formats/ByteOrder.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr auto kLittle = std::endian::little;

void appendFloats(std::string& to, const Vec3& v) {
  for (double x : v) appendNumber(to, static_cast<float>(x), kLittle);
}

Vec3 unitNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 area = (b - a).cross(c - a);
  const double length = area.stableNorm();
  return length > 0.0 && std::isfinite(length) ? Vec3(area / length) : Vec3(Vec3::Zero());
}

template <class Number>
void appendText(std::string& to, Number value) {
  char digits[32];  // the longest shortest double has 24
  const auto end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
  to.append(digits, end);
}

void appendPointText(std::string& to, const Vec3& p) {
  appendText(to, p.x());
  to += ' ';
  appendText(to, p.y());
  to += ' ';
  appendText(to, p.z());
  to += '\n';
}

void appendTriangleText(std::string& to, const Triangle& t, std::uint64_t firstIndex) {
  for (std::uint32_t corner : t) {
    to += ' ';
    appendText(to, corner + firstIndex);
  }
  to += '\n';
}

}  // namespace

std::string writeStl(const TriangleSoup& soup) {
  std::string bytes = "Binary STL written by Handwheel";  // must not begin with "solid"
  bytes.reserve(84 + 50 * soup.triangles.size());
  bytes.resize(80, '\0');
  appendNumber(bytes, static_cast<std::uint32_t>(soup.triangles.size()), kLittle);
  for (const Triangle& t : soup.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = rounded(soup.points[t[k]], NumberType::Float32);
    appendFloats(bytes, rounded(unitNormal(p[0], p[1], p[2]), NumberType::Float32));
    for (const Vec3& corner : p) appendFloats(bytes, corner);
    appendNumber(bytes, std::uint16_t{0}, kLittle);
  }
  return bytes;
}

std::string writePly(const TriangleSoup& soup, NumberType numbers) {
  const std::string type = numbers == NumberType::Float32 ? "float" : "double";
  // Some programs know signed indices only; they do as long as they suffice.
  const bool manyPoints = soup.points.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment written by Handwheel\n";
  bytes += "element vertex " + std::to_string(soup.points.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) bytes += "property " + type + " " + axis + "\n";
  bytes += "element face " + std::to_string(soup.triangles.size()) + "\n";
  bytes += std::string("property list uchar ") + (manyPoints ? "uint" : "int") + " vertex_indices\nend_header\n";
  bytes.reserve(bytes.size() + 24 * soup.points.size() + 13 * soup.triangles.size());
  for (const Vec3& point : soup.points) {
    const Vec3 p = rounded(point, numbers);
    if (numbers == NumberType::Float32)
      appendFloats(bytes, p);
    else
      for (double x : p) appendNumber(bytes, x, kLittle);
  }
  for (const Triangle& t : soup.triangles) {
    bytes += '\3';
    for (std::uint32_t corner : t) appendNumber(bytes, corner, kLittle);
  }
  return bytes;
}

std::string writeObj(const TriangleSoup& soup, NumberType numbers) {
  std::string text = "# written by Handwheel\n";
  for (const Vec3& point : soup.points) {
    text += "v ";
    appendPointText(text, rounded(point, numbers));
  }
  for (const Triangle& t : soup.triangles) {
    text += 'f';
    appendTriangleText(text, t, 1);
  }
  return text;
}

std::string writeOff(const TriangleSoup& soup, NumberType numbers) {
  std::string text = "OFF\n";
  text += std::to_string(soup.points.size()) + " " + std::to_string(soup.triangles.size()) + " 0\n";
  for (const Vec3& point : soup.points) appendPointText(text, rounded(point, numbers));
  for (const Triangle& t : soup.triangles) {
    text += '3';
    appendTriangleText(text, t, 0);
  }
  return text;
}

}  // namespace handwheel
