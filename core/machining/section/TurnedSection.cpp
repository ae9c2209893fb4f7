// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/TurnedSection.h"

#include "machining/section/SectionDifference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Calls take(r) with the radii at which a segment crosses a height. O(1).
template <class Take>
void eachRadiusAt(const SectionSegment& segment, double z, Take take) {
  const SectionCarrier& carrier = segment.carrier;
  if (!carrier.isCircle()) {
    const double low = std::min(segment.from.y(), segment.to.y()), high = std::max(segment.from.y(), segment.to.y());
    if (z < low || z > high || !(high > low)) return;
    const double t = (z - segment.from.y()) / (segment.to.y() - segment.from.y());
    take(segment.from.x() + t * (segment.to.x() - segment.from.x()));
    return;
  }
  const double up = z - carrier.point.y(), radius = std::abs(carrier.radius), square = (radius - up) * (radius + up);
  if (square < 0.0) return;
  const double whole = segment.length();
  for (const double side : {-1.0, 1.0}) {
    const ProfilePoint p(carrier.point.x() + side * std::sqrt(square), z);
    const double here = segment.lengthTo(p);
    if (here >= 0.0 && here <= whole) take(p.x());
  }
}

// The least and the largest radius that were seen at a height.
struct RadiusRange {
  double least = kInfinity, largest = -kInfinity;
  void take(double r) {
    least = std::min(least, r);
    largest = std::max(largest, r);
  }
  bool isEmpty() const { return !(largest > least); }
};

constexpr double kBeside = 1e-7;  // mm below and above a height, where a face at the height does not count

}  // namespace

void SectionRemoval::add(const SectionRemoval& other) {
  area += other.area;
  volume += other.volume;
  box.extend(other.box);
  gone.extend(other.gone);
}

TurnedSection::TurnedSection(const StockCylinder& stock) {
  const double r = 0.5 * stock.diameter, length = stock.length;
  const std::array<ProfilePoint, 4> corners{ProfilePoint(0, 0), ProfilePoint(r, 0), ProfilePoint(r, length),
                                            ProfilePoint(0, length)};
  SectionLoop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.push_back(SectionSegment::line(corners[i], corners[(i + 1) % corners.size()]));
  m_box = boxOf(loop);
  m_loops.push_back(SharedLoop::of(loop));
}

std::size_t TurnedSection::size() const {
  std::size_t sum = 0;
  for (const SharedLoop& loop : m_loops) sum += loop.size();
  return sum;
}

double TurnedSection::area() const {
  double sum = 0.0;
  for (const SharedLoop& loop : m_loops) sum += loop.area();
  return sum;
}

double TurnedSection::volume() const {
  double sum = 0.0;
  for (const SharedLoop& loop : m_loops) sum += loop.volume();
  return sum;
}

TurnedSection::TurnedSection(const std::vector<SectionLoop>& loops) {
  for (const SectionLoop& loop : loops)
    if (!loop.empty()) m_loops.push_back(SharedLoop::of(loop));
  findBox();
}

TurnedSection::TurnedSection(std::vector<SharedLoop> loops) : m_loops(std::move(loops)) {
  findBox();
}

void TurnedSection::findBox() {
  m_box = ProfileBox();
  for (const SharedLoop& loop : m_loops) m_box.extend(loop.box());
}

std::vector<TurnedSection> TurnedSection::pieces() const {
  std::vector<std::vector<SharedLoop>> pieces;
  for (const SharedLoop& loop : m_loops)
    if (loop.area() > 0.0) pieces.push_back({loop});
  for (const SharedLoop& loop : m_loops) {
    if (loop.area() > 0.0) continue;
    const auto owner = std::find_if(pieces.begin(), pieces.end(), [&](const std::vector<SharedLoop>& piece) {
      const ProfilePoint p = loop.pointOnBoundary();
      return piece.front().box().contains(p) && isInside(std::span(&piece.front(), 1), p);
    });
    if (owner != pieces.end()) owner->push_back(loop);
  }
  std::vector<TurnedSection> all;
  for (std::vector<SharedLoop>& piece : pieces) all.push_back(TurnedSection(std::move(piece)));
  std::sort(all.begin(), all.end(),
            [](const TurnedSection& a, const TurnedSection& b) { return a.box().min().y() < b.box().min().y(); });
  return all;
}

std::optional<SectionRemoval> TurnedSection::subtract(const SectionCutter& cutter, std::uint32_t pass,
                                                      bool isOfTrailingEdge, double toolHeight) {
  // A larger cutter leaves the positions in which boundaries nearly coincide.
  static constexpr std::array<double, 6> kGrown{0.0, 6e-8, 1.7e-7, 3.1e-7, 5.3e-7, 8.9e-7};
  for (const double grown : kGrown) {
    SectionRemoval removal;
    SectionLoop area = cutter(grown);
    if (area.empty()) return removal;
    for (SectionSegment& segment : area) {
      segment.pass = pass;
      segment.isOfTrailingEdge = isOfTrailingEdge;
    }
    if (subtractOnce(area, toolHeight, removal)) return removal;
  }
  return std::nullopt;
}

bool TurnedSection::subtractOnce(const SectionLoop& cutter, double toolHeight, SectionRemoval& removal) {
  std::optional<SectionDifference> difference = differenceOf(m_loops, cutter);
  if (!difference) return false;
  removal = difference->removal;
  if (removal.isEmpty()) return true;
  std::size_t segments = 0;
  for (const SharedLoop& loop : difference->loops) segments += loop.size();
  if (segments > kMostSegments) return false;
  m_loops = std::move(difference->loops);
  removal.gone = removal.box;
  if (m_loops.size() > 1) removal.gone.extend(dropChips(difference->unchanged, boxOf(cutter), toolHeight));
  constexpr double kSlack = 1e-6;  // mm
  const bool isWithin = (removal.gone.min().array() > m_box.min().array() + kSlack).all() &&
                        (removal.gone.max().array() < m_box.max().array() - kSlack).all();
  if (!isWithin || m_loops.empty()) findBox();
  return true;
}

