// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HdStandIn.h"

#include <HD/hd.h>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

namespace handwheel {

namespace {

std::thread servo;
std::atomic<bool> isStopping{false};
HDSchedulerCallback callback = nullptr;
void* callbackData = nullptr;
std::atomic<HDenum> pending{0};

void put(HDdouble* values, const Vec3& v) {
  std::copy(v.begin(), v.end(), values);
}

void runServo() {
  while (!isStopping) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    bool isStalled = false;
    {
      const std::lock_guard lock(HdStandIn::only().mutex);
      isStalled = HdStandIn::only().isStalled;
    }
    if (!isStalled && callback) callback(callbackData);
  }
}

}  // namespace

HdStandIn& HdStandIn::only() {
  static HdStandIn device;
  return device;
}

void HdStandIn::reset() {
  const std::lock_guard lock(mutex);
  isPlugged = true;
  needsInkwell = isInInkwell = saysNonsense = isStalled = isForceOn = isRunning = false;
  buttons = frames = 0;
  calibrationStyles = HD_CALIBRATION_INKWELL;
  askedStyle = 0;
  force.reset();
  name.clear();
}

}  // namespace handwheel

using namespace handwheel;

HHD hdInitDevice(const char* name) {
  const std::lock_guard lock(HdStandIn::only().mutex);
  HdStandIn::only().name = name ? name : "";
  if (!HdStandIn::only().isPlugged) pending = 1;
  return HdStandIn::only().isPlugged ? 7 : HD_INVALID_HANDLE;
}

void hdDisableDevice(HHD) {}

HDErrorInfo hdGetError() {
  return {pending.exchange(0), 0, 0};
}

const char* hdGetErrorString(HDenum) {
  return "no device";
}

void hdEnable(HDenum what) {
  const std::lock_guard lock(HdStandIn::only().mutex);
  if (what == HD_FORCE_OUTPUT) HdStandIn::only().isForceOn = true;
}

HDSchedulerHandle hdScheduleAsynchronous(HDSchedulerCallback call, void* data, HDushort) {
  callback = call;
  callbackData = data;
  return 1;
}

void hdUnschedule(HDSchedulerHandle) {
  callback = nullptr;
}

void hdStartScheduler() {
  isStopping = false;
  servo = std::thread(runServo);
  const std::lock_guard lock(HdStandIn::only().mutex);
  HdStandIn::only().isRunning = true;
}

void hdStopScheduler() {
  isStopping = true;
  if (servo.joinable()) servo.join();
  const std::lock_guard lock(HdStandIn::only().mutex);
  HdStandIn::only().isRunning = false;
}

void hdBeginFrame(HHD) {
  HdStandIn::only().mutex.lock();
}

void hdEndFrame(HHD) {
  ++HdStandIn::only().frames;
  if (!HdStandIn::only().isPlugged) pending = 1;
  HdStandIn::only().mutex.unlock();
}

// To be called within a frame, except for constant values.
void hdGetDoublev(HDenum what, HDdouble* values) {
  const HdStandIn& device = HdStandIn::only();
  if (what == HD_CURRENT_POSITION) put(values, device.position);
  if (what == HD_CURRENT_VELOCITY) put(values, Vec3(1.0, 2.0, 3.0));
  if (what == HD_CURRENT_TRANSFORM) {  // turned by a quarter about z
    put(values, Vec3(0, 1, 0));
    put(values + 4, Vec3(-1, 0, 0));
    put(values + 8, Vec3(0, 0, 1));
    put(values + 12, device.position);
  }
  if (what == HD_NOMINAL_MAX_FORCE) *values = 3.3;
  if (what == HD_NOMINAL_MAX_STIFFNESS) *values = 0.5;
  if (what == HD_NOMINAL_MAX_DAMPING) *values = 0.003;
  if (what == HD_USABLE_WORKSPACE_DIMENSIONS) {
    put(values, device.least);
    put(values + 3, device.most);
  }
  if (device.saysNonsense && what < HD_NOMINAL_MAX_FORCE) *values = std::numeric_limits<double>::quiet_NaN();
}

void hdGetIntegerv(HDenum what, HDint* values) {
  if (what == HD_CURRENT_BUTTONS) *values = HdStandIn::only().buttons;
  if (what == HD_OUTPUT_DOF) *values = 3;
  if (what == HD_CALIBRATION_STYLE) *values = HdStandIn::only().calibrationStyles;
}

void hdSetDoublev(HDenum what, const HDdouble* values) {
  if (what == HD_CURRENT_FORCE) HdStandIn::only().force = Vec3(values[0], values[1], values[2]);
}

HDenum hdCheckCalibration() {
  const HdStandIn& device = HdStandIn::only();
  if (!device.needsInkwell) return HD_CALIBRATION_OK;
  return device.isInInkwell ? HD_CALIBRATION_NEEDS_UPDATE : HD_CALIBRATION_NEEDS_MANUAL_INPUT;
}

void hdUpdateCalibration(HDenum style) {
  const std::lock_guard lock(HdStandIn::only().mutex);
  HdStandIn::only().askedStyle = style;
  if (style == HD_CALIBRATION_INKWELL && HdStandIn::only().isInInkwell) HdStandIn::only().needsInkwell = false;
}
