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
constexpr double kRounding = 1e-9;  // relative to sums of costs

using Order = std::vector<std::size_t>;  // indices of stops

// The known costs for every alternative of every stop.
class CostTable {
 public:
  CostTable(std::span<const std::size_t> alternatives, const VisitCosts& costs)
      : m_alternatives(alternatives), m_costs(costs) {
    for (const std::size_t count : alternatives) {
      m_first.push_back(m_nodes);
      m_nodes += count;
    }
    m_values.assign(m_nodes * m_nodes, kNever);
    m_isExact.assign(m_nodes * m_nodes, false);
    for (std::size_t from = 0; from + 1 < alternatives.size(); ++from) {  // nothing leaves the last stop,
      for (std::size_t to = 1; to < alternatives.size(); ++to) {          // and nothing comes to the first
        if (from == to) continue;
        for (std::size_t a = 0; a < alternatives[from]; ++a) {
          for (std::size_t b = 0; b < alternatives[to]; ++b)
            m_values[at({from, a}, {to, b})] = costs.least({from, a}, {to, b});
        }
      }
    }
  }

  std::size_t stops() const { return m_alternatives.size(); }
  std::size_t alternatives(std::size_t stop) const { return m_alternatives[stop]; }
  double operator()(const Visit& from, const Visit& to) const { return m_values[at(from, to)]; }

  // Requests the exact costs that are not known yet. Returns false if all were known.
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
    return (m_first[from.stop] + from.alternative) * m_nodes + m_first[to.stop] + to.alternative;
  }

  std::span<const std::size_t> m_alternatives;
  const VisitCosts& m_costs;
  std::vector<std::size_t> m_first;  // node of each stop's first alternative
  std::size_t m_nodes = 0;
  std::vector<double> m_values;
  std::vector<bool> m_isExact;
};

// Returns the best alternatives for an order, stop by stop (dynamic programming).
VisitOrder bestAlternatives(const CostTable& costs, const Order& order) {
  std::vector<std::vector<std::size_t>> before(order.size());
  std::vector<double> least(costs.alternatives(order.front()), 0.0), next;
  for (std::size_t i = 1; i < order.size(); ++i) {
    next.assign(costs.alternatives(order[i]), kNever);
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
  auto alternative = static_cast<std::size_t>(last - least.begin());
  for (std::size_t i = order.size(); i-- > 0;) {
    best.visits[i] = {order[i], alternative};
    if (i > 0) alternative = before[i][alternative];
  }
  return best;
}

// Considers all orders at once: the least cost of having visited a set of stops, and being at one of them.
class AllOrders {
 public:
  explicit AllOrders(const CostTable& costs) : m_costs(costs), m_between(costs.stops() - 2) {
    for (std::size_t stop = 1; stop + 1 < costs.stops(); ++stop) {
      for (std::size_t alternative = 0; alternative < costs.alternatives(stop); ++alternative)
        m_nodes.push_back({stop, alternative});
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
      for (std::size_t alternative = 0; alternative < m_costs.alternatives(last); ++alternative) {
        const double cost = m_least[(sets - 1) * m_nodes.size() + i] + m_costs(m_nodes[i], {last, alternative});
        if (cost >= best.cost) continue;
        best.cost = cost;
        bestEnd = i;
        end = {last, alternative};
      }
    }
    if (best.cost < kNever) best.visits = visitsTo(sets - 1, bestEnd, end);
    return best;
  }

 private:
  static std::size_t bitOf(std::size_t stop) { return std::size_t{1} << (stop - 1); }

  void reachFromFirst(std::size_t i) {
    const std::size_t index = bitOf(m_nodes[i].stop) * m_nodes.size() + i;
    for (std::size_t alternative = 0; alternative < m_costs.alternatives(0); ++alternative)
      m_least[index] = std::min(m_least[index], m_costs({0, alternative}, m_nodes[i]));
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

  std::vector<Visit> visitsTo(std::size_t set, std::size_t i, const Visit& end) const {
    std::vector<Visit> visits{end};
    while (true) {
      visits.push_back(m_nodes[i]);
      const std::uint32_t before = m_before[set * m_nodes.size() + i];
      if (before == kNone) break;
      set &= ~bitOf(m_nodes[i].stop);
      i = before;
    }
    Visit first{0, 0};
    for (std::size_t alternative = 1; alternative < m_costs.alternatives(0); ++alternative) {
      if (m_costs({0, alternative}, visits.back()) < m_costs(first, visits.back())) first.alternative = alternative;
    }
    visits.push_back(first);
    std::reverse(visits.begin(), visits.end());
    return visits;
  }

  const CostTable& m_costs;
  std::size_t m_between;
  std::vector<Visit> m_nodes;  // the stops in between
  std::vector<double> m_least;
  std::vector<std::uint32_t> m_before;
};

// Connects each stop to the nearest one that is left, by the best alternatives of both.
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
      for (std::size_t a = 0; a < costs.alternatives(from); ++a) {
        for (std::size_t b = 0; b < costs.alternatives(to); ++b) cost = std::min(cost, costs({from, a}, {to, b}));
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

// Reverses pieces of the order, and moves stops, while that costs less.
VisitOrder improved(const CostTable& costs, Order order, const std::function<bool()>& isOver) {
  VisitOrder best = bestAlternatives(costs, order);
  const auto take = [&](const Order& other) {
    VisitOrder found = bestAlternatives(costs, other);
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

std::optional<VisitOrder> cheapestOrder(std::span<const std::size_t> alternatives, const VisitCosts& costs,
                                        const VisitSettings& settings, Progress progress) {
  assert(alternatives.size() >= 2);
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto spent = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  const auto isOver = [&] { return progress.cancelled() || spent() > settings.seconds; };
  CostTable table(alternatives, costs);
  const bool isExact = settings.mayReorder && alternatives.size() <= kMostExact + 2 && alternatives.size() > 2;
  Order present(alternatives.size());
  std::iota(present.begin(), present.end(), std::size_t{0});
  // The costs of the given order are known first: the result is never worse.
  VisitOrder best = bestAlternatives(table, present);
  while (best.cost < kNever && table.learn(best.visits, isOver, progress) && !isOver())
    best = bestAlternatives(table, present);
  if (!table.isExact(best.visits)) best.cost = kNever;
  if (settings.mayReorder && !isExact) present = nearestNeighbours(table);
  while (settings.mayReorder && alternatives.size() > 2 && !isOver()) {
    VisitOrder found = isExact ? AllOrders(table).best() : improved(table, present, isOver);
    if (!(found.cost < best.cost * (1.0 - kRounding))) break;  // it costs more already by the bounds
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
