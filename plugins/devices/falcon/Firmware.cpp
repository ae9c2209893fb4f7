// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/Firmware.h"

#include <cstdlib>
#include <fstream>

namespace handwheel::falcon {

namespace {

constexpr std::size_t kLargest = 1 << 20;  // bytes; the known ones have about 8,000

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

std::string firmwarePath() {
  if (std::string path = variable("HANDWHEEL_FALCON_FIRMWARE"); !path.empty()) return path;
  std::string folder = variable("XDG_DATA_HOME");
  if (folder.empty()) folder = variable("HOME") + "/.local/share";
  return folder + "/handwheel/falcon.bin";
}

Result<Firmware> readFirmware() {
  const std::string path = firmwarePath();
  std::ifstream stream(path, std::ios::binary);
  Firmware bytes(kLargest);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (bytes.empty()) {
    const std::string name = path.substr(path.rfind('/') + 1);
    return Error{ErrorCode::ReferenceMissing, {"the firmware file", name}, {}, path};
  }
  return bytes;
}

}  // namespace handwheel::falcon
