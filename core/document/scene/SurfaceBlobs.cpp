// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/SurfaceBlobs.h"

#include "base/JsonText.h"
#include "document/container/Blobs.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

std::vector<bool> isThere(const std::vector<IndexRange>& lost, std::size_t count) {
  std::vector<bool> there(count, true);
  for (const IndexRange& range : lost) {
    for (std::size_t i = range.begin; i < std::min(range.end, count); ++i) there[i] = false;
  }
  return there;
}

}  // namespace

template <class Number>
nlohmann::json writeSoupBlobs(const TriangleSoup& soup, const std::string& name, Container& container) {
  std::vector<Number> numbers;
  numbers.reserve(3 * soup.points.size());
  for (const Vec3& p : soup.points) {
    for (double v : p) numbers.push_back(static_cast<Number>(v));
  }
  writeArray<Number>(container, name + "/points", numbers, 3);
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * soup.triangles.size());
  for (const Triangle& t : soup.triangles) corners.insert(corners.end(), t.begin(), t.end());
  writeArray<std::uint32_t>(container, name + "/triangles", corners, 3);
  return {{"points", soup.points.size()}, {"triangles", soup.triangles.size()}};
}

template <class Number>
TriangleSoup readSoupBlobs(const nlohmann::json& counts, const std::string& name, const Container& container,
                           double largestCoordinate, std::uint64_t& lost) {
  const std::uint64_t count = countAt(counts, "triangles");
  const auto points = readArray<Number>(container, name + "/points", countAt(counts, "points"), 3);
  const auto corners = readArray<std::uint32_t>(container, name + "/triangles", count, 3);
  std::vector<bool> isReadable = isThere(points.lost, points.values.size() / 3);
  TriangleSoup soup;
  soup.points.reserve(isReadable.size());
  for (std::size_t i = 0; i < isReadable.size(); ++i) {
    const Vec3 p(points.values[3 * i], points.values[3 * i + 1], points.values[3 * i + 2]);
    if (!(p.allFinite() && p.cwiseAbs().maxCoeff() <= largestCoordinate)) isReadable[i] = false;
    soup.points.push_back(isReadable[i] ? p : Vec3(Vec3::Zero()));
  }
  const std::vector<bool> isListed = isThere(corners.lost, corners.values.size() / 3);
  for (std::size_t i = 0; i < isListed.size(); ++i) {
    const Triangle t{corners.values[3 * i], corners.values[3 * i + 1], corners.values[3 * i + 2]};
    const auto isGood = [&](std::uint32_t corner) { return corner < isReadable.size() && isReadable[corner]; };
    if (isListed[i] && std::all_of(t.begin(), t.end(), isGood)) soup.triangles.push_back(t);
  }
  lost = count - std::min<std::uint64_t>(count, soup.triangles.size());
  return soup;
}

template nlohmann::json writeSoupBlobs<float>(const TriangleSoup&, const std::string&, Container&);
template nlohmann::json writeSoupBlobs<double>(const TriangleSoup&, const std::string&, Container&);
template TriangleSoup readSoupBlobs<float>(const nlohmann::json&, const std::string&, const Container&, double,
                                           std::uint64_t&);
template TriangleSoup readSoupBlobs<double>(const nlohmann::json&, const std::string&, const Container&, double,
                                            std::uint64_t&);

}  // namespace handwheel
