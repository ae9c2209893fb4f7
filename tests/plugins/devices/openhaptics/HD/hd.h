// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The few functions of OpenHaptics that the bridge calls, declared for its test. This file contains nothing from the
// manufacturer, and the numerical values are Handwheel's own. HdStandIn.h simulates the device.

using HHD = unsigned int;
using HDenum = unsigned int;
using HDint = int;
using HDdouble = double;
using HDushort = unsigned short;
using HDSchedulerHandle = unsigned long;
using HDCallbackCode = unsigned int;
#define HDCALLBACK
using HDSchedulerCallback = HDCallbackCode (*)(void*);

struct HDErrorInfo {
  HDenum errorCode;
  int internalErrorCode;
  HHD hHD;
};
#define HD_DEVICE_ERROR(error) ((error).errorCode != 0)

inline constexpr const char* HD_DEFAULT_DEVICE = nullptr;
inline constexpr HHD HD_INVALID_HANDLE = ~0u;
inline constexpr HDushort HD_MAX_SCHEDULER_PRIORITY = 9;
inline constexpr HDCallbackCode HD_CALLBACK_CONTINUE = 1;

enum : HDenum {
  HD_FORCE_OUTPUT = 100,
  HD_CURRENT_POSITION,
  HD_CURRENT_VELOCITY,
  HD_CURRENT_TRANSFORM,
  HD_CURRENT_BUTTONS,
  HD_CURRENT_FORCE,
  HD_CURRENT_TORQUE,
  HD_NOMINAL_MAX_FORCE,
  HD_NOMINAL_MAX_STIFFNESS,
  HD_NOMINAL_MAX_DAMPING,
  HD_OUTPUT_DOF,
  HD_USABLE_WORKSPACE_DIMENSIONS,
  HD_CALIBRATION_STYLE,
  HD_CALIBRATION_OK,
  HD_CALIBRATION_NEEDS_UPDATE,
  HD_CALIBRATION_NEEDS_MANUAL_INPUT,
};

// The calibration styles. They are bits, because a device may support several styles.
enum : HDenum {
  HD_CALIBRATION_ENCODER_RESET = 1u << 0,
  HD_CALIBRATION_AUTO = 1u << 1,
  HD_CALIBRATION_INKWELL = 1u << 2,
};

HHD hdInitDevice(const char* name);
void hdDisableDevice(HHD device);
HDErrorInfo hdGetError();
const char* hdGetErrorString(HDenum code);
void hdEnable(HDenum what);
HDSchedulerHandle hdScheduleAsynchronous(HDSchedulerCallback callback, void* data, HDushort priority);
void hdUnschedule(HDSchedulerHandle callback);
void hdStartScheduler();
void hdStopScheduler();
void hdBeginFrame(HHD device);
void hdEndFrame(HHD device);
void hdGetDoublev(HDenum what, HDdouble* values);
void hdGetIntegerv(HDenum what, HDint* values);
void hdSetDoublev(HDenum what, const HDdouble* values);
HDenum hdCheckCalibration();
void hdUpdateCalibration(HDenum style);
