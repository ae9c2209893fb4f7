// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/Cases.h"
#include "machining/TurningFidelity.h"
#include "machining/lathe/LatheJson.h"
#include "simulation/turning/LatheSimulation.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

using Do = LatheCommand::Kind;

constexpr StockCylinder kSteppedBar{44.0, 100.0, 0.0};
constexpr double kRest = 2.0;        // s, in which the spindle reaches its speed and the tool its position
constexpr double kSpindle = 1500.0;  // r/min
constexpr double kStiff = 1e15;      // N/mm²: what the law presses on does not bend
constexpr const char* kTool = "right-finishing";

// A lathe without limits of power and torque, whose work is stiff: what it makes is known in closed form. Its commands
// take effect with the next step.
class SteppedLathe {
 public:
  explicit SteppedLathe(double dt) : m_dt(dt) {}

  void send(Do kind, double value, double other = 0.0) {
    m_channel->commands.push({kind, LatheAxis::Carriage, value, other});
  }
  // Until this time of the machine has come: with the first step that begins then or later.
  void runUntil(double time) {
    while (static_cast<double>(m_steps) * m_dt < time) step();
  }
  void step() {
    m_simulation.step(m_dt, {});
    ++m_steps;
  }
  // Starts the spindle, moves the tip to a position, and waits. Returns the time.
  double begin(const ProfilePoint& tip) {
    send(Do::Speed, kSpindle);
    send(Do::Spindle, 1.0);
    send(Do::MoveTip, tip.x(), tip.y());
    runUntil(kRest);
    return static_cast<double>(m_steps) * m_dt;
  }
  const TurnedProfile& profile() const { return m_simulation.run().profile(); }
  double nose() const { return m_tool->noseRadius; }
  ProfilePoint centre() const { return m_tool->noseCentre(); }

 private:
  LatheRun run() const {
    LatheSetup setup = defaultLatheSetup(kSteppedBar);
    setup.spindle.power = setup.spindle.torque = 0.0;
    setup.stations.assign(1, {kTool});
    LatheMaterial material = latheMaterial(WorkMaterials::standard().called({}), ForceLaw::Kienzle, m_tools);
    material.modulus = kStiff;
    return {setup, m_tools, m_bar, LatheMachine::initialState(setup, kSteppedBar),
            std::make_shared<const LatheMaterial>(std::move(material))};
  }

  double m_dt;  // s
  LatheTools m_tools = shippedLatheTools();
  std::shared_ptr<const LatheTool> m_tool = toolNamed(m_tools, kTool);
  TurnedProfile m_bar{kSteppedBar, turnSpacingSetting().standard};
  std::shared_ptr<LatheChannel> m_channel = std::make_shared<LatheChannel>();
  LatheSimulation m_simulation{run(), TurnedSurface(m_bar, 0.02), 0.0, m_channel, SurfaceFinish(m_bar.size())};
  std::uint64_t m_steps = 0;
};

// The largest distance of the samples between two heights from a circle of the profile.
double distanceFromArc(const TurnedProfile& profile, const ProfilePoint& centre, double radius, double from,
                       double to) {
  double largest = 0.0;
  const TurnedProfile::Range within = samplesWithin(profile, from, to);
  for (std::size_t i = within.first; i < within.last; ++i)
    largest = std::max(largest, std::abs((ProfilePoint(profile.radius(i), profile.z(i)) - centre).norm() - radius));
  return largest;
}

// The feed cuts to a shoulder, and the lever is thrown out at moments that are no multiples of a step. The shoulder has
// the fillet of the nose; where the nose must have come to rest says where it is.
FidelitySample shouldersByTheLever(double dt) {
  constexpr double kFeed = 0.1, kDepth = 0.3, kMoments[] = {2.00417, 2.10123, 2.20311, 2.30739};
  FidelitySample sample;
  double cutting = 0.0;  // s
  for (const double moment : kMoments) {
    SteppedLathe lathe(dt);
    const ProfilePoint tip(0.5 * kSteppedBar.diameter - kDepth, kSteppedBar.length + 1.0);
    const double begun = lathe.begin(tip);
    lathe.send(Do::Feed, -kFeed);
    sample.cost += cpuMilliseconds([&] { lathe.runUntil(begun + moment); });
    lathe.send(Do::Feed, 0.0);
    lathe.runUntil(begun + moment + 0.1);
    const ProfilePoint at = tip + lathe.centre() - ProfilePoint(0.0, kFeed * kSpindle / 60.0 * moment);
    // Its fillet ends where the bar begins, at 60 degrees and more from the radius.
    const double reach = 0.5 * lathe.nose();
    sample.error = std::max(sample.error, distanceFromArc(lathe.profile(), at, lathe.nose(), at.y() - reach, at.y()));
    cutting += moment;
  }
  sample.cost /= cutting;
  return sample;
}

// A hand leads the nose around a ball at an even speed, both slides at once. It is where it is as each step begins.
FidelitySample ballByHand(double dt) {
  constexpr double kBall = 20.0, kHand = 10.0, kFirst = 0.6;  // mm, mm/s, rad from the axis
  const ProfilePoint centre(0.0, 85.0);
  SteppedLathe lathe(dt);
  const double around = kBall + lathe.nose();
  const auto tipAt = [&](double angle) {
    return ProfilePoint(centre + around * ProfilePoint(std::sin(angle), std::cos(angle)) - lathe.centre());
  };
  lathe.begin(tipAt(kFirst));
  const double distance = around * (0.5 * M_PI - kFirst);
  FidelitySample sample;
  const double all = cpuMilliseconds([&] {
    for (double gone = 0.0; gone < distance;) {
      gone = std::min(distance, gone + kHand * dt);
      const ProfilePoint tip = tipAt(kFirst + gone / around);
      lathe.send(Do::MoveTip, tip.x(), tip.y());
      lathe.step();
    }
  });
  sample.cost = all / (distance / kHand);
  sample.error = distanceFromArc(lathe.profile(), centre, kBall, centre.y(), kSteppedBar.length - lathe.nose());
  return sample;
}

FidelityCase caseOf(const std::string& name, FidelitySample (*measured)(double dt)) {
  return {name, "closed form", [measured](double value, std::uint64_t, Progress) { return measured(1e-3 * value); }};
}

}  // namespace

std::vector<FidelityCase> turnIncrementCases() {
  return {caseOf("shoulders by the feed, thrown out by its lever", shouldersByTheLever),
          caseOf("a ball of radius 20 mm by hand", ballByHand)};
}

}  // namespace handwheel
