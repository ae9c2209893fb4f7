// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/LibusbTransport.h"

#include "haptics/device/DeviceErrors.h"

#include <libusb.h>
#include <algorithm>
#include <cmath>
#include <functional>

namespace handwheel::falcon {

namespace {

constexpr std::uint16_t kVendor = 0x0403;
constexpr std::uint16_t kProduct = 0xcb48;
constexpr std::uint8_t kOut = 0x02, kIn = 0x81;
constexpr std::uint8_t kVendorRequest = 0x40;
constexpr unsigned kMilliseconds = 100;  // time limit for a transfer out while firmware is loaded
constexpr unsigned kPacketTime = 10;     // ms for a packet of the loop: an exchange waits 20 ms at most
constexpr std::size_t kShort = 64;       // bytes
constexpr int kMostErrors = 10;

class LibusbTransport final : public UsbTransport {
 public:
  LibusbTransport(std::shared_ptr<libusb_context> context, libusb_device_handle* handle)
      : m_context(std::move(context)), m_handle(handle) {}
  ~LibusbTransport() override {
    libusb_release_interface(m_handle, 0);
    libusb_close(m_handle);
  }
  LibusbTransport(const LibusbTransport&) = delete;
  LibusbTransport& operator=(const LibusbTransport&) = delete;

  bool control(std::uint8_t request, std::uint16_t value) noexcept override {
    return noted(libusb_control_transfer(m_handle, kVendorRequest, request, value, 0, nullptr, 0, kMilliseconds), 0) ==
           0;
  }

  bool write(std::span<const std::uint8_t> bytes) noexcept override {
    int sent = 0;
    auto* const data = const_cast<std::uint8_t*>(bytes.data());  // libusb only reads it
    const int size = static_cast<int>(bytes.size());
    const unsigned milliseconds = bytes.size() <= kShort ? kPacketTime : kMilliseconds;
    return noted(libusb_bulk_transfer(m_handle, kOut, data, size, &sent, milliseconds), kOut) == 0 && sent == size;
  }

  std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept override {
    int received = 0;
    const auto milliseconds = static_cast<unsigned>(std::max(1.0, std::ceil(timeout * 1e3)));  // 0 would mean for ever
    const int size = static_cast<int>(into.size());
    noted(libusb_bulk_transfer(m_handle, kIn, into.data(), size, &received, milliseconds), kIn);
    return m_gone ? kGone : received;
  }

  bool isGone() const noexcept override { return m_gone; }

 private:
  // Restarts a halted pipe. A line with repeated errors counts as gone; a timeout is no error.
  int noted(int status, std::uint8_t pipe) noexcept {
    if (status == LIBUSB_ERROR_PIPE && pipe != 0) (void)libusb_clear_halt(m_handle, pipe);
    m_errors = status == 0 || status == LIBUSB_ERROR_TIMEOUT ? 0 : m_errors + 1;
    m_gone |= status == LIBUSB_ERROR_NO_DEVICE || m_errors >= kMostErrors;
    return status;
  }

  std::shared_ptr<libusb_context> m_context;
  libusb_device_handle* m_handle;
  int m_errors = 0;  // consecutive errors
  bool m_gone = false;
};

// Claims the interface. The kernel may have taken the chip for a serial line; it gets it back on release.
int claim(libusb_device_handle* handle) {
  const int status = libusb_claim_interface(handle, 0);
  if (status != LIBUSB_ERROR_BUSY) return status;
  (void)libusb_set_auto_detach_kernel_driver(handle, 1);
  return libusb_claim_interface(handle, 0);
}

std::string addressOf(libusb_device* device) {
  std::uint8_t ports[7] = {};
  const int depth = libusb_get_port_numbers(device, ports, sizeof(ports));
  std::string address = std::to_string(libusb_get_bus_number(device));
  for (int i = 0; i < depth; ++i) address += (i == 0 ? '-' : '.') + std::to_string(ports[i]);
  return address;
}

void forEachFalcon(libusb_context* context, const std::function<void(libusb_device*)>& visit) {
  libusb_device** list = nullptr;
  const ssize_t count = libusb_get_device_list(context, &list);
  for (ssize_t i = 0; i < count; ++i) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(list[i], &descriptor) != 0) continue;
    if (descriptor.idVendor == kVendor && descriptor.idProduct == kProduct) visit(list[i]);
  }
  if (count >= 0) libusb_free_device_list(list, 1);
}

}  // namespace

Usb::Usb() {
  libusb_context* context = nullptr;
  if (libusb_init(&context) == 0) m_context.reset(context, libusb_exit);
}

std::vector<std::string> Usb::find() const {
  std::vector<std::string> all;
  if (m_context) forEachFalcon(m_context.get(), [&](libusb_device* device) { all.push_back(addressOf(device)); });
  return all;
}

Result<std::unique_ptr<UsbTransport>> Usb::open(const std::string& address) const {
  libusb_device_handle* handle = nullptr;
  int status = LIBUSB_ERROR_NO_DEVICE;
  if (m_context) {
    forEachFalcon(m_context.get(), [&](libusb_device* device) {
      if (!handle && addressOf(device) == address) status = libusb_open(device, &handle);
    });
  }
  if (handle) {
    status = claim(handle);
    if (status == 0) return std::unique_ptr<UsbTransport>(std::make_unique<LibusbTransport>(m_context, handle));
    libusb_close(handle);
  }
  return Error{DeviceError::Unreachable, {libusb_strerror(status)}, {}, "Novint Falcon"};
}

}  // namespace handwheel::falcon
