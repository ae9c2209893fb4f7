// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <optional>
#include <string>
#include <string_view>

namespace handwheel::haply {

// State of the first Inverse3 and the first VerseGrip. From one state frame of the service; in the frame of Device.h,
// mm.
struct Frame {
  std::string deviceId;  // never empty
  std::optional<Vec3> position;
  std::optional<Vec3> velocity;
  std::optional<Eigen::Quaterniond> orientation;  // orientation of the VerseGrip
  std::uint32_t buttons = 0;
  bool isCalibrated = true;
};

// Parses a state frame of the service. Field names of versions 3.0 to 3.5; unknown ones are skipped. Nothing when the
// text is not JSON or has no Inverse3.
std::optional<Frame> readFrame(std::string_view text);

// Returns the first message of a client: it names itself and asks for the inventory.
std::string clientHello();
// Returns the message that moves the arm's origin to the middle of its workspace. Sent once.
std::string centringCommand(const std::string& deviceId);
// Returns the message for a force. In the frame of Device.h, N; it holds until the next message.
std::string forceCommand(const std::string& deviceId, const Vec3& force);

}  // namespace handwheel::haply
