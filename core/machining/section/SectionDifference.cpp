// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/SectionDifference.h"

#include "machining/section/PlaneVectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kSnap = SectionDifference::kSnap;
constexpr double kOn = 2.0 * kSnap;  // mm; a piece whose middle is nearer than this to the other boundary lies on it

// The vertices of a difference. A point within kSnap of a vertex is that vertex.
class Vertices {
 public:
  std::size_t idOf(const ProfilePoint& p) {
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if ((m_points[i] - p).squaredNorm() <= kSnap * kSnap) return i;
    m_points.push_back(p);
    // A cutter that ends on the axis leaves no vertex below it.
    if (p.x() < 0.0 && p.x() >= -kSnap) m_points.back().x() = 0.0;
    return m_points.size() - 1;
  }
  const ProfilePoint& operator[](std::size_t id) const { return m_points[id]; }
  std::size_t size() const { return m_points.size(); }

 private:
  std::vector<ProfilePoint> m_points;
};

struct Split {
  double length = 0.0;  // mm from the start of the segment
  std::size_t vertex = 0;
};

// A piece of a boundary between two vertices.
struct BoundaryPiece {
  SectionSegment segment;
  std::size_t from = 0, to = 0;     // vertices
  std::vector<RunPart> parts = {};  // if not empty, the piece is these segments, which the cutter does not meet
  const SectionSegment& first() const { return parts.empty() ? segment : parts.front().front(); }
  const SectionSegment& last() const { return parts.empty() ? segment : parts.back().back(); }
};

// A segment of a loop that meets the cutter.
struct MetSegment {
  std::size_t loop, run, index;
  std::vector<Split> splits = {};
};

void addSplit(std::vector<Split>& splits, const SectionSegment& segment, const ProfilePoint& p, Vertices& vertices) {
  splits.push_back({std::clamp(segment.lengthTo(p), 0.0, segment.length()), vertices.idOf(p)});
}

// Splits two segments where they meet. An end that lies on the other segment is such a point; a crossing is none if the
// segments stay together from there to such an end.
void splitBoth(const SectionSegment& a, std::vector<Split>& ofA, const SectionSegment& b, std::vector<Split>& ofB,
               Vertices& vertices) {
  std::array<double, 4> ends{};  // mm along a
  std::size_t endCount = 0;
  const auto take = [&](const ProfilePoint& p) {
    addSplit(ofA, a, p, vertices);
    addSplit(ofB, b, p, vertices);
  };
  for (const ProfilePoint& end : {a.from, a.to, b.from, b.to}) {
    if (!a.isOn(end, kSnap) || !b.isOn(end, kSnap)) continue;
    take(end);
    ends[endCount++] = a.lengthTo(end);
  }
  const CarrierMeetings found = meetings(a.carrier, b.carrier, kSnap);
  for (std::size_t i = 0; i < found.count; ++i) {
    const ProfilePoint& p = found.points[i];
    if (!a.isOn(p, kSnap) || !b.isOn(p, kSnap)) continue;
    const double here = a.lengthTo(p);
    const bool isTogether = std::any_of(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(endCount),
                                        [&](double end) { return b.isOn(a.at(0.5 * (end + here)), kSnap); });
    if (!isTogether) take(p);
  }
}

// Appends the pieces of a segment between its splits.
void appendPieces(const SectionSegment& segment, std::vector<Split>& splits, Vertices& vertices,
                  std::vector<BoundaryPiece>& pieces) {
  const std::size_t first = vertices.idOf(segment.from), last = vertices.idOf(segment.to);
  std::sort(splits.begin(), splits.end(), [](const Split& a, const Split& b) { return a.length < b.length; });
  std::size_t before = first;
  const auto add = [&](std::size_t vertex) {
    if (vertex == before) return;
    SectionSegment piece = segment;
    piece.from = vertices[before];
    piece.to = vertices[vertex];
    pieces.push_back({piece, before, vertex});
    before = vertex;
  };
  for (const Split& split : splits) {
    if (split.vertex != first && split.vertex != last) add(split.vertex);
  }
  add(last);
}

