// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../WindowDriver.h"
#include "spacemouse/Driver.h"
#include "spacemouse/SpaceMouseEmulator.h"
#include "window/haptics/HapticSession.h"
#include "window/haptics/SpaceMouseNavigation.h"

#include <array>

namespace handwheel::test {

// A hand on the cap of an emulated SpaceMouse Compact. Like the real device, it sends reports every 16 ms.
struct CapFixture {
  std::shared_ptr<SpaceMouseEmulator> mouse = std::make_shared<SpaceMouseEmulator>();
  std::shared_ptr<std::atomic<bool>> isPlugged = std::make_shared<std::atomic<bool>>(true);
  QTemporaryDir dev;
  WindowDriver driver{builtInKinds(), drivers()};
  HapticSession& session = *driver.window().findChild<HapticSession*>();
  SpaceMouseNavigation& device = *driver.window().findChild<SpaceMouseNavigation*>();
  Viewport& view = *driver.find<Viewport>("viewport");
  QTimer reports;
  std::array<int, 3> translation{}, rotation{};

  CapFixture() {
    reports.setInterval(16);
    QObject::connect(&reports, &QTimer::timeout, &view, [this] { report(); });
    reports.start();
  }
  ~CapFixture() { session.close(); }

  MainWindow::Drivers drivers() {
    const auto clock = std::make_shared<FakeClock>(FakeClock::Pace::Real);
    spacemouse::Hid hid;
    hid.find = [plugged = isPlugged] {
      return *plugged ? std::vector<spacemouse::Hid::Entry>{{"/dev/hidraw0", "SpaceMouse Compact", 2}}
                      : std::vector<spacemouse::Hid::Entry>();
    };
    hid.open = [device = mouse, clock](const std::string&) -> Result<std::unique_ptr<HidTransport>> {
      return std::unique_ptr<HidTransport>(std::make_unique<FakeHid>(device, clock));
    };
    MainWindow::Drivers all;
    all.push_back(std::make_unique<spacemouse::Driver>(hid, std::vector<std::string>()));
    return all;
  }
  void plug(bool isIn) {
    {
      const std::lock_guard lock(mouse->mutex);
      mouse->gone = !isIn;
    }
    *isPlugged = isIn;
    QFile node(dev.filePath("hidraw0"));
    isIn ? void(node.open(QIODevice::WriteOnly)) : void(node.remove());
  }
  // Sends the two reports of the cap. Report 1 is the translation (x right, y towards the user, z down), report 2 the
  // rotation about the same axes; the values are little-endian.
  void report() {
    const std::lock_guard lock(mouse->mutex);
    if (mouse->reports.size() > 4) return;
    for (const auto& [id, axes] : {std::pair(1, translation), std::pair(2, rotation)}) {
      Report bytes{static_cast<std::uint8_t>(id)};
      for (const int value : axes) {
        bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
        bytes.push_back(static_cast<std::uint8_t>(value >> 8 & 0xff));
      }
      mouse->reports.push_back(bytes);
    }
  }
  bool begin(const QString& file) {
    return begin([&] { return driver.open(file); });
  }
  // Plugs the device in and opens a document. open: the function that opens the document.
  template <class Open>
  bool begin(Open open) {
    plug(true);
    driver.window().activateWindow();
    if (!QTest::qWaitForWindowActive(&driver.window()) || !open()) return false;
    device.watch({dev.path()});
    return waitForNavigation(true);
  }
  bool waitForNavigation(bool isThere) {
    return QTest::qWaitFor([&] { return device.names().empty() != isThere; }, kPatienceMs);
  }
  bool hasReports() {
    const std::lock_guard lock(mouse->mutex);
    return !mouse->reports.empty();
  }
  // Releases the cap and waits until the device has read this and the view is at rest.
  CameraState rest() {
    translation = rotation = {};
    {
      const std::lock_guard lock(mouse->mutex);
      mouse->reports.clear();
    }
    reports.stop();
    report();
    (void)QTest::qWaitFor([&] { return !hasReports(); }, kPatienceMs);
    QTest::qWait(100);
    reports.start();
    CameraState last = view.camera();
    (void)QTest::qWaitFor([&] { return last == std::exchange(last, (QTest::qWait(100), view.camera())); }, kPatienceMs);
    return view.camera();
  }
};

}  // namespace handwheel::test
