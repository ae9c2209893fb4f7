// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactGodObject.h"
#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "bench/ContactShapes.h"
#include "bench/ScanPath.h"
#include "haptics/contact/ContactGaps.h"
#include "haptics/contact/GodObject.h"
#include "haptics/contact/TouchableSurface.h"
#include "proximity/TriangleHierarchy.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdio>
#include <memory>
#include <numbers>

using namespace handwheel;
using namespace handwheel::bench;
using handwheel::test::ExactGodObject;

namespace {

Bars bars;

constexpr double kDepth = 1.0;  // mm, of the tip below the surface
constexpr int kTicks = 20'000;  // 20 s at 1 kHz

// So fast over the bumpy ball, along a line that comes by nearly everything.
Vec3 tipAt(int tick, double speed, double scale, double depth) {
  const double angle = 1e-3 * speed * tick / kBallRadius, z = 0.6 * std::sin(0.13 * angle);
  const Vec3 d(std::cos(angle) * std::sqrt(1 - z * z), std::sin(angle) * std::sqrt(1 - z * z), z);
  return scale * (bumpyRadius(d) - depth) * d;
}

// us of thread CPU time that asking for it adds to each figure: as much as a tick on a small model takes.
double clockCost() {
  constexpr int kReads = 2001;
  std::vector<double> times;
  for (int i = 0; i < kReads; ++i) {
    const std::uint64_t start = threadCpuNanoseconds();
    times.push_back(1e-3 * static_cast<double>(threadCpuNanoseconds() - start));
  }
  std::nth_element(times.begin(), times.begin() + kReads / 2, times.end());
  return times[kReads / 2];
}

// us of thread CPU time of many ticks, without the clock's own.
class TickTimes {
 public:
  void add(auto&& tick) {
    const std::uint64_t start = threadCpuNanoseconds();
    tick();
    m_times.push_back(std::max(0.0, 1e-3 * static_cast<double>(threadCpuNanoseconds() - start) - m_clock));
  }
  // No number where there was no tick.
  double quantile(double share) {
    if (m_times.empty()) return std::nan("");
    std::sort(m_times.begin(), m_times.end());
    return m_times[static_cast<std::size_t>(share * static_cast<double>(m_times.size() - 1))];
  }

 private:
  double m_clock = clockCost();
  std::vector<double> m_times;
};

struct Slide {
  double middle = 0.0, p99 = 0.0;  // us of thread CPU time
  int stalls = 0;                  // ticks in which the proxy stood still
  double worst = 0.0;              // difference of depth to the ideal's, as a share of it
  double leap = 0.0;               // largest change of force in a tick, as a share of the usual one
};

std::vector<Vec3> pathOf(double speed, double scale, double depth) {
  std::vector<Vec3> path;
  for (int i = 0; i < kTicks; ++i) path.push_back(tipAt(i, speed, scale, depth));
  return path;
}

// The change of force from tick to tick is given for a stiffness of 1 N/mm.
Slide slideAlong(const ContactSurface& surface, const std::vector<Vec3>& path, double depth) {
  GodObject god;
  god.place(1.5 * path.front());
  god.follow(surface, path.front(), {});
  TickTimes times;
  Slide slide;
  Vec3 last = god.contact().proxy, lastForce = last - path.front();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec3& tip = path[i];
    times.add([&] { god.follow(surface, tip, {}); });
    const Contact& contact = god.contact();
    const Vec3 force = contact.proxy - tip;
    slide.stalls += (contact.proxy - last).norm() < 1e-4 * (tip - path[i - 1]).norm() ? 1 : 0;
    slide.worst = std::max(slide.worst, std::abs(contact.depth / depth - 1.0));
    slide.leap = std::max(slide.leap, (force - lastForce).norm() / depth);
    last = contact.proxy;
    lastForce = force;
  }
  slide.middle = times.quantile(0.5);
  slide.p99 = times.quantile(0.99);
  return slide;
}

Slide slideOver(const ContactSurface& surface, double speed, double scale = 1.0, double depth = kDepth) {
  return slideAlong(surface, pathOf(speed, scale, depth), depth * scale);
}

