// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LargeInputs.h"
#include "RoundCells.h"
#include "TestClass.h"
#include "document/cell/CellScene.h"
#include "planning/PathVerification.h"

#include <QTest>
#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The solids of a link, of the carried part or of an obstacle, in the world.
using Solids = std::vector<ConvexSet>;

struct Samples {
  double most = 1e9;   // mm: no distance is larger than its clearance by more than this at all samples
  double least = 1e9;  // mm: every distance at the samples exceeds its clearance by at least this
};

// Samples a motion at most kStep apart, and reckons all distances by the independent calculation.
class Sampling {
 public:
  Sampling(const RoundCell& cell, const CellScene& scene) : m_cell(cell) {
    for (const auto& obstacle : cell.obstacles) m_obstacles.push_back(placed(obstacle, Pose::Identity()));
    findPairs(scene);
  }

  Samples take() const {
    constexpr double kStep = 0.25;                                // mm: travel of the robot between two samples
    const double travel = std::max(2.0 * m_cell.travel(), 1e-9);  // two links move towards each other
    Samples all;
    for (double share = 0.0;;) {
      const Samples here = at(m_cell.from + share * (m_cell.to - m_cell.from));
      all.most = std::min(all.most, here.most);
      all.least = std::min(all.least, here.least);
      if (share >= 1.0 || all.most < -kTooNear) return all;
      share = std::min(1.0, share + std::max(kStep, here.least) / travel);
    }
  }
  static constexpr double kTooNear = 1e-5;  // mm

 private:
  static Solids placed(const std::vector<RoundSolid>& solids, const Pose& pose) {
    Solids made;
    for (const RoundSolid& each : solids) {
      made.push_back(each.set);
      made.back().pose = pose * each.set.pose;
    }
    return made;
  }

  // Links are left out only as the scene says, neighbours by the rule: with no link that has a shape in between.
  void findPairs(const CellScene& scene) {
    std::vector<std::size_t> shaped;
    if (!m_cell.base.empty()) shaped.push_back(0);
    for (std::size_t i = 0; i < m_cell.joints.size(); ++i) {
      if (!m_cell.joints[i].solids.empty()) shaped.push_back(i + 1);
    }
    const std::size_t last = m_cell.joints.size();
    const auto add = [&](std::size_t a, std::size_t b) {
      if (!scene.alwaysMeeting.contains({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)}))
        m_pairs.emplace_back(a, b);
    };
    for (std::size_t i = 0; i < shaped.size(); ++i) {
      for (std::size_t j = i + 2; j < shaped.size(); ++j) add(shaped[i], shaped[j]);
      if (m_cell.part && shaped[i] != last) add(shaped[i], last + 1);
    }
  }

  Samples at(const Eigen::VectorXd& values) const {
    const std::vector<Pose> poses = m_cell.linkPoses(values);
    std::vector<Solids> links{placed(m_cell.base, poses.front())};
    for (std::size_t i = 0; i < m_cell.joints.size(); ++i)
      links.push_back(placed(m_cell.joints[i].solids, poses[i + 1]));
    if (m_cell.part) links.push_back(placed({*m_cell.part}, poses.back()));
    Samples nearest;
    for (std::size_t i = 1; i < links.size(); ++i) {
      for (const Solids& obstacle : m_obstacles) compare(links[i], obstacle, m_cell.clearance, nearest);
    }
    for (const auto& [a, b] : m_pairs) compare(links[a], links[b], 0.0, nearest);
    return nearest;
  }

  static void compare(const Solids& one, const Solids& other, double clearance, Samples& nearest) {
    for (const ConvexSet& a : one) {
      for (const ConvexSet& b : other) {
        const double apart = (a.pose.translation() - b.pose.translation()).norm() - a.half.norm() - b.half.norm();
        if (apart - clearance >= std::max(nearest.least, 0.0)) continue;
        const DistanceBounds bounds =
            boundsOfDistance(a, b, b.pose.translation(), 1e-6, clearance + std::max(nearest.least, 0.0));
        // Bodies that touch have a distance of 0, which is not less than a clearance of 0.
        const double touching = clearance == 0.0 && bounds.most < kTooNear ? 2.0 * kTooNear : 0.0;
        nearest.most = std::min(nearest.most, bounds.most - clearance - touching);
        nearest.least = std::min(nearest.least, bounds.least - clearance);
      }
    }
  }

  const RoundCell& m_cell;
  std::vector<Solids> m_obstacles;
  std::vector<std::pair<std::size_t, std::size_t>> m_pairs;
};

}  // namespace

