// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/VisitOrder.h"

#include "base/Geometry.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <numeric>

namespace handwheel {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;  // of sums of costs

using Order = std::vector<std::size_t>;  // of stops

// The costs as far as they are known, of every way of every stop.
class CostTable {
 public:
  CostTable(std::span<const std::size_t> ways, const VisitCosts& costs) : m_ways(ways), m_costs(costs) {
    for (const std::size_t count : ways) {
      m_first.push_back(m_nodes);
      m_nodes += count;
    }
    m_values.assign(m_nodes * m_nodes, kNever);
    m_isExact.assign(m_nodes * m_nodes, false);
    for (std::size_t from = 0; from + 1 < ways.size(); ++from) {  // nothing leaves the last stop,
      for (std::size_t to = 1; to < ways.size(); ++to) {          // and nothing comes to the first
        if (from == to) continue;
        for (std::size_t a = 0; a < ways[from]; ++a) {
          for (std::size_t b = 0; b < ways[to]; ++b) m_values[at({from, a}, {to, b})] = costs.least({from, a}, {to, b});
        }
      }
    }
  }

  std::size_t stops() const { return m_ways.size(); }
  std::size_t ways(std::size_t stop) const { return m_ways[stop]; }
  double operator()(const Visit& from, const Visit& to) const { return m_values[at(from, to)]; }

  // Asks for what is not known exactly yet. False: all was known.
  bool learn(const std::vector<Visit>& visits, const std::function<bool()>& isOver, Progress progress) {
    bool isNew = false;
    for (std::size_t i = 1; i < visits.size() && !isOver(); ++i) {
      const std::size_t index = at(visits[i - 1], visits[i]);
      if (m_isExact[index]) continue;
      m_values[index] = m_costs.exact(visits[i - 1], visits[i], progress);
      m_isExact[index] = isNew = true;
    }
    return isNew;
  }

  bool isExact(const std::vector<Visit>& visits) const {
    for (std::size_t i = 1; i < visits.size(); ++i) {
      if (!m_isExact[at(visits[i - 1], visits[i])]) return false;
    }
    return true;
  }

  double costOf(const std::vector<Visit>& visits) const {
    double cost = 0.0;
    for (std::size_t i = 1; i < visits.size(); ++i) cost += (*this)(visits[i - 1], visits[i]);
    return cost;
  }

 private:
  std::size_t at(const Visit& from, const Visit& to) const {
    return (m_first[from.stop] + from.way) * m_nodes + m_first[to.stop] + to.way;
  }

  std::span<const std::size_t> m_ways;
  const VisitCosts& m_costs;
  std::vector<std::size_t> m_first;  // node of each stop's first way
  std::size_t m_nodes = 0;
  std::vector<double> m_values;
  std::vector<bool> m_isExact;
};

// The best ways for an order, stop by stop (dynamic programming).
VisitOrder bestWays(const CostTable& costs, const Order& order) {
  std::vector<std::vector<std::size_t>> before(order.size());
  std::vector<double> least(costs.ways(order.front()), 0.0), next;
  for (std::size_t i = 1; i < order.size(); ++i) {
    next.assign(costs.ways(order[i]), kNever);
    before[i].assign(next.size(), 0);
    for (std::size_t b = 0; b < next.size(); ++b) {
      for (std::size_t a = 0; a < least.size(); ++a) {
        const double cost = least[a] + costs({order[i - 1], a}, {order[i], b});
        if (cost >= next[b]) continue;
        next[b] = cost;
        before[i][b] = a;
      }
    }
    least.swap(next);
  }
  VisitOrder best;
  const auto last = std::min_element(least.begin(), least.end());
  best.cost = *last;
  best.visits.resize(order.size());
  auto way = static_cast<std::size_t>(last - least.begin());
  for (std::size_t i = order.size(); i-- > 0;) {
    best.visits[i] = {order[i], way};
    if (i > 0) way = before[i][way];
  }
  return best;
}

// All orders at once: the least cost of having been at a set of stops, and being at one of them.
class AllOrders {
 public:
  explicit AllOrders(const CostTable& costs) : m_costs(costs), m_between(costs.stops() - 2) {
    for (std::size_t stop = 1; stop + 1 < costs.stops(); ++stop) {
      for (std::size_t way = 0; way < costs.ways(stop); ++way) m_nodes.push_back({stop, way});
    }
  }