// The largest change of force in a tick that the mesh itself makes, as above.
double exactLeap(const TriangleSoup& mesh, const std::vector<Vec3>& path, double depth) {
  ExactGodObject exact(mesh);
  exact.place(path.front());
  Vec3 last = exact.proxy() - path.front();
  double leap = 0.0;
  for (const Vec3& tip : path) {
    const Vec3 force = exact.follow(tip) - tip;
    leap = std::max(leap, (force - last).norm() / depth);
    last = force;
  }
  return leap;
}

ContactSurface surfaceOf(const TriangleSoup& mesh) {
  return {mesh.points, mesh.triangles};
}

// us, the median; each tick a segment against CGAL's tree, from above where the tip was to where it is. A finger proxy
// needs up to four of them in a tick: one for each plane that holds it, and one that finds no other.
double segmentByCgal(const TriangleSoup& mesh, const std::vector<Vec3>& path) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Iterator = std::vector<Kernel::Triangle_3>::const_iterator;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
  const auto point = [](const Vec3& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
  std::vector<Kernel::Triangle_3> triangles;
  for (const Triangle& t : mesh.triangles)
    triangles.emplace_back(point(mesh.points[t[0]]), point(mesh.points[t[1]]), point(mesh.points[t[2]]));
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.cbegin(), triangles.cend());
  tree.build();
  TickTimes times;
  std::size_t missed = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Kernel::Segment_3 segment(point(1.05 * path[i - 1]), point(path[i]));
    times.add([&] { missed += !tree.do_intersect(segment); });
  }
  return missed == 0 ? times.quantile(0.5) : std::nan("");  // the tip is below the surface
}

// "10.1 k", "4.99 M"
std::string named(std::size_t triangles) {
  const bool isMillions = triangles >= 1'000'000;
  char text[16];
  std::snprintf(text, sizeof text, "%.3g %c", static_cast<double>(triangles) / (isMillions ? 1e6 : 1e3),
                isMillions ? 'M' : 'k');
  return text;
}

// Squares to a side of the cube for some 10 k, 100 k, 1 M and 5 M triangles.
constexpr int kSides[] = {29, 91, 289, 645};
// us, the medians of a tick and of a segment against CGAL's tree on the same path.
struct Medians {
  double tick = 0.0, segment = 0.0;
};
// At 100 mm/s, by the side; for growth().
std::map<int, Medians> middles;

void sliding(benchmark::State& state) {
  const int side = kSides[state.range(0)];
  const double speed = static_cast<double>(state.range(1));
  const TriangleSoup mesh = ball(side, bumpyRadius);
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
  const std::vector<Vec3> path = pathOf(speed, 1.0, kDepth);
  const double segment = segmentByCgal(mesh, path);
  state.counters["segment_us"] = segment;
  if (!fast) middles[side] = {slide.middle, segment};
  bars.atMost(what + "median to one segment against CGAL's tree", 4.0, ratioTo(slide.middle, segment));
  bars.atMost(what + "stalls", 0, slide.stalls);
  bars.atMost(what + "force off the ideal by (share)", 0.1, slide.worst);
  const double exact = exactLeap(mesh, path, kDepth);
  state.counters["leap"] = slide.leap;
  state.counters["exact_leap"] = exact;
  bars.atMost(what + "largest leap to the exact control's", 1.1, slide.leap / exact);
}

struct Scan {
  const char* file;
  Vec3 axis;  // around which the tip goes
};
const Scan kScans[] = {{"scans/meshlab-samples/bunny10k.ply", Vec3::UnitY()},
                       {"anatomy/femur-proximal/femur_01.ply", Vec3::UnitZ()},
                       {"scans/common-3d-test-models/stanford-bunny.obj", Vec3::UnitY()},
                       {"scans/meshlab-samples/Laurana50k.ply", Vec3::UnitY()}};