// Returns the segments of a loop between two others, exclusive.
std::vector<RunPart> partsBetween(const SharedLoop& loop, const MetSegment& after, const MetSegment& before) {
  const std::vector<SectionRun::Pointer>& runs = loop.runs();
  std::vector<RunPart> parts;
  const auto take = [&](std::size_t run, std::size_t first, std::size_t last) {
    if (first < last) parts.push_back({runs[run], first, last});
  };
  if (after.run == before.run && after.index < before.index) {
    take(after.run, after.index + 1, before.index);
    return parts;
  }
  take(after.run, after.index + 1, runs[after.run]->segments.size());
  for (std::size_t r = (after.run + 1) % runs.size(); r != before.run; r = (r + 1) % runs.size())
    take(r, 0, runs[r]->segments.size());
  take(before.run, 0, before.index);
  return parts;
}

// Returns the number of crossings of a ray from a point, or nothing if the ray passes an end too closely to tell.
std::optional<int> crossings(const SectionSegment& segment, const ProfilePoint& p, const ProfilePoint& ahead) {
  constexpr double kClose = 1e-9;  // mm
  const double from = crossProduct(ahead, segment.from - p), to = crossProduct(ahead, segment.to - p);
  if (!segment.carrier.isCircle()) {
    if (std::max(from, to) < -kClose || std::min(from, to) > kClose) return 0;
    const bool isAhead = (segment.from - p).dot(ahead) > -kClose || (segment.to - p).dot(ahead) > -kClose;
    if (!isAhead) return 0;
    if (std::abs(from) <= kClose || std::abs(to) <= kClose) return std::nullopt;
    const ProfilePoint at = segment.from + from / (from - to) * (segment.to - segment.from);
    return (at - p).dot(ahead) > 0.0 ? 1 : 0;
  }
  // An arc of less than half a circle stays within half of its chord from that.
  const ProfilePoint begin = segment.from - segment.carrier.point, end = segment.to - segment.carrier.point;
  const bool isMinor = segment.carrier.radius * crossProduct(begin, end) > 0.0;
  const double half = 0.5 * (segment.to - segment.from).norm() + kClose;
  if (isMinor && (std::max(from, to) < -half || std::min(from, to) > half)) return 0;
  const double radius = std::abs(segment.carrier.radius);
  const ProfilePoint toCentre = segment.carrier.point - p;
  const double off = crossProduct(ahead, toCentre), foot = toCentre.dot(ahead);
  if (std::abs(off) > radius + kClose || foot < -radius - kClose) return 0;
  const double square = (radius - off) * (radius + off);
  const double whole = segment.length();
  if (square < 1e-12 * radius * radius) {
    // The ray touches the circle. That matters only if the arc is there.
    const double at = segment.lengthTo(p + foot * ahead);
    constexpr double kNear = 1e-4;
    return at > -kNear * radius && at < whole + kNear * radius ? std::nullopt : std::optional(0);
  }
  int count = 0;
  for (const double side : {-1.0, 1.0}) {
    const double distance = foot + side * std::sqrt(square);
    if (distance < 0.0) continue;
    const ProfilePoint at = p + distance * ahead;
    if ((at - segment.from).norm() <= kClose || (at - segment.to).norm() <= kClose) return std::nullopt;
    const double here = segment.lengthTo(at);
    if (here > 0.0 && here < whole) ++count;
  }
  return count;
}

// Returns true if a ray from a point may meet a box.
bool mayMeet(const ProfileBox& box, const ProfilePoint& p, const ProfilePoint& ahead) {
  const ProfilePoint centre = box.center() - p, half = 0.5 * box.sizes();
  const double beside = half.x() * std::abs(ahead.y()) + half.y() * std::abs(ahead.x()) + kOn;
  const double behind = half.x() * std::abs(ahead.x()) + half.y() * std::abs(ahead.y()) + kOn;
  return std::abs(crossProduct(ahead, centre)) <= beside && centre.dot(ahead) >= -behind;
}

std::optional<bool> isInsideAlong(std::span<const SharedLoop> loops, const ProfilePoint& p, const ProfilePoint& ahead) {
  int count = 0;
  for (const SharedLoop& loop : loops) {
    for (const SectionRun::Pointer& run : loop.runs()) {
      if (!mayMeet(run->box, p, ahead)) continue;
      for (const SectionSegment& segment : run->segments) {
        const std::optional<int> here = crossings(segment, p, ahead);
        if (!here) return std::nullopt;
        count += *here;
      }
    }
  }
  return count % 2 == 1;
}

enum class PieceSide { Inside, Outside, OnSame, OnOpposite };

