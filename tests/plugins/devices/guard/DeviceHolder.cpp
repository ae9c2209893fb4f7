// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "polhem/Driver.h"

#include <chrono>
#include <cstdio>
#include <thread>

// A program in the middle of a wall: holds the Polhem at the line given with 1 N, each millisecond, until it is killed.
int main(int argc, char** argv) {
  using namespace handwheel;
  polhem::Driver driver("/nowhere");
  const std::unique_ptr<Device> device = argc == 2 ? driver.make(argv[1]) : nullptr;
  if (!device || !device->open({})) {
    std::fprintf(stderr, "the device cannot be opened\n");
    return 1;
  }
  for (;;) {
    (void)device->read();
    device->write({Vec3(0.0, 0.0, 1.0), Vec3::Zero(), 0.0});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}