// Touches scanned surfaces, compared with the exact control tick by tick: a narrow corner holds back both. Two proxies
// on different sides of a ridge stay so for some ticks, so a force is correct if it equals that of a control that has
// gone the whole path by itself, or that of one which starts each tick from the present proxy. (At one position a
// second sheet passes through the surface; a control ignores it, but one of the two is not there.)
void scans(benchmark::State& state) {
  const Scan& scan = kScans[state.range(0)];
  const ReadScan read = scanOf(scan.file);
  if (!read.isThere) return bars.missing(state, scan.file, "HANDWHEEL_DATA is not set, or this scan is not in it");
  if (!read.mesh) return bars.failed(state, scan.file, "is refused");
  const TriangleSoup* const mesh = &*read.mesh;
  constexpr double kShallow = 0.3;  // mm of 76
  const std::vector<Vec3> path = pathOver(*mesh, scan.axis, 0.1, kShallow, kTicks);
  const ContactSurface surface = touchableSurface(mesh->points, mesh->triangles, {});
  const TriangleHierarchy triangles(mesh->points, mesh->triangles);
  TickTimes times;
  int stalls = 0, late = 0, compared = 0, off = 0;
  double leap = 0.0, exactest = 0.0;
  for (auto _ : state) {
    GodObject god;
    ExactGodObject exact(*mesh), oneTick(*mesh);
    exact.place(path.front());
    god.place(path.front() + 2.0 * (exact.proxy() - path.front()));
    Vec3 last = Vec3::Zero(), lastExact = Vec3::Zero();
    bool wasTouching = false, wasLate = false;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Vec3& tip = path[i];
      times.add([&] { god.follow(surface, tip, {}); });
      const Contact& contact = god.contact();
      if (contact.touching && !wasTouching) exact.place(contact.proxy);  // the contact point is its own affair
      const Vec3 control = exact.follow(tip);
      if (contact.touching && wasTouching) {
        ++compared;
        const double moved = (contact.proxy - last).norm(), movedExactly = (control - lastExact).norm();
        const double step = (tip - path[i - 1]).norm();
        const auto stood = triangles.nearest(last);
        oneTick.stand(stood->triangle, stood->point);
        const Vec3 next = oneTick.follow(tip);
        const auto isOff = [&](const Vec3& proxy) {
          const double wanted = (proxy - tip).norm();
          return std::abs(contact.depth - wanted) > 0.1 * std::max(kShallow, wanted);
        };
        const bool isLate = moved < 1e-4 * step && movedExactly > 1e-2 * step;
        late += isLate ? 1 : 0;
        stalls += isLate && wasLate ? 1 : 0;
        wasLate = isLate;
        off += isOff(control) && isOff(next) ? 1 : 0;
        leap = std::max(leap, ((contact.proxy - last) - (tip - path[i - 1])).norm());
        exactest = std::max(exactest, ((control - lastExact) - (tip - path[i - 1])).norm());
      }
      wasTouching = contact.touching;
      last = contact.proxy;
      lastExact = control;
    }
  }
  const std::string what =
      std::filesystem::path(scan.file).stem().string() + ", " + named(mesh->triangles.size()) + ": ";
  state.counters["in_contact"] = compared;
  if (compared < kTicks / 2) return bars.failed(state, what, "hardly ever in contact");
  bars.atMost(what + "us, median", 4.0, times.quantile(0.5));
  bars.atMost(what + "us, p99", 10.0, times.quantile(0.99));
  bars.tell(what + "ticks by which it leaves a corner later than the exact control", late);
  bars.atMost(what + "stalls: longer than one such tick", 0, stalls);
  bars.atMost(what + "ticks with a force off the exact control's by 10 %", 0, off);
  bars.atMost(what + "largest leap to the exact control's", 1.1, leap / exactest);
}

// Compares the growth from 10 k to 5 M triangles with that of a segment against CGAL's tree on the same path: besides
// the logarithm, a larger model is less often in the processor's cache.
void tellGrowth(const std::string& motion, const Medians& small, const Medians& large) {
  const double grown = large.tick / small.tick,
               logarithm = std::log(12.0 * kSides[3] * kSides[3]) / std::log(12.0 * kSides[0] * kSides[0]);
  bars.atMost("growth from 10 k to 5 M, " + motion + ", to that of a segment against CGAL's tree", 1.25,
              ratioTo(grown, large.segment / small.segment));
  bars.tell("growth from 10 k to 5 M, " + motion + ", to that of the logarithm", grown / logarithm);
}

