// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/DeviceErrors.h"

namespace handwheel {

const ErrorDescription DeviceError::Unreachable{
    .id = "DeviceUnreachable",
    .sentences = {translatable("ErrorText", "the device cannot be reached (%1)")},
    .advice = {translatable(
        "ErrorText",
        "Check that it is plugged in, that no other program uses it and that you have permission to use it.")}};

const ErrorDescription DeviceError::NotResponding{
    .id = "DeviceNotResponding",
    .sentences = {translatable("ErrorText", "the device does not respond correctly (%1)")},
    .advice = {translatable("ErrorText", "Switch it off and on again, or try another port.")}};

const ErrorDescription DeviceError::PluginVersion{
    .id = "PluginVersion",
    .sentences = {translatable("ErrorText", "the plugin was made for another version of Handwheel (%1, here %2)")},
    .advice = {translatable("ErrorText", "Install a plugin that was made for this version, or remove the file.")}};

const ErrorDescription DeviceError::PluginBroken{
    .id = "PluginBroken",
    .sentences = {translatable("ErrorText", "the plugin cannot be used (%1)")},
    .advice = {translatable("ErrorText", "Install a plugin that was made for this version, or remove the file.")}};

}  // namespace handwheel
