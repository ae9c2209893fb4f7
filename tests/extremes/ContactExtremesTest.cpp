// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ContactExtremes.h"
#include "ExtremeRows.h"
#include "TestClass.h"
#include "haptics/contact/TouchableSurface.h"
#include "haptics/safety/SafetyChain.h"
#include "haptics/scene/SurfaceForce.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kTouchStiffness = 0.5;  // N/mm
constexpr double kMostForce = 8.0;       // N, of the device
constexpr double kSkins = 100.0;  // by so many a proxy may be off: it stands on one, and is lifted 16 out of a corner

SafetyChain chainOfDevice() {
  SafetySettings settings;
  settings.maxForce = kMostForce;
  settings.rampTime = 0.01;
  return SafetyChain(settings);
}

// Finite, of length 1 or none, and as deep as it says.
bool isSane(const Contact& contact, const Vec3& tip) {
  if (!contact.proxy.allFinite() || !contact.normal.allFinite() || !std::isfinite(contact.depth)) return false;
  if (!contact.touching) return contact.normal.isZero(0.0) && contact.proxy == tip;
  return std::abs(contact.normal.norm() - 1.0) < 1e-9 &&
         std::abs((contact.proxy - tip).norm() - contact.depth) <= 1e-12 * contact.depth;
}

// The frame of a floor of this size at this position.
struct Frame {
  double scale;
  Pose pose;

  Vec3 operator()(const Vec3& p) const { return pose * Vec3(scale * p); }
  TriangleSoup operator()(TriangleSoup soup) const {
    for (Vec3& p : soup.points) p = (*this)(p);
    return soup;
  }
};

Pose poseAt(double offset, bool isTilted) {
  Pose pose = Pose::Identity();
  if (isTilted) pose.linear() = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = offset * Vec3(1.0, -0.7, 0.3);
  return pose;
}

// Along the path of the tip, the proxy is the nearest point of the plane: in each tick, so it never stands still.
QString offTheFloor(const ContactSurface& surface, const Frame& frame, double breadth) {
  const Vec3 up = frame.pose.linear().col(2);
  const double far = frame.pose.translation().cwiseAbs().maxCoeff() + frame.scale;
  const double rounding = 64.0 * std::numeric_limits<double>::epsilon() * far;
  const double tolerance = kSkins * surface.skin() + rounding + FloorPath::kDepth * rounding / breadth;
  if (tolerance > 0.01 * frame.scale) return "the tolerance says nothing";
  GodObject god;
  god.place(frame(FloorPath::at(0)));
  for (int tick = 0; tick < FloorPath::kTicks; ++tick) {
    const Vec3 point = FloorPath::at(tick), tip = frame(point);
    const Contact& contact = god.follow(surface, tip, {});
    if (!isSane(contact, tip)) return QString("tick %1: no sane contact").arg(tick);
    if (point.z() > 0.01 && contact.touching) return QString("tick %1: touches in free space").arg(tick);
    if (!FloorPath::isPressed(tick)) continue;
    const Vec3 foot = frame(Vec3(point.x(), point.y(), 0));
    const double off = (contact.proxy - foot).norm();
    if (!contact.touching || off > tolerance) return QString("tick %1: off by %2 mm").arg(tick).arg(off);
    const Vec3 force = contactForce(contact, tip, Vec3::Zero(), kTouchStiffness, 0.0);
    const Vec3 wanted = kTouchStiffness * FloorPath::kDepth * frame.scale * up;
    if ((force - wanted).norm() > kTouchStiffness * 2.0 * tolerance) return QString("tick %1: another force").arg(tick);
  }
  return {};
}

}  // namespace