// Returns the largest distance of a segment from the ends and the middle of a piece, or infinity if the piece does not
// run along the segment.
double distanceAlong(const BoundaryPiece& piece, const ProfilePoint& middle, const SectionSegment& other) {
  double largest = 0.0;
  for (const ProfilePoint& p : {middle, piece.segment.from, piece.segment.to}) {
    largest = std::max(largest, (other.nearest(p) - p).norm());
    if (largest > kOn) return std::numeric_limits<double>::infinity();
  }
  return largest;
}

// Returns the side of a boundary on which a piece lies. beside: the segments of the boundary near it. Of several
// segments within kOn, as in a slender wedge, the nearest one counts.
PieceSide sideOf(const BoundaryPiece& piece, std::span<const SectionSegment* const> beside,
                 std::span<const SharedLoop> loops) {
  const ProfilePoint middle = piece.segment.at(0.5 * piece.segment.length());
  double least = std::numeric_limits<double>::infinity(), cosine = 0.0;
  for (const SectionSegment* other : beside) {
    const double here = distanceAlong(piece, middle, *other);
    if (here >= least) continue;
    const double turn = piece.segment.carrier.direction(middle).dot(other->carrier.direction(middle));
    constexpr double kAlong = 0.9;  // other curves only cross here
    if (std::abs(turn) < kAlong) continue;
    least = here;
    cosine = turn;
  }
  if (cosine != 0.0) return cosine > 0.0 ? PieceSide::OnSame : PieceSide::OnOpposite;
  return isInside(loops, middle) ? PieceSide::Inside : PieceSide::Outside;
}

// Returns the angle from one direction to another, clockwise, in (0, 2π].
double clockwise(const ProfilePoint& from, const ProfilePoint& to) {
  const double angle = std::atan2(-crossProduct(from, to), from.dot(to));
  return angle > 0.0 ? angle : angle + 2.0 * M_PI;
}

// Returns which of several segments that leave the end of another one turns most to the left. Where curves touch, what
// they do next decides.
std::size_t leftmost(const SectionSegment& arriving, std::span<const SectionSegment* const> leaving) {
  const ProfilePoint back = -arriving.carrier.direction(arriving.to);
  std::vector<double> angles;
  for (const SectionSegment* out : leaving) angles.push_back(clockwise(back, out->carrier.direction(out->from)));
  constexpr double kTied = 1e-5;  // rad
  bool isTied = false;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    isTied = isTied || angles[i] < kTied || angles[i] > 2.0 * M_PI - kTied;
    for (std::size_t k = 0; k < i; ++k) isTied = isTied || std::abs(angles[i] - angles[k]) < kTied;
  }
  if (isTied) {
    double reach = arriving.length();
    for (const SectionSegment* out : leaving) reach = std::min(reach, out->length());
    const ProfilePoint& vertex = arriving.to;
    const ProfilePoint backward = arriving.at(arriving.length() - 0.5 * reach) - vertex;
    for (std::size_t i = 0; i < leaving.size(); ++i)
      angles[i] = clockwise(backward, leaving[i]->at(0.5 * reach) - vertex);
  }
  return static_cast<std::size_t>(std::min_element(angles.begin(), angles.end()) - angles.begin());
}

// Chains directed pieces to closed loops. Of several pieces that leave a vertex, the one that turns most to the left is
// next, so that loops which touch in a vertex stay apart.
std::optional<std::vector<SharedLoop>> chained(const std::vector<BoundaryPiece>& pieces, std::size_t vertexCount) {
  std::vector<std::vector<std::size_t>> leaving(vertexCount);
  std::vector<int> balance(vertexCount, 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    leaving[pieces[i].from].push_back(i);
    ++balance[pieces[i].from];
    --balance[pieces[i].to];
  }
  if (std::any_of(balance.begin(), balance.end(), [](int count) { return count != 0; })) return std::nullopt;
  std::vector<bool> isUsed(pieces.size(), false);
  std::vector<SharedLoop> loops;
  for (std::size_t start = 0; start < pieces.size(); ++start) {
    if (isUsed[start]) continue;
    SharedLoopBuilder loop;
    std::size_t now = start;
    while (true) {
      isUsed[now] = true;
      for (const RunPart& part : pieces[now].parts) loop.add(part);
      if (pieces[now].parts.empty()) loop.add(pieces[now].segment);
      if (pieces[now].to == pieces[start].from && leaving[pieces[start].from].size() == 1) break;
      std::vector<std::size_t> others;
      std::vector<const SectionSegment*> out;
      for (const std::size_t other : leaving[pieces[now].to]) {
        if (isUsed[other] && other != start) continue;
        others.push_back(other);
        out.push_back(&pieces[other].first());
      }
      if (others.empty()) return std::nullopt;
      const std::size_t next = others.size() == 1 ? others.front() : others[leftmost(pieces[now].last(), out)];
      if (next == start) break;
      now = next;
    }
    loops.push_back(loop.finish());
  }
  return loops;
}

