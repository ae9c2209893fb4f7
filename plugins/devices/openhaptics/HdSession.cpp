// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "openhaptics/HdSession.h"

#include "haptics/device/DeviceErrors.h"
#include "openhaptics/Driver.h"

#include <algorithm>
#include <cmath>

namespace handwheel::openhaptics {

namespace {

constexpr double kForceLife = 0.04;  // s after the request; then the callback itself sends none
constexpr double kLook = 0.0002;     // s between looks for a tick
constexpr double kTickTime = 0.01;   // s that a tick may take
constexpr double kSilence = 0.1;     // s without a tick until the device counts as failed
constexpr int kFarewells = 3;        // ticks with zero force on leaving

double number(HDenum what) {
  HDdouble value = 0.0;
  hdGetDoublev(what, &value);
  return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

// Returns the calibration style to use. A device reports its styles as bits; a calibration is of one. The manufacturer
// advises: first the automatic one, then the inkwell, then the reset of the encoders.
HDenum calibrationStyle() {
  HDint known = 0;
  hdGetIntegerv(HD_CALIBRATION_STYLE, &known);
  for (const HDenum style : {HD_CALIBRATION_AUTO, HD_CALIBRATION_INKWELL, HD_CALIBRATION_ENCODER_RESET}) {
    if (known & static_cast<HDint>(style)) return style;
  }
  return HD_CALIBRATION_AUTO;
}

// The matrix is stored column by column.
Eigen::Quaterniond orientationOf(const HDdouble* transform) {
  Eigen::Matrix3d turn;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) turn(row, column) = transform[4 * column + row];
  }
  const bool isTurn = turn.allFinite() && std::abs(turn.determinant() - 1.0) < 1e-3;
  return isTurn ? Eigen::Quaterniond(turn).normalized() : Eigen::Quaterniond::Identity();
}

}  // namespace

Status HdSession::open(Progress progress) {
  close();
  m_device = hdInitDevice(m_name == kDefaultDevice ? HD_DEFAULT_DEVICE : m_name.c_str());
  if (const HDErrorInfo error = hdGetError(); HD_DEVICE_ERROR(error)) {
    m_device = HD_INVALID_HANDLE;
    return refusal(error);
  }
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  askCapabilities();
  m_forces.write({});
  m_last = {};
  m_last.status = DeviceStatus::Starting;
  m_states.write(m_last);
  hdEnable(HD_FORCE_OUTPUT);
  m_callback = hdScheduleAsynchronous(&HdSession::tick, this, HD_MAX_SCHEDULER_PRIORITY);
  hdStartScheduler();
  if (const HDErrorInfo error = hdGetError(); HD_DEVICE_ERROR(error)) {
    close();
    return refusal(error);
  }
  m_lastTick = m_clock->now();
  return Done{};
}

Error HdSession::refusal(const HDErrorInfo& error) const {
  const char* const reason = hdGetErrorString(error.errorCode);
  return {DeviceError::Unreachable, {reason ? reason : ""}, {}, "OpenHaptics"};
}

// Values that the device does not state are those of a Touch.
void HdSession::askCapabilities() {
  DeviceCapabilities all = touchCapabilities();
  const auto take = [](double& value, double said) { value = said > 0.0 ? said : value; };
  take(all.maxForce, number(HD_NOMINAL_MAX_FORCE));
  take(all.maxStiffness, number(HD_NOMINAL_MAX_STIFFNESS));
  take(all.maxDamping, number(HD_NOMINAL_MAX_DAMPING));
  HDint outputs = 3;
  hdGetIntegerv(HD_OUTPUT_DOF, &outputs);
  all.outputs = outputs >= 6 ? 6 : 3;
  m_calibrationStyle = calibrationStyle();
  HDdouble box[6] = {};  // the least corner, then the largest
  hdGetDoublev(HD_USABLE_WORKSPACE_DIMENSIONS, box);
  const Vec3 least(box[0], box[1], box[2]), most(box[3], box[4], box[5]);
  const double reach = 0.5 * (most - least).minCoeff();
  const bool isBox = least.allFinite() && most.allFinite() && reach > 1.0 && reach < 1e3;
  if (isBox) all.workspaceRadius = reach;
  m_centre = isBox ? Vec3(0.5 * (least + most)) : Vec3(Vec3::Zero());
  all.inherentDamping = touchDamping(all.maxStiffness, all.nominalRate);
  m_capabilities = all;
}

