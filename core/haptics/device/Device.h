// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"
#include "base/Result.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace handwheel {

// Specifications of a haptic device. Lengths in mm, forces in N, torques in N·mm, times in s.
struct DeviceCapabilities {
  int inputs = 3;   // degrees of freedom measured: 3 position, 6 with orientation, 7 with a gripper
  int outputs = 3;  // degrees of freedom driven: 0 none, 3 force, 6 with torque, 7 with a gripper
  int buttons = 0;
  double maxForce = 0.0;             // N, in any direction
  double maxTorque = 0.0;            // N·mm
  double maxGripperForce = 0.0;      // N
  double maxStiffness = 0.0;         // N/mm, as its manufacturer states
  double maxAngularStiffness = 0.0;  // N·mm/rad
  double maxDamping = 0.0;           // N·s/mm
  double workspaceRadius = 0.0;      // mm, around the origin of its frame
  double nominalRate = 1000.0;       // Hz, of the servo loop
  double inherentDamping = 0.0;      // N·s/mm: the b of eq. 2-1, friction of the mechanism
  // It measures a displacement from rest and springs back (a SpaceMouse): to be interpreted as a velocity.
  bool isRateControl = false;
  // Delay between a motion and the force response in driver, cable and motors, s. The delay of the loop is measured.
  double latency = 0.0;
};

// Connection state of a device.
enum class DeviceStatus : std::uint8_t {
  Absent,       // not plugged in, or unplugged
  Starting,     // loading firmware, connecting
  NeedsHoming,  // answers, but does not know its position: no force may be sent
  Ready,
  Failed,  // answers wrongly, or not in time
};

// One reading of a device: pose, velocity, gripper, buttons and status. In the device's own frame: x right, y up, z
// towards the user.
struct DeviceState {
  Vec3 position = Vec3::Zero();  // mm
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Vec3 velocity = Vec3::Zero();  // mm/s; zero where the device gives none
  double gripper = 0.0;          // mm or rad, as the device has it
  std::uint32_t buttons = 0;     // bit n: button n is held
  DeviceStatus status = DeviceStatus::Absent;
  bool hasVelocity = false;  // false: the servo loop estimates it from the positions
  // Sequence number. The same as in the previous reading: the device has sent nothing new, and its force may soon be
  // stale. 0: not counted, because each reading is measured on request, or because there are no motors and only changes
  // are sent.
  std::uint32_t reading = 0;
};

// Force, torque and gripper force to send to a device.
struct DeviceForce {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // N·mm
  double gripper = 0.0;        // N

  bool isZero() const { return force.isZero(0.0) && torque.isZero(0.0) && gripper == 0.0; }
};

// Interface of a haptic device, or of one without motors. A driver creates it, the servo loop owns it. open() and
// close() may take seconds and are called on a worker thread; read() and write() only on the servo thread between them,
// once each per tick: they allocate nothing, take no lock, and make no system call but those that talk to the device.
class Device {
 public:
  virtual ~Device() = default;

  // Returns the specifications of its type; exact once open, for devices that can be queried.
  virtual DeviceCapabilities capabilities() const = 0;
  // Connects; loads firmware if necessary, with retries. Error: the reason, to be read by a person.
  virtual Status open(Progress progress) = 0;
  // Sends zero force first. May be called at any time after open(), twice, and after the device is gone.
  virtual void close() noexcept = 0;

  // Returns the latest reading. Never waits longer than a tick; the status shows whether the device is gone.
  virtual DeviceState read() noexcept = 0;
  // Sends the force unchanged: it has passed the safety chain.
  virtual void write(const DeviceForce& force) noexcept = 0;
};

// An entry in the list of devices that can be opened.
struct DeviceInfo {
  std::string driver;   // "spacemouse"
  std::string address;  // unique within the driver: a path, a port, a serial number
  std::string name;     // "SpaceMouse Compact"
};

// Finds devices of one family and creates objects for them. Built in, or from a plugin. One thread at a time.
class DeviceDriver {
 public:
  virtual ~DeviceDriver() = default;

  virtual std::string id() const = 0;
  // Returns the devices connected now. Polled for hot-plugging: cheap, and without effect on the devices.
  virtual std::vector<DeviceInfo> find() = 0;
  // Creates the device at an address; null if the address is unknown.
  virtual std::unique_ptr<Device> make(const std::string& address) = 0;
};

}  // namespace handwheel
