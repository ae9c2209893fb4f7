// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SnapShapes.h"
#include "TestClass.h"
#include "haptics/snap/SnapProxy.h"
#include "haptics/snap/SnapSum.h"

#include <QtTest>
#include <cstdlib>
#include <new>

using namespace handwheel;
using namespace handwheel::test;

namespace {

thread_local bool counts = false;
thread_local int countedAllocations = 0;

// Returns the number of allocations on this thread during the work.
template <class Work>
int allocationsIn(Work work) {
  countedAllocations = 0;
  counts = true;
  work();
  counts = false;
  return countedAllocations;
}

}  // namespace

// Replaces the operator of the library, here and in every library of the program.
void* operator new(std::size_t size) {
  if (counts) ++countedAllocations;
  if (void* p = std::malloc(size ? size : 1)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}

// The work of the servo thread in a tick.
class SnapTickTest : public QObject {
  Q_OBJECT

 private slots:
  void allocatesNothing();
};

void SnapTickTest::allocatesNothing() {
  QCOMPARE(allocationsIn([] { ::operator delete(::operator new(1)); }), 1);  // it does count
  std::mt19937 random(1);
  auto features = featuresOf(randomSimplices(random, 3000, 10.0, 1.0));
  std::vector<Vec3> line;
  for (int i = 0; i < 100; ++i) line.push_back(randomIn(random, 10.0));
  features.addCurve(7, line, true);
  const SnapField field(features);
  std::vector<Vec3> hands;
  for (int i = 0; i < 1000; ++i) hands.push_back(randomIn(random, 11.0));
  SnapSum sum;
  SnapProxy proxy;
  Vec3 total = Vec3::Zero();
  for (const SnapShape shape : kSnapShapes)
    for (const double distance : {0.5, 20.0}) {  // few in reach; all of them
      const int count = allocationsIn([&] {
        const SnapProfile profile(shape, 0.5, distance);
        for (const Vec3& hand : hands)
          total += sum.step(field, profile, hand).force + proxy.step(field, profile, hand).force;
      });
      QCOMPARE(count, 0);
    }
  QVERIFY(total.norm() > 0.0);
}

HANDWHEEL_TEST(SnapTickTest)
#include "SnapTickTest.moc"
