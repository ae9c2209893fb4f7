// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Bars.h"
#include "core/proximity/Surfaces.h"
#include "proximity/SelfIntersection.h"
#include "proximity/TriangleHierarchy.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <tbb/task_arena.h>

using namespace handwheel;
using bench::secondsOf;
using test::Surface;

namespace {

bench::Bars bars;

// A closed bumpy sphere of 8 n² triangles.
const Surface& bumpySphere(int n) {
  static std::map<int, Surface> surfaces;
  auto [at, isNew] = surfaces.try_emplace(n);
  if (isNew) at->second = test::sphere(n, Vec3(10, 20, 30), 50.0, 0.1);
  return at->second;
}

void countTriangles(benchmark::State& state, const Surface& s) {
  state.counters["triangles"] = static_cast<double>(s.triangles.size());
}

void build(benchmark::State& state) {
  const Surface& s = bumpySphere(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    TriangleHierarchy hierarchy(s.points, s.triangles);
    benchmark::DoNotOptimize(hierarchy);
  }
  countTriangles(state, s);
}

std::vector<Vec3> pointsAround(const Surface& s) {
  Box box;
  for (const Vec3& p : s.points) box.extend(p);
  std::vector<Vec3> points;
  for (const Vec3& p : test::soup(1500, 0.5, 0, 11).points)
    points.push_back(box.center() + 1.5 * (p - Vec3::Constant(0.5)).cwiseProduct(box.sizes()));
  return points;
}

void ray(benchmark::State& state) {
  const Surface& s = bumpySphere(static_cast<int>(state.range(0)));
  const TriangleHierarchy hierarchy(s.points, s.triangles);
  const std::vector<Vec3> points = pointsAround(s);
  std::size_t i = 0;
  for (auto _ : state) {
    const Vec3& origin = points[i % points.size()];
    benchmark::DoNotOptimize(hierarchy.firstHit(origin, points[(i + 1) % points.size()] - origin));
    ++i;
  }
  countTriangles(state, s);
}

void nearest(benchmark::State& state) {
  const Surface& s = bumpySphere(static_cast<int>(state.range(0)));
  const TriangleHierarchy hierarchy(s.points, s.triangles);
  const std::vector<Vec3> points = pointsAround(s);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(hierarchy.nearest(points[i++ % points.size()]));
  countTriangles(state, s);
}

// The usual method with CGAL: boxes, then its exact predicates, with corners compared by index.
class CgalSelfIntersection {
 public:
  explicit CgalSelfIntersection(const Surface& s) : m_surface(s) {
    for (const Vec3& p : s.points) m_points.emplace_back(p.x(), p.y(), p.z());
  }

  std::size_t count() const {
    using Box3 = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
    std::vector<Box3> boxes;
    boxes.reserve(m_surface.triangles.size());
    for (std::uint32_t i = 0; i < m_surface.triangles.size(); ++i) boxes.emplace_back(triangle(i).bbox(), i);
    std::vector<const Box3*> order;
    for (const Box3& box : boxes) order.push_back(&box);
    std::size_t found = 0;
    CGAL::box_self_intersection_d(
        order.begin(), order.end(), [&](const Box3* a, const Box3* b) { found += meet(a->info(), b->info()); },
        std::ptrdiff_t{200});
    return found;
  }

 private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

  const Kernel::Point_3& corner(std::uint32_t t, std::size_t i) const {
    return m_points[m_surface.triangles[t][i % 3]];
  }
  Kernel::Triangle_3 triangle(std::uint32_t t) const { return {corner(t, 0), corner(t, 1), corner(t, 2)}; }

  bool meet(std::uint32_t a, std::uint32_t b) const {
    std::array<std::size_t, 3> inA{}, inB{};
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (m_surface.triangles[a][i] == m_surface.triangles[b][j]) {
          inA[shared] = i;
          inB[shared++] = j;
          break;
        }
    if (shared == 3) return true;
    if (shared == 2) {
      const auto &p = corner(a, inA[0]), &q = corner(a, inA[1]), &r = corner(a, 3 - inA[0] - inA[1]),
                 &t = corner(b, 3 - inB[0] - inB[1]);
      return CGAL::coplanar(p, q, r, t) && CGAL::coplanar_orientation(p, q, r, t) == CGAL::POSITIVE;
    }
    if (shared == 0) return CGAL::do_intersect(triangle(a), triangle(b));
    return CGAL::do_intersect(triangle(a), Kernel::Segment_3(corner(b, inB[0] + 1), corner(b, inB[0] + 2))) ||
           CGAL::do_intersect(triangle(b), Kernel::Segment_3(corner(a, inA[0] + 1), corner(a, inA[0] + 2)));
  }

  const Surface& m_surface;
  std::vector<Kernel::Point_3> m_points;
};

// A ball with so many crossings that both must agree on; the balls that are timed have none.
bool agreeOnCrossings() {
  Surface two = test::sphere(20);
  const Surface other = test::sphere(20, Vec3(0.7, 0.1, 0.2));
  const auto first = static_cast<std::uint32_t>(two.points.size());
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles) two.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  const std::size_t found = selfIntersections(two.points, two.triangles)->size();
  return found > 0 && found == CgalSelfIntersection(two).count();
}

// Both in the same run, by turns: "ratio" and "ratioAlone" (on one thread, as CGAL) are what to compare across
// machines.
void selfIntersection(benchmark::State& state) {
  const Surface& s = bumpySphere(static_cast<int>(state.range(0)));
  const CgalSelfIntersection cgal(s);
  tbb::task_arena alone(1);
  bench::Fastest ours, oursAlone, theirs;
  std::size_t found = 0, foundByCgal = 0;
  bool isSame = agreeOnCrossings();
  for (auto _ : state) {
    const double seconds = secondsOf([&] { found = selfIntersections(s.points, s.triangles)->size(); });
    state.SetIterationTime(seconds);
    ours.add(seconds);
    oursAlone.add(
        secondsOf([&] { alone.execute([&] { found += selfIntersections(s.points, s.triangles)->size(); }); }));
    theirs.add(secondsOf([&] { foundByCgal = cgal.count(); }));
    isSame = isSame && found == 2 * foundByCgal;
  }
  const std::string onAll = "self-intersections, on all cores, to CGAL's sequential search";
  if (!isSame) return bars.failed(state, onAll, "the numbers of pairs differ");
  countTriangles(state, s);
  state.counters["ratio"] = ours.seconds / theirs.seconds;
  state.counters["ratioAlone"] = oursAlone.seconds / theirs.seconds;
  bars.atMost(onAll, 1.05, ours.seconds / theirs.seconds);
  bars.atMost("self-intersections, on one core, to CGAL's sequential search", 1.05, oursAlone.seconds / theirs.seconds);
}

}  // namespace

BENCHMARK(build)->Arg(158)->Arg(354)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ray)->Arg(158)->Arg(354)->Arg(500)->Unit(benchmark::kMicrosecond);
BENCHMARK(nearest)->Arg(158)->Arg(354)->Arg(500)->Unit(benchmark::kMicrosecond);
BENCHMARK(selfIntersection)->Arg(158)->Arg(354)->Unit(benchmark::kMillisecond)->UseManualTime();

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
