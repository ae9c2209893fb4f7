// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/LibusbTransport.h"
#include "falcon/Packet.h"

#include <cstdio>

using namespace handwheel;

// Prints the Falcons that libusb finds, and the first one's answer to one packet.
int main() {
  const falcon::Usb usb;
  const std::vector<std::string> found = usb.find();
  for (const std::string& address : found) std::printf("%s\n", address.c_str());
  if (found.empty()) return 1;
  auto device = usb.open(found[0]);
  if (!device) {
    std::printf("%s\n", device.error().arguments[0].c_str());
    return 2;
  }
  if (!(*device)->write(falcon::encode({}, 0))) return 3;
  std::uint8_t bytes[64] = {};
  const std::ptrdiff_t count = (*device)->read(bytes, 0.1);
  if (count < 2) return 4;
  falcon::AnswerReader reader;
  const int answers = reader.take(std::span(bytes).first(static_cast<std::size_t>(count)).subspan(2));
  std::printf("%d, %d %d %d\n", answers, reader.reading().encoders[0], reader.reading().encoders[1],
              reader.reading().encoders[2]);
  return usb.open("9-9") ? 5 : 0;
}
