// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/HidapiTransport.h"

#include <cstdio>

using namespace handwheel;
using namespace handwheel::spacemouse;

// Prints the devices that hidapi finds, and the readings of the first until a button is pressed: a line for each
// change.
int main() {
  const Hid hid = hidapi();
  const std::vector<Hid::Entry> entries = hid.find();
  for (const Hid::Entry& entry : entries)
    std::printf("%s, %s, %d\n", entry.path.c_str(), entry.name.c_str(), entry.buttons);
  if (entries.empty()) return 1;
  const auto clock = std::make_shared<SteadyClock>();
  HidSession session([&] { return hid.open(entries[0].path); }, clock, entries[0].buttons);
  if (!session.open({})) return 2;
  const double end = clock->now() + 10.0;
  DeviceState state;
  while (state.buttons == 0 && clock->now() < end) {
    const DeviceState next = session.exchange({});
    if (next.status != DeviceStatus::Ready) break;
    const Eigen::AngleAxisd turn(next.orientation);
    const Vec3 turned = turn.angle() * turn.axis() + Vec3::Zero();  // adding makes a negative zero positive
    const Vec3 position = next.position + Vec3::Zero();
    if (next.position != state.position || next.buttons != state.buttons ||
        !next.orientation.isApprox(state.orientation)) {
      std::printf("%.4f %.4f %.4f, %.4f %.4f %.4f, %u\n", position.x(), position.y(), position.z(), turned.x(),
                  turned.y(), turned.z(), next.buttons);
    }
    state = next;
  }
  session.close();
}
