// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "spacemouse/HidSession.h"

#include <map>
#include <optional>

namespace handwheel::spacemouse {

// Functions of a HID library that the driver needs.
struct Hid {
  struct Entry {
    std::string path;
    std::string name;
    int buttons = 0;
  };
  std::function<std::vector<Entry>()> find;  // finds the devices with six axes
  std::function<Result<std::unique_ptr<HidTransport>>(const std::string& path)> open;
};

// Driver of SpaceMouse devices through spacenavd or HID reports. If the daemon spacenavd runs, the driver offers one
// device on its socket; otherwise it offers each device through its HID reports. It never uses the socket and the
// reports together, because the daemon reads the same devices and every movement would count twice.
class Driver final : public DeviceDriver {
 public:
  explicit Driver(Hid hid, std::vector<std::string> sockets = {"/run/spnav.sock", "/var/run/spnav.sock"})
      : m_hid(std::move(hid)), m_sockets(std::move(sockets)), m_clock(std::make_shared<SteadyClock>()) {}

  std::string id() const override { return "spacemouse"; }
  std::vector<DeviceInfo> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;

 private:
  std::optional<std::string> daemon();  // finds the socket of a running daemon
  bool answers(const std::string& path);

  // The result of the last attempt to connect to a socket file. It is kept because each attempt switches the lamp of
  // the device on and off.
  struct Asked {
    std::string identity;
    double at = 0.0;
    bool listening = false;
  };

  Hid m_hid;
  std::vector<std::string> m_sockets;
  std::shared_ptr<Clock> m_clock;
  std::map<std::string, Asked> m_asked;
};

}  // namespace handwheel::spacemouse