// The piece in the chuck is the one that reaches lowest. Pieces that the cut did not change stay.
ProfileBox TurnedSection::dropChips(std::size_t unchanged, const ProfileBox& cutter, double toolHeight) {
  constexpr double kSlack = 1e-6;  // mm
  const auto lowest = std::min_element(m_loops.begin(), m_loops.end(), [](const SharedLoop& a, const SharedLoop& b) {
    return a.box().min().y() < b.box().min().y();
  });
  std::vector<SharedLoop> left, chips;
  for (auto loop = m_loops.begin(); loop != m_loops.end(); ++loop) {
    const ProfileBox& box = loop->box();
    const bool isWithin = box.min().y() >= cutter.min().y() - kSlack && box.max().y() <= cutter.max().y() + kSlack &&
                          box.sizes().y() <= toolHeight + kSlack;
    const bool isOld = loop - m_loops.begin() < static_cast<std::ptrdiff_t>(unchanged);
    const bool isChip = !isOld && loop != lowest && isWithin && loop->area() > 0.0;
    (isChip ? chips : left).push_back(*loop);
  }
  // A hollow falls off with the chip that it is in.
  std::erase_if(left,
                [&](const SharedLoop& loop) { return loop.area() < 0.0 && isInside(chips, loop.pointOnBoundary()); });
  m_loops = std::move(left);
  ProfileBox gone;
  for (const SharedLoop& chip : chips) gone.extend(chip.box());
  return gone;
}

bool TurnedSection::contains(const ProfilePoint& p) const {
  return isInside(m_loops, p);
}

std::optional<TurnedSection::Radii> TurnedSection::radiiAt(double z) const {
  std::array<RadiusRange, 2> sides;
  eachSegment(ProfileBox(ProfilePoint(-kInfinity, z - kBeside), ProfilePoint(kInfinity, z + kBeside)),
              [&](const SectionSegment& segment) {
                for (std::size_t side = 0; side < 2; ++side)
                  eachRadiusAt(segment, z + (side == 0 ? -kBeside : kBeside), [&](double r) { sides[side].take(r); });
              });
  if (sides[0].isEmpty() && sides[1].isEmpty()) return std::nullopt;
  const RadiusRange& below = sides[0].isEmpty() ? sides[1] : sides[0];
  const RadiusRange& above = sides[1].isEmpty() ? sides[0] : sides[1];
  const Radii radii{std::max({below.least, above.least, 0.0}), std::min(below.largest, above.largest)};
  return radii.inner < radii.outer ? std::optional(radii) : std::nullopt;
}

std::vector<double> TurnedSection::heightsAt(double radius) const {
  const SectionCarrier across{{radius, 0.0}, {0.0, 1.0}, 0.0};
  constexpr double kSlack = 1e-7;  // mm
  std::vector<double> heights;
  const ProfileBox there(ProfilePoint(radius - kSlack, -kInfinity), ProfilePoint(radius + kSlack, kInfinity));
  eachSegment(there, [&](const SectionSegment& segment) {
    const CarrierMeetings found = meetings(segment.carrier, across, kSlack);
    for (std::size_t i = 0; i < found.count; ++i)
      if (segment.isOn(found.points[i], kSlack)) heights.push_back(found.points[i].y());
  });
  return heights;
}

TurnedProfile::Range TurnedSection::sample(TurnedProfile& profile, const TurnedProfile::Range& range) const {
  TurnedProfile::Range changed;
  if (range.isEmpty()) return changed;
  std::vector<std::array<RadiusRange, 2>> seen(range.size());
  const double spacing = profile.spacing();
  const double first = static_cast<double>(range.first), last = static_cast<double>(range.last);
  const ProfileBox there(ProfilePoint(-kInfinity, (first - 1.0) * spacing), ProfilePoint(kInfinity, last * spacing));
  eachSegment(there, [&](const SectionSegment& segment) {
    const ProfileBox box = segment.looseBox();
    const double low = std::ceil((box.min().y() - kBeside) / spacing), high = (box.max().y() + kBeside) / spacing;
    for (double i = std::max(low, first); i <= high && i < last; ++i) {
      const auto at = static_cast<std::size_t>(i);
      for (std::size_t side = 0; side < 2; ++side)
        eachRadiusAt(segment, profile.z(at) + (side == 0 ? -kBeside : kBeside),
                     [&](double r) { seen[at - range.first][side].take(r); });
    }
  });
  for (std::size_t i = range.first; i < range.last; ++i) {
    const auto& [below, above] = seen[i - range.first];
    // The ends of the bar have material on one side only.
    const RadiusRange& low = i == 0 ? above : below;
    const RadiusRange& high = i + 1 == profile.size() ? below : above;
    const bool isSolid = !low.isEmpty() && !high.isEmpty();
    // A cut only removes, whatever the rounding of the boundary.
    const double most = profile.radius(i), least = profile.inner(i);
    const double inner = isSolid ? std::clamp(std::max(low.least, high.least), least, most) : least;
    const double outer = isSolid ? std::clamp(std::min(low.largest, high.largest), inner, most) : inner;
    if (profile.set(i, outer, inner)) changed.extend({i, i + 1});
  }
  return changed;
}

}  // namespace handwheel
