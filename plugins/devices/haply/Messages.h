// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <optional>
#include <string>
#include <string_view>

namespace handwheel::haply {

// State of the first Inverse3 and VerseGrip in a state frame. Vectors are in the frame of Device.h, lengths in mm.
struct Frame {
  std::string deviceId;  // never empty
  std::optional<Vec3> position;
  std::optional<Vec3> velocity;
  std::optional<Eigen::Quaterniond> orientation;  // orientation of the VerseGrip
  std::uint32_t buttons = 0;
  bool isCalibrated = true;
};

// Parses a state frame of the service. The field names of versions 3.0 to 3.5 are known; unknown fields are skipped.
// Returns nothing if the text is not JSON or contains no Inverse3.
std::optional<Frame> readFrame(std::string_view text);

// Returns the first message of a client, in which the client names itself and asks for the inventory.
std::string clientHello();
// Returns the message that moves the arm's origin to the middle of its workspace. It must be sent once.
std::string centringCommand(const std::string& deviceId);
// Returns the message for a force. force: N, in the frame of Device.h. The force acts until the next message.
std::string forceCommand(const std::string& deviceId, const Vec3& force);

}  // namespace handwheel::haply
