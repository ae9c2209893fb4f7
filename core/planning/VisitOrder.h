// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace handwheel {

// A stop of a tour, with the alternative that is chosen for it. Alternatives are the different ways to make a stop,
// such as the joint values that reach the same pose. Both members are indices.
struct Visit {
  std::size_t stop = 0, alternative = 0;
  bool operator==(const Visit&) const = default;
};

// The costs of moving from one visit to another.
struct VisitCosts {
  // Returns a lower bound of the cost; infinity: there is no connection. Must be cheap.
  std::function<double(const Visit& from, const Visit& to)> least;
  // Returns the exact cost. It may be expensive, and is called at most once for each pair.
  std::function<double(const Visit& from, const Visit& to, Progress progress)> exact;
};

struct VisitOrder {
  std::vector<Visit> visits;  // one for each stop
  double cost = std::numeric_limits<double>::infinity();
};

// Settings for the search for an order.
struct VisitSettings {
  bool mayReorder = true;  // false: the order stays, and only the alternatives are chosen
  double seconds = 30.0;   // time limit, after which the best order so far is returned
};

// Returns the cheapest order of stops, with the cheapest alternative for each stop, or nothing if the stops cannot be
// connected. The first and the last stop keep their positions. With at most kMostExact stops in between, all orders are
// compared (Held and Karp 1962). With more stops, the order begins with nearest neighbours and is improved by reversing
// pieces and moving stops (2-opt: Croes 1958), with the best alternatives for each order. Exact costs are requested
// only for orders that are the cheapest according to the known costs. alternatives: the number of alternatives for each
// stop.
std::optional<VisitOrder> cheapestOrder(std::span<const std::size_t> alternatives, const VisitCosts& costs,
                                        const VisitSettings& settings = {}, Progress progress = {});
inline constexpr std::size_t kMostExact = 8;

}  // namespace handwheel
