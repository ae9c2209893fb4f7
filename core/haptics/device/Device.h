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

// Specifications of a haptic device. Lengths are in mm, forces in N, torques in N·mm, and times in s.
struct DeviceCapabilities {
  int inputs = 3;   // measured degrees of freedom: 3 position, 6 with orientation, 7 with a gripper
  int outputs = 3;  // driven degrees of freedom: 0 none, 3 force, 6 with torque, 7 with a gripper
  int buttons = 0;
  double maxForce = 0.0;             // N, in any direction
  double maxTorque = 0.0;            // N·mm
  double maxGripperForce = 0.0;      // N
  double maxStiffness = 0.0;         // N/mm, as the manufacturer states
  double maxAngularStiffness = 0.0;  // N·mm/rad
  double maxDamping = 0.0;           // N·s/mm
  double workspaceRadius = 0.0;      // mm, around the origin of the device's frame
  double nominalRate = 1000.0;       // Hz, rate of the servo loop
  double inherentDamping = 0.0;      // N·s/mm: b of He 2008, eq. 2-1, the friction of the mechanism
  // True if the device measures a displacement from rest and springs back, like a SpaceMouse. The displacement must be
  // interpreted as a velocity.
  bool isRateControl = false;
  // Delay between a motion and the force response in driver, cable and motors, s. The delay of the loop is measured
  // separately.
  double latency = 0.0;
};

// Connection state of a device.
enum class DeviceStatus : std::uint8_t {
  Absent,       // not plugged in, or unplugged
  Starting,     // loading firmware, connecting
  NeedsHoming,  // the device answers, but does not know its position: no force may be sent
  Ready,
  Failed,  // the device answers incorrectly, or too late
};

// One reading of a device: pose, velocity, gripper, buttons and status. Vectors are in the frame of the device: x
// right, y up, z towards the user.
struct DeviceState {
  Vec3 position = Vec3::Zero();  // mm
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Vec3 velocity = Vec3::Zero();  // mm/s; zero if the device does not report it
  double gripper = 0.0;          // mm or rad, depending on the device
  std::uint32_t buttons = 0;     // bit n: button n is held
  DeviceStatus status = DeviceStatus::Absent;
  bool hasVelocity = false;  // false: the servo loop estimates the velocity from the positions
  // Sequence number. If it is the same as in the previous reading, the device has sent nothing new, and its force may
  // soon be outdated. 0: readings are not counted, because each is measured on request, or because the device has no
  // motors and sends only changes.
  std::uint32_t reading = 0;
};

// Force, torque and gripper force to send to a device.
struct DeviceForce {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // N·mm
  double gripper = 0.0;        // N

  bool isZero() const { return force.isZero(0.0) && torque.isZero(0.0) && gripper == 0.0; }
};

// Interface of a haptic device, or of a device without motors. A driver creates the device, and the servo loop owns it.
// open() and close() may take seconds, and are called on a worker thread. read() and write() are called only between
// them and only on the servo thread, once each per tick. They must not allocate, take a lock, or make system calls
// other than those that communicate with the device.
class Device {
 public:
  virtual ~Device() = default;

  // Returns the specifications of the device's type. If the device can be queried, they are exact once it is open.
  virtual DeviceCapabilities capabilities() const = 0;
  // Connects to the device, and loads firmware if necessary, with retries. Error: the reason, in words for the user.
  virtual Status open(Progress progress) = 0;
  // Sends zero force and closes the device. May be called at any time after open(), twice, and after the device is
  // gone.
  virtual void close() noexcept = 0;

  // Returns the latest reading. Never waits longer than a tick. The status shows whether the device is gone.
  virtual DeviceState read() noexcept = 0;
  // Sends the force unchanged. The force must have passed the safety chain.
  virtual void write(const DeviceForce& force) noexcept = 0;
};

// An entry in the list of devices that can be opened.
struct DeviceInfo {
  std::string driver;   // "spacemouse"
  std::string address;  // unique within the driver: a path, a port, a serial number
  std::string name;     // "SpaceMouse Compact"
};

// Finds devices of one family and creates objects for them. A driver is built in, or is loaded from a plugin. It must
// be used by one thread at a time.
class DeviceDriver {
 public:
  virtual ~DeviceDriver() = default;

  virtual std::string id() const = 0;
  // Returns the devices that are connected now. It is polled for hot-plugging, so it must be cheap and must not affect
  // the devices.
  virtual std::vector<DeviceInfo> find() = 0;
  // Creates the device at an address. Returns null if the address is unknown.
  virtual std::unique_ptr<Device> make(const std::string& address) = 0;
};

}  // namespace handwheel
