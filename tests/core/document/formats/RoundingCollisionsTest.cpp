// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/RoundingCollisions.h"

#include "TestClass.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/structure/Weld.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

// Returns a corner of a coarse lattice, off it by less than half a step of single precision: many of them round to the
// same position.
Vec3 nearLatticePoint() {
  const auto coordinate = [] { return *rc::gen::inRange(1, 3) + *rc::gen::inRange(-3, 4) * std::ldexp(1.0, -27); };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

// Tetrahedra with corners of their own, so that they touch at most by the positions they happen to share.
TriangleSoup tetrahedra(int count) {
  TriangleSoup soup;
  for (int i = 0; i < count; ++i) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    for (int k = 0; k < 4; ++k) soup.points.push_back(nearLatticePoint());
    for (const Triangle& t : {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{1, 2, 3}, Triangle{2, 0, 3}}) {
      soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    }
  }
  return soup;
}

MeshReport roundingFigures(const TriangleSoup& soup) {
  return reportOn(soup, SelfIntersections::Skip);
}

}  // namespace

class RoundingCollisionsTest : public QObject {
  Q_OBJECT

 private slots:
  void edgesStaySound() {
    const bool holds = rc::check("rounding spoils no edge or vertex, and moves nothing far", [] {
      const TriangleSoup exact = tetrahedra(*rc::gen::inRange(1, 6));
      TriangleSoup inFile = exact;
      roundPoints(inFile, NumberType::Float32);
      const TriangleSoup plain = inFile;
      const auto parted = separateRoundedVertices(exact, inFile);
      RC_CLASSIFY(!parted.empty(), "vertices parted");

      const MeshReport before = roundingFigures(exact), welded = roundingFigures(plain),
                       after = roundingFigures(inFile);
      RC_ASSERT(after.nonManifoldEdges <= before.nonManifoldEdges);
      RC_ASSERT(after.inconsistentEdges <= before.inconsistentEdges);
      RC_ASSERT(after.nonManifoldVertices <= before.nonManifoldVertices);
      if (welded.nonManifoldEdges == 0 && welded.inconsistentEdges == 0 && welded.nonManifoldVertices == 0)
        RC_ASSERT(parted.empty());
      for (std::uint32_t v = 0; v < plain.points.size(); ++v) {
        const bool moved = inFile.points[v] != plain.points[v];
        RC_ASSERT(moved == (std::find(parted.begin(), parted.end(), v) != parted.end()));
        // One step at numbers from 2 to 4 is 2^-22.
        RC_ASSERT((inFile.points[v] - plain.points[v]).cwiseAbs().maxCoeff() <= 4 * std::ldexp(1.0, -22));
        RC_ASSERT(rounded(inFile.points[v], NumberType::Float32) == inFile.points[v]);
      }
      for (std::size_t v = 0; v < exact.points.size(); ++v) {
        for (std::size_t u = 0; u < v; ++u) {
          // One position in the mesh stays one in the file.
          if (exact.points[v] == exact.points[u]) RC_ASSERT(inFile.points[v] == inFile.points[u]);
        }
      }
    });
    QVERIFY(holds);
  }

  void cancelled() {
    TriangleSoup exact{{Vec3(1, 1, 1), Vec3(2, 1, 1), Vec3(1, 2, 1), Vec3(1, 1, 2)},
                       {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    const auto n = static_cast<std::uint32_t>(exact.points.size());  // the same once more, off by less than a step
    for (std::uint32_t v = 0; v < n; ++v)
      exact.points.push_back(exact.points[v] + Vec3::Constant(std::ldexp(1.0, -27)));
    for (std::size_t f = 0; f < 4; ++f) {
      const Triangle t = exact.triangles[f];
      exact.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    }
    TriangleSoup inFile = exact;
    roundPoints(inFile, NumberType::Float32);
    TriangleSoup untouched = inFile;
    QVERIFY(!separateRoundedVertices(exact, inFile).empty());
    JobState job;
    job.cancelled = true;
    QVERIFY(separateRoundedVertices(exact, untouched, Progress(job)).empty());
    roundPoints(exact, NumberType::Float32);
    QVERIFY(untouched.points == exact.points);
  }
};

HANDWHEEL_TEST(RoundingCollisionsTest)
#include "RoundingCollisionsTest.moc"