HDCallbackCode HDCALLBACK HdSession::tick(void* session) noexcept {
  static_cast<HdSession*>(session)->serve();
  return HD_CALLBACK_CONTINUE;
}

// Runs on the manufacturer's thread.
void HdSession::serve() noexcept {
  hdBeginFrame(m_device);
  DeviceState state = read();
  const TimedForce& asked = m_forces.read();
  const bool isWanted = state.status == DeviceStatus::Ready && m_clock->now() - asked.time <= kForceLife;
  write(isWanted ? asked.force : DeviceForce());
  hdEndFrame(m_device);
  if (const HDErrorInfo error = hdGetError(); HD_DEVICE_ERROR(error)) state.status = DeviceStatus::Failed;
  m_states.write(state);
  m_ticks.fetch_add(1, std::memory_order_release);
}

DeviceState HdSession::read() noexcept {
  DeviceState state;
  HDdouble position[3] = {}, velocity[3] = {}, transform[16] = {};
  HDint buttons = 0;
  hdGetDoublev(HD_CURRENT_POSITION, position);
  hdGetDoublev(HD_CURRENT_VELOCITY, velocity);
  hdGetDoublev(HD_CURRENT_TRANSFORM, transform);
  hdGetIntegerv(HD_CURRENT_BUTTONS, &buttons);
  state.position = Vec3(position[0], position[1], position[2]) - m_centre;
  state.velocity = Vec3(velocity[0], velocity[1], velocity[2]);
  state.hasVelocity = true;
  state.orientation = orientationOf(transform);
  state.buttons = static_cast<std::uint32_t>(buttons);
  const auto calibration = hdCheckCalibration();
  state.status = calibration == HD_CALIBRATION_OK ? DeviceStatus::Ready : DeviceStatus::NeedsHoming;
  m_canCalibrate = calibration == HD_CALIBRATION_NEEDS_UPDATE;
  if (state.position.allFinite() && state.velocity.allFinite()) return state;
  DeviceState failed;
  failed.status = DeviceStatus::Failed;
  return failed;
}

void HdSession::write(const DeviceForce& force) noexcept {
  const HDdouble newtons[3] = {force.force.x(), force.force.y(), force.force.z()};
  hdSetDoublev(HD_CURRENT_FORCE, newtons);
  if (m_capabilities.outputs < 6) return;
  const HDdouble torque[3] = {force.torque.x(), force.torque.y(), force.torque.z()};
  hdSetDoublev(HD_CURRENT_TORQUE, torque);
}

DeviceState HdSession::exchange(const DeviceForce& force) noexcept {
  if (m_device == HD_INVALID_HANDLE) return {};
  const std::uint32_t before = m_ticks.load(std::memory_order_acquire);
  m_forces.write({force, m_clock->now()});
  if (m_canCalibrate.exchange(false)) hdUpdateCalibration(m_calibrationStyle);
  if (waitForTick(before)) {
    m_lastTick = m_clock->now();
    const std::uint32_t number = m_last.reading + 1;
    m_last = m_states.read();
    m_last.reading = number;
  } else if (m_clock->now() - m_lastTick > kSilence) {
    m_last.status = DeviceStatus::Failed;
  }
  return m_last;
}

bool HdSession::waitForTick(std::uint32_t before) noexcept {
  const double end = m_clock->now() + kTickTime;
  while (m_ticks.load(std::memory_order_acquire) == before) {
    if (m_clock->now() > end) return false;
    m_clock->sleep(kLook);
  }
  return true;
}

void HdSession::close() noexcept {
  if (m_device == HD_INVALID_HANDLE) return;
  for (int i = 0; m_callback != 0 && i < kFarewells; ++i) (void)exchange({});
  hdStopScheduler();
  if (m_callback != 0) hdUnschedule(m_callback);
  m_callback = 0;
  hdDisableDevice(m_device);
  m_device = HD_INVALID_HANDLE;
}

}  // namespace handwheel::openhaptics
