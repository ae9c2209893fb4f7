// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ProximityQuery.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace handwheel {

namespace {

// Relative to lengths: far more than the rounding of sums of poses and travels.
constexpr double kTravelRounding = 1e-9;
// A query with a larger reach than necessary saves the queries of this many steps.
constexpr double kStepsAhead = 8.0;
// mm: bodies whose spheres are no further apart are tested for contacts.
constexpr double kTouchingSpheres = 1e-9;

}  // namespace

ProximityQuery::ProximityQuery(std::vector<CollisionBody> bodies, const std::vector<BodyPair>& pairs) {
  for (CollisionBody& body : bodies) {
    m_bodies.push_back({.body = std::move(body)});
    m_bodies.back().centre = m_bodies.back().body.centre();
  }
  for (const BodyPair& pair : pairs) {
    assert(pair.first < m_bodies.size() && pair.second < m_bodies.size());
    const auto begin = static_cast<std::uint32_t>(m_pieces.size()), number = static_cast<std::uint32_t>(m_pairs.size());
    for (std::uint32_t i = 0; i < m_bodies[pair.first].body.pieces().size(); ++i) {
      for (std::uint32_t j = 0; j < m_bodies[pair.second].body.pieces().size(); ++j) m_pieces.push_back({number, i, j});
    }
    m_pairs.push_back({pair, begin, static_cast<std::uint32_t>(m_pieces.size())});
  }
}

void ProximityQuery::place(std::uint32_t body, const Pose& pose) {
  Placed& placed = m_bodies[body];
  const bool wasSomewhere = placed.isSomewhere;
  placed.isSomewhere = pose.matrix().allFinite();
  if (!placed.isSomewhere) return;
  const Vec3 centre = pose * placed.body.centre();
  // No point of a ball is moved further by a rotation than the norm of the difference of two rotations times its
  // radius.
  placed.step = (centre - placed.centre).norm() +
                M_SQRT1_2 * (pose.linear() - placed.pose.linear()).norm() * placed.body.radius();
  placed.travel += placed.step;
  placed.pose = pose;
  placed.centre = centre;
  if (wasSomewhere && placed.travel < 1.0 / kTravelRounding) return;
  // The former distances are not known any more, or the sum of the travel has become coarse.
  for (Pieces& pieces : m_pieces) {
    const BodyPair& pair = m_pairs[pieces.pair].bodies;
    if (pair.first == body || pair.second == body) pieces.bound = -std::numeric_limits<double>::infinity();
  }
  placed.travel = 0.0;
}

bool ProximityQuery::isApart(const Pair& pair, double enough) {
  const Placed &a = m_bodies[pair.bodies.first], &b = m_bodies[pair.bodies.second];
  if (!a.isSomewhere || !b.isSomewhere) return true;
  return (a.centre - b.centre).norm() - a.body.radius() - b.body.radius() >= enough;
}

double ProximityQuery::boundOf(const Pieces& pieces) {
  ++m_counts.bounds;
  const Pair& pair = m_pairs[pieces.pair];
  const Placed &a = m_bodies[pair.bodies.first], &b = m_bodies[pair.bodies.second];
  const double travel = a.travel + b.travel, moved = travel - pieces.travel;
  const double kept = pieces.bound - moved - kTravelRounding * (moved + std::abs(pieces.bound) + 1.0);
  const CollisionPiece &first = a.body.pieces()[pieces.first], &second = b.body.pieces()[pieces.second];
  const double apart = (a.pose * first.centre - b.pose * second.centre).norm();
  return std::max(kept, apart - first.radius - second.radius - kTravelRounding * apart);
}

// Returns the additional reach of a query: as large as pays off, 0 if bodies leap.
double ProximityQuery::marginOf(const Pair& pair, double enough) const {
  const double ahead = kStepsAhead * (m_bodies[pair.bodies.first].step + m_bodies[pair.bodies.second].step);
  return ahead <= 0.5 * enough ? ahead : 0.0;
}

void ProximityQuery::learn(Pieces& pieces, double bound) {
  const Pair& pair = m_pairs[pieces.pair];
  pieces.bound = bound > 0.0 ? bound : -std::numeric_limits<double>::infinity();
  pieces.travel = m_bodies[pair.bodies.first].travel + m_bodies[pair.bodies.second].travel;
}

std::optional<ClosestPoints> ProximityQuery::look(Pieces& pieces, double enough, double margin) {
  const Placed &a = m_bodies[m_pairs[pieces.pair].bodies.first], &b = m_bodies[m_pairs[pieces.pair].bodies.second];
  const CollisionPiece &first = a.body.pieces()[pieces.first], &second = b.body.pieces()[pieces.second];
  const auto found = closestPoints(first, a.pose * first.pose, second, b.pose * second.pose, enough + margin,
                                   pieces.hint, m_counts, m_tolerance);
  learn(pieces, found ? found->distance - m_tolerance : enough + margin);
  return found && found->distance < enough ? found : std::nullopt;
}

