// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/DeviationDisplay.h"

#include "document/workpiece/TurnedPartDisplay.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kRings = 2000, kBands = 200;  // along the part, at most
constexpr std::uint32_t kSides = 72;                // of a ring

// Adds rings of points, and bands between one and the next.
class Bands {
 public:
  explicit Bands(TriangleSoup& soup) : m_soup(soup) {}

  std::uint32_t ring(double radius, double z) {
    const auto first = static_cast<std::uint32_t>(m_soup.points.size());
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const double angle = 2.0 * M_PI * k / kSides;
      m_soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return first;
  }
  // Seen from outside where the second ring is above the first.
  void band(std::uint32_t a, std::uint32_t b) {
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const std::uint32_t next = (k + 1) % kSides;
      m_soup.triangles.push_back({a + k, a + next, b + next});
      m_soup.triangles.push_back({a + k, b + next, b + k});
    }
  }

 private:
  TriangleSoup& m_soup;
};

// The surface between two samples, and the flat ends of the part where they are.
std::shared_ptr<const TriangleSoup> surfaceBetween(const TurnedProfile& part, const std::vector<std::size_t>& samples) {
  auto soup = std::make_shared<TriangleSoup>();
  Bands bands(*soup);
  std::uint32_t outer = 0, inner = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t s = samples[i];
    const std::uint32_t nextOuter = bands.ring(part.radius(s), part.z(s));
    const std::uint32_t nextInner = bands.ring(part.inner(s), part.z(s));
    if (i > 0) {
      bands.band(outer, nextOuter);
      if (part.isBored()) bands.band(nextInner, inner);
    }
    if (s == 0) bands.band(nextInner, nextOuter);
    if (s + 1 == part.size()) bands.band(nextOuter, nextInner);
    outer = nextOuter;
    inner = nextInner;
  }
  return soup;
}

double worse(double a, double b) {
  return std::abs(b) > std::abs(a) ? b : a;
}

}  // namespace

DisplayModel deviationDisplay(const WorkpieceSnapshot& workpiece, const DeviationColour& colour) {
  const TargetProfile& target = workpiece.target->profile;
  const StockCylinder& stock = workpiece.stock;
  const TurnedProfile bar(stock, stock.length / static_cast<double>(kBands));
  const TurnedProfile& part = workpiece.part ? workpiece.part->profile : bar;
  std::vector<std::size_t> rings;
  const std::size_t stride = part.size() / kRings + 1;
  for (std::size_t i = 0; i + 1 < part.size(); i += stride) rings.push_back(i);
  rings.push_back(part.size() - 1);
  const auto distanceAt = [&](std::size_t i) {
    const double z = stock.position + part.z(i);
    const double outside = target.distance({part.radius(i), z});
    return part.inner(i) > 0.0 ? worse(outside, target.distance({part.inner(i), z})) : outside;
  };
  DisplayModel model;
  const std::size_t perBand = rings.size() / kBands + 1;
  for (std::size_t first = 0; first + 1 < rings.size(); first += perBand) {
    const std::size_t last = std::min(first + perBand, rings.size() - 1);
    const std::vector<std::size_t> samples(rings.begin() + static_cast<std::ptrdiff_t>(first),
                                           rings.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    double largest = 0.0;
    for (const std::size_t s : samples) largest = worse(largest, distanceAt(s));
    DisplayPart band;
    band.name = "deviation." + std::to_string(model.parts.size());
    band.group = kStockGroup;
    band.soup = surfaceBetween(part, samples);
    band.colour = colour(largest);
    band.pose.translation().z() = stock.position;
    model.parts.push_back(std::move(band));
  }
  return model;
}

}  // namespace handwheel
