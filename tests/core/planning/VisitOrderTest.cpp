// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/VisitOrder.h"

#include "Scenes.h"
#include "TestClass.h"

#include <QtTest>
#include <map>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A table of costs, which counts its look-ups.
struct Table {
  std::vector<std::size_t> alternatives;
  std::map<std::pair<std::size_t, std::size_t>, std::pair<double, double>> costs;  // least and exact, by visits
  std::map<std::pair<std::size_t, std::size_t>, int> asked = {};

  static std::size_t number(const Visit& visit) { return 100 * visit.stop + visit.alternative; }
  static std::pair<std::size_t, std::size_t> key(const Visit& from, const Visit& to) {
    return {number(from), number(to)};
  }
  VisitCosts lookup() {
    return {[this](const Visit& from, const Visit& to) { return costs.at(key(from, to)).first; },
            [this](const Visit& from, const Visit& to, Progress) {
              ++asked[key(from, to)];
              return costs.at(key(from, to)).second;
            }};
  }
  double exactOf(const std::vector<Visit>& visits) const {
    double cost = 0.0;
    for (std::size_t i = 1; i < visits.size(); ++i) cost += costs.at(key(visits[i - 1], visits[i])).second;
    return cost;
  }
};

// blocked: share of the costs that are higher than the known bound, some of them infinite.
Table anyTable(std::size_t stops, std::size_t mostAlternatives, double blocked) {
  Table table;
  for (std::size_t s = 0; s < stops; ++s)
    table.alternatives.push_back(*rc::gen::inRange<std::size_t>(1, mostAlternatives + 1));
  for (std::size_t s = 0; s < stops; ++s) {
    for (std::size_t t = 0; t < stops; ++t) {
      for (std::size_t a = 0; a < table.alternatives[s]; ++a) {
        for (std::size_t b = 0; b < table.alternatives[t]; ++b) {
          const double least = evenly(1.0, 10.0);
          const bool isBlocked = evenly(0.0, 1.0) < blocked;
          const double more = !isBlocked               ? least
                              : evenly(0.0, 1.0) < 0.3 ? std::numeric_limits<double>::infinity()
                                                       : least + evenly(0.0, 10.0);
          table.costs[Table::key({s, a}, {t, b})] = {least, more};
        }
      }
    }
  }
  return table;
}

// Tries each order and each alternative, one after the other.
double leastByTrying(const Table& table, bool mayReorder) {
  std::vector<std::size_t> order(table.alternatives.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  double least = std::numeric_limits<double>::infinity();
  do {
    std::vector<Visit> visits;
    for (const std::size_t stop : order) visits.push_back({stop, 0});
    for (bool isMore = true; isMore;) {
      least = std::min(least, table.exactOf(visits));
      isMore = false;
      for (Visit& visit : visits) {
        if (++visit.alternative < table.alternatives[visit.stop]) {
          isMore = true;
          break;
        }
        visit.alternative = 0;
      }
    }
  } while (mayReorder && std::next_permutation(order.begin() + 1, order.end() - 1));
  return least;
}

bool visitsAll(const Table& table, const std::vector<Visit>& visits) {
  std::set<std::size_t> stops;
  for (const Visit& visit : visits) {
    if (visit.alternative >= table.alternatives[visit.stop]) return false;
    stops.insert(visit.stop);
  }
  return stops.size() == table.alternatives.size() && visits.size() == stops.size() && visits.front().stop == 0 &&
         visits.back().stop == stops.size() - 1;
}

}  // namespace

class VisitOrderTest : public QObject {
  Q_OBJECT

 private slots:
  // The result is as cheap as the cheapest of all, for any exact costs above the known bounds; and nothing is requested
  // twice.
  void ofAllOrders() {
    QVERIFY(rc::check([] {
      Table table = anyTable(*rc::gen::inRange<std::size_t>(2, 7), 3, evenly(0.0, 1.0));
      for (const bool mayReorder : {false, true}) {
        table.asked.clear();
        const double least = leastByTrying(table, mayReorder);
        const auto found =
            cheapestOrder(table.alternatives, table.lookup(), {.mayReorder = mayReorder, .seconds = 60.0});
        RC_ASSERT(found.has_value() == std::isfinite(least));
        for (const auto& [key, count] : table.asked) RC_ASSERT(count == 1);
        if (!found) continue;
        RC_ASSERT(visitsAll(table, found->visits));
        RC_ASSERT(std::abs(found->cost - least) < 1e-9);
        RC_ASSERT(std::abs(table.exactOf(found->visits) - found->cost) < 1e-9);
      }
    }));
  }

  // Many stops around a circle, in disorder: the round trip is the cheapest. Each has an alternative that is off it.
  void manyStops() {
    constexpr std::size_t kStops = 24;
    std::vector<double> angles(kStops);
    for (std::size_t i = 0; i < kStops; ++i) angles[i] = 0.25 * static_cast<double>((i * 7) % (kStops - 1));
    angles.back() = 0.25 * (kStops - 1);
    const auto at = [&](const Visit& visit) {
      const double radius = visit.alternative == 1 ? 10.0 : 14.0;
      return Vec3(radius * std::cos(angles[visit.stop]), radius * std::sin(angles[visit.stop]), 0.0);
    };
    const std::vector<std::size_t> alternatives(kStops, 2);
    const auto cost = [&](const Visit& from, const Visit& to) { return (at(from) - at(to)).norm(); };
    const auto found = cheapestOrder(
        alternatives, {cost, [&](const Visit& from, const Visit& to, Progress) { return cost(from, to); }},
        {.seconds = 60.0});
    QVERIFY(found.has_value());
    const double round = (kStops - 1) * 2.0 * 10.0 * std::sin(0.125);
    QVERIFY2(std::abs(found->cost - round) < 1e-9, qPrintable(QString("%1, %2").arg(found->cost).arg(round)));
    for (const Visit& visit : found->visits) QCOMPARE(visit.alternative, std::size_t{1});
  }

  // The result is never worse than the given order, and an impossible tour stays impossible.
  void manyStopsInDisorder() {
    QVERIFY(rc::check([] {
      Table table = anyTable(14, 2, 0.2);
      const double present = [&] {
        const auto kept = cheapestOrder(table.alternatives, table.lookup(), {.mayReorder = false, .seconds = 60.0});
        return kept ? kept->cost : std::numeric_limits<double>::infinity();
      }();
      const auto found = cheapestOrder(table.alternatives, table.lookup(), {.seconds = 60.0});
      if (!found) {
        RC_ASSERT(std::isinf(present));
        return;
      }
      RC_ASSERT(visitsAll(table, found->visits));
      RC_ASSERT(found->cost <= present + 1e-9);
      RC_ASSERT(std::abs(table.exactOf(found->visits) - found->cost) < 1e-9);
    }));
  }

  void cancelled() {
    JobState state;
    state.cancelled = true;
    Table table = anyTableOf(5);
    QVERIFY(!cheapestOrder(table.alternatives, table.lookup(), {}, Progress(state)));
    QVERIFY(table.asked.empty());
  }

 private:
  static Table anyTableOf(std::size_t stops) {
    Table table{std::vector<std::size_t>(stops, 1), {}};
    for (std::size_t s = 0; s < stops; ++s) {
      for (std::size_t t = 0; t < stops; ++t) table.costs[Table::key({s, 0}, {t, 0})] = {1.0, 1.0};
    }
    return table;
  }
};

HANDWHEEL_TEST(VisitOrderTest)
#include "VisitOrderTest.moc"