// Measures the cost of the number of triangles by itself: the same motion counted in triangles, a twentieth of a side
// in a tick and half a side deep. At the same motion in mm a finer mesh also has more triangles under the tip and on
// its path.
void growth(benchmark::State& state) {
  std::map<int, Medians> inTriangles;
  for (auto _ : state)
    for (const int side : {kSides[0], kSides[3]}) {
      const double length =
          0.5 * std::numbers::pi * kBallRadius / side;  // length of an edge: a side of the cube is a quarter turn
      const TriangleSoup mesh = ball(side, bumpyRadius);
      const std::vector<Vec3> path = pathOf(1e3 * length / 20, 1.0, 0.5 * length);
      inTriangles[side] = {slideAlong(surfaceOf(mesh), path, 0.5 * length).middle, segmentByCgal(mesh, path)};
    }
  tellGrowth("same motion in triangles", inTriangles[kSides[0]], inTriangles[kSides[3]]);
  const std::string inTheWay = "100 mm/s, more triangles in the way";
  if (middles.contains(kSides[0]) && middles.contains(kSides[3]))
    tellGrowth(inTheWay, middles[kSides[0]], middles[kSides[3]]);
  else
    bars.skipped(state, "growth from 10 k to 5 M, " + inTheWay, "sliding/0 and sliding/3 did not run");
  bars.tell("us that the clock took, and that no figure has in it", clockCost());
}

// Adds the defects of scans, at three scales; the same mesh without them is the control.
void defects(benchmark::State& state) {
  const TriangleSoup clean = ball(91, bumpyRadius);
  const Slide control = slideOver(surfaceOf(clean), 100.0);
  struct Variant {
    const char* name;
    std::function<void(TriangleSoup&)> spoil;
  };
  const Variant variants[] = {
      {"triangles turned over", turnSome},
      {"seams of 1 um", [](TriangleSoup& m) { cutSeams(m, 0.001); }},
      {"seams of 20 um", [](TriangleSoup& m) { cutSeams(m, 0.02); }},
      {"soup, corners 1e-5 mm apart", [](TriangleSoup& m) { shatter(m, 0.5e-5); }},
      {"needles", addNeedles},
  };
  for (auto _ : state)
    for (const double scale : {1e-3, 1.0, 1e3})
      for (const Variant& variant : variants) {
        TriangleSoup mesh = clean;
        variant.spoil(mesh);
        for (Vec3& p : mesh.points) p *= scale;
        closeContactGaps(mesh.points, mesh.triangles);
        const Slide slide = slideOver(surfaceOf(mesh), 100.0, scale);
        const std::string what = std::string(variant.name) + (scale < 1 ? ", x 1e-3" : scale > 1 ? ", x 1e+3" : "");
        bars.atMost(what + ": stalls", 0, slide.stalls);
        bars.atMost(what + ": force off the ideal by (share)", 0.1, slide.worst);
        bars.atMost(what + ": largest leap to the clean mesh's", 1.1, slide.leap / control.leap);
      }
}

// An edit under the tip: time in proportion to it, whatever the size of the mesh.
void edits(benchmark::State& state) {
  const TriangleSoup mesh = ball(289, bumpyRadius);
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
  const TriangleSoup mesh = ball(91, bumpyRadius);
  const ContactSurface surface = surfaceOf(mesh);
  const TriangleHierarchy truth(mesh.points, mesh.triangles);
  int lost = 0;
  std::size_t touching = 0;  // ticks in contact
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
      touching += contact.touching ? 1 : 0;
      if (i % 10 != 0 && contact.touching) continue;
      const auto hit = truth.firstHit(Vec3::Zero(), contact.proxy);
      lost += hit && hit->distance > 1.0 + 1e-9 ? 1 : 0;
      if (contact.touching)
        off = std::max(off, std::sqrt(truth.nearest(contact.proxy)->squaredDistance) / surface.diagonal());
    }
  }
  state.counters["lost"] = lost;
  bars.atMostOver(touching, "pop-throughs in 1 M ticks", 0, lost);
  bars.atMostOver(touching, "proxy off the surface, share of the model's size", 1e-6, off);
  bars.tell("ticks of these in contact", static_cast<double>(touching));
}

BENCHMARK(sliding)
    ->Args({0, 100})
    ->Args({1, 100})
    ->Args({2, 100})
    ->Args({3, 100})
    ->Args({2, 1000})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(scans)->DenseRange(0, 3)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(growth)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(defects)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(edits)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(popThroughs)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
