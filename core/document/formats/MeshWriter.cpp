// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshWriter.h"

#include "base/ByteOrder.h"
#include "mesh/structure/CancelPolling.h"

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

// Calls write(point) and then write(triangle) for each of the soup. Returns false if cancelled.
template <class WritePoint, class WriteTriangle>
bool writeEach(const TriangleSoup& soup, Progress progress, WritePoint writePoint, WriteTriangle writeTriangle) {
  const std::size_t points = soup.points.size(), count = points + soup.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!pollProgress(i, count, progress)) return false;
    if (i < points) {
      writePoint(soup.points[i]);
    } else {
      writeTriangle(soup.triangles[i - points]);
    }
  }
  progress.set(1.0);
  return !progress.cancelled();
}

}  // namespace

std::string writeStl(const TriangleSoup& soup, Progress progress) {
  std::string bytes = "Binary STL written by Handwheel";  // must not begin with "solid"
  bytes.reserve(84 + 50 * soup.triangles.size());
  bytes.resize(80, '\0');
  appendNumber(bytes, static_cast<std::uint32_t>(soup.triangles.size()), kLittle);
  const auto writeTriangle = [&](const Triangle& t) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = rounded(soup.points[t[k]], NumberType::Float32);
    appendFloats(bytes, rounded(unitNormal(p[0], p[1], p[2]), NumberType::Float32));
    for (const Vec3& corner : p) appendFloats(bytes, corner);
    appendNumber(bytes, std::uint16_t{0}, kLittle);
  };
  const auto skipPoint = [](const Vec3&) {};
  if (!writeEach(soup, progress, skipPoint, writeTriangle)) return {};
  return bytes;
}

std::string writePly(const TriangleSoup& soup, NumberType numbers, Progress progress) {
  const std::string type = numbers == NumberType::Float32 ? "float" : "double";
  // Some programs support signed indices only, which are used if they suffice.
  const bool manyPoints = soup.points.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment written by Handwheel\n";
  bytes += "element vertex " + std::to_string(soup.points.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) bytes += "property " + type + " " + axis + "\n";
  bytes += "element face " + std::to_string(soup.triangles.size()) + "\n";
  bytes += std::string("property list uchar ") + (manyPoints ? "uint" : "int") + " vertex_indices\nend_header\n";
  bytes.reserve(bytes.size() + 24 * soup.points.size() + 13 * soup.triangles.size());
  const auto writePoint = [&](const Vec3& point) {
    const Vec3 p = rounded(point, numbers);
    if (numbers == NumberType::Float32)
      appendFloats(bytes, p);
    else
      for (double x : p) appendNumber(bytes, x, kLittle);
  };
  const auto writeTriangle = [&](const Triangle& t) {
    bytes += '\3';
    for (std::uint32_t corner : t) appendNumber(bytes, corner, kLittle);
  };
  if (!writeEach(soup, progress, writePoint, writeTriangle)) return {};
  return bytes;
}

std::string writeObj(const TriangleSoup& soup, NumberType numbers, Progress progress) {
  std::string text = "# written by Handwheel\n";
  const auto writePoint = [&](const Vec3& point) {
    text += "v ";
    appendPointText(text, rounded(point, numbers));
  };
  const auto writeTriangle = [&](const Triangle& t) {
    text += 'f';
    appendTriangleText(text, t, 1);
  };
  if (!writeEach(soup, progress, writePoint, writeTriangle)) return {};
  return text;
}

std::string writeOff(const TriangleSoup& soup, NumberType numbers, Progress progress) {
  std::string text = "OFF\n";
  text += std::to_string(soup.points.size()) + " " + std::to_string(soup.triangles.size()) + " 0\n";
  const auto writePoint = [&](const Vec3& point) { appendPointText(text, rounded(point, numbers)); };
  const auto writeTriangle = [&](const Triangle& t) {
    text += '3';
    appendTriangleText(text, t, 0);
  };
  if (!writeEach(soup, progress, writePoint, writeTriangle)) return {};
  return text;
}

}  // namespace handwheel