// Calls visit(segment) with the segments of parts, until it returns false. Returns false if it did.
template <class Visit>
bool eachSegmentOf(std::span<const RunPart> parts, Visit visit) {
  for (const RunPart& part : parts)
    for (std::size_t i = part.first; i < part.last; ++i)
      if (!visit(part.run->segments[i])) return false;
  return true;
}

// Returns true if the sides of a loop coincide: it encloses nothing.
bool isSliver(const SectionLoop& loop) {
  double length = 0.0;
  for (const SectionSegment& segment : loop) length += segment.length();
  return areaOf(loop) <= 0.5 * length * kOn;
}

bool meets(const ProfileBox& a, const ProfileBox& b) {
  return (a.min().array() <= b.max().array() + kOn).all() && (b.min().array() <= a.max().array() + kOn).all();
}

}  // namespace

bool isInside(std::span<const SharedLoop> loops, const ProfilePoint& p) {
  static const std::array<ProfilePoint, 5> kDirections{ProfilePoint(1.0, 0.0), ProfilePoint(0.8, 0.6),
                                                       ProfilePoint(0.28, -0.96), ProfilePoint(-0.352, 0.936),
                                                       ProfilePoint(0.5376, 0.8432)};
  for (const ProfilePoint& ahead : kDirections) {
    if (const std::optional<bool> known = isInsideAlong(loops, p, ahead.normalized())) return *known;
  }
  return false;
}

namespace {

// A subtraction of a cutter from loops.
class Subtraction {
 public:
  Subtraction(const std::vector<SharedLoop>& loops, const SectionLoop& cutter)
      : m_loops(loops), m_cutter(cutter), m_box(boxOf(cutter)), m_area{SharedLoop({SectionRun::of(cutter)})} {}

  std::optional<SectionDifference> run() {
    if (isSliver(m_cutter)) return SectionDifference();
    findMeetings();
    cutLoops();
    addCutter();
    if (!m_isAnyDropped) return SectionDifference();
    m_result.unchanged = m_result.loops.size();
    m_kept.insert(m_kept.end(), m_added.begin(), m_added.end());
    std::optional<std::vector<SharedLoop>> all = chained(m_kept, m_vertices.size());
    if (!all) return std::nullopt;
    constexpr double kLeastArea = 1e-10;  // mm², slivers of the snapping
    for (SharedLoop& loop : *all) {
      constexpr std::size_t kMostOfSliver = 16;  // segments
      if (loop.size() > kMostOfSliver || std::abs(loop.area()) > kLeastArea) m_result.loops.push_back(std::move(loop));
    }
    return std::move(m_result);
  }

 private:
  const SectionSegment& segmentOf(const MetSegment& met) const {
    return m_loops[met.loop].runs()[met.run]->segments[met.index];
  }

  // Counts a piece of the boundary of what is removed.
  void drop(const SectionSegment& segment) {
    m_isAnyDropped = true;
    m_result.removal.area += segment.moment();
    m_result.removal.volume += M_PI * segment.squareMoment();
    m_result.removal.box.extend(segment.box());
  }

  void findMeetings() {
    m_cutterSplits.resize(m_cutter.size());
    std::vector<ProfileBox> boxes;
    for (const SectionSegment& segment : m_cutter) boxes.push_back(segment.box());
    for (std::size_t k = 0; k < m_loops.size(); ++k) {
      for (std::size_t r = 0; r < m_loops[k].runs().size(); ++r) {
        const SectionRun& run = *m_loops[k].runs()[r];
        for (std::size_t i = 0; i < run.segments.size() && meets(run.box, m_box); ++i) {
          const SectionSegment& segment = run.segments[i];
          if (!meets(segment.looseBox(), m_box)) continue;
          MetSegment met{k, r, i};
          const ProfileBox own = segment.box();
          for (std::size_t b = 0; b < m_cutter.size(); ++b)
            if (meets(own, boxes[b])) splitBoth(segment, met.splits, m_cutter[b], m_cutterSplits[b], m_vertices);
          if (!met.splits.empty()) m_met.push_back(std::move(met));
        }
      }
    }
    m_isMeeting.assign(m_vertices.size(), false);
    for (const std::vector<Split>& splits : m_cutterSplits)
      for (const Split& split : splits) m_isMeeting[split.vertex] = true;
  }

