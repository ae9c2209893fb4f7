// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/HidapiTransport.h"

#include "haptics/device/DeviceErrors.h"
#include "spacemouse/Models.h"

#include <hidapi.h>
#include <algorithm>
#include <cmath>

namespace handwheel::spacemouse {

namespace {

class HidapiTransport final : public HidTransport {
 public:
  explicit HidapiTransport(hid_device* device) : m_device(device) {}
  ~HidapiTransport() override { hid_close(m_device); }
  HidapiTransport(const HidapiTransport&) = delete;
  HidapiTransport& operator=(const HidapiTransport&) = delete;

  std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept override {
    const int milliseconds = static_cast<int>(std::ceil(timeout * 1e3));
    const int length = hid_read_timeout(m_device, into.data(), into.size(), milliseconds);
    return length < 0 ? kGone : length;
  }

  bool write(std::span<const std::uint8_t> report) noexcept override {
    return hid_write(m_device, report.data(), report.size()) >= 0;
  }

 private:
  hid_device* m_device;
};

std::string ascii(const wchar_t* text) {
  std::string result;
  for (; text && *text != 0; ++text) result += *text >= 32 && *text < 127 ? static_cast<char>(*text) : '?';
  return result;
}

Hid::Entry entryOf(const hid_device_info& info) {
  const Model* const model = modelOf(info.vendor_id, info.product_id);
  const std::string name = model ? model->name : ascii(info.product_string);
  return {info.path, name.empty() ? "SpaceMouse" : name, model ? model->buttons : 32};
}

// Returns each device once, although hidapi lists it for each of its collections.
std::vector<Hid::Entry> findAll() {
  std::vector<Hid::Entry> all;
  for (const std::uint16_t vendor : {kLogitech, k3Dconnexion}) {
    hid_device_info* const list = hid_enumerate(vendor, 0);
    for (const hid_device_info* info = list; info; info = info->next) {
      if (!isSixAxis(info->vendor_id, info->product_id, info->usage_page, info->usage)) continue;
      const auto isSame = [&](const Hid::Entry& entry) { return entry.path == info->path; };
      if (std::none_of(all.begin(), all.end(), isSame)) all.push_back(entryOf(*info));
    }
    hid_free_enumeration(list);
  }
  return all;
}

Result<std::unique_ptr<HidTransport>> openPath(const std::string& path) {
  hid_device* const device = hid_open_path(path.c_str());
  if (!device) return Error{DeviceError::Unreachable, {ascii(hid_error(nullptr))}, {}, path};
  return std::unique_ptr<HidTransport>(std::make_unique<HidapiTransport>(device));
}

}  // namespace

Hid hidapi() {
  return {findAll, openPath};
}

}  // namespace handwheel::spacemouse
