// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Bars.h"
#include "collision/ProximityQuery.h"
#include "core/collision/TriangleOracle.h"
#include "robot/Kinematics.h"
#include "robot/dh/DhTable.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <numeric>
#include <random>

using namespace handwheel;

namespace {

bench::Bars bars;

constexpr double kNear = 20.0;  // mm: the tolerance
constexpr std::size_t kAll = 1'000'000;
constexpr std::size_t kLinks = 6;

// A tube with bumps and round ends around a line. Its ends have no triangles without area: FCL counts contacts of
// those, too.
TriangleSoup tube(const Vec3& from, const Vec3& to, double radius, int around, int along) {
  TriangleSoup soup;
  const Vec3 segment = to - from, axis = segment.norm() > 1.0 ? Vec3(segment.normalized()) : Vec3(Vec3::UnitZ());
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  for (int j = 0; j <= along; ++j) {
    const double t = M_PI * j / along, across = radius * std::sin(t) * (1.0 + 0.05 * std::sin(9.0 * t));
    const Vec3 middle = 0.5 * (from + to) - (0.5 * segment.norm() + radius) * std::cos(t) * axis;
    for (int i = 0; i < around; ++i) {
      const double turn = 2.0 * M_PI * i / around;
      soup.points.push_back(middle + across * (std::cos(turn) * u + std::sin(turn) * v));
    }
  }
  for (int j = 0; j < along; ++j) {
    for (int i = 0; i < around; ++i) {
      const auto at = [&](int a, int b) { return static_cast<std::uint32_t>(around * b + a % around); };
      if (j > 0) soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      if (j + 1 < along) soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return soup;
}

// A shell of the size of a car's body before the robot, bent, with windows that an arm can reach through.
TriangleSoup carBody() {
  constexpr int kAlong = 100, kAcross = 44;
  TriangleSoup soup;
  for (int j = 0; j <= kAlong; ++j) {
    for (int i = 0; i <= kAcross; ++i) {
      const double y = 2.0 * j / kAlong - 1.0, turn = M_PI * (i / static_cast<double>(kAcross));
      const double height = 700.0 + 400.0 * std::exp(-6.0 * y * y) + 15.0 * std::sin(12.0 * turn) * std::cos(20.0 * y);
      const double narrow = 1.0 - 0.3 * y * y;
      soup.points.emplace_back(1050.0 - 550.0 * narrow * std::cos(turn), 2295.0 * y,
                               height * std::pow(std::sin(turn), 0.6));
    }
  }
  const auto at = [](int i, int j) { return static_cast<std::uint32_t>((kAcross + 1) * j + i); };
  for (int j = 0; j < kAlong; ++j) {
    for (int i = 0; i < kAcross; ++i) {
      const bool isWindow = (j / 8) % 3 == 1 && (i / 5) % 4 == 2;
      if (isWindow) continue;
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return soup;
}

using Model = std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>>;

Model modelOf(const TriangleSoup& soup) {
  const auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  std::vector<fcl::Triangle> triangles;
  for (const Triangle& t : soup.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  model->beginModel();
  model->addSubModel(soup.points, triangles);
  model->endModel();
  model->computeLocalAABB();
  return model;
}

using Configuration = std::array<Pose, kLinks>;

// The six moving links of an IRB 140 and the shell: as bodies of a query, and as FCL has them.
class Cell {
 public:
  Cell() : m_robot(robotOf(*libraryTable("irb140"))) {
    std::vector<CollisionBody> bodies;
    const auto add = [&](const TriangleSoup& soup) {
      m_soups.push_back(soup);
      m_triangles.push_back(static_cast<double>(soup.triangles.size()));
      m_models.push_back(modelOf(soup));
      bodies.push_back(
          CollisionBody({CollisionPiece::ofMesh(Pose::Identity(), std::make_shared<const CollisionMesh>(soup))}));
    };
    for (const std::uint32_t j : m_robot.order) {
      if (m_robot.joints[j].dof == kNone || m_links.size() == kLinks) continue;
      const std::uint32_t link = m_robot.joints[j].child;
      Vec3 to = Vec3::Zero();
      for (const Joint& next : m_robot.joints) {
        if (next.parent == link) to = next.origin.translation();
      }
      const double radius = 90.0 - 10.0 * static_cast<double>(m_links.size());
      m_links.push_back(link);
      add(tube(Vec3::Zero(), to, radius, 24, 27));
    }
    add(carBody());
    std::vector<BodyPair> pairs;
    for (std::uint32_t i = 0; i < kLinks; ++i) pairs.push_back({i, kLinks});
    m_query.emplace(std::move(bodies), pairs);
  }

  ProximityQuery& query() { return *m_query; }
  const fcl::BVHModel<fcl::OBBRSSd>& link(std::size_t i) const { return *m_models[i]; }
  const fcl::BVHModel<fcl::OBBRSSd>& body() const { return *m_models[kLinks]; }
  const TriangleSoup& soup(std::size_t i) const { return m_soups[i]; }
  double robotTriangles() const { return std::accumulate(m_triangles.begin(), m_triangles.end() - 1, 0.0); }
  double bodyTriangles() const { return m_triangles.back(); }

  Configuration configurationAt(const JointValues& values) const {
    const std::vector<Pose> poses = linkPoses(m_robot, values);
    Configuration configuration;
    for (std::size_t i = 0; i < kLinks; ++i) configuration[i] = poses[m_links[i]];
    return configuration;
  }

  JointValues anyValues(std::mt19937& random) const {
    JointValues values(static_cast<Eigen::Index>(m_robot.dofs.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const JointLimits& limits = m_robot.jointOfDof(static_cast<std::uint32_t>(i)).limits;
      values[i] = limits.lower + (limits.upper - limits.lower) * (random() / 4294967296.0);
    }
    return values;
  }

 private:
  RobotModel m_robot;
  std::vector<std::uint32_t> m_links;
  std::vector<double> m_triangles;
  std::vector<TriangleSoup> m_soups;
  std::vector<Model> m_models;
  std::optional<ProximityQuery> m_query;
};

Cell& cell() {
  static Cell one;
  return one;
}

// Return random configurations of the robot, or those at every millisecond of motions between such at 1 rad/s.
const std::vector<Configuration>& randomConfigurations() {
  static const std::vector<Configuration> all = [] {
    std::vector<Configuration> configurations;
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) configurations.push_back(cell().configurationAt(cell().anyValues(random)));
    return configurations;
  }();
  return all;
}

const std::vector<Configuration>& motion() {
  static const std::vector<Configuration> all = [] {
    std::vector<Configuration> configurations;
    std::mt19937 random(8);
    JointValues from = cell().anyValues(random);
    while (configurations.size() < 20000) {
      const JointValues to = cell().anyValues(random);
      const double seconds = (to - from).cwiseAbs().maxCoeff();
      for (double t = 0.0; t < seconds; t += 0.001)
        configurations.push_back(cell().configurationAt(from + (t / seconds) * (to - from)));
      from = to;
    }
    return configurations;
  }();
  return all;
}

// FCL as one uses it well: a minimum that is there already prunes, and is handed from link to link.
double fclDistance(const Configuration& configuration, double enough, bool needsPoints) {
  fcl::DistanceRequestd request(needsPoints);
  fcl::DistanceResultd result;
  result.min_distance = enough;
  for (std::size_t i = 0; i < kLinks && result.min_distance > 0.0; ++i)
    fcl::distance(&cell().link(i), configuration[i], &cell().body(), Pose::Identity(), request, result);
  return result.min_distance;
}

std::size_t fclContacts(const Configuration& configuration, std::size_t most) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < kLinks && count < most; ++i) {
    fcl::CollisionRequestd request(most, false);
    fcl::CollisionResultd result;
    count += fcl::collide(&cell().link(i), configuration[i], &cell().body(), Pose::Identity(), request, result);
  }
  return count;
}

void place(const Configuration& configuration) {
  for (std::uint32_t i = 0; i < kLinks; ++i) cell().query().place(i, configuration[i]);
}

// C1 to C4 of He 2008, table 3-1: the closest points, nearer than a tolerance, colliding, and all contacts, which are
// the pairs of triangles that meet; and the closest points of every link that is near.
enum Query { kClosest, kTolerance, kColliding, kContacts, kNearPairs };
constexpr std::array<const char*, 5> kQueries = {"C1 closest points", "C2 tolerance", "C3 colliding", "C4 all contacts",
                                                 "near pairs"};

struct Answer {
  double value;  // the value that both must return
  double seconds;
};

Answer ours(Query which, const Configuration& configuration) {
  double value = 0.0;
  static std::vector<NearPair> near;
  static std::vector<BodyContact> contacts;
  const double seconds = bench::secondsOf([&] {
    place(configuration);
    ProximityQuery& query = cell().query();
    switch (which) {
      case kClosest: {
        const auto found = query.closest();
        value = found ? std::max(0.0, found->points.distance) : 1e9;
        break;
      }
      case kTolerance:
        value = query.isNearer(kNear);
        break;
      case kColliding:
        value = query.isOverlapping();
        break;
      case kContacts:
        query.findContacts(0.0, kAll, contacts);
        value = static_cast<double>(contacts.size());
        break;
      case kNearPairs:
        query.findNear(kNear, near);
        value = static_cast<double>(near.size());
        break;
    }
  });
  return {value, seconds};
}

Answer theirs(Query which, const Configuration& configuration) {
  double value = 0.0;
  const double seconds = bench::secondsOf([&] {
    switch (which) {
      case kClosest:
        value = fclDistance(configuration, 1e9, true);
        break;
      case kTolerance:
        value = fclDistance(configuration, kNear, false) < kNear;
        break;
      case kColliding:
        value = fclContacts(configuration, 1) > 0;
        break;
      case kContacts:
        value = static_cast<double>(fclContacts(configuration, kAll));
        break;
      case kNearPairs:
        for (std::size_t i = 0; i < kLinks; ++i) {
          fcl::DistanceRequestd request(true);
          fcl::DistanceResultd result;
          result.min_distance = kNear;
          fcl::distance(&cell().link(i), configuration[i], &cell().body(), Pose::Identity(), request, result);
          value += result.min_distance < kNear;
        }
        break;
    }
  });
  return {value, seconds};
}

struct Times {
  std::vector<double> each;
  double total = 0.0;
  void add(double seconds) {
    each.push_back(seconds);
    total += seconds;
  }
  double mean() const { return 1e6 * total / static_cast<double>(each.size()); }  // us
  double p99() {
    std::sort(each.begin(), each.end());
    return 1e6 * each[each.size() * 99 / 100];
  }
};

// Returns the scene of a configuration: #1 apart, #2 nearer than the tolerance, #3 colliding.
std::size_t sceneOf(const Configuration& configuration) {
  const double distance = fclDistance(configuration, kNear, false);
  return distance >= kNear ? 0 : distance > 0.0 ? 1 : 2;
}

// Runs one query over all configurations: its times as a whole and in each scene, with FCL's at every n-th
// configuration.
void queries(benchmark::State& state) {
  const auto which = static_cast<Query>(state.range(0));
  const bool isMotion = state.range(1) == 1;
  const std::vector<Configuration>& all = isMotion ? motion() : randomConfigurations();
  const std::size_t every = isMotion ? 10 : 1;
  const std::string name = std::string(kQueries[which]) + (isMotion ? ", 1 kHz motion" : ", random places");
  Times own, fcls;
  std::array<Times, 3> scenes, fclScenes;
  std::array<QueryCounts, 3> counts{};
  bool isSame = true;
  for (auto _ : state) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      cell().query().resetCounts();
      const Answer answer = ours(which, all[i]);
      own.add(answer.seconds);
      if (i % every != 0) continue;
      const Answer other = theirs(which, all[i]);
      const std::size_t scene = sceneOf(all[i]);
      isSame &= std::abs(answer.value - other.value) <= 1e-6 * (1.0 + other.value);
      fcls.add(other.seconds);
      scenes[scene].add(answer.seconds);
      fclScenes[scene].add(other.seconds);
      const QueryCounts& done = cell().query().counts();
      counts[scene].volumes += done.volumes;
      counts[scene].pairs += done.pairs;
    }
  }
  if (!isSame) return bars.failed(state, name, "FCL says something else");
  state.counters["us"] = own.mean();
  state.counters["us99"] = own.p99();
  state.counters["fcl_us"] = fcls.mean();
  state.counters["ratio"] = bench::ratioTo(own.mean(), fcls.mean());
  for (std::size_t scene = 0; scene < 3; ++scene) {
    const std::string number = "#" + std::to_string(scene + 1);
    const auto count = static_cast<double>(scenes[scene].each.size());
    if (count == 0.0) continue;
    const std::string row = name + " " + number + " (" + std::to_string(scenes[scene].each.size()) + ")";
    bars.tell(row + ", us", scenes[scene].mean());
    bars.tell(row + ", us of FCL", fclScenes[scene].mean());
    bars.tell(row + ", bounding volumes", static_cast<double>(counts[scene].volumes) / count);
    bars.tell(row + ", triangles", static_cast<double>(counts[scene].pairs) / count);
  }
  // The query is meant for successive frames. FCL returns no depth, so collisions do not count for near pairs; for
  // contacts it returns only the intersecting triangles, while ours returns their positions and displacements.
  double ratio = bench::ratioTo(own.mean(), fcls.mean());
  if (which == kNearPairs)
    ratio = bench::ratioTo(scenes[0].total + scenes[1].total, fclScenes[0].total + fclScenes[1].total);
  const bool isBar = isMotion && which != kContacts;
  isBar ? bars.atMost(name + ", to FCL", 1.0, ratio) : bars.tell(name + ", to FCL", ratio);
  if (which == kTolerance) {
    bars.atMost(name + ", mean us (20 kHz)", 50.0, own.mean());
    bars.atMost(name + ", p99 us (a servo period)", 1000.0, own.p99());
  }
  if (which == kClosest) bars.atMost(name + ", mean us (1 kHz)", 1000.0, own.mean());
  state.counters["robot"] = cell().robotTriangles();
  state.counters["body"] = cell().bodyTriangles();
}

// Pairs of triangles nearer than a distance, by looking at each.
std::size_t nearByBruteForce(const Configuration& configuration, double than) {
  std::size_t count = 0;
  const TriangleSoup& shell = cell().soup(kLinks);
  for (std::size_t link = 0; link < kLinks; ++link) {
    const TriangleSoup& soup = cell().soup(link);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
      const test::Corners s = test::cornersOf(soup, i, configuration[link]);
      Box box;
      for (const Vec3& corner : s) box.extend(corner);
      const Vec3 low = box.min().array() - than, high = box.max().array() + than;
      for (std::size_t j = 0; j < shell.triangles.size(); ++j) {
        const Triangle& t = shell.triangles[j];
        const Vec3 &a = shell.points[t[0]], &b = shell.points[t[1]], &c = shell.points[t[2]];
        if ((a.cwiseMax(b).cwiseMax(c).array() < low.array()).any()) continue;
        if ((a.cwiseMin(b).cwiseMin(c).array() > high.array()).any()) continue;
        count += test::triangleDistance(s, {a, b, c}) < than ? 1 : 0;
      }
    }
  }
  return count;
}

// Finds all contacts with a margin, for which FCL has no query: compared with every pair of triangles, at a few
// configurations near the body.
void contactsWithMargin(benchmark::State& state) {
  constexpr std::size_t kConfigurations = 10;
  constexpr double kRounding = 1e-6;  // mm: what is at the margin by this may count or not
  const std::string name = "C4 all contacts nearer than 20 mm";
  Times own, brute;
  double found = 0.0, wrong = 0.0;
  std::vector<BodyContact> contacts;
  for (auto _ : state) {
    for (std::size_t i = 0; i < randomConfigurations().size() && own.each.size() < kConfigurations; ++i) {
      const Configuration& configuration = randomConfigurations()[i];
      if (sceneOf(configuration) == 0) continue;
      own.add(bench::secondsOf([&] {
        place(configuration);
        cell().query().findContacts(kNear, kAll, contacts);
      }));
      found += static_cast<double>(contacts.size());
      std::size_t least = 0;
      brute.add(bench::secondsOf([&] { least = nearByBruteForce(configuration, kNear - kRounding); }));
      wrong +=
          contacts.size() < least || contacts.size() > nearByBruteForce(configuration, kNear + kRounding) ? 1.0 : 0.0;
    }
  }
  bars.atMostOver(own.each.size(), name + ": places with others than every pair tells", 0.0, wrong);
  bars.tell(name + ": mean number", found / static_cast<double>(own.each.size()));
  bars.tell(name + ": mean us", own.mean());
  bars.tell(name + ": mean us of every pair", brute.mean());
}

}  // namespace

BENCHMARK(queries)->ArgsProduct({{kClosest, kTolerance, kColliding, kContacts, kNearPairs}, {0, 1}})->Iterations(1);
BENCHMARK(contactsWithMargin)->Iterations(1);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