  // Keeps or drops the pieces of the loops. A loop that the cutter does not meet stays as it is, or lies in the cutter.
  void cutLoops() {
    std::vector<const SectionSegment*> cutter;
    for (const SectionSegment& segment : m_cutter) cutter.push_back(&segment);
    std::size_t next = 0;
    for (std::size_t k = 0; k < m_loops.size(); ++k) {
      const std::size_t first = next;
      while (next < m_met.size() && m_met[next].loop == k) ++next;
      if (next == first) {
        std::vector<RunPart> all;
        for (const SectionRun::Pointer& run : m_loops[k].runs()) all.push_back({run, 0, run->segments.size()});
        if (!isDropped(all)) m_result.loops.push_back(m_loops[k]);
        continue;
      }
      for (std::size_t n = first; n < next; ++n) {
        std::vector<BoundaryPiece> pieces;
        appendPieces(segmentOf(m_met[n]), m_met[n].splits, m_vertices, pieces);
        for (const BoundaryPiece& piece : pieces) {
          const PieceSide side = sideOf(piece, cutter, m_area);
          if (side == PieceSide::Outside || side == PieceSide::OnOpposite)
            m_kept.push_back(piece);
          else
            drop(piece.segment);
        }
        BoundaryPiece rest;
        rest.parts = partsBetween(m_loops[k], m_met[n], m_met[n + 1 < next ? n + 1 : first]);
        if (rest.parts.empty() || isDropped(rest.parts)) continue;
        rest.from = m_vertices.idOf(rest.first().from);
        rest.to = m_vertices.idOf(rest.last().to);
        m_kept.push_back(std::move(rest));
      }
    }
  }

  // Drops segments that the cutter does not meet if it contains them. Returns true if it does.
  bool isDropped(std::span<const RunPart> parts) {
    for (const RunPart& part : parts)
      if (!meets(part.run->box, m_box)) return false;
    ProfilePoint middle(0.0, 0.0);
    double longest = -1.0;
    const bool isNear = eachSegmentOf(parts, [&](const SectionSegment& segment) {
      const double length = (segment.to - segment.from).norm();
      if (length > longest) middle = segment.at(0.5 * segment.length());
      longest = std::max(longest, length);
      return meets(segment.looseBox(), m_box);
    });
    if (!isNear || !isInside(m_area, middle)) return false;
    eachSegmentOf(parts, [&](const SectionSegment& segment) {
      drop(segment);
      return true;
    });
    return true;
  }

  // Adds the pieces of the cutter that are in the material. The side changes only where the cutter meets the loops, so
  // most pieces are on that of the piece before.
  void addCutter() {
    std::vector<const SectionSegment*> beside;
    for (const MetSegment& met : m_met) beside.push_back(&segmentOf(met));
    std::optional<PieceSide> before;
    for (std::size_t b = 0; b < m_cutter.size(); ++b) {
      std::vector<BoundaryPiece> pieces;
      appendPieces(m_cutter[b], m_cutterSplits[b], m_vertices, pieces);
      for (BoundaryPiece& piece : pieces) {
        const bool goesOn = before && (piece.from >= m_isMeeting.size() || !m_isMeeting[piece.from]);
        before = goesOn ? before : std::optional(sideOf(piece, beside, m_loops));
        if (before != PieceSide::Inside) continue;
        drop(piece.segment);
        piece.segment = piece.segment.reversed();
        std::swap(piece.from, piece.to);
        m_added.push_back(piece);
      }
    }
  }

  const std::vector<SharedLoop>& m_loops;
  const SectionLoop& m_cutter;
  ProfileBox m_box;
  std::array<SharedLoop, 1> m_area;  // the cutter
  Vertices m_vertices;
  std::vector<MetSegment> m_met;  // in the order of the loops
  std::vector<std::vector<Split>> m_cutterSplits;
  std::vector<bool> m_isMeeting;  // true for vertices at which the cutter meets a loop
  std::vector<BoundaryPiece> m_kept, m_added;
  bool m_isAnyDropped = false;
  SectionDifference m_result;
};

}  // namespace

std::optional<SectionDifference> differenceOf(const std::vector<SharedLoop>& loops, const SectionLoop& cutter) {
  return Subtraction(loops, cutter).run();
}

}  // namespace handwheel
