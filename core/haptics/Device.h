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

// The data sheet of a device. Lengths in mm, forces in N, torques in N·mm, times in s.
struct DeviceCapabilities {
  int inputs = 3;   // degrees of freedom measured: 3 position, 6 and orientation, 7 and a gripper
  int outputs = 3;  // driven: 0 none, 3 force, 6 and torque, 7 and a gripper
  int buttons = 0;
  double maxForce = 0.0;             // N, in any direction
  double maxTorque = 0.0;            // N·mm
  double maxGripperForce = 0.0;      // N
  double maxStiffness = 0.0;         // N/mm, as its maker states it
  double maxAngularStiffness = 0.0;  // N·mm/rad
  double maxDamping = 0.0;           // N·s/mm
  double workspaceRadius = 0.0;      // mm, around the origin of its frame
  double nominalRate = 1000.0;       // Hz, of the servo loop
  double inherentDamping = 0.0;      // N·s/mm: the b of eq. 2-1, friction of the mechanism that is always there
  // It measures a displacement from rest and springs back (a SpaceMouse): to be read as a velocity.
  bool isRateControl = false;
  // s, what driver, wire and motors add between a motion and the force that answers it. The loop's own is measured.
  double latency = 0.0;
};

enum class DeviceStatus : std::uint8_t {
  Absent,       // not plugged in, or unplugged
  Starting,     // loading firmware, connecting
  NeedsHoming,  // answers, but does not know where it is: no force may be sent
  Ready,
  Failed,  // answers wrongly, or not in time
};

// One reading, in the device's own frame: x right, y up, z towards the user.
struct DeviceState {
  Vec3 position = Vec3::Zero();  // mm
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Vec3 velocity = Vec3::Zero();  // mm/s; zero where the device gives none
  double gripper = 0.0;          // mm or rad, as the device has it
  std::uint32_t buttons = 0;     // bit n: button n is held
  DeviceStatus status = DeviceStatus::Absent;
  bool hasVelocity = false;  // else the servo loop estimates it from the positions
  // Counts what the device has said. The same as in the reading before: nothing new, and its force may soon be stale.
  // 0: not counted, for each reading is measured as it is asked for, or there are no motors and only changes are sent.
  std::uint32_t reading = 0;
};

struct DeviceForce {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // N·mm
  double gripper = 0.0;        // N

  bool isZero() const { return force.isZero(0.0) && torque.isZero(0.0) && gripper == 0.0; }
};

// A haptic device, or one that only points. A driver makes it, the servo loop owns it. open() and close() may take
// seconds and are called on a worker; read() and write() only on the servo thread between them, once each per tick:
// they allocate nothing, take no lock, and make no system call but those that talk to the device.
class Device {
 public:
  virtual ~Device() = default;

  // As its kind has them; exact once open, for those that can be asked.
  virtual DeviceCapabilities capabilities() const = 0;
  // Connects: loads firmware where it must, with retries. Error: why not, to be read by a person.
  virtual Status open(Progress progress) = 0;
  // Sends zero force first. May be called at any time after open(), twice, and after the device is gone.
  virtual void close() noexcept = 0;

  // The latest reading. Never waits longer than a tick; a device that is gone says so in the status.
  virtual DeviceState read() noexcept = 0;
  // Sent as it is: it has passed the safety chain.
  virtual void write(const DeviceForce& force) noexcept = 0;
};

// A device that could be opened.
struct DeviceListing {
  std::string driver;   // "spacemouse"
  std::string address;  // unique within the driver: a path, a port, a serial number
  std::string name;     // "SpaceMouse Compact"
};

// Finds and makes devices of one family. Built in, or from a plugin. One thread at a time.
class DeviceDriver {
 public:
  virtual ~DeviceDriver() = default;

  virtual std::string id() const = 0;
  // What is plugged in now. Called again and again for hot-plugging: cheap, and without effect on the devices.
  virtual std::vector<DeviceListing> find() = 0;
  // Null for an address that it does not know.
  virtual std::unique_ptr<Device> make(const std::string& address) = 0;
};

}  // namespace handwheel
