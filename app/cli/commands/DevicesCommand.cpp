// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/DevicesCommand.h"

#include "base/NumberText.h"
#include "cli/Messages.h"
#include "cli/ReportJson.h"
#include "haptics/device/MouseDevice.h"
#include "haptics/device/SimulatedDevice.h"

namespace handwheel {

namespace {

struct Found {
  DeviceInfo listing;
  DeviceCapabilities capabilities;
};

// Finds the devices. One that is disconnected meanwhile is left out. The two that need no hardware come first.
std::vector<Found> foundBy(DeviceCatalogue& catalogue) {
  std::vector<Found> all{{{"simulated", "hand", "Simulated hand"}, simulatedDevice().capabilities},
                         {{"mouse", "pointer", "Mouse"}, MouseDevice().capabilities()}};
  for (DeviceInfo& listing : catalogue.find()) {
    const std::unique_ptr<Device> device = catalogue.make(listing.driver, listing.address);
    if (device) all.push_back({std::move(listing), device->capabilities()});
  }
  return all;
}

nlohmann::ordered_json toJson(const DeviceCapabilities& all) {
  return {{"inputs", all.inputs},
          {"outputs", all.outputs},
          {"buttons", all.buttons},
          {"max_force_n", all.maxForce},
          {"max_torque_nmm", all.maxTorque},
          {"max_gripper_force_n", all.maxGripperForce},
          {"max_stiffness_n_per_mm", all.maxStiffness},
          {"max_angular_stiffness_nmm_per_rad", all.maxAngularStiffness},
          {"max_damping_ns_per_mm", all.maxDamping},
          {"inherent_damping_ns_per_mm", all.inherentDamping},
          {"workspace_radius_mm", all.workspaceRadius},
          {"rate_hz", all.nominalRate},
          {"latency_s", all.latency},
          {"rate_control", all.isRateControl}};
}

nlohmann::ordered_json toJson(const PluginInfo& plugin) {
  nlohmann::ordered_json json = {
      {"file", plugin.file}, {"name", plugin.name}, {"version", plugin.version}, {"driver", plugin.driver}};
  json["error"] = plugin.error ? nlohmann::ordered_json(sentenceFor(*plugin.error)) : nlohmann::ordered_json();
  return json;
}

nlohmann::ordered_json toJson(const DeviceCatalogue& catalogue, const std::vector<Found>& devices) {
  nlohmann::ordered_json json = {{"drivers", catalogue.drivers()}};
  json["devices"] = nlohmann::ordered_json::array();
  for (const auto& [listing, capabilities] : devices) {
    nlohmann::ordered_json entry = {{"driver", listing.driver}, {"address", listing.address}, {"name", listing.name}};
    entry["capabilities"] = toJson(capabilities);
    json["devices"].push_back(std::move(entry));
  }
  json["plugins"] = nlohmann::ordered_json::array();
  for (const PluginInfo& plugin : catalogue.plugins()) json["plugins"].push_back(toJson(plugin));
  return json;
}

// Returns "6 axes in, 3 driven, up to 8 N, 4 buttons".
std::string capabilitiesText(const DeviceCapabilities& all) {
  std::string text = std::to_string(all.inputs) + " axes in, ";
  if (all.outputs > 0) {
    text += std::to_string(all.outputs) + " driven, up to " + roundedText(all.maxForce) + " N, ";
  } else {
    text += "no force, ";
  }
  return text + std::to_string(all.buttons) + (all.buttons == 1 ? " button" : " buttons");
}

std::string readableText(const DeviceCatalogue& catalogue, const std::vector<Found>& devices) {
  std::string text = "Drivers:";
  for (const std::string& id : catalogue.drivers()) text += " " + id;
  text += catalogue.drivers().empty() ? " none\n" : "\n";
  text += "Devices:\n";
  for (const auto& [listing, capabilities] : devices) {
    text += "  " + listing.name + " (" + listing.driver + ", " + listing.address +
            "): " + capabilitiesText(capabilities) + "\n";
  }
  return text;
}

}  // namespace

CommandSpec devicesSpec() {
  return {"devices",
          "",
          "Lists the haptic and pointing devices that are plugged in. Also the drivers, and the plugins that provide\n"
          "them; a plugin that cannot be used is reported on stderr.",
          {
              {"json", 0, "", "Print the list as JSON"},
              {"help", 'h', "", "Show this help"},
          }};
}

int runDevices(const Arguments& arguments, std::vector<std::unique_ptr<DeviceDriver>> drivers) {
  DeviceCatalogue catalogue;
  for (std::unique_ptr<DeviceDriver>& driver : drivers) catalogue.add(std::move(driver));
  catalogue.load(pluginFolders());
  for (const PluginInfo& plugin : catalogue.plugins()) {
    if (plugin.error) complain(sentenceFor(*plugin.error));
  }
  const std::vector<Found> devices = foundBy(catalogue);
  return print(arguments.has("json") ? textOf(toJson(catalogue, devices)) : readableText(catalogue, devices));
}

}  // namespace handwheel
