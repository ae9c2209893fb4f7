// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "bench/ContactShapes.h"
#include "haptics/ContactSeams.h"
#include "haptics/GodObject.h"
#include "proximity/TriangleHierarchy.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <memory>
#include <numbers>

using namespace handwheel;
using namespace handwheel::bench;

namespace {

Bars bars;

constexpr double kDepth = 1.0;  // mm, of the tip below the surface
constexpr int kTicks = 20'000;  // 20 s at 1 kHz

// So fast over the bumpy ball, along a line that comes by nearly everything.
Vec3 tipAt(int tick, double speed, double scale, double depth) {
  const double way = 1e-3 * speed * tick / kBallRadius, z = 0.6 * std::sin(0.13 * way);
  const Vec3 d(std::cos(way) * std::sqrt(1 - z * z), std::sin(way) * std::sqrt(1 - z * z), z);
  return scale * (bumpyRadius(d) - depth) * d;
}

struct Slide {
  double middle = 0.0, p99 = 0.0;  // us of thread CPU time
  int stalls = 0;                  // ticks in which the proxy stood still
  double worst = 0.0;              // difference of depth to the ideal's, as a share of it
  double leap = 0.0;               // largest change of force in a tick, as a share of the usual one
};

Slide slideOver(const ContactSurface& surface, double speed, double scale = 1.0, double depth = kDepth) {
  GodObject god;
  god.place(1.5 * tipAt(0, speed, scale, depth));
  god.follow(surface, tipAt(0, speed, scale, depth), {});
  std::vector<double> times;
  Slide slide;
  Vec3 last = god.contact().proxy, lastForce = last - tipAt(0, speed, scale, depth);
  for (int i = 1; i < kTicks; ++i) {
    const Vec3 tip = tipAt(i, speed, scale, depth);
    const std::uint64_t start = threadCpuNanoseconds();
    const Contact& contact = god.follow(surface, tip, {});
    times.push_back(1e-3 * static_cast<double>(threadCpuNanoseconds() - start));
    const Vec3 force = contact.proxy - tip;
    slide.stalls += (contact.proxy - last).norm() < 1e-4 * 1e-3 * speed * scale ? 1 : 0;
    slide.worst = std::max(slide.worst, std::abs(contact.depth / (depth * scale) - 1.0));
    slide.leap = std::max(slide.leap, (force - lastForce).norm() / (depth * scale));
    last = contact.proxy;
    lastForce = force;
  }
  std::sort(times.begin(), times.end());
  slide.middle = times[times.size() / 2];
  slide.p99 = times[times.size() * 99 / 100];
  return slide;
}

ContactSurface surfaceOf(const TouchMesh& mesh) {
  return {mesh.points, mesh.triangles};
}

std::string named(std::size_t triangles) {
  return triangles < 1'000'000 ? std::to_string(triangles / 1000) + " k" : std::to_string(triangles / 1'000'000) + " M";
}

// Squares to a side of the cube for some 10 k, 100 k, 1 M and 5 M triangles.
constexpr int kSides[] = {29, 91, 289, 645};

void sliding(benchmark::State& state) {
  const int side = kSides[state.range(0)];
  const double speed = static_cast<double>(state.range(1));
  const TouchMesh mesh = ball(side, bumpyRadius);
  const ContactSurface surface = surfaceOf(mesh);
  Slide slide;
  for (auto _ : state) slide = slideOver(surface, speed);
  state.counters["us"] = slide.middle;
  state.counters["us99"] = slide.p99;
  state.counters["stalls"] = slide.stalls;
  const std::string what = named(mesh.triangles.size()) + ", " + std::to_string(state.range(1)) + " mm/s: ";
  const bool fast = speed > 500;
  if (side == 289) {
    if (!fast) bars.atMost(what + "us, median", 4.0, slide.middle);
    bars.atMost(what + "us, p99", fast ? 35.0 : 10.0, slide.p99);
  }
  // The dynamic finger proxy of CHAI3D 3.3.0 with a radius of 0, measured once on a machine of this kind.
  constexpr double kFingerProxy[] = {1.6, 2.1, 3.1, 4.9};
  bars.atMost(what + "median to the finger proxy's", 1.0, slide.middle / (fast ? 11.0 : kFingerProxy[state.range(0)]));
  bars.atMost(what + "stalls", 0, slide.stalls);
  bars.atMost(what + "force off the ideal by (share)", side == 29 ? 0.15 : 0.1, slide.worst);
}

// What the number of triangles costs by itself: the same motion counted in triangles, a twentieth of a side in a tick
// and half a side deep. At the same motion in mm a finer mesh also has more triangles under the tip and in its way.
void growth(benchmark::State& state) {
  std::vector<double> middles;
  for (auto _ : state)
    for (const int side : kSides) {
      const double length =
          0.5 * std::numbers::pi * kBallRadius / side;  // of an edge: a side of the cube is a quarter turn
      middles.push_back(slideOver(surfaceOf(ball(side, bumpyRadius)), 1e3 * length / 20, 1.0, 0.5 * length).middle);
    }
  const double logarithmic = std::log(12.0 * kSides[3] * kSides[3]) / std::log(12.0 * kSides[0] * kSides[0]);
  bars.atMost("growth from 10 k to 5 M, to that of the logarithm", 1.0, middles.back() / middles.front() / logarithmic);
}

// What is wrong with scans, at three scales; the same mesh without it is the control.
void defects(benchmark::State& state) {
  const TouchMesh clean = ball(91, bumpyRadius);
  const Slide control = slideOver(surfaceOf(clean), 100.0);
  struct Variant {
    const char* name;
    std::function<void(TouchMesh&)> spoil;
  };
  const Variant variants[] = {
      {"triangles turned over", turnSome},
      {"seams of 1 um", [](TouchMesh& m) { cutSeams(m, 0.001); }},
      {"seams of 20 um", [](TouchMesh& m) { cutSeams(m, 0.02); }},
      {"soup, corners 1e-5 mm apart", [](TouchMesh& m) { shatter(m, 0.5e-5); }},
      {"needles", addNeedles},
  };
  for (auto _ : state)
    for (const double scale : {1e-3, 1.0, 1e3})
      for (const Variant& variant : variants) {
        TouchMesh mesh = clean;
        variant.spoil(mesh);
        for (Vec3& p : mesh.points) p *= scale;
        closeSeams(mesh.points, mesh.triangles);
        const Slide slide = slideOver(surfaceOf(mesh), 100.0, scale);
        const std::string what = std::string(variant.name) + (scale < 1 ? ", x 1e-3" : scale > 1 ? ", x 1e+3" : "");
        bars.atMost(what + ": stalls", 0, slide.stalls);
        bars.atMost(what + ": force off the ideal by (share)", 0.1, slide.worst);
        bars.atMost(what + ": largest leap to the clean mesh's", 1.1, slide.leap / control.leap);
      }
}

// An edit under the tip: time in proportion to it, whatever the size of the mesh.
void edits(benchmark::State& state) {
  const TouchMesh mesh = ball(289, bumpyRadius);
  const ContactSurface surface = surfaceOf(mesh);
  const auto secondsFor = [&](std::size_t count) {
    Fastest fastest;
    for (int run = 0; run < 5; ++run) {
      ContactSurface edited = surface;
      std::vector<ContactTriangle> changed;
      for (std::size_t i = 0; i < count; ++i) {
        const Triangle& t = mesh.triangles[i];
        changed.push_back({{1.001 * mesh.points[t[0]], 1.001 * mesh.points[t[1]], 1.001 * mesh.points[t[2]]},
                           static_cast<std::uint32_t>(i)});
      }
      fastest.add(secondsOf([&] { edited.update({}, changed); }));
    }
    return fastest.seconds;
  };
  double some = 0.0, many = 0.0;
  for (auto _ : state) {
    some = secondsFor(1'000);
    many = secondsFor(10'000);
  }
  state.counters["us_1000"] = 1e6 * some;
  state.counters["us_10000"] = 1e6 * many;
  bars.atMost("edit of 10,000 triangles of 1 M to one of 1,000", 15.0, many / some);
  bars.atMost("edit of 1,000 triangles of 1 M to building it (share)", 0.01,
              some / secondsOf([&] { surfaceOf(mesh); }));
}

// A million ticks, pressed in deeply at any speed: where the proxy ends inside, it has come through.
void popThroughs(benchmark::State& state) {
  const TouchMesh mesh = ball(91, bumpyRadius);
  const ContactSurface surface = surfaceOf(mesh);
  const TriangleHierarchy truth(mesh.points, mesh.triangles);
  int lost = 0;
  double off = 0.0;
  for (auto _ : state) {
    std::mt19937 random(11);
    std::normal_distribution<double> number;
    GodObject god;
    Vec3 tip(60, 0, 0);
    god.place(tip);
    for (int i = 0; i < 1'000'000; ++i) {
      const double step = std::pow(10.0, -3.0 + 4.0 * (i % 1000) / 1000.0);
      tip += step * Vec3(number(random), number(random), number(random));
      if (tip.norm() > 50) tip *= 0.6;
      const Contact& contact = god.follow(surface, tip, {});
      if (i % 10 != 0 && contact.touching) continue;
      const auto hit = truth.firstHit(Vec3::Zero(), contact.proxy);
      lost += hit && hit->distance > 1.0 + 1e-9 ? 1 : 0;
      if (contact.touching)
        off = std::max(off, std::sqrt(truth.nearest(contact.proxy)->squaredDistance) / surface.diagonal());
    }
  }
  state.counters["lost"] = lost;
  bars.atMost("pop-throughs in 1 M ticks", 0, lost);
  bars.atMost("proxy off the surface, share of the model's size", 1e-6, off);
}

// A segment against CGAL's tree, the bare query that a god-object needs several of in a tick.
void segmentByCgal(benchmark::State& state) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Iterator = std::vector<Kernel::Triangle_3>::const_iterator;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
  const TouchMesh mesh = ball(289, bumpyRadius);
  const auto point = [](const Vec3& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
  std::vector<Kernel::Triangle_3> triangles;
  for (const Triangle& t : mesh.triangles)
    triangles.emplace_back(point(mesh.points[t[0]]), point(mesh.points[t[1]]), point(mesh.points[t[2]]));
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.cbegin(), triangles.cend());
  tree.build();
  std::vector<double> times;
  for (auto _ : state)
    for (int i = 0; i < kTicks; ++i) {
      const Vec3 tip = tipAt(i, 100.0, 1.0, kDepth);
      const Kernel::Segment_3 segment(point(1.05 * tip), point(tip));
      const std::uint64_t start = threadCpuNanoseconds();
      benchmark::DoNotOptimize(tree.do_intersect(segment));
      times.push_back(1e-3 * static_cast<double>(threadCpuNanoseconds() - start));
    }
  std::sort(times.begin(), times.end());
  const Slide ours = slideOver(surfaceOf(mesh), 100.0);
  state.counters["us"] = times[times.size() / 2];
  bars.atMost("a tick at 1 M to one segment against CGAL's tree, in the same run", 4.0,
              ours.middle / times[times.size() / 2]);
}

BENCHMARK(sliding)
    ->Args({0, 100})
    ->Args({1, 100})
    ->Args({2, 100})
    ->Args({3, 100})
    ->Args({2, 1000})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(growth)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(defects)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(edits)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(popThroughs)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(segmentByCgal)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