bool ProximityQuery::isOverlapping() {
  for (const Pair& pair : m_pairs) {
    if (isApart(pair, 0.0)) continue;
    const Placed &a = m_bodies[pair.bodies.first], &b = m_bodies[pair.bodies.second];
    for (std::uint32_t i = pair.begin; i < pair.end; ++i) {
      Pieces& pieces = m_pieces[i];
      if (boundOf(pieces) > 0.0) continue;
      const CollisionPiece &first = a.body.pieces()[pieces.first], &second = b.body.pieces()[pieces.second];
      if (areMeeting(first, a.pose * first.pose, second, b.pose * second.pose, pieces.hint, m_counts)) return true;
    }
  }
  return false;
}

bool ProximityQuery::isNearer(Pieces& pieces, double than) {
  if (boundOf(pieces) >= than) return false;
  const Pair& pair = m_pairs[pieces.pair];
  const Placed &a = m_bodies[pair.bodies.first], &b = m_bodies[pair.bodies.second];
  const CollisionPiece &first = a.body.pieces()[pieces.first], &second = b.body.pieces()[pieces.second];
  const double bound = distanceBound(first, a.pose * first.pose, second, b.pose * second.pose, than,
                                     than + marginOf(pair, than), pieces.hint, m_counts);
  if (bound < than) return true;
  learn(pieces, bound);
  return false;
}

bool ProximityQuery::isNearer(double than) {
  if (!(than > 0.0)) return false;
  // The pair that was too near last time is mostly too near again.
  if (m_last < m_pieces.size() && !isApart(m_pairs[m_pieces[m_last].pair], than) && isNearer(m_pieces[m_last], than))
    return true;
  for (const Pair& pair : m_pairs) {
    if (isApart(pair, than)) continue;
    for (std::uint32_t i = pair.begin; i < pair.end; ++i) {
      if (i == m_last || !isNearer(m_pieces[i], than)) continue;
      m_last = i;
      return true;
    }
  }
  return false;
}

// The pairs with the least bounds are tested first: the nearest one is then soon known, and the others are skipped.
std::optional<NearPair> ProximityQuery::closest(double enough) {
  std::optional<NearPair> best;
  double least = enough;
  m_order.clear();
  for (const Pair& pair : m_pairs) {
    if (isApart(pair, least)) continue;
    for (std::uint32_t i = pair.begin; i < pair.end; ++i) m_order.emplace_back(boundOf(m_pieces[i]), i);
  }
  std::sort(m_order.begin(), m_order.end());
  const auto last =
      std::find_if(m_order.begin(), m_order.end(), [&](const auto& each) { return each.second == m_last; });
  if (last != m_order.end()) std::rotate(m_order.begin(), last, last + 1);
  for (const auto& [bound, i] : m_order) {
    if (bound >= least - (best ? m_tolerance : 0.0)) continue;
    const auto found = look(m_pieces[i], least, marginOf(m_pairs[m_pieces[i].pair], least));
    if (!found) continue;
    least = found->distance;
    best = {m_pairs[m_pieces[i].pair].bodies, *found};
    m_last = i;
  }
  return best;
}

void ProximityQuery::findNear(double threshold, std::vector<NearPair>& near) {
  near.clear();
  for (const Pair& pair : m_pairs) {
    if (isApart(pair, threshold)) continue;
    const double margin = marginOf(pair, threshold);
    double least = threshold;
    std::optional<ClosestPoints> best;
    for (std::uint32_t i = pair.begin; i < pair.end; ++i) {
      if (boundOf(m_pieces[i]) >= least - (best ? m_tolerance : 0.0)) continue;
      const auto found = look(m_pieces[i], least, margin);
      if (!found) continue;
      best = found;
      least = found->distance;
    }
    if (best) near.push_back({pair.bodies, *best});
  }
}

bool ProximityQuery::findContacts(double margin, std::size_t most, std::vector<BodyContact>& contacts) {
  contacts.clear();
  if (!(margin >= 0.0)) return true;
  for (const Pair& pair : m_pairs) {
    if (isApart(pair, std::max(margin, kTouchingSpheres))) continue;
    const Placed &a = m_bodies[pair.bodies.first], &b = m_bodies[pair.bodies.second];
    for (std::uint32_t i = pair.begin; i < pair.end; ++i) {
      Pieces& pieces = m_pieces[i];
      if (margin > 0.0 ? !isNearer(pieces, margin) : boundOf(pieces) > 0.0) continue;
      const CollisionPiece &first = a.body.pieces()[pieces.first], &second = b.body.pieces()[pieces.second];
      m_contacts.clear();
      addContacts(first, a.pose * first.pose, second, b.pose * second.pose, margin, most - contacts.size(), m_contacts,
                  m_counts);
      for (const PieceContact& each : m_contacts) contacts.push_back({pair.bodies, pieces.first, pieces.second, each});
      if (contacts.size() >= most) return false;
    }
  }
  return true;
}

}  // namespace handwheel
