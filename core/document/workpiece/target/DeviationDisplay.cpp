// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/DeviationDisplay.h"

#include "document/workpiece/TurnedPartDisplay.h"
#include "machining/target/TargetDeviation.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kRings = 2000, kBands = 200;  // along the part, at most
constexpr std::uint32_t kSides = 72;                // sides of a ring

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
    const bool hasFirst = m_soup.points[a] != m_soup.points[a + 1];  // else it is a point of the axis
    const bool hasSecond = m_soup.points[b] != m_soup.points[b + 1];
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const std::uint32_t next = (k + 1) % kSides;
      if (hasFirst) m_soup.triangles.push_back({a + k, a + next, b + next});
      if (hasSecond) m_soup.triangles.push_back({a + k, b + next, b + k});
    }
  }

 private:
  TriangleSoup& m_soup;
};

enum class Surface { Both, Outer, Inner };

// The surface between two samples, and the flat ends of the part where they are: these are of the outside.
std::shared_ptr<const TriangleSoup> surfaceBetween(const TurnedProfile& part, const std::vector<std::size_t>& samples,
                                                   Surface which = Surface::Both) {
  const bool isOuter = which != Surface::Inner, isInner = which != Surface::Outer && part.isBored();
  auto soup = std::make_shared<TriangleSoup>();
  Bands bands(*soup);
  std::uint32_t outer = 0, inner = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t s = samples[i];
    const std::uint32_t nextOuter = bands.ring(part.radius(s), part.z(s));
    const std::uint32_t nextInner = bands.ring(part.inner(s), part.z(s));
    if (i > 0) {
      if (isOuter) bands.band(outer, nextOuter);
      if (isInner) bands.band(nextInner, inner);
    }
    if (isOuter && s == 0) bands.band(nextInner, nextOuter);
    if (isOuter && s + 1 == part.size()) bands.band(nextOuter, nextInner);
    outer = nextOuter;
    inner = nextInner;
  }
  return soup;
}

// The part, or the bar that it is to become.
TurnedProfile shownProfile(const WorkpieceSnapshot& workpiece) {
  const StockCylinder& stock = workpiece.stock;
  if (workpiece.part) return workpiece.part->profile;
  return TurnedProfile(stock, stock.length / static_cast<double>(kBands));
}

// The samples of each band, the first of which is the last of the one before.
std::vector<std::vector<std::size_t>> bandsOf(const TurnedProfile& part) {
  std::vector<std::size_t> rings;
  const std::size_t stride = part.size() / kRings + 1;
  for (std::size_t i = 0; i + 1 < part.size(); i += stride) rings.push_back(i);
  rings.push_back(part.size() - 1);
  std::vector<std::vector<std::size_t>> bands;
  const std::size_t perBand = rings.size() / kBands + 1;
  for (std::size_t first = 0; first + 1 < rings.size(); first += perBand) {
    const std::size_t last = std::min(first + perBand, rings.size() - 1);
    bands.emplace_back(rings.begin() + static_cast<std::ptrdiff_t>(first),
                       rings.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  }
  return bands;
}

void addBand(DisplayModel& model, const char* name, std::shared_ptr<const TriangleSoup> soup,
             const std::array<float, 3>& colour, double base) {
  DisplayPart band;
  band.name = name + std::to_string(model.parts.size());
  band.group = kStockGroup;
  band.soup = std::move(soup);
  band.colour = colour;
  band.pose.translation().z() = base;
  model.parts.push_back(std::move(band));
}

// Bands of one colour beside each other are one part. What has no area is none: a view would wait for it.
template <class Colour>
void addBands(DisplayModel& model, const char* name, const TurnedProfile& part, double base, Surface which,
              Colour colourOf) {
  std::vector<std::size_t> run;
  std::array<float, 3> colour{};
  const auto end = [&] {
    const bool hasArea = std::any_of(run.begin(), run.end(), [&](std::size_t i) {
      return (which == Surface::Inner ? part.inner(i) : part.radius(i)) > 0.0;
    });
    if (hasArea) addBand(model, name, surfaceBetween(part, run, which), colour, base);
    run.clear();
  };
  for (const std::vector<std::size_t>& samples : bandsOf(part)) {
    const std::array<float, 3> next = colourOf(samples);
    if (!run.empty() && next != colour) end();
    colour = next;
    run.insert(run.end(), samples.begin() + (run.empty() ? 0 : 1), samples.end());
  }
  if (!run.empty()) end();
}

double worse(double a, double b) {
  return std::abs(b) > std::abs(a) ? b : a;
}

}  // namespace

DisplayModel deviationDisplay(const WorkpieceSnapshot& workpiece, const DeviationColour& colour) {
  const TargetProfile& target = workpiece.target->profile;
  const double base = workpiece.stock.position;
  const TurnedProfile part = shownProfile(workpiece);
  const AxisRange range = rangeOfTarget(target, part, base);
  const auto distanceAt = [&](std::size_t i) {
    if (part.z(i) < range.from) return 0.0;
    const double z = base + part.z(i);
    const double outside = target.distance({part.radius(i), z});
    return part.inner(i) > 0.0 ? worse(outside, target.distance({part.inner(i), z})) : outside;
  };
  DisplayModel model;
  addBands(model, "deviation.", part, base, Surface::Both, [&](const std::vector<std::size_t>& samples) {
    double largest = 0.0;
    for (const std::size_t s : samples) largest = worse(largest, distanceAt(s));
    return colour(largest);
  });
  return model;
}

// Between its rings a band has more samples, each of which counts.
DisplayModel finishDisplay(const WorkpieceSnapshot& workpiece, const FinishColour& colour) {
  const TurnedProfile part = shownProfile(workpiece);
  const SurfaceFinish finish = workpiece.part ? workpiece.part->finish : SurfaceFinish();
  DisplayModel model;
  for (const Surface which : {Surface::Outer, Surface::Inner}) {
    if (which == Surface::Inner && !part.isBored()) continue;
    const TurningSide side = which == Surface::Inner ? TurningSide::Bore : TurningSide::Outside;
    addBands(model, "finish.", part, workpiece.stock.position, which, [&](const std::vector<std::size_t>& samples) {
      std::optional<double> roughest;
      for (std::size_t i = samples.front(); i <= samples.back() && i < finish.size(); ++i) {
        const FinishMark mark = finish.at(side, i);
        if (mark.isKnown()) roughest = std::max(roughest.value_or(0.0), static_cast<double>(mark.roughness));
      }
      return colour(roughest);
    });
  }
  return model;
}

}  // namespace handwheel
