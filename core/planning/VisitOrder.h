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

// A stop of a tour, with one of the alternatives for it.
struct Visit {
  std::size_t stop = 0, alternative = 0;
  bool operator==(const Visit&) const = default;
};

// The costs of moving from one visit to another.
struct VisitCosts {
  // Returns a lower bound; infinity: there is no connection. Cheap.
  std::function<double(const Visit& from, const Visit& to)> least;
  // Returns the cost; called once for each pair. Expensive.
  std::function<double(const Visit& from, const Visit& to, Progress progress)> exact;
};

struct VisitOrder {
  std::vector<Visit> visits;  // one for each stop
  double cost = std::numeric_limits<double>::infinity();
};

// Settings of the search for an order.
struct VisitSettings {
  bool mayReorder = true;  // false: only the alternatives are chosen
  double seconds = 30.0;   // time limit, after which the best order so far is returned
};

// Returns the cheapest order of stops, with the cheapest alternative for each. The first and the last stop stay at the
// ends. alternatives: their number for each stop. Up to kMostExact stops in between all orders are compared (Held and
// Karp 1962); beyond, the nearest neighbour goes first, and pieces of the order are reversed and stops moved while that
// costs less (2-opt: Croes 1958), with the best alternatives for each order. Exact costs are requested only along
// orders that are the cheapest by the known costs. None: there is no connection.
std::optional<VisitOrder> cheapestOrder(std::span<const std::size_t> alternatives, const VisitCosts& costs,
                                        const VisitSettings& settings = {}, Progress progress = {});
inline constexpr std::size_t kMostExact = 8;

}  // namespace handwheel