  VisitOrder best() {
    const std::size_t sets = std::size_t{1} << m_between;
    m_least.assign(sets * m_nodes.size(), kNever);
    m_before.assign(sets * m_nodes.size(), kNone);
    const std::size_t last = m_costs.stops() - 1;
    for (std::size_t i = 0; i < m_nodes.size(); ++i) reachFromFirst(i);
    for (std::size_t set = 1; set < sets; ++set) {
      for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        if (m_least[set * m_nodes.size() + i] < kNever) goOn(set, i);
      }
    }
    VisitOrder best;
    std::size_t bestEnd = 0;
    Visit end;
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
      for (std::size_t way = 0; way < m_costs.ways(last); ++way) {
        const double cost = m_least[(sets - 1) * m_nodes.size() + i] + m_costs(m_nodes[i], {last, way});
        if (cost >= best.cost) continue;
        best.cost = cost;
        bestEnd = i;
        end = {last, way};
      }
    }
    if (best.cost < kNever) best.visits = wayTo(sets - 1, bestEnd, end);
    return best;
  }

 private:
  static std::size_t bitOf(std::size_t stop) { return std::size_t{1} << (stop - 1); }

  void reachFromFirst(std::size_t i) {
    const std::size_t index = bitOf(m_nodes[i].stop) * m_nodes.size() + i;
    for (std::size_t way = 0; way < m_costs.ways(0); ++way)
      m_least[index] = std::min(m_least[index], m_costs({0, way}, m_nodes[i]));
  }

  void goOn(std::size_t set, std::size_t i) {
    const double least = m_least[set * m_nodes.size() + i];
    for (std::size_t next = 0; next < m_nodes.size(); ++next) {
      const std::size_t bit = bitOf(m_nodes[next].stop);
      if (set & bit) continue;
      const std::size_t index = (set | bit) * m_nodes.size() + next;
      const double cost = least + m_costs(m_nodes[i], m_nodes[next]);
      if (cost >= m_least[index]) continue;
      m_least[index] = cost;
      m_before[index] = static_cast<std::uint32_t>(i);
    }
  }

  std::vector<Visit> wayTo(std::size_t set, std::size_t i, const Visit& end) const {
    std::vector<Visit> visits{end};
    while (true) {
      visits.push_back(m_nodes[i]);
      const std::uint32_t before = m_before[set * m_nodes.size() + i];
      if (before == kNone) break;
      set &= ~bitOf(m_nodes[i].stop);
      i = before;
    }
    Visit first{0, 0};
    for (std::size_t way = 1; way < m_costs.ways(0); ++way) {
      if (m_costs({0, way}, visits.back()) < m_costs(first, visits.back())) first.way = way;
    }
    visits.push_back(first);
    std::reverse(visits.begin(), visits.end());
    return visits;
  }

  const CostTable& m_costs;
  std::size_t m_between;
  std::vector<Visit> m_nodes;  // of the stops in between
  std::vector<double> m_least;
  std::vector<std::uint32_t> m_before;
};

// From each stop to the nearest one that is left, by the best ways of both.
Order nearestNeighbours(const CostTable& costs) {
  const std::size_t last = costs.stops() - 1;
  Order order{0};
  std::vector<bool> isLeft(costs.stops(), true);
  while (order.size() < last) {
    const std::size_t from = order.back();
    std::size_t nearest = 0;
    double least = kNever;
    for (std::size_t to = 1; to < last; ++to) {
      if (!isLeft[to]) continue;
      double cost = kNever;
      for (std::size_t a = 0; a < costs.ways(from); ++a) {
        for (std::size_t b = 0; b < costs.ways(to); ++b) cost = std::min(cost, costs({from, a}, {to, b}));
      }
      if (nearest != 0 && cost >= least) continue;
      least = cost;
      nearest = to;
    }
    isLeft[nearest] = false;
    order.push_back(nearest);
  }
  order.push_back(last);
  return order;
}

// Turns pieces of the order round, and moves stops, while that costs less.
VisitOrder improved(const CostTable& costs, Order order, const std::function<bool()>& isOver) {
  VisitOrder best = bestWays(costs, order);
  const auto take = [&](const Order& other) {
    VisitOrder found = bestWays(costs, other);
    if (!(found.cost < best.cost * (1.0 - kRounding))) return false;
    best = std::move(found);
    order = other;
    return true;
  };
  for (bool isBetter = true; isBetter && !isOver();) {
    isBetter = false;
    for (std::size_t i = 1; i + 1 < order.size() && !isOver(); ++i) {
      for (std::size_t j = 1; j + 1 < order.size(); ++j) {
        if (i == j) continue;
        Order other = order;
        const auto a = static_cast<std::ptrdiff_t>(std::min(i, j)), b = static_cast<std::ptrdiff_t>(std::max(i, j));
        if (i < j) {
          std::reverse(other.begin() + a, other.begin() + b + 1);
          isBetter |= take(other);
        }
        other = order;
        if (i < j)
          std::rotate(other.begin() + a, other.begin() + a + 1, other.begin() + b + 1);
        else
          std::rotate(other.begin() + a, other.begin() + b, other.begin() + b + 1);
        isBetter |= take(other);
      }
    }
  }
  return best;
}

}  // namespace

std::optional<VisitOrder> cheapestOrder(std::span<const std::size_t> ways, const VisitCosts& costs,
                                        const VisitSettings& settings, Progress progress) {
  assert(ways.size() >= 2);
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto spent = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  const auto isOver = [&] { return progress.cancelled() || spent() > settings.seconds; };
  CostTable table(ways, costs);
  const bool isExact = settings.mayReorder && ways.size() <= kMostExact + 2 && ways.size() > 2;
  Order present(ways.size());
  std::iota(present.begin(), present.end(), std::size_t{0});
  // The order that is there is known first: whatever happens, no worse one is returned.
  VisitOrder best = bestWays(table, present);
  while (best.cost < kNever && table.learn(best.visits, isOver, progress) && !isOver()) best = bestWays(table, present);
  if (!table.isExact(best.visits)) best.cost = kNever;
  if (settings.mayReorder && !isExact) present = nearestNeighbours(table);
  while (settings.mayReorder && ways.size() > 2 && !isOver()) {
    VisitOrder found = isExact ? AllOrders(table).best() : improved(table, present, isOver);
    if (!(found.cost < best.cost * (1.0 - kRounding))) break;  // by bounds already it costs more
    if (!table.learn(found.visits, isOver, progress) && table.isExact(found.visits)) {
      best = std::move(found);
      continue;
    }
    found.cost = table.costOf(found.visits);
    if (table.isExact(found.visits) && found.cost < best.cost) best = found;
    for (std::size_t i = 0; i < present.size(); ++i) present[i] = found.visits[i].stop;
    progress.set(std::min(1.0, spent() / settings.seconds));
  }
  if (!(best.cost < kNever)) return std::nullopt;
  return best;
}

}  // namespace handwheel
