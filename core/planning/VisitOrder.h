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

// A stop of a tour, with one of the alternative ways to be there.
struct Visit {
  std::size_t stop = 0, way = 0;
  bool operator==(const Visit&) const = default;
};

// What it costs to go from one visit to another.
struct VisitCosts {
  // At least so much; infinity: there is no way. Cheap.
  std::function<double(const Visit& from, const Visit& to)> least;
  // So much; asked for once. Expensive.
  std::function<double(const Visit& from, const Visit& to, Progress progress)> exact;
};

struct VisitOrder {
  std::vector<Visit> visits;  // one of each stop
  double cost = std::numeric_limits<double>::infinity();
};

// How an order is looked for.
struct VisitSettings {
  bool mayReorder = true;  // else only the ways are chosen
  double seconds = 30.0;   // after which the best one so far is taken
};

// The cheapest order of stops, from the first to the last, which stay where they are, and the cheapest way to be at
// each (ways: how many there are). Up to kMostExact stops in between all orders are looked at (Held and Karp 1962);
// beyond, the nearest neighbour goes first, and pieces of the order are turned round and stops moved while that costs
// less (2-opt: Croes 1958), with the best ways of each order. Exact costs are asked for only along orders that are the
// cheapest by what is known. None: there is no way.
std::optional<VisitOrder> cheapestOrder(std::span<const std::size_t> ways, const VisitCosts& costs,
                                        const VisitSettings& settings = {}, Progress progress = {});
inline constexpr std::size_t kMostExact = 8;

}  // namespace handwheel