// The proof of motions against dense sampling, in random cells of round numbers and aligned poses: 10,000 cells, or a
// million if HANDWHEEL_LARGE is set.
class ProofSamplingTest : public QObject {
  Q_OBJECT

 private slots:
  void cells_data() {
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= sized(10U, 100U); ++seed) QTest::addRow("seed %u", seed) << seed;
  }
  // No motion is proven where a sample collides or is nearer than the clearance. At most 1 % of those that keep the
  // clearance and a millimetre more are not proven.
  void cells() {
    QFETCH(unsigned, seed);
    const int count = sized(1'000, 10'000);
    constexpr double kSpare = 1.0;  // mm
    RoundCells cells(seed);
    int proven = 0, kept = 0, missed = 0;
    for (int i = 0; i < count; ++i) {
      const RoundCell cell = cells.next();
      CollisionMeshes meshes;
      const Result<CellScene> scene = sceneOf(cellOf(cell), meshes);
      QVERIFY2(scene.hasValue(), qPrintable(QString("cell %1").arg(i)));
      MotionCheckSettings settings;
      settings.clearance = cell.clearance;
      MotionCheck check(scene->scene, scene->planned(cell.from), scene->planned(cell.to), settings);
      const bool isProven = check.run() == MotionCheck::State::Free;
      const Samples samples = Sampling(cell, *scene).take();
      proven += isProven ? 1 : 0;
      kept += samples.least >= kSpare ? 1 : 0;
      missed += samples.least >= kSpare && !isProven ? 1 : 0;
      QVERIFY2(!isProven || samples.most > -Sampling::kTooNear,
               qPrintable(QString("cell %1 is proven, but nearer by %2 mm").arg(i).arg(-samples.most)));
    }
    qInfo("%d cells: %d motions proven, %d keep %g mm more than the clearance, %d of them not proven", count, proven,
          kept, kSpare, missed);
    QVERIFY(proven > count / 20);
    QVERIFY2(100 * missed <= kept, qPrintable(QString("%1 of %2").arg(missed).arg(kept)));
  }

  // A cube of 5 mm that stands and moves inside of a mesh without touching its surface, in each of its shells. The
  // third shell is inside of the second.
  void insideOfAShell() {
    RoundCell cell;
    RoundJoint slide{.isPrismatic = true, .axis = Vec3::UnitX(), .solids = {}};
    slide.solids.push_back({{ConvexSet::Kind::Block, Pose::Identity(), Vec3::Constant(2.5), {}}});
    cell.joints.push_back(slide);
    std::vector<RoundSolid> shells;
    for (const auto& [x, half] : {std::pair(-200.0, 20.0), std::pair(100.0, 50.0), std::pair(100.0, 20.0)})
      shells.push_back({{ConvexSet::Kind::Block, Pose(Eigen::Translation3d(x, 0, 0)), Vec3::Constant(half), {}}, true});
    cell.obstacles.push_back(shells);
    for (const auto& [from, to, isFree] : {std::tuple(-205.0, -195.0, false), std::tuple(60.0, 65.0, false),
                                           std::tuple(95.0, 105.0, false), std::tuple(-100.0, 40.0, true)}) {
      cell.from = Eigen::VectorXd::Constant(1, from);
      cell.to = Eigen::VectorXd::Constant(1, to);
      CollisionMeshes meshes;
      const Result<CellScene> scene = sceneOf(cellOf(cell), meshes);
      QVERIFY(scene.hasValue());
      const VerifiedPath path = verified(scene->scene, {cell.from, cell.to}, {});
      QCOMPARE(path.isCertified(), isFree);
      QVERIFY(isFree || (!path.collisions.empty() && path.collisions.front().deepest.distance <= 0.0));
    }
  }
};

HANDWHEEL_TEST(ProofSamplingTest)
#include "ProofSamplingTest.moc"