// The proxy and its force on surfaces, with tips, and with settings that are as odd as can be.
class ContactExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void floors_data();
  void floors();
  void anyMesh_data() { test::everyMesh(20'000); }
  void anyMesh();
  void strangeNumbersSendNoStrangeForce();
  void strangeCorners();
};

void ContactExtremesTest::floors_data() {
  QTest::addColumn<ExtremeFloor>("floor");
  for (const ExtremeFloor& floor : extremeFloors()) QTest::newRow(floor.name.c_str()) << floor;
}

// Floors of every size and at every position at which coordinates are fine enough to describe a floor: written down
// there, or as a body that stands there.
void ContactExtremesTest::floors() {
  QFETCH(ExtremeFloor, floor);
  const TriangleSoup soup = floor.soup();
  int cases = 0;
  for (const double scale : test::kScales)
    for (const double offset : test::kOffsets) {
      if (offset * 1e-11 > scale * floor.breadth) continue;
      const ContactSurface own(Frame{scale, Pose::Identity()}(soup).points, soup.triangles);
      for (const bool isTilted : {false, true}) {
        const Frame frame{scale, poseAt(offset, isTilted)};
        const ContactSurface::Placed body{own, frame.pose};
        ++cases;
        const ContactSurface written(frame(soup).points, soup.triangles);
        QCOMPARE(offTheFloor(written, frame, floor.breadth), QString());
        QCOMPARE(offTheFloor(ContactSurface(std::span(&body, 1)), frame, floor.breadth), QString());
      }
    }
  QVERIFY(cases >= 20);
}

// For any mesh, the hand is never pushed farther than it came from, and the force is no more than the device may give.
void ContactExtremesTest::anyMesh() {
  QFETCH(ExtremeMesh, extreme);
  const TriangleSoup soup = extreme.soup();
  for (const double friction : {0.0, 0.4}) {
    TouchedSurface touched;
    touched.surface = touchableSurface(soup.points, soup.triangles, {});
    touched.stiffness = kTouchStiffness;
    touched.contact.friction = friction;
    const ContactSurface& surface = touched.surface;
    WildTip wild(test::boxOf(soup), 7);
    SurfaceForce force("surface", touched);
    SafetyChain chain = chainOfDevice();
    Vec3 before = wild.start();
    int touching = 0;
    for (int i = 0; i < 2000; ++i) {
      TipState tip;
      tip.position = i == 0 ? before : wild.next();
      tip.isRestart = i == 0;
      ForceOut out;
      force.advance(tip, out);
      const Contact& contact = force.contact();
      QVERIFY(isSane(contact, tip.position));
      const double travel = (tip.position - before).norm();
      const Vec3 asked = force.force(tip, 1.0, 1.0);
      QVERIFY(asked.norm() <= kTouchStiffness * ((1.0 + 1e-9) * travel + kSkins * surface.skin()));
      before = contact.proxy;
      touching += contact.touching ? 1 : 0;
      SafetyInput input;
      input.asked.force = asked;
      input.position = tip.position;
      const Vec3 sent = chain.process(input).sent.force;
      QVERIFY(sent.allFinite() && sent.norm() <= kMostForce * (1.0 + 1e-12));
    }
    if (extreme.volume) QVERIFY(touching > 20);
  }
}

// In the tip, its velocity, the stiffness, the damping and the options: a proxy that is there, and a force that is.
void ContactExtremesTest::strangeNumbersSendNoStrangeForce() {
  const std::vector<double> strange = strangeNumbers();
  std::mt19937 random(8);
  const auto number = [&] { return random() % 3 ? strange[random() % strange.size()] : 0.1 * (random() % 30) - 1.0; };
  const auto vector = [&] {
    const double x = number(), y = number();
    return Vec3(x, y, number());
  };
  const TriangleSoup ball = bumpySphere(3);
  const ContactSurface surface(ball.points, ball.triangles);
  int touching = 0;
  for (int scene = 0; scene < 200; ++scene) {
    TouchedSurface touched;
    touched.surface = surface;
    touched.stiffness = scene % 2 ? kTouchStiffness : number();
    touched.damping = scene % 3 ? 0.001 : number();
    touched.contact.friction = scene % 5 ? 0.0 : number();
    touched.contact.tolerance = scene % 7 ? 1e-9 : number();
    SurfaceForce force("surface", touched, scene % 4 ? Vec3(Vec3::Zero()) : Vec3(Vec3::UnitZ()));
    SafetyChain chain = chainOfDevice();
    for (int i = 0; i < 60; ++i) {
      TipState tip;
      tip.position = i % 3 ? Vec3(0.02 * (i % 20), 0.1, 1.3 - 0.05 * (i % 12)) : vector();
      tip.velocity = i % 4 ? Vec3(Vec3::Zero()) : vector();
      tip.isRestart = i == 0 || scene % 11 == 0;
      ForceOut out;
      force.advance(tip, out);
      const bool isTipThere = tip.position.allFinite();
      if (isTipThere) QVERIFY(force.contact().proxy.allFinite());
      touching += force.contact().touching ? 1 : 0;
      SafetyInput input;
      input.asked.force = force.force(tip, 1.0, 1.0);
      input.position = tip.position;
      input.velocity = tip.velocity;
      input.isDeviceReady = isTipThere && tip.velocity.allFinite();
      const Vec3 sent = chain.process(input).sent.force;
      QVERIFY(sent.allFinite() && sent.norm() <= kMostForce * (1.0 + 1e-12));
    }
  }
  QVERIFY(touching > 1000);  // out of 12,000
}

// Corners that no formula expects, among some that are there.
void ContactExtremesTest::strangeCorners() {
  const std::vector<double> strange = strangeNumbers();
  std::mt19937 random(9);
  for (int scene = 0; scene < 300; ++scene) {
    TriangleSoup soup = floorIn(4, 4);
    for (int i = 0; i < 8; ++i) {
      Vec3& p = soup.points[random() % soup.points.size()];
      p[random() % 3] = strange[random() % strange.size()];
    }
    const ContactSurface surface(soup.points, soup.triangles);
    GodObject god;
    god.place({0, 0, 1});
    for (int tick = 0; tick < FloorPath::kTicks; ++tick) {
      const Vec3 tip = FloorPath::at(tick);
      const Contact& contact = god.follow(surface, tip, {});
      QVERIFY(contact.proxy.allFinite() && contact.normal.allFinite() && std::isfinite(contact.depth));
      QVERIFY(contactForce(contact, tip, Vec3(1, 2, 3), kTouchStiffness, 0.001).allFinite());
    }
  }
}

HANDWHEEL_TEST(ContactExtremesTest)
#include "ContactExtremesTest.moc"
