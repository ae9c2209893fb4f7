// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haply/Messages.h"

#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

namespace handwheel::haply {

namespace {

using Json = nlohmann::json;

constexpr double kMetre = 1e3;         // mm
constexpr double kMostPlausible = 10;  // m or m/s; beyond, it is no reading

// Returns the first of these keys that an object has; null otherwise.
const Json* member(const Json* object, std::initializer_list<const char*> keys) {
  if (!object || !object->is_object()) return nullptr;
  for (const char* const key : keys) {
    const auto found = object->find(key);
    if (found != object->end()) return &*found;
  }
  return nullptr;
}

std::optional<double> number(const Json* object, const char* key) {
  const Json* const value = member(object, {key});
  if (!value || !value->is_number()) return {};
  const double result = value->get<double>();
  return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

// Converts a vector. The service has x right, y away from the user, z up; this turns it by -90° about x.
std::optional<Vec3> vector(const Json* object) {
  const auto x = number(object, "x"), y = number(object, "y"), z = number(object, "z");
  if (!x || !y || !z) return {};
  const Vec3 turned(*x, *z, -*y);
  return turned.cwiseAbs().maxCoeff() <= kMostPlausible ? std::optional<Vec3>(kMetre * turned) : std::nullopt;
}

std::optional<Eigen::Quaterniond> quaternion(const Json* object) {
  const auto w = number(object, "w"), x = number(object, "x"), y = number(object, "y"), z = number(object, "z");
  if (!w || !x || !y || !z) return {};
  const Eigen::Quaterniond turned(*w, *x, *z, -*y);
  const double norm = turned.norm();
  return norm > 0.5 && norm < 2.0 ? std::optional(turned.normalized()) : std::nullopt;
}

bool isOn(const Json* value) {
  return value && ((value->is_boolean() && value->get<bool>()) || (value->is_number() && value->get<double>() != 0.0));
}

// Returns the first entry of an array of devices, or null.
const Json* first(const Json* list) {
  return list && list->is_array() && !list->empty() ? &list->front() : nullptr;
}

// Returns the state of a device. Older versions have the members of "state" directly in the device.
const Json* stateOf(const Json* device) {
  const Json* const state = member(device, {"state"});
  return state ? state : device;
}

void readGrip(const Json* grip, Frame& frame) {
  const Json* const state = stateOf(grip);
  frame.orientation = quaternion(member(state, {"orientation"}));
  if (isOn(member(state, {"button"}))) frame.buttons |= 1;
  const Json* const buttons = member(state, {"buttons"});
  std::uint32_t bit = 1;
  for (const char* const key : {"a", "b", "c"}) {
    if (isOn(member(buttons, {key}))) frame.buttons |= bit;
    bit <<= 1;
  }
}

std::string textOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::optional<Frame> readFrame(std::string_view text) {
  const Json root = Json::parse(text, nullptr, false);
  const Json* const arm = first(member(&root, {"inverse3"}));
  const Json* const id = member(arm, {"device_id", "id"});
  if (!id || !id->is_string() || id->get_ref<const std::string&>().empty()) return {};
  Frame frame;
  frame.deviceId = id->get<std::string>();
  const Json* const state = stateOf(arm);
  frame.position = vector(member(state, {"cursor_position", "position"}));
  frame.velocity = vector(member(state, {"cursor_velocity", "velocity"}));
  const Json* const calibrated = member(member(arm, {"status"}), {"calibrated"});
  frame.isCalibrated = !calibrated || isOn(calibrated);
  readGrip(first(member(&root, {"verse_grip", "wireless_verse_grip", "wired_verse_grip"})), frame);
  return frame;
}

std::string clientHello() {
  return R"({"session":{"configure":{"profile":{"name":"handwheel"}}}})";
}

std::string centringCommand(const std::string& deviceId) {
  const Json preset = {{"device_id", deviceId}, {"configure", {{"preset", "arm_front_centered"}}}};
  return textOf({{"inverse3", Json::array({preset})}});
}

std::string forceCommand(const std::string& deviceId, const Vec3& force) {
  const Json vector = {{"x", force.x()}, {"y", -force.z()}, {"z", force.y()}};
  const Json arm = {{"device_id", deviceId}, {"commands", {{"set_cursor_force", {{"vector", vector}}}}}};
  return textOf({{"inverse3", Json::array({arm})}});
}

}  // namespace handwheel::haply
